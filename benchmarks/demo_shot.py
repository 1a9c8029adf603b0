"""The built-in demo shot at any size: its pictures, and its true outline as a shape and as mask."""

from __future__ import annotations

from functools import lru_cache

import cv2
import numpy as np

from benchmarks.shots import Shot, matte
from resources import demo
from roam_core.arrays import Array, UInt8
from roam_core.roto import Keyframe, RotoShape

SIZES = {"480p": (854, 480), "1080p": (1920, 1080)}
"""Width and height that the demo is resized to, by name."""
LONGEST = demo.LAST - demo.FIRST + 1
"""Frames that the demo has."""


def true_points(frame: int, size: tuple[int, int] = demo.SIZE) -> Array:
    """The true outline `(16, 3, 2)` of a frame, scaled as a picture of `size` (w, h) is."""
    return demo.true_points(frame) * np.divide(size, demo.SIZE)


def true_shape(frame: int, size: tuple[int, int] = demo.SIZE) -> RotoShape:
    """A shape whose one artist key is the true outline."""
    return RotoShape("shape-1", "Demo", (Keyframe(frame, true_points(frame, size)),))


def load(size: tuple[int, int] = demo.SIZE, count: int = LONGEST) -> Shot:
    """The first `count` frames of the demo, resized to `size` (w, h)."""
    pictures = [_resized(_rendered(demo.FIRST + k), size) for k in range(count)]
    shape = (size[1], size[0])
    masks = [matte([true_shape(demo.FIRST + k, size)], demo.FIRST + k, shape) for k in range(count)]
    return Shot("demo", demo.FIRST, pictures, masks)


@lru_cache(maxsize=LONGEST)
def _rendered(frame: int) -> UInt8:
    return demo.render_frame(frame)


def _resized(picture: UInt8, size: tuple[int, int]) -> UInt8:
    if size == demo.SIZE:
        return picture
    how = cv2.INTER_AREA if size < demo.SIZE else cv2.INTER_CUBIC
    return np.asarray(cv2.resize(picture, size, interpolation=how), dtype=np.uint8)
