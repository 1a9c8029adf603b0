"""Whole objects drawn in two pieces that overlap, as an artist draws rider and horse, against the same in one outline.

The largest outline of a shot's true mask is cut across its long axis, so that the pieces share a tenth of its length.
They are tracked together, and filled between two keys, and the union is judged by the true mask. What is cut off bends,
turns and changes its look like the whole: no pose fits it for long (`propagate.parts.along`,
`propagate.between.along_union`).
"""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from benchmarks import processes, report, shots
from benchmarks.shots import Shot
from roam_core import fill_span, keys_from_mask, shapes_from_mask, track
from roam_core.arrays import Array, Bools
from roam_core.geometry import bezier
from roam_core.kernels.coverage import coverage
from roam_core.params import params_for
from roam_core.roto import RotoShape

START, LENGTH = 10, 16
"""Frames before the one that is given, and frames that are predicted from it."""
APART = 12
"""Frames from a key to the next one where frames between are filled."""
CUTS = (0.5, 0.25)
"""Shares of the object's area on one side of the middle of what its pieces have in common."""
SHARED = 0.1
"""Of the object's length, what they have in common."""


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `pieces` may be told."""
    shots.add_arguments(parser)


def run(given: argparse.Namespace) -> None:
    """Track all shots in one outline and in two pieces, and report."""
    params_for(given.config)
    chosen = shots.names(given.shots)
    found = dict(zip(chosen, processes.each(measured, [(name, given.config) for name in chosen]), strict=True))
    text, is_all = _text(found, given.config), given.shots is None
    result = {"config": given.config, "shots": found}
    report.write("pieces" if is_all else "pieces some", text, result, publish=given.publish and is_all)


def measured(job: tuple[str, str]) -> list[tuple[float, float, float, float]]:
    """Of a shot by a configuration the mean IoU and confidence when tracked, and when filled between two keys: in one
    outline, and for each cut in two pieces.
    """
    name, config = job
    shot = shots.load(name)
    masks = [_inside(shot, frame) for frame in shot.frames[START : START + APART + 1]]
    whole = [(masks[0],), (masks[-1],)]
    axes = [long_axis(masks[0])]
    for mask in masks[1:]:
        axes.append(long_axis(mask, axes[-1]))
    ways = [whole, *([cut(masks[k], share, axes[k]) for k in (0, -1)] for share in CUTS)]
    return [(*_tracked(shot, first, config), *_filled(shot, first, last, config)) for first, last in ways]


def cut(inside: Bools, share: float, axis: Array) -> tuple[Bools, Bools]:
    """Two pieces of what is `inside (h, w)`, cut across an `axis (2,)` in rows and columns; `share` of it lies before
    the cut.
    """
    places = np.argwhere(inside).astype(np.float64)
    along = (places - places.mean(axis=0)) @ axis
    middle, half = np.quantile(along, share), 0.5 * SHARED * np.ptp(along)
    rows, columns = places.astype(np.intp).T
    pieces = np.zeros((2, *inside.shape), dtype=bool)
    pieces[0, rows, columns] = along < middle + half
    pieces[1, rows, columns] = along > middle - half
    return pieces[0], pieces[1]


def long_axis(inside: Bools, before: Array | None = None) -> Array:
    """The long axis `(2,)` of what is `inside`, in rows and columns; in the sense that it had `before`."""
    places = np.argwhere(inside).astype(np.float64)
    away = places - places.mean(axis=0)
    _, axes = np.linalg.eigh(away.T @ away)
    axis = np.asarray(axes[:, 1])
    sense = axis.sum() if before is None else axis @ before
    return axis if sense >= 0.0 else -axis


def _inside(shot: Shot, frame: int) -> Bools:
    """The largest outline of the true mask, filled."""
    outline = _largest(shot.mask(frame), frame)
    return np.asarray(coverage(bezier.flatten(outline.at(frame).points), shot.size) > 0.5)


def _area(shape: RotoShape) -> float:
    return bezier.area(shape.keys[0].points)


def _largest(piece: Bools, frame: int) -> RotoShape:
    """The outline of the largest component of a piece, without its holes."""
    return max(shapes_from_mask(piece, frame), key=_area)


def _tracked(shot: Shot, pieces: Sequence[Bools], config: str) -> tuple[float, float]:
    first = shot.frames[START]
    frames = range(first, min(first + LENGTH, shot.last) + 1)
    shapes = [_largest(piece, first) for piece in pieces]
    results = track(shot.read, shapes, frames, config)
    return _scored(shot, ((result.frame, [each.shape for each in result.results]) for result in results))


def _filled(shot: Shot, pieces: Sequence[Bools], later: Sequence[Bools], config: str) -> tuple[float, float]:
    first = shot.frames[START]
    last, shapes = first + APART, [_largest(piece, first) for piece in pieces]
    keyed = [keys_from_mask([shape], piece, last)[0] for shape, piece in zip(shapes, later, strict=True)]
    images = {frame: shot.read(frame) for frame in range(first, last + 1)}
    filled = fill_span(images, keyed, first, last, config)
    return _scored(shot, ((frame, filled) for frame in range(first + 1, last)))


def _scored(shot: Shot, found: Iterable[tuple[int, Sequence[RotoShape]]]) -> tuple[float, float]:
    """The mean IoU with the true masks, and the mean confidence, of shapes on frames."""
    pairs = []
    for frame, shapes in found:
        keys = [shape.key_at(frame) for shape in shapes]
        sure = float(np.mean([key.confidence for key in keys if key is not None and key.confidence is not None]))
        pairs.append((shots.overlap(shots.matte(shapes, frame, shot.size), shot.mask(frame)), sure))
    iou, confidence = np.mean(pairs, axis=0)
    return float(iou), float(confidence)


def _text(found: dict[str, Any], config: str) -> str:
    title = f"The largest outline of each shot, whole and in two pieces, configuration `{config}`. "
    tracked = _table({name: [each[:2] for each in ways] for name, ways in found.items()})
    filled = _table({name: [each[2:] for each in ways] for name, ways in found.items()})
    return (
        f"{title}{report.circumstances()}.\n\nTracked, {LENGTH} frames:\n\n{tracked}\n\n"
        f"Filled between two keys {APART} frames apart:\n\n{filled}"
    )


def _table(found: dict[str, Any]) -> str:
    rows = [[name, *_cells(each)] for name, each in found.items()]
    mean = np.mean(list(found.values()), axis=0)
    rows.append([f"**mean of {len(found)}**", *(f"**{cell}**" for cell in _cells(mean))])
    names = ["in one outline", *(f"cut at {share:.0%}" for share in CUTS)]
    return report.table(["shot", *(f"{name}{what}" for name in names for what in (": IoU", ", confidence"))], rows)


def _cells(measured: Any) -> list[str]:
    return [f"{value:.3f}" for each in measured for value in each]
