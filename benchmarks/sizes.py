"""Shots scaled down: how much is lost to pictures of fewer lines."""

from __future__ import annotations

import argparse
from dataclasses import dataclass

import cv2
import numpy as np

from benchmarks import processes, report, restarts, shots
from benchmarks.shots import Shot
from roam_core.arrays import Bools, Image
from roam_core.propagate import warm_up

LINES = (96, 192, 240, 360, 480)


@dataclass(frozen=True)
class Job:
    """One shot at one size."""

    shot: str
    lines: int
    config: str


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `sizes` may be told."""
    shots.add_arguments(parser)


def run(given: argparse.Namespace) -> None:
    """Short runs on the shots at each size, and all sizes in one table."""
    chosen = shots.names(given.shots)
    jobs = [Job(shot, lines, given.config) for lines in LINES for shot in chosen]
    found = dict(zip(jobs, processes.each(measured, jobs), strict=True))
    means = {lines: float(np.mean([found[Job(shot, lines, given.config)] for shot in chosen])) for lines in LINES}
    rows = [[f"{shot}", *(f"{found[Job(shot, lines, given.config)]:.3f}" for lines in LINES)] for shot in chosen] + [
        [f"**mean of {len(chosen)} shots**", *(f"**{means[lines]:.3f}**" for lines in LINES)]
    ]
    title = (
        f"Configuration `{given.config}`, IoU of runs of {restarts.LENGTH} frames from every {restarts.GAP}th frame, "
        f"pictures and masks reduced to so many lines. {report.circumstances()}."
    )
    text = f"{title}\n\n{report.table(['shot', *(f'{lines} lines' for lines in LINES)], rows)}"
    name = "sizes" if given.shots is None else "sizes some"
    report.write(name, text, {"config": given.config, "means": means}, publish=given.publish and given.shots is None)


def measured(job: Job) -> float:
    """The mean IoU of the runs of a shot at one size."""
    warm_up(job.config)
    return float(np.mean(restarts.measured(scaled(shots.load(job.shot), job.lines), job.config)))


def scaled(shot: Shot, lines: int) -> Shot:
    """A shot reduced to so many lines: a pixel shows the mean of what it covers, and is the object's by half of it."""
    width = round(shot.size[1] * lines / shot.size[0])

    def picture(image: Image) -> Image:
        return np.asarray(cv2.resize(image, (width, lines), interpolation=cv2.INTER_AREA), dtype=image.dtype)

    def mask(true: Bools) -> Bools:
        return np.asarray(picture(true.astype(np.float32)) > 0.5)

    return Shot(shot.name, shot.first, [picture(each) for each in shot.pictures], [mask(each) for each in shot.masks])
