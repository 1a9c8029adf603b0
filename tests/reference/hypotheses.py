"""A slow, obvious twin of `roam_core.kernels.hypotheses`."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array, Bools, Indices


def ref_agreed_similarity(
    source: Array, target: Array, first: Indices, second: Indices, threshold: float
) -> tuple[Array, Bools]:
    """Every hypothesis on every point, then the normal equations of those that agree; as complex numbers."""
    z, w = source @ [1, 1j], target @ [1, 1j]
    hypotheses = [
        (alpha, w[i] - alpha * z[i])
        for i, j in zip(first, second, strict=True)
        for alpha in [(w[j] - w[i]) / (z[j] - z[i]) if abs(z[j] - z[i]) > 1e-9 else 1.0]
    ]
    sums = [np.minimum(np.abs(alpha * z + beta - w), threshold).sum() for alpha, beta in hypotheses]
    alpha, beta = hypotheses[int(np.argmin(np.round(sums, 9)))]
    inliers = np.abs(alpha * z + beta - w) <= threshold
    for turn in range(3):
        again = np.abs(alpha * z + beta - w) <= threshold
        if turn > 0 and again.sum() < 2:
            break
        inliers = again
        spots = np.column_stack([z[inliers], np.ones(int(inliers.sum()))])
        alpha, beta = np.linalg.lstsq(spots, w[inliers], rcond=None)[0] if np.ptp(z[inliers]) != 0 else (1, 0)
        if np.ptp(z[inliers]) == 0:
            beta = (w[inliers] - z[inliers]).mean()
    return np.array([[alpha.real, -alpha.imag, beta.real], [alpha.imag, alpha.real, beta.imag]]), inliers


def ref_best_motion(motions: Array, source: Array, target: Array, threshold: float, nearest: float) -> int:
    """Every hypothesis on every point."""
    carried = [(each @ np.column_stack([source, np.ones(len(source))]).T).T for each in motions]
    errors = [np.hypot(*(at[:, :2] / np.maximum(at[:, 2:], nearest) - target).T) for at in carried]
    return int(np.argmin([np.minimum(each, threshold).sum() for each in errors]))
