"""How far reduced keys are from the fewest possible: the optimum of straight keys, by dynamic programming.

The optimum is found in another way than the program's: every pair of frames is tried, every place of either outline is
compared with every edge of the other, and the fewest good spans that lead from the first frame to the last are counted
by the textbook. Keys are frames of the tracked outline in both; `tracked` is the outline as the engine gave it, `even`
the same after smoothing by the tolerance.
"""

from __future__ import annotations

import argparse
from typing import Any

import numpy as np

from benchmarks import demo_shot, fewest_keys, report, shots
from roam_core.arrays import Array
from roam_core.geometry import bezier
from roam_core.interchange.keys.reduction import Motion, Reduction, reduced
from roam_core.interchange.keys.smoothing import smoothed
from roam_core.roto import RotoShape

TOLERANCE = 1.0
"""Pixels."""

SHOTS = "car-turn,mallard-water"
PLACES = 8
"""Places on each segment, as the program compares them."""


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `key_optimum` may be told."""
    parser.add_argument("--shots", metavar="A,B", default=SHOTS, help="beside the demo (%(default)s)")
    parser.add_argument("--publish", action="store_true", help="put the table into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Track each shot, count the keys of both, and report."""
    names = shots.names(given.shots) if given.shots else []
    rows = []
    for shot in (demo_shot.load(), *(shots.load(name) for name in names)):
        tracked = fewest_keys.tracked(shot)
        for kind, shape in (("tracked", tracked), ("even", smoothed(tracked, TOLERANCE).shape)):
            rows.append(_row(shot.name, kind, shape))
    head = ["shot", "outline", "frames", "straight: keys", "optimum", "error", "Nuke: keys", "error, at quarter frames"]
    title = f"Keys at {TOLERANCE:g} px; errors in pixels. {report.circumstances()}."
    report.write("key_optimum", f"{title}\n\n{report.table(head, rows)}", {"rows": rows}, publish=given.publish)


def _row(shot: str, kind: str, shape: RotoShape) -> list[Any]:
    straight, cubic = (reduced(shape, TOLERANCE, motion) for motion in (Motion.LINEAR, Motion.CUBIC))
    figures = [str(len(straight.shape.keys)), str(optimum(shape, TOLERANCE)), _error(straight)]
    return [shot, kind, str(straight.before), *figures, str(len(cubic.shape.keys)), _error(cubic)]


def _error(reduction: Reduction) -> str:
    return f"{reduction.max_error:.2f}"


def optimum(shape: RotoShape, tolerance: float) -> int:
    """The fewest frames, the artist's among them, with straight spans between that stray by at most the tolerance.

    Holds are none of its business: the shape must have none.
    """
    first, last = shape.frames[0], shape.frames[-1]
    outlines = np.stack([_places(shape, frame) for frame in range(first, last + 1)])
    fixed = {frame - first for frame in shape.artist_frames}
    count = len(outlines)
    fewest = [1, *[count + 1] * (count - 1)]
    for stop in range(1, count):
        for start in range(stop - 1, -1, -1):
            if fewest[start] + 1 < fewest[stop] and is_good(outlines[start : stop + 1], shape.closed, tolerance):
                fewest[stop] = fewest[start] + 1
            if start in fixed:  # no span reaches over an artist's key
                break
    return fewest[-1]


def is_good(span: Array, closed: bool, tolerance: float) -> bool:
    """Whether straight motion between the ends of `span (F, S, 2)` stays within the tolerance of every frame inside."""
    inside = sorted(range(1, len(span) - 1), key=lambda index: abs(index - len(span) / 2.0))
    for index in inside:  # the middle strays first
        share = index / (len(span) - 1.0)
        between = (1.0 - share) * span[0] + share * span[-1]
        if max(_farthest(between, span[index], closed), _farthest(span[index], between, closed)) > tolerance:
            return False
    return True


def _farthest(places: Array, line: Array, closed: bool) -> float:
    """The largest distance from `places (S, 2)` to the polyline `line (S, 2)`: every place with every edge."""
    starts, ends = (line, np.roll(line, -1, axis=0)) if closed else (line[:-1], line[1:])
    along = ends - starts
    length = np.maximum((along**2).sum(axis=1), 1e-18)
    apart = places[:, None] - starts[None]
    share = np.clip((apart * along).sum(axis=2) / length, 0.0, 1.0)
    squared = ((apart - share[..., None] * along) ** 2).sum(axis=2)
    return float(np.sqrt(squared.min(axis=1).max()))


def _places(shape: RotoShape, frame: int) -> Array:
    """Places `(S, 2)` of the outline at a frame, evenly in the parameter."""
    segments = bezier.segments(shape.at(frame).points, shape.closed)
    weights = bezier.bernstein(np.arange(PLACES) / PLACES)
    line: Array = np.einsum("nk,skc->snc", weights, segments).reshape(-1, 2)
    return line if shape.closed else np.concatenate([line, segments[-1, -1:]])
