"""The point tracker: one to four points, each found again by the pattern around it, and the motion that they tell.

A pattern is a small plane (`roam_core.motion.plane_track`): it is looked for in its search area, then matched to the
key's own pattern at sub-pixel accuracy, however it turns, grows and shears. A point that is hidden goes with the others
and is looked for again where they say that it is.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np

from roam_core.arrays import Array, Bools, UInt8
from roam_core.cancel import CancelToken
from roam_core.errors import RoamError
from roam_core.features import PreparedFrame
from roam_core.features.grid import FROM_CENTRES, TO_CENTRES
from roam_core.geometry import projective
from roam_core.geometry.bezier import polygon_points
from roam_core.geometry.plane_motion import PlaneMotion, fit
from roam_core.media.partial import ReadFrame
from roam_core.media.source import MissingFrame
from roam_core.motion.bridging import Lost, bridged
from roam_core.motion.plane_track import Covers, Guess, Look, LostPlane, PlaneTracker, no_covers
from roam_core.params.tracks import POINT_TRACK, PointTrackParams
from roam_core.translatable import sentence

KINDS = {kind.pairs: kind for kind in PlaneMotion}
"""What so many points tell of a motion."""


class LostPoints(Lost):
    """None of the points could be found on a frame."""


@dataclass(frozen=True, eq=False)
class PointStep:
    """Where the points are on a frame.

    Attributes
    ----------
    places : (N, 2) pixels.
    confidence : (N,) how far each can be trusted, in [0, 1]; 0 where it was not found itself.
    """

    frame: int
    places: Array
    confidence: Array

    @property
    def found(self) -> Bools:
        """Which of the points were found themselves `(N,)`."""
        return np.asarray(self.confidence > 0.0)


def motion_of(before: Array, after: Array, pixel_aspect: float = 1.0) -> Array | None:
    """The motion `(3, 3)` that one to four points `(N, 2)` tell; None where they tell none, all on a line, say.

    What two of them tell is turned as it is shown, where pixels are shown `pixel_aspect` times as wide as high.
    """
    return fit(KINDS[min(len(before), max(KINDS))], before, after, pixel_aspect)


class PatternTracker(PlaneTracker):
    """Follows the pattern about one point: a square of `2 * pattern` pixels, in a search area of `2 * search`.

    Raises
    ------
    RoamError
        where the pattern lies outside of the picture, or is too small.
    """

    def __init__(
        self,
        picture: PreparedFrame,
        place: Array,
        pattern: float,
        search: float,
        params: PointTrackParams = POINT_TRACK,
        covers: Sequence[Array] = (),
    ) -> None:
        corners = np.asarray(place) + pattern * np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
        try:
            super().__init__(
                PlaneMotion(params.motion), picture, [polygon_points(corners)], (), covers, params=params.plane
            )
        except RoamError:
            if np.count_nonzero(self._mask) > (2.0 * pattern - 1.0) ** 2:  # nothing of it is cut off
                raise RoamError(
                    sentence("The area around a point is too small to know it again by: make it larger.")
                ) from None
            raise RoamError(
                sentence("A point lies outside of the picture, or under what is left out: put it elsewhere.")
            ) from None
        self.place, self.corners = np.asarray(place, dtype=np.float64), corners
        self._pattern, self._search = pattern, search
        self._grey, self._least = picture.grey, params.least_likeness

    def at(self, matrix: Array) -> Array:
        """Where the point is `(2,)` by a motion from the first picture."""
        return projective.apply(matrix, self.place)

    # ---- the rest is private

    def _guesses(self, look: Look) -> Sequence[Guess]:
        found = self._by_search(look)
        return [(guess, guess) for guess in (found, look.onward) if guess is not None]

    def _by_search(self, look: Look) -> Array | None:
        """Where in the search area the pattern, turned and sized as it last was, is most alike."""
        middle = np.floor(self.at(look.onward))
        reach, size = round(self._search), look.picture.size
        half = max(round(self._pattern), 1)
        x0, y0 = (int(v) for v in middle - reach)
        window = _cut(look.picture.grey, x0, y0, 2 * reach + 1)
        if window is None or not _overlaps(middle, reach, size):
            return None
        pattern = self._under(look.onward, half)
        if pattern.std() < 1.0:
            return None
        alike = cv2.matchTemplate(window, pattern, cv2.TM_CCOEFF_NORMED)
        _, best, _, at = cv2.minMaxLoc(np.nan_to_num(alike))
        if best < self._least:
            return None
        away = np.array([x0 + at[0] + half + 0.5, y0 + at[1] + half + 0.5]) - self.at(look.onward)
        return np.array([[1.0, 0.0, away[0]], [0.0, 1.0, away[1]], [0.0, 0.0, 1.0]]) @ look.onward

    def _under(self, motion: Array, half: int) -> UInt8:
        """The key's pattern as it would be seen under a motion from the key `(2 half + 1, 2 half + 1)`."""
        place = self.at(motion)
        to_picture = np.array([[1.0, 0.0, place[0] - half - 0.5], [0.0, 1.0, place[1] - half - 0.5], [0.0, 0.0, 1.0]])
        way = TO_CENTRES @ np.linalg.inv(motion) @ to_picture @ FROM_CENTRES
        flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
        side = 2 * half + 1
        return np.asarray(
            cv2.warpPerspective(self._grey, way, (side, side), flags=flags, borderMode=cv2.BORDER_REPLICATE), np.uint8
        )


def _overlaps(middle: Array, reach: int, size: tuple[int, int]) -> bool:
    return bool((middle + reach > 0).all() and middle[0] - reach < size[1] and middle[1] - reach < size[0])


