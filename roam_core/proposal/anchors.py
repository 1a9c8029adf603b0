"""Where on an outline the anchors of a spline lie best: near where they were matched, and where the curve fits."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from roam_core.geometry import bezier, polyline
from roam_core.kernels.anchoring import anchored

Array = NDArray[np.float64]
IntArray = NDArray[np.int64]

CHOICES = np.array([s * n for n in (1, 2, 3, 4, 6, 8, 11, 15, 20, 27, 36) for s in (-1, 1)])
"""Samples by which an anchor may move along the outline in one round."""
FREE = 6.0
"""Pixels of a 480-line image that an anchor may move for the price of ..."""
PRICE = 25.0
"""... this much error, square pixels times pixels; it grows with the square, up to ..."""
MOST = 20.0
"""... this many times."""


def spread(points: Array, samples: Array, matched: IntArray, rounds: int, scale: float = 1.0) -> IntArray:
    """The sample `(P,)` of each anchor, moved from the `matched (P,)` one as far as the curve follows the ring better.

    `points (P, 3, 2)` is the spline that was matched to the ring `samples (M, 2)`, which has equal steps. Each round is
    exact over all choices of the anchors' moves (`kernels.anchoring`) with another anchor held still.
    """
    total, count = len(samples), len(points)
    if count < 3:
        return matched
    home_at = np.maximum.accumulate(matched[0] + (matched - matched[0]) % total)
    step = polyline.length(samples) / total
    control = bezier.segments(points)
    straight = (control[:, 0] == control[:, 1]).all(axis=1) & (control[:, 2] == control[:, 3]).all(axis=1)
    at = home_at
    for turn in range(rounds):
        first = turn * count // rounds
        here, home = (np.roll(places, -first) for places in (at, home_at))
        here[count - first :] += total
        home[count - first :] += total
        choices = here[:, None] + np.append(0, CHOICES)
        away = (choices - home[:, None]) * (step / (FREE * scale))
        price = PRICE * scale**3 * np.minimum(away**2, MOST)
        places, least = anchored(samples, choices, price, np.roll(straight, -first))
        if np.isfinite(least):
            at = np.roll(places, first)
            at[:first] -= total
    return np.asarray(at % total)
