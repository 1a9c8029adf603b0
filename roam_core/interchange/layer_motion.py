"""The motion of another program's layer as one of ours: its shapes keep their own keys, few as they are."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from itertools import pairwise

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import bspline, projective
from roam_core.interchange.keys.keying import NEAR, keys_of
from roam_core.interchange.reading import ShapeReader, brief
from roam_core.roto import Interpolation, Layer, LayerTransform, RotoShape, Spline
from roam_core.roto.placement import matrix_at
from roam_core.roto.shape import unplaced


def layer_motion(
    matrices: Callable[[Array], Array],
    times: Iterable[float],
    size: tuple[float, float],
    frame: Callable[[float], int],
    reader: ShapeReader,
) -> LayerTransform | None:
    """The matrices of a layer that moves, on as few frames as show the same on every frame.

    Parameters
    ----------
    matrices : gives `(T, 3, 3)` in pixels, y down, at any moments `(T,)` of the file.
    times : of the file's keys.
    size : (width, height) of the file's pictures, pixels; differences are measured at their corners.
    frame : turns the file's frames into the plate's.

    Returns
    -------
    The motion, or None where one of its matrices is no map of the plane, as where a layer shrinks to nothing, or one of
    its frames no frame.
    """
    reach = np.array([*size, 1.0]) * np.array([1.0, 1.0, max(size)])[:, None]

    def scaled(moments: Array) -> Array:
        found = matrices(moments)
        return np.asarray(found / found[:, 2:, 2:] * reach)

    keys = keys_of(scaled, times, reader.check_keys)
    found = {key.frame: key.value / reach for key in keys}
    more: set[int] = set()
    for key, following in pairwise(keys):  # between two of ours a matrix moves evenly
        if key.interpolation is Interpolation.SMOOTH:
            reader.check_keys(following.frame - key.frame)
            more.update(range(key.frame + 1, following.frame))
        elif key.interpolation is Interpolation.HOLD:
            more.add(following.frame - 1)
    if beside := sorted(more - found.keys()):
        found |= zip(beside, matrices(np.array(beside, dtype=np.float64)), strict=True)
    try:
        return LayerTransform.of({frame(at): matrix for at, matrix in found.items()})
    except ValueError:
        return None


def tell_strays(layer: Layer, reader: ShapeReader) -> None:
    """A note where a perspective shows B-splines otherwise than in the other program.

    There the curve is that of the control points as they are seen; in our layers it is the curve itself that is seen.
    """
    strays = {
        shape.id: (_stray(shape), shape.name)
        for shape in layer.in_plate_space().shapes()
        if shape.spline is Spline.BSPLINE and shape.placement
    }
    seen = [each for each in strays.values() if each[0] > NEAR]
    if seen:
        most, name = max(seen)
        reader.note(
            f"{len(seen)} B-spline(s) lie in a layer that moves in perspective, which carries the curve in place "
            f"of its control points: {brief(name)} strays by up to {most:.1f} px."
        )


def _stray(shape: RotoShape) -> float:
    """How far the handles of a B-spline lie from those of the B-spline of its control points, as they are seen."""
    strays = [0.0]
    for key in unplaced(shape).keys:
        matrix = matrix_at(shape.placement, key.frame)
        if matrix[2, :2].any():
            controls = projective.apply(matrix, bspline.control_polygon(key.points, shape.closed))
            curve = bspline.bezier_points(controls, shape.closed)
            strays.append(float(np.abs(curve - projective.apply(matrix, key.points)).max()))
    return max(strays)
