"""Smooth through time: a tracked outline shivers a little on every frame, an artist's moves evenly.

The engine's keys move to where their accelerations are least while they stay near the tracked outline: penalised least
squares in time, in which sliding along the outline costs little. No place of the outline strays farther than the reach
that is asked for; the artist's keys stay bit by bit.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from roam_core.arrays import Array, Bools
from roam_core.cancel import CancelToken
from roam_core.errors import RoamError
from roam_core.geometry import bspline
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.interchange.bake_layers import BY_LAYER
from roam_core.interchange.keys.reduction import PLACES, places
from roam_core.roto import Interpolation, Origin, RotoShape, Spline
from roam_core.translatable import sentence

STIFFNESS = 10.0
"""Weight of a squared acceleration (pixels a frame a frame) against a squared pixel of distance: of a shiver from frame
to frame a 160th part is left, of a swing that takes 20 frames nine tenths, of one of 40 frames all but a 200th."""

SLIDE = 0.1
"""Weight of moving along the outline against moving across it."""

ROUNDS = 60
"""Times that places which stray too far are held tighter; what strays even then goes back towards where it was."""

HELD = 1e9
"""Weight of a key that must not move."""


@dataclass(frozen=True)
class Smoothing:
    """A shape that moves evenly, and what that costs.

    Attributes
    ----------
    shape : the shape with the engine's keys moved.
    max_error, mean_error : pixels between the outlines before and after, over all places of the engine's keys.
    """

    shape: RotoShape
    max_error: float
    mean_error: float

    def report(self) -> str:
        """What was done, in one sentence."""
        return sentence(
            "{name!r}: smoothed through time; the engine's outlines moved by at most {max_error:.2f} "
            "px, {mean_error:.2f} px on average.",
            name=self.shape.name,
            max_error=self.max_error,
            mean_error=self.mean_error,
        )


def smoothed(shape: RotoShape, reach: float, token: CancelToken | None = None) -> Smoothing:
    """The shape with the engine's keys moved by at most `reach` pixels, so that it moves as evenly as that allows.

    Held and smooth spans part a shape in time: nothing is evened out across them. What a layer's motion made stays.

    Raises `RoamError` when the reach is no positive number.
    """
    if not 0.0 < reach < np.inf:
        raise RoamError(
            sentence("The reach of smoothing must be a positive number of pixels, not {reach:g}.", reach=reach)
        )
    movable = np.array([key.origin is Origin.ENGINE and key.inputs != BY_LAYER for key in shape.keys])
    bends = _accelerations(shape)
    if not movable.any() or not len(bends):
        return Smoothing(shape, 0.0, 0.0)
    tracked = _stacked(shape)
    moved, strays = _evened(shape, tracked, STIFFNESS * bends.T @ bends, movable, reach, token)
    keys = (
        replace(key, points=each[0], feather=None if key.feather is None and not each[1:].any() else each[1])
        if is_movable
        else key
        for key, each, is_movable in zip(shape.keys, moved, movable, strict=True)
    )
    strays = strays[movable]
    return Smoothing(replace(shape, keys=tuple(keys)), float(strays.max()), float(strays.mean()))


def _stacked(shape: RotoShape) -> Array:
    """Points, and the feather's offsets where there are any, of every key: `(K, 1 | 2, P, 3, 2)`."""
    points = np.stack([key.points for key in shape.keys])
    if all(key.feather is None for key in shape.keys):
        return points[:, None]
    feathers = [np.zeros_like(points[0]) if key.feather is None else key.feather for key in shape.keys]
    return np.stack([points, np.stack(feathers)], axis=1)


def _accelerations(shape: RotoShape) -> Array:
    """The linear map `(A, K)` from the keys' values to the accelerations between linear spans.

    Each is weighted by the root of the time for which it stands: keys on every frame have the rows 1, -2, 1.
    """
    rows = []
    for k in range(1, len(shape.keys) - 1):
        before, key, after = shape.keys[k - 1 : k + 2]
        if before.interpolation is key.interpolation is Interpolation.LINEAR:
            first, second = key.frame - before.frame, after.frame - key.frame
            row = np.zeros(len(shape.keys))
            row[k - 1 : k + 2] = 1.0 / first, -1.0 / first - 1.0 / second, 1.0 / second
            rows.append(row / np.sqrt(0.5 * (first + second)))
    return np.array(rows).reshape(len(rows), len(shape.keys))