def _cut(grey: UInt8, x: int, y: int, side: int) -> UInt8 | None:
    """A square of the picture from column x, row y; what lies outside repeats its edge. None wholly outside."""
    height, width = grey.shape
    if x + side <= 0 or y + side <= 0 or x >= width or y >= height:
        return None
    columns = np.clip(np.arange(x, x + side), 0, width - 1)
    rows = np.clip(np.arange(y, y + side), 0, height - 1)
    return np.ascontiguousarray(grey[np.ix_(rows, columns)])


class PointTracker:
    """Follows one to four points, one picture at a time.

    Parameters
    ----------
    places : (N, 2) on the first picture. pattern, search : half the sides of their areas, pixels.
    pixel_aspect : how much wider than high a pixel is shown.
    """

    def __init__(
        self,
        picture: PreparedFrame,
        places: Array,
        pattern: float,
        search: float,
        params: PointTrackParams = POINT_TRACK,
        covers: Sequence[Array] = (),
        pixel_aspect: float = 1.0,
    ) -> None:
        self._aspect = pixel_aspect
        self._patterns = [PatternTracker(picture, place, pattern, search, params, covers) for place in places]
        self._places = np.array(places, dtype=np.float64)
        self._motions = [projective.IDENTITY] * len(self._places)
        self._found = np.ones(len(self._places), dtype=bool)

    def step(
        self, picture: PreparedFrame, frame: int, covers: Sequence[Array] = (), token: CancelToken | None = None
    ) -> PointStep:
        """Find the points on the next picture.

        Raises
        ------
        LostPoints
            where none of them is seen; Cancelled at a safe point.
        """
        motions, confidence = list(self._motions), np.zeros(len(self._places))

        def look(index: int, onward: Array | None) -> None:
            try:
                step = self._patterns[index].step(picture, frame, covers, token, onward)
            except LostPlane:
                return
            motions[index], confidence[index] = step.matrix, step.confidence

        for index in np.flatnonzero(self._found).tolist():
            look(index, None)
        seen = np.flatnonzero(confidence).tolist()
        for index in np.flatnonzero(confidence == 0.0).tolist():
            onward = self._with_others(index, motions, seen)
            motions[index] = onward[0] if onward else motions[index]
            for guess in onward:
                if not confidence[index]:
                    look(index, guess)
        if not confidence.any():
            raise LostPoints(
                sentence(
                    "No point was found on frame {frame}; put them anew there, or make their areas larger.",
                    frame=frame,
                )
            )
        self._motions, self._found = motions, confidence > 0.0
        self._places = self._at(motions)
        return PointStep(frame, self._places, confidence)

    def skip(self) -> None:
        """A frame goes by without a picture: on the next one the points are so much farther on."""
        for pattern in self._patterns:
            pattern.skip()

    # ---- the rest is private

    def _at(self, motions: Sequence[Array]) -> Array:
        return np.array([pattern.at(motion) for pattern, motion in zip(self._patterns, motions, strict=True)])

    def _with_others(self, index: int, motions: list[Array], seen: list[int]) -> list[Array]:
        """Where a point that was not found may be, `(3, 3)` from the first picture, by the points that are `seen`.

        The patterns of two points tell how the plane lies that all are on; else it goes on as they did.
        """
        ways: list[Array | None] = []
        if len(seen) > 1:
            now = np.concatenate([self._corners(each, motions[each]) for each in seen])
            first = np.concatenate([self._patterns[each].corners for each in seen])
            ways.append(fit(PlaneMotion.HOMOGRAPHY, first, now))
        if seen:
            step = motion_of(self._places[seen], self._at(motions)[seen], self._aspect)
            ways.append(None if step is None else projective.usable(step @ self._motions[index]))
        else:
            ways.append(self._motions[index])
        return [way for way in ways if way is not None]

    def _corners(self, index: int, motion: Array) -> Array:
        return projective.apply(motion, self._patterns[index].corners)


def track_points(
    read: ReadFrame,
    places: Array,
    frames: range,
    pattern: float,
    search: float,
    token: CancelToken | None = None,
    covers: Covers = no_covers,
    pixel_aspect: float = 1.0,
    params: PointTrackParams = POINT_TRACK,
) -> Iterator[PointStep]:
    """Follow points from `frames[0]`, where they are at `places (N, 2)`, through the other frames.

    `pixel_aspect` is how much wider than high a pixel is shown. A frame whose picture is missing is passed over. Frames
    on which all points are hidden come when one is seen again.

    Raises
    ------
    LostPoints
        on the first frame where none is seen any more. Cancelled: at a safe point after `token` was cancelled.
    RoamError
        when there is no point, or one lies outside of the picture, or its pattern is too small.
    """
    start = np.asarray(places, dtype=np.float64).reshape(-1, 2)
    if not 0 < len(start) <= max(KINDS):
        raise RoamError(sentence("Put one, two, three or four points on the picture to track them."))
    tracker = PointTracker(
        PreparedFrame(read(frames[0])), start, pattern, search, params, covers(frames[0]), pixel_aspect
    )

    def look(frame: int) -> PointStep:
        try:
            return tracker.step(PreparedFrame(read(frame)), frame, covers(frame), token)
        except MissingFrame:
            tracker.skip()
            raise

    first = PointStep(frames[0], start, np.ones(len(start)))
    yield from bridged(first, look, _between, frames[1:], params.plane.waits, token)


def _between(before: PointStep, after: PointStep, frames: Sequence[int]) -> Iterator[PointStep]:
    """The points on frames on which all are hidden: they go evenly from where they were to where they are."""
    for frame in frames:
        share = (frame - before.frame) / (after.frame - before.frame)
        places = (1.0 - share) * before.places + share * after.places
        yield replace(before, frame=frame, places=places, confidence=np.zeros(len(places)))
