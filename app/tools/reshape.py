"""Changing the points of shapes on one frame: what drags, nudges and point actions have in common. Free of Qt."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import affine
from roam_core.geometry.bezier import ANCHOR, OUT
from roam_core.geometry.extent import extent
from roam_core.roto import Outline, Project, RotoShape, edit
from roam_core.roto.edit import Part
from roam_core.roto.keying import AUTO_KEY, Change, Keying, held_at, reshape
from roam_core.roto.transform import falloff, transform_like

from ..model.shown import editable_shapes
from ..model.view_state import Selection, ViewState
from .settling import settled

Vector = tuple[float, float]


@dataclass(frozen=True)
class Grab:
    """What a drag holds: shapes on one frame, how far each of their points follows, and where they were at its start.

    Attributes
    ----------
    weights : by shape, `(P,)` in [0, 1]: 1 for a grabbed point, less for those that soft selection takes along.
    start : by shape, what `roam_core.roto.keying.held_at` gave when the drag began.
    keying : which keys the edit reaches.
    """

    frame: int
    weights: Mapping[str, Array]
    start: Mapping[str, Outline]
    keying: Keying = AUTO_KEY

    @classmethod
    def of(cls, project: Project, frame: int, weights: Mapping[str, Array], keying: Keying = AUTO_KEY) -> Grab:
        return cls(frame, weights, {each: held_at(project.shape(each), frame) for each in weights}, keying)

    @property
    def here(self) -> Grab:
        """The same, reaching no keys by ripple: on its own frame the edit looks the same."""
        return replace(self, keying=replace(self.keying, ripple=None))

    @property
    def point_count(self) -> int:
        """How many points follow wholly: those that were grabbed, without what soft selection takes along."""
        return sum(int((weights == 1.0).sum()) for weights in self.weights.values())

    def is_held(self, project: Project) -> bool:
        """False when an edit meanwhile took a shape away, locked it, or gave it another number of points."""
        counts = {shape.id: shape.point_count for shape in editable_shapes(project, self.frame)}
        return all(counts.get(shape_id) == len(start.points) for shape_id, start in self.start.items())

    def moved(self, project: Project, delta: Vector) -> Project:
        """The project with the grabbed points moved by `delta` from where they began, image pixels."""
        return self.transformed(project, affine.translation(delta))

    def transformed(self, project: Project, matrix: Array) -> Project:
        """The project with the grabbed points carried by `matrix`, `(2, 3)` or `(3, 3)`, from where they began."""
        return self.changed(project, lambda each: transform_like(self.start[each], self.weights[each], matrix))

    def settled(self, before: Project, after: Project) -> Project:
        """The project `after` the edit, with what follows from it on other keys; see `app.tools.settling`."""
        return settled(before, after, self.start, self.frame, self.keying)

    def changed(self, project: Project, change_of: Callable[[str], Change]) -> Project:
        """The project with each shape changed as `change_of(shape id)` says, from where it began."""
        return project.with_shapes(
            reshape(project.shape(shape_id), self.frame, change_of(shape_id), self.keying, start)
            for shape_id, start in self.start.items()
        )


Tangent = Callable[[Array, int, int, Vector], Array]
"""How the other handle follows: `(points, index, part, position) -> points`."""


def break_tangent(points: Array, index: int, part: int, position: Vector) -> Array:
    """The other handle stays: the point becomes a cusp."""
    return edit.drag_handle(points, index, part, position, keep_smooth=False)


def as_seen(tangent: Tangent, aspect: float) -> Tangent:
    """The same with lengths and angles as they are seen, of pixels `aspect` times as wide as high."""
    seen = np.array((aspect, 1.0))

    def turned(points: Array, index: int, part: int, position: Vector) -> Array:
        before = points[[index]] * seen
        after = tangent(before, 0, part, (position[0] * aspect, position[1]))
        result = points.copy()
        result[index] = np.where(after[0] == before[0], points[index], after[0] / seen)
        return result

    return turned


def smoothed(points: Array, indices: Iterable[int], closed: bool, aspect: float) -> Array:
    """`edit.smooth_points` with lengths as they are seen, of pixels `aspect` times as wide as high."""
    seen = np.array((aspect, 1.0))
    before = points * seen
    after = edit.smooth_points(before, indices, closed)
    return np.where(after == before, points, after / seen)


def turn(part: Part, delta: Vector, tangent: Tangent) -> Change:
    """The change that moves one handle by `delta`, image pixels, on whichever key."""
    index, which = part

    def change(outline: Outline) -> Outline:
        x, y = (outline.points[index, which] + delta).tolist()
        return replace(outline, points=tangent(outline.points, index, which, (x, y)))

    return change


def pull_out(index: int, delta: Vector) -> Change:
    """The change that draws both handles of a point out of its anchor, the leaving one by `delta`, image pixels."""

    def change(outline: Outline) -> Outline:
        x, y = (outline.points[index, ANCHOR] + delta).tolist()
        return replace(outline, points=edit.equal_handles(outline.points, index, OUT, (x, y)))

    return change


def grabbed_indices(project: Project, frame: int, selection: Selection) -> dict[str, list[int]]:
    """The points that an edit of the selection changes, by shape: the selected ones, or all of them if none is.

    Shapes that are locked, hidden or outside their lifetime are left out.
    """
    chosen: dict[str, list[int]] = {}
    for shape in editable_shapes(project, frame):
        if shape.id in selection.shapes:
            indices = selected_indices(shape, selection) if selection.points else list(range(shape.point_count))
            if indices:
                chosen[shape.id] = indices
    return chosen


def pixel_aspect(project: Project) -> float:
    """Width of a pixel of the project's plate divided by its height."""
    return project.clip.pixel_aspect if project.clip else 1.0


