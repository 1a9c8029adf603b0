"""OpenColorIO: the studio's configuration ($OCIO) or the built-in one of ACES, its spaces, file rules and views.

Loaded when the first plate asks for it: those in the spaces of `roam_core.media.curves` never do.
"""

from __future__ import annotations

import hashlib
import os
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import PyOpenColorIO as ocio  # noqa: N813 - the name its own manual uses

from roam_core.arrays import Float32, UInt8
from roam_core.bounded import bounded_bytes
from roam_core.errors import RoamError
from roam_core.media.curves import (
    BLACK_CODE,
    DENSITY_PER_CODE,
    LINEAR,
    LOG,
    NEGATIVE_GAMMA,
    SRGB,
    WHITE_CODE,
)
from roam_core.translatable import sentence

_ERRORS = (ocio.Exception, ocio.ExceptionMissingFile)

BUILT_IN = "studio-config-v4.0.0_aces-v2.0_ocio-v2.5"
"""The configuration of ACES, with the cameras' log curves, that is used where `$OCIO` names none: one for all versions
of OpenColorIO, so that a plate gives the same points with a later one."""
VARIABLE = "OCIO"
"""The environment variable that names the studio's configuration, as in other programs."""
WORKING = "Linear Rec.709 (sRGB)"
"""What OpenColorIO calls scene-linear values with the primaries of Rec. 709: every plate is brought there."""

MOST_BYTES = 1 << 28
"""Of a configuration, or of one of its tables."""

_ALIASES = {SRGB: ("srgb_rec709_scene", "srgb_tx", "srgb_texture"), LINEAR: ("lin_rec709_scene", "lin_srgb")}
"""Names by which configurations know the spaces that ROAM knows by itself."""

_PRIMARIES = {
    "lin_ap0_scene": (0.7347, 0.2653, 0.0, 1.0, 0.0001, -0.077),
    "lin_ap1_scene": (0.713, 0.293, 0.165, 0.83, 0.128, 0.044),
    "lin_rec2020_scene": (0.708, 0.292, 0.17, 0.797, 0.131, 0.046),
    "lin_p3d65_scene": (0.68, 0.32, 0.265, 0.69, 0.15, 0.06),
}
"""Chromaticities of red, green and blue (x, y each) by the name of the scene-linear space with them."""
SAME_PRIMARY = 2e-3

# The shaper of baked views, ACEScct's curve (S-2016-001): evenly spaced stops, straight near black.
_STOPS, _OFFSET, _STRAIGHT_BELOW = 17.52, 9.72, 0.0078125
_SHAPED = (-0.035, 0.9)
"""The shaped values, of about -0.01 and 64 in the light of the scene, between which a view is baked."""
BAKED_STEPS = 65
"""Steps along each side of a baked view."""


class View(NamedTuple):
    """A display, and one of the views that a configuration has for it."""

    display: str
    view: str


def space_names() -> tuple[str, ...]:
    """The colour spaces of the configuration in which a plate may be, in its own order; no data, no displays."""
    config = _config()
    names = config.getColorSpaceNames(ocio.SEARCH_REFERENCE_SPACE_SCENE, ocio.COLORSPACE_ACTIVE)
    return tuple(str(name) for name in names if not config.getColorSpace(name).isData())


def views() -> tuple[View, ...]:
    """All views of all displays of the configuration."""
    config = _config()
    return tuple(View(display, view) for display in config.getDisplays() for view in config.getViews(display))


def named(name: str) -> str | None:
    """The space that the configuration knows by a name, an alias or a role; ROAM's own word where it is one of those.

    None where there is none, or no configuration.
    """
    try:
        space = _config().getColorSpace(name)
    except RoamError:
        return None
    if space is None:
        return None
    known = {str(space.getName()), *map(str, space.getAliases())}
    return next((word for word, aliases in _ALIASES.items() if known & set(aliases)), str(space.getName()))


def by_rule(file: Path) -> str | None:
    """The space that the configuration's file rules give a file; None where only their default holds."""
    try:
        config = _config()
    except RoamError:
        return None
    path = os.fsencode(file).decode("utf-8", "replace")
    return None if config.filepathOnlyMatchesDefaultRule(path) else named(config.getColorSpaceFromFilepath(path)[0])


