"""Slow twin of `roam_core.kernels.anchoring`: every choice of places tried, every piece fitted by `lstsq`."""

from __future__ import annotations

from itertools import product

import numpy as np

from roam_core.arrays import Array, Bools, Int64
from roam_core.geometry.bezier import bernstein


def ref_error(samples: Array, first: int, last: int, straight: bool, looked_at: int, hold: float) -> float:
    """Integral of the squared distance of the piece from sample `first` to `last` to the cubic that follows it best."""
    steps = last - first
    count = min(steps - 1, looked_at)
    if count <= 0:
        return 0.0
    offset = (np.arange(1, count + 1) * steps) // (count + 1)
    piece = samples[(first + offset) % len(samples)]
    start, stop = samples[first % len(samples)], samples[last % len(samples)]
    t = offset / steps
    rest = piece - start - t[:, None] * (stop - start)
    if not straight:
        weights = bernstein(t)[:, 1:3]
        held = np.vstack([weights, np.sqrt(hold) * np.eye(2)])
        wanted = np.vstack([rest, np.zeros((2, 2))])
        handles, *_ = np.linalg.lstsq(held, wanted, rcond=None)
        rest = wanted - held @ handles
    step = float(np.hypot(*(samples[1] - samples[0])))
    return float((rest**2).sum()) / count * steps * step


def ref_anchored(
    samples: Array, places: Int64, price: Array, straight: Bools, looked_at: int, hold: float
) -> tuple[list[int], float]:
    """The best of all choices, the first anchor on the first of its places."""
    best, least = [], np.inf
    for choice in product([0], *[range(places.shape[1])] * (len(places) - 1)):
        at = [int(places[n, c]) for n, c in enumerate(choice)]
        ends = [*at[1:], at[0] + len(samples)]
        if any(b <= a for a, b in zip(at, ends, strict=True)):
            continue
        value = sum(price[n, c] for n, c in enumerate(choice))
        pieces = enumerate(zip(at, ends, strict=True))
        value += sum(ref_error(samples, a, b, straight[n], looked_at, hold) for n, (a, b) in pieces)
        if value < least:
            best, least = at, value
    return best, float(least)
