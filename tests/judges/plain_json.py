"""Our JSON as somebody would read it who has nothing but its description in docs/FORMATS.md."""

from __future__ import annotations

import json
from itertools import pairwise
from typing import Any

import numpy as np

from roam_core.arrays import Array
from tests.judges.coverage import between, filled, soft, union
from tests.judges.moving import between as moved

BLENDS = {
    "add": union,
    "plus": lambda under, own: np.minimum(under + own, 1.0),
    "subtract": lambda under, own: under * (1.0 - own),
    "intersect": lambda under, own: under * own,
    "difference": lambda under, own: np.abs(under - own),
    "max": np.maximum,
}


def matte(text: str, frame: float, size: tuple[int, int]) -> Array:
    """The matte `(h, w)` at a frame."""
    return _joined(json.loads(text)["items"], frame, size)


def names(text: str) -> list[str]:
    """The names of all shapes, in the order of the file."""
    return list(_names(json.loads(text)["items"]))


def _names(items: list[Any]) -> list[str]:
    return [name for item in items for name in (_names(item["items"]) if "items" in item else [item["name"]])]


def _joined(items: list[Any], frame: float, size: tuple[int, int]) -> Array:
    joint = np.zeros(size)
    for item in items:
        own = _own(item, frame, size) if item["visible"] else None
        if own is not None:
            own = 1.0 - own if item["invert"] else own
            joint = BLENDS[item["blend"]](joint, own * _value(item["opacity"], frame))
    return joint


def _own(item: dict[str, Any], frame: float, size: tuple[int, int]) -> Array | None:
    if item["kind"] == "layer":
        return _joined(item["items"], frame, size)
    life = item["lifetime"]
    if not item["closed"] or (life is not None and not life[0] <= frame < life[1]):
        return None
    points = moved([(key["frame"], key["interpolation"], _points(key["points"])) for key in item["keys"]], frame)
    width = _value(item["feather"], frame)
    if any(key.get("feather") for key in item["keys"]):
        assert width == 0.0, "no judge of both kinds of feather"
        offsets = [(key["frame"], key["interpolation"], _points(key["feather"])) for key in item["keys"]]
        return between(points, points + moved(offsets, frame), size)
    return soft(points, size, min(width, 0.0), max(width, 0.0)) if width else filled(points, size)


def _points(rows: list[list[float]]) -> Array:
    return np.array([row * (6 // len(row)) for row in rows]).reshape(-1, 3, 2)


def _value(value: Any, frame: float) -> float:
    if not isinstance(value, list):
        return float(value)
    for before, after in pairwise(value):
        slopes = before.get("slopes"), after.get("slopes")
        if before["frame"] < frame < after["frame"] and before["interpolation"] != "hold" and any(slopes):
            return _cubic(before, after, frame)
    return float(moved([(key["frame"], key["interpolation"], key["value"]) for key in value], frame))


def _cubic(before: dict[str, Any], after: dict[str, Any], frame: float) -> float:
    """Between two keys of which one has tangents: by Hermite's form."""
    span = after["frame"] - before["frame"]
    u, own = (frame - before["frame"]) / span, (after["value"] - before["value"]) / span
    own *= before["interpolation"] == "linear"
    leaving, arriving = before.get("slopes", (0, own))[1], after.get("slopes", (own, 0))[0]
    ends = (2 * u**3 - 3 * u**2 + 1) * before["value"] + (3 * u**2 - 2 * u**3) * after["value"]
    return float(ends + span * ((u**3 - 2 * u**2 + u) * leaving + (u**3 - u**2) * arriving))
