"""The camera: a slow tracking move over two depths of sea bed, with the small unrest of a diver's hands."""

from __future__ import annotations

import numpy as np

from .timing import FIRST, SIZE, Array, progress

PAN = np.array([200.0, -62.0])
"""How far the camera travels over the whole shot, in pixels of the sand."""

SAND, REEF = 1.0, 1.22
"""Nearness of the two layers of ground: the reef's boulders stand up towards the camera and so move faster."""


def sway(frame: float) -> Array:
    """Offset `(2,)` in pixels by which the hand-held camera wanders off its course."""
    t = (frame - FIRST) / 24.0
    x = 2.6 * np.sin(2.1 * t + 0.4) + 1.1 * np.sin(5.3 * t + 1.7)
    y = 2.1 * np.sin(2.7 * t + 2.2) + 0.9 * np.sin(6.1 * t + 0.3)
    return np.array([x, y])


def travel(frame: float) -> Array:
    """Where the camera looks `(2,)`, in pixels of the sand from the middle of its travel."""
    u = float(progress(frame))
    return np.asarray(PAN * (u - 0.5 + 0.06 * np.sin(2 * np.pi * u)) + sway(frame))


def turn(frame: float) -> float:
    """Rotation of the camera in radians."""
    return float(np.radians(-2.2 + 4.6 * progress(frame) + 0.25 * np.sin((frame - FIRST) / 7.0)))


def zoom(frame: float) -> float:
    """Magnification: the camera sinks slowly towards the ground."""
    return float(1.0 + 0.06 * progress(frame))


def view(frame: float, nearness: float, texture_size: tuple[int, int]) -> Array:
    """The affine map `(2, 3)` from a ground texture of `(width, height)` pixels to the plate at `frame`."""
    angle, scale = turn(frame), zoom(frame)
    linear = scale * np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    looked_at = np.array(texture_size) / 2.0 + nearness * travel(frame)
    return np.column_stack([linear, np.array(SIZE) / 2.0 - linear @ looked_at])
