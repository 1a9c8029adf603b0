"""Texture: what the picture is like around each cell, in a few numbers."""

from __future__ import annotations

import cv2
import numpy as np

from roam_core.arrays import Float32, UInt8, UInt16
from roam_core.params import TextureParams


def texture(lab: UInt8, params: TextureParams) -> Float32:
    """The texture `(14, rows, columns)` around each cell of a picture `(rows, columns, 3)` in 8-bit CIE Lab.

    The colour itself; its means in a small and in a large window; how much it deviates in a window between the two, and
    how steep the lightness is there, along x and y. All sums are of whole numbers, so they are exact.
    """
    near, around, far = params.windows
    mean = _mean(lab, around)
    squares = _mean(np.square(lab, dtype=np.uint16), around)
    deviation = np.sqrt(np.maximum(squares - mean * mean, np.float32(0.0)))
    lightness = np.ascontiguousarray(lab[..., 0])
    slopes = (_mean(np.abs(cv2.Sobel(lightness, cv2.CV_16S, x, 1 - x)).astype(np.uint16), around) for x in (1, 0))
    colours: tuple[UInt8 | Float32, ...] = lab, _mean(lab, near), _mean(lab, far), deviation
    result = np.empty((14, *lab.shape[:2]), np.float32)
    for i, each in enumerate(colours):
        result[3 * i : 3 * i + 3] = each.transpose(2, 0, 1)
    result[12:] = tuple(slopes)
    return result


def _mean(values: UInt8 | UInt16, side: int) -> Float32:
    return np.asarray(cv2.boxFilter(values, cv2.CV_32F, (side, side)), dtype=np.float32)
