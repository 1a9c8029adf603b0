"""Objects that come into the picture: shots seen through windows of half their picture, forwards and backwards.

On its key the edge of the window cuts the object off, and more of it comes in from frame to frame. What that looks like
the key does not tell. Tracked, and judged inside the window by the true mask.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from benchmarks import processes, report, shots
from benchmarks.shots import Shot
from roam_core.arrays import Array, Image
from roam_core.params import params_for

LENGTH, LEAST = 12, 8
"""Frames that are predicted from a key, and the least of them that a run has."""
CUT_OFF = 0.12, 0.65
"""Shares of the object in the window between which a key is set."""
GAINED, LOST = 0.2, 0.05
"""By how much of the object more must come into the window in a run, and by how much less may be there meanwhile."""
NEXT = 10
"""Frames from one key to the next in one window."""


@dataclass(frozen=True)
class Window:
    """Columns `x0` to `x1` and rows `y0` to `y1` of a picture, the last ones not among them."""

    x0: int
    x1: int
    y0: int
    y1: int

    def of(self, picture: Image) -> Image:
        return np.ascontiguousarray(picture[self.y0 : self.y1, self.x0 : self.x1])


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `coming_in` may be told."""
    shots.add_arguments(parser)


def run(given: argparse.Namespace) -> None:
    """Track what comes into the windows of all shots, and report."""
    params_for(given.config)
    chosen = shots.names(given.shots)
    by_shot = processes.each(measured, [(name, given.config) for name in chosen])
    found = {name: runs for name, runs in zip(chosen, by_shot, strict=True) if runs}
    text, is_all = _text(found, given.config), given.shots is None
    result = {"config": given.config, "shots": found}
    report.write("coming_in" if is_all else "coming_in some", text, result, publish=given.publish and is_all)


def measured(job: tuple[str, str]) -> list[tuple[float, float, float]]:
    """Of every run in a shot by a configuration: IoU on its first frame, mean IoU, mean confidence."""
    name, config = job
    shot = shots.load(name)
    found = []
    for frames in (list(shot.frames), list(reversed(shot.frames))):
        for window in windows(shot.size):
            shares = np.array([_share(shot, frame, window) for frame in frames])
            found += [_tracked(shot, frames[k : k + LENGTH + 1], window, config) for k in begun(shares)]
    return found


def windows(size: tuple[int, int]) -> list[Window]:
    """Halves of a picture of `size` (h, w): the left, the middle, the right, the upper, the lower one."""
    height, width = size
    sides = [Window(x, x + width // 2, 0, height) for x in (0, width // 4, width - width // 2)]
    return [*sides, Window(0, width, 0, height // 2), Window(0, width, height // 2, height)]


def begun(shares: Array) -> list[int]:
    """Where runs begin, by the `shares (N,)` of the object that are in the window from frame to frame."""
    found: list[int] = []
    for k, share in enumerate(shares[: len(shares) - LEAST]):
        ahead = shares[k : k + LENGTH + 1]
        is_apart = not found or k >= found[-1] + NEXT
        if (
            is_apart
            and CUT_OFF[0] <= share <= CUT_OFF[1]
            and ahead.max() >= share + GAINED
            and ahead.min() >= share - LOST
        ):
            found.append(k)
    return found


def _share(shot: Shot, frame: int, window: Window) -> float:
    mask = shot.mask(frame)
    return np.count_nonzero(window.of(mask)) / max(np.count_nonzero(mask), 1)


def _tracked(shot: Shot, frames: Sequence[int], window: Window, config: str) -> tuple[float, float, float]:
    masks = [window.of(shot.mask(frame)) for frame in frames]
    pairs = shots.tracked(lambda k: window.of(shot.read(frames[k])), masks, config)
    iou, confidence = np.mean(pairs, axis=0)
    return pairs[0][0], float(iou), float(confidence)


def _text(found: dict[str, list[tuple[float, float, float]]], config: str) -> str:
    rows = [[name, str(len(runs)), *_cells(np.mean(runs, axis=0))] for name, runs in found.items()]
    every = [each for runs in found.values() for each in runs]
    mean = _cells(np.mean(every, axis=0)) if every else []
    rows.append(["**mean of all runs**", str(len(every)), *(f"**{cell}**" for cell in mean)])
    title = f"Objects that come into windows of half the picture, {LENGTH} frames, configuration `{config}`. "
    table = report.table(["shot", "runs", "IoU one frame on", "IoU", "confidence"], rows)
    return f"{title}{report.circumstances()}.\n\n{table}"


def _cells(means: Array) -> list[str]:
    return [f"{value:.3f}" for value in means]
