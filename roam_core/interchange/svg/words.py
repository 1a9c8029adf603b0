"""Words of SVG that its writer and its reader share, and its small grammars: numbers, lengths, colours, transforms."""

from __future__ import annotations

import math
import re
from collections.abc import Callable

import numpy as np

from roam_core.arrays import Array
from roam_core.interchange.reading import MAX_NUMBER
from roam_core.translatable import sentence

SVG = "http://www.w3.org/2000/svg"
INKSCAPE = "http://www.inkscape.org/namespaces/inkscape"
SODIPODI = "http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"
XLINK = "http://www.w3.org/1999/xlink"
LABEL, LAYER_MODE, INSENSITIVE = f"{{{INKSCAPE}}}label", f"{{{INKSCAPE}}}groupmode", f"{{{SODIPODI}}}insensitive"

AID, PART = "data-roam-aid", "data-roam-part"
"""Of elements that serve our picture alone, and of those that only wrap shapes of ours."""

LIGHT, DARK = "white", "black"

NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
UNITS = {"": 1.0, "px": 1.0, "pt": 96 / 72, "pc": 16.0, "in": 96.0, "cm": 96 / 2.54, "mm": 96 / 25.4, "q": 96 / 101.6}
"""Pixels of one unit, at the 96 pixels an inch that CSS lays down."""

MAX_TRANSFORMS = 100
"""Of one list: drawing programs write one or two."""

COLOURS = {
    "black": "#000000", "silver": "#c0c0c0", "gray": "#808080", "grey": "#808080", "white": "#ffffff",
    "maroon": "#800000", "red": "#ff0000", "purple": "#800080", "fuchsia": "#ff00ff", "green": "#008000",
    "lime": "#00ff00", "olive": "#808000", "yellow": "#ffff00", "navy": "#000080", "blue": "#0000ff",
    "teal": "#008080", "aqua": "#00ffff", "orange": "#ffa500",
}  # fmt: skip

ORIGINS = {"left": "0", "top": "0", "center": "50%", "right": "100%", "bottom": "100%"}
"""Words of a `transform-origin` as lengths."""

IDENTITY: Array = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])


def svg_tag(name: str) -> str:
    """The tag of an element of SVG."""
    return f"{{{SVG}}}{name}"


def xlink_href() -> str:
    """The attribute by which a `use` names what it repeats, in the spelling that all programs know."""
    return f"{{{XLINK}}}href"


def decimal(value: float) -> str:
    """Six decimals without trailing zeros."""
    return f"{value:.6f}".rstrip("0").rstrip(".") if round(value, 6) else "0"


def number(word: str) -> float:
    """A word of the form `NUMBER`, brought within `MAX_NUMBER`: what lies that far is left out as a whole."""
    return min(max(float(word), -MAX_NUMBER), MAX_NUMBER)


def numbers(text: str | None, count: Callable[[int], None] = lambda _: None) -> list[float]:
    """All numbers of a list, whatever stands between them; `count` is told how many, and may refuse."""
    words = re.findall(NUMBER, text or "")
    count(len(words))
    return [number(word) for word in words]


def length(text: str | None, whole: float, default: float = 0.0) -> float:
    """A length in pixels; percentages are of `whole`. What is no length is the default."""
    found = re.fullmatch(rf"\s*({NUMBER})\s*(%|[A-Za-z]*)\s*", text or "")
    if found is None:
        return default
    value, unit = number(found.group(1)), found.group(2).lower()
    if unit == "%":
        return value / 100.0 * whole
    return value * UNITS[unit] if unit in UNITS else default


def colour(text: str | None) -> tuple[float, float, float] | None:
    """A colour of the forms `#rgb`, `#rrggbb` and `rgb(...)`, or one of CSS's sixteen old names, or None.

    What such a form says of transparency is passed over: `paint_share` has it.
    """
    text = (text or "").strip().lower()
    text = COLOURS.get(text, text)
    if re.fullmatch(r"#[0-9a-f]{3,4}", text):
        text = "#" + "".join(2 * digit for digit in text[1:])
    if re.fullmatch(r"#[0-9a-f]{6}(?:[0-9a-f]{2})?", text):
        red, green, blue = (int(text[k : k + 2], 16) / 255.0 for k in (1, 3, 5))
        return red, green, blue
    if (found := _RGB.fullmatch(text)) and len(shares := numbers(found.group(1))) == 3:
        red, green, blue = (min(max(share / (100.0 if "%" in found.group(1) else 255.0), 0.0), 1.0) for share in shares)
        return red, green, blue
    return None


