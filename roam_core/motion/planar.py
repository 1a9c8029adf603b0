"""A plane by its corners: those of a reference picture, found again in a later one, and the one motion that they tell.

It tells whether what lies inside outlines still is one plane; the planar tracker (`roam_core.motion.plane_track`) takes
its guesses from corners that are followed.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np

from roam_core.arrays import Array, UInt8
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import reduced
from roam_core.geometry import bezier, projective
from roam_core.geometry.plane_motion import PlaneMotion, ransac
from roam_core.params import PLANAR, PlanarParams, scale_for

BESIDE = 4.0
"""Pixels around a part of a picture that is warped, for the interpolation between them."""


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
    """A picture that later ones are matched to: corners in it, and where it is from the first.

    Of its grey levels it has the `part` around the corners.
    """

    grey: UInt8
    part: Region
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
        mask = inside(outlines, holes, picture.size)
        x, y, width, height = cv2.boundingRect(mask)
        part = _surroundings(np.array([[x, y], [x + width, y + height]]), picture.size)
        grey = picture.grey_within(part)
        return cls(grey, part, corners_in(grey, mask[part.slices], most) + part.origin, matrix, params)

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
        source, target, shrunk = _matched(self, picture, self.corners[seen], since)
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


def _surroundings(places: Array, size: tuple[int, int]) -> Region:
    """What of a picture `(h, w)` is looked at for corners at some `places (K, 2)`."""
    return Region.around(places, 24.0 * scale_for(size), size)


def _matched(old: Reference, new: PreparedFrame, corners: Array, since: Array) -> tuple[Array, Array, float]:
    """Corners of the reference picture, and where the new one, warped back by `since (3, 3)`, has them."""
    params, region = old.params, _surroundings(corners, new.size)
    shrunk = min(1.0, params.side / max(region.x1 - region.x0, region.y1 - region.y0))
    origin = np.asarray(region.origin, dtype=np.float64)
    a = reduced(old.grey[region.shifted(-old.part.x0, -old.part.y0).slices], shrunk)
    # From a pixel of the reduced reference, in OpenCV's coordinates, to one of the new picture.
    to_full = np.array(
        [[1 / shrunk, 0, origin[0] + 0.5 / shrunk], [0, 1 / shrunk, origin[1] + 0.5 / shrunk], [0, 0, 1]]
    )
    from_full = np.array([[1.0, 0.0, -0.5], [0.0, 1.0, -0.5], [0.0, 0.0, 1.0]])
    way = from_full @ since @ to_full
    warped = _alike(_warped(new, way, (a.shape[0], a.shape[1])), a)
    source, target = followed(a, warped, (corners - origin) * shrunk, params.window_closely, 2, params.returned)
    return source / shrunk + origin, target / shrunk + origin, shrunk


def _warped(picture: PreparedFrame, way: Array, size: tuple[int, int]) -> UInt8:
    """A picture's grey levels `(h, w)` of `size`, each taken from where `way (3, 3)` leads, in OpenCV's coordinates.

    Only the part of the picture that they come from is looked at.
    """
    height, width = size
    rim = np.array([[0.0, 0.0, 1.0], [width, 0.0, 1.0], [width, height, 1.0], [0.0, height, 1.0]]) @ way.T
    part = Region(0, 0, picture.size[1], picture.size[0])
    if (rim[:, 2] > 0.0).all():  # else the horizon crosses it
        around = Region.around(rim[:, :2] / rim[:, 2:], BESIDE, picture.size)
        part = part if around.is_empty else around
    to_part = np.array([[1.0, 0.0, -part.x0], [0.0, 1.0, -part.y0], [0.0, 0.0, 1.0]])
    grey, flags = picture.grey_within(part), cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    warped = cv2.warpPerspective(grey, to_part @ way, (width, height), flags=flags, borderMode=cv2.BORDER_REPLICATE)
    return np.asarray(warped, dtype=np.uint8)


def _alike(picture: UInt8, model: UInt8) -> UInt8:
    """`picture` with the mean and contrast of `model`: light that changes is no motion."""
    mean, spread = float(picture.mean()), float(picture.std())
    gain = float(np.clip(model.std() / max(spread, 1.0), 0.5, 2.0))
    levels = np.clip((np.arange(256) - mean) * gain + model.mean(), 0, 255)
    return np.asarray(cv2.LUT(picture, np.round(levels).astype(np.uint8)), dtype=np.uint8)
