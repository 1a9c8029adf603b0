"""What is seen of each of several shapes: their joint matte, divided among those that make it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from roam_core.arguments import moment, size_of
from roam_core.arrays import Matte
from roam_core.matte.compose import BLENDS, Draw, Place, reach
from roam_core.matte.rasterise import Patch, has_area, shape_patch
from roam_core.roto import BlendMode, Layer, RotoShape


@dataclass(frozen=True)
class Visible:
    """What is seen of a shape; or of an inverted layer, in which no shape makes what is white.

    Attributes
    ----------
    item : the shape or layer.
    layer : the layer that the shape lies in, or the inverted one.
    patch : the share of the joint matte, black beside its values.
    """

    item: Layer | RotoShape
    layer: Layer
    patch: Patch


def visible_shares(
    root: Layer, frame: float, size: tuple[int, int], drawn: Draw = shape_patch
) -> tuple[list[Visible], Matte]:
    """What is seen of each shape at one frame, bottom first, and the joint matte as `render_matte` gives it.

    In every pixel the shares add up to the joint matte, but for rounding. A shape hides what lies under it in its layer
    as far as it covers it; under PLUS only as far as there is no room for both; under MAX and DIFFERENCE what lies
    under it keeps what it is more. A shape that subtracts or intersects takes from what lies under it and has no share.
    The opacity of a layer scales the shares of what lies in it.

    Parameters
    ----------
    root : a layer that lies in no moving one.
    frame : the plate's frame number.
    size : (h, w) of the image.
    drawn : fills one shape; it is asked more than once for each, and may remember.
    """
    frame, size = moment(frame), size_of(size)
    if not root.visible:
        return [], np.zeros(size, dtype=np.float32)
    whole = slice(0, size[0]), slice(0, size[1])
    shares, matte = _of_layer(root.in_plate_space(), frame, size, drawn, whole)
    return [share for share in shares if share.patch.values.any()], matte


def _add(under: Matte, over: Matte) -> Matte:
    return np.float32(1.0) - over


def _plus(under: Matte, over: Matte) -> Matte:
    room = np.float32(1.0) - over
    return _quotient(np.minimum(under, room), under)


def _rest(under: Matte, over: Matte) -> Matte:
    return _quotient(np.maximum(under - over, np.float32(0.0)), under)


def _quotient(part: Matte, whole: Matte) -> Matte:
    return np.divide(part, whole, out=np.zeros_like(part), where=whole > 0.0)


KEPT: dict[BlendMode, Callable[[Matte, Matte], Matte]] = {
    BlendMode.ADD: _add,
    BlendMode.PLUS: _plus,
    BlendMode.SUBTRACT: _add,
    BlendMode.INTERSECT: lambda under, over: over,
    BlendMode.DIFFERENCE: _rest,
    BlendMode.MAX: _rest,
}
"""Which share of what lies under a matte stays: `kept(under, over) -> (h, w)` in [0, 1]."""

SHOWN: dict[BlendMode, Callable[[Matte, Matte], Matte]] = {
    BlendMode.SUBTRACT: lambda under, over: np.zeros_like(over),
    BlendMode.INTERSECT: lambda under, over: np.zeros_like(over),
    BlendMode.DIFFERENCE: lambda under, over: _rest(over, under),
}
"""Which share of the upper matte is seen, where that is not all of it."""


def _of_layer(
    layer: Layer, frame: float, size: tuple[int, int], drawn: Draw, place: Place
) -> tuple[list[Visible], Matte]:
    """The shares of what lies in a layer, and its matte in `place`, beside which it is black."""
    matte: Matte = np.zeros((place[0].stop - place[0].start, place[1].stop - place[1].start), dtype=np.float32)
    shares: list[Visible] = []
    for item in layer.children:
        if not item.visible or (isinstance(item, RotoShape) and not has_area(item, frame)):
            continue
        at = reach(item, frame, size, drawn)
        if isinstance(item, Layer):
            above, over = _of_layer(item, frame, size, drawn, at)
        else:
            patch = drawn(item, frame, size)
            over = patch.whole(size) if patch.outside else patch.seen_in(*at).values
            above = [Visible(item, layer, Patch(at[0].start, at[1].start, over.copy()))]
        shares = _laid(above, over, at, item.blend, shares, matte, place)
    if layer.invert:
        np.subtract(np.float32(1.0), matte, out=matte)
        shares = [Visible(layer, layer, Patch(place[0].start, place[1].start, matte.copy()))]
    opacity = layer.opacity_at(frame)
    if opacity != 1.0:
        for values in (matte, *(share.patch.values for share in shares)):
            np.multiply(values, np.float32(opacity), out=values)
    return shares, matte


def _laid(
    above: list[Visible], over: Matte, at: Place, mode: BlendMode, under: list[Visible], matte: Matte, place: Place
) -> list[Visible]:
    """All shares after the matte `over`, in the rectangle `at`, has been blended into `matte`, which is of `place`."""
    rows, columns = (
        slice(own.start - whole.start, own.stop - whole.start) for own, whole in zip(at, place, strict=True)
    )
    before = matte[rows, columns].copy()
    if mode is BlendMode.INTERSECT:
        matte[:] = 0.0
    matte[rows, columns] = BLENDS[mode](before, over)
    kept = KEPT[mode](before, over)
    under = [_scaled(share, kept, at, beside=mode is not BlendMode.INTERSECT) for share in under]
    if mode in SHOWN:
        shown = SHOWN[mode](before, over)
        above = [_scaled(share, shown, at) for share in above]
    return under + above


def _scaled(share: Visible, factor: Matte, at: Place, *, beside: bool = True) -> Visible:
    """The share after its values were scaled in the rectangle `at`; those `beside` it stay, or are dropped."""
    seen = share.patch.seen_in(*at)
    np.multiply(seen.values, factor[seen.place], out=seen.values)
    if beside:
        return share
    return replace(share, patch=Patch(at[0].start + seen.top, at[1].start + seen.left, seen.values))
