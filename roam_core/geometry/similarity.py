"""Similarity transforms `(2, 3)`: least squares, RANSAC, application."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array, Bools

IDENTITY: Array = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
IDENTITY.setflags(write=False)


def fit(source: Array, target: Array, weights: Array | None = None) -> Array:
    """The similarity `(2, 3)` that maps `source (K, 2)` to `target (K, 2)` with the least (weighted) squared error.

    With one point it is the translation; with none the identity.
    """
    if len(source) == 0:
        return IDENTITY.copy()
    w = np.ones(len(source)) if weights is None else weights
    w = w / w.sum()
    mean_s, mean_t = w @ source, w @ target
    s, t = source - mean_s, target - mean_t
    spread = float(w @ (s**2).sum(axis=1))
    if spread < 1e-12:
        a, b = 1.0, 0.0
    else:
        a = float(w @ (s[:, 0] * t[:, 0] + s[:, 1] * t[:, 1])) / spread
        b = float(w @ (s[:, 0] * t[:, 1] - s[:, 1] * t[:, 0])) / spread
    linear = np.array([[a, -b], [b, a]])
    return np.column_stack([linear, mean_t - linear @ mean_s])


def apply(transform: Array, positions: Array) -> Array:
    """`positions (..., 2)` carried by `transform (2, 3)`."""
    return np.asarray(positions @ transform[:, :2].T + transform[:, 2])


def ransac(source: Array, target: Array, threshold: float = 2.0, trials: int = 128) -> tuple[Array, Bools]:
    """A similarity robust to outliers, and which of the pairs agree with it.

    Two-point hypotheses drawn from a seeded generator (the same input gives the same bits), inliers within
    `threshold` pixels, then least squares on the inliers of the best one, twice.
    """
    from roam_core.kernels.hypotheses import agreed_similarity  # numba: a command's help must not wait for it

    n = len(source)
    if n < 3:
        return fit(source, target), np.ones(n, dtype=bool)
    rng = np.random.default_rng(0)
    first = rng.integers(0, n, trials)
    second = (first + rng.integers(1, n, trials)) % n
    return agreed_similarity(source, target, first, second, threshold)
