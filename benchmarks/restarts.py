"""Short runs from many start frames: one long run is chaotic, the mean over many short ones tells versions apart."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from benchmarks import shots
from benchmarks.shots import Shot
from roam_core import shapes_from_mask, track
from roam_core.arrays import Bools
from roam_core.params import RoamParams

LENGTH, GAP = 15, 20
"""Frames that a run predicts, and frames from the start of a run to the start of the next."""
SHORTEST = 4
"""Frames that a run at the end of the shot must have left to be worth its while."""


@dataclass(frozen=True)
class Job:
    """One shot under one configuration."""

    shot: str
    config: str | RoamParams
    length: int = LENGTH
    gap: int = GAP


def runs(frames: range, length: int = LENGTH, gap: int = GAP) -> list[range]:
    """The runs of a shot: each its given frame and the up to `length` frames that are predicted from it."""
    starts = range(frames[0], frames[-1] + 1 - SHORTEST, gap)
    return [range(start, min(start + length, frames[-1]) + 1) for start in starts]


def predicted(shot: Shot, run: range, config: str | RoamParams) -> Iterator[tuple[Bools, Bools]]:
    """The matte and the true mask of every predicted frame of a run from the true mask of its first frame."""
    given = shapes_from_mask(shot.mask(run[0]), run[0])
    for result in track(shot.read, given, run, config):
        shapes = [each.shape for each in result.results]
        yield shots.matte(shapes, result.frame, shot.size), shot.mask(result.frame)


def measured(shot: Shot, config: str | RoamParams, length: int = LENGTH, gap: int = GAP) -> list[float]:
    """The mean IoU of every run of a shot; starts on which the object is out of the picture are passed over."""
    return [iou for iou, _ in scored(shot, config, length, gap)]


def scored(shot: Shot, config: str | RoamParams, length: int = LENGTH, gap: int = GAP) -> list[tuple[float, float]]:
    """The mean IoU and accuracy of every run of a shot, as `measured`."""
    found = []
    for run in runs(shot.frames, length, gap):
        if shot.mask(run[0]).any():
            pairs = [
                (shots.overlap(ours, true), float(np.mean(ours == true))) for ours, true in predicted(shot, run, config)
            ]
            iou, accuracy = np.mean(pairs, axis=0)
            found.append((float(iou), float(accuracy)))
    return found


def of_job(job: Job) -> list[float]:
    """`measured` for another process."""
    return measured(shots.load(job.shot), job.config, job.length, job.gap)


def spread(values: Sequence[float]) -> dict[str, Any]:
    """Mean, standard deviation and least of a shot's runs."""
    return {
        "mean": float(np.mean(values)),
        "spread": float(np.std(values)),
        "least": float(np.min(values)),
        "runs": [round(value, 4) for value in values],
    }
