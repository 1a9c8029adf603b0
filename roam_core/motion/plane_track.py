"""The planar tracker: every picture is matched to the texture that the plane has on the key itself, so nothing adds up.

Where the plane lies is guessed from corners followed since the last picture, and from how it moved before; then the
key's texture tells it exactly (`roam_core.motion.registration`). Where the plane no longer looks as on the key, the
last picture that was believed becomes a second reference; the key is tried first all the same. What is hidden on the
last picture is not followed, so that nothing that passes before the plane carries it off. Where all of it is hidden for
a while its motion is bridged, and said to be.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np

from roam_core.arrays import Array, Bools, UInt8
from roam_core.cancel import CancelToken
from roam_core.errors import RoamError
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import FROM_CENTRES, TO_CENTRES, reduced
from roam_core.geometry import projective
from roam_core.geometry.plane_motion import PlaneMotion, fit, ransac
from roam_core.media.partial import ReadFrame
from roam_core.media.source import MissingFrame
from roam_core.motion.bridging import Lost, bridged
from roam_core.motion.planar import corners_in, followed, inside
from roam_core.motion.registration import Expected, Fit, Texture, confidence_of
from roam_core.params import PLANAR, scale_for
from roam_core.params.tracks import PLANE_TRACK, PlaneTrackParams
from roam_core.translatable import sentence

Covers = Callable[[int], Sequence[Array]]
"""The closed splines `(P, 3, 2)` of what lies before the plane on a frame."""
Guess = tuple[Array, Array]
"""Where a match may begin, and where what it leaves open is expected, `(3, 3)` each from the first picture."""


class LostPlane(Lost):
    """The plane could not be found on a frame."""


@dataclass(frozen=True, eq=False)
class PlaneStep:
    """Where the plane is on a frame.

    Attributes
    ----------
    matrix : (3, 3) from the first frame's picture to this one's, full-size pixels.
    confidence : how far it can be trusted, in [0, 1]; 0 where it was bridged.
    seen : share of the plane that is seen as it was, in [0, 1].
    error : the expected error of its corners, pixels; infinite where it was bridged.
    """

    frame: int
    matrix: Array
    confidence: float
    seen: float
    error: float


@dataclass(frozen=True, eq=False)
class _Reference:
    """A picture's texture of the plane, where that picture is from the first, and what it is worth.

    `error` is what its own place may err by at the corners, pixels; `share` how much of the plane it shows, and
    `steps` how many references lie before it.
    """

    texture: Texture
    matrix: Array
    error: float = 0.0
    share: float = 1.0
    steps: int = 0


@dataclass(frozen=True, eq=False)
class _Match:
    """The plane on a picture: from the first one `matrix (3, 3)`, and what of `PlaneStep` follows from the fit."""

    matrix: Array
    fit: Fit
    reference: _Reference
    seen: float
    error: float
    confidence: float

    @classmethod
    def of(cls, fit: Fit, reference: _Reference, params: PlaneTrackParams, scale: float) -> _Match | None:
        """None where the motion is no usable one."""
        matrix = projective.usable(fit.matrix @ reference.matrix)
        if matrix is None:
            return None
        error, seen = float(np.hypot(fit.error, reference.error)), fit.seen * reference.share
        confidence = confidence_of(error / scale, seen, fit.likeness, params.confidence)
        return cls(matrix, fit, reference, seen, error, confidence * params.confidence.aged**reference.steps)


@dataclass(frozen=True, eq=False)
class Look:
    """A picture that is looked at: what covers it, where the plane would be if it went on evenly, whether to stop."""

    picture: PreparedFrame
    hidden: UInt8 | None
    onward: Array
    check: Callable[[], None]

    def is_free(self, places: Array) -> Bools:
        """Which of `places (K, 2)` nothing covers."""
        if self.hidden is None:
            return np.ones(len(places), dtype=bool)
        column, row = np.clip(places.astype(int), 0, np.array(self.picture.size)[::-1] - 1).T
        return np.asarray(self.hidden[row, column] == 0)


class PlaneTracker:
    """Follows the plane that the insides of outlines lie on, one picture at a time.

    Parameters
    ----------
    kind : what the plane may do.
    outlines : closed splines `(P, 3, 2)` on the first picture; where an even number of them overlap is outside.
    holes : closed splines that are cut out of it, and go with the plane.
    covers : closed splines of what lies before it on the first picture.
    pixel_aspect : how much wider than high a pixel is shown: what turns then is a similarity as it is shown.

    Raises
    ------
    RoamError
        where too little is left to follow.
    """

    def __init__(
        self,
        kind: PlaneMotion,
        picture: PreparedFrame,
        outlines: Sequence[Array],
        holes: Sequence[Array] = (),
        covers: Sequence[Array] = (),
        pixel_aspect: float = 1.0,
        params: PlaneTrackParams = PLANE_TRACK,
    ) -> None:
        self.kind, self.params, self._aspect = PlaneMotion(kind), params, pixel_aspect
        self._mask = inside(outlines, [*holes, *covers], picture.size)
        texture = Texture.of(picture.grey, self._mask, params.registration, pixel_aspect)
        if texture is None:
            raise RoamError(sentence("Too little of the picture lies inside the shapes to track a plane by it."))
        self._key = _Reference(texture, projective.IDENTITY)
        self._second: _Reference | None = None
        self._before, self._matrix, self._seen = picture, projective.IDENTITY, self._mask
        self._moved, self._frames = projective.IDENTITY, 1
        self._lost_on: int | None = None
        self._last: _Match | None = None
        self._scale = scale_for(picture.size)

    def step(
        self,
        picture: PreparedFrame,
        frame: int,
        covers: Sequence[Array] = (),
        token: CancelToken | None = None,
        onward: Array | None = None,
    ) -> PlaneStep:
        """Find the plane on the next picture.

        `onward (3, 3)` is where it is expected, from the first picture; None: where it would be if it went on evenly.

        Raises
        ------
        LostPlane
            where it is not seen; Cancelled at a safe point. The tracker then stands on the picture before.
        RoamError
            where the picture has another size.
        """
        check = token.check if token is not None else _go_on
        picture.require_size_of(self._before, frame)
        hidden = inside(covers, (), picture.size) if covers else None
        look = Look(picture, hidden, self.onward() if onward is None else onward, check)
        guesses = self._guesses(look)
        check()
        match = self._found(look, guesses)
        if match is None:
            self._lose(frame)
            raise LostPlane(
                sentence(
                    "The plane was lost on frame {frame}: too little of it looks as it did; start again there, or "
                    "leave out what covers it.",
                    frame=frame,
                )
            )
        self._refuse_far(match.matrix, frame, picture)
        self._keep(picture, match)
        return PlaneStep(frame, match.matrix, match.confidence, match.seen, match.error)

    def skip(self) -> None:
        """A frame goes by without the plane, or without a picture: on the next one it is so much farther on."""
        self._frames += 1

    def onward(self) -> Array:
        """Where the plane would be if it moved on as it did, from the first picture `(3, 3)`."""
        onward = projective.usable(np.linalg.matrix_power(self._moved, self._frames) @ self._matrix)
        return self._matrix if onward is None else onward

    # ---- the rest is private

    def _guesses(self, look: Look) -> Sequence[Guess]:
        guesses = self._by_corners(look), look.onward, self._matrix
        return [(guess, look.onward) for guess in guesses if guess is not None]

    def _by_corners(self, look: Look) -> Array | None:
        """Where the plane would be by the corners of what was seen of it, from the first picture `(3, 3)`."""
        params, picture = PLANAR, look.picture
        rows, columns = np.nonzero(self._seen)
        if len(rows) == 0:
            return None
        extent = np.array([[columns.min(), rows.min()], [columns.max() + 1.0, rows.max() + 1.0]])
        region = Region.around(extent, params.travel * self._scale, picture.size)
        shrunk = min(1.0, params.side / max(region.x1 - region.x0, region.y1 - region.y0))
        parts = self._before.grey, picture.grey, self._seen
        old, new, mask = (reduced(each[region.slices], shrunk) for each in parts)
        source, target = followed(
            old, new, corners_in(old, mask, params.corners), params.window, returned=params.returned
        )
        to_full = np.array([[1 / shrunk, 0, region.x0], [0, 1 / shrunk, region.y0], [0, 0, 1.0]])
        free = look.is_free(projective.apply(to_full, target))
        motion, agree = ransac(self.kind, source[free], target[free], params.agree, self._aspect)
        if motion is None or agree.sum() < max(params.enough * self.kind.pairs, 4):
            return None
        return projective.usable(to_full @ motion @ np.linalg.inv(to_full) @ self._matrix)

    def _found(self, look: Look, guesses: Sequence[Guess]) -> _Match | None:
        """The best match to the key; to the second reference where that tells more; None where neither is alike."""
        best = self._best(self._key, look, guesses)
        if best is not None and best.confidence >= self.params.least_confidence:
            return best
        for reference in (self._second, self._renewed()):
            found = None if reference is None else self._best(reference, look, guesses)
            if found is not None and (best is None or found.confidence > best.confidence):
                best, self._second = found, reference
            if best is not None and best.confidence >= self.params.least_confidence:
                break
        return best

    def _best(self, reference: _Reference, look: Look, guesses: Sequence[Guess]) -> _Match | None:
        """The best match to a reference, from any of the guesses."""
        back, params = np.linalg.inv(reference.matrix), self.params
        within = float(np.hypot(params.within * self._scale, 2.0 * self._error))
        best: _Match | None = None
        for guess, expected in guesses:
            start = projective.usable(guess @ back)
            if start is None:
                continue
            found = reference.texture.matched(
                look.picture.grey, start, self.kind, look.hidden, Expected(expected @ back, within), look.check
            )
            match = None if found is None else _Match.of(found, reference, params, self._scale)
            if match is None or match.seen < params.least_seen or match.fit.likeness < params.least_fit:
                continue
            if best is None or match.seen * match.fit.likeness > best.seen * best.fit.likeness:
                best = match
            if match.seen > params.surely:
                break
        return best

    def _keep(self, picture: PreparedFrame, match: _Match) -> None:
        """Stand on this picture: where the plane is, how it moved, and what of it is seen."""
        moved = projective.usable(match.matrix @ np.linalg.inv(self._matrix)) if self._frames == 1 else None
        self._moved = projective.IDENTITY if moved is None else moved
        self._before, self._matrix, self._frames, self._last = picture, match.matrix, 1, match
        self._seen = _seen_in(picture, match, self._mask)

    @property
    def _error(self) -> float:
        return 0.0 if self._last is None else self._last.error

    def _renewed(self) -> _Reference | None:
        """The last picture as a reference, of what was seen of the plane on it; None where that is not believed."""
        last = self._last
        if last is None or last.confidence < self.params.least_confidence:
            return None
        texture = Texture.of(self._before.grey, self._seen, self.params.registration, self._aspect)
        if texture is None:
            return None
        return _Reference(texture, self._matrix, last.error, last.seen, last.reference.steps + 1)

    def _lose(self, frame: int) -> None:
        """The plane is not seen on a frame; one that is looked at again, from elsewhere, goes by once."""
        if frame != self._lost_on:
            self._lost_on = frame
            self.skip()

    def _refuse_far(self, matrix: Array, frame: int, picture: PreparedFrame) -> None:
        points = self._key.texture.corners
        far = self.params.far * max(picture.size)
        behind = (projective.depth(matrix, points) <= 0.0).any()
        if behind or np.abs(projective.apply(matrix, points)).max() > far:
            self._lose(frame)
            raise LostPlane(
                sentence("The plane was lost on frame {frame}: it would tip over; try a simpler motion.", frame=frame)
            )


def _seen_in(picture: PreparedFrame, match: _Match, first: UInt8) -> UInt8:
    """Where the plane, which `first (h, w)` shows on the first picture, is seen in this one: 255, else 0, `(h, w)`."""
    height, width = picture.size
    weights = cv2.warpPerspective(
        match.fit.weights,
        TO_CENTRES @ match.fit.matrix @ match.reference.texture.levels[-1].to_full @ FROM_CENTRES,
        (width, height),
        flags=cv2.INTER_LINEAR,
    )
    whole = cv2.warpPerspective(
        first, TO_CENTRES @ match.matrix @ FROM_CENTRES, (width, height), flags=cv2.INTER_NEAREST
    )
    return np.where((weights > 0.5) & (whole > 0), 255, 0).astype(np.uint8)


def _go_on() -> None:
    """Nobody can ask to stop."""


def no_covers(_frame: int) -> Sequence[Array]:
    """Nothing lies before the plane."""
    return ()


def track_plane(
    read: ReadFrame,
    outlines: Sequence[Array],
    holes: Sequence[Array],
    frames: range,
    kind: PlaneMotion,
    token: CancelToken | None = None,
    covers: Covers = no_covers,
    pixel_aspect: float = 1.0,
    params: PlaneTrackParams = PLANE_TRACK,
) -> Iterator[PlaneStep]:
    """Follow the plane from `frames[0]`, where its outlines `(P, 3, 2)` are given, through the other frames.

    `pixel_aspect` is how much wider than high a pixel is shown. A frame whose picture is missing is passed over. Frames
    on which the plane is hidden come when it is seen again.

    Raises
    ------
    LostPlane
        on the first frame where it is seen no more. Cancelled: at a safe point after `token` was cancelled.
    RoamError
        when nothing is outlined, or too little.
    """
    if not outlines:
        raise RoamError(sentence("There is no closed shape to track; draw one, or select one, first."))
    start = frames[0]
    tracker = PlaneTracker(kind, PreparedFrame(read(start)), outlines, holes, covers(start), pixel_aspect, params)
    around = np.concatenate([outline.reshape(-1, 2) for outline in outlines])

    def look(frame: int) -> PlaneStep:
        try:
            return tracker.step(PreparedFrame(read(frame)), frame, covers(frame), token)
        except MissingFrame:
            tracker.skip()
            raise

    def between(before: PlaneStep, after: PlaneStep, hidden: Sequence[int]) -> Iterator[PlaneStep]:
        return _between(before, after, hidden, around)

    yield from bridged(
        PlaneStep(start, projective.IDENTITY, 1.0, 1.0, 0.0), look, between, frames[1:], params.waits, token
    )


def _between(before: PlaneStep, after: PlaneStep, frames: Sequence[int], around: Array) -> Iterator[PlaneStep]:
    """The plane on frames on which it is hidden: its corners go evenly from where it was to where it is."""
    low, high = around.min(axis=0), around.max(axis=0)
    box = np.array([low, (high[0], low[1]), high, (low[0], high[1])])
    ends = [projective.apply(step.matrix, box) for step in (before, after)]
    for frame in frames:
        share = (frame - before.frame) / (after.frame - before.frame)
        matrix = fit(PlaneMotion.HOMOGRAPHY, box, (1.0 - share) * ends[0] + share * ends[1])
        if matrix is not None:
            yield replace(before, frame=frame, matrix=matrix, confidence=0.0, seen=0.0, error=np.inf)
