"""The compact form of keys: those of a shape that are alike are one object, its numbers in one word of base64.

Bit by bit the same numbers come back. Nothing is compressed: the last bits of tracked points are noise, and equal
projects have equal files on every machine.
"""

from __future__ import annotations

import base64
import json
import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain, groupby, repeat
from typing import Any

import numpy as np

from roam_core.arrays import Array
from roam_core.roto.animated import Interpolation
from roam_core.roto.keyframe import Keyframe, Origin
from roam_core.translatable import N_, sentence

Document = dict[str, Any]

FEWEST_PACKED = 8
"""Fewer keys that are alike are written one by one, with numbers to read."""
FEWEST_PACKED_DRAWN = 17
"""The same for an artist's keys."""
LARGEST_FRAME = 2**31 - 1
"""Frame numbers lie between minus this and this: the window counts them in 32 bits."""

_FIELDS = (
    "type", "origin", "interpolation", "points", "feather", "confidence", "vertex_confidence", "inputs", "set_points",
)  # fmt: skip
"""What a key by itself and packed keys have; `frame` and `frames` come to it."""


# ---- numbers ---------------------------------------------------------------------------------------------------------


def packed_numbers(values: Array) -> Document:
    """An array as plain data: its shape, and its numbers as base64 of little-endian 64-bit floats in C order.

    Raises
    ------
    ValueError
        when one of them is not finite.
    """
    if not np.isfinite(values).all():
        raise ValueError(sentence("a number of the project is not finite"))
    data = base64.b64encode(np.ascontiguousarray(values, dtype="<f8").tobytes()).decode("ascii")
    return {"type": "Numbers", "shape": list(values.shape), "data": data}


def unpacked_numbers(document: Any) -> Array:
    """The read-only array that `packed_numbers` made plain.

    Raises
    ------
    ValueError
        when it is damaged, or a number in it is not finite.
    """
    if not isinstance(document, dict) or document.keys() != {"type", "shape", "data"} or document["type"] != "Numbers":
        raise ValueError(sentence("a list of packed numbers is damaged"))
    shape, data = document["shape"], document["data"]
    if not isinstance(shape, list) or len(shape) > 4 or not isinstance(data, str):
        raise ValueError(sentence("a list of packed numbers is damaged"))
    lengths = tuple(whole(length, N_("a length of packed numbers"), 0) for length in shape)
    if len(data) != 4 * math.ceil(8 * math.prod(lengths) / 3):
        raise ValueError(sentence("packed numbers are not as many as they say"))
    values = np.frombuffer(base64.b64decode(data, validate=True), dtype="<f8").astype(np.float64, copy=False)
    if not np.isfinite(values).all():
        raise ValueError(sentence("a packed number is not finite"))
    values = values.reshape(lengths)
    values.setflags(write=False)
    return values


def listed_rows(rows: Any, width: int) -> Array:
    """Lists of `width` numbers each as an array `(K, width)`.

    Raises
    ------
    ValueError
        when they are of another length, or something in them is no finite number.
    """
    if not isinstance(rows, list) or not all(isinstance(row, list) and len(row) == width for row in rows):
        raise ValueError(sentence("what should be rows of {width} numbers is something else", width=width))
    return listed_numbers([value for row in rows for value in row]).reshape(-1, width)


def listed_numbers(values: Any) -> Array:
    """A list of numbers as an array `(K,)`.

    Raises
    ------
    ValueError
        when something in it is no finite number.
    """
    if not isinstance(values, list) or not set(map(type, values)) <= {int, float}:
        raise ValueError(sentence("a list of numbers holds something else"))
    found = np.array(values, dtype=np.float64)
    if not np.isfinite(found).all():
        raise ValueError(sentence("a number is not finite"))
    return found


def number(value: Any, name: str, low: float = -math.inf, high: float = math.inf, of: str = "") -> float:
    """A finite number between `low` and `high`.

    What it is called, and what it is `of` where the name has that place, are marked by `N_`.
    """
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise ValueError(sentence("{name} is no number", name=_called(name, of)))
    if not low <= value <= high:
        raise ValueError(
            sentence(
                "{name} is {value:g}, not between {low:g} and {high:g}",
                name=_called(name, of),
                value=value,
                low=low,
                high=high,
            )
        )
    return float(value)


