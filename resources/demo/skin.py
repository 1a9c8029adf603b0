"""The manta's back, built once in its rest pose: colour and relief. Linear light."""

from __future__ import annotations

from functools import lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray

from .ground import mixed
from .noise import Image, fractal
from .timing import Array, smoothstep

SCALE = 240.0
"""Texture pixels per half wing span: finer than the plate, so that the manta stays sharp when it is near."""

ORIGIN = np.array([-1.0, -1.2])
"""Rest position of the texture's first corner; its columns run along the body, its rows across it."""

_SHAPE = (576, 420)


def texture_positions(rest: Array) -> Array:
    """Pixel indices (column, row) `(..., 2)` in the textures of rest positions `(..., 2)`."""
    return np.asarray((rest - ORIGIN) * SCALE - 0.5)


def _rest_grid() -> tuple[Array, Array]:
    row, column = np.mgrid[: _SHAPE[0], : _SHAPE[1]]
    return (column + 0.5) / SCALE + ORIGIN[0], (row + 0.5) / SCALE + ORIGIN[1]


@lru_cache(maxsize=1)
def colour() -> Image:
    """Albedo `(H, W, 3)`: slate with mottles, pale shoulder patches, speckles and old scratches."""
    u, v = _rest_grid()
    w = np.abs(v)
    image = np.broadcast_to(np.array([0.044, 0.050, 0.056], dtype=np.float32), (*_SHAPE, 3))
    image = image * (1.0 + 0.26 * fractal(_SHAPE, 70, 5, 51, 0.6)[..., None])
    image = image * (1.0 + 0.12 * fractal(_SHAPE, 5, 3, 52, 0.8)[..., None])

    # Shoulder patches: a wedge behind the head on each side, frayed towards the back.
    ragged = 0.022 * fractal(_SHAPE, 34, 5, 53, 0.62)
    ahead = smoothstep(0.0, 0.035, 0.315 - 0.42 * (w - 0.2) - u + 0.6 * ragged)
    behind = smoothstep(0.0, 0.075, u - (0.02 + 0.30 * np.abs(w - 0.30)) + 1.5 * ragged)
    inner = smoothstep(0.0, 0.045, w - 0.115 - 0.20 * np.maximum(0.22 - u, 0.0) + ragged)
    image = mixed(image, (0.46, 0.45, 0.41), 0.86 * ahead * behind * inner)

    # Paler, browner wing tips and trailing edges, the head a little darker.
    image = mixed(image, (0.110, 0.105, 0.092), 0.65 * smoothstep(0.70, 1.02, w + 0.8 * ragged))
    image = mixed(image, (0.095, 0.092, 0.084), 0.50 * smoothstep(-0.12, -0.30, u + 0.22 * w + 2.0 * ragged))
    image = mixed(image, (0.035, 0.040, 0.045), 0.55 * smoothstep(0.30, 0.42, u + 1.2 * ragged))
    image = mixed(image, (0.040, 0.044, 0.050), 0.60 * np.exp(-((v / 0.035) ** 2)) * smoothstep(0.35, 0.1, u))
    image = _speckled(image)
    return np.clip(image, 0.004, 1.0).astype(np.float32)


def _speckled(image: NDArray[np.floating]) -> Image:
    """Pale and dark speckles and a few thin scratches over an albedo."""
    rng = np.random.default_rng(54)
    dark, pale = np.zeros(_SHAPE, dtype=np.float32), np.zeros(_SHAPE, dtype=np.float32)
    shift = 4
    for layer, count, radii in ((dark, 70, (1.5, 6.0)), (pale, 90, (1.0, 3.6))):
        for _ in range(count):
            x, y = rng.uniform(0.05, 0.95, 2) * (_SHAPE[1], _SHAPE[0])
            a = rng.uniform(*radii)
            axes = (int(a * 16), int(a * rng.uniform(0.5, 1.0) * 16))
            centre = (int(x * 16), int(y * 16))
            cv2.ellipse(layer, centre, axes, rng.uniform(0, 180), 0, 360, rng.uniform(0.4, 1.0), -1, cv2.LINE_8, shift)
    for _ in range(9):
        start = rng.uniform(0.2, 0.8, 2) * (_SHAPE[1], _SHAPE[0])
        angle, bow = rng.uniform(0.0, 2 * np.pi), rng.uniform(-0.012, 0.012)
        steps = np.arange(0.0, rng.uniform(35.0, 110.0), 3.0)
        turn = angle + bow * steps
        line = start + 3.0 * np.cumsum(np.stack([np.cos(turn), np.sin(turn)], axis=1), axis=0)
        cv2.polylines(pale, [np.round(line * 16).astype(np.int32)], False, 0.6, 1, cv2.LINE_8, shift)
    dark, pale = cv2.GaussianBlur(dark, (0, 0), 1.0), cv2.GaussianBlur(pale, (0, 0), 0.8)
    return mixed(mixed(image, (0.020, 0.022, 0.026), 0.7 * dark), (0.36, 0.36, 0.33), 0.62 * pale)


@lru_cache(maxsize=1)
def relief() -> Image:
    """Slope `(H, W, 2)` of the back along u and v: body, shoulders, spine, fin rays and the skin's roughness."""
    u, v = _rest_grid()
    w = np.abs(v)
    trunk = 0.215 * np.exp(-((v / 0.20) ** 2) - ((u + 0.02) / 0.42) ** 2)
    lobes = 0.030 * np.exp(-(((w - 0.16) / 0.06) ** 2) - ((u - 0.46) / 0.12) ** 2)
    spine = 0.016 * np.exp(-((v / 0.03) ** 2)) * smoothstep(0.3, 0.0, u)
    fan = np.arctan2(w, 0.9 - u)
    rays = 0.0011 * np.sin(130.0 * fan + 1.2 * fractal(_SHAPE, 90, 3, 61)) * smoothstep(0.28, 0.6, w)
    folds = 0.008 * fractal(_SHAPE, 60, 3, 62) + 0.0018 * fractal(_SHAPE, 12, 4, 63, 0.7)
    height = (trunk + lobes + spine + rays + folds).astype(np.float32)
    slopes = [cv2.Sobel(height, cv2.CV_32F, dx, dy, ksize=3, scale=SCALE / 8) for dx, dy in ((1, 0), (0, 1))]
    return np.dstack(slopes).astype(np.float32)
