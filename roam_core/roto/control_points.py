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
from roam_core.roto.keyframe import Keyframe
from roam_core.roto.shape import RotoShape, Spline


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
    return shape.spline is Spline.BEZIER or bspline.all_bsplines(_stacked(shape), shape.closed, tolerance)


def with_spline(shape: RotoShape, spline: Spline) -> RotoShape:
    """The shape as one of the other kind.

    To Bezier no outline changes. To a B-spline every key becomes the nearest one of as many points.
    """
    changed = replace(shape, spline=spline)
    if spline is Spline.BEZIER:
        return changed
    polygons = bspline.control_polygons(_stacked(shape), shape.closed)
    return _with_points(changed, bspline.all_bezier_points(polygons, shape.closed))


def with_control(
    shape: RotoShape, on_control: Callable[[Array], Array], on_feather: Callable[[Array], Array]
) -> RotoShape:
    """A B-spline shape with `on_control` applied to the control polygon `(P, 2)` of every key.

    `on_feather` does the like to the feather offsets `(P, 3, 2)`, to as many points.
    """

    polygons = bspline.control_polygons(_stacked(shape), shape.closed)
    changed = np.stack([on_control(polygon) for polygon in polygons])
    return _with_points(shape, bspline.all_bezier_points(changed, shape.closed), on_feather)


def opened_or_closed(shape: RotoShape) -> RotoShape:
    """The shape closed where it was open and the other way round; a B-spline keeps its control polygon."""
    turned = replace(shape, closed=not shape.closed)
    if shape.spline is Spline.BEZIER:
        return turned

    polygons = bspline.control_polygons(_stacked(shape), shape.closed)
    return _with_points(turned, bspline.all_bezier_points(polygons, turned.closed))


def _stacked(shape: RotoShape) -> Array:
    """The points of every key, `(K, P, 3, 2)`."""
    return np.stack([key.points for key in shape.keys])


def _with_points(
    shape: RotoShape, points: Array, on_feather: Callable[[Array], Array] = lambda feather: feather
) -> RotoShape:
    """The shape with these `points (K, Q, 3, 2)` of its keys, which it holds from now on."""
    same = points.shape[1] == shape.point_count
    points.setflags(write=False)

    def given(key: Keyframe, own: Array) -> Keyframe:
        feather = None if key.feather is None else on_feather(key.feather)
        if same:
            return key.with_points(own, feather)
        return replace(key, points=own, feather=feather, vertex_confidence=None)

    return replace(shape, keys=tuple(map(given, shape.keys, points)))
