"""How the light has changed since the key, told by the background that both pictures show.

It has become brighter or darker, warmer or colder; or a veil lies over all of the picture and lifts its blacks: haze,
glare, a fade to white. On a plate that is seen in its log encoding another exposure is one, too. A shadow lies over a
part of it (`proposal.cues.shadow`).
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property

import cv2
import numpy as np

from roam_core.arrays import Array, Bools, Float32
from roam_core.features import PreparedFrame
from roam_core.params.evidence import ExposureParams
from roam_core.proposal.cues.key_view import KeyView
from roam_core.proposal.cues.known_again import known_again, local_means


@dataclass(frozen=True, eq=False)
class Light:
    """What has become of a picture's light since the key.

    Attributes
    ----------
    exposure : factor by which it has become brighter. tint : (3,) factors of red, green and blue besides.
    veil : (3,) levels, in [0, 255], of red, green and blue that lie over all of it besides; less than 0 where the key
        had more of it.
    shades : factors by which parts of the picture are darker besides, or brighter; none where all lies in one light.
    """

    exposure: float = 1.0
    tint: Array = field(default_factory=lambda: np.ones(3))
    veil: Array = field(default_factory=lambda: np.zeros(3))
    shades: tuple[float, ...] = ()

    @property
    def gains(self) -> Array:
        """By what red, green and blue `(3,)` of the key are multiplied to look as they do now."""
        return self.exposure * self.tint

    @property
    def in_parts(self) -> tuple[Light, ...]:
        """The light in those parts."""
        return tuple(replace(self, exposure=self.exposure * shade, shades=()) for shade in self.shades)

    def after(self, first: Light) -> Light:
        """The light since a key, where this is that since another picture and `first` that picture's since the key."""
        return Light(self.exposure * first.exposure, self.tint * first.tint, self.gains * first.veil + self.veil)

    def cast(self, key: PreparedFrame) -> PreparedFrame:
        """The key's picture as it would be in this light."""
        return key.multiplied(self.gains, self.veil)

    def removed(self, frame: PreparedFrame) -> PreparedFrame:
        """A picture in this light as it would be in that of the key."""
        return frame.multiplied(1.0 / self.gains, -self.veil / self.gains)


UNCHANGED = Light()


