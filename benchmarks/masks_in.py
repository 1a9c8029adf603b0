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

from benchmarks import figures, processes, report, shots, yardstick
from benchmarks.shots import Mask
from roam_core.interchange import ImportOptions, MaskOptions, read_shapes
from roam_core.kernels.coverage import coverage
from roam_core.roto import Clip, RotoShape

TOLERANCES = (1.0, 2.0)
"""Pixels."""
PUPPETS = (1, 2)
"""Seeds."""
LENGTH = 24
"""Frames of a puppet."""


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `masks_in` may be told."""
    parser.add_argument("--shots", metavar="A,B", help="only these shots")
    parser.add_argument("--publish", action="store_true", help="put the tables into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Import the masks of each shot, and of the limbs of puppets, and report."""
    jobs = [(name, tolerance) for name in shots.names(given.shots) for tolerance in TOLERANCES]
    cases = processes.each(measured, jobs)
    head = ["shot", "within", "frames", "shapes", "points", "keys", "share", "IoU, mean", "least", "below .97"]
    text = report.table([*head, "farthest", "flows a frame"], [_row(case) for case in cases])
    text = f"Points, keys and share are those of the largest shape. {report.circumstances()}.\n\n{text}"
    slides = [_slides(seed) for seed in PUPPETS] if figures.has_puppets() and given.shots is None else []
    if slides:
        rows = [[each["name"], str(each["limbs"]), f"{each['median']:.1f}", f"{each['upper']:.1f}"] for each in slides]
        text += "\n\n" + report.table(["puppet", "limbs", "slide on the last frame, median px", "upper decile"], rows)
    report.write("masks in", text, {"shots": cases, "puppets": slides}, publish=given.publish and given.shots is None)


def measured(job: tuple[str, float]) -> dict[str, Any]:
    """All figures of one shot at one tolerance."""
    name, tolerance = job
    shot = shots.load(name)
    began = time.process_time()
    shapes, notes = imported(shot.masks, tolerance)
    seconds = (time.process_time() - began) / len(shot.frames)
    overlaps = [shots.overlap(shots.matte(shapes, k, shot.size), mask) for k, mask in enumerate(shot.masks)]
    largest = max(shapes, key=lambda shape: len(shape.keys) * shape.point_count)
    flow = float(np.median(yardstick.flow_seconds(shot.pictures[:12])))
    return {
        "shot": name,
        "tolerance": tolerance,
        "frames": len(shot.frames),
        "shapes": len(shapes),
        "points": largest.point_count,
        "keys": len(largest.keys),
        "span": largest.frames[-1] - largest.frames[0] + 1,
        "iou": overlaps,
        "notes": notes,
        "flows": seconds / flow,
    }


def imported(masks: Sequence[Mask], tolerance: float) -> tuple[list[RotoShape], tuple[str, ...]]:
    """Shapes of masks that are numbered from 0 on, and what was said of them."""
    height, width = masks[0].shape
    with tempfile.TemporaryDirectory() as folder:
        for number, mask in enumerate(masks):
            cv2.imwrite(str(Path(folder) / f"mask.{number:04d}.png"), np.where(mask, 255, 0).astype(np.uint8))
        clip = Clip(Path("plate"), 0, len(masks) - 1, (width, height))
        found = read_shapes(Path(folder), clip, ImportOptions(masks=MaskOptions(tolerance)))
    return list(found.layer.shapes()), found.notes


def _row(case: dict[str, Any]) -> list[str]:
    iou = np.array(case["iou"])
    told = next((note for note in case["notes"] if note.startswith("'Shape 1'")), "")
    farthest = told.partition("on average, ")[2].partition(" px")[0] or "-"
    return [
        case["shot"],
        f"{case['tolerance']:g} px",
        str(case["frames"]),
        str(case["shapes"]),
        str(case["points"]),
        f"{case['keys']} of {case['span']}",
        f"{case['keys'] / case['span']:.2f}",
        f"{iou.mean():.3f}",
        f"{iou.min():.3f}",
        str(int((iou < 0.97).sum())),
        f"{farthest} px",
        f"{case['flows']:.0f}",
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
