"""Shapes that an engine closed to a point: where something would be seen of the point, the opacity takes them out."""

from __future__ import annotations

from dataclasses import replace

from roam_core.interchange.bake_layers import BY_LAYER
from roam_core.interchange.flatten import is_feathered
from roam_core.roto import BlendMode, Layer, RotoShape
from roam_core.roto.animated import is_always, product
from roam_core.roto.sight import in_sight


def without_points(layer: Layer, are_smoothed: bool) -> Layer:
    """The layer whose shapes have no opacity on the keys on which they are out of sight (`roto.sight`).

    Soft shapes, for other programs would blur the point; all of them where keys `are_smoothed`, which opens it again.
    An inverted shape, and one that intersects, says more out of sight than without opacity: it stays.
    """
    children = (
        without_points(child, are_smoothed) if isinstance(child, Layer) else _without_point(child, are_smoothed)
        for child in layer.children
    )
    return replace(layer, children=tuple(children))


def _without_point(shape: RotoShape, is_smoothed: bool) -> RotoShape:
    if shape.invert or shape.blend is BlendMode.INTERSECT or not (is_smoothed or is_feathered(shape)):
        return shape
    own = tuple(key for key in shape.keys if key.inputs != BY_LAYER)
    sight = in_sight(replace(shape, keys=own)) if own else 1.0
    return shape if is_always(sight, 1.0) else replace(shape, opacity=product(shape.opacity, sight))
