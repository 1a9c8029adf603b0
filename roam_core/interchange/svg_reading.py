"""Outlines of SVG drawings as shapes: groups become layers, and nothing that a drawing points to is followed."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from xml.etree.ElementTree import Element

import numpy as np
from numpy.typing import NDArray

from roam_core.errors import RoamError
from roam_core.geometry import bspline
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.interchange.reading import Imported, ShapeReader, brief, sensible
from roam_core.interchange.svg_path import Spline, ellipse, parsed_path, polygon, rectangle
from roam_core.interchange.svg_words import IDENTITY, LABEL, colour, composed, length, moved, numbers, transform
from roam_core.interchange.xml import local_name, parsed
from roam_core.roto import BlendMode, Keyframe, Layer, RotoShape, grips
from roam_core.roto import Spline as SplineKind

Array = NDArray[np.float64]

GROUPS = {"g", "a", "switch", "svg"}
DRAWN = {"path", "rect", "circle", "ellipse", "line", "polyline", "polygon"}
SILENT = {"defs", "title", "desc", "metadata", "style", "script", "namedview", "clipPath", "mask", "symbol", "marker"}
SILENT |= {"linearGradient", "radialGradient", "pattern", "filter", "cursor", "view", "animate", "set"}
"""Elements that draw nothing by themselves."""


MAX_DRAWING = 16 << 20
"""Bytes of a drawing that is read."""

PER_TRANSFORM = 8
"""Parts that a transform counts for."""

_RULES = {
    word: re.compile(rf"(?:^|;)\s*{word}\s*:([^;]*)")
    for word in ("fill", "fill-rule", "stroke", "opacity", "display", "visibility")
}
"""How the properties that are asked for stand in a style attribute; the first of several counts."""


@dataclass
class SvgReader(ShapeReader):
    """Walks through a drawing, carrying along the map from user space to pixels of the picture."""

    viewport: tuple[float, float] = (0.0, 0.0)
    _palette: list[tuple[float, float, float]] = field(default_factory=list)

    def shapes(self) -> Imported:
        """All outlines of the file, bottom first, as shapes with one key on the clip's first frame."""
        root = parsed(self, doctype="ignored", content=self.content(MAX_DRAWING))
        if local_name(root) != "svg":
            raise RoamError(f"{self.path} is no SVG picture (its root element is {brief(local_name(root))}).")
        self.viewport, to_pixels = _viewport(root, self.clip.size)
        children = self._children(root, to_pixels, 1)
        if not children:
            self.note("There are no outlines in the drawing.")
        return self.finished(children, self.viewport)

    def _children(self, parent: Element, to_pixels: Array, depth: int) -> tuple[Layer | RotoShape, ...]:
        self.check_depth(depth)
        made: list[Layer | RotoShape] = []
        for element in parent:
            kind = local_name(element) if isinstance(element.tag, str) else ""
            if kind in GROUPS | DRAWN:
                item = self._item(element, kind, to_pixels, depth)
                made += [] if item is None else [item]
            elif kind and kind not in SILENT:
                self.note(f"Elements of the kind {brief(kind)} were left out: ROAM reads outlines only.")
        return tuple(made)

    def _item(self, element: Element, kind: str, to_pixels: Array, depth: int) -> Layer | RotoShape | None:
        try:
            written = element.get("transform", "")
            self.check_parts(PER_TRANSFORM * (1 + written.count("(")))
            to_pixels = composed(to_pixels, transform(written))
        except ValueError as error:
            self.note(f"{brief(_name(element, kind))} was left out ({error}).")
            return None
        if kind in DRAWN:
            return self._drawn(element, kind, to_pixels)
        if kind == "svg":
            self.note("A picture within the picture was read without its own scale.")
            corner = [length(element.get(axis), whole) for axis, whole in zip("xy", self.viewport, strict=True)]
            to_pixels = composed(to_pixels, np.column_stack([np.eye(2), corner]))
        children = self._children(element, to_pixels, depth + 1)
        if not children:
            return None
        return Layer(
            self.fresh_id("layer"),
            _name(element, "Group"),
            children,
            visible=_is_shown(element),
            locked=element.get("data-roam-locked") == "true",
            opacity=_share(element, "opacity"),
            invert=element.get("data-roam-invert") == "true",
        )

    def _drawn(self, element: Element, kind: str, to_pixels: Array) -> Layer | RotoShape | None:
        """One shape, or a layer of them for a path of several outlines."""
        name = _name(element, kind)
        try:
            splines = [spline for spline in self._splines(element, kind, name) if len(spline.rows) > 0]
            made = [self._shape(element, spline, name, to_pixels) for spline in splines]
        except (ValueError, OverflowError) as error:
            self.note(f"{brief(name)} was left out ({error}).")
            return None
        if len(made) <= 1:
            return made[0] if made else None
        parts = _joined(made, _style(element, "fill-rule") == "evenodd")
        plain = tuple(replace(part, visible=True, opacity=1.0, invert=False) for part in parts)
        whole = made[0]
        return Layer(
            self.fresh_id("layer"), name, plain, visible=whole.visible, opacity=whole.opacity, invert=whole.invert
        )

    def _shape(self, element: Element, spline: Spline, name: str, to_pixels: Array) -> RotoShape:
        self.check_points(len(spline.rows), name)
        points = spline.points
        ends = numbers(element.get("data-roam-ends"))
        if not spline.closed and len(ends) == 4:
            points[0, IN], points[-1, OUT] = ends[:2], ends[2:]
        with np.errstate(all="ignore"):  # what overflows is found in the next line
            key = Keyframe(self.clip.first, moved(points, to_pixels))
        if not sensible((key,)):
            raise ValueError("it lies nowhere near the picture")
        blend = element.get("data-roam-blend", "add")
        shape = RotoShape(
            id=self.fresh_id("shape"),
            name=name,
            keys=(key,),
            closed=spline.closed,
            colour=colour(_style(element, "fill")) or colour(_style(element, "stroke")) or (0.90, 0.62, 0.0),
            blend=BlendMode(blend) if blend in list(BlendMode) else BlendMode.ADD,
            opacity=_share(element, "opacity"),
            invert=element.get("data-roam-invert") == "true",
            feather=length(element.get("data-roam-feather"), 0.0),
            visible=_is_shown(element),
            locked=element.get("data-roam-locked") == "true",
        )
        if element.get("data-roam-spline") == SplineKind.BSPLINE.value and _still_b_spline(key.points, spline.closed):
            return grips.with_spline(shape, SplineKind.BSPLINE)
        return shape

    def _splines(self, element: Element, kind: str, name: str) -> list[Spline]:
        """The outlines of a drawing element in its own coordinates."""
        if kind == "path":
            splines, is_whole = parsed_path(element.get("d", ""), self.check_parts)
            if not is_whole:
                self.note(f"The path of {brief(name)} is damaged: what stands before the damage was read.")
            # A lone M draws nothing; an outline that was closed, or drawn to, does.
            return [spline for spline in splines if spline.closed or len(spline.rows) > 1]
        wide, high = self.viewport
        at = {word: length(element.get(word), wide) for word in ("x", "cx", "x1", "x2", "width", "rx")}
        at |= {word: length(element.get(word), high) for word in ("y", "cy", "y1", "y2", "height", "ry")}
        if kind in ("polyline", "polygon"):
            values = numbers(element.get("points"), self.check_parts)
            places = list(zip(values[::2], values[1::2], strict=False))
            return [polygon(places, closed=kind == "polygon")] if places else []
        if kind == "line":
            return [polygon([(at["x1"], at["y1"]), (at["x2"], at["y2"])], closed=False)]
        if kind == "circle":
            radius = length(element.get("r"), float(np.hypot(wide, high) / np.sqrt(2.0)))
            return [ellipse(at["cx"], at["cy"], radius, radius)] if radius > 0.0 else []
        if kind == "ellipse":
            return [ellipse(at["cx"], at["cy"], at["rx"], at["ry"])] if min(at["rx"], at["ry"]) > 0.0 else []
        if min(at["width"], at["height"]) <= 0.0:
            return []
        rx, ry = (at[word] if element.get(word) else at[other] for word, other in (("rx", "ry"), ("ry", "rx")))
        return [rectangle(at["x"], at["y"], at["width"], at["height"], rx, ry)]


