"""The planar tracker: corners inside outlines followed by KLT, one RANSAC motion, matched to the reference picture.

Every picture is matched twice: to the one before, which finds the plane wherever it went, and then, warped back by
that, to the reference picture, which takes out what adds up from frame to frame. Where the plane no longer looks as it
did on the reference, the last picture that still matched becomes the next reference.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from roam_core.arrays import Array, UInt8
from roam_core.cancel import CancelToken
from roam_core.errors import RoamError
from roam_core.features import PreparedFrame, Region
from roam_core.geometry import bezier, projective
from roam_core.geometry.plane_motion import PlaneMotion, ransac
from roam_core.media.source import MissingFrame
from roam_core.params import PLANAR, PlanarParams, scale_for

ReadFrame = Callable[[int], NDArray[Any]]


@dataclass(frozen=True, eq=False)
class PlaneStep:
    """Where the plane is on a frame.

    Attributes
    ----------
    matrix : (3, 3) from the first frame's picture to this one's, full-size pixels.
    agreement : share of the followed corners that agree with it.
    corners : how many were followed.
    """

    frame: int
    matrix: Array
    agreement: float
    corners: int


class LostPlane(RoamError):
    """The plane could not be found on a frame."""


@dataclass(frozen=True, eq=False)
class Match:
    """How a reference picture was met again.

    Attributes
    ----------
    matrix : (3, 3) from the first picture to the one that was matched, full-size pixels.
    sought : (K, 2) the corners of the reference that the motion leaves in the picture.
    agreeing : (J, 2) those of them that were found where it says. there : (J, 2) where that is.
    followed : how many were found at all.
    """

    matrix: Array
    sought: Array
    agreeing: Array
    there: Array
    followed: int

    @property
    def agreement(self) -> float:
        """Share of the corners that should be seen that are, where they should be."""
        return len(self.agreeing) / max(len(self.sought), 1)


@dataclass(frozen=True, eq=False)
class Reference:
    """A picture that later ones are matched to: its grey levels and corners in it, and where it is from the first."""

    grey: UInt8
    corners: Array
    matrix: Array
    params: PlanarParams = PLANAR

    @classmethod
    def of(
        cls,
        picture: PreparedFrame,
        outlines: Sequence[Array],
        holes: Sequence[Array] = (),
        matrix: Array = projective.IDENTITY,
        params: PlanarParams = PLANAR,
        count: int | None = None,
    ) -> Reference:
        """With up to `count` corners between the closed splines `(P, 3, 2)`, which lie on the picture.

        None: `PlanarParams.corners`.
        """
        most = params.corners if count is None else count
        corners = corners_in(picture.grey, inside(outlines, holes, picture.size), most)
        return cls(picture.grey, corners, matrix, params)

    def matched(
        self,
        picture: PreparedFrame,
        guess: Array,
        kind: PlaneMotion,
        tolerance: float | None = None,
        check: Callable[[], None] | None = None,
    ) -> Match | None:
        """The motion `guess (3, 3)`, from the first picture to this one, refined; None where too few corners tell it.

        A corner agrees within `tolerance` pixels, by default `PlanarParams.agree_closely` of the reduced picture.
        """
        params = self.params
        least = params.enough * kind.pairs
        since = guess @ np.linalg.inv(self.matrix)
        height, width = picture.size
        there = projective.apply(since, self.corners)
        margin = 8.0 * scale_for(picture.size)
        seen = ((there >= margin) & (there <= np.array([width, height]) - margin)).all(axis=1)
        if seen.sum() < least:
            return None
        source, target, shrunk = _matched(self.grey, picture.grey, self.corners[seen], since, params)
        if check is not None:
            check()
        residual, agree = ransac(
            kind, source, target, params.agree_closely / shrunk if tolerance is None else tolerance
        )
        if residual is None or agree.sum() < least:
            return None
        matrix = projective.usable(since @ residual @ self.matrix)
        if matrix is None:
            return None
        return Match(matrix, self.corners[seen], source[agree], projective.apply(since, target[agree]), len(source))


class PlanarTracker:
    """Follows the plane that the insides of outlines lie on, one picture at a time.

    Parameters
    ----------
    kind : what the plane may do.
    outlines : closed splines `(P, 3, 2)` on the first picture; where an even number of them overlap is outside.
    holes : closed splines that are cut out.
    params : how it looks.
    """

    def __init__(
        self,
        kind: PlaneMotion,
        picture: PreparedFrame,
        outlines: Sequence[Array],
        holes: Sequence[Array] = (),
        params: PlanarParams = PLANAR,
    ) -> None:
        self.kind, self.params = PlaneMotion(kind), params
        self._outlines, self._holes = list(outlines), list(holes)
        self._before, self._matrix = picture, projective.IDENTITY
        self._scale = scale_for(picture.size)
        self._reference = Reference.of(picture, self._outlines, self._holes, params=params)
        self._check: Callable[[], None] = _go_on

    def step(self, picture: PreparedFrame, frame: int, token: CancelToken | None = None) -> PlaneStep:
        """Find the plane on the next picture.

        Raises
        ------
        LostPlane
            where too few corners agree; Cancelled at a safe point. The tracker then stands on the picture before.
        """
        self._check = token.check if token is not None else _go_on
        guess, agreement, count = self._from_last(picture, frame)
        matched = self._from_reference(picture, guess)
        if matched is None and self._reference.grey is not self._before.grey:
            # The plane looks different by now: go on from the last picture, which was still believed.
            outlines, holes = (self._carried(curves, self._matrix) for curves in (self._outlines, self._holes))
            self._reference = Reference.of(self._before, outlines, holes, self._matrix, self.params)
            matched = self._from_reference(picture, guess)
        if matched is not None:
            guess, agreement, count = matched.matrix, matched.agreement, matched.followed
        self._refuse_far(guess, frame, picture)
        self._before, self._matrix = picture, guess
        return PlaneStep(frame, guess, agreement, count)

    # ---- the rest is private

    def _from_last(self, picture: PreparedFrame, frame: int) -> tuple[Array, float, int]:
        outlines = self._carried(self._outlines, self._matrix)
        region = Region.around(np.concatenate(outlines), self.params.travel * self._scale, picture.size)
        holes = self._carried(self._holes, self._matrix)
        source, target, shrunk = _followed_in(self._before.grey, picture.grey, region, outlines, holes, self.params)
        self._check()
        motion, agree = ransac(self.kind, source, target, self.params.agree / shrunk)
        self._check()
        matrix = None if motion is None else projective.usable(motion @ self._matrix)
        if matrix is None or agree.sum() < max(self.params.enough * self.kind.pairs, 4):
            raise LostPlane(
                f"The plane was lost on frame {frame}: too few corners inside the shapes go one way; start again there."
            )
        return matrix, float(agree.mean()), len(source)

    def _from_reference(self, picture: PreparedFrame, guess: Array) -> Match | None:
        """The motion refined by the reference, or None where they do not look alike."""
        match = self._reference.matched(picture, guess, self.kind, check=self._check)
        return match if match is not None and match.agreement >= self.params.least_agreement else None

    def _refuse_far(self, matrix: Array, frame: int, picture: PreparedFrame) -> None:
        points = np.concatenate([outline.reshape(-1, 2) for outline in self._outlines])
        far = self.params.far * max(picture.size)
        behind = (projective.depth(matrix, points) <= 0.0).any()
        if behind or np.abs(projective.apply(matrix, points)).max() > far:
            raise LostPlane(f"The plane was lost on frame {frame}: it would tip over; try a simpler motion.")

    def _carried(self, outlines: Sequence[Array], matrix: Array) -> list[Array]:
        return [projective.apply(matrix, points) for points in outlines]


def _go_on() -> None:
    """Nobody can ask to stop."""


def track_plane(
    read: ReadFrame,
    outlines: Sequence[Array],
    holes: Sequence[Array],
    frames: range,
    kind: PlaneMotion,
    token: CancelToken | None = None,
) -> Iterator[PlaneStep]:
    """Follow the plane from `frames[0]`, where its outlines `(P, 3, 2)` are given, through the other frames.

    A frame whose picture is missing is passed over.

    Raises
    ------
    LostPlane
        on the frame where it cannot be followed any further. Cancelled: at a safe point after `token` was cancelled.
    RoamError
        when nothing is outlined, or no corner is found inside.
    """
    if not outlines:
        raise RoamError("There is no closed shape to track; draw one, or select one, first.")
    tracker = PlanarTracker(kind, PreparedFrame(read(frames[0])), outlines, holes)
    for frame in frames[1:]:
        if token is not None:
            token.check()
        try:
            picture = PreparedFrame(read(frame))
        except MissingFrame:
            continue
        yield tracker.step(picture, frame, token)


def corners_in(grey: UInt8, mask: UInt8, count: int = PLANAR.corners) -> Array:
    """Up to `count` corners `(K, 2)` of `grey (h, w)` where `mask (h, w)` is not zero, spread out, in our pixels."""
    area = int(np.count_nonzero(mask))
    if area == 0:
        return np.empty((0, 2))
    x, y, wide, high = cv2.boundingRect(mask)
    box = slice(y, y + high), slice(x, x + wide)
    apart = max(2.0, float(np.sqrt(area / count)) * 0.6)
    found = cv2.goodFeaturesToTrack(
        np.ascontiguousarray(grey[box]), count, 0.003, apart, mask=np.ascontiguousarray(mask[box]), blockSize=5
    )
    # Pixel centres lie at half-integers in our coordinates and at integers in OpenCV's.
    return np.empty((0, 2)) if found is None else found.reshape(-1, 2) + np.array([x + 0.5, y + 0.5])


def followed(
    old: UInt8,
    new: UInt8,
    corners: Array,
    window: int = PLANAR.window,
    levels: int = 4,
    returned: float = PLANAR.returned,
) -> tuple[Array, Array]:
    """Those of `corners (K, 2)` of the old picture that KLT finds on the new one and back again, and where.

    It compares windows of `window` pixels, on `levels` halvings of the pictures beside themselves. What comes back
    within `returned` pixels of where it was has been found.
    """
    if len(corners) == 0:
        return corners, corners
    criteria = (cv2.TERM_CRITERIA_EPS | cv2.TERM_CRITERIA_COUNT, 30, 0.01)
    options: dict[str, Any] = {"winSize": (window, window), "maxLevel": levels, "criteria": criteria}
    here = (corners - 0.5).astype(np.float32).reshape(-1, 1, 2)
    there, found, _ = cv2.calcOpticalFlowPyrLK(old, new, here, None, **options)
    back, found_back, _ = cv2.calcOpticalFlowPyrLK(new, old, there, None, **options)
    near = np.hypot(*(back - here).reshape(-1, 2).T) < returned
    keep = (found.ravel() == 1) & (found_back.ravel() == 1) & near
    return corners[keep], there.reshape(-1, 2)[keep].astype(np.float64) + 0.5


def inside(outlines: Sequence[Array], holes: Sequence[Array], size: tuple[int, int]) -> UInt8:
    """255 where corners may lie, `(h, w)`: inside an odd number of outlines, and in no hole."""
    mask = np.zeros(size, dtype=np.uint8)
    for curves, value in ((outlines, 255), (holes, 0)):
        lines = [np.round((bezier.flatten(points, True) - 0.5) * 16.0).astype(np.int32) for points in curves]
        if lines:
            cv2.fillPoly(mask, lines, value, shift=4)
    return mask


def _followed_in(
    old: UInt8,
    new: UInt8,
    region: Region,
    outlines: Sequence[Array],
    holes: Sequence[Array],
    params: PlanarParams,
) -> tuple[Array, Array, float]:
    """Corners inside the outlines and where they went, full-size pixels, and by how much the region was reduced."""
    none = np.empty((0, 2))
    if region.is_empty:
        return none, none, 1.0
    shrunk = min(1.0, params.side / max(region.x1 - region.x0, region.y1 - region.y0))
    origin = np.asarray(region.origin, dtype=np.float64)
    a, b = (_reduced(grey[region.slices], shrunk) for grey in (old, new))
    local, cut = ([(points - origin) * shrunk for points in curves] for curves in (outlines, holes))
    corners = corners_in(a, inside(local, cut, (a.shape[0], a.shape[1])), params.corners)
    source, target = followed(a, b, corners, params.window, returned=params.returned)
    return source / shrunk + origin, target / shrunk + origin, shrunk


def _matched(old: UInt8, new: UInt8, corners: Array, since: Array, params: PlanarParams) -> tuple[Array, Array, float]:
    """Corners of the reference picture, and where the new one, warped back by `since (3, 3)`, has them."""
    height, width = old.shape
    region = Region.around(corners, 24.0 * scale_for((height, width)), (height, width))
    shrunk = min(1.0, params.side / max(region.x1 - region.x0, region.y1 - region.y0))
    origin = np.asarray(region.origin, dtype=np.float64)
    a = _reduced(old[region.slices], shrunk)
    # From a pixel of the reduced reference, in OpenCV's coordinates, to one of the new picture.
    to_full = np.array(
        [[1 / shrunk, 0, origin[0] + 0.5 / shrunk], [0, 1 / shrunk, origin[1] + 0.5 / shrunk], [0, 0, 1]]
    )
    from_full = np.array([[1.0, 0.0, -0.5], [0.0, 1.0, -0.5], [0.0, 0.0, 1.0]])
    way = from_full @ since @ to_full
    flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    b = cv2.warpPerspective(new, way, (a.shape[1], a.shape[0]), flags=flags, borderMode=cv2.BORDER_REPLICATE)
    warped = _alike(np.asarray(b, dtype=np.uint8), a)
    source, target = followed(a, warped, (corners - origin) * shrunk, params.window_closely, 2, params.returned)
    return source / shrunk + origin, target / shrunk + origin, shrunk


def _alike(picture: UInt8, model: UInt8) -> UInt8:
    """`picture` with the mean and contrast of `model`: light that changes is no motion."""
    mean, spread = float(picture.mean()), float(picture.std())
    gain = float(np.clip(model.std() / max(spread, 1.0), 0.5, 2.0))
    levels = np.clip((np.arange(256) - mean) * gain + model.mean(), 0, 255)
    return np.asarray(cv2.LUT(picture, np.round(levels).astype(np.uint8)), dtype=np.uint8)


def _reduced(grey: UInt8, factor: float) -> UInt8:
    if factor == 1.0:
        return np.ascontiguousarray(grey)
    return np.asarray(cv2.resize(grey, None, fx=factor, fy=factor, interpolation=cv2.INTER_AREA), dtype=np.uint8)
