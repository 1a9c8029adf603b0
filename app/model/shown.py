"""Which shapes are in sight on a frame, and which of them may be edited. Free of Qt: painting and hitting both ask."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry.bezier import ANCHOR
from roam_core.geometry.extent import extent
from roam_core.roto import BlendMode, Layer, Project, RotoShape

NEEDS_OTHERS = frozenset({BlendMode.SUBTRACT, BlendMode.INTERSECT})
"""How a matte may join what lies under it that makes nothing of nothing."""


@dataclass(frozen=True)
class Shown:
    """A visible shape in plate space; `locked` also when a layer above it is."""

    shape: RotoShape
    locked: bool


def shown_shapes(project: Project, frame: int) -> list[Shown]:
    """The shapes in sight at `frame`, bottom first: visible with all their layers, and inside their lifetime."""
    return [shown for shown in _below(project.plate_root, project.root.locked) if shown.shape.exists_at(frame)]


def visible_shapes(project: Project) -> list[RotoShape]:
    """The shapes that are in sight on the frames of their lifetimes, bottom first."""
    return [shown.shape for shown in _below(project.plate_root, project.root.locked)]


def editable_shapes(project: Project, frame: int) -> list[RotoShape]:
    """The shapes that may be grabbed at `frame`, bottom first."""
    return editable_in(project, range(frame, frame + 1))


def editable_in(project: Project, frames: range) -> list[RotoShape]:
    """The shapes that may be grabbed on any of these frames, bottom first."""
    free = [shown.shape for shown in _below(project.plate_root, project.root.locked) if not shown.locked]
    return [shape for shape in free if any(shape.exists_at(frame) for frame in frames)]


def bounds(arrays: list[Array]) -> tuple[float, float, float, float] | None:
    """The box `(left, top, right, bottom)` around positions `(..., 2)`, or None where there are none."""
    flat = [array.reshape(-1, 2) for array in arrays if array.size]
    if not flat:
        return None
    low, high = np.vstack(flat).min(axis=0), np.vstack(flat).max(axis=0)
    return float(low[0]), float(low[1]), float(high[0]), float(high[1])


def selection_bounds(
    project: Project, frame: int, shape_ids: frozenset[str], points: frozenset[tuple[str, int]]
) -> tuple[float, float, float, float] | None:
    """The box around the selected points, or around the selected shapes where no point is."""
    outlines = {s.shape.id: s.shape.at(frame) for s in shown_shapes(project, frame) if s.shape.id in shape_ids}
    if points:
        return bounds([outlines[i].control_points[p, ANCHOR] for i, p in points if i in outlines])
    return bounds([extent(outline.points, outline.closed) for outline in outlines.values()])


def lacks_base(project: Project, frame: int) -> bool:
    """Whether shapes are in sight at `frame` that only subtract or intersect, with nothing under them to do it to."""
    return bool(shown_shapes(project, frame)) and not _gives(project.root, frame)


def _gives(layer: Layer, frame: int) -> bool:
    """Whether anything in a layer may make its matte more than nothing."""
    if layer.invert:
        return True
    there = [child for child in layer.children if child.visible and child.blend not in NEEDS_OTHERS]
    return any(_gives(child, frame) if isinstance(child, Layer) else child.exists_at(frame) for child in there)


def _below(layer: Layer, locked: bool) -> Iterator[Shown]:
    if not layer.visible:
        return
    for child in layer.children:
        if isinstance(child, Layer):
            yield from _below(child, locked or child.locked)
        elif child.visible:
            yield Shown(child, locked or child.locked)