def grabbed_weights(
    project: Project, frame: int, selection: Selection, soft_radius: float | None = None
) -> dict[str, Array]:
    """How far each point follows an edit of the selection, by shape: `(P,)`.

    `soft_radius` is as in `falloff`, heights of a pixel: it reaches as far aside as down on the screen.
    """
    weights: dict[str, Array] = {}
    for shape_id, indices in grabbed_indices(project, frame, selection).items():
        anchors = project.shape(shape_id).at(frame).control_points[:, ANCHOR]
        if soft_radius is None:
            weights[shape_id] = np.zeros(len(anchors))
            weights[shape_id][indices] = 1.0
        else:
            weights[shape_id] = falloff(anchors * (pixel_aspect(project), 1.0), indices, soft_radius)
    return weights


def selection_extent(project: Project, view: ViewState) -> tuple[Vector, Vector] | None:
    """The least and greatest corner of the box about what an edit of the selection changes, or None for nothing.

    About the selected points, or about the whole outlines of the selected shapes.
    """
    found: list[Array] = []
    for shape_id, indices in grabbed_indices(view.solo.seen(project), view.frame, view.selection).items():
        outline = project.shape(shape_id).at(view.frame)
        points = view.selection.points
        found.append(outline.control_points[indices, ANCHOR] if points else extent(outline.points, outline.closed))
    if not found:
        return None
    (left, top), (right, bottom) = np.concatenate(found).min(axis=0), np.concatenate(found).max(axis=0)
    return (float(left), float(top)), (float(right), float(bottom))


def grab_selection(project: Project, view: ViewState, selection: Selection | None = None) -> Grab:
    """What a drag of the selection (or of another one) holds on the present frame, with the modes that are on."""
    chosen = view.selection if selection is None else selection
    weights = grabbed_weights(view.solo.seen(project), view.frame, chosen, view.editing.soft_radius)
    return Grab.of(project, view.frame, weights, view.editing.keying(view.play_range))


def grab_point(project: Project, view: ViewState, shape_id: str, index: int) -> Grab:
    """What a drag of one point's handle holds."""
    weights = np.zeros(project.shape(shape_id).point_count)
    weights[index] = 1.0
    return Grab.of(project, view.frame, {shape_id: weights}, view.editing.keying(view.play_range))


def keys_changed(before: Project, after: Project, shape_ids: Iterable[str]) -> int:
    """How many keys of these shapes an edit changed or made."""
    changed = 0
    for shape_id in shape_ids:
        old = before.shape(shape_id)
        changed += sum(key != old.key_at(key.frame) for key in after.shape(shape_id).keys)
    return changed


def selected_indices(shape: RotoShape, selection: Selection) -> list[int]:
    """The selected points of one shape, in order."""
    return [index for index in selection.indices_of(shape.id) if index < shape.point_count]


def with_point_inserted(shape: RotoShape, segment: int, t: float) -> RotoShape:
    """A new point, of index `segment + 1`, where the outline was hit; a hit on an anchor puts it just beside."""
    return edit.insert_point(shape, segment, min(max(t, 1e-3), 1.0 - 1e-3))


def pruned(selection: Selection, project: Project) -> Selection:
    """The selection without the shapes and points that the project does not have (any more)."""
    counts = {shape.id: shape.point_count for shape in project.shapes}
    shapes = frozenset(shape_id for shape_id in selection.shapes if shape_id in counts)
    return Selection(shapes, frozenset((i, p) for i, p in selection.points if p < counts.get(i, 0)))