def _still_b_spline(points: Array, closed: bool) -> bool:
    """False where another program has changed the outline: then its new points count, not what it once was."""
    return len(points) > 1 and bspline.is_bspline(points, closed, 1e-4)


def _viewport(root: Element, size: tuple[int, int]) -> tuple[tuple[float, float], Array]:
    """Size of the picture in pixels, and the map from its user space into it."""
    box = numbers(root.get("viewBox"))
    has_box = len(box) == 4 and min(box[2:]) > 0.0
    default = (box[2], box[3]) if has_box else (float(size[0]), float(size[1]))
    width, height = (length(root.get(w), full, full) for w, full in zip(("width", "height"), default, strict=True))
    if min(width, height) <= 0.0:
        width, height = default
    if not has_box:
        return (width, height), IDENTITY
    ratio = np.array([width / box[2], height / box[3]])
    align = root.get("preserveAspectRatio", "xMidYMid meet")
    if not align.strip().startswith("none"):
        ratio[:] = ratio.max() if "slice" in align else ratio.min()
    left = np.array([width, height]) - ratio * np.array(box[2:])
    place = re.match(r"x(Min|Mid|Max)Y(Min|Mid|Max)", align.strip())
    share = {"Min": 0.0, "Mid": 0.5, "Max": 1.0}
    rest = np.array([share[word] for word in place.groups()] if place else [0.5, 0.5]) * left
    return (width, height), np.column_stack([np.diag(ratio), rest - ratio * np.array(box[:2])])


def _joined(made: list[RotoShape], is_even_odd: bool) -> list[RotoShape]:
    """How the outlines of one path join: by the even-odd rule as differences, by the other by which way they run.

    Of the latter, an outline that runs against the first cuts a hole.
    """
    areas = [_signed_area(shape.keys[0].points[:, ANCHOR]) for shape in made]
    parts = made[:1]
    for shape, area in zip(made[1:], areas[1:], strict=True):
        blend = BlendMode.SUBTRACT if area * areas[0] < 0.0 else BlendMode.ADD
        parts.append(replace(shape, blend=BlendMode.DIFFERENCE if is_even_odd else blend))
    return parts


def _signed_area(line: Array) -> float:
    ahead = np.roll(line, -1, axis=0)
    return 0.5 * float((line[:, 0] * ahead[:, 1] - ahead[:, 0] * line[:, 1]).sum())


def _name(element: Element, default: str) -> str:
    title = next((child.text for child in element if local_name(child) == "title" and child.text), None)
    label = element.get(LABEL)
    return label if label is not None else title or element.get("id") or default.capitalize()


def _style(element: Element, word: str) -> str | None:
    """A property from the style attribute, or from the attribute of its own name."""
    found = _RULES[word].search(element.get("style", ""))
    return element.get(word) if found is None else found.group(1).strip()


def _share(element: Element, word: str) -> float:
    values = numbers(_style(element, word))
    return min(max(values[0], 0.0), 1.0) if values else 1.0


def _is_shown(element: Element) -> bool:
    return _style(element, "display") != "none" and _style(element, "visibility") not in ("hidden", "collapse")
