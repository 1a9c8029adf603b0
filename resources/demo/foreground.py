"""What passes in front: a few quick fish between camera and manta, out of focus, and drifting specks in the water."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from . import body, camera
from .noise import Image
from .timing import FIRST, SIZE, smoothstep

MEETING = 1027.0
"""The moment at which the school is in the middle of its crossing."""

VELOCITY = np.array([-27.0, 31.0])
"""Of the school on the plate, in pixels per frame."""

SOFTNESS = 2.6
"""Half width in pixels of the edges' defocus: the fish are nearer than the focus."""

# Of each fish: place relative to the school's middle (behind it, beside it) and length in pixels, phase of its tail
# beat, and by how many degrees it points off the school's course.
_SCHOOL = ((0.0, 0.0, 156.0, 0.0, -3.0), (24.0, 52.0, 134.0, 2.0, 7.0), (62.0, -40.0, 126.0, 4.1, -9.0))


@dataclass(frozen=True)
class Layer:
    """A piece of picture to lay over the plate: `colour (h, w, 3)` linear light, `alpha (h, w)`, at (left, top)."""

    colour: Image
    alpha: Image
    left: int
    top: int

    @property
    def window(self) -> tuple[slice, slice]:
        rows, columns = self.alpha.shape
        return np.s_[self.top : self.top + rows, self.left : self.left + columns]


def school(frame: float) -> list[Layer]:
    """The fish that are on the plate at `frame`, farthest first."""
    layers = (_fish(frame, *row) for row in reversed(_SCHOOL))
    return [layer for layer in layers if layer is not None]


def _fish(frame: float, behind: float, beside: float, length: float, phase: float, off: float) -> Layer | None:
    course = VELOCITY / np.hypot(*VELOCITY)
    across = np.array([-course[1], course[0]])
    start = body.surface(np.array([0.02, -0.10]), MEETING)[:2]
    centre = start + (frame - MEETING) * VELOCITY - behind * course + beside * across
    turn = np.radians(off)
    forward, aside = course * np.cos(turn) + across * np.sin(turn), across * np.cos(turn) - course * np.sin(turn)
    reach = 0.62 * length
    low = np.maximum(np.floor(centre - reach), 0).astype(int)
    high = np.minimum(np.ceil(centre + reach), SIZE).astype(int)
    if (low >= high).any():
        return None
    y, x = np.mgrid[low[1] : high[1], low[0] : high[0]].astype(np.float32) + np.float32(0.5)
    dx, dy = x - np.float32(centre[0]), y - np.float32(centre[1])
    # s runs from the snout (0) to the end of the tail (1); c is the distance from the swimming spine.
    s = 0.5 - (dx * np.float32(forward[0]) + dy * np.float32(forward[1])) / np.float32(length)
    bend = np.sin(7.0 * s - 1.1 * (frame - FIRST) + phase) * 0.034 * smoothstep(0.1, 1.0, s)
    c = (dx * np.float32(aside[0]) + dy * np.float32(aside[1])) / np.float32(length) - bend
    width = _half_width(s)
    inside = (width - np.abs(c)) * length
    alpha = smoothstep(-SOFTNESS, SOFTNESS, inside) * (s > -0.02) * (s < 1.02)
    return Layer(_scales(s, c, width), alpha.astype(np.float32), int(low[0]), int(low[1]))


def _half_width(s: NDArray[np.floating]) -> NDArray[np.floating]:
    """Half width over length along the fish, seen from above: a spindle, two breast fins, and a forked tail."""
    s = np.clip(s, 0.0, 1.0)
    spindle = 0.175 * np.sqrt(np.maximum(4.0 * s * (1.0 - s), 0.0)) * (1.0 - 0.86 * s)
    fins = 0.060 * np.exp(-(((s - 0.34) / 0.04) ** 2))
    tail = 0.085 * smoothstep(0.84, 0.95, s) * smoothstep(1.0, 0.96, s)
    return np.asarray(spindle + fins + tail)


def _scales(s: NDArray[np.floating], c: NDArray[np.floating], width: NDArray[np.floating]) -> Image:
    """Colour of a fish: dark olive back, bars, silver flanks that turn away from the sun."""
    rim = np.clip(np.abs(c) / np.maximum(width, 1e-3), 0.0, 1.0)
    side = np.clip(c / np.maximum(width, 1e-3), -1.0, 1.0)
    bars = 0.5 + 0.5 * np.sin(44.0 * s)
    shade = 0.62 + 0.38 * np.sqrt(1.0 - 0.9 * rim * rim) - 0.28 * side
    back, flank = np.array([0.045, 0.072, 0.076]), np.array([0.25, 0.31, 0.31])
    share = (smoothstep(0.25, 1.0, rim) * (1.0 - 0.35 * bars) + 0.10 * bars)[..., None]
    return np.asarray((back + share * (flank - back)) * shade[..., None], dtype=np.float32)


# ---- specks ----------------------------------------------------------------------------------------------------------

_COUNT = 64
_REACH = 7


def specks(frame: float) -> list[Layer]:
    """Small particles that drift between the lens and the manta; the nearer, the larger, fainter and faster."""
    rng = np.random.default_rng(81)
    nearness = rng.uniform(1.2, 2.6, _COUNT)
    place = rng.uniform(0.0, 1.0, (_COUNT, 2))
    drift = rng.normal(0.0, 0.45, (_COUNT, 2)) + np.array([0.3, 0.5])
    bright = rng.uniform(0.12, 0.5, _COUNT)
    span = np.array(SIZE) + 2 * _REACH
    position = (place * span - nearness[:, None] * camera.travel(frame) + drift * (frame - FIRST)) % span - _REACH
    sigma = 0.75 + 0.85 * (nearness - 1.2)
    layers = []
    for (x, y), spread, share in zip(position, sigma, bright / (1.0 + 0.8 * (nearness - 1.2)), strict=True):
        left, top = max(int(x) - _REACH, 0), max(int(y) - _REACH, 0)
        right, bottom = min(int(x) + _REACH + 1, SIZE[0]), min(int(y) + _REACH + 1, SIZE[1])
        if left >= right or top >= bottom:
            continue
        gx = np.exp(-0.5 * ((np.arange(left, right) + 0.5 - x) / spread) ** 2)
        gy = np.exp(-0.5 * ((np.arange(top, bottom) + 0.5 - y) / spread) ** 2)
        alpha = (share * gy[:, None] * gx[None, :]).astype(np.float32)
        colour = np.broadcast_to(np.array([0.34, 0.40, 0.38], dtype=np.float32), (*alpha.shape, 3))
        layers.append(Layer(colour, alpha, left, top))
    return layers
