"""Whole objects drawn in two pieces that overlap, as an artist draws rider and horse, against the same in one outline.

The largest outline of a shot's true mask is cut across its long axis, so that the pieces share a tenth of its length.
They are tracked together, and the union is judged by the true mask. What is cut off bends, turns and changes its look
like the whole: no pose fits it for long (`propagate.parts.along`).
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import Any

import numpy as np

from benchmarks import processes, report, shots
from benchmarks.shots import Shot
from roam_core import shapes_from_mask, track
from roam_core.arrays import Bools
from roam_core.geometry import bezier
from roam_core.kernels.coverage import coverage
from roam_core.params import CONFIGS, DEFAULT_CONFIG, params_for
from roam_core.roto import RotoShape

START, LENGTH = 10, 16
"""Frames before the one that is given, and frames that are predicted from it."""
CUTS = (0.5, 0.25)
"""Shares of the object's area on one side of the middle of what its pieces have in common."""
SHARED = 0.1
"""Of the object's length, what they have in common."""


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `pieces` may be told."""
    parser.add_argument("--config", metavar="NAME", default=DEFAULT_CONFIG, help=f"one of {', '.join(CONFIGS)}")
    parser.add_argument("--shots", metavar="A,B", help="these shots only")
    parser.add_argument("--publish", action="store_true", help="put the table into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Track all shots in one outline and in two pieces, and report."""
    params_for(given.config)
    chosen = shots.names(given.shots)
    found = dict(zip(chosen, processes.each(measured, [(name, given.config) for name in chosen]), strict=True))
    text, is_all = _text(found, given.config), given.shots is None
    result = {"config": given.config, "shots": found}
    report.write("pieces" if is_all else "pieces some", text, result, publish=given.publish and is_all)


def measured(job: tuple[str, str]) -> list[tuple[float, float]]:
    """The mean IoU and confidence of a shot by a configuration: in one outline, and for each cut in two pieces."""
    name, config = job
    shot = shots.load(name)
    frame = shot.frames[START]
    (whole, *_) = sorted(shapes_from_mask(shot.mask(frame), frame), key=_area, reverse=True)
    inside = _filled(whole, frame, shot.size)
    drawn = [[whole], *([_largest(piece, frame) for piece in cut(inside, share)] for share in CUTS)]
    return [_scored(shot, shapes, config) for shapes in drawn]


def cut(inside: Bools, share: float) -> tuple[Bools, Bools]:
    """Two pieces of what is `inside (h, w)`, cut across its long axis; `share` of it lies before the cut."""
    places = np.argwhere(inside).astype(np.float64)
    away = places - places.mean(axis=0)
    _, axes = np.linalg.eigh(away.T @ away)
    axis = axes[:, 1] * (1.0 if axes[:, 1].sum() >= 0.0 else -1.0)
    along = away @ axis
    middle, half = np.quantile(along, share), 0.5 * SHARED * np.ptp(along)
    rows, columns = places.astype(np.intp).T
    pieces = np.zeros((2, *inside.shape), dtype=bool)
    pieces[0, rows, columns] = along < middle + half
    pieces[1, rows, columns] = along > middle - half
    return pieces[0], pieces[1]


def _area(shape: RotoShape) -> float:
    return bezier.area(shape.keys[0].points)


def _filled(shape: RotoShape, frame: int, size: tuple[int, int]) -> Bools:
    return np.asarray(coverage(bezier.flatten(shape.at(frame).points), size) > 0.5)


def _largest(piece: Bools, frame: int) -> RotoShape:
    """The outline of the largest component of a piece, without its holes."""
    return max(shapes_from_mask(piece, frame), key=_area)


def _scored(shot: Shot, shapes: Sequence[RotoShape], config: str) -> tuple[float, float]:
    first = shot.frames[START]
    frames = range(first, min(first + LENGTH, shot.last) + 1)
    pairs = []
    for result in track(shot.read, shapes, frames, config):
        ours = shots.matte([each.shape for each in result.results], result.frame, shot.size)
        sure = float(np.mean([each.confidence for each in result.results]))
        pairs.append((shots.overlap(ours, shot.mask(result.frame)), sure))
    iou, confidence = np.mean(pairs, axis=0)
    return float(iou), float(confidence)


def _text(found: dict[str, Any], config: str) -> str:
    rows = [[name, *_cells(each)] for name, each in found.items()]
    mean = np.mean(list(found.values()), axis=0)
    rows.append([f"**mean of {len(found)}**", *(f"**{cell}**" for cell in _cells(mean))])
    names = ["in one outline", *(f"cut at {share:.0%}" for share in CUTS)]
    head = ["shot", *(f"{name}{what}" for name in names for what in (": IoU", ", confidence"))]
    title = f"The largest outline of each shot, whole and in two pieces, {LENGTH} frames, configuration `{config}`. "
    return f"{title}{report.circumstances()}.\n\n{report.table(head, rows)}"


def _cells(measured: Any) -> list[str]:
    return [f"{value:.3f}" for each in measured for value in each]
