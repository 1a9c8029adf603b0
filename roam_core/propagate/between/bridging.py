"""What neither pass of a span sees: carried from where it was last seen to where it is seen again.

A limb that something hides between two keys is lost by both passes, though both keys show it. It is taken to move,
turn and grow evenly in between, by the similarity that takes the one outline to the other. Points of two keys need not
lie at the same places of an outline: they may have slid along it, by up to a quarter of its length.
"""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import bezier, polyline, similarity


def between(first: Array, last: Array, share: float, places: int) -> Array:
    """A spline `(P, 3, 2)` a `share` of the way, in [0, 1], from `first` to `last`, `(P, 3, 2)` each.

    The shape is that of the nearer one. They are laid on each other by so many `places`, evenly along each.
    """
    motion = _motion(first, last, places)
    middle = bezier.flatten(first).mean(axis=0)
    arrived = similarity.apply(motion, middle[None])[0]
    here = (1.0 - share) * middle + share * arrived
    turn, growth = np.arctan2(motion[1, 0], motion[0, 0]), np.log(np.hypot(motion[0, 0], motion[1, 0]))
    points, about, rest = (first, middle, share) if share <= 0.5 else (last, arrived, share - 1.0)
    c, s = np.exp(rest * growth) * np.array([np.cos(rest * turn), np.sin(rest * turn)])
    return np.asarray((points - about) @ np.array([[c, s], [-s, c]]) + here)


def _motion(first: Array, last: Array, places: int) -> Array:
    """The similarity `(2, 3)` that takes one outline to the other, whichever of its places their points lie at."""
    line, target = (polyline.resample(bezier.flatten(points), places) for points in (first, last))
    slid = [np.roll(target, by, axis=0) for by in range(-places // 4, places // 4 + 1)]
    motions = [similarity.fit(line, each) for each in slid]
    misses = [
        float(((similarity.apply(motion, line) - each) ** 2).sum()) for motion, each in zip(motions, slid, strict=True)
    ]
    return np.asarray(motions[int(np.argmin(misses))])
