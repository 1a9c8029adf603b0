"""Which of many similarities carries the most points to where they went: the scores of RANSAC hypotheses."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

Complex = NDArray[np.complex128]


def best_hypothesis(source: Complex, target: Complex, alpha: Complex, beta: Complex, threshold: float) -> int:
    """The index of the similarity `z -> alpha z + beta` with the least sum of errors, each no more than `threshold`.

    `source`, `target (N,)` are points as complex numbers, `alpha`, `beta (T,)` the hypotheses; the first of equals.
    """
    return int(_best(source, target, alpha, beta, float(threshold)))


@njit(nogil=True, cache=True)
def _best(source, target, alpha, beta, threshold):  # type: ignore[no-untyped-def]
    least, chosen = np.inf, 0
    for t in range(len(alpha)):
        a, b, c, d = alpha[t].real, alpha[t].imag, beta[t].real, beta[t].imag
        total = 0.0
        for n in range(len(source)):
            x, y = source[n].real, source[n].imag
            u = a * x - b * y + c - target[n].real
            v = b * x + a * y + d - target[n].imag
            total += min(np.sqrt(u * u + v * v), threshold)
            if total >= least:
                break
        if total < least:
            least, chosen = total, t
    return chosen
