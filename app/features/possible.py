"""What can be done with what is selected, for menus that offer no more than that."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from roam_core.roto import Origin, Project, RotoShape, Spline
from roam_core.roto.layers import raised

from ..model.view_state import ViewState, selected_shapes

Shapes = Sequence[RotoShape]


def is_possible(project: Project, view: ViewState, action_id: str) -> bool:
    """False where an action would find nothing to do on the selected shapes and this frame."""
    shapes = selected_shapes(project, view.selection)
    if action_id in _OF_UNLOCKED and shapes and all(project.is_locked(shape.id) for shape in shapes):
        return False
    if action_id == "layer.ungroup":
        return bool(view.layers) or any(len(project.layers_above(shape.id)) > 1 for shape in shapes)
    if (step := {"shape.raise": 1, "shape.lower": -1}.get(action_id)) is not None:
        return raised(project, view.layers | view.selection.shapes, step) != project
    if action_id == "shape.select_none":
        return bool(view.layers or view.selection.shapes)
    if action_id == "shape.show_all":
        return any(not item.visible for item in project.root.items())
    if action_id == "shape.solo":
        return bool(view.solo.ids or view.layers or shapes)
    if action_id == "points.first":
        counts = [(shape.closed, len(view.selection.indices_of(shape.id))) for shape in shapes]
        return any(count for _, count in counts) and all(
            count == 0 or (closed and count == 1) for closed, count in counts
        )
    test = _OF_SHAPES.get(action_id)
    return test is None or test(shapes, view.frame)


def _has_key(shapes: Shapes, frame: int) -> bool:
    return any(len(shape.keys) > 1 and shape.key_at(frame) is not None for shape in shapes)


def _is_there(shapes: Shapes, frame: int) -> bool:
    return any(shape.exists_at(frame) for shape in shapes)


def _is_tracked(shapes: Shapes, _frame: int) -> bool:
    return any(key.origin is Origin.ENGINE for shape in shapes for key in shape.keys)


def _is_feathered(shapes: Shapes, frame: int) -> bool:
    return any(shape.at(frame).feather is not None for shape in shapes)


def _is(spline: Spline) -> Callable[[Shapes, int], bool]:
    return lambda shapes, _: any(shape.spline is spline for shape in shapes)


_OF_UNLOCKED = {
    "key.set", "key.set_points", "key.delete", "track.forward", "track.backward", "track.fill",
    "track.delete_engine_keys", "edit.cut", "edit.paste_properties", "shape.delete", "shape.rename", "shape.reverse",
    "shape.to_bezier", "shape.to_bspline", "points.smooth", "points.cusp", "points.first", "points.delete",
    "points.transform", "points.toggle_closed", "feather.reset", "feather.all_keys", "planar.forward",
    "planar.backward", "object.one", "object.parts", "object.in_front", "object.behind", "object.as_stacked",
}  # fmt: skip
"""Actions that leave what is locked as it is."""

_OF_SHAPES: Mapping[str, Callable[[Shapes, int], bool]] = {
    "key.set": _is_there,
    "key.set_points": _is_there,
    "key.delete": _has_key,
    "track.delete_engine_keys": _is_tracked,
    "track.fill": lambda shapes, _: any(len(shape.artist_keys) > 1 for shape in shapes),
    "feather.reset": _is_feathered,
    "feather.all_keys": lambda shapes, _: any(len(shape.keys) > 1 for shape in shapes),
    "points.smooth": _is(Spline.BEZIER),
    "points.cusp": _is(Spline.BEZIER),
    "shape.to_bezier": _is(Spline.BSPLINE),
    "shape.to_bspline": _is(Spline.BEZIER),
    "object.one": lambda shapes, _: len(shapes) > 1,
    "object.parts": lambda shapes, _: any(shape.link for shape in shapes),
    "object.as_stacked": lambda shapes, frame: any(shape.depth_at(frame) for shape in shapes),
    "file.export_selected": lambda shapes, _: bool(shapes),
}