def whole(value: Any, name: str, low: int = -LARGEST_FRAME, high: int = LARGEST_FRAME, of: str = "") -> int:
    """A whole number from `low` to `high`, called as `number` is."""
    if isinstance(value, bool) or not isinstance(value, int):
        raise ValueError(sentence("{name} is no whole number", name=_called(name, of)))
    if not low <= value <= high:
        raise ValueError(
            sentence("{name} lies not between {low} and {high}", name=_called(name, of), low=low, high=high)
        )
    return value


def _called(name: str, of: str = "") -> str:
    return sentence(name, name=sentence(of)) if of else sentence(name)


def text(value: Any, name: str) -> str:
    """A text."""
    if not isinstance(value, str):
        raise ValueError(sentence("{name} is no text", name=_called(name)))
    return value


# ---- writing keys ----------------------------------------------------------------------------------------------------


def packed_keys(keys: Sequence[Keyframe]) -> list[Document]:
    """A shape's keys as plain data: few that are alike one by one, many as one object; by their first frames."""
    alike: dict[tuple[Any, ...], list[Keyframe]] = {}
    for key in keys:
        alike.setdefault(_constraints(key), []).append(key)
    placed: list[tuple[int, Document]] = []
    for run in alike.values():
        fewest = FEWEST_PACKED_DRAWN if run[0].origin is Origin.ARTIST else FEWEST_PACKED
        if len(run) < fewest:
            placed.extend((key.frame, _plain_key(key)) for key in run)
        else:
            placed.append((run[0].frame, _plain_run(run)))
    return [document for _, document in sorted(placed, key=lambda each: each[0])]


def _constraints(key: Keyframe) -> tuple[Any, ...]:
    """What keys that are alike have in common."""
    vertices = None if key.vertex_confidence is None else key.vertex_confidence.shape
    alike = (key.origin, key.interpolation, key.feather is None, key.confidence is None, vertices, key.set_points)
    return (*alike, json.dumps(dict(key.extra)) if key.extra else "")


def _plain_key(key: Keyframe) -> Document:
    document: Document = {
        "type": "Keyframe",
        "frame": key.frame,
        "origin": key.origin.value,
        "interpolation": key.interpolation.value,
        "points": key.points.reshape(-1, 6).tolist(),
    }
    if key.feather is not None:
        document["feather"] = key.feather.reshape(-1, 6).tolist()
    if key.confidence is not None:
        document["confidence"] = key.confidence
    if key.vertex_confidence is not None:
        document["vertex_confidence"] = key.vertex_confidence.tolist()
    if key.inputs:
        document["inputs"] = key.inputs
    if key.set_points:
        document["set_points"] = list(key.set_points)
    return {**document, **key.extra}


def _plain_run(run: Sequence[Keyframe]) -> Document:
    first = run[0]
    document: Document = {
        "type": "Keyframes",
        "origin": first.origin.value,
        "interpolation": first.interpolation.value,
        "frames": [key.frame for key in run],
        "points": packed_numbers(_without_equal_handles(np.stack([key.points for key in run]))),
    }
    if first.feather is not None:
        document["feather"] = packed_numbers(np.stack([key.feather for key in run if key.feather is not None]))
    if first.confidence is not None:
        document["confidence"] = packed_numbers(np.array([key.confidence for key in run], dtype=np.float64))
    if first.vertex_confidence is not None:
        rows = [key.vertex_confidence for key in run if key.vertex_confidence is not None]
        document["vertex_confidence"] = packed_numbers(np.stack(rows))
    stamps = [[len(list(same)), stamp] for stamp, same in groupby(key.inputs for key in run)]
    if stamps != [[len(run), ""]]:
        document["inputs"] = stamps
    if first.set_points:
        document["set_points"] = list(first.set_points)
    return {**document, **first.extra}


def _without_equal_handles(points: Array) -> Array:
    """Points `(K, P, 3, 2)`, or of polygons their anchors `(K, P, 1, 2)`: all handles lie on them, bit by bit."""
    bits = points.view(np.int64)
    return points[:, :, :1] if np.array_equal(bits[:, :, 1:], np.repeat(bits[:, :, :1], 2, axis=2)) else points


# ---- reading keys ----------------------------------------------------------------------------------------------------


def unpacked_keys(document: Document) -> list[Keyframe]:
    """The keys of a `Keyframe` or a `Keyframes`.

    Raises
    ------
    KeyError, TypeError, ValueError
        when it is damaged.
    """
    if document["type"] == "Keyframe":
        return [_read_key(document)]
    if document["type"] == "Keyframes":
        return list(_read_run(document))
    raise ValueError(sentence("what stands among the keys is no key"))


