"""The outlines of SVG's drawing elements in their own coordinates, and how a picture within a picture is fitted in."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from xml.etree.ElementTree import Element

import numpy as np

from roam_core.arrays import Array
from roam_core.interchange.svg.path import Spline, ellipse, parsed_path, polygon, rectangle
from roam_core.interchange.svg.words import length, numbers

Box = tuple[float, float]

DRAWN = {"path", "rect", "circle", "ellipse", "line", "polyline", "polygon"}


def outlines(element: Element, kind: str, box: Box, count: Callable[[int], None]) -> tuple[list[Spline], bool]:
    """The outlines of an element of the kinds `DRAWN`, and whether all of it was understood.

    `box` is the user space (width, height) that percentages are of; `count` is told of parts, and may refuse.
    """
    if kind == "path":
        splines, is_whole = parsed_path(element.get("d", ""), count)
        # A lone M draws nothing; an outline that was closed, or drawn to, does.
        return [spline for spline in splines if spline.closed or len(spline.rows) > 1], is_whole
    return [spline for spline in _basic(element, kind, box, count) if spline.rows], True


def _basic(element: Element, kind: str, box: Box, count: Callable[[int], None]) -> list[Spline]:
    wide, high = box
    at = {word: length(element.get(word), wide) for word in ("x", "cx", "x1", "x2", "width", "rx")}
    at |= {word: length(element.get(word), high) for word in ("y", "cy", "y1", "y2", "height", "ry")}
    if kind in ("polyline", "polygon"):
        values = numbers(element.get("points"), count)
        places = list(zip(values[::2], values[1::2], strict=False))
        return [polygon(places, closed=kind == "polygon")] if places else []
    if kind == "line":
        return [polygon([(at["x1"], at["y1"]), (at["x2"], at["y2"])], closed=False)]
    if kind == "circle":
        radius = length(element.get("r"), math.hypot(wide, high) / math.sqrt(2.0))
        return [ellipse(at["cx"], at["cy"], radius, radius)] if radius > 0.0 else []
    rx, ry = (at[word] if element.get(word) else at[other] for word, other in (("rx", "ry"), ("ry", "rx")))
    if kind == "ellipse":
        return [ellipse(at["cx"], at["cy"], rx, ry)] if min(rx, ry) > 0.0 else []
    if min(at["width"], at["height"]) <= 0.0:
        return []
    return [rectangle(at["x"], at["y"], at["width"], at["height"], rx, ry)]


def picture_size(root: Element, size: tuple[int, int]) -> tuple[Box, Box]:
    """Size of the picture in pixels, and of its user space; what it does not say is that of the clip's (`size`)."""
    box = view_box(root)
    default = (box[2], box[3]) if box is not None else (float(size[0]), float(size[1]))
    width, height = (length(root.get(w), full, full) for w, full in zip(("width", "height"), default, strict=True))
    if min(width, height) <= 0.0:
        width, height = default
    return (width, height), (width, height) if box is None else (box[2], box[3])


def view_box(element: Element) -> tuple[float, float, float, float] | None:
    """The user space's left, top, width and height, where the element has a view box with an area."""
    box = numbers(element.get("viewBox"))
    return (box[0], box[1], box[2], box[3]) if len(box) == 4 and min(box[2:]) > 0.0 else None


def fitted(element: Element, width: float, height: float) -> Array:
    """The map `(2, 3)` of an element's view box into a picture of `width` x `height` whose corner is the origin."""
    box = view_box(element)
    if box is None:
        return np.eye(2, 3)
    ratio = np.array([width / box[2], height / box[3]])
    align = element.get("preserveAspectRatio", "xMidYMid meet")
    if not align.strip().startswith("none"):
        ratio[:] = ratio.max() if "slice" in align else ratio.min()
    left = np.array([width, height]) - ratio * np.array(box[2:])
    place = re.match(r"x(Min|Mid|Max)Y(Min|Mid|Max)", align.strip())
    share = {"Min": 0.0, "Mid": 0.5, "Max": 1.0}
    rest = np.array([share[word] for word in place.groups()] if place else [0.5, 0.5]) * left
    return np.column_stack([np.diag(ratio), rest - ratio * np.array(box[:2])])
