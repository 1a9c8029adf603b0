"""Silhouette as a judge: a shape file is read by an XML parser alone, and composited as its manual describes.

Objects of a layer join bottom first by their modes; a layer is joined inside itself, inverted where it says so, and
joins by its own mode. Positions are measured from the centre in image heights; keys count from the session's start.
"""

from __future__ import annotations

import re
from xml.etree.ElementTree import Element

import numpy as np
from defusedxml import ElementTree

from roam_core.arrays import Array
from tests.judges.coverage import filled, union
from tests.judges.moving import between

MODES = {
    "Add": union,
    "Subtract": lambda under, own: under * (1.0 - own),
    "Difference": lambda under, own: np.abs(under - own),
    "Max": np.maximum,
    "Inside": lambda under, own: under * own,
}


def matte(text: str, frame: float, size: tuple[int, int]) -> Array:
    """The matte `(h, w)` of a shape file on a frame of the plate."""
    session = ElementTree.fromstring(text)
    width, height = float(session.get("width")), float(session.get("height"))
    scale = (width, height, float(session.get("pixelAspect")))
    joint = np.zeros(size)
    for element in session:
        joint = _joined(joint, element, frame - float(session.get("sessionStartFrame")), scale)
    return joint


def names(text: str) -> list[str]:
    """The labels of all shapes."""
    return [each.get("label", "") for each in ElementTree.fromstring(text).iter() if each.get("type") == "Shape"]


def _joined(under: Array, element: Element, frame: float, scale: tuple[float, float, float]) -> Array:
    """What an object makes of what lies under it."""
    if element.get("hidden", "False") == "True":
        return under
    opacity = _number(element, "opacity", frame, 100.0) / 100.0
    if element.get("type") == "Layer":
        own = np.zeros(under.shape)
        for child in _property(element, "objects"):
            own = _joined(own, child, frame, scale)
    else:
        keys = [(float(key.get("frame", "")), key.get("interp", ""), key) for key in _property(element, "path")]
        if any(path.get("closed") != "True" for _, _, key in keys for path in key):
            return under
        own = filled(between([(at, how, _points(key, scale)) for at, how, key in keys], frame), under.shape)
    own = 1.0 - own if _text(element, "invert", "false") == "true" else own
    return np.asarray(MODES[_text(element, "mode", "Add")](under, own * opacity))


def _points(key: Element, scale: tuple[float, float, float]) -> Array:
    """Anchor, in- and out-handle `(P, 3, 2)` in pixels, of a Bezier or of the Bezier of a uniform cubic B-spline."""
    width, height, aspect = scale
    (path,) = key
    rows = [re.findall(r"-?\d+\.\d+", point.text or "") for point in path]
    values = np.array(rows, dtype=np.float64).reshape(len(rows), -1, 2)
    pixels = np.stack([values[..., 0] * height / aspect + width / 2.0, values[..., 1] * height + height / 2.0], axis=-1)
    if path.get("type") == "Bezier":
        return pixels
    hull = pixels[:, 0]
    before, after = np.roll(hull, 1, axis=0), np.roll(hull, -1, axis=0)
    return np.stack([(before + 4 * hull + after) / 6, (before + 2 * hull) / 3, (2 * hull + after) / 3], axis=1)


def _property(element: Element, name: str) -> Element:
    (found,) = [each for each in element.findall("Properties/Property") if each.get("id") == name]
    return found


def _text(element: Element, name: str, default: str) -> str:
    for each in element.findall("Properties/Property"):
        if each.get("id") == name:
            return each.findtext("Value") or default
    return default


def _number(element: Element, name: str, frame: float, default: float) -> float:
    for each in element.findall("Properties/Property"):
        if each.get("id") == name and each.find("Key") is not None:
            keys = [(float(k.get("frame", "")), k.get("interp", ""), float(k.text or "")) for k in each]
            return float(between(keys, frame))
    return float(_text(element, name, str(default)))
