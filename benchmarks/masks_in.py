"""Masks in, curves out: how few keys carry the drawn masks of real shots, how near they lie, how points slide.

The masks are read as `roam import` reads them. The IoU is that of the rendered matte with the whole true mask, pixel by
pixel, specks among them. The limbs of puppets have true motion: a slide is how far an anchor has moved off its spot of
the limb, against the first frame.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from benchmarks import figures, report, shots
from roam_core.arrays import Bools
from roam_core.interchange import ImportOptions, MaskOptions
from roam_core.interchange.masks.importer import MaskImporter
from roam_core.interchange.masks.sequence import Fitted
from roam_core.kernels.coverage import coverage
from roam_core.roto import Clip, RotoShape

CHOSEN = "car-turn,mallard-water,lucia,motorbike,swing"
"""Shots of the table: the first three were tuned on, the others were not."""
PUPPETS = (1,)
"""Seeds."""
LENGTH = 16
"""Frames of a puppet."""


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `masks_in` may be told."""
    parser.add_argument("--shots", metavar="A,B", default=CHOSEN, help=f"these shots; else {CHOSEN}")
    parser.add_argument("--tolerance", type=float, default=1.0, metavar="PX", help="pixels, as `roam import` takes it")
    parser.add_argument("--slides", action="store_true", help="the slides of points on puppets too")
    parser.add_argument("--publish", action="store_true", help="put the tables into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Import the masks of each shot, and of the limbs of puppets, and report."""
    cases = [measured(name, given.tolerance) for name in shots.names(given.shots)]
    head = ["shot", "frames", "shapes", "points", "keys", "share", "within", "not held", "IoU, mean", "least"]
    text = report.table([*head, "below .97", "mean, px", "farthest, px", "s"], [_row(case) for case in cases])
    told = "Points to `not held`, mean and farthest are those of the largest shape; IoU is that of the whole matte."
    text = f"At {given.tolerance:g} px. {told} {report.circumstances()}.\n\n{text}"
    slides = [_slides(seed) for seed in PUPPETS] if figures.has_puppets() and given.slides else []
    if slides:
        rows = [[each["name"], str(each["limbs"]), f"{each['median']:.1f}", f"{each['upper']:.1f}"] for each in slides]
        text += "\n\n" + report.table(["puppet", "limbs", "slide on the last frame, median px", "upper decile"], rows)
    report.write("masks_in", text, {"shots": cases, "puppets": slides}, publish=given.publish)


def measured(name: str, tolerance: float) -> dict[str, Any]:
    """All figures of one shot; `seconds` are those of the processor."""
    shot = shots.load(name)
    began = time.process_time()
    shapes, parts = imported(shot.masks, tolerance)
    seconds = time.process_time() - began
    overlaps = [shots.overlap(shots.matte(shapes, k, shot.size), mask) for k, mask in enumerate(shot.masks)]
    largest = max(parts, key=lambda part: len(part.frames) * len(part.keys[0][1]))
    return {
        "shot": name,
        "tolerance": tolerance,
        "frames": len(shot.frames),
        "shapes": len(shapes),
        "points": len(largest.keys[0][1]),
        "keys": len(largest.keys),
        "span": len(largest.frames),
        "within": largest.within,
        "beyond": largest.beyond,
        "mean": largest.mean,
        "farthest": largest.greatest,
        "iou": overlaps,
        "seconds": seconds,
    }


def imported(masks: Sequence[Bools], tolerance: float) -> tuple[list[RotoShape], tuple[Fitted, ...]]:
    """Shapes of masks that are numbered from 0 on, and their figures."""
    height, width = masks[0].shape
    with tempfile.TemporaryDirectory() as folder:
        for number, mask in enumerate(masks):
            cv2.imwrite(str(Path(folder) / f"mask.{number:04d}.png"), np.where(mask, 255, 0).astype(np.uint8))
        clip = Clip(Path("plate"), 0, len(masks) - 1, (width, height))
        found, parts = MaskImporter().measured(Path(folder), clip, ImportOptions(masks=MaskOptions(tolerance)))
    return list(found.layer.shapes()), parts


def _row(case: dict[str, Any]) -> list[str]:
    iou = np.array(case["iou"])
    return [
        case["shot"],
        str(case["frames"]),
        str(case["shapes"]),
        str(case["points"]),
        f"{case['keys']} of {case['span']}",
        f"{case['keys'] / case['span']:.2f}",
        f"{case['within']:.2f}",
        str(len(case["beyond"])),
        f"{iou.mean():.3f}",
        f"{iou.min():.3f}",
        str(int((iou < 0.97).sum())),
        f"{case['mean']:.2f}",
        f"{case['farthest']:.1f}",
        f"{case['seconds']:.0f}",
    ]


def _slides(seed: int) -> dict[str, Any]:
    """How far anchors of the limbs of a puppet slide, on its last frame."""
    figure = figures.of_puppet(seed, LENGTH)
    slides: list[float] = []
    for part in figure.drawn:
        masks = [np.asarray(coverage(line, figure.size) > 0.5) for line in figure.lines[part][:LENGTH]]
        shapes, _ = imported(masks, 1.0)
        shape = shapes[0]
        motion = figure.since(part, LENGTH - 1)
        spots = shape.at(0).anchors @ motion[:2, :2].T + motion[:2, 2]
        slides.extend(np.hypot(*(shape.at(LENGTH - 1).anchors - spots).T).tolist())
    return {
        "name": figure.name,
        "limbs": len(figure.drawn),
        "median": float(np.median(slides)),
        "upper": float(np.quantile(slides, 0.9)),
    }
