"""Moving the points of shapes on one frame: what drags, nudges and point actions have in common. Free of Qt."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.canvas.shown import editable_shapes
from app.view_state import Selection
from roam_core.geometry.bezier import ANCHOR
from roam_core.roto import Project, RotoShape, edit
from roam_core.roto.edit import Part

Array = NDArray[np.float64]
Vector = tuple[float, float]


def keyed(project: Project, shape_id: str, frame: int, points: Array) -> Project:
    """The project with these points of a shape at `frame`, as an artist key.

    On a frame without a key, or with one of the engine's, this makes an artist key: a hand-made edit is never
    interpolated away nor tracked over.
    """
    return project.with_shape(edit.set_key(project.shape(shape_id), frame, points))


@dataclass(frozen=True)
class Grab:
    """What a drag holds: parts of shapes on one frame, and where their points were when it began."""

    frame: int
    parts: Mapping[str, tuple[Part, ...]]
    start: Mapping[str, Array]

    @classmethod
    def of(cls, project: Project, frame: int, parts: Mapping[str, tuple[Part, ...]]) -> Grab:
        return cls(frame, parts, {shape_id: project.shape(shape_id).at(frame).points for shape_id in parts})

    def is_held(self, project: Project) -> bool:
        """False when an edit meanwhile took a shape away, locked it, or gave it another number of points."""
        counts = {shape.id: shape.point_count for shape in editable_shapes(project, self.frame)}
        return all(counts.get(shape_id) == len(points) for shape_id, points in self.start.items())

    def moved(self, project: Project, delta: Vector) -> Project:
        """The project with the grabbed parts moved by `delta` from where they began, image pixels."""
        return self._mapped(project, lambda points, parts: edit.move_parts(points, parts, delta))

    def turned(self, project: Project, position: Vector, tangent: Tangent) -> Project:
        """The project with the one grabbed handle put at `position`."""
        return self._mapped(project, lambda points, parts: tangent(points, *parts[0], position))

    def _mapped(self, project: Project, function: Callable[[Array, tuple[Part, ...]], Array]) -> Project:
        for shape_id, parts in self.parts.items():
            project = keyed(project, shape_id, self.frame, function(self.start[shape_id], parts))
        return project


Tangent = Callable[[Array, int, int, Vector], Array]
"""How the other handle follows: `(points, index, part, position) -> points`."""


def break_tangent(points: Array, index: int, part: int, position: Vector) -> Array:
    """The other handle stays: the point becomes a cusp."""
    return edit.drag_handle(points, index, part, position, keep_smooth=False)


def grabbed_parts(project: Project, frame: int, selection: Selection) -> dict[str, tuple[Part, ...]]:
    """The anchors that an edit of the selection moves, by shape: the selected points, or whole shapes if none is.

    Shapes that are locked, hidden or outside their lifetime are left out.
    """
    chosen: dict[str, tuple[Part, ...]] = {}
    for shape in editable_shapes(project, frame):
        if shape.id in selection.shapes:
            indices = selected_indices(shape, selection) if selection.points else range(shape.point_count)
            if indices:
                chosen[shape.id] = tuple((index, ANCHOR) for index in indices)
    return chosen


def selected_indices(shape: RotoShape, selection: Selection) -> list[int]:
    """The selected points of one shape, in order."""
    return sorted(index for owner, index in selection.points if owner == shape.id and index < shape.point_count)


def with_point_inserted(shape: RotoShape, segment: int, t: float) -> RotoShape:
    """A new point, of index `segment + 1`, where the outline was hit; a hit on an anchor puts it just beside."""
    return edit.insert_point(shape, segment, min(max(t, 1e-3), 1.0 - 1e-3))


def pruned(selection: Selection, project: Project) -> Selection:
    """The selection without the shapes and points that the project does not have (any more)."""
    counts = {shape.id: shape.point_count for shape in project.shapes}
    shapes = frozenset(shape_id for shape_id in selection.shapes if shape_id in counts)
    return Selection(shapes, frozenset((i, p) for i, p in selection.points if p < counts.get(i, 0)))