def light_since(view: KeyView, frame: PreparedFrame, inside: Bools, last: Light, params: ExposureParams) -> Light:
    """The light of `frame` against that of the key: of what is not to be seen, as it was `last`.

    A patch of the background is known again by its correlation with the key's, which light does not change. Exposure
    and tint are the same everywhere: where most patches do not agree on a factor, it is shadows, glitter, or something
    else. Told is the factor nearest to 1 from which the median differs by no more than two patches of one light do.
    Shadows and glitter change all channels alike, so that patches agree more closely on the tint. Light multiplies the
    values of the plate, not those that levels shift; but what is stretched then tells less of a change apart.

    Where one factor does not tell what has become of dark patches and of bright ones, a factor and a veil may.

    Parameters
    ----------
    view : the key, carried by the motion of its surroundings. frame : as it was given.
    inside : (rows, columns) where the object may be.
    """
    plate, contrast = frame.plate, frame.contrast
    picture, luma = view.grid.colours_of(plate), view.grid.grey_of(plate)
    seen = view.plate.seen
    known = view.in_sight & ~inside & (view.coverage < params.beside)
    seen_luma = np.asarray(cv2.cvtColor(seen, cv2.COLOR_RGB2GRAY), np.uint8)
    before, now = local_means(seen_luma, params.window), local_means(luma, params.window)
    flat = params.flat / contrast
    usable = known_again((seen_luma, luma), (before, now), known, params.window, params.alike, flat)
    usable &= _is_exposed(before, now, params)
    chosen = np.flatnonzero(usable)
    chosen = chosen[:: len(chosen) // params.most + 1]  # those beside each other overlap, and tell the same
    colours_then, colours = (
        np.ascontiguousarray(local_means(each, params.window).reshape(-1, 3)[chosen].T) for each in (seen, picture)
    )
    patches = _Patches(before.ravel()[chosen], now.ravel()[chosen], colours_then, colours, contrast)
    light = _veiled(patches, last, params) or _multiplied(patches, last, params)
    shades = _shades(patches, light, params)
    return light if shades == light.shades else replace(light, shades=shades)


@dataclass(frozen=True, eq=False)
class _Patches:
    """Patches of the background, known again: their mean luma `(N,)` and colours `(3, N)` on the key and now.

    contrast : by how much the plate's differences are stretched in what is seen of it.
    """

    luma_then: Float32
    luma: Float32
    colours_then: Float32
    colours: Float32
    contrast: float

    @cached_property
    def brighter(self) -> Array:
        """The logarithms of the factors `(N,)` by which their luma has grown."""
        return np.asarray(np.log(self.luma.astype(np.float64) / self.luma_then))


@dataclass(frozen=True)
class _Line:
    """What has become of brightness: `factor` times what it was, and `veil` levels more."""

    factor: float
    veil: float

    @classmethod
    def through(cls, then: Float32, now: Float32) -> _Line:
        """By which the spread of all patches, then, comes to lie on that of now, and their medians on each other.

        The spread is that between the middles of the darkest third and of the brightest. A fit of one to the other
        would tell the less of a factor, the less exactly the patches lie on each other.
        """
        dark, middle, bright = (
            np.array([np.quantile(each, at) for each in (then, now)]) for at in (1 / 6, 1 / 2, 5 / 6)
        )
        run, rise = bright - dark
        factor = float(rise / max(run, 1.0))
        return cls(factor, float(middle[1] - factor * middle[0]))

    def at(self, then: Float32) -> Array:
        """What has become of levels."""
        return np.asarray(self.factor * then + self.veil, dtype=np.float64)


def _veiled(patches: _Patches, last: Light, params: ExposureParams) -> Light | None:
    """The light where it takes a veil to explain the patches, None where it does not.

    A veil comes up where it explains half of the patches that a factor misses, and of all a share of `params.veiled`.
    It stays while it explains more than a factor; where that is too few, it is the `last` one. It has a colour; the
    factor is that of all channels.
    """
    if len(patches.luma) < params.least:
        return None
    is_there = bool(last.veil.any())
    factor = float(np.exp(np.median(patches.brighter)))
    by_factor = _missed(_Line(factor, 0.0), patches, params)
    asked = 0.0 if is_there else max(params.veiled, 0.5 * by_factor)
    if by_factor <= asked:
        return None
    line = _Line.through(patches.luma_then, patches.luma)
    by_line = _missed(line, patches, params)
    if by_factor - by_line <= asked:
        return None
    with np.errstate(invalid="ignore", divide="ignore"):  # what has one brightness correlates with nothing
        alike = float(np.corrcoef(patches.luma_then, patches.luma)[0, 1])
    if by_line > 1.0 - params.agreed or line.factor <= 0.0 or not alike >= params.alike:
        return last if is_there else None
    middles = (np.median(each, axis=1) for each in (patches.colours_then, patches.colours))
    then, now = (each.astype(np.float64) for each in middles)
    return Light(line.factor, veil=now - line.factor * then)


def _missed(line: _Line, patches: _Patches, params: ExposureParams) -> float:
    """The share of patches of which a line does not tell what has become of them.

    As of factors, what is stretched tells less of a change apart.
    """
    expected = np.maximum(line.at(patches.luma_then), 1.0)
    apart = np.abs(np.log(patches.luma / expected))
    return float(np.mean(apart >= params.within / patches.contrast))


def _multiplied(patches: _Patches, last: Light, params: ExposureParams) -> Light:
    """The light by factors, of luma and of each channel besides; the `last` one's where patches agree on none."""
    exposure = _agreed(patches.brighter, patches.contrast, params)
    if exposure is None and last.veil.any():
        return last
    coloured = np.flatnonzero(np.all(_is_exposed(patches.colours_then, patches.colours, params), axis=0))
    then, now = (each[:, coloured] for each in (patches.colours_then, patches.colours))
    tint = _agreed(np.log(now.astype(np.float64) / then) - patches.brighter[coloured], patches.contrast, params)
    return Light(last.exposure if exposure is None else float(exposure), last.tint if tint is None else tint)


def _shades(patches: _Patches, light: Light, params: ExposureParams) -> tuple[float, ...]:
    """The factors by which patches are darker than in a `light`, and by which others are brighter.

    They are told where enough patches are that far off, and nearly all lie in one of the lights: where water glitters,
    or what is no more the same is taken for known again, patches are off by anything. Under a veil it is not asked.
    """
    shadow = params.shadow
    if light.veil.any() or len(patches.luma) < params.least:
        return ()
    changes = patches.brighter - np.log(light.exposure)
    beyond = changes[changes < -shadow.apart], changes[changes > shadow.apart]
    told = [np.median(each) for each in beyond if len(each) >= shadow.share * len(changes)]
    nearest = np.min([np.abs(changes - each) for each in (0.0, *told)], axis=0)
    if np.mean(nearest < shadow.within) < shadow.agreed:
        return ()
    return tuple(float(np.exp(each)) for each in told)


def _is_exposed(before: Float32, now: Float32, params: ExposureParams) -> Bools:
    """Whether means are neither cut at white nor lost in black, before or now."""
    low, high = np.minimum(before, now), np.maximum(before, now)
    return np.asarray((low > params.darkest) & (high < params.brightest))


def _agreed(changes: Array, contrast: float, params: ExposureParams) -> Array | None:
    """The factors `(...)` that cells tell by the logarithms of theirs `(..., N)`; None where they do not agree.

    Left out of the factors is what two patches of one light may differ by, in a picture whose contrast was not raised.
    """
    if changes.shape[-1] < params.least:
        return None
    median = np.median(changes, axis=-1)
    agreeing = np.count_nonzero(np.abs(changes - median[..., None]) < params.within, axis=-1)
    if np.any(agreeing < params.agreed * changes.shape[-1]):
        return None
    left = params.within / contrast
    return np.asarray(np.exp(median - np.clip(median, -left, left)))
