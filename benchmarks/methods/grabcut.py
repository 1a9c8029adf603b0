"""The naive peer of the paper: a box followed by a correlation filter, and GrabCut inside it."""

from __future__ import annotations

from collections.abc import Iterator

import cv2
import numpy as np

from benchmarks.methods.correlation import BoxTracker
from benchmarks.methods.method import Shapes, living
from benchmarks.shots import Shot, matte
from roam_core.arrays import Bools, Float32, UInt8

MARGIN = 0.1
"""By how much of its side the box is widened: what lies beyond is surely background."""
ROUNDS = 3
"""Rounds of GrabCut."""
CORE = 0.2
"""Depth inside the object, as a share of the greatest depth, from which a pixel is taken for the object's at first."""


class GrabCut:
    """Rother et al., SIGGRAPH 2004, begun from the last mask as the tracker (Henriques et al., 2015) shifts it."""

    name = "GrabCut and box tracker"

    def carry(self, shot: Shot, shapes: Shapes, frames: range) -> Iterator[Bools]:
        """See `Method.carry`."""
        key = matte(living(shapes, frames[0]), frames[0], shot.size)
        if not key.any():
            for _ in frames[1:]:
                yield key
            return
        rows, columns = np.flatnonzero(key.any(axis=1)), np.flatnonzero(key.any(axis=0))
        box = float(columns[0]), float(rows[0]), float(columns[-1] + 1), float(rows[-1] + 1)
        tracker = BoxTracker(_grey(shot, frames[0]), box)
        mask = key
        for frame in frames[1:]:
            shift = tracker.step(_grey(shot, frame))
            mask = _cut(shot.read(frame), _shifted(mask, shift), tracker.box)
            yield mask

    def fill(self, shot: Shot, shapes: Shapes, start: int, stop: int) -> list[Bools]:
        """See `Method.fill`: each half from its own key."""
        middle = (start + stop) // 2
        ahead = list(self.carry(shot, shapes, range(start, middle + 1)))
        behind = list(self.carry(shot, shapes, range(stop, middle, -1)))
        return ahead + behind[::-1]


def _grey(shot: Shot, frame: int) -> Float32:
    return np.asarray(cv2.cvtColor(shot.read(frame), cv2.COLOR_RGB2GRAY), dtype=np.float32)


def _shifted(mask: Bools, shift: tuple[float, float]) -> Bools:
    height, width = mask.shape
    motion = np.array([[1.0, 0.0, shift[0]], [0.0, 1.0, shift[1]]])
    return np.asarray(cv2.warpAffine(mask.astype(np.uint8), motion, (width, height), flags=cv2.INTER_NEAREST) > 0)


def _cut(picture: UInt8, guess: Bools, box: tuple[float, float, float, float]) -> Bools:
    """GrabCut inside the box; `guess` where the box has left the picture or nothing of the object is expected."""
    height, width = guess.shape
    x0, y0, x1, y1 = box
    wide, high = MARGIN * (x1 - x0), MARGIN * (y1 - y0)
    columns = slice(max(int(x0 - wide), 0), min(int(np.ceil(x1 + wide)), width))
    rows = slice(max(int(y0 - high), 0), min(int(np.ceil(y1 + high)), height))
    inside = guess[rows, columns]
    if inside.size == 0 or not inside.any() or inside.all():
        return guess
    depth = cv2.distanceTransform(inside.astype(np.uint8), cv2.DIST_L2, 3)
    labels = np.full(guess.shape, cv2.GC_BGD, dtype=np.uint8)
    labels[rows, columns] = np.where(inside, cv2.GC_PR_FGD, cv2.GC_PR_BGD)
    labels[rows, columns][depth > CORE * depth.max()] = cv2.GC_PR_FGD
    cv2.setRNGSeed(0)  # its first mixtures come from k-means
    cv2.grabCut(np.ascontiguousarray(picture), labels, None, None, None, ROUNDS, cv2.GC_INIT_WITH_MASK)
    return np.asarray((labels == cv2.GC_FGD) | (labels == cv2.GC_PR_FGD))
