"""Reads a `.fxs` file back to pixels with a hardened XML parser and nothing of the exporter's."""

from __future__ import annotations

from dataclasses import dataclass
from xml.etree.ElementTree import Element

import numpy as np
from defusedxml import ElementTree

from roam_core.arrays import Array


@dataclass
class JudgedShape:
    """An `Object` of type Shape: properties as text, path keys as pixels (P, 3, 2) anchor, in- and out-handle.

    Those of a B-spline are its control points, (P, 1, 2).
    """

    label: str
    hidden: str
    locked: str
    properties: dict[str, str]
    opacity: dict[int, float]
    keys: dict[int, Array]
    interps: dict[int, str]
    closed: set[str]
    kind: str

    def points(self, frame: int) -> Array:
        """The path at a frame, linear or held between its keys."""
        frames = sorted(self.keys)
        before = max((f for f in frames if f <= frame), default=frames[0])
        after = min((f for f in frames if f > before), default=before)
        if frame <= before or after == before or self.interps[before] == "hold":
            return self.keys[before]
        u = (frame - before) / (after - before)
        return (1 - u) * self.keys[before] + u * self.keys[after]


@dataclass
class JudgedLayer:
    """A `Layer`, or an `Object` of that type, with what lies in it."""

    label: str
    hidden: str | None
    locked: str | None
    properties: dict[str, str]
    children: list[JudgedLayer | JudgedShape]

    def shapes(self) -> list[JudgedShape]:
        """All shapes below, in the order of the file."""
        return [
            shape
            for child in self.children
            for shape in (child.shapes() if isinstance(child, JudgedLayer) else [child])
        ]


def judge(text: str) -> tuple[dict[str, str], JudgedLayer]:
    """The session's attributes and its one layer."""
    session = ElementTree.fromstring(text)
    assert session.tag == "Silhouette"
    (root,) = session
    assert root.tag == "Layer"
    scale = (float(session.get("width")), float(session.get("height")), float(session.get("pixelAspect")))
    return dict(session.attrib), _layer(root, scale)


def _layer(element: Element, scale: tuple[float, float, float]) -> JudgedLayer:
    assert element.get("type") == "Layer"
    children: list[JudgedLayer | JudgedShape] = []
    for item in _property(element, "objects"):
        assert item.tag == "Object"
        children.append(_layer(item, scale) if item.get("type") == "Layer" else _shape(item, scale))
    return JudgedLayer(
        element.attrib["label"], element.get("hidden"), element.get("locked"), _constants(element), children
    )


def _shape(element: Element, scale: tuple[float, float, float]) -> JudgedShape:
    kind = element.attrib["shape_type"]
    assert kind in ("Bezier", "Bspline")
    keys = {int(key.attrib["frame"]): key for key in _property(element, "path")}
    assert list(keys) == sorted(keys)
    paths = {frame: key.find("Path") for frame, key in keys.items()}
    assert {path.get("type") for path in paths.values() if path is not None} == {kind}
    opacity = {int(key.attrib["frame"]): float(key.text or "") for key in _property(element, "opacity").findall("Key")}
    return JudgedShape(
        label=element.attrib["label"],
        hidden=element.attrib["hidden"],
        locked=element.attrib["locked"],
        properties=_constants(element),
        opacity=opacity,
        keys={frame: _pixels(path, scale) for frame, path in paths.items() if path is not None},
        interps={frame: key.attrib["interp"] for frame, key in keys.items()},
        closed={path.attrib["closed"] for path in paths.values() if path is not None},
        kind=kind,
    )


def _pixels(path: Element, scale: tuple[float, float, float]) -> Array:
    width, height, aspect = scale
    rows = [point.text or "" for point in path.findall("Point")]
    assert not any("e" in row for row in rows)
    values = [[float(number) for number in row.replace("(", "").replace(")", "").split(",")] for row in rows]
    measured = np.array(values).reshape(len(values), -1, 2)
    return np.stack([measured[..., 0] / aspect * height + width / 2, (measured[..., 1] + 0.5) * height], axis=-1)


def _property(element: Element, name: str) -> Element:
    (found,) = [item for item in element.findall("Properties/Property") if item.get("id") == name]
    return found


def _constants(element: Element) -> dict[str, str]:
    items = element.findall("Properties/Property")
    return {item.attrib["id"]: item.findtext("Value") or "" for item in items if item.find("Value") is not None}
