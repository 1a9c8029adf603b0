"""Nearest colours in a window: how much better a pixel is explained by labelled inside than by outside pixels."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from roam_core.arrays import Bools, Float32, Int32, UInt8
from roam_core.threads import in_halves

OUTSIDE, INSIDE, UNKNOWN = 0, 1, 2
PARTS = 100
"""Distances are counted in whole parts of a squared Lab unit: a processor compares many whole numbers at a time."""
FAR = np.int32(1 << 28)
"""More parts than any two colours are apart; thrice as many still fit."""
LANES = 8
"""Columns of a window are filled up to a multiple of this."""


def log_ratio(inside: Float32, outside: Float32, sigma: float, clip: float) -> Float32:
    """`(outside - inside) / (2 sigma^2)` of squared distances, clipped: the log-ratio of two kernel densities, each
    reduced to its nearest sample. `sigma` in Lab units, `clip` in nats.
    """
    variance = np.float32(sigma * sigma)
    enough = np.float32(4.0) * variance * np.float32(clip)  # beyond this a distance changes nothing any more
    nats = (np.minimum(outside, enough) - np.minimum(inside, enough)) / (np.float32(2.0) * variance)
    return np.asarray(np.clip(nats, np.float32(-clip), np.float32(clip)))


def nearest_colours(
    colours: NDArray[Any],
    memory: NDArray[Any],
    labels: UInt8,
    wanted: Bools,
    shift: Float32,
    radius: int,
    spread: float,
) -> tuple[Float32, Float32]:
    """How far each wanted pixel is from its nearest colour labelled inside, and from that outside, `(h, w)` each.

    The squared colour distance plus `spread` times the squared displacement, least over the pixels of a label in the
    window; more than any two colours are apart where there is none, and for pixels that are not wanted.

    Parameters
    ----------
    colours, memory : (h, w, 3) Lab of the new and of the labelled frame, on one grid: whole numbers, as in 8 bits.
    labels : (h, w) `OUTSIDE`, `INSIDE` or `UNKNOWN` for each pixel of `memory`.
    wanted : (h, w) pixels to rate.
    shift : (h, w, 2) where a pixel is expected in `memory`, as an offset (x, y).
    radius : half side of the window. spread : Lab units squared a pixel squared, to hundredths.
    """
    now, then, away = colours.astype(np.int32), _planes(memory, labels, radius), _away(radius, spread)
    nearest = np.full((2, *labels.shape), FAR, dtype=np.int32)

    def match_rows(first: int, stop: int) -> None:
        _nearest(now, then, away, wanted, shift, radius, first, stop, nearest)

    in_halves(match_rows, wanted)
    inside, outside = nearest.astype(np.float32) / np.float32(PARTS)
    return inside, outside


def _padded(radius: int) -> int:
    """The columns of a window, those to fill it up included."""
    return -(-(2 * radius + 1) // LANES) * LANES


def _planes(memory: NDArray[Any], labels: UInt8, radius: int) -> Int32:
    """`(5, h + m, w + n)`: Lab, then `FAR` where a pixel is not inside, and where it is not outside.

    All around there is room for windows that reach beyond the picture, or lie there.
    """
    rows, columns = labels.shape
    room = 2 * radius + 1
    planes = np.full((5, rows + 2 * room, columns + 2 * room + _padded(radius)), FAR, dtype=np.int32)
    planes[:3] = 0
    seen = planes[:, room : room + rows, room : room + columns]
    seen[:3] = memory.transpose(2, 0, 1)
    seen[3][labels == INSIDE] = 0
    seen[4][labels == OUTSIDE] = 0
    return planes


@lru_cache(maxsize=8)
def _away(radius: int, spread: float) -> Int32:
    """What each place of a window `(2 radius + 1, n)` adds to a distance; `FAR` in the columns that fill it up."""
    steps = np.arange(-radius, radius + 1)
    away = np.full((len(steps), _padded(radius)), FAR, dtype=np.int32)
    away[:, : len(steps)] = np.round(PARTS * spread * (steps[:, None] ** 2 + steps**2))
    away.setflags(write=False)
    return away


@njit(nogil=True, cache=True)
def _nearest(colours, planes, away, wanted, shift, radius, first, stop, nearest):  # type: ignore[no-untyped-def]
    rows, columns = wanted.shape
    height, width = np.uint64(away.shape[0]), np.uint64(away.shape[1])  # unsigned: no index counts from the end
    for y in range(first, stop):
        for x in range(columns):
            if not wanted[y, x]:
                continue
            cx, cy = int(np.round(x + shift[y, x, 0])), int(np.round(y + shift[y, x, 1]))
            left = np.uint64(min(max(cx, -radius - 1), columns + radius) + radius + 1)
            top = np.uint64(min(max(cy, -radius - 1), rows + radius) + radius + 1)
            c0, c1, c2 = colours[y, x, 0], colours[y, x, 1], colours[y, x, 2]
            inside, outside = FAR, FAR
            for v in range(height):
                for u in range(width):
                    d0 = np.int32(c0 - planes[0, top + v, left + u])
                    d1 = np.int32(c1 - planes[1, top + v, left + u])
                    d2 = np.int32(c2 - planes[2, top + v, left + u])
                    parts = np.int32(PARTS * np.int32(d0 * d0 + d1 * d1 + d2 * d2) + away[v, u])
                    inside = min(inside, np.int32(parts + planes[3, top + v, left + u]))
                    outside = min(outside, np.int32(parts + planes[4, top + v, left + u]))
            nearest[0, y, x], nearest[1, y, x] = inside, outside
