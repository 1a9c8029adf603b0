"""The motion of another program's layer as one of ours: its shapes keep their own keys, few as they are."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import pairwise

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import projective
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.interchange.keys.keying import NEAR, keys_of
from roam_core.interchange.reading import ShapeReader, brief
from roam_core.roto import Interpolation, Layer, LayerTransform, RotoShape, Spline
from roam_core.roto.placement import Placement, matrix_at
from roam_core.translatable import sentence


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
    seen = [(stray, shape.name) for shape, above in _carried(layer) if (stray := _stray(shape, above)) > NEAR]
    if seen:
        most, name = max(seen)
        reader.note(
            sentence(
                "{count} B-spline(s) lie in a layer that moves in perspective, which carries the curve in "
                "place of its control points: {word} strays by up to {most:.1f} px.",
                count=len(seen),
                word=brief(name),
                most=most,
            )
        )


def _carried(layer: Layer, above: Placement = ()) -> Iterator[tuple[RotoShape, Placement]]:
    """The B-splines of layers that move, and what moves them."""
    for child in layer.children:
        if isinstance(child, Layer):
            yield from _carried(child, above if child.transform is None else (*above, child.transform))
        elif above and child.spline is Spline.BSPLINE and child.point_count > 1:
            yield child, above


def _stray(shape: RotoShape, above: Placement) -> float:
    """How far the points of a B-spline lie from those of the B-spline of its control points, as they are seen."""
    matrices = np.stack([matrix_at(above, key.frame) for key in shape.keys])
    if not matrices[:, 2, :2].any():
        return 0.0
    points = np.stack([key.points for key in shape.keys])
    leaving = points[:, :, OUT]
    arriving, following = (np.roll(points[:, :, part], -1, axis=1) for part in (IN, ANCHOR))
    if not shape.closed:
        leaving, arriving, following = leaving[:, :-1], arriving[:, :-1], following[:, :-1]
    # Handles lie at the thirds between two control points; these lie as far beyond the handles as the handles apart.
    first, second = 2.0 * leaving - arriving, 2.0 * arriving - leaving
    left, out, into, right = (_seen(matrices, places) for places in (first, leaving, arriving, second))
    curve_out, curve_into = (2.0 * left + right) / 3.0, (left + 2.0 * right) / 3.0
    between = 0.5 * (curve_into + np.roll(curve_out, -1, axis=1)) - _seen(matrices, following)
    strays = (curve_out - out, curve_into - into, between if shape.closed else between[:, :-1])
    return float(np.abs(np.concatenate(strays, axis=1)).max())


def _seen(matrices: Array, places: Array) -> Array:
    """Places `(K, P, 2)` carried by `(K, 3, 3)`."""
    whole = np.concatenate([places, np.ones((*places.shape[:-1], 1))], axis=-1) @ matrices.transpose(0, 2, 1)
    return np.asarray(whole[..., :2] / np.maximum(whole[..., 2:], projective.HORIZON))
