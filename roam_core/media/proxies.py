"""Proxies: pictures of half or a quarter of the size, for looking alone; no engine sees them."""

from __future__ import annotations

import cv2
import numpy as np

from roam_core.arrays import Image

STEPS = (1, 2, 4)
"""Pixels of the plate along a side of a proxy's pixel."""


def reduced(image: Image, step: int) -> Image:
    """The picture `(h, w)` or `(h, w, c)` with `step` times fewer pixels along each side, each the mean of what it
    covers; the picture itself where `step` is 1.

    Parameters
    ----------
    image : uint8, uint16 or float32. step : one of `STEPS`.
    """
    if step == 1:
        return image
    height, width = image.shape[:2]
    size = max(width // step, 1), max(height // step, 1)
    return np.asarray(cv2.resize(image, size, interpolation=cv2.INTER_AREA))
