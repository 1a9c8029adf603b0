"""The pre-warp from sparse points: corners inside the outline, followed by pyramidal KLT, a RANSAC similarity."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np

from roam_core.arrays import Array, UInt8
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import reduced
from roam_core.geometry import similarity
from roam_core.params import KltParams, RoamParams


@dataclass(frozen=True)
class Warp:
    """A similarity `(2, 3)` from one frame to the next, how many points there were and what share agreed."""

    transform: Array
    points: int
    agreement: float


def similarity_warp(before: PreparedFrame, after: PreparedFrame, line: Array, params: RoamParams, scale: float) -> Warp:
    """How the inside of the closed polyline `line (K, 2)` moved from one frame to the next.

    With fewer than three followed points the shape is taken to stand still.
    """
    source, target, precision = followed_points(before, after, line, params, scale)
    if len(source) < 3:
        return Warp(similarity.IDENTITY.copy(), len(source), 0.0)
    transform, inliers = similarity.ransac(source, target, max(params.motion_threshold * scale, precision))
    return Warp(transform, len(source), float(inliers.mean()))


def followed_points(
    before: PreparedFrame, after: PreparedFrame, line: Array, params: RoamParams, scale: float
) -> tuple[Array, Array, float]:
    """Corners inside the closed polyline `line (K, 2)` and where they went, `(C, 2)` each, pixels.

    They are followed on a reduced copy of the region, forwards and back again; those that do not return
    (`KltParams.returned`) are dropped. The third value is the error in pixels that an agreeing point may have for that
    reason.
    """
    none = np.empty((0, 2))
    region = Region.around(line, params.motion_travel * scale, before.size)
    if region.is_empty:
        return none, none, 0.0
    reduce = min(1.0, params.motion_size / max(region.x1 - region.x0, region.y1 - region.y0))
    old, new = (reduced(frame.grey_within(region), reduce) for frame in (before, after))
    start = _corners(old, (line - np.asarray(region.origin)) * reduce, params.motion_features, params.klt)
    if len(start) < 3:
        return none, none, 0.0
    start, end = _followed(old, new, start, params.klt)
    # Pixel centres lie at half-integers in our coordinates and at integers in OpenCV's.
    source = (start + 0.5) / reduce + np.asarray(region.origin)
    target = (end + 0.5) / reduce + np.asarray(region.origin)
    return source, target, params.motion_threshold * 0.5 / reduce


def _corners(grey: UInt8, line: Array, count: int, params: KltParams) -> Array:
    """Up to `count` corners inside the polyline, spread out; a shape of few corners yields weaker ones."""
    mask = np.zeros(grey.shape, dtype=np.uint8)
    cv2.fillPoly(mask, [np.round((line - 0.5) * 16).astype(np.int32)], 255, shift=4)
    area = int(np.count_nonzero(mask))
    if area == 0:
        return np.empty((0, 2))
    distance = max(2.0, float(np.sqrt(area / count)) * params.apart)
    found = cv2.goodFeaturesToTrack(grey, count, params.quality, distance, mask=mask, blockSize=params.block)
    return np.empty((0, 2)) if found is None else found.reshape(-1, 2).astype(np.float64)


def _followed(old: UInt8, new: UInt8, start: Array, params: KltParams) -> tuple[Array, Array]:
    criteria = (cv2.TERM_CRITERIA_EPS | cv2.TERM_CRITERIA_COUNT, params.steps, params.still)
    options: dict[str, Any] = {"winSize": (params.window,) * 2, "maxLevel": params.levels, "criteria": criteria}
    points = start.astype(np.float32).reshape(-1, 1, 2)
    forward, good, _ = cv2.calcOpticalFlowPyrLK(old, new, points, None, **options)
    back, good_back, _ = cv2.calcOpticalFlowPyrLK(new, old, forward, None, **options)
    returned = np.hypot(*(back - points).reshape(-1, 2).T) < params.returned
    keep = (good.ravel() == 1) & (good_back.ravel() == 1) & returned
    return start[keep], forward.reshape(-1, 2)[keep].astype(np.float64)
