"""TrackPoints: the points that a point track follows, where the artist put them on a frame, and their areas."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import projective
from roam_core.params import scale_for
from roam_core.params.tracks import POINT_TRACK

Spot = tuple[float, float]
MOST = 4
"""Four points tell a motion in perspective."""
LEAST_PATTERN, MOST_PATTERN = 5.0, 200.0
"""Of a smaller pattern too few pixels are left inside its rim to know a point again by."""


@dataclass(frozen=True)
class TrackPoints:
    """Up to four `places` on `frame`, image pixels; `pattern` and `search` are half the sides of their areas."""

    frame: int = 1
    places: tuple[Spot, ...] = ()
    pattern: float = POINT_TRACK.pattern
    search: float = POINT_TRACK.search

    @classmethod
    def on(cls, frame: int, size: tuple[int, int]) -> TrackPoints:
        """None yet, with areas for a picture of `size` (width, height)."""
        scale = scale_for(size)
        return cls(frame, (), POINT_TRACK.pattern * scale, POINT_TRACK.search * scale)

    def with_place(self, place: Spot) -> TrackPoints:
        """One more."""
        return replace(self, places=(*self.places, place))

    def moved(self, index: int, place: Spot) -> TrackPoints:
        """One of them elsewhere."""
        return replace(self, places=(*self.places[:index], place, *self.places[index + 1 :]))

    def without(self, index: int) -> TrackPoints:
        """One less."""
        return replace(self, places=(*self.places[:index], *self.places[index + 1 :]))

    def grown(self, factor: float) -> TrackPoints:
        """Both areas larger by a factor, within bounds."""
        pattern = float(np.clip(self.pattern * factor, LEAST_PATTERN, MOST_PATTERN))
        return replace(self, pattern=pattern, search=self.search * pattern / self.pattern)

    def carried(self, motion: Array, frame: int) -> TrackPoints:
        """Where a motion `(3, 3)` brings them on another frame."""
        places = projective.apply(motion, np.array(self.places).reshape(-1, 2))
        return replace(self, frame=frame, places=tuple((float(x), float(y)) for x, y in places))
