"""The planar peer: corners inside the outline followed by KLT, one RANSAC motion for the object, accumulated."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from benchmarks.methods.method import Array, MovingPoints
from benchmarks.shots import Shot
from roam_core.geometry import bezier

FEATURES = 400
"""Corners that are followed."""
RETURN, AGREE = 0.5, 2.0
"""Pixels by which a corner that is followed there and back again may miss its place, and by which it may disagree."""
FAR = 3.0
"""Sizes of the picture beyond which no outline is carried."""
NEEDED = {"similarity": 2, "affine": 3, "homography": 4}
"""Pairs that fix a motion; with fewer than three times as many the object is taken to stand still."""


class Planar(MovingPoints):
    """All outlines move as one plane does, in the way of Mocha: `kind` is similarity, affine or homography."""

    def __init__(self, kind: str) -> None:
        self.kind = kind
        self.name = f"planar, {kind}"

    def moved(self, shot: Shot, outlines: list[Array], before: int, after: int) -> list[Array]:
        """See `MovingPoints.moved`."""
        old, new = (cv2.cvtColor(shot.read(frame), cv2.COLOR_RGB2GRAY) for frame in (before, after))
        source, target = _followed(old, new, _inside(outlines, shot.size))
        motion = _motion(source, target, self.kind)
        moved = [cv2.perspectiveTransform(points.reshape(-1, 1, 2), motion).reshape(-1, 3, 2) for points in outlines]
        far = FAR * max(shot.size)
        # A homography can throw points through the horizon; an artist would not follow it there.
        return moved if all(np.abs(points).max() < far for points in moved) else outlines


def _inside(outlines: list[Array], size: tuple[int, int]) -> NDArray[np.uint8]:
    """Where corners may lie: inside an odd number of outlines."""
    mask = np.zeros(size, dtype=np.uint8)
    lines = [np.round((bezier.flatten(points) - 0.5) * 16.0).astype(np.int32) for points in outlines]
    cv2.fillPoly(mask, lines, 255, shift=4)
    return mask


def _followed(old: NDArray[Any], new: NDArray[Any], inside: NDArray[np.uint8]) -> tuple[Array, Array]:
    """Corners `(K, 2)` on the old picture and their places on the new one."""
    corners = cv2.goodFeaturesToTrack(old, FEATURES, 0.005, 4.0, mask=inside, blockSize=5)
    if corners is None:
        return np.empty((0, 2)), np.empty((0, 2))
    options: dict[str, Any] = {"winSize": (21, 21), "maxLevel": 4}
    there, found, _ = cv2.calcOpticalFlowPyrLK(old, new, corners, None, **options)
    back, returned, _ = cv2.calcOpticalFlowPyrLK(new, old, there, None, **options)
    near = np.hypot(*(back - corners).reshape(-1, 2).T) < RETURN
    keep = (found.ravel() == 1) & (returned.ravel() == 1) & near
    # Pixel centres lie at half-integers in our coordinates and at integers in OpenCV's.
    return tuple(points.reshape(-1, 2)[keep].astype(np.float64) + 0.5 for points in (corners, there))


def _motion(source: Array, target: Array, kind: str) -> Array:
    """The motion `(3, 3)` that most of the pairs agree with."""
    motion = None
    if len(source) >= 3 * NEEDED[kind]:
        if kind == "similarity":
            motion, _ = cv2.estimateAffinePartial2D(source, target, ransacReprojThreshold=AGREE)
        elif kind == "affine":
            motion, _ = cv2.estimateAffine2D(source, target, ransacReprojThreshold=AGREE)
        else:
            motion, _ = cv2.findHomography(source, target, cv2.RANSAC, AGREE)
    if motion is None:
        return np.eye(3)
    return np.asarray(motion if len(motion) == 3 else np.vstack([motion, [0.0, 0.0, 1.0]]), dtype=np.float64)
