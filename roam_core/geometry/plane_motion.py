"""Motions of a plane as matrices `(3, 3)`: least squares and RANSAC for translation, similarity, affine, homography.

They act on pixels. Where these are shown wider than high (`pixel_aspect` is not 1), what turns is a similarity as it is
shown: in pixels it shears. The other kinds are the same, however pixels are shown.
"""

from __future__ import annotations

from enum import StrEnum

import numpy as np

from roam_core.arrays import Array, Bools
from roam_core.geometry import projective


class PlaneMotion(StrEnum):
    """What a plane may do between two pictures, each kind holding the ones before it."""

    TRANSLATION = "translation"
    SIMILARITY = "similarity"
    AFFINE = "affine"
    HOMOGRAPHY = "homography"

    @property
    def pairs(self) -> int:
        """The pairs of points that fix such a motion."""
        return {"translation": 1, "similarity": 2, "affine": 3, "homography": 4}[self.value]


def fit(kind: PlaneMotion, source: Array, target: Array, pixel_aspect: float = 1.0) -> Array | None:
    """The motion `(3, 3)` that carries `source (K, 2)` to `target (K, 2)` with the least squared error.

    Of a homography the error is measured in the target picture, to first order. None where the points fix none: too
    few, or all on one line.
    """
    if len(source) < kind.pairs:
        return None
    before, after = _centrings(kind, source, target, pixel_aspect)
    s, t = projective.apply(before, source), projective.apply(after, target)
    weights = np.ones(len(s))
    for _ in range(3 if kind is PlaneMotion.HOMOGRAPHY and len(s) > 4 else 1):
        rows, right = _equations(kind, s, t)
        twice = np.concatenate([weights, weights])
        unknown, _, rank, _ = np.linalg.lstsq(rows * twice[:, None], right * twice, rcond=1e-9)
        if rank < rows.shape[1]:
            return None
        matrix = _matrix(kind, unknown[None])[0]
        weights = 1.0 / np.maximum(projective.depth(matrix, s), 1e-3)
    return projective.usable(np.linalg.inv(after) @ matrix @ before)


def ransac(
    kind: PlaneMotion, source: Array, target: Array, threshold: float, pixel_aspect: float = 1.0, trials: int = 256
) -> tuple[Array | None, Bools]:
    """A motion `(3, 3)` robust to outliers, and which of the pairs `(K, 2)` agree with it.

    The fewest pairs that fix a motion are drawn from a seeded generator (the same input gives the same bits); the
    hypothesis of the least error, cut off at `threshold` pixels, is fitted to those that agree with it until they stay
    the same. None where no hypothesis is usable.
    """
    from roam_core.kernels.hypotheses import best_motion  # numba: reading a project must not wait for it

    n, none = len(source), np.zeros(len(source), dtype=bool)
    if n < kind.pairs:
        return None, none
    before, after = _centrings(kind, source, target, pixel_aspect)
    s, t = projective.apply(before, source), projective.apply(after, target)
    drawn = np.random.default_rng(0).random((trials, n)).argpartition(kind.pairs - 1, axis=1)[:, : kind.pairs]
    guesses = _solved(kind, s[drawn], t[drawn])
    scale = after[1, 1]  # of what `t` is measured in, to a pixel of the target
    best = guesses[best_motion(guesses, s, t, threshold * scale, projective.HORIZON)]
    agree = np.hypot(*(projective.apply(best, s) - t).T) <= threshold * scale
    matrix = None
    for _ in range(10):
        found = fit(kind, source[agree], target[agree], pixel_aspect)
        if found is None:
            break
        matrix, was = found, agree
        agree = np.hypot(*(projective.apply(matrix, source) - target).T) <= threshold
        if np.array_equal(agree, was):
            break
    return matrix, none if matrix is None else agree


def _centring(points: Array) -> Array:
    """The map that brings points about the origin, their mean distance from it to 1: solvers are exact there."""
    middle = points.mean(axis=0)
    spread = max(float(np.hypot(*(points - middle).T).mean()), 1e-9)
    return np.array([[1.0 / spread, 0.0, -middle[0] / spread], [0.0, 1.0 / spread, -middle[1] / spread], [0, 0, 1.0]])


def _centrings(kind: PlaneMotion, source: Array, target: Array, pixel_aspect: float) -> tuple[Array, Array]:
    """The maps of `_centring` for both; a translation keeps its size, so one scale serves both.

    Those of a similarity map to what is shown, where it turns without shear.
    """
    shown = np.diag([pixel_aspect if kind is PlaneMotion.SIMILARITY else 1.0, 1.0, 1.0])
    before, after = (_centring(projective.apply(shown, points)) @ shown for points in (source, target))
    if kind is PlaneMotion.TRANSLATION:
        after = np.diag([before[0, 0] / after[0, 0]] * 2 + [1.0]) @ after
    return before, after


def _equations(kind: PlaneMotion, source: Array, target: Array) -> tuple[Array, Array]:
    """Linear equations `(..., 2K, U)` and right sides `(..., 2K)` for `source` and `target (..., K, 2)`."""
    x, y, u, v = source[..., 0], source[..., 1], target[..., 0], target[..., 1]
    one, zero = np.ones_like(x), np.zeros_like(x)
    if kind is PlaneMotion.TRANSLATION:
        rows, right = ([one, zero], [zero, one]), (u - x, v - y)
    elif kind is PlaneMotion.SIMILARITY:
        rows, right = ([x, -y, one, zero], [y, x, zero, one]), (u, v)
    elif kind is PlaneMotion.AFFINE:
        rows, right = ([x, y, one, zero, zero, zero], [zero, zero, zero, x, y, one]), (u, v)
    else:
        across = [x, y, one, zero, zero, zero, -u * x, -u * y]
        down = [zero, zero, zero, x, y, one, -v * x, -v * y]
        rows, right = (across, down), (u, v)
    return np.concatenate([np.stack(each, axis=-1) for each in rows], axis=-2), np.concatenate(right, axis=-1)


def _matrix(kind: PlaneMotion, unknown: Array) -> Array:
    """Matrices `(T, 3, 3)` of the solutions `(T, U)`."""
    result = np.tile(np.eye(3), (len(unknown), 1, 1))
    if kind is PlaneMotion.TRANSLATION:
        result[:, :2, 2] = unknown
    elif kind is PlaneMotion.SIMILARITY:
        a, b, dx, dy = unknown.T
        result[:, 0], result[:, 1] = np.stack([a, -b, dx], axis=1), np.stack([b, a, dy], axis=1)
    elif kind is PlaneMotion.AFFINE:
        result[:, :2] = unknown.reshape(-1, 2, 3)
    else:
        result.reshape(-1, 9)[:, :8] = unknown
    return result


def _solved(kind: PlaneMotion, source: Array, target: Array) -> Array:
    """The motions `(T, 3, 3)` fixed by the fewest pairs `(T, K, 2)`; where they fix none, the identity."""
    rows, right = _equations(kind, source, target)
    solvable = np.abs(np.linalg.det(rows)) > 1e-8
    rows = np.where(solvable[:, None, None], rows, np.eye(rows.shape[1]))
    found = _matrix(kind, np.asarray(np.linalg.solve(rows, right[..., None])[..., 0], dtype=np.float64))
    return np.where(solvable[:, None, None], found, np.eye(3))
