"""What varies with time in a setting of Fusion's: the splines behind a polyline, a level, a soft edge, as our keys."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from roam_core.arrays import Array
from roam_core.interchange.fusion.text import Table
from roam_core.interchange.keys.keying import STEP
from roam_core.interchange.reading import ShapeReader, brief
from roam_core.roto import Animated, Interpolation, ValueKey
from roam_core.roto.animated import Animatable, mapped, values_of
from roam_core.translatable import sentence

Tools = Mapping[str, Table]

PARTS = ("X", "Y", "LX", "LY", "RX", "RY")


@dataclass(frozen=True)
class PathKey:
    """A polyline on a frame: positions (P, 3, 2) of anchor, in- and out-handle from the centre, or (P, 1, 2) of control
    points, in image widths and heights, y up."""

    frame: int
    rows: Array
    closed: bool
    interpolation: Interpolation


@dataclass(frozen=True)
class _Stamp:
    """A key of a spline: its value, whether what leads to it or away from it is a step, and whether it is eased."""

    time: float
    value: Any
    step_in: bool
    step_out: bool
    eased: bool


def keys_of_path(reader: ShapeReader, title: str, inputs: Table, tools: Tools, is_polygon: bool) -> list[PathKey]:
    """The keys of a mask's polyline; a constant one has its key on the clip's first frame."""
    made = inputs.table("Polyline")
    source = made.named.get("SourceOp")
    if source is None:
        path = made.named.get("Value")
        stamps = [_Stamp(reader.clip.first + reader.options.frame_offset, path, False, False, False)]
    else:
        stamps = _stamps(tools, str(source), "Value")
    if not stamps or not all(isinstance(stamp.value, Table) for stamp in stamps):
        raise ValueError(sentence("it has no polyline"))
    count = len(stamps[0].value.table("Points").listed)
    if count < 2:
        raise ValueError(sentence("it has fewer than two points"))
    reader.check_points(count * len(stamps), title, len(stamps))
    rows = {id(stamp): _rows(stamp.value, count, is_polygon) for stamp in stamps}
    held = _held(reader, title, stamps, lambda a, b: bool((rows[id(a)] == rows[id(b)]).all()))
    return [
        PathKey(frame, rows[id(stamp)], stamp.value.named.get("Closed") is True, interpolation)
        for frame, stamp, interpolation in held
    ]


def opacity_of(reader: ShapeReader, title: str, inputs: Table, tools: Tools) -> Animatable:
    """The level of a mask."""
    return mapped(_value(reader, title, inputs, tools, "Level", 1.0), lambda level: min(max(level, 0.0), 1.0))


def feather_of(reader: ShapeReader, title: str, inputs: Table, tools: Tools, width: float) -> Animatable:
    """The soft edge of a mask in pixels, outwards or inwards by its border; it covers the same ground where the border
    is half of it, as our writer has it."""
    edge = _value(reader, title, inputs, tools, "SoftEdge", 0.0)
    border = _value(reader, title, inputs, tools, "BorderWidth", 0.0)
    edges, borders = values_of(edge), values_of(border)
    if not any(edges):
        if any(borders):
            reader.note(sentence("The border of {name}, which moves its edge, is not read.", name=brief(title)))
        return 0.0
    if len(edges) != len(borders) or any(
        abs(abs(b) * 2.0 - e) > 1e-8 + 1e-6 * e for e, b in zip(edges, borders, strict=True)
    ):
        reader.note(
            sentence(
                "The soft edge of {name} lies on both sides of its outline; it was read as outside.", name=brief(title)
            )
        )
        if any(borders):
            reader.note(sentence("The border of {name}, which moves its edge, is not read.", name=brief(title)))
        return mapped(edge, lambda share: _sane(share * width))
    return mapped(border, lambda share: _sane(share * 2.0 * width))


def _sane(pixels: float) -> float:
    return min(max(pixels, -1e6), 1e6)


def _value(reader: ShapeReader, title: str, inputs: Table, tools: Tools, name: str, standard: float) -> Animatable:
    made = inputs.table(name)
    source = made.named.get("SourceOp")
    if source is None:
        return made.number("Value", standard)
    stamps = _stamps(tools, str(source), None)
    if not stamps or not all(isinstance(stamp.value, float) for stamp in stamps):
        reader.note(
            sentence(
                "{field} of {name} comes from {source}, which is not read.",
                field=name,
                name=brief(title),
                source=brief(str(source)),
            )
        )
        return standard
    reader.check_points(0, title, len(stamps))
    held = _held(reader, title, stamps, lambda a, b: bool(a.value == b.value))
    return Animated(tuple(ValueKey(frame, stamp.value, interpolation) for frame, stamp, interpolation in held))


def _stamps(tools: Tools, name: str, field: str | None) -> list[_Stamp]:
    """The keys of a spline in order of time: their `field`, or their number."""
    spline = tools.get(name, Table())
    if spline.kind != "BezierSpline":
        return []
    stamps = []
    for time, key in spline.table("KeyFrames").named.items():
        if not isinstance(time, float) or not isinstance(key, Table):
            raise ValueError(sentence("its spline {name} has a key that is none", name=brief(name)))
        flags = key.table("Flags").named
        number = key.listed[0] if key.listed else None
        value = key.named.get(field) if field else number
        eased = flags.get("Linear") is not True and ("LH" in key.named or "RH" in key.named)
        stamps.append(_Stamp(time, value, flags.get("StepIn") is True, flags.get("StepOut") is True, eased))
    return sorted(stamps, key=lambda stamp: stamp.time)


def _held(reader: ShapeReader, title: str, stamps: list[_Stamp], same: Any) -> list[tuple[int, _Stamp, Interpolation]]:
    """The keys on whole frames and how they move on; one that repeats another just before the next makes it a hold."""
    result: list[tuple[int, _Stamp, Interpolation]] = []
    for index, stamp in enumerate(stamps):
        following = stamps[index + 1] if index + 1 < len(stamps) else None
        if result and following is not None and following.time - stamp.time <= STEP:
            frame, before, _ = result[-1]
            if same(before, stamp):
                result[-1] = (frame, before, Interpolation.HOLD)
                continue
        is_step = stamp.step_out or (following is not None and following.step_in)
        frame = reader.frame(stamp.time)
        if not math.isclose(stamp.time, round(stamp.time), abs_tol=1e-6):
            reader.note(
                sentence("{name} has keys between frames; they were moved to the nearest ones.", name=brief(title))
            )
        if result and result[-1][0] == frame:
            result.pop()
        result.append((frame, stamp, Interpolation.HOLD if is_step else Interpolation.LINEAR))
        if stamp.eased:
            reader.note(sentence("{name} has eased keys; they were read as straight ones.", name=brief(title)))
    return result


def _rows(path: Table, count: int, is_polygon: bool) -> Array:
    """Positions (P, 3, 2) of anchors and handles, or (P, 1, 2) of control points."""
    points = path.table("Points").listed
    if len(points) != count or not all(isinstance(point, Table) for point in points):
        raise ValueError(sentence("its keys differ in their number of points"))
    names = PARTS if is_polygon else PARTS[:2]
    rows = np.array([[point.number(name, 0.0) for name in names] for point in points]).reshape(count, -1, 2)
    rows[:, 1:] += rows[:, :1]
    return rows
