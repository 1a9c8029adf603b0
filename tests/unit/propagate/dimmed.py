"""Drawn shots whose light falls: a dark body that bends before a wall that becomes as dark as it was; a body that goes
through the shadow of a line that goes over all of the picture; and one that goes into the dark, which stays there.
"""

from __future__ import annotations

from collections.abc import Callable

import cv2
import numpy as np

from roam_core.arrays import Array, UInt8

SIZE = 200, 320
Colour = tuple[int, int, int]


def dimmed_body(count: int, by: float) -> tuple[list[UInt8], list[UInt8]]:
    """Its pictures and masks. On the last frame the light is less by the share `by`."""

    def radius(angle: Array, k: int) -> Array:
        return np.asarray(40.0 + 12.0 * np.sin(2.0 * angle + 0.15 * k) + 6.0 * np.cos(3.0 * angle - 0.1 * k))

    def light(_: Array, k: int) -> float:
        return 1.0 - by * k / (count - 1)

    return _body((160, 150, 140), (112, 105, 98), radius, light, count)


def shaded_body(count: int, by: float) -> tuple[list[UInt8], list[UInt8]]:
    """Its pictures and masks. A shadow, darker by the share `by`, comes in from the left and lies over all at last."""

    def radius(angle: Array, _: int) -> Array:
        return np.asarray(40.0 + 6.0 * np.sin(3.0 * angle))

    def light(x: Array, k: int) -> Array:
        return np.asarray(1.0 - by / (1.0 + np.exp((x[..., None] - SIZE[1] * k / (count - 1)) / 3.0)))

    return _body((150, 150, 140), (90, 80, 75), radius, light, count)


def body_into_the_dark(count: int, by: float) -> tuple[list[UInt8], list[UInt8]]:
    """Its pictures and masks. To the right there is less and less light, by the share `by` at last: always the same."""

    def radius(angle: Array, _: int) -> Array:
        return np.full(angle.shape, 40.0)

    def light(x: Array, _: int) -> Array:
        return np.asarray(1.0 - by * np.clip((x[..., None] - SIZE[1] / 4) / (SIZE[1] / 2), 0.0, 1.0))

    return _body((150, 150, 140), (90, 80, 75), radius, light, count)


def _body(
    wall: Colour,
    cloth: Colour,
    radius: Callable[[Array, int], Array],
    light: Callable[[Array, int], Array | float],
    count: int,
) -> tuple[list[UInt8], list[UInt8]]:
    """A body of a `radius` by angle and frame that goes to the right before a wall, in a `light` by place and frame."""
    behind, before = _texture(1, wall), _texture(2, cloth)
    height, width = SIZE
    x, y = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    pictures, masks = [], []
    for k in range(count):
        from_middle = np.stack([x - 110.0 - 5.0 * k, y - 100.0])
        inside = np.hypot(*from_middle) < radius(np.arctan2(from_middle[1], from_middle[0]), k)
        picture = np.where(inside[..., None], np.roll(before, 5 * k, axis=1), behind) * light(x, k)
        grain = np.random.default_rng(k).normal(0.0, 2.0, picture.shape)
        pictures.append(np.uint8(np.clip(picture + grain, 0.0, 255.0)))
        masks.append(np.uint8(255) * inside)
    return pictures, masks


def _texture(seed: int, around: Colour) -> Array:
    rough = np.random.default_rng(seed).normal(0.0, 1.0, (*SIZE, 3))
    smooth = cv2.GaussianBlur(rough, (0, 0), 2.0)
    return np.asarray(np.array(around) + 16.0 * smooth / smooth.std())
