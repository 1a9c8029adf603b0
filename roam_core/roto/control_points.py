"""Control points: of a Bezier shape its points with handles, of a B-spline its polygon; and the points they give.

They are `(P, 3, 2)` like points; those of a B-spline are its control points with both handles on them, so that tools
move, nudge and transform either kind alike. `Outline.control_points` gives them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from roam_core.arrays import Array
from roam_core.geometry import bspline
from roam_core.geometry.bezier import ANCHOR
from roam_core.roto.shape import Keyframe, RotoShape, Spline


def points_of(control_points: ArrayLike, spline: Spline, closed: bool) -> Array:
    """The points `(P, 3, 2)` of a curve whose control points are `(P, 3, 2)`; handles of a B-spline's control points
    mean nothing.
    """
    controls = np.asarray(control_points, dtype=np.float64)
    return controls if spline is Spline.BEZIER else bspline.bezier_points(controls[:, ANCHOR], closed)


def settled(points: Array, shape: RotoShape) -> Array:
    """`points (P, 3, 2)` as the shape can hold them: of a B-spline shape the nearest B-spline, else themselves."""
    if shape.spline is Spline.BEZIER:
        return points
    return bspline.bezier_points(bspline.control_polygon(points, shape.closed), shape.closed)


def is_of_its_kind(shape: RotoShape, tolerance: float = 1e-3) -> bool:
    """False for a B-spline shape with a key that is none, by more than `tolerance` pixels.

    Perspective makes such keys: the spline of the carried control points is another curve than the carried spline.
    """
    return shape.spline is Spline.BEZIER or all(
        bspline.is_bspline(key.points, shape.closed, tolerance) for key in shape.keys
    )


def with_spline(shape: RotoShape, spline: Spline) -> RotoShape:
    """The shape as one of the other kind.

    To Bezier no outline changes. To a B-spline every key becomes the nearest one of as many points.
    """
    changed = replace(shape, spline=spline)
    return _mapped(changed, lambda points: settled(points, changed), lambda feather: feather)


def with_control(
    shape: RotoShape, on_control: Callable[[Array], Array], on_feather: Callable[[Array], Array]
) -> RotoShape:
    """A B-spline shape with `on_control` applied to the control polygon `(P, 2)` of every key.

    `on_feather` does the like to the feather offsets `(P, 3, 2)`, to as many points.
    """

    def on_points(points: Array) -> Array:
        return bspline.bezier_points(on_control(bspline.control_polygon(points, shape.closed)), shape.closed)

    return _mapped(shape, on_points, on_feather)


def opened_or_closed(shape: RotoShape) -> RotoShape:
    """The shape closed where it was open and the other way round; a B-spline keeps its control polygon."""
    turned = replace(shape, closed=not shape.closed)
    if shape.spline is Spline.BEZIER:
        return turned

    def on_points(points: Array) -> Array:
        return bspline.bezier_points(bspline.control_polygon(points, shape.closed), turned.closed)

    return _mapped(turned, on_points, lambda feather: feather)


def _mapped(shape: RotoShape, on_points: Callable[[Array], Array], on_feather: Callable[[Array], Array]) -> RotoShape:
    def mapped(key: Keyframe) -> Keyframe:
        points = on_points(key.points)
        feather = None if key.feather is None else on_feather(key.feather)
        same = len(points) == len(key.points)
        return replace(key, points=points, feather=feather, vertex_confidence=key.vertex_confidence if same else None)

    return replace(shape, keys=tuple(mapped(key) for key in shape.keys))
