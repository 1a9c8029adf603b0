"""Where shapes and tracked layers are on a frame, as one place each: what a stabilised view goes along with."""

from __future__ import annotations

from collections.abc import Collection

from roam_core.geometry import projective
from roam_core.geometry.bezier import ANCHOR
from roam_core.roto import Layer, Project, RotoShape
from roam_core.roto.following import matrix_of, surface_of
from roam_core.roto.sight import is_out_of_sight

Places = dict[str, tuple[float, float]]
"""Image positions of shapes and layers, by their ids."""


def places_of(project: Project, frame: int, shape_ids: Collection[str], layer_ids: Collection[str] = ()) -> Places:
    """Where those of the shapes and layers that are seen on a frame are, in plate space.

    Of a layer that moves with a track it is the middle of the tracked surface, in place of its shapes. Of a shape it
    is the mean of its anchors: each keeps its spot on the object, so their mean does, however the object turns, grows
    or leans, and a single anchor that chatters hardly moves it. The middle of the outline's bounds hangs on four
    anchors alone and goes to and fro as a shape turns; the centroid of its area is nowhere for open shapes and for
    those that cross themselves. What an engine closed, because it is out of sight, is not seen.
    """
    tracked = [layer for layer in map(project.find, filter(project.has, layer_ids)) if _moves(layer)]
    carried = {shape.id for layer in tracked if isinstance(layer, Layer) for shape in layer.shapes()}
    found: Places = {}
    for layer in tracked:
        if isinstance(layer, Layer) and all(each.visible for each in (layer, *project.layers_above(layer.id))):
            middle = projective.apply(matrix_of(project, layer.id, frame), surface_of(layer).mean(axis=0))
            found[layer.id] = float(middle[0]), float(middle[1])
    for shape in map(project.shape, filter(project.has, set(shape_ids) - carried)):
        if _is_seen(project, shape, frame):
            x, y = shape.at(frame).points[:, ANCHOR].mean(axis=0).tolist()
            found[shape.id] = x, y
    return found


def _is_seen(project: Project, shape: RotoShape, frame: int) -> bool:
    is_shown = shape.visible and all(layer.visible for layer in project.layers_above(shape.id))
    return is_shown and shape.exists_at(frame) and not is_out_of_sight(shape, frame)


def _moves(item: object) -> bool:
    """Whether a layer has a motion of its own that may be followed: one matrix, or no shapes, is none."""
    if not isinstance(item, Layer) or item.transform is None or len(item.transform.frames) < 2:
        return False
    return bool(item.transform.surface) or any(True for _ in item.shapes())
