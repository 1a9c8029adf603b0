"""Nearest colours in a window: how much better a pixel is explained by labelled inside than by outside pixels."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from roam_core.threads import in_halves

Float32 = NDArray[np.float32]
UInt8 = NDArray[np.uint8]

OUTSIDE, INSIDE, UNKNOWN = 0, 1, 2
FAR = np.float32(1e9)


def local_match(
    colours: Float32,
    memory: Float32,
    labels: UInt8,
    wanted: NDArray[np.bool_],
    shift: Float32,
    radius: int,
    sigma: float,
    spread: float,
    clip: float,
) -> Float32:
    """ln p(inside) / p(outside) of each wanted pixel, from its nearest colours among labelled pixels of another frame.

    With `d` the squared colour distance plus `spread` times the squared displacement, least over the pixels of a label
    in the window, the ratio is `(d_outside - d_inside) / (2 sigma^2)`, clipped: two kernel densities, each reduced to
    its nearest sample.

    Parameters
    ----------
    colours, memory : (h, w, 3) Lab of the new and of the labelled frame, on one grid.
    labels : (h, w) `OUTSIDE`, `INSIDE` or `UNKNOWN` for each pixel of `memory`.
    wanted : (h, w) pixels to rate; the others get 0.
    shift : (h, w, 2) where a pixel is expected in `memory`, as an offset (x, y).
    radius : half side of the window. sigma : Lab units. clip : nats. spread : Lab units squared a pixel squared.
    """
    ratio = np.zeros(labels.shape, dtype=np.float32)

    def match_rows(first: int, stop: int) -> None:
        _local_match(
            colours, memory, labels, wanted, shift, radius, np.float32(sigma * sigma), np.float32(spread),
            np.float32(clip), first, stop, ratio,
        )  # fmt: skip

    in_halves(match_rows, wanted)
    return ratio


@njit(nogil=True, cache=True)
def _local_match(colours, memory, labels, wanted, shift, radius, variance, spread, clip, first, stop, ratio):  # type: ignore[no-untyped-def]
    rows, columns = labels.shape
    enough = 4.0 * variance * clip  # beyond this a distance changes nothing any more
    for y in range(first, stop):
        for x in range(columns):
            if not wanted[y, x]:
                continue
            cx, cy = int(np.round(x + shift[y, x, 0])), int(np.round(y + shift[y, x, 1]))
            c0, c1, c2 = colours[y, x, 0], colours[y, x, 1], colours[y, x, 2]
            inside, outside = FAR, FAR
            for v in range(max(cy - radius, 0), min(cy + radius + 1, rows)):
                for u in range(max(cx - radius, 0), min(cx + radius + 1, columns)):
                    label = labels[v, u]
                    if label == UNKNOWN:
                        continue
                    d0, d1, d2 = c0 - memory[v, u, 0], c1 - memory[v, u, 1], c2 - memory[v, u, 2]
                    away = np.float32((v - cy) * (v - cy) + (u - cx) * (u - cx))
                    distance = d0 * d0 + d1 * d1 + d2 * d2 + spread * away
                    if label == INSIDE:
                        inside = min(inside, distance)
                    else:
                        outside = min(outside, distance)
            if inside < FAR or outside < FAR:
                value = (min(outside, enough) - min(inside, enough)) / (np.float32(2.0) * variance)
                ratio[y, x] = min(max(value, -clip), clip)