def _evened(
    shape: RotoShape,
    tracked: Array,
    stiffness: Array,
    movable: Bools,
    reach: float,
    token: CancelToken | None,
) -> tuple[Array, Array]:
    """Points of every key, evened out, as `tracked (K, C, P, 3, 2)`; their strays `(K, C, S)`, none above `reach`."""
    pull = -np.tensordot(stiffness, tracked, axes=1)
    metric = _metric(tracked[:, 0], shape.closed)
    before = places(tracked, shape.closed)
    weights = np.ones(metric.shape[:2])
    weights[:, ~movable] = HELD
    for _ in range(ROUNDS):
        if token is not None:
            token.check()
        moved = tracked + _displacements(pull, stiffness, weights[..., None, None] * metric)
        moved[~movable] = tracked[~movable]
        if shape.spline is Spline.BSPLINE:
            moved[movable, 0] = [_settled(points, shape.closed) for points in moved[movable, 0]]
        strays = _strays(before, places(moved, shape.closed), shape.closed)
        worst = _at_points(strays.max(axis=1), tracked.shape[2], shape.closed)
        if worst.max() <= reach:
            return moved, strays
        tighter = 1.2 * (worst / reach) ** 2
        weights[:, movable] *= np.where(worst > 0.98 * reach, np.clip(tighter, 1.0, 100.0), 1.0).T[:, movable]
    return _drawn_back(shape, tracked, moved, reach)


def _metric(points: Array, closed: bool) -> Array:
    """What moving each point costs in each key `(P, K, 2, 2)`, from `points (K, P, 3, 2)`: 1 across, little along."""
    along = points[:, :, OUT] - points[:, :, IN]
    chord = np.roll(points[:, :, ANCHOR], -1, axis=1) - np.roll(points[:, :, ANCHOR], 1, axis=1)
    if not closed:
        chord[:, [0, -1]] = 0.0
    along = np.where(np.abs(along).max(axis=-1, keepdims=True) > 1e-6, along, chord)
    length = np.hypot(along[..., 0], along[..., 1])[..., None]
    unit = along / np.where(length > 1e-6, length, np.inf)
    metric: Array = np.eye(2) - (1.0 - SLIDE) * unit[..., :, None] * unit[..., None, :]
    return metric.transpose(1, 0, 2, 3)


def _displacements(pull: Array, stiffness: Array, weights: Array) -> Array:
    """How far each control point moves under `pull (K, C, P, 3, 2)`; `weights (P, K, 2, 2)`, `stiffness (K, K)`.

    One symmetric system of five bands holds the keys of all points one after the other, x and y of each in turn.
    """
    from scipy.linalg import solveh_banded  # large: an export without smoothing does not wait for it

    keys, curves, count = pull.shape[:3]
    bands = np.zeros((5, count, keys, 2))
    bands[4] = np.diagonal(stiffness)[:, None] + np.diagonal(weights, axis1=2, axis2=3)
    bands[3, :, :, 1] = weights[..., 0, 1]
    bands[2, :, 1:] = np.diagonal(stiffness, 1)[:, None]
    bands[0, :, 2:] = np.diagonal(stiffness, 2)[:, None]
    columns = pull.transpose(2, 0, 4, 1, 3).reshape(count * keys * 2, curves * 3)
    solved = solveh_banded(bands.reshape(5, -1), columns)
    return np.asarray(solved.reshape(count, keys, 2, curves, 3).transpose(1, 3, 0, 4, 2))


def _settled(points: Array, closed: bool) -> Array:
    """The B-spline nearest to `points (P, 3, 2)`, as points."""
    return bspline.bezier_points(bspline.control_polygon(points, closed), closed)


def _strays(before: Array, after: Array, closed: bool) -> Array:
    """Distances `(K, C, S)` between two outlines at every place, both ways."""
    from roam_core.kernels.key_spans import outline_distances  # numba: a command's help must not wait for it

    return np.maximum(outline_distances(before, after, closed), outline_distances(after, before, closed))


def _at_points(strays: Array, count: int, closed: bool) -> Array:
    """The largest of `strays (K, S)` on the segments that a point bounds, `(K, P)`."""
    worst = np.zeros((len(strays), count))
    segment = np.minimum(np.arange(strays.shape[1]) // PLACES, count - 1 if closed else max(count - 2, 0))
    for ends in (segment, np.minimum(segment + 1, count - 1) if not closed else (segment + 1) % count):
        np.maximum.at(worst.T, ends, strays.T)
    return worst


def _drawn_back(shape: RotoShape, tracked: Array, moved: Array, reach: float) -> tuple[Array, Array]:
    """`moved`, with the keys that stray beyond `reach` drawn back towards `tracked` by halves until they do not."""
    before = places(tracked, shape.closed)
    for _ in range(30):
        strays = _strays(before, places(moved, shape.closed), shape.closed)
        beyond = strays.max(axis=(1, 2)) > reach
        if not beyond.any():
            return moved, strays
        moved[beyond] = 0.5 * (tracked[beyond] + moved[beyond])
    moved[beyond] = tracked[beyond]
    return moved, _strays(before, places(moved, shape.closed), shape.closed)
