"""How the light has changed since the key, told by the background that both pictures show."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import cv2
import numpy as np

from roam_core.arrays import Array, Bools, Float32, UInt8
from roam_core.features import PreparedFrame
from roam_core.features.grid import Grid
from roam_core.params.evidence import ExposureParams
from roam_core.proposal.cues.key_view import KeyView


@dataclass(frozen=True, eq=False)
class Light:
    """What has become of a picture's light since the key.

    Attributes
    ----------
    exposure : factor by which it has become brighter. tint : (3,) factors of red, green and blue besides.
    """

    exposure: float = 1.0
    tint: Array = field(default_factory=lambda: np.ones(3))

    @property
    def gains(self) -> Array:
        """By what red, green and blue `(3,)` of the key are multiplied to look as they do now."""
        return self.exposure * self.tint


UNCHANGED = Light()


def light_since(
    view: KeyView, frame: PreparedFrame, inside: Bools, grid: Grid, last: Light, params: ExposureParams
) -> Light:
    """The light of `frame` against that of the key: of what is not to be seen, as it was `last`.

    A patch of the background is known again by its correlation with the key's, which light does not change. Exposure
    and tint are the same everywhere: where most patches do not agree on a factor, it is shadows, glitter, or something
    else. Told is the factor nearest to 1 from which the median differs by no more than two patches of one light do.
    Shadows and glitter change all channels alike, so that patches agree more closely on the tint. Light multiplies the
    values of the plate, not those that levels shift; but what is stretched then tells less of a change apart.

    Parameters
    ----------
    view : the key, carried by the motion of its surroundings. frame : as it was given.
    inside : (rows, columns) where the object may be.
    """
    plate, contrast = frame.plate, frame.contrast
    picture, luma = grid.colours_of(plate), grid.grey_of(plate)
    seen, known = replace(view, picture=view.picture.plate).seen(grid)
    known &= ~inside & (view.coverage < params.beside)
    seen_luma = np.asarray(cv2.cvtColor(seen, cv2.COLOR_RGB2GRAY), np.uint8)
    usable = _known_again(seen_luma, luma, known, params.flat / contrast, params)
    before, now = _means(seen_luma, params.window), _means(luma, params.window)
    usable &= _is_exposed(before, now, params)
    brighter = np.log(now[usable].astype(np.float64) / before[usable])
    exposure = _agreed(brighter, contrast, params)
    channels_before, channels = _means(seen, params.window), _means(picture, params.window)
    coloured = np.all(_is_exposed(channels_before, channels, params)[usable], axis=1)
    shifts = np.log(channels[usable][coloured].astype(np.float64) / channels_before[usable][coloured])
    tint = _agreed(shifts - brighter[coloured, None], contrast, params)
    return Light(last.exposure if exposure is None else float(exposure), last.tint if tint is None else tint)


def _known_again(then: UInt8, now: UInt8, known: Bools, flat: float, params: ExposureParams) -> Bools:
    """The cells `(rows, columns)` around which both lumas show the same, and nothing but what is `known`.

    Those of a deviation under `flat` count for less.
    """
    window = (params.window, params.window)
    whole = cv2.erode(known.astype(np.uint8), np.ones(window, np.uint8), borderType=cv2.BORDER_CONSTANT, borderValue=0)
    then32, now32 = np.asarray(then, np.float32), np.asarray(now, np.float32)
    mean_then, mean = cv2.blur(then32, window), cv2.blur(now32, window)
    variance_then, variance = (
        cv2.blur(then32 * then32, window) - mean_then**2,
        cv2.blur(now32 * now32, window) - mean**2,
    )
    covariance = cv2.blur(then32 * now32, window) - mean_then * mean
    least = np.sqrt(np.maximum(variance_then * variance, np.float32(flat**4)))
    return np.asarray((whole > 0) & (covariance > params.alike * least))


def _means(picture: UInt8, window: int) -> Float32:
    """The mean of each channel around each cell."""
    return np.asarray(cv2.blur(np.asarray(picture, np.float32), (window, window)))


def _is_exposed(before: Float32, now: Float32, params: ExposureParams) -> Bools:
    """Whether means are neither cut at white nor lost in black, before or now."""
    low, high = np.minimum(before, now), np.maximum(before, now)
    return np.asarray((low > params.darkest) & (high < params.brightest))


def _agreed(changes: Array, contrast: float, params: ExposureParams) -> Array | None:
    """The factors `(...)` that cells tell by the logarithms of theirs `(N, ...)`; None where they do not agree.

    Left out of the factors is what two patches of one light may differ by, in a picture whose contrast was not raised.
    """
    if len(changes) < params.least:
        return None
    median = np.median(changes, axis=0)
    if np.any(np.mean(np.abs(changes - median) < params.within, axis=0) < params.agreed):
        return None
    left = params.within / contrast
    return np.asarray(np.exp(median - np.clip(median, -left, left)))
