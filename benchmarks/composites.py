"""Composites: the object of each shot over the pictures of other shots, whose own objects pass behind it.

The shots have one thing each that moves by itself; films have passers-by. Objects and surroundings meet here that no
parameter was chosen on together. The other shot runs backwards, and what moves in it stays in the picture.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence

import cv2
import numpy as np

from benchmarks import processes, report, shots
from benchmarks.shots import Shot
from roam_core.arrays import Bools, Image
from roam_core.params import params_for

PLATES = 5, 11, 17
"""By how many places the other shots lie after that of the object, in the order of their names."""
LENGTH = 48
"""Frames that are predicted from the first one, at most."""
SOFT = 0.8
"""Standard deviation, in pixels, by which the object's edge is softened, after a pixel was taken off around it."""


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `composites` may be told."""
    shots.add_arguments(parser)


def run(given: argparse.Namespace) -> None:
    """Track the objects of all shots before others, and report."""
    params_for(given.config)
    chosen, every = shots.names(given.shots), shots.names()
    plates = {name: [every[(every.index(name) + places) % len(every)] for places in PLATES] for name in chosen}
    jobs = [(name, plate, given.config) for name in chosen for plate in plates[name]]
    measures = processes.each(measured, jobs)
    found = {(name, plate): each for (name, plate, _), each in zip(jobs, measures, strict=True)}
    text, is_all = _text(plates, found, given.config), given.shots is None
    result = {"config": given.config, "shots": {f"{name} / {plate}": each for (name, plate), each in found.items()}}
    report.write("composites" if is_all else "composites some", text, result, publish=given.publish and is_all)


def measured(job: tuple[str, str, str]) -> tuple[float, float]:
    """Of the object of a shot over the pictures of another one, by a configuration: mean IoU, mean confidence."""
    name, plate, config = job
    pictures, masks = composed(shots.load(name), shots.load(plate))
    iou, confidence = np.mean(shots.tracked(pictures.__getitem__, masks, config), axis=0)
    return float(iou), float(confidence)


def composed(shot: Shot, plate: Shot) -> tuple[list[Image], list[Bools]]:
    """The object of `shot` over the pictures of `plate`, from its last one backwards, and the object's masks."""
    count = min(len(shot.pictures), len(plate.pictures), LENGTH + 1)
    below = list(reversed(plate.pictures))
    masks = list(shot.masks[:count])
    return [_over(*each) for each in zip(shot.pictures[:count], masks, below[:count], strict=True)], masks


def _over(picture: Image, mask: Bools, below: Image) -> Image:
    """What a mask shows of a picture, over another picture."""
    height, width = mask.shape
    if below.shape[:2] != mask.shape:
        below = np.asarray(cv2.resize(below, (width, height), interpolation=cv2.INTER_AREA))
    if below.dtype != picture.dtype:
        below = below / np.float32(255.0) if below.dtype == np.uint8 else below * np.float32(255.0)
    core = cv2.erode(mask.astype(np.float32), np.ones((3, 3), np.uint8))
    share = cv2.GaussianBlur(core, (0, 0), SOFT)[..., None]
    mixed = share * picture + (1.0 - share) * below
    return np.asarray(np.round(mixed) if picture.dtype == np.uint8 else mixed, dtype=picture.dtype)


def _text(plates: dict[str, list[str]], found: dict[tuple[str, str], tuple[float, float]], config: str) -> str:
    rows = [[name, *_cells([found[name, plate] for plate in below])] for name, below in plates.items()]
    mean = _cells([found[name, plate] for name, below in plates.items() for plate in below])[-2:]
    rows.append([f"**mean of {len(found)} runs**", *([""] * len(PLATES)), *(f"**{cell}**" for cell in mean)])
    headings = ["object", *(f"{places} on" for places in PLATES), "IoU", "confidence"]
    title = f"Objects over other shots, up to {LENGTH} frames, configuration `{config}`. {report.circumstances()}."
    return f"{title}\n\n{report.table(headings, rows)}"


def _cells(measures: Sequence[tuple[float, float]]) -> list[str]:
    """The IoU of each run, their mean, and the mean confidence."""
    return [f"{value:.3f}" for value in (*(iou for iou, _ in measures), *np.mean(measures, axis=0))]
