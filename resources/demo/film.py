"""From light to a frame of film: lens, exposure, vignette, tone curve and grain."""

from __future__ import annotations

from functools import lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray

from .noise import Image
from .timing import SIZE, Array

GRAIN_SEED = 91
_WEIGHTS = np.array([0.2126, 0.7152, 0.0722], dtype=np.float32)
_SATURATION = (1.18 * np.eye(3) - 0.18 * _WEIGHTS[:, None]).astype(np.float32)


def develop(linear: Image, gain: Array, frame: int) -> NDArray[np.uint8]:
    """The finished frame `(540, 960, 3)` RGB of linear light `(540, 960, 3)`."""
    image = _through_lens(linear) * gain.astype(np.float32) * _vignette()[..., None]
    picture = _tone(np.maximum(image @ _SATURATION, 0.0))
    picture += _grain(picture, frame)
    return np.asarray(np.clip(np.rint(picture * 255.0), 0, 255), dtype=np.uint8)


def _through_lens(image: Image) -> Image:
    """A soft lens, and a veil of light around what is bright."""
    small = cv2.resize(image, (SIZE[0] // 4, SIZE[1] // 4), interpolation=cv2.INTER_AREA)
    glow = cv2.resize(cv2.GaussianBlur(small, (0, 0), 5.0), SIZE, interpolation=cv2.INTER_LINEAR)
    return np.asarray(0.93 * cv2.GaussianBlur(image, (0, 0), 0.52) + 0.07 * glow, dtype=np.float32)


@lru_cache(maxsize=1)
def _vignette() -> Image:
    x = (np.arange(SIZE[0]) + 0.5) / SIZE[0] - 0.5
    y = ((np.arange(SIZE[1]) + 0.5) / SIZE[1] - 0.5) * SIZE[1] / SIZE[0]
    r2 = x[None, :] ** 2 + y[:, None] ** 2
    return (1.0 / (1.0 + 1.05 * r2) ** 2).astype(np.float32)


def _tone(image: Image) -> Image:
    """A film's S-curve from linear light to display values in [0, 1]: contrast in the middle, a long shoulder."""
    x = np.maximum(image, 0.0) * np.float32(2.1)
    curve = x * (x + np.float32(0.06)) / (x * (x + np.float32(0.66)) + np.float32(0.13))
    return np.asarray(np.power(curve, np.float32(1 / 2.0)), dtype=np.float32)


def _grain(picture: Image, frame: int) -> Image:
    """Grain `(540, 960, 3)`: clumps of about a pixel, strongest in the middle tones, partly common to the colours."""
    rng = np.random.default_rng([GRAIN_SEED, frame])
    noise = rng.standard_normal((SIZE[1], SIZE[0], 2), dtype=np.float32)
    noise = cv2.GaussianBlur(noise, (0, 0), 0.55)
    luma = picture @ _WEIGHTS
    amplitude = 0.007 + 0.058 * np.sqrt(np.maximum(luma, 0.0)) * np.maximum(1.0 - luma, 0.0)
    common, colour = noise[..., 0] * amplitude, noise[..., 1] * (np.float32(0.4) * amplitude)
    return np.asarray(cv2.merge([common + colour, common - np.float32(0.5) * colour, common - colour]))
