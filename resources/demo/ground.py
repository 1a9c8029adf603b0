"""The sea bed, built once: rippled sand below, and boulders grown over with algae above it. Linear light."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray

from .noise import Image, fractal
from .timing import SIZE, smoothstep

MARGIN = (190, 120)
"""How far the textures reach past the plate on each side, in pixels: the room for the camera's travel."""

GROUND_SIZE = (SIZE[0] + 2 * MARGIN[0], SIZE[1] + 2 * MARGIN[1])

SUN = np.array([-0.52, -0.46, 0.72]) / np.linalg.norm([-0.52, -0.46, 0.72])
"""Direction towards the light: from the upper left, towards the camera."""

Places = Sequence[tuple[float, float, float]]

_PLACED: Places = ((592.0, 612.0, 66.0), (508.0, 585.0, 40.0), (652.0, 668.0, 46.0), (548.0, 668.0, 24.0))
"""Boulders under the right wing in the first half of the shot: its slate edge has to be told from theirs."""

_SHAPE = (GROUND_SIZE[1], GROUND_SIZE[0])


def lit(height: Image, ambient: float) -> Image:
    """Light `(H, W)` on a height field in pixels: the sun by its normals, and the water's diffuse glow."""
    gx = cv2.Sobel(height, cv2.CV_32F, 1, 0, ksize=3, scale=1 / 8)
    gy = cv2.Sobel(height, cv2.CV_32F, 0, 1, ksize=3, scale=1 / 8)
    facing = (SUN[2] - gx * SUN[0] - gy * SUN[1]) / np.sqrt(1.0 + gx * gx + gy * gy)
    return np.asarray(ambient + (1.0 - ambient) * np.maximum(facing, 0.0) / SUN[2], dtype=np.float32)


def mixed(base: NDArray[np.floating], colour: tuple[float, float, float], share: NDArray[np.floating]) -> Image:
    """`base (H, W, 3)` with `colour` laid over it by `share (H, W)`."""
    return np.asarray(base + share[..., None] * (np.array(colour) - base), dtype=np.float32)


@lru_cache(maxsize=1)
def sand() -> Image:
    """The sand `(H, W, 3)`: ripples bent by the swell, coarse grains, rubble and turf. A little out of focus."""
    y, x = np.mgrid[: _SHAPE[0], : _SHAPE[1]].astype(np.float32)
    warp = fractal(_SHAPE, 170, 3, 11)
    ripple = np.sin((0.35 * x + 0.94 * y) * (2 * np.pi / 27.0) + 2.3 * warp)
    strength = smoothstep(-1.0, 0.9, fractal(_SHAPE, 260, 2, 12)).astype(np.float32)
    dunes = fractal(_SHAPE, 120, 5, 13)
    height = 3.0 * strength * (ripple + 0.3 * ripple * ripple) + 3.2 * dunes + 0.8 * fractal(_SHAPE, 7, 3, 14, 0.8)

    colour = np.broadcast_to(np.array([0.385, 0.335, 0.245], dtype=np.float32), (*_SHAPE, 3))
    colour = colour * (1.0 + 0.10 * fractal(_SHAPE, 60, 5, 15)[..., None])
    turf = smoothstep(0.35, 1.5, fractal(_SHAPE, 150, 6, 16, 0.62))
    colour = mixed(colour, (0.070, 0.085, 0.045), 0.80 * turf)
    colour = colour * (1.0 + 0.13 * fractal(_SHAPE, 3, 2, 17)[..., None])

    pebbles, tint = _stones(420, (2.0, 9.5), 18)
    inside = smoothstep(0.2, 1.6, pebbles)
    cast = cv2.GaussianBlur(_thrown(inside, (3, 3)), (0, 0), 1.6)
    colour = colour * (1.0 - 0.55 * cast * (1.0 - inside))[..., None]
    stone = np.array([0.30, 0.26, 0.21]) * (0.25 + 1.25 * tint)[..., None]
    colour = colour + inside[..., None] * (stone - colour)
    image = colour * lit(height + 1.3 * pebbles, 0.42)[..., None]
    return np.asarray(cv2.GaussianBlur(np.clip(image, 0.0, 1.0).astype(np.float32), (0, 0), 0.9))


