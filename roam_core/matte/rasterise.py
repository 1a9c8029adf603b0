"""One shape on one frame as an antialiased matte: coverage, feather, motion blur, invert and opacity."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from roam_core.arrays import Array, Indices, Matte
from roam_core.geometry import bezier
from roam_core.roto import Interpolation, Outline, RotoShape
from roam_core.roto.sight import is_out_of_sight, moving_in_sight

TOLERANCE = 1.0 / 512.0
"""Pixels by which the polyline that is filled may stray from the spline: that much of a pixel's area at the very most,
and far less on average."""

LEAST_FEATHER = 1e-6
"""Pixels: a narrower edge is a hard one, and in single precision its ramp has no slope."""

LEAST_LEVELS, MOST_LEVELS = 8, 128
"""Bounds on the outlines that are laid between an outline and its feather curve."""


@dataclass(frozen=True)
class Patch:
    """A matte of which only a rectangle is stored: `values (h, w)` float32 from row `top` and column `left`.

    Every pixel beside it has the value `outside`.
    """

    top: int
    left: int
    values: Matte
    outside: float = 0.0

    @property
    def place(self) -> tuple[slice, slice]:
        """Where the values lie in the picture."""
        height, width = self.values.shape
        return slice(self.top, self.top + height), slice(self.left, self.left + width)

    def seen_in(self, rows: slice, columns: slice) -> Patch:
        """The patch in a part of its picture, told from that part's corner; empty where it does not reach there."""
        (above, below), (left, right) = (
            (max(own.start, part.start), min(own.stop, part.stop))
            for own, part in zip(self.place, (rows, columns), strict=True)
        )
        if above >= below or left >= right:
            return Patch(0, 0, np.zeros((0, 0), dtype=np.float32), self.outside)
        values = self.values[above - self.top : below - self.top, left - self.left : right - self.left]
        return Patch(above - rows.start, left - columns.start, values, self.outside)

    def whole(self, size: tuple[int, int]) -> Matte:
        """The matte `(h, w)` of the whole picture."""
        matte = np.full(size, self.outside, dtype=np.float32)
        matte[self.place] = self.values
        return matte


def shape_matte(shape: RotoShape, frame: float, size: tuple[int, int]) -> Matte:
    """The matte of one shape, as if it were alone.

    Parameters
    ----------
    shape : visible or not. An open shape has no area, and outside its lifetime a shape does not exist: both give zeros,
        inverted or not. Nothing is inside of one that is out of sight (`roto.sight`), and motion blur does not show how
        it closes.
    frame : the plate's frame number. With motion blur the shutter opens at `frame + phase`.
    size : (h, w) of the image.

    Returns
    -------
    (h, w) float32 in [0, 1]: coverage with its soft edge, averaged over the open shutter, then inverted, then scaled by
    the opacity.
    """
    return shape_patch(shape, frame, size).whole(size)


def shape_patch(shape: RotoShape, frame: float, size: tuple[int, int]) -> Patch:
    """What `shape_matte` gives, stored in the rectangle that the shape reaches: small shapes cost little anywhere."""
    if not has_area(shape, frame):
        return Patch(0, 0, np.zeros((0, 0), dtype=np.float32))
    moments = _moments(shape, frame)
    first, last = moving_in_sight(shape, frame, min(moments), max(moments))
    outlines = [shape.at(min(max(moment, first), last)) for moment in moments]
    feathers = [shape.feather_at(moment) for moment in moments]
    top, bottom, left, right = _reach(outlines, max(feathers), size)
    values = np.zeros((bottom - top, right - left), dtype=np.float32)
    if values.size and not is_out_of_sight(shape, frame):  # a point has no edge that could be soft
        moved = [_moved(outline, left, top) for outline in outlines]
        values = _over_shutter(moved, feathers, values.shape, jumps=_jumps(shape, moments))
    outside = 0.0
    if shape.invert:
        values, outside = np.float32(1.0) - values, 1.0
    opacity = shape.opacity_at(frame)
    if opacity != 1.0:
        values, outside = values * np.float32(opacity), outside * opacity
    return Patch(top, left, values, outside)


