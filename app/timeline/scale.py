"""TimeScale: where frames lie on the screen. No Qt: plain numbers, pulled by every row of the timeline."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from roam_core.arrays import Array, Int64

LABEL_WIDTH = 148
"""Pixels left of the frames: the names of the rows."""
RIGHT_MARGIN = 14
WIDEST_FRAME = 80.0
"""Pixels a frame at the closest zoom."""


@dataclass(frozen=True)
class TimeScale:
    """A piece of time on a strip of pixels.

    `first` is the frame (fractions allowed) at the left edge of the strip, `pixels` the width of one frame, `left` and
    `right` the strip's edges in pixels, `clip` the frames that exist, as a half-open pair.
    """

    first: float = 1.0
    pixels: float = 10.0
    left: float = LABEL_WIDTH
    right: float = 1000.0
    clip: tuple[int, int] = (1, 2)

    @property
    def width(self) -> float:
        return max(self.right - self.left, 1.0)

    @property
    def last(self) -> float:
        """The time at the right edge of the strip."""
        return self.first + self.width / self.pixels

    def x(self, frame: float) -> float:
        """The middle of a frame, in pixels."""
        return self.left + (frame - self.first + 0.5) * self.pixels

    def has_left_of(self, frame: float) -> bool:
        """Whether the middle of a frame lies left of the strip, over the names."""
        return self.x(frame) < self.left

    def nearest(self, frames: Sequence[int] | Int64, x: float) -> tuple[float, int | None]:
        """How many pixels the nearest of the `frames` lies from the pixel `x`, and which it is; infinity and None
        where there is none. Those left of the strip are passed over: they have no marks.
        """
        there = np.asarray(frames, dtype=np.int64)
        there = there[there >= self.first - 0.5]
        if not len(there):
            return math.inf, None
        distances = np.abs(self.left + (there - self.first + 0.5) * self.pixels - x)
        return float(distances.min()), int(there[distances.argmin()])

    def time(self, x: float) -> float:
        """The frame under a pixel, with the fraction of it that lies left of the pixel."""
        return self.first + (x - self.left) / self.pixels

    def frame(self, x: float) -> int:
        """The frame under a pixel, held inside the clip."""
        return self.held(math.floor(self.time(x)))

    def held(self, frame: int) -> int:
        return min(max(frame, self.clip[0]), self.clip[1] - 1)

    def fitted(self) -> TimeScale:
        """The whole clip from edge to edge."""
        first, stop = self.clip
        return replace(self, first=float(first), pixels=min(self.width / (stop - first), WIDEST_FRAME))

    def zoomed(self, factor: float, x: float) -> TimeScale:
        """Zoomed by `factor` with the time under the pixel `x` held in place."""
        least = self.fitted().pixels
        pixels = min(max(self.pixels * factor, least), max(WIDEST_FRAME, least))
        time = self.time(x)
        return replace(self, pixels=pixels, first=time - (x - self.left) / pixels).bounded()

    def panned(self, frames: float) -> TimeScale:
        return replace(self, first=self.first + frames).bounded()

    def resized(self, right: float) -> TimeScale:
        """On a strip that ends elsewhere; a clip that was fitted stays so."""
        was_fitted = math.isclose(self.pixels, self.fitted().pixels)
        resized = replace(self, right=right)
        return resized.fitted() if was_fitted else resized.bounded()

    def showing(self, frame: int) -> TimeScale:
        """Moved by as little as makes `frame` visible."""
        if frame < self.first:
            return replace(self, first=float(frame)).bounded()
        if frame + 1 > self.last:
            return replace(self, first=frame + 1 - self.width / self.pixels).bounded()
        return self

    def bounded(self) -> TimeScale:
        """Moved so that no empty time shows where the clip could fill the strip."""
        first, stop = self.clip
        latest = max(stop - self.width / self.pixels, first)
        return replace(self, first=min(max(self.first, first), latest))

    def steps(self, least: float = 56.0) -> tuple[int, int]:
        """Frames between labels and between ticks: round numbers, labels at least so many pixels apart."""
        label = next(step for step in _round_numbers() if step * self.pixels >= least)
        tick = next(step for step in _round_numbers() if step * self.pixels >= 6.0 and label % step == 0)
        return label, tick


def _round_numbers() -> Iterator[int]:
    """1, 2, 5, 10, 20, 50, ..."""
    for power in range(12):
        for digit in (1, 2, 5):
            yield digit * 10**power


def whole_frames(first: float, last: float, most: int) -> Array:
    """The whole frames around `first` to `last`, evenly fewer where they are more than `most`, with both ends."""
    low, high = math.floor(first), math.ceil(last)
    return np.unique(np.round(np.linspace(low, high, min(high - low + 1, max(most, 2)))))