@lru_cache(maxsize=1)
def reef() -> Image:
    """The boulders, `(H, W, 4)` premultiplied: what they hide and the shadow that they throw on the sand."""
    domes, tint = _stones(84, (13.0, 92.0), 31, clusters=7, placed=_PLACED)
    rough = fractal(_SHAPE, 34, 6, 32, 0.58)
    cracks = np.exp(-((fractal(_SHAPE, 62, 4, 33) / 0.055) ** 2))
    present = smoothstep(0.0, 2.4, domes + 2.0 * fractal(_SHAPE, 9, 3, 34) * (domes > 0.0))
    height = np.sqrt(np.maximum(domes, 0.0)) * 6.2 + 2.1 * rough - 3.2 * cracks

    # Slate not unlike the manta's back: along the boulders its edge has to be found by texture and light.
    colour = np.array([0.150, 0.112, 0.096], dtype=np.float32) * (0.55 + 0.95 * tint)[..., None]
    colour = colour * (1.0 + 0.22 * fractal(_SHAPE, 22, 5, 35)[..., None])
    colour = mixed(colour, (0.120, 0.128, 0.048), 0.75 * smoothstep(0.2, 1.5, fractal(_SHAPE, 85, 6, 36, 0.6)))
    colour = mixed(colour, (0.330, 0.140, 0.140), 0.70 * smoothstep(1.15, 1.9, fractal(_SHAPE, 48, 5, 37, 0.6)))
    colour = mixed(colour, (0.330, 0.300, 0.225), 0.55 * smoothstep(0.9, 2.0, fractal(_SHAPE, 16, 4, 38, 0.7)))
    colour = colour * (1.0 - 0.55 * cracks)[..., None]

    hollow = np.clip((cv2.GaussianBlur(height, (0, 0), 11) - height) / 16.0, 0.0, 0.75)
    colour = colour * (lit(height, 0.30) * (1.0 - hollow))[..., None]

    shadow = np.zeros(_SHAPE, dtype=np.float32)
    for throw, blur in ((7, 3.0), (15, 6.0), (25, 9.0)):
        shadow = np.maximum(shadow, cv2.GaussianBlur(_thrown(present, (throw, throw)), (0, 0), blur))
    solid = present.astype(np.float32)
    alpha = solid + (1.0 - solid) * 0.66 * shadow
    image = np.dstack([np.clip(colour, 0.0, 1.0) * solid[..., None], alpha]).astype(np.float32)
    return np.asarray(cv2.GaussianBlur(image, (0, 0), 0.8))


def _thrown(mask: NDArray[np.floating], offset: tuple[int, int]) -> Image:
    """A mask moved by whole pixels (x, y), away from the sun."""
    return np.roll(np.asarray(mask, dtype=np.float32), offset[::-1], axis=(0, 1))


def _stones(
    count: int, radii: tuple[float, float], seed: int, clusters: int = 0, placed: Places = ()
) -> tuple[Image, Image]:
    """Heights `(H, W)` of stones strewn over the ground, 0 between them, and a brightness in [0, 1] for each stone.

    Parameters
    ----------
    radii : smallest and largest radius in pixels; small ones are many.
    clusters : gather the stones around this many places; 0 strews them evenly.
    placed : (x, y, radius) of stones that must be there beside the strewn ones.
    """
    rng = np.random.default_rng(seed)
    rows, columns = _SHAPE
    heights = np.zeros(_SHAPE, dtype=np.float32)
    tint = np.full(_SHAPE, 0.5, dtype=np.float32)
    bumps = fractal(_SHAPE, max(radii[1] * 0.8, 6.0), 5, seed + 1000)
    places = rng.uniform(0.0, 1.0, (max(clusters, 1), 2)) * (columns, rows)
    for index in range(-len(placed), count):
        radius = radii[0] * (radii[1] / radii[0]) ** (rng.uniform() ** 1.7)
        aspect, angle, brightness = rng.uniform(0.62, 1.0), rng.uniform(0.0, np.pi), rng.uniform()
        if index < 0:
            x, y, radius = placed[index]
        elif clusters:
            x, y = places[rng.integers(clusters)] + rng.standard_normal(2) * (150.0, 95.0)
        else:
            x, y = rng.uniform(0.0, 1.0, 2) * (columns, rows)
        reach = int(1.5 * radius) + 3
        left, top = max(int(x) - reach, 0), max(int(y) - reach, 0)
        window = np.s_[top : max(int(y) + reach, 0), left : max(int(x) + reach, 0)]
        if heights[window].size == 0:
            continue
        dy, dx = np.indices(heights[window].shape, dtype=np.float32)
        dx, dy = dx + np.float32(left - x), dy + np.float32(top - y)
        c, s = np.cos(angle), np.sin(angle)
        distance = np.hypot((dx * c + dy * s) / radius, (dy * c - dx * s) / (radius * aspect))
        distance = distance + 0.13 * bumps[window]
        dome = radius * 0.62 * np.sqrt(np.maximum(1.0 - np.maximum(distance, 0.0) ** 2.4, 0.0))
        higher = dome > heights[window]
        heights[window] = np.where(higher, dome, heights[window])
        tint[window] = np.where(higher, brightness, tint[window])
    return heights, tint