def _read_key(document: Document) -> Keyframe:
    feather, vertices, confidence = (document.get(k) for k in ("feather", "vertex_confidence", "confidence"))
    return Keyframe(
        frame=whole(document["frame"], N_("the frame of a key")),
        origin=Origin(document["origin"]),
        interpolation=Interpolation(document["interpolation"]),
        points=listed_rows(document["points"], 6).reshape(-1, 3, 2),
        feather=None if feather is None else listed_rows(feather, 6).reshape(-1, 3, 2),
        confidence=None if confidence is None else number(confidence, N_("the confidence of a key")),
        vertex_confidence=None if vertices is None else listed_numbers(vertices),
        inputs=text(document.get("inputs", ""), N_("the inputs of a key")),
        set_points=_read_indices(document, len(document["points"])),
        extra=rest(document, "frame", *_FIELDS),
    )


def _read_indices(document: Document, count: int) -> tuple[int, ...]:
    """The points that the artist set of a key of `count` points."""
    indices = document.get("set_points", [])
    found = tuple(whole(index, N_("a point that was set"), 0, count - 1) for index in indices)
    if list(found) != sorted(set(found)):
        raise ValueError(sentence("the points that were set are not in order"))
    return found


def _read_run(document: Document) -> Iterator[Keyframe]:
    frames = _read_frames(document["frames"])
    count = len(frames)
    points = _read_points(document["points"], count)
    feather = _column(document, "feather", count, points.shape[1:])
    confidence = _column(document, "confidence", count, ())
    vertices = None if "vertex_confidence" not in document else unpacked_numbers(document["vertex_confidence"])
    if vertices is not None and (vertices.ndim != 2 or len(vertices) != count):
        raise ValueError(sentence("the packed keys and their {name} differ in length", name="vertex_confidence"))
    origin, interpolation = Origin(document["origin"]), Interpolation(document["interpolation"])
    chosen, extra = _read_indices(document, points.shape[1]), rest(document, "frames", *_FIELDS)
    for k, (frame, stamp) in enumerate(zip(frames, _stamps(document, count), strict=True)):
        yield Keyframe(
            frame=frame,
            points=points[k],
            feather=None if feather is None else feather[k],
            origin=origin,
            interpolation=interpolation,
            confidence=None if confidence is None else float(confidence[k]),
            vertex_confidence=None if vertices is None else vertices[k],
            inputs=stamp,
            set_points=chosen,
            extra=extra,
        )


def _read_frames(frames: Any) -> list[int]:
    if not isinstance(frames, list) or not set(map(type, frames)) <= {int}:
        raise ValueError(sentence("the frames of packed keys are no whole numbers"))
    for frame in (min(frames, default=0), max(frames, default=0)):
        whole(frame, N_("the frame of a key"))
    return frames


def _read_points(document: Any, count: int) -> Array:
    points = unpacked_numbers(document)
    if points.ndim != 4 or len(points) != count or points.shape[2:] not in ((1, 2), (3, 2)):
        raise ValueError(sentence("the packed keys and their {name} differ in length", name="points"))
    if points.shape[2] == 1:
        points = np.repeat(points, 3, axis=2)
        points.setflags(write=False)
    return points


def _column(document: Document, name: str, count: int, shape: tuple[int, ...]) -> Array | None:
    """The numbers `(count, *shape)` of a field, or None where it is not there."""
    if name not in document:
        return None
    values = unpacked_numbers(document[name])
    if values.shape != (count, *shape):
        raise ValueError(sentence("the packed keys and their {name} differ in length", name=name))
    return values


def _stamps(document: Document, count: int) -> Iterator[str]:
    """The inputs of each key, from pairs (how many, inputs)."""
    pairs = document.get("inputs", [[count, ""]])
    lengths = [whole(length, N_("a length of inputs"), 0) for length, _ in pairs]
    if sum(lengths) != count:
        raise ValueError(sentence("the packed keys and their {name} differ in length", name="inputs"))
    stamps = [text(stamp, N_("the inputs of a key")) for _, stamp in pairs]
    return chain.from_iterable(map(repeat, stamps, lengths))


def rest(document: Mapping[str, Any], *known: str) -> Document:
    """The fields that are not `known`: those of a newer program are kept as they are."""
    return {name: value for name, value in document.items() if name not in known}
