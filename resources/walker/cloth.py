"""What the figure and the world behind it look like: cloth, skin and a street, all from seeded noise. 0 to 255."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from ..demo.noise import Image, fractal
from ..demo.timing import Array, smoothstep

TILE = 360
"""Pixels of a side of a cloth: more than any part is long."""

SKINS = ((206, 160, 132), (172, 122, 92), (116, 80, 62), (226, 186, 160))
SHIRTS = ((146, 62, 58), (62, 98, 142), (176, 150, 84), (84, 124, 84), (150, 150, 156))
TROUSERS = ((66, 76, 106), (104, 92, 76), (70, 70, 72), (122, 104, 84))
WALLS = ((168, 158, 142), (150, 110, 92), (128, 136, 132), (186, 172, 138))

Colour = tuple[int, int, int]


def shirt(colour: Colour, seed: int) -> Image:
    """Checked, striped or mottled cloth `(TILE, TILE, 3)`, worn and creased."""
    rng = np.random.default_rng(seed)
    y, x = np.mgrid[:TILE, :TILE].astype(np.float32)
    warp = 3.0 * fractal((TILE, TILE), 90, 3, seed + 1)
    pitch = rng.uniform(17.0, 26.0)
    bars = [np.sin(2.0 * np.pi * (axis + warp) / pitch + rng.uniform(0.0, 6.0)) for axis in (x, y)]
    kind = rng.integers(3)
    pattern: NDArray[np.floating]
    if kind == 0:
        pattern = 20.0 * smoothstep(0.2, 0.6, bars[0]) + 20.0 * smoothstep(0.3, 0.7, bars[1]) - 14.0
    elif kind == 1:
        pattern = 34.0 * smoothstep(-0.2, 0.3, bars[1]) - 17.0
    else:
        pattern = 34.0 * smoothstep(-0.1, 0.25, fractal((TILE, TILE), 34, 3, seed + 2)) - 17.0
    return _worn(colour, pattern, seed)


def trousers(colour: Colour, seed: int) -> Image:
    """Twill `(TILE, TILE, 3)`: fine diagonal threads, faded in patches."""
    y, x = np.mgrid[:TILE, :TILE].astype(np.float32)
    threads = 5.0 * np.sin(2.0 * np.pi * (x + 0.6 * y) / 4.3)
    faded = 17.0 * smoothstep(-0.6, 1.4, fractal((TILE, TILE), 60, 4, seed + 2, 0.6)) - 8.0
    return _worn(colour, threads + faded, seed)


def skin(colour: Colour, seed: int) -> Image:
    """Skin `(TILE, TILE, 3)`: nearly even, with moles."""
    image = np.array(colour, dtype=np.float32) + 5.0 * fractal((TILE, TILE), 30, 4, seed, 0.6)[..., None]
    spots = smoothstep(2.4, 2.9, fractal((TILE, TILE), 7, 1, seed + 1))
    return np.asarray(image - 46.0 * spots[..., None], dtype=np.float32)


def _worn(colour: Colour, pattern: NDArray[np.floating], seed: int) -> Image:
    """A colour with a pattern, creases and threads of light and dark."""
    creases = 11.0 * fractal((TILE, TILE), 48, 4, seed + 3, 0.55) + 5.0 * fractal((TILE, TILE), 4, 2, seed + 4)
    light = 1.0 + (pattern + creases) / 115.0
    return np.asarray(np.array(colour, dtype=np.float32) * light[..., None], dtype=np.float32)


def street(size: tuple[int, int], kerb: float, rng: np.random.Generator) -> Image:
    """The world behind the figure `(h, w, 3)`: a wall of courses with doors and bills on it, and slabs below `kerb`."""
    width, height = size
    seed = int(rng.integers(1 << 30))
    y, x = np.mgrid[:height, :width].astype(np.float32)
    wall = np.array(WALLS[rng.integers(len(WALLS))], dtype=np.float32)
    image = np.broadcast_to(wall, (height, width, 3)) + 9.0 * fractal((height, width), 130, 6, seed, 0.62)[..., None]
    course, brick = rng.uniform(20.0, 27.0), rng.uniform(50.0, 70.0)
    row = np.floor(y / course)
    shifted = x + 0.5 * brick * (row % 2)
    tone = np.random.default_rng(seed + 1).normal(0.0, 11.0, (int(row.max()) + 1, int(width / brick) + 3))
    image = image + tone[row.astype(int), (shifted / brick).astype(int)][..., None]
    joints = np.minimum(
        np.minimum(y % course, course - y % course), np.minimum(shifted % brick, brick - shifted % brick)
    )
    image = image * (0.74 + 0.26 * smoothstep(0.4, 1.9, joints))[..., None]
    image = _hung(np.asarray(image, dtype=np.float32), kerb, rng)
    return _paved(image, kerb, seed)


def _hung(image: Image, kerb: float, rng: np.random.Generator) -> Image:
    """Doors and bills of the colours that figures wear: not all that is red is a shirt."""
    for _ in range(15):
        colour = np.array((*SHIRTS, *TROUSERS, *SKINS)[rng.integers(len(SHIRTS) + len(TROUSERS) + len(SKINS))])
        wide, high = rng.uniform(26, 110), rng.uniform(50, 190)
        left, bottom = rng.uniform(0, image.shape[1] - wide), kerb - rng.uniform(0, kerb - high)
        box = np.s_[int(bottom - high) : int(bottom), int(left) : int(left + wide)]
        grain = fractal((image[box].shape[0], image[box].shape[1]), 24, 4, int(rng.integers(1 << 30)), 0.6)
        image[box] = colour * rng.uniform(0.7, 1.05) + 10.0 * grain[..., None]
        x0, y0, x1, y1 = int(left), int(bottom - high), int(left + wide), int(bottom)
        cv2.rectangle(image, (x0, y0), (x1, y1), (52.0, 48.0, 46.0), 2, cv2.LINE_8)
    return image


def _paved(image: Image, kerb: float, seed: int) -> Image:
    """Slabs below the kerb, nearer ones larger."""
    height, width = image.shape[:2]
    y, x = np.mgrid[:height, :width].astype(np.float32)
    near = np.maximum(y - kerb, 0.0) / max(height - kerb, 1.0)
    slabs = np.array((132.0, 130.0, 126.0)) + 10.0 * fractal((height, width), 40, 6, seed + 5, 0.7)[..., None]
    joints = np.minimum(np.abs(np.sin(np.pi * x / 74.0)) * 74.0 / np.pi, 9.0 * np.abs(np.sin(np.pi * 5.0 * near**0.6)))
    slabs = slabs * (0.72 + 0.28 * smoothstep(0.5, 2.2, joints))[..., None] * (0.8 + 0.25 * near)[..., None]
    step = smoothstep(0.0, 3.0, y - kerb)[..., None]
    return np.asarray((1.0 - step) * image + step * slabs, dtype=np.float32)


def shade(across: Array, far: bool) -> Array:
    """Light on a round limb by its place `across` it, -1 to 1: it comes from the front, and less of it to the far side.

    It follows the part, as the light of an overcast street does near enough.
    """
    bulge = np.sqrt(np.clip(1.0 - 0.85 * np.clip(across + 0.22, -1.0, 1.0) ** 2, 0.0, 1.0))
    return np.asarray((0.60 + 0.40 * bulge) * (0.84 if far else 1.0))
