"""Few keys for one part: every frame fitted, then key after key taken out while the outlines stay within reach."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from roam_core.arrays import Array
from roam_core.interchange.masks.fitting import Fit, Outlines, fitted

NEIGHBOURS = 2
"""Keys to both sides that move when one is taken out."""
SLACK = 0.6
"""Share of the tolerance within which each frame is fitted by itself: the rest is room for what lies between keys."""
FARTHEST = 4.0
"""Tolerances by which a point may lie off the straight way between its neighbours for its key to be tried."""


class Keys:
    """The keys of one part, and how far each frame strays.

    Attributes
    ----------
    times : numbers of the frames. at : the outlines that have keys, rising.
    points : their points. errors : (F,) pixels.
    """

    def __init__(self, outlines: Outlines, tolerance: float, checked: Callable[[], None]) -> None:
        self.outlines, self.tolerance, self.checked = outlines, tolerance, checked
        self.times = outlines.times
        self.at: list[int] = []
        self.points: dict[int, Array] = {}
        self.errors = np.full(len(self.times), np.inf)

    def fit_every(self, start: Array) -> None:
        """A key on every frame, from the splines `start (F, P, 3, 2)`."""
        for k in range(len(self.times)):
            self.checked()
            for share in (SLACK, 1.0):
                fit = fitted(self.outlines, [k], [k], start[k : k + 1], (None, None), share * self.tolerance, False)
                assert fit is not None
                if share == SLACK or fit.worst < self.errors[k]:
                    self._take([k], [k], fit)
                if fit.worst <= self.tolerance:
                    break
        self.at = list(range(len(self.times)))

    @property
    def missed(self) -> int:
        """Frames that are not held."""
        return int(np.count_nonzero(self.errors > self.tolerance))

    def _take(self, keys: list[int], frames: list[int], fit: Fit) -> None:
        for key, points in zip(keys, fit.points, strict=True):
            self.points[key] = points
        self.errors[frames] = fit.errors

    def stride(self, told: Callable[[float], None]) -> None:
        """From key to key the longest steps that keep all frames near enough, both ends of each free to move."""
        last = len(self.times) - 1
        place = 0
        while self.at[place] < last:
            here = self.at[place]
            told(here / last)
            good, bad = 1, last - here + 1
            while bad - good > 1:
                self.checked()
                step = min(2 * good, (good + bad) // 2)
                following = self.at.index(here + step)
                if self._window([*self.at[: place + 1], *self.at[following:]], place, place + 2, hopeless=True):
                    good = step
                else:
                    bad = step
            place += 1

    def even_out(self) -> None:
        """The keys that are left laid as near to all outlines on average as the tolerance lets them."""
        for low in range(0, len(self.at), 2):
            self.checked()
            self._window(self.at, low, min(low + 3, len(self.at)), hopeless=False, evened=True)

    def reduce(self, told: Callable[[float], None]) -> None:
        """Take out keys, the one that bends the motion least first, until none can go."""
        prices = {key: self._bend(key) for key in self.at[1:-1]}
        most = max(len(prices), 1)
        while prices:
            self.checked()
            key = min(prices, key=lambda each: prices[each])
            if prices[key] > FARTHEST * self.tolerance:
                break
            del prices[key]
            if not self._without(key):
                continue
            told(1.0 - len(prices) / most)
            place = int(np.searchsorted(self.at, key))
            for near in self.at[max(place - NEIGHBOURS - 1, 1) : place + NEIGHBOURS + 1]:
                if near != self.at[-1]:
                    prices[near] = self._bend(near)

    def merge(self) -> None:
        """Put one key in the place of two neighbours wherever that does."""
        place = 1
        while place + 2 < len(self.at):
            self.checked()
            middle = sum(self.at[place : place + 2]) // 2
            kept = self.points.get(middle)
            self.points[middle] = self._between(middle)
            keys = [*self.at[:place], middle, *self.at[place + 2 :]]
            if not self._window(
                keys, max(place - NEIGHBOURS, 0), min(place + NEIGHBOURS + 1, len(keys)), hopeless=True
            ):
                del self.points[middle]
                if kept is not None:
                    self.points[middle] = kept
                place += 1

    def _between(self, frame: int) -> Array:
        """The points that the keys give on a frame without one."""
        right = int(np.searchsorted(self.at, frame))
        if self.at[right] == frame:
            return self.points[frame]
        before, after = self.at[right - 1], self.at[right]
        share = (self.times[frame] - self.times[before]) / (self.times[after] - self.times[before])
        return np.asarray((1.0 - share) * self.points[before] + share * self.points[after])

    def _bend(self, key: int) -> float:
        """How far across the outline the points of a key lie off the straight way between its neighbours."""
        place = self.at.index(key)
        before, after = self.at[place - 1], self.at[place + 1]
        share = (self.times[key] - self.times[before]) / (self.times[after] - self.times[before])
        straight = (1.0 - share) * self.points[before] + share * self.points[after]
        off = (self.points[key] - straight)[:, 0]
        tangent = self.outlines.spot_tangents[key]
        return float(np.abs(off[:, 0] * tangent[:, 1] - off[:, 1] * tangent[:, 0]).max())

    def _without(self, key: int) -> bool:
        place = self.at.index(key)
        rest = self.at[:place] + self.at[place + 1 :]
        low, high = max(place - NEIGHBOURS, 0), min(place + NEIGHBOURS, len(rest))
        return self._window(rest, low, high, hopeless=True)

    def _window(self, keys: list[int], low: int, high: int, *, hopeless: bool, evened: bool = False) -> bool:
        """Fit the keys `keys[low:high]` anew; with `hopeless` take them over only if all frames stay near enough."""
        free = keys[low:high]
        first = keys[low - 1] if low > 0 else None
        last = keys[high] if high < len(keys) else None
        frames = list(range(free[0] if first is None else first + 1, (free[-1] if last is None else last - 1) + 1))
        ends = (
            None if first is None else (first, self.points[first]),
            None if last is None else (last, self.points[last]),
        )
        start = np.stack([self.points[key] for key in free])
        fit = fitted(self.outlines, frames, free, start, ends, self.tolerance, hopeless, evened)
        if fit is None or (evened and fit.worst > max(self.tolerance, float(self.errors[frames].max()))):
            return False
        for gone in set(self.at) - set(keys):
            del self.points[gone]
        self._take(free, frames, fit)
        self.at = keys
        return True
