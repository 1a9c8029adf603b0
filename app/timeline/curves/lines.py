"""CurveLine: one curve of the editor as numbers, in the units that it shows. No Qt: the plot paints what it pulls."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry.bezier import ANCHOR
from roam_core.roto import Animated, Layer, Project, RotoShape
from roam_core.roto.animated import cubic_slopes, value_at
from roam_core.roto.value_curves import ValuePlace, values_of_item

from ...model.view_state import ViewState
from ..scale import whole_frames
from ..values.key_forms import form_of
from ..values.shown import OUTLINES, SHOWN_AS, Kind, colour_of, items_in_hand

MOST = 12
"""Curves that are shown at once."""
FINENESS = 400
"""Samples of a curve over the frames in sight, at least."""
MOST_FRAMES = 1500
"""Frames on which an outline is looked at for its curve: no fewer than a plot has pixels."""
RIGHT_BEFORE = 1e-6
"""Frames before a key at which a held value still stands."""


@dataclass(frozen=True)
class CurveKey:
    """A key: its frame and value, its form, and the values at the ends of its handles, a third of a span away.

    `arriving` and `leaving` are (frame, value), or None where there is no cubic on that side.
    """

    frame: int
    value: float
    form: str
    arriving: tuple[float, float] | None = None
    leaving: tuple[float, float] | None = None


@dataclass(frozen=True)
class CurveLine:
    """How one thing varies: `frames (N,)` and `values (N,)` of its line, and its keys, none of what never varies."""

    item_id: str
    title: str
    kind: Kind
    colour: tuple[float, float, float]
    frames: Array
    values: Array
    keys: tuple[CurveKey, ...]

    def place(self, key: CurveKey) -> ValuePlace:
        return self.item_id, self.kind.value, key.frame


def lines_of(project: Project, view: ViewState, kind: Kind, first: float, last: float) -> list[CurveLine]:
    """The curves of a kind of the shapes and layers in hand, over the frames from `first` to `last`.

    What varies comes first: where there are more of them than are shown, none of these is left out for a constant.
    """
    items = items_in_hand(project, view)
    if kind in OUTLINES:
        shapes = [item for item in items if isinstance(item, RotoShape)]
        return [_outline_line(shape, view, kind, first, last) for shape in shapes[:MOST]]
    having = [item for item in items if kind in values_of_item(item)]
    having.sort(key=lambda item: not isinstance(values_of_item(item)[kind], Animated))
    return [_value_line(item, kind, first, last) for item in having[:MOST]]


def value_range(lines: list[CurveLine], kind: Kind) -> tuple[float, float]:
    """The least and greatest value worth showing: with room around, and all that an opacity can be."""
    seen = [line.values for line in lines if len(line.values)]
    ends = [
        end[1]
        for line in lines
        for key in line.keys
        for end in (key.arriving, key.leaving, (0.0, key.value))
        if end is not None
    ]
    low = min([*(each.min() for each in seen), *ends], default=0.0)
    high = max([*(each.max() for each in seen), *ends], default=1.0)
    if kind is Kind.OPACITY:
        low, high = min(low, 0.0), max(high, SHOWN_AS[kind][0])
    room = max(0.12 * (high - low), 0.5)
    return float(low - room), float(high + room)


def ticks(low: float, high: float, most: int) -> list[float]:
    """Round values between two, at most so many."""
    step = 10.0 ** math.floor(math.log10(max(high - low, 1e-9)) - 1)
    factors = (1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0)
    step *= next(factor for factor in factors if (high - low) / (step * factor) <= max(most, 1) or factor == 100.0)
    count = int((high - low) / step) + 2
    begin = math.ceil(low / step)
    return [step * (begin + k) for k in range(count) if step * (begin + k) <= high]


def _value_line(item: Layer | RotoShape, kind: Kind, first: float, last: float) -> CurveLine:
    value = values_of_item(item)[kind]
    factor = SHOWN_AS[kind][0]
    own = value.frames if isinstance(value, Animated) else ()
    frames = np.unique([*np.linspace(first, last, FINENESS), *own, *(frame - RIGHT_BEFORE for frame in own)])
    values = factor * np.array([value_at(value, frame) for frame in frames.tolist()])
    keys = _value_keys(value, factor) if isinstance(value, Animated) else ()
    return CurveLine(item.id, item.name, kind, colour_of(item), frames, values, keys)


def _value_keys(value: Animated, factor: float) -> tuple[CurveKey, ...]:
    keys: list[CurveKey] = []
    for index, key in enumerate(value.keys):
        before = value.keys[index - 1] if index else None
        after = value.keys[index + 1] if index + 1 < len(value.keys) else None
        arriving = leaving = None
        if key.slopes is not None and before is not None and cubic_slopes(before, key) is not None:
            third = (key.frame - before.frame) / 3.0
            arriving = key.frame - third, factor * (key.value - third * key.slopes[0])
        if key.slopes is not None and after is not None and cubic_slopes(key, after) is not None:
            third = (after.frame - key.frame) / 3.0
            leaving = key.frame + third, factor * (key.value + third * key.slopes[1])
        keys.append(CurveKey(key.frame, factor * key.value, form_of(key), arriving, leaving))
    return tuple(keys)


def _outline_line(shape: RotoShape, view: ViewState, kind: Kind, first: float, last: float) -> CurveLine:
    """Where the selected points of a shape, or all of them, are in the mean."""
    chosen = view.selection.indices_of(shape.id)
    axis = 0 if kind is Kind.X else 1

    def place(frame: float) -> float:
        anchors = shape.at(frame).control_points[:, ANCHOR, axis]
        own = [index for index in chosen if index < len(anchors)]
        return float(np.mean(anchors[own] if own else anchors))

    own = [frame for frame in shape.artist_frames if first <= frame <= last]
    frames = np.union1d(whole_frames(first, last, MOST_FRAMES), own)
    values = np.array([place(frame) for frame in frames.tolist()])
    keys = tuple(CurveKey(key.frame, place(key.frame), key.interpolation.value) for key in shape.artist_keys)
    return CurveLine(shape.id, shape.name, kind, shape.colour, frames, values, keys)
