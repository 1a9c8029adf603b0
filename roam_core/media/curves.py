"""Curves: between the light of a scene and the values that files hold of it, written out; the spaces made of them."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array

SRGB = "sRGB"
"""Display-referred values with the sRGB transfer curve (8- and 16-bit images, movies)."""
LINEAR = "linear"
"""Scene-linear values, 1.0 for diffuse white (EXR), with the primaries of Rec. 709."""
LOG = "log"
"""Kodak's Cineon printing density, 10-bit code values divided by 1023 (DPX)."""
COLOUR_SPACES = (SRGB, LINEAR, LOG)
"""The spaces that need no OpenColorIO."""

# Cineon's reference white and black, density per code value, and the negative's gamma.
WHITE_CODE, BLACK_CODE, DENSITY_PER_CODE, NEGATIVE_GAMMA = 685.0, 95.0, 0.002, 0.6


def srgb_from_linear(values: Array) -> Array:
    """The sRGB transfer curve (IEC 61966-2-1) of linear `values` in [0, 1]."""
    return np.where(values <= 0.0031308, 12.92 * values, 1.055 * np.maximum(values, 0.0031308) ** (1 / 2.4) - 0.055)


def linear_from_log(values: Array) -> Array:
    """Scene-linear values of Cineon log `values` (code / 1023): code 95 gives 0 and 685 gives 1.

    Source: Kodak's Cineon conversion, gain and offset fitted so that black and white land on 0 and 1.
    """
    slope = DENSITY_PER_CODE / NEGATIVE_GAMMA
    black = 10.0 ** ((BLACK_CODE - WHITE_CODE) * slope)
    return np.asarray((10.0 ** ((values * 1023.0 - WHITE_CODE) * slope) - black) / (1.0 - black))


def linear_from_srgb(values: Array) -> Array:
    """The light of sRGB `values` in [0, 1]: the inverse of `srgb_from_linear`."""
    return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)
