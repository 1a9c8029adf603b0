"""The dense flow peer: every control point goes where OpenCV's DIS flow goes at its place."""

from __future__ import annotations

from functools import lru_cache

import cv2
import numpy as np

from benchmarks.methods.method import Array, MovingPoints
from benchmarks.shots import Shot
from roam_core.arrays import Float32


class ContourFlow(MovingPoints):
    """Anchors and handles are carried by the dense flow between the two pictures (Kroeger et al., ECCV 2016)."""

    name = "dense flow on the contour"

    def moved(self, shot: Shot, outlines: list[Array], before: int, after: int) -> list[Array]:
        """See `MovingPoints.moved`."""
        flow = _flow(shot, before, after)
        return [points + _sampled(flow, points.reshape(-1, 2)).reshape(points.shape) for points in outlines]


@lru_cache(maxsize=200)
def _flow(shot: Shot, before: int, after: int) -> Float32:
    """Remembered, for a search for keys crosses the same frames again and again."""
    old, new = (cv2.cvtColor(shot.read(frame), cv2.COLOR_RGB2GRAY) for frame in (before, after))
    flow = cv2.DISOpticalFlow.create(cv2.DISOPTICAL_FLOW_PRESET_MEDIUM).calc(old, new, None)
    return np.asarray(flow, dtype=np.float32)


def _sampled(flow: Float32, positions: Array) -> Array:
    """The flow `(K, 2)` at positions `(K, 2)`, bilinear; beyond the border that of the border."""
    maps = (positions - 0.5).astype(np.float32)
    values = cv2.remap(flow, maps[None], None, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
    return np.asarray(values[0], dtype=np.float64)
