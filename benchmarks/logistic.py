"""A logistic model of a share, no weight of which is negative: what confidence is fitted with."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array

RIDGE = 4e-3
"""Price of the squared weight of a sign, in units of its standard deviation."""
ROUNDS, STEPS = 6, 8
"""Times that features of negative weight are dropped, and Newton's steps each time: both more than enough."""


def fitted(features: Array, shares: Array, counts: Array) -> Array:
    """Constant and weights `(1 + K,)` of `expected` that make the shares most probable.

    Parameters
    ----------
    features : (M, K). shares : (M,) in [0, 1]. counts : (M,) how much each row counts.
    """
    middle, spread = features.mean(axis=0), features.std(axis=0) + 1e-9
    rows = np.column_stack([np.ones(len(features)), -(features - middle) / spread])
    price = np.array([0.0, *[RIDGE] * features.shape[1]])
    weights, kept = np.zeros(rows.shape[1]), np.ones(rows.shape[1], dtype=bool)
    for _ in range(ROUNDS):
        weights[kept] = _newton(rows[:, kept], shares, counts / counts.sum(), price[kept])
        against = kept & (weights < 0)
        against[0] = False
        if not against.any():
            break
        kept &= ~against
        weights[against] = 0.0
    slopes = weights[1:] / spread
    return np.array([weights[0] + slopes @ middle, *slopes])


def expected(features: Array, weights: Array) -> Array:
    """The share `(M,)` that features `(M, K)` let one expect, as `confidence.expected_overlap` has it."""
    return np.asarray(1.0 / (1.0 + np.exp(features @ weights[1:] - weights[0])))


def _newton(rows: Array, shares: Array, counts: Array, price: Array) -> Array:
    weights = np.zeros(rows.shape[1])
    for _ in range(STEPS):
        now = 1.0 / (1.0 + np.exp(-np.clip(rows @ weights, -30.0, 30.0)))
        slope = rows.T @ (counts * (now - shares)) + price * weights
        curvature = (rows.T * (counts * now * (1.0 - now))) @ rows + np.diag(price + 1e-9)
        weights = weights - np.linalg.solve(curvature, slope)
    return weights