def with_primaries(chromaticities: object) -> str | None:
    """The scene-linear space with these primaries, eight numbers of an EXR file; None for others, and for Rec. 709."""
    if not isinstance(chromaticities, tuple) or len(chromaticities) != 8:
        return None
    for name, primaries in _PRIMARIES.items():
        if np.allclose(chromaticities[:6], primaries, rtol=0.0, atol=SAME_PRIMARY):
            return named(name)
    return None


def definition_of(space: str) -> str:
    """What `$OCIO` says that a space is, as 32 hexadecimal digits; "" for the built-in configuration, or an unread one.

    It covers the whole configuration and the tables that the space is made of: their content, not where they lie.
    """
    return _definition(_version(), space)


def to_linear(values: Float32, space: str) -> None:
    """Turn values `(..., 3)`, contiguous, into scene-linear ones with the primaries of Rec. 709, in place, unclipped.

    Raises
    ------
    RoamError
        when the configuration has no such space, or there is none.
    """
    _to_linear(_version(), space).applyRGB(values)


def displayed(values: Float32, space: str, view: View, exposure: float) -> UInt8:
    """What a view shows of a plate's values `(h, w, 3)`, contiguous: display values, 0 to 255.

    Parameters
    ----------
    exposure : stops, of the scene's light before the view.

    Raises
    ------
    RoamError
        when the configuration has no such space or view, or there is none.
    """
    shown = np.empty(values.shape, np.uint8)
    height, width = values.shape[:2]
    given = ocio.PackedImageDesc(values, width, height, 3)
    wanted = ocio.PackedImageDesc(shown, width, height, 3, ocio.BIT_DEPTH_UINT8, 1, 3, 3 * width)
    _to_view(_version(), space, view, exposure).apply(given, wanted)
    return shown


# ---- the configuration -----------------------------------------------------------------------------------------------


def _config() -> Any:
    return _opened(_version())


def _version() -> str:
    """What tells one configuration from another: processors are kept by it."""
    return os.environ.get(VARIABLE, "")


@cache
def _opened(path: str) -> Any:
    try:
        return ocio.Config.CreateFromFile(path) if path else ocio.Config.CreateFromBuiltinConfig(BUILT_IN)
    except _ERRORS as error:
        raise RoamError(
            sentence(
                "The OpenColorIO configuration {path} cannot be read: {reason}. Correct ${variable}, or unset it.",
                path=path or BUILT_IN,
                reason=_reason(error),
                variable=VARIABLE,
            )
        ) from None


@cache
def _definition(path: str, space: str) -> str:
    if not path:
        return ""
    try:
        config = _opened(path)
        used = config.getProcessor(space, ocio.ROLE_SCENE_LINEAR).getProcessorMetadata().getFiles()
    except (RoamError, *_ERRORS):
        return ""
    found = hashlib.sha256()
    for file in (path, *sorted(used, key=lambda file: Path(file).name)):
        found.update(_content(Path(file)) or str(file).encode())  # of a configuration that is no file, its name
    return found.hexdigest()[:32]


def _content(file: Path) -> bytes:
    try:
        return bounded_bytes(file, MOST_BYTES)
    except RoamError:
        return b""


def _reason(error: Exception) -> str:
    return " ".join(str(error).split()).rstrip(".")


# ---- transforms ------------------------------------------------------------------------------------------------------


@cache
def _to_linear(version: str, space: str) -> Any:
    return _processor(_linear_transform(version, space)).getDefaultCPUProcessor()


@cache
def _to_view(version: str, space: str, view: View, exposure: float) -> Any:
    """From a plate's space to 8-bit display values."""
    config = _opened(version)
    group = ocio.GroupTransform()
    group.appendTransform(_linear_transform(version, space))
    group.appendTransform(
        _between(ocio.Config.GetProcessorFromBuiltinColorSpace, WORKING, config, ocio.ROLE_SCENE_LINEAR)
    )
    group.appendTransform(_gain(2.0**exposure))
    group.appendTransform(_view_transform(version, view))
    depths = ocio.BIT_DEPTH_F32, ocio.BIT_DEPTH_UINT8
    return _processor(group).getOptimizedCPUProcessor(*depths, ocio.OPTIMIZATION_DEFAULT)