def has_area(shape: RotoShape, frame: float) -> bool:
    """True when the shape is closed and exists at `frame`."""
    return shape.closed and shape.exists_at(frame)


def outline_matte(outline: Outline, feather: float, size: tuple[int, int]) -> Matte:
    """Coverage `(h, w)` of a closed outline with its soft edges.

    A feather curve gives the mean coverage of all outlines between the outline and the curve, each the linear blend of
    the two at one weight: the matte falls evenly from 1 to 0 across the gap, on whichever side of the outline the curve
    lies. The uniform `feather` is a ramp over the distance to the outline, in pixels, outwards where it is positive and
    inwards where it is negative, averaged over each pixel. Where a shape has both, the matte is as soft as the wider of
    the two outside.
    """
    from roam_core.kernels.coverage import coverage, distance, holds_centres  # numba: a command's help must not wait

    line, feathered = _lines(outline)
    if feathered is None:
        matte = coverage(line, size)
    else:
        matte = _between(line, feathered, size)
    if abs(feather) >= LEAST_FEATHER:
        # A wide ramp hides what a narrow one shows: by a 512th of its width the line may stray.
        coarse = outline.flatten(float(np.clip(abs(feather) / 512.0, TOLERANCE, 0.05)))
        away = distance(coarse, size, abs(feather) + 0.5)
        # By its centre, not by its coverage: in a corner that passes a half while the centre is well inside or outside.
        signed = np.where(holds_centres(coarse, size), -away, away)
        if feather > 0.0:
            np.maximum(matte, _ramp(signed, feather), out=matte)
        else:
            np.minimum(matte, np.float32(1.0) - _ramp(-signed, -feather), out=matte)
    return matte


def _ramp(signed: Matte, width: float) -> Matte:
    """The mean over a pixel of the ramp that falls from 1 on the outline to 0 at `width` pixels outside of it.

    `signed (h, w)` is the distance of the pixel's centre to the outline, outside positive. The mean is taken across the
    outline: exact where it is straight and runs along the pixels.
    """
    near, far = signed - np.float32(0.5), signed + np.float32(0.5)
    inside = np.minimum(far, np.float32(0.0)) - np.minimum(near, np.float32(0.0))
    first, last = (np.clip(end, np.float32(0.0), np.float32(width)) for end in (near, far))
    # The integral over what lies on the ramp as a product: a difference of integrals loses digits as the ramp widens.
    on = (last - first) * (np.float32(1.0) - np.float32(0.5 / width) * (first + last))
    ramp: Matte = np.clip(inside + on, np.float32(0.0), np.float32(1.0))
    return ramp


def _reach(outlines: list[Outline], feather: float, size: tuple[int, int]) -> tuple[int, int, int, int]:
    """Rows and columns (top, bottom, left, right; half open) outside of which the outlines leave the picture black.

    A spline lies within the hull of its control points.
    """
    hulls = [outline.points.reshape(-1, 2) for outline in outlines]
    hulls += [(o.points + o.feather).reshape(-1, 2) for o in outlines if o.feather is not None]
    hull, margin = np.concatenate(hulls), max(feather + 1.0, 0.0)
    if not np.isfinite(hull).all():
        raise ValueError("a shape has a point that is not finite")
    bounds = np.array([size[1], size[0]], dtype=np.float64)
    low = np.clip(np.floor(hull.min(axis=0) - margin), 0.0, bounds).astype(np.intp)
    high = np.clip(np.ceil(hull.max(axis=0) + margin), low, bounds).astype(np.intp)
    return int(low[1]), int(high[1]), int(low[0]), int(high[0])


def _moved(outline: Outline, left: int, top: int) -> Outline:
    return Outline(outline.points - np.array([left, top], dtype=np.float64), outline.feather, outline.closed)


