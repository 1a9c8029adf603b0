"""Mattes of several shapes joined into one, layer by layer, by their blend modes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import numpy as np

from roam_core.arguments import moment, size_of
from roam_core.arrays import Matte
from roam_core.matte.rasterise import Patch, has_area, shape_patch
from roam_core.roto import BlendMode, Layer, Project, RotoShape
from roam_core.roto.given import shapes_of

Draw = Callable[[RotoShape, float, tuple[int, int]], Patch]
"""Fills one shape at one frame in a picture of `(h, w)`: `shape_patch`, or what remembers its answers."""

Place = tuple[slice, slice]
"""Rows and columns of a picture."""


def _add(under: Matte, matte: Matte) -> Matte:
    return under + matte * (np.float32(1.0) - under)


def _plus(under: Matte, matte: Matte) -> Matte:
    total: Matte = np.minimum(under + matte, np.float32(1.0))
    return total


def _subtract(under: Matte, matte: Matte) -> Matte:
    return under * (np.float32(1.0) - matte)


def _intersect(under: Matte, matte: Matte) -> Matte:
    return under * matte


def _difference(under: Matte, matte: Matte) -> Matte:
    apart: Matte = np.abs(under - matte)
    return apart


def _max(under: Matte, matte: Matte) -> Matte:
    greater: Matte = np.maximum(under, matte)
    return greater


BLENDS: dict[BlendMode, Callable[[Matte, Matte], Matte]] = {
    BlendMode.ADD: _add,
    BlendMode.PLUS: _plus,
    BlendMode.SUBTRACT: _subtract,
    BlendMode.INTERSECT: _intersect,
    BlendMode.DIFFERENCE: _difference,
    BlendMode.MAX: _max,
}
"""What a matte makes of what lies under it in its layer: `blend(under, matte) -> (h, w)` in [0, 1]."""


def render_matte(
    shapes: Project | Layer | RotoShape | Iterable[RotoShape],
    frame: float,
    size: tuple[int, int],
    drawn: Draw = shape_patch,
) -> Matte:
    """The joint matte of shapes at one frame.

    Shapes are joined bottom first. A layer is joined inside itself, then inverted, then scaled by its opacity, and
    joined with what lies under it by its mode; a project is its root layer. What is invisible takes no part, nor does a
    shape that is open or outside its lifetime: it does not count as an empty one, which under INTERSECT would wipe out
    what lies under it.

    Parameters
    ----------
    shapes : a project, a layer that lies in no moving one, or shapes in plate space in the order of compositing.
    frame : the plate's frame number.
    size : (h, w) of the image.
    drawn : fills one shape; whoever needs shapes more than once gives a function that remembers.

    Returns
    -------
    (h, w) float32 in [0, 1].

    Raises
    ------
    ValueError
        when an argument is not what it should be.
    """
    frame, size = moment(frame), size_of(size)
    if isinstance(shapes, Project):
        shapes = shapes.plate_root
    if isinstance(shapes, Layer):
        shapes = shapes.in_plate_space()
        return _layer_matte(shapes, frame, size, drawn) if shapes.visible else np.zeros(size, dtype=np.float32)
    return _join(shapes_of(shapes), frame, size, drawn)


def cut_patch(
    item: Layer | RotoShape, cutters: Sequence[Layer | RotoShape], frame: float, size: tuple[int, int], drawn: Draw
) -> Patch:
    """An item in plate space and what above it only takes away from it, as `render_matte` joins them.

    Stored in the rectangle that the item reaches: of hundreds of small items in a large picture each costs little.
    """
    place = reach(item, frame, size, drawn)
    return Patch(place[0].start, place[1].start, _join((item, *cutters), frame, size, drawn, place))


def reach(item: Layer | RotoShape, frame: float, size: tuple[int, int], drawn: Draw) -> Place:
    """The rectangle beside which an item in plate space is black."""
    whole, nothing = (slice(0, size[0]), slice(0, size[1])), (slice(0, 0), slice(0, 0))
    if not item.visible:
        return nothing
    if isinstance(item, Layer):
        reached = [] if item.invert else [reach(child, frame, size, drawn) for child in item.children]
        some = [place for place in reached if place[0].start < place[0].stop and place[1].start < place[1].stop]
        if not some:
            return whole if item.invert else nothing
        rows, columns = zip(*some, strict=True)
        return _around(rows), _around(columns)
    if not has_area(item, frame):
        return nothing
    patch = drawn(item, frame, size)
    if patch.outside != 0.0:
        return whole
    return patch.place if patch.values.size else nothing


def _around(ranges: Iterable[slice]) -> slice:
    starts, stops = zip(*((each.start, each.stop) for each in ranges), strict=True)
    return slice(min(starts), max(stops))


def _layer_matte(layer: Layer, frame: float, size: tuple[int, int], drawn: Draw, place: Place | None = None) -> Matte:
    matte = _join(layer.children, frame, size, drawn, place)
    if layer.invert:
        np.subtract(np.float32(1.0), matte, out=matte)
    opacity = layer.opacity_at(frame)
    if opacity != 1.0:
        matte *= np.float32(opacity)
    return matte


def _join(
    items: Iterable[Layer | RotoShape], frame: float, size: tuple[int, int], drawn: Draw, place: Place | None = None
) -> Matte:
    """Items joined in a picture of `size`, or in that part of it which is its `place`."""
    rows, columns = place or (slice(0, size[0]), slice(0, size[1]))
    matte: Matte = np.zeros((rows.stop - rows.start, columns.stop - columns.start), dtype=np.float32)
    for item in items:
        if not item.visible:
            continue
        if isinstance(item, Layer):
            matte = BLENDS[item.blend](matte, _layer_matte(item, frame, size, drawn, place))
        elif has_area(item, frame):
            patch = drawn(item, frame, size)
            _put(patch if place is None else patch.seen_in(rows, columns), item.blend, matte)
    return matte


def _put(patch: Patch, mode: BlendMode, matte: Matte) -> None:
    """Blend a shape into the matte `(h, w)` under it; only where the shape reaches, unless black beside it matters."""
    if patch.outside != 0.0:
        matte[:] = BLENDS[mode](matte, patch.whole(matte.shape))
        return
    region = BLENDS[mode](matte[patch.place], patch.values)
    if mode is BlendMode.INTERSECT:
        matte[:] = 0.0
    matte[patch.place] = region
