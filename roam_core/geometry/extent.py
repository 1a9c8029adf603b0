"""The extent of a spline: the exact upright box about its curve, from where its segments turn back."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import bezier


def extent(points: Array, closed: bool = True) -> Array:
    """The corners `(2, 2)`, least and greatest, of the box about the curve of `points (P, 3, 2)`."""
    control = bezier.segments(points, closed)
    if len(control) == 0:
        return np.stack([points[:, bezier.ANCHOR].min(axis=0), points[:, bezier.ANCHOR].max(axis=0)])
    t = np.concatenate([_turns(control), np.zeros((1, *control[:, 0].shape)), np.ones((1, *control[:, 0].shape))])
    reached = np.einsum("rscb,sbc->rsc", bezier.bernstein(t), control)
    return np.stack([reached.min(axis=(0, 1)), reached.max(axis=(0, 1))])


def _turns(control: Array) -> Array:
    """The parameters `(2, S, 2)` at which segments `(S, 4, 2)` turn back in x and in y; 0 where they do not."""
    first, second, third = np.moveaxis(np.diff(control, axis=1), 1, 0)
    a, half, c = first - 2.0 * second + third, second - first, first
    root = np.sqrt(np.maximum(half * half - a * c, 0.0))
    # The form that loses nothing where the two terms of the usual one nearly cancel, nor where a is naught.
    q = -(half + np.where(half < 0.0, -root, root))
    with np.errstate(divide="ignore", invalid="ignore"):
        t = np.stack([q / a, c / q])
    return np.where(np.isfinite(t) & (t > 0.0) & (t < 1.0), t, 0.0)
