"""Slow, obvious twins of `roam_core.kernels.gmm_density` and of the update of mixtures."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array

Mixture = tuple[Array, Array, Array]
"""Weight (K,), mean (K, 3), variance (K, 3)."""


def ref_components(colour: Array, mixture: Mixture) -> Array:
    """w_k N(colour; mean_k, variance_k) for each component."""
    weight, mean, variance = mixture
    normal = np.exp(-0.5 * (colour - mean) ** 2 / variance) / np.sqrt(2.0 * np.pi * variance)
    return np.asarray(weight * normal.prod(axis=1))


def ref_match(colour: Array, mixture: Mixture, bound: float) -> int:
    """The likeliest component within `bound` in the root mean square of normalised differences; K if there is none."""
    weight, mean, variance = mixture
    near = np.sqrt(((colour - mean) ** 2 / variance).mean(axis=1)) <= bound
    likely = np.where(near, ref_components(colour, mixture), -1.0)
    return int(likely.argmax()) if near.any() else len(weight)