@cache
def _view_transform(version: str, view: View) -> Any:
    """From scene-linear values to those of a display: a baked table where computing them is slow, else exactly."""
    config = _opened(version)
    shown = ocio.DisplayViewTransform(ocio.ROLE_SCENE_LINEAR, view.display, view.view)
    try:
        exact = config.getProcessor(shown)
    except _ERRORS as error:
        raise RoamError(
            sentence(
                "OpenColorIO cannot show the view {view} on {display}: {reason}.",
                view=view.view,
                display=view.display,
                reason=_reason(error),
            )
        ) from None
    steps = exact.createGroupTransform()
    if any(isinstance(step, ocio.FixedFunctionTransform) for step in steps):
        return _baked(exact.getDefaultCPUProcessor())
    return steps


def _processor(transform: Any) -> Any:
    """The processor of a transform that names no space. A configuration takes two tables of one size for the same."""
    return ocio.Config.CreateRaw().getProcessor(transform)


def _linear_transform(version: str, space: str) -> Any:
    """From a space to scene-linear values with the primaries of Rec. 709."""
    if space == LINEAR:
        return _gain(1.0)
    if space == SRGB:
        return ocio.ExponentWithLinearTransform(gamma=[2.4, 2.4, 2.4, 1.0], offset=[0.055, 0.055, 0.055, 0.0])
    if space == LOG:
        return _cineon()
    config = _opened(version)
    if config.getColorSpace(space) is None:
        raise RoamError(
            sentence(
                "The colour space {space!r} is not known to the OpenColorIO configuration {path}; "
                "choose another, or set ${variable} to the one that has it.",
                space=space,
                path=version or BUILT_IN,
                variable=VARIABLE,
            )
        )
    return _between(ocio.Config.GetProcessorToBuiltinColorSpace, config, space, WORKING)


def _between(make: Any, *spaces: Any) -> Any:
    try:
        return make(*spaces).createGroupTransform()
    except _ERRORS as error:
        raise RoamError(
            sentence("OpenColorIO cannot convert {spaces}: {reason}.", spaces=str(spaces), reason=_reason(error))
        ) from None


def _cineon() -> Any:
    """The curve of `roam_core.media.curves.linear_from_log`."""
    slope = DENSITY_PER_CODE / NEGATIVE_GAMMA
    black = 10.0 ** ((BLACK_CODE - WHITE_CODE) * slope)
    transform = ocio.LogAffineTransform(
        [1.0 / (slope * 1023.0)] * 3, [WHITE_CODE / 1023.0] * 3, [1.0 - black] * 3, [black] * 3
    )
    transform.setBase(10.0)
    transform.setDirection(ocio.TRANSFORM_DIR_INVERSE)
    return transform


def _gain(factor: float) -> Any:
    return ocio.MatrixTransform(np.diag([factor, factor, factor, 1.0]).ravel().tolist())


def _shaper() -> list[Any]:
    """Scene-linear values to [0, 1], as a view is baked: in even stops."""
    curve = ocio.LogCameraTransform([_STRAIGHT_BELOW] * 3)
    curve.setBase(2.0)
    curve.setLogSideSlopeValue([1.0 / _STOPS] * 3)
    curve.setLogSideOffsetValue([_OFFSET / _STOPS] * 3)
    low, high = _SHAPED
    scale = 1.0 / (high - low)
    matrix = np.diag([scale, scale, scale, 1.0]).ravel().tolist()
    return [curve, ocio.MatrixTransform(matrix, [-low * scale] * 3 + [0.0])]


def _baked(exact: Any) -> Any:
    """A table of what a processor makes of scene-linear values; one of ACES takes a thousand operations a pixel."""
    steps = np.linspace(0.0, 1.0, BAKED_STEPS, dtype=np.float32)
    grid = np.stack(np.meshgrid(steps, steps, steps, indexing="ij"), axis=-1)
    unshaped = ocio.GroupTransform(_shaper())
    unshaped.setDirection(ocio.TRANSFORM_DIR_INVERSE)
    _processor(unshaped).getDefaultCPUProcessor().applyRGB(grid)
    exact.applyRGB(grid)
    table = ocio.Lut3DTransform(BAKED_STEPS)
    table.setInterpolation(ocio.INTERP_TETRAHEDRAL)
    table.setData(grid.ravel())
    return ocio.GroupTransform([*_shaper(), table])
