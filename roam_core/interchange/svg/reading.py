"""Outlines of SVG drawings as shapes: groups become layers, and nothing outside of a drawing is followed."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from xml.etree.ElementTree import Element

import numpy as np

from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.geometry import bspline
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.interchange.reading import Imported, ShapeReader, brief, sensible
from roam_core.interchange.svg.abbreviations import written_out
from roam_core.interchange.svg.compound import joined
from roam_core.interchange.svg.crossings import taken_apart
from roam_core.interchange.svg.css import Line, StyleSheet, computed
from roam_core.interchange.svg.frames import UNCUT, cuts_off, mask_frame, picture_frame, reach_beyond
from roam_core.interchange.svg.outlines import DRAWN, fitted, outlines, picture_size, view_box
from roam_core.interchange.svg.path import Spline
from roam_core.interchange.svg.properties import (
    blend_of,
    fill_share,
    is_locked,
    is_painted,
    is_shown,
    name_of,
    own_name,
    share_of,
    taken_of_switch,
)
from roam_core.interchange.svg.scope import Scope
from roam_core.interchange.svg.telling import cut_of, size_note
from roam_core.interchange.svg.words import (
    AID,
    PART,
    about,
    colour,
    composed,
    length,
    lightness,
    moved,
    numbers,
    paint_share,
    transform,
    xlink_href,
)
from roam_core.interchange.xml import local_name, parsed
from roam_core.roto import BlendMode, Keyframe, Layer, RotoShape, control_points
from roam_core.roto import Spline as SplineKind
from roam_core.roto.shape import NO_COLOUR
from roam_core.translatable import said_by, sentence

Item = Layer | RotoShape

GROUPS = {"g", "a", "switch", "svg"}
SILENT = {"defs", "title", "desc", "metadata", "style", "script", "namedview", "clipPath", "mask", "symbol", "marker"}
SILENT |= {"linearGradient", "radialGradient", "pattern", "filter", "cursor", "view", "animate", "set", "path-effect"}
"""Elements that draw nothing by themselves."""

MAX_DRAWING = 16 << 20
"""Bytes of a drawing that is read."""

PER_TRANSFORM, PER_ELEMENT, PER_USE = 8, 16, 40
"""Parts that a transform, each look at an element, and each `use` counts for."""

PER_NUMBER = 40
"""Letters that a number of ours takes at most."""


@dataclass
class SvgReader(ShapeReader):
    """Walks through a drawing, carrying along what elements take from those around them."""

    is_ours: bool = False
    grow: float = 1.0
    lines_only: int = 0
    _sheet: StyleSheet | None = None
    _by_id: dict[str, Element] = field(default_factory=dict)
    _places: dict[Element, Line] = field(default_factory=dict)

    def shapes(self) -> Imported:
        """All outlines of the file, bottom first, as shapes with one key on the clip's first frame."""
        root = parsed(self, doctype="ignored", content=written_out(self.content(MAX_DRAWING), MAX_DRAWING))
        if local_name(root) != "svg":
            raise RoamError(
                sentence(
                    "{path} is no SVG picture (its root element is {element}).",
                    path=self.called,
                    element=brief(local_name(root)),
                )
            )
        self.is_ours = root.get("data-roam-frame") is not None
        self._sheet = StyleSheet(self.check_parts, self.note)
        self._look_up(root)
        size, box = picture_size(root, self.clip.size)
        ratio = np.array(self.clip.size) / np.array(size)
        self.grow = float(np.sqrt(ratio.prod()))
        if told := size_note(root, size, box, self.clip.size):
            self.note(told)
        into = composed(np.column_stack([np.diag(ratio), np.zeros(2)]), fitted(root, *size))
        children = self._inside(root, Scope(into, computed(self._line(root), self._sheet, {}), box))
        if not children:
            self.note(sentence("There are no outlines in the drawing."))
        if self.lines_only:
            self.note(
                sentence(
                    "The width of lines was left out; {lines_only} of the outlines are drawn as lines only.",
                    lines_only=self.lines_only,
                )
            )
        return self.finished(children)

    def _look_up(self, root: Element) -> None:
        """Remember elements by their ids, gather the style sheets, and what lies in what where a sheet asks for it."""
        sheets = []
        for element in root.iter():
            if (key := element.get("id")) is not None:
                self._by_id.setdefault(key, element)
            if isinstance(element.tag, str) and local_name(element) == "style":
                sheets.append("".join(element.itertext()))
        assert self._sheet is not None
        for text in sheets:
            self._sheet.add(text)
        if sheets:
            self._places[root] = Line(root)
            for parent in root.iter():
                for child in parent:
                    self._places[child] = Line(child, self._places[parent])

    def _line(self, element: Element) -> Line:
        return self._places.get(element) or Line(element)

    # ---- elements ----------------------------------------------------------------------------------------------------

    def _inside(self, parent: Element, scope: Scope) -> tuple[Item, ...]:
        """The items of what lies in an element, bottom first."""
        self.check_depth(scope.depth)
        children = taken_of_switch(parent) if local_name(parent) == "switch" else parent
        return tuple(item for element in children for item in self.items(element, scope))

    def items(self, element: Element, scope: Scope) -> tuple[Item, ...]:
        """The items of one element: none, one, or in a mask all of a group's."""
        kind = local_name(element) if isinstance(element.tag, str) else ""
        self.check_parts(PER_ELEMENT)
        if element.get(AID) is not None:
            return ()
        if element.get(PART) is not None:
            return self._inside(element, replace(scope, depth=scope.depth + 1))
        if kind not in GROUPS | DRAWN | {"use"}:
            if kind and kind not in SILENT:
                self.note(
                    sentence("Elements of the kind {kind} were left out: ROAM reads outlines only.", kind=brief(kind))
                )
            return ()
        assert self._sheet is not None
        style, default = computed(self._line(element), self._sheet, scope.style), "Group" if kind in GROUPS else kind
        if scope.paints and not is_shown(style, kind in DRAWN):
            return ()
        name = name_of(element, default)
        try:
            written = style.get("transform", "")
            self.check_parts(PER_TRANSFORM * (1 + written.count("(")))
            placed = about(style.get("transform-origin"), transform(written), scope.box)
            into = composed(scope.to_pixels, placed)
        except ValueError as error:
            self.note(sentence("{name} was left out ({reason}).", name=brief(name), reason=said_by(error)))
            return ()
        inner = replace(scope, to_pixels=into, style=style, depth=scope.depth + 1)
        if kind in DRAWN:
            made = self._drawn(element, kind, name, inner)
        elif kind == "use":
            made = self._used(element, name, inner)
        else:
            made = self._group(element, kind, name, inner)
        return self._cut(made, name, inner) if made else ()

    def _group(self, element: Element, kind: str, name: str, scope: Scope) -> tuple[Item, ...]:
        inner = self._within(element, scope, element) if kind == "svg" else scope
        children = self._inside(element, inner)
        if kind == "svg" and cuts_off(element, element, children, scope.box, scope.to_pixels):
            self.note(sentence(UNCUT, name=brief(name)))
        if scope.paints and share_of(scope.style, "opacity") == 1.0:
            return children
        layer = self._layer(name, children, scope.style, element)
        # Inverted, or intersecting, a layer takes part whose shapes do not exist on the drawing's frame.
        return (layer,) if children or layer.invert or layer.blend is BlendMode.INTERSECT else ()

    def _layer(self, name: str, children: tuple[Item, ...], style: Mapping[str, str], element: Element) -> Layer:
        return Layer(
            self.fresh_id("layer"),
            name,
            children,
            visible=is_shown(style, False),
            locked=is_locked(element),
            opacity=share_of(style, "opacity"),
            invert=element.get("data-roam-invert") == "true",
            blend=blend_of(element),
        )

    def _within(self, picture: Element, scope: Scope, placed: Element) -> Scope:
        """The scope in a picture or symbol, at the place and of the size that `placed` says."""
        x, y, *size = picture_frame(picture, placed, scope.box)
        moves = np.array([[1.0, 0.0, x], [0.0, 1.0, y]])
        inner = (size[0], size[1]) if (box := view_box(picture)) is None else (box[2], box[3])
        return replace(scope, to_pixels=composed(composed(scope.to_pixels, moves), fitted(picture, *size)), box=inner)

    def _used(self, element: Element, name: str, scope: Scope) -> tuple[Item, ...]:
        """What a `use` repeats, at its place."""
        self.check_parts(PER_USE)
        found = self._target(element.get("href") or element.get(xlink_href()) or "", brief(name), scope)
        if found is None:
            return ()
        target, used = found
        scope = replace(scope, used=used)
        if local_name(target) in ("symbol", "svg"):
            made = self._inside(target, self._within(target, scope, element))
            if cuts_off(target, element, made, scope.box, scope.to_pixels):
                self.note(sentence(UNCUT, name=brief(name)))
        else:
            x, y = (length(element.get(axis), whole) for axis, whole in zip("xy", scope.box, strict=True))
            moves = composed(scope.to_pixels, np.array([[1.0, 0.0, x], [0.0, 1.0, y]]))
            made = self.items(target, replace(scope, to_pixels=moves))
        if not made or (scope.paints and share_of(scope.style, "opacity") == 1.0):
            return made
        is_plain = len(made) == 1 and share_of(scope.style, "opacity") == 1.0 and is_shown(scope.style, False)
        if not is_plain:
            return (self._layer(name, made, scope.style, element),)
        return (replace(made[0], name=name),) if own_name(element) is not None else made

    def _target(self, address: str, name: str, scope: Scope) -> tuple[Element, frozenset[str]] | None:
        """The element of a `#id`, and the ids in progress with it; None, and a sentence, where it cannot be read."""
        key = address.strip().removeprefix("#")
        if not address.strip().startswith("#"):
            self.note(sentence("What {name} refers to lies in another file, not opened: it was left out.", name=name))
        elif key not in self._by_id:
            self.note(
                sentence(
                    "What {name} refers to ({key}) is not in the drawing: it was left out.", name=name, key=brief(key)
                )
            )
        elif key in scope.used:
            self.note(sentence("{name} refers to itself: it was left out.", name=name))
        else:
            return self._by_id[key], scope.used | {key}
        return None

    # ---- outlines ----------------------------------------------------------------------------------------------------

    def _drawn(self, element: Element, kind: str, name: str, scope: Scope) -> tuple[Item, ...]:
        """One shape, or a layer of them for a path of several outlines."""
        style = scope.style
        try:
            splines, is_whole = outlines(element, kind, scope.box, self.check_parts)
            if not is_whole:
                self.note(
                    sentence("The path of {name} is damaged: what stands before the damage was read.", name=brief(name))
                )
            rule = style.get("clip-rule" if scope.paints == "clip" else "fill-rule")
            is_filled = self._is_filled(scope)
            for spline in splines:
                if kind != "line" and len(spline.rows) > 2 and is_filled:
                    spline.close()
            if is_filled:
                splines = taken_apart(splines, rule == "evenodd", scope.to_pixels, self.check_parts)
            made = [self._shape(element, spline, name, scope) for spline in splines]
        except (ValueError, OverflowError) as error:
            self.note(sentence("{name} was left out ({reason}).", name=brief(name), reason=said_by(error)))
            return ()
        if not made:
            return ()
        if not self.is_ours and not scope.paints and not self._is_filled(scope) and is_painted(style):
            self.lines_only += 1
        item: Item = made[0]
        if len(made) > 1:
            compound = self.fresh_id("compound")
            parts = (
                replace(part, visible=True, opacity=1.0, invert=False, compound=compound)
                for part in joined(made, rule == "evenodd", self.check_parts)
            )
            whole = made[0]
            item = Layer(
                self.fresh_id("layer"),
                name,
                tuple(parts),
                visible=whole.visible,
                opacity=whole.opacity,
                invert=whole.invert,
            )
        return self._painted(item, name, scope)

    def _is_filled(self, scope: Scope) -> bool:
        """Whether an outline is painted within: then its end is joined to its beginning, as every program shows it."""
        return not self.is_ours and (scope.paints == "clip" or paint_share(scope.style.get("fill", "")) > 0.0)

    def _painted(self, item: Item, name: str, scope: Scope) -> tuple[Item, ...]:
        """An item of a mask: white paint adds, black takes away; others stay as they are."""
        fill = scope.style.get("fill", "black")
        if scope.paints not in ("luminance", "alpha"):
            return (item,)
        if paint_share(fill) == 0.0:
            return ()
        share = 1.0 if scope.paints == "alpha" else lightness(fill)
        if share is None:
            self.note(
                sentence("The paint of {name} in a mask is no plain colour: it was read as white.", name=brief(name))
            )
            share = 1.0
        if share <= 0.005:
            return (replace(item, blend=BlendMode.SUBTRACT),)
        if share < 0.995:
            self.note(sentence("The grey of {name} in a mask was read as its opacity.", name=brief(name)))
            assert isinstance(item.opacity, float)
            return (replace(item, opacity=item.opacity * share),)
        return (item,)

    def _shape(self, element: Element, spline: Spline, name: str, scope: Scope) -> RotoShape:
        self.check_points(len(spline.rows), name)
        points, style = spline.points, scope.style
        ends = numbers(element.get("data-roam-ends"))
        if not spline.closed and len(ends) == 4:
            points[0, IN], points[-1, OUT] = ends[:2], ends[2:]
        told = element.get("data-roam-feather-curve", "")
        curve = numbers(told, self.check_parts) if len(told) < PER_NUMBER * points.size else []
        feather = np.array(curve).reshape(points.shape) if len(curve) == points.size else None
        with np.errstate(all="ignore"):  # what overflows is found in the next line
            soft = None if feather is None else feather @ scope.to_pixels[:, :2].T
            key = Keyframe(self.clip.first, moved(points, scope.to_pixels), soft)
        if not sensible((key,)):
            raise ValueError(sentence("it lies nowhere near the picture"))
        rgb = numbers(element.get("data-roam-colour", "")[: 3 * PER_NUMBER])
        mine = (rgb[0], rgb[1], rgb[2]) if len(rgb) == 3 and 0.0 <= min(rgb) <= max(rgb) <= 1.0 else None
        opacity = share_of({"opacity": element.get("data-roam-opacity") or style.get("opacity", "")}, "opacity")
        shape = RotoShape(
            id=self.fresh_id("shape"),
            name=name,
            keys=(key,),
            closed=spline.closed,
            colour=mine or colour(style.get("fill")) or colour(style.get("stroke")) or NO_COLOUR,
            blend=blend_of(element),
            opacity=opacity * fill_share(style) if self._is_filled(scope) and scope.paints != "clip" else opacity,
            invert=element.get("data-roam-invert") == "true",
            feather=self.grow * length(element.get("data-roam-feather"), 0.0),
            visible=is_shown(style, True) and (self.is_ours or scope.paints != "" or is_painted(style)),
            locked=is_locked(element),
        )
        if element.get("data-roam-spline") == SplineKind.BSPLINE.value and _still_b_spline(key.points, spline.closed):
            return control_points.with_spline(shape, SplineKind.BSPLINE)
        return shape

    # ---- clip paths and masks ----------------------------------------------------------------------------------------

    def _cut(self, made: tuple[Item, ...], name: str, scope: Scope) -> tuple[Item, ...]:
        """The items of an element, cut by its clip path and its mask: a layer with what cuts on top of them."""
        if scope.style.get("filter", "none") != "none":
            self.note(sentence("The filter of {name} was left out.", name=brief(name)))
        for word, kind in (("clip-path", "clipPath"), ("mask", "mask")):
            address = scope.style.get(word, "none")
            if address == "none" or scope.paints == "clip":
                continue
            cutter = self._cutter(address, kind, name, scope)
            if cutter is None:
                continue
            if len(made) == 1 and isinstance(made[0], Layer) and not made[0].invert:
                layer = made[0]
                made = (replace(layer, children=(*layer.children, cutter)),)
            else:
                shown = made[0].visible
                inner = tuple(replace(item, visible=True) for item in made)
                made = (Layer(self.fresh_id("layer"), name, (*inner, cutter), visible=shown),)
        return made

    def _cutter(self, address: str, kind: str, name: str, scope: Scope) -> Item | None:
        """A clip path or mask as a layer or shape that intersects; None where it cuts nothing or cannot be read."""
        what = sentence("clip path") if kind == "clipPath" else sentence("mask")
        link = re.match(r"url\(\s*['\"]?(#[^'\")\s]*)", address)
        found = None if link is None else self._target(link.group(1), cut_of(what, name), scope)
        if found is None:
            if link is None:
                self.note(
                    sentence(
                        "The {what} of {name} is no outline of the drawing: it was left out.",
                        what=what,
                        name=brief(name),
                    )
                )
            return None
        target, used = found
        units = target.get("clipPathUnits" if kind == "clipPath" else "maskContentUnits", "userSpaceOnUse")
        if local_name(target) != kind or units != "userSpaceOnUse":
            self.note(
                sentence(
                    "The {what} of {name} is given in shares of its box: it was left out.", what=what, name=brief(name)
                )
            )
            return None
        assert self._sheet is not None
        style = computed(self._line(target), self._sheet, {})
        paints = "clip" if kind == "clipPath" else "alpha" if style.get("mask-type") == "alpha" else "luminance"
        try:
            into = composed(scope.to_pixels, transform(style.get("transform")))
        except ValueError as error:
            self.note(
                sentence(
                    "The {what} of {name} was left out ({reason}).", what=what, name=brief(name), reason=said_by(error)
                )
            )
            return None
        inner = replace(scope, to_pixels=into, style=style, used=used, paints=paints, depth=scope.depth + 1)
        parts = self._inside(target, inner)
        frame = mask_frame(target, scope.box) if kind == "mask" else None
        if frame is not None and reach_beyond(parts, frame, into):
            self.note(
                sentence(
                    "The frame of the {what} of {name} was left out: what lies beyond it masks, too.",
                    what=what,
                    name=brief(name),
                )
            )
        if "clip-path" in style or "mask" in style:
            self.note(sentence("What cuts the {what} of {name} itself was left out.", what=what, name=brief(name)))
        blend = BlendMode.INTERSECT
        if parts and self._covers(parts[0]):
            if len(parts) == 1:
                return None
            if all(part.blend is BlendMode.SUBTRACT for part in parts[1:]):
                blend, parts = BlendMode.SUBTRACT, tuple(replace(part, blend=BlendMode.ADD) for part in parts[1:])
        own = name_of(target, str(what))
        if len(parts) == 1 and parts[0].blend is BlendMode.ADD:
            return replace(parts[0], blend=blend, name=own)
        return Layer(self.fresh_id("layer"), own, parts, blend=blend)

    def _covers(self, item: Item) -> bool:
        """True for a rectangle behind the whole picture, as many programs write one: it cuts nothing away."""
        if isinstance(item, Layer) or item.blend is not BlendMode.ADD or item.opacity != 1.0 or not item.closed:
            return False
        points, size = item.keys[0].points, np.array(self.clip.size)
        corners, low, high = points[:, ANCHOR], points.min(axis=(0, 1)), points.max(axis=(0, 1))
        is_box = len(points) == 4 and bool(((corners == low) | (corners == high)).all())
        straight = bool((points == points[:, :1]).all())
        return is_box and straight and bool((low <= 0.01).all() and (high >= size - 0.01).all())


def _still_b_spline(points: Array, closed: bool) -> bool:
    """False where another program has changed the outline: then its new points count, not what it once was."""
    return len(points) > 1 and bspline.is_bspline(points, closed, 1e-4)
