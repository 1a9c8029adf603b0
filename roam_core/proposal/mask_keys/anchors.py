"""Where on an outline the anchors of a spline lie best: near where they were matched, and where the curve fits."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from roam_core.arrays import Array, Bools, Int64
from roam_core.geometry import bezier, polyline
from roam_core.kernels.anchoring import anchored
from roam_core.params import ANCHORS

CHOICES = np.array([side * step for step in ANCHORS.choices for side in (-1, 1)])
"""Samples by which an anchor may move along the outline in one round."""


def spread(points: Array, samples: Array, matched: Int64, rounds: int, scale: float = 1.0) -> Int64:
    """The sample `(P,)` of each anchor, moved from the `matched (P,)` one as far as the curve has to follow the ring.

    `points (P, 3, 2)` is the spline that was matched to the ring `samples (M, 2)`, which has equal steps. What only
    moved keeps its points in their places; where limbs appear that no points were drawn for, they come from elsewhere.
    """
    if len(samples) == 0 or len(points) < 3:
        return matched
    ring = _Ring(samples, _straight(points), scale)
    home = np.maximum.accumulate(matched[0] + (matched - matched[0]) % len(samples))
    choices = [ring.spread(home, price, rounds) for price in ANCHORS.prices]
    errors = np.array([ring.error(at) for at in choices])
    enough = max(ANCHORS.worse * float(errors.min()), ANCHORS.exact * scale**2 * polyline.length(samples))
    return np.asarray(choices[int(np.argmax(errors <= enough))] % len(samples))


def _straight(points: Array) -> Bools:
    """Which segments of a spline `(P, 3, 2)` have no handles."""
    control = bezier.segments(points)
    return np.asarray((control[:, 0] == control[:, 1]).all(axis=1) & (control[:, 2] == control[:, 3]).all(axis=1))


@dataclass(frozen=True, eq=False)
class _Ring:
    """An outline `samples (M, 2)` to be followed by segments of which some are `straight (P,)`."""

    samples: Array
    straight: Bools
    scale: float

    def spread(self, home: Int64, price: float, rounds: int) -> Int64:
        """Anchors near `home (P,)`, samples that run on past the last. Each round is exact over all choices of the
        anchors' moves (`kernels.anchoring`) with another anchor held still.
        """
        total, count, at = len(self.samples), len(home), home
        step = polyline.length(self.samples) / total
        for turn in range(rounds):
            first = turn * count // rounds
            here, there = (np.roll(places, -first) for places in (at, home))
            here[count - first :] += total
            there[count - first :] += total
            choices = here[:, None] + np.append(0, CHOICES)
            away = (choices - there[:, None]) * (step / (ANCHORS.free * self.scale))
            prices = price * self.scale**3 * np.minimum(away**2, ANCHORS.most)
            places, least = self._anchored(choices, prices, np.roll(self.straight, -first))
            if np.isfinite(least):
                at = np.roll(places, first)
                at[:first] -= total
        return at

    def error(self, at: Int64) -> float:
        """The integral of the squared distance of the outline to its segments, cubic pixels."""
        return self._anchored(at[:, None], np.zeros((len(at), 1)), self.straight)[1]

    def _anchored(self, choices: Int64, prices: Array, straight: Bools) -> tuple[Int64, float]:
        return anchored(self.samples, choices, prices, straight, ANCHORS.looked_at, ANCHORS.hold)
