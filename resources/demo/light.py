"""Light that changes with time: exposure and tint, a cloud's shadow, and the caustics of the waves above."""

from __future__ import annotations

from functools import lru_cache

import cv2
import numpy as np

from .noise import Image, cell_walls, fractal
from .timing import FIRST, SIZE, Array, progress, smoothstep

_TILE = 512
_COARSE = 3
"""Caustics and cloud are soft: they are made on every third pixel and enlarged."""


def exposure(frame: float) -> Array:
    """Gain `(3,)` of red, green and blue: the day darkens by half a stop and turns from warm to cool."""
    p = float(progress(frame))
    stops = 0.30 - 0.52 * p + 0.05 * np.sin(5.0 * p)
    tint = np.array([0.045, 0.0, -0.040]) * (1.0 - 2.0 * p)
    return np.asarray(2.0**stops * (1.0 + tint))


@lru_cache(maxsize=1)
def _wave_tile() -> Image:
    """One tile of caustics with mean about 1: bright threads where the walls of warped cells run."""
    walls = cell_walls(_TILE, 7, 71)
    axis = np.arange(_TILE) * (2 * np.pi / _TILE)
    x, y = np.meshgrid(axis, axis)
    column = (np.arange(_TILE)[None, :] + 9.0 * np.sin(2 * y + 1.0) + 6.0 * np.sin(3 * y + 2 * x)).astype(np.float32)
    row = (np.arange(_TILE)[:, None] + 9.0 * np.sin(2 * x + 0.4) + 6.0 * np.cos(3 * x - y)).astype(np.float32)
    bent = cv2.remap(walls, column, row, cv2.INTER_LINEAR, borderMode=cv2.BORDER_WRAP)
    threads = np.exp(-bent / 0.10) + 0.55 * np.exp(-bent / 0.32)
    return np.asarray(threads / threads.mean(), dtype=np.float32)


def _scrolled(offset: Array, scale: float) -> Image:
    """The tile on the coarse plate, moved by `offset` plate pixels and enlarged by `scale`."""
    step = _COARSE / scale
    width, height = SIZE[0] // _COARSE, SIZE[1] // _COARSE
    matrix = np.array([[step, 0.0, -offset[0] / scale], [0.0, step, -offset[1] / scale]])
    flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    tile = cv2.warpAffine(_wave_tile(), matrix, (width, height), flags=flags, borderMode=cv2.BORDER_WRAP)
    return np.asarray(tile, dtype=np.float32)


def caustics(frame: float, anchor: Array, strength: float) -> Image:
    """Light of the waves `(540, 960)` around 1: where two drifting nets of threads meet.

    Parameters
    ----------
    anchor : (2,) plate position of a point of the surface that the light falls on; the nets drift relative to it.
    strength : 0 for even light, 1 for a calm day at little depth.
    """
    t = frame - FIRST
    one = _scrolled(anchor + t * np.array([0.9, 0.5]), 0.78)
    two = _scrolled(anchor + t * np.array([-0.7, 0.8]) + 173.0, 0.61)
    net = np.sqrt(one * two)
    net = cv2.GaussianBlur(1.0 + strength * (net - 0.92), (0, 0), 0.9)
    return np.asarray(cv2.resize(net, SIZE, interpolation=cv2.INTER_CUBIC), dtype=np.float32)


@lru_cache(maxsize=1)
def _cloud() -> Image:
    """A soft-edged shadow, twice as wide as the coarse plate: 0 in the light, 1 in the shade."""
    shape = (SIZE[1] // _COARSE, 2 * SIZE[0] // _COARSE)
    noise = fractal(shape, 120.0, 3, 72, 0.4)
    ramp = (np.arange(shape[1]) / shape[1] - 0.5) * 5.0
    return smoothstep(-0.9, 1.1, -ramp[None, :] + 0.7 * noise).astype(np.float32)


def cloud(frame: float) -> Image:
    """Factor `(540, 960)` of a cloud whose shadow comes in from the left and reaches the middle in the end."""
    width, height = SIZE[0] // _COARSE, SIZE[1] // _COARSE
    x = width * (1.08 - 0.72 * float(progress(frame)))
    matrix = np.array([[1.0, 0.0, x], [0.0, 1.0, 0.0]])
    flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    part = cv2.warpAffine(_cloud(), matrix, (width, height), flags=flags, borderMode=cv2.BORDER_REPLICATE)
    shade = cv2.resize(part, SIZE, interpolation=cv2.INTER_CUBIC)
    return np.asarray(1.0 - 0.34 * shade, dtype=np.float32)
