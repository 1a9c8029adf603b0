"""A slow, obvious twin of `roam_core.kernels.hypotheses`."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def ref_best_hypothesis(
    source: NDArray[np.complex128],
    target: NDArray[np.complex128],
    alpha: NDArray[np.complex128],
    beta: NDArray[np.complex128],
    threshold: float,
) -> int:
    """Every hypothesis on every point."""
    scores = [
        sum(min(abs(a * z + b - w), threshold) for z, w in zip(source, target, strict=True))
        for a, b in zip(alpha, beta, strict=True)
    ]
    return int(np.argmin(scores))
