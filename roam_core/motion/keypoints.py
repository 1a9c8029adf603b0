"""Keypoints of a picture and what is around each (SIFT: Lowe, IJCV 2004), known again on another picture.

What comes out from behind something is seen in part, and to its colours a part of it looks like a smaller one.
Keypoints tell place and size all the same: those that are in sight agree on them.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from roam_core.arrays import Array, Bools, Float32
from roam_core.features import PreparedFrame
from roam_core.features.grid import Grid
from roam_core.geometry import similarity
from roam_core.params.redetection import KeypointParams


@dataclass(frozen=True, eq=False)
class Keypoints:
    """`places (K, 2)` in the image, pixels, and the `descriptors (K, 128)` of what is around them."""

    places: Array
    descriptors: Float32

    @classmethod
    def of(cls, frame: PreparedFrame, grid: Grid, inside: Bools | None = None) -> Keypoints:
        """Those of a frame in the cells of `grid`, or of those that are `inside (rows, columns)`."""
        mask = None if inside is None else inside.astype(np.uint8)
        found, descriptors = cv2.SIFT.create().detectAndCompute(grid.grey_of(frame), mask)
        if not found:
            return cls(np.empty((0, 2)), np.empty((0, 128), np.float32))
        cells = np.array([each.pt for each in found], np.float64) + 0.5  # OpenCV counts from the middle of a pixel
        return cls(grid.to_image(cells), np.asarray(descriptors, np.float32))

    def similarity_to(self, other: Keypoints, near: float, params: KeypointParams) -> Array | None:
        """The similarity `(3, 3)` by which enough of them lie where `other` ones look alike; None where there is none.

        They look alike where the next best one of the others is clearly less alike. `near`: pixels by which they may
        miss it.
        """
        if len(other.places) < 2:
            return None
        pairs = [
            (best.queryIdx, best.trainIdx)
            for best, second in cv2.BFMatcher().knnMatch(self.descriptors, other.descriptors, 2)
            if best.distance < params.clearly * second.distance
        ]
        if len(pairs) < params.fewest:
            return None
        ours, theirs = np.array(pairs).T
        transform, agree = similarity.ransac(self.places[ours], other.places[theirs], near, params.trials)
        if np.count_nonzero(agree) < params.fewest:
            return None
        return np.vstack([transform, [0.0, 0.0, 1.0]])
