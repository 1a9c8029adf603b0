"""Looks: view, exposure, gamma and single channels, to judge pictures on the screen; no file holds what they show."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import StrEnum
from functools import lru_cache
from typing import NamedTuple

import cv2
import numpy as np

from roam_core.arrays import Image, UInt8
from roam_core.media.colour import to_display, unit_floats
from roam_core.media.curves import (
    COLOUR_SPACES,
    DENSITY_PER_CODE,
    LINEAR,
    LOG,
    NEGATIVE_GAMMA,
    SRGB,
    linear_from_srgb,
    srgb_from_linear,
)
from roam_core.media.proxies import reduced

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
    """A plate's own values `(h, w, 3)`, and the colour space that they are in.

    `scalable` are the same, or a proxy of them, in a type that OpenCV scales: what views and exposure are made of.
    None where they have to be made first (`roam_core.media.looking.scalable`).
    """

    values: Image
    colour_space: str
    scalable: Image | None = None


SINGLE = {Channel.RED: 0, Channel.GREEN: 1, Channel.BLUE: 2}


@dataclass(frozen=True)
class Look:
    """How a picture is looked at.

    Attributes
    ----------
    exposure : stops; each doubles the light of the scene.
    gamma : exponent over the display's own curve; above 1 the shadows open.
    channel : all channels, or one of them as grey.
    view : a display and one of its views, by their names in the OpenColorIO configuration; None for the plate's own
        light with the sRGB curve, clipped, which is what the engine sees.
    """

    exposure: float = 0.0
    gamma: float = 1.0
    channel: Channel = Channel.COLOUR
    view: tuple[str, str] | None = None

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
        return with_opacity(shown, pixels[:, :, 3])
    if pixels.ndim == 3:
        pixels = _channel(pixels, look.channel)
    if (look.exposure, look.gamma) == (0.0, 1.0):
        return pixels
    return np.asarray(cv2.LUT(pixels, look.table), dtype=np.uint8)


def with_opacity(colours: UInt8, opacity: UInt8) -> UInt8:
    """A picture `(h, w, 3)`, or a grey one `(h, w)`, with opacity `(h, w)` as its fourth channel: `(h, w, 4)` uint8."""
    if colours.ndim == 2:
        colours = np.asarray(cv2.cvtColor(colours, cv2.COLOR_GRAY2RGB))
    return np.dstack([colours, opacity])


def seen_plate(values: Image, colour_space: str, look: Look) -> UInt8:
    """A plate `(h, w, 3)` as the look shows it: exposing it less brings back what lies above white.

    Raises
    ------
    RoamError
        when the colour space or the view is not known.
    """
    after = replace(look, exposure=0.0, view=None)
    if look.view is None:
        light = _exposed(values, colour_space, look.exposure) if look.exposure else (values, colour_space)
        return seen(to_display(*light), after)
    from roam_core.media.colour_config import View, displayed

    return seen(displayed(unit_floats(values), colour_space, View(*look.view), look.exposure), after)


def is_seen_anew(plate: Plate, look: Look) -> bool:
    """True where a look wants more of a plate than its display picture holds: its own values, for `seen_plate`."""
    return look.view is not None or (look.exposure != 0.0 and has_more_than_shown(plate.values, plate.colour_space))


def scalable(values: Image, step: int = 1) -> Image:
    """A plate's values, or a proxy of them (`roam_core.media.proxies`), in a type that OpenCV scales: no halves."""
    return reduced(unit_floats(values) if values.dtype == np.float16 else values, step)


def has_more_than_shown(values: Image, colour_space: str) -> bool:
    """True for a plate whose values reach beyond what its display picture holds."""
    return values.dtype != np.uint8 and (colour_space != SRGB or np.issubdtype(values.dtype, np.floating))


def _exposed(values: Image, colour_space: str, stops: float) -> tuple[Image, str]:
    """The plate as a camera would have seen it with `stops` more light, and the space that it is in then.

    The negative of a log plate grows denser; what is encoded for a display, or only OpenColorIO knows, is made light
    first.
    """
    values = unit_floats(values)
    if colour_space == LOG:
        return values + np.float32(stops * np.log10(2.0) * NEGATIVE_GAMMA / DENSITY_PER_CODE / 1023.0), LOG
    if colour_space == SRGB:
        values, colour_space = linear_from_srgb(np.maximum(values, np.float32(0.0))).astype(np.float32), LINEAR
    elif colour_space not in COLOUR_SPACES:
        from roam_core.media.colour_config import to_linear

        to_linear(values, colour_space)
        colour_space = LINEAR
    return values * np.float32(2.0**stops), colour_space


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
