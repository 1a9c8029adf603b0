"""Online adaptation of mixtures, after Stauffer and Grimson: "Adaptive background mixture models" (CVPR 1999)."""

from __future__ import annotations

import numpy as np

from roam_core.appearance.gmm import Mixtures, Samples
from roam_core.arrays import Array
from roam_core.kernels.gmm_density import matches
from roam_core.params import AppearanceParams


def adapted(mixtures: Mixtures, samples: Samples, rate: float, params: AppearanceParams, spread: int = 0) -> Mixtures:
    """The mixtures after a frame in which their edges showed `samples`.

    Each colour counts for the component that it matches. With m_k the share of an edge's colours that match component
    k, w_k <- (1 - rate) w_k + rate m_k, and mean and variance move by rho_k = rate m_k / w_k towards those of the
    matching colours: the paper's rule for one pixel a frame, taken over all of an edge's pixels at once. Where enough
    colours match nothing, they replace the weakest component with the weight `rate` times their share. An edge without
    colours stays as it is.
    """
    floor, parts = params.variance_floor, (mixtures.weight, mixtures.mean, mixtures.variance)
    sums = matches(samples.colours, samples.starts, spread, parts, params.matched)
    seen = sums[:, :, 6].sum(axis=1)
    known = mixtures.weight.sum(axis=1) > 0.0
    shares = sums[:, :, 6] / np.maximum(seen, 1.0)[:, None]
    means, variances = _moments(sums, floor)
    weight = (1.0 - rate) * mixtures.weight + rate * shares[:, :-1]
    rho = np.clip(rate * shares[:, :-1] / np.maximum(weight, 1e-12), 0.0, 1.0)[:, :, None]
    mean = (1.0 - rho) * mixtures.mean + rho * means[:, :-1]
    variance = (1.0 - rho) * mixtures.variance + rho * (variances[:, :-1] + (means[:, :-1] - mean) ** 2)
    edges = np.flatnonzero(known & (rate * shares[:, -1] > rate * params.replaced))
    weakest = weight[edges].argmin(axis=1)
    weight[edges, weakest] = rate * shares[edges, -1]
    mean[edges, weakest] = means[edges, -1]
    variance[edges, weakest] = np.maximum(variances[edges, -1], params.new_variance)
    weight /= np.maximum(weight.sum(axis=1), 1e-12)[:, None]
    keep = ~known | (seen == 0.0)
    return Mixtures(
        np.where(keep[:, None], mixtures.weight, weight),
        np.where(keep[:, None, None], mixtures.mean, mean),
        np.where(keep[:, None, None], mixtures.variance, np.maximum(variance, floor)),
    )


def _moments(sums: Array, floor: float) -> tuple[Array, Array]:
    """Mean and variance `(N, K + 1, 3)` of matched colours from their sums `(N, K + 1, 7)`."""
    number = np.maximum(sums[:, :, 6:], 1.0)
    means = sums[:, :, :3] / number
    return means, np.maximum(sums[:, :, 3:6] / number - means**2, floor)
