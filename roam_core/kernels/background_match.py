"""How like a picture is to another one about each cell, at the best of the places within reach.

All sums over windows are of whole numbers, so they are exact in whatever order they are taken.
"""

from __future__ import annotations

from typing import NamedTuple

import cv2
import numpy as np
from numba import njit
from numpy.typing import NDArray

from roam_core.arrays import Bools, Float32, Int32, UInt8
from roam_core.threads import in_halves


class _Picture(NamedTuple):
    """The channels `(3, h, w)` of a picture; their means about each cell, and their variance `(h, w)`, all summed."""

    planes: Int32
    means: Float32
    variance: Float32

    @classmethod
    def of(cls, colours: UInt8, window: int) -> _Picture:
        """Of `colours (h, w, 3)`, in windows of so many cells a side."""
        planes = np.ascontiguousarray(colours.transpose(2, 0, 1), dtype=np.float32)
        means = np.stack([cv2.blur(plane, (window, window)) for plane in planes])
        squares = cv2.blur(_dot(planes, planes), (window, window))
        return cls(planes.astype(np.int32), means, squares - _dot(means, means))


def best_matches(
    now: UInt8, then: UInt8, known: Bools, window: int, reach: int, texture: float, shade: float
) -> tuple[Float32, Float32]:
    """Of each cell the best correlation of the windows around both, and the least squared difference, `(h, w)` each.

    Each the best of all places of `then` that are `known (h, w)`, up to `reach` cells off. Whole windows correlate with
    such as are known as a whole; where there are none that is 0. The difference is infinite where nothing is known.

    Parameters
    ----------
    now, then : (h, w, 3) pictures. window : side of the windows, odd.
    texture : standard deviation under which both together tell less. shade : weight of a first channel that has become
        less.
    """
    then_wide, known_wide = _padded(then, reach), _padded(known.astype(np.uint8), reach)
    whole = cv2.erode(known_wide, np.ones((window, window), np.uint8), borderType=cv2.BORDER_CONSTANT, borderValue=0)
    likeness, difference = np.zeros(known.shape, np.float32), np.full(known.shape, np.inf, np.float32)
    pictures = _Picture.of(now, window), _Picture.of(then_wide, window)
    bounds = np.float32(texture**4), np.float32(shade)

    def match_rows(first: int, stop: int) -> None:
        _match_rows(*pictures, known_wide > 0, whole > 0, window, reach, *bounds, first, stop, likeness, difference)

    in_halves(match_rows, np.ones(known.shape, np.bool_))
    return likeness, difference


def _padded(values: NDArray[np.uint8], reach: int) -> NDArray[np.uint8]:
    """With `reach` cells of zeros all around."""
    return np.asarray(cv2.copyMakeBorder(values, reach, reach, reach, reach, cv2.BORDER_CONSTANT, value=0))


def _dot(a: Float32, b: Float32) -> Float32:
    """The products of `(3, h, w)` each, summed over the channels."""
    return np.asarray(a[0] * b[0] + a[1] * b[1] + a[2] * b[2])


@njit(nogil=True, cache=True)
def _match_rows(now, then, known, whole, window, reach, least, shade, first, stop, likeness, difference):  # type: ignore[no-untyped-def]
    """The rows from `first` to `stop`; of `then`, `known` and `whole` there are `reach` more on each side."""
    height, width = likeness.shape
    half, share = window // 2, 1.0 / (window * window)
    inner = max(width - 2 * half, 0)  # cells of a row about which there is a whole window
    above, below = max(first - half, 0), min(stop + half, height)
    products, total, sums = np.empty(width, np.int32), np.empty(inner, np.int32), np.empty((below, inner), np.int32)
    for down in range(2 * reach + 1):
        for right in range(2 * reach + 1):
            end = right + width
            for y in range(above, below):
                products[:] = 0
                for c in range(3):
                    _multiply(now.planes[c, y], then.planes[c, y + down, right:end], products)
                sums[y] = 0
                for k in range(window):
                    _add(sums[y], products[k : k + inner])
            for y in range(max(first, half), min(stop, height - half)):
                total[:] = 0
                for k in range(y - half, y + half + 1):
                    _add(total, sums[k])
                v, here, there = y + down, slice(half, half + inner), slice(right + half, right + half + inner)
                _correlate(
                    now.means[0, y, here], now.means[1, y, here], now.means[2, y, here], now.variance[y, here],
                    then.means[0, v, there], then.means[1, v, there], then.means[2, v, there], then.variance[v, there],
                    total, share, least, whole[v, there], likeness[y, here],
                )  # fmt: skip
            for y in range(first, stop):
                v = y + down
                _compare(
                    now.planes[0, y], now.planes[1, y], now.planes[2, y],
                    then.planes[0, v, right:end], then.planes[1, v, right:end], then.planes[2, v, right:end],
                    shade, known[v, right:end], difference[y],
                )  # fmt: skip


@njit(nogil=True, cache=True)
def _multiply(now, then, products):  # type: ignore[no-untyped-def]
    for x in range(len(products)):
        products[x] += now[x] * then[x]


@njit(nogil=True, cache=True)
def _add(total, row):  # type: ignore[no-untyped-def]
    for x in range(len(total)):
        total[x] += row[x]


@njit(nogil=True, cache=True, error_model="numpy")
def _correlate(m0, m1, m2, variance, t0, t1, t2, variance_then, total, share, least, whole, likeness):  # type: ignore[no-untyped-def]
    """The best correlation of a row, with that at one more place; `total` of the products of both windows.

    With NumPy's rule for divisions by zero, of which there are none, many cells are taken at a time.
    """
    for x in range(len(likeness)):
        product = m0[x] * t0[x] + m1[x] * t1[x] + m2[x] * t2[x]
        spread = np.sqrt(max(variance[x] * variance_then[x], least))
        like = (np.float32(total[x] * share) - product) / spread
        likeness[x] = max(likeness[x], like) if whole[x] else likeness[x]


@njit(nogil=True, cache=True)
def _compare(n0, n1, n2, t0, t1, t2, shade, known, difference):  # type: ignore[no-untyped-def]
    """The least squared difference of a row, with that at one more place."""
    for x in range(len(difference)):
        lighter = np.float32(n0[x] - t0[x])
        lighter = max(lighter, shade * lighter)
        a, b = np.float32(n1[x] - t1[x]), np.float32(n2[x] - t2[x])
        apart = lighter * lighter + a * a + b * b
        difference[x] = min(difference[x], apart) if known[x] else difference[x]