def _over_shutter(outlines: list[Outline], feathers: list[float], size: tuple[int, int], *, jumps: bool) -> Matte:
    """The mean matte over the open shutter, from outlines and feathers at the borders and middles of equal parts of it.

    A shape with a soft edge is filled once a part, at its middle. One without is swept through each part, from border
    to border, so that its edge leaves an even ramp however far it moves; not where it `jumps` on the way.
    """
    if len(set(feathers)) == 1 and all(_same(outline, outlines[0]) for outline in outlines[1:]):
        return outline_matte(outlines[0], feathers[0], size)
    is_soft = any(feathers) or any(o.feather is not None and o.feather.any() for o in outlines)
    if not is_soft and not jumps:
        return _swept(outlines[::2], size)
    total = np.zeros(size, dtype=np.float32)
    middles = outlines[1::2]
    for outline, feather in zip(middles, feathers[1::2], strict=True):
        total += outline_matte(outline, feather, size)
    return total / np.float32(len(middles))


def _swept(borders: list[Outline], size: tuple[int, int]) -> Matte:
    """The mean coverage of outlines that move evenly from each of the borders to the next one."""
    from roam_core.kernels.coverage import swept_coverage
    from roam_core.kernels.flattening import step_counts

    segments = np.stack([bezier.segments(outline.points) for outline in borders])
    counts = np.max([step_counts(control, TOLERANCE) for control in segments], axis=0)
    segment, weights = _places(counts)
    lines = np.einsum("nk,mnkc->mnc", weights, segments[:, segment])
    total = np.zeros(size, dtype=np.float32)
    for start, end in pairwise(lines):
        total += swept_coverage(start, end, size)
    return total / np.float32(len(lines) - 1)


def _moments(shape: RotoShape, frame: float) -> list[float]:
    """The frame alone; or borders and middles of equal parts of the open shutter in turn, the borders at both ends."""
    blur = shape.motion_blur
    if blur is None or not blur.is_seen:
        return [frame]
    halves = 2 * blur.samples
    return [frame + blur.phase + blur.shutter * half / halves for half in range(halves + 1)]


def _jumps(shape: RotoShape, moments: list[float]) -> bool:
    """Whether a held key gives way to the next one while the shutter is open."""
    opens, closes = min(moments), max(moments)
    return any(
        start.interpolation is Interpolation.HOLD and opens < stop.frame <= closes
        for start, stop in pairwise(shape.keys)
    )


def _same(a: Outline, b: Outline) -> bool:
    """True for two moments of a shape that holds still, which need filling only once."""
    if (a.feather is None) != (b.feather is None):
        return False
    still = np.array_equal(a.points, b.points)
    return still and (a.feather is None or b.feather is None or np.array_equal(a.feather, b.feather))


def _lines(outline: Outline) -> tuple[Array, Array | None]:
    """The outline as a polyline `(K, 2)`, and its feather curve at the same `(segment, t)` pairs where it has one."""
    if outline.feather is None or not outline.feather.any():
        return outline.flatten(TOLERANCE), None
    from roam_core.kernels.flattening import step_counts

    inner = bezier.segments(outline.points)
    outer = bezier.segments(outline.points + outline.feather)
    counts = np.maximum(step_counts(inner, TOLERANCE), step_counts(outer, TOLERANCE))
    segment, weights = _places(counts)
    line, feathered = (np.einsum("nk,nkc->nc", weights, control[segment]) for control in (inner, outer))
    return line, feathered


def _places(counts: Indices) -> tuple[Indices, Array]:
    """Segments `(N,)` and weights `(N, 4)` of their control points for `counts (S,)` equal steps along each segment."""
    segment, t = bezier.even_pairs(counts)
    return segment, bezier.bernstein(t)


def _between(line: Array, feathered: Array, size: tuple[int, int]) -> Matte:
    """Mean coverage of the outlines between two that are joined vertex by vertex, about one a pixel of their gap.

    Where that would be too many, each is swept to the next one: the gap shows no bands.
    """
    from roam_core.kernels.coverage import coverage, swept_coverage

    gap = float(np.hypot(*(feathered - line).T).max())
    levels = int(np.clip(np.ceil(gap), LEAST_LEVELS, MOST_LEVELS))

    def at(level: float) -> Array:
        weight = level / levels
        return np.asarray((1.0 - weight) * line + weight * feathered)

    total = np.zeros(size, dtype=np.float32)
    for level in range(levels):
        is_wide = gap > levels
        total += swept_coverage(at(level), at(level + 1), size) if is_wide else coverage(at(level + 0.5), size)
    return total / np.float32(levels)
