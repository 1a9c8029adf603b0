"""Looks: exposure, gamma and single channels for judging a picture on the screen; no file ever holds what they show."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import StrEnum
from functools import lru_cache
from typing import NamedTuple

import cv2
import numpy as np

from roam_core.arrays import Array, Image, UInt8
from roam_core.media.colour import (
    DENSITY_PER_CODE,
    LINEAR,
    LOG,
    NEGATIVE_GAMMA,
    srgb_from_linear,
    to_display,
)

LUMINANCE = (0.2126, 0.7152, 0.0722)
"""Weights of red, green and blue in what an eye takes for brightness (Rec. 709)."""


class Channel(StrEnum):
    """What of the picture is shown: all of it, or one channel as grey."""

    COLOUR = "colour"
    RED = "red"
    GREEN = "green"
    BLUE = "blue"
    LUMINANCE = "luminance"


class Plate(NamedTuple):
    """A plate's own values `(h, w, 3)`, and the colour space that they are in."""

    values: Image
    colour_space: str


SINGLE = {Channel.RED: 0, Channel.GREEN: 1, Channel.BLUE: 2}


@dataclass(frozen=True)
class Look:
    """How a picture is looked at.

    Attributes
    ----------
    exposure : stops; each doubles the light of the scene.
    gamma : exponent over the display's own curve; above 1 the shadows open.
    channel : all channels, or one of them as grey.
    """

    exposure: float = 0.0
    gamma: float = 1.0
    channel: Channel = Channel.COLOUR

    @property
    def is_neutral(self) -> bool:
        """True where the picture is shown as it is."""
        return self == Look()

    @property
    def table(self) -> UInt8:
        """The display value `(256,)` uint8 that is shown for each display value, by exposure and gamma."""
        return _table(self.exposure, self.gamma)


def seen(pixels: UInt8, look: Look) -> UInt8:
    """Display values as the look shows them.

    Parameters
    ----------
    pixels : (h, w) or (h, w, 3) uint8; of (h, w, 4) the fourth channel is opacity and stays as it is.
    look : with a single channel a picture of three becomes grey, (h, w); one of four keeps its opacity.

    Returns
    -------
    uint8; `pixels` itself where the look is neutral.
    """
    if pixels.ndim == 3 and pixels.shape[2] == 4:
        shown = seen(np.ascontiguousarray(pixels[:, :, :3]), look)
        code = cv2.COLOR_GRAY2RGB
        colours = shown if shown.ndim == 3 else cv2.cvtColor(shown, code)
        return np.dstack([colours, pixels[:, :, 3]])
    if pixels.ndim == 3:
        pixels = _channel(pixels, look.channel)
    if (look.exposure, look.gamma) == (0.0, 1.0):
        return pixels
    return np.asarray(cv2.LUT(pixels, look.table), dtype=np.uint8)


def seen_plate(values: Image, colour_space: str, look: Look) -> UInt8:
    """A float plate `(h, w, 3)` as the look shows it: exposing it less brings back what lies above white.

    Raises
    ------
    RoamError
        when the colour space is not known.
    """
    shown = to_display(_exposed(values, colour_space, look.exposure), colour_space)
    return seen(shown, replace(look, exposure=0.0))


def has_more_than_shown(values: Image, colour_space: str) -> bool:
    """True for a plate whose values reach beyond what its display picture holds."""
    return values.dtype != np.uint8 and colour_space in (LINEAR, LOG)


def linear_from_srgb(values: Array) -> Array:
    """The light of sRGB `values` in [0, 1]: the inverse of `roam_core.media.colour.srgb_from_linear`."""
    return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)


def _exposed(values: Image, colour_space: str, stops: float) -> Image:
    """The plate as a camera would have seen it with `stops` more light; the negative of a log plate grows denser."""
    if colour_space == LOG:
        return values + np.float32(stops * np.log10(2.0) * NEGATIVE_GAMMA / DENSITY_PER_CODE / 1023.0)
    return values * np.float32(2.0**stops)


def _channel(pixels: UInt8, channel: Channel) -> UInt8:
    """One channel `(h, w)` of a picture, or the picture itself."""
    if channel is Channel.COLOUR:
        return pixels
    if channel is Channel.LUMINANCE:
        return np.asarray(cv2.transform(pixels, np.array([LUMINANCE])), dtype=np.uint8)
    return np.asarray(cv2.extractChannel(pixels, SINGLE[channel]), dtype=np.uint8)


@lru_cache(maxsize=64)
def _table(exposure: float, gamma: float) -> UInt8:
    light = linear_from_srgb(np.linspace(0.0, 1.0, 256)) * 2.0**exposure
    shown = srgb_from_linear(np.clip(light, 0.0, 1.0)) ** (1.0 / gamma)
    return np.asarray(np.rint(255.0 * shown), dtype=np.uint8)
