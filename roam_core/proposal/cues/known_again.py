"""What two pictures both show: patches that are known again by their correlation, which light does not change."""

from __future__ import annotations

import cv2
import numpy as np

from roam_core.arrays import Bools, Float32, UInt8


def known_again(
    lumas: tuple[UInt8, UInt8], means: tuple[Float32, Float32], known: Bools, window: int, alike: float, flat: float
) -> Bools:
    """The cells `(rows, columns)` around which two lumas show the same, and nothing but what is `known`.

    Parameters
    ----------
    lumas : (rows, columns) each. means : theirs around each cell (`local_means`).
    window : side, in cells, of the patches that are compared. alike : correlation from which two are the same.
    flat : deviation, in levels, under which a patch counts for less.
    """
    square = np.ones((window, window), np.uint8)
    whole = cv2.erode(known.astype(np.uint8), square, borderType=cv2.BORDER_CONSTANT, borderValue=0)
    values = [np.asarray(luma, np.float32) for luma in lumas]
    variance_then, covariance, variance = (
        local_means(values[i] * values[j], window) - means[i] * means[j] for i, j in ((0, 0), (0, 1), (1, 1))
    )
    least = np.sqrt(np.maximum(variance_then * variance, np.float32(flat**4)))
    return np.asarray((whole > 0) & (covariance > alike * least))


def local_means(picture: UInt8 | Float32, window: int) -> Float32:
    """The mean of each channel over a square around each cell, its side so many cells."""
    return np.asarray(cv2.blur(np.asarray(picture, np.float32), (window, window)))