_RGB = re.compile(rf"rgba?\(((?:[\s,]*{NUMBER}\s*%?){{3}})(?:\s*[,/]\s*({NUMBER}\s*%?))?\s*\)")


def paint_share(text: str) -> float:
    """How opaque a paint is by itself, in [0, 1]: 0 for `none` and `transparent`, 1 for what is no colour."""
    text = text.strip().lower()
    if text in ("none", "transparent"):
        return 0.0
    if re.fullmatch(r"#(?:[0-9a-f]{4}|[0-9a-f]{8})", text):
        return int(text[4:] * 2 if len(text) == 5 else text[7:], 16) / 255.0
    if (found := _RGB.fullmatch(text)) and found.group(2):
        share = numbers(found.group(2))[0] / (100.0 if "%" in found.group(2) else 1.0)
        return min(max(share, 0.0), 1.0)
    return 1.0


def lightness(text: str) -> float | None:
    """How white a colour is in a luminance mask, in [0, 1], by the shares that SVG lays down; None for no colour."""
    found = colour(text)
    return None if found is None else 0.2125 * found[0] + 0.7154 * found[1] + 0.0721 * found[2]


def transform(text: str | None) -> Array:
    """The affine map `(2, 3)` of a list of transforms; the one that stands last is applied first.

    Raises `ValueError` for a word that is no transform, and for a list of more than `MAX_TRANSFORMS`.
    """
    result = IDENTITY
    text, position = (text or "").strip(), 0
    if text.count("(") > MAX_TRANSFORMS:
        raise ValueError(sentence("more than {most} transforms in one list", most=MAX_TRANSFORMS))
    while position < len(text):
        found = _TRANSFORM.match(text, position)
        if found is None:
            raise ValueError(sentence("no transform: {text!r}", text=text[position : position + 20]))
        result = composed(result, _single(found.group(1), numbers(found.group(2))))
        position = found.end()
    return result


_TRANSFORM = re.compile(r"([A-Za-z]+)\s*\(([^()]*)\)[\s,]*")


def composed(outer: Array, inner: Array) -> Array:
    """The map `(2, 3)` that applies `inner`, then `outer`."""
    result: Array = outer[:, :2] @ inner
    result[:, 2] += outer[:, 2]
    return result


def about(origin: str | None, inner: Array, box: tuple[float, float]) -> Array:
    """The map `(2, 3)` that does what `inner` does about a `transform-origin`; of its words a missing one is 0."""
    words = [ORIGINS.get(word, word) for word in re.split(r"[\s,]+", (origin or "").strip())[:2]]
    place = np.array([length(word, whole) for word, whole in zip([*words, "", ""], box, strict=False)])
    result: Array = inner.copy()
    result[:, 2] += place - inner[:, :2] @ place
    return result


def moved(points: Array, by: Array) -> Array:
    """Positions `(..., 2)` under an affine map `(2, 3)`."""
    result: Array = points @ by[:, :2].T + by[:, 2]
    return result


def _single(name: str, values: list[float]) -> Array:
    """One transform of a list."""
    count = len(values)
    if name == "matrix" and count == 6:
        return np.array(values).reshape(3, 2).T
    if name == "translate" and count in (1, 2):
        return _matrix(1.0, 0.0, 0.0, 1.0, values[0], values[1] if count == 2 else 0.0)
    if name == "scale" and count in (1, 2):
        return _matrix(values[0], 0.0, 0.0, values[-1])
    if name == "rotate" and count in (1, 3):
        cos, sin = math.cos(math.radians(values[0])), math.sin(math.radians(values[0]))
        x, y = values[1:] if count == 3 else (0.0, 0.0)
        return _matrix(cos, sin, -sin, cos, x - cos * x + sin * y, y - sin * x - cos * y)
    if name in ("skewX", "skewY") and count == 1:
        slope = math.tan(math.radians(values[0]))
        return _matrix(1.0, 0.0, slope, 1.0) if name == "skewX" else _matrix(1.0, slope, 0.0, 1.0)
    raise ValueError(sentence("no transform: {name!r} of {count} numbers", name=name, count=count))


def _matrix(a: float, b: float, c: float, d: float, e: float = 0.0, f: float = 0.0) -> Array:
    return np.array([[a, c, e], [b, d, f]])
