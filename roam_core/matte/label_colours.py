"""The colours in which data sets paint their labels: a mask of them tells one object from the next."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

VOID = np.array([224, 224, 192], dtype=np.uint8)
"""The colour of label 255: what belongs to no object for certain, such as a line around each."""


def labels_of_colours(colours: NDArray[Any]) -> NDArray[np.uint32] | None:
    """The labels (h, w) of a mask `(h, w, 3)` in the colours of PASCAL VOC; DAVIS and others paint in them too.

    In these the bits of a label's number are dealt to red, green and blue in turn, the highest of each channel first:
    1 is (128, 0, 0), 8 is (64, 0, 0). None where there are colours of no label below 64, and where all is grey. The
    numbers are ids of 32 bits, in the order of the labels; what is void is none of them.
    """
    if colours.dtype != np.uint8 or colours.ndim != 3 or colours.shape[2] != 3 or (colours & 0b0001_1111).any():
        return None
    known = np.where((colours == VOID).all(axis=2, keepdims=True), np.uint8(0), colours)
    if (known & 0b0010_0000).any() or not (known != known[..., :1]).any():  # labels from 64 on; all grey
        return None
    bits = known.astype(np.uint32)
    high, low = bits >> 7, bits >> 6 & 1
    weights = np.array([1, 2, 4], dtype=np.uint32)
    labels: NDArray[np.uint32] = (high @ weights + low @ (weights << 3)).astype(np.uint32)
    return labels << np.uint32(24)
