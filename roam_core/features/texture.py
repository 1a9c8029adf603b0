"""Texture: what the picture is like around each cell, in a few numbers."""

from __future__ import annotations

import cv2
import numpy as np

from roam_core.arrays import Float32, UInt8
from roam_core.params import TextureParams


def texture(lab: UInt8, params: TextureParams) -> Float32:
    """The texture `(rows, columns, 14)` around each cell of a picture `(rows, columns, 3)` in 8-bit CIE Lab.

    The colour itself; its means in a small and in a large window; how much it deviates in a window between the two, and
    how steep the lightness is there, along x and y. All sums are of whole numbers, so they are exact.
    """
    near, around, far = params.windows
    colours = lab.astype(np.float32)
    mean = _mean(colours, around)
    deviation = np.sqrt(np.maximum(_mean(colours * colours, around) - mean * mean, np.float32(0.0)))
    lightness = np.ascontiguousarray(lab[..., 0])
    slopes = (_mean(np.abs(cv2.Sobel(lightness, cv2.CV_32F, x, 1 - x)), around) for x in (1, 0))
    return np.dstack([colours, _mean(colours, near), _mean(colours, far), deviation, *slopes])


def _mean(values: Float32, side: int) -> Float32:
    return np.asarray(cv2.blur(values, (side, side)), dtype=np.float32)
