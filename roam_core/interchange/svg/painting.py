"""The joint matte of layers as elements of SVG that any renderer paints alike: white, as opaque as the matte is white.

A layer whose shapes only join is a group of white paths, one on the other: opacities join as `a + b - ab`. A layer that
is inverted, or in which shapes cut one another, is a white rectangle behind a luminance mask, and the mask holds the
layer's shapes as paths in their order: white adds, black takes away, a grey picture with a `mix-blend-mode` does what
paint alone cannot. Rectangles, repetitions and other aids bear `data-roam-aid`, what only wraps shapes bears
`data-roam-part`: our reader passes over the former and looks into the latter.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import dataclass, field

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry.bezier import IN, OUT
from roam_core.interchange.protocol import ShapeWriter
from roam_core.interchange.svg.path import path_data
from roam_core.interchange.svg.soft import curve_levels, uniform_bands
from roam_core.interchange.svg.words import (
    AID,
    DARK,
    INSENSITIVE,
    LABEL,
    LAYER_MODE,
    LIGHT,
    PART,
    decimal,
    svg_tag,
    xlink_href,
)
from roam_core.interchange.xml import xml_text
from roam_core.roto import BlendMode, Layer, Outline, RotoShape, Spline
from roam_core.translatable import sentence

ALIKE = {BlendMode.PLUS, BlendMode.MAX}
"""Modes that leave hard, opaque shapes as a union would, but for pixels that two edges share."""

UPON_NOTHING = {BlendMode.ADD, BlendMode.PLUS, BlendMode.MAX, BlendMode.DIFFERENCE}
"""Modes that give the shape itself where nothing lies under it."""

EVERYWHERE: Array = np.array([-np.inf, -np.inf, np.inf, np.inf])

MIXED = {BlendMode.DIFFERENCE: "difference", BlendMode.MAX: "lighten"}
"""What a grey picture of the shape does with the opaque one under it."""


@dataclass
class Painter(ShapeWriter):
    """Turns layers and shapes into elements, as they are on one frame.

    Attributes
    ----------
    frame : the plate's frame.
    ids : an XML id for each layer and shape; ours of other elements hold a dot, which these do not.
    absent : ids of the shapes that do not exist on the frame and were left out.
    """

    KINDS = frozenset(Spline)

    frame: int = 0
    ids: dict[str, str] = field(default_factory=dict)
    absent: list[str] = field(default_factory=list)

    def group(self, parent: ET.Element, layer: Layer, colour: str = LIGHT) -> None:
        """A layer as a group: the joint matte of what lies in it, in `colour`, with the layer's opacity."""
        group = ET.SubElement(parent, svg_tag("g"), self._attributes(layer))
        group.set(LAYER_MODE, "layer")
        if layer.invert:
            group.set("data-roam-invert", "true")
        if layer.blend is not BlendMode.ADD:
            group.set("data-roam-blend", layer.blend.value)
        if layer.opacity_at(self.frame) != 1.0:
            group.set("opacity", decimal(layer.opacity_at(self.frame)))
        self.fill(group, layer, colour)

    def fill(self, parent: ET.Element, layer: Layer, colour: str = LIGHT) -> None:
        """Elements whose joint alpha is the matte of the layer's children, inverted where the layer is."""
        modes = self._modes(layer)
        if not layer.invert and set(modes.values()) <= {BlendMode.ADD}:
            for child in layer.children:
                self._joined(parent, child, colour)
            return
        mask = self._mask(parent, f"{self.ids[layer.id]}.matte")
        self._compose(mask, layer, modes)
        self._cover(parent, colour, mask)

    # ---- layers in black and white -----------------------------------------------------------------------------------

    def _modes(self, layer: Layer) -> dict[str, BlendMode]:
        """How each child that shows must be joined: by its own mode, or as a union where that comes to the same."""
        modes: dict[str, BlendMode] = {}
        below: Array | None = None
        for child in layer.children:
            if not child.visible:
                continue
            if isinstance(child, RotoShape) and not (child.closed and child.exists_at(self.frame)):
                continue
            box, mode = self._box(child), child.blend
            is_apart = below is None or (box[:2] >= below[2:]).any() or (box[2:] <= below[:2]).any()
            if (mode in ALIKE and self._is_plain(child)) or (is_apart and mode in UPON_NOTHING):
                mode = BlendMode.ADD
            modes[child.id] = mode
            below = box if below is None else np.concatenate([np.minimum(below, box)[:2], np.maximum(below, box)[2:]])
        return modes

    def _box(self, item: Layer | RotoShape) -> Array:
        """Left, top, right and bottom outside of which an item is black; of a layer everything."""
        if isinstance(item, Layer) or item.invert:
            return EVERYWHERE
        outline, margin = item.at(self.frame), max(item.feather_at(self.frame), 0.0) + 1.0
        places = outline.points.reshape(-1, 2)
        if outline.feather is not None:
            places = np.concatenate([places, (outline.points + outline.feather).reshape(-1, 2)])
        return np.concatenate([places.min(axis=0) - margin, places.max(axis=0) + margin])

    def _is_plain(self, item: Layer | RotoShape) -> bool:
        """True for a shape that is hard, opaque and not inverted."""
        if isinstance(item, Layer) or item.invert or item.opacity_at(self.frame) != 1.0:
            return False
        return not self._is_soft(item)

    def _compose(self, mask: ET.Element, layer: Layer, modes: dict[str, BlendMode]) -> None:
        """Paint the layer's matte in grey, opaquely; an inverted one in black on white, where paint alone does it."""
        is_mixed = any(mode in (*MIXED, BlendMode.PLUS) for mode in modes.values())
        light, dark = (DARK, LIGHT) if layer.invert and not is_mixed else (LIGHT, DARK)
        inside = mask
        if is_mixed:
            inside = ET.SubElement(mask, svg_tag("g"), {PART: "true", "style": "isolation:isolate"})
        self._rectangle(inside, dark)
        for child in layer.children:
            mode = modes.get(child.id, BlendMode.ADD)
            if mode is BlendMode.ADD:
                self._joined(inside, child, light)
            elif mode is BlendMode.SUBTRACT:
                self._joined(inside, child, dark)
            elif mode is BlendMode.INTERSECT:
                within = self._mask(inside, f"{self.ids[child.id]}.beside")
                self._rectangle(within, LIGHT)
                self._joined(within, child, DARK)
                self._cover(inside, dark, within)
            else:
                self._mix(inside, child, mode)
        if layer.invert and is_mixed:
            self._rectangle(inside, LIGHT, "difference")

    def _mix(self, parent: ET.Element, item: Layer | RotoShape, mode: BlendMode) -> None:
        """Join an opaque grey picture of an item. A sum is `1 - max(1 - m - a, 0)`, built of what renderers know."""
        if mode is BlendMode.PLUS:
            self._rectangle(parent, LIGHT, "difference")
        style = f"mix-blend-mode:{MIXED.get(mode, 'lighten')}"
        blended = ET.SubElement(parent, svg_tag("g"), {PART: "true", "style": style})
        grey = ET.SubElement(blended, svg_tag("g"), {PART: "true", "id": f"{self.ids[item.id]}.grey"})
        self._rectangle(grey, DARK)
        self._joined(grey, item, LIGHT)
        if mode is BlendMode.PLUS:
            self._repeated(parent, grey.get("id", ""), style="mix-blend-mode:difference")
            self._rectangle(parent, LIGHT, "difference")

    # ---- shapes ------------------------------------------------------------------------------------------------------

    def _joined(self, parent: ET.Element, child: Layer | RotoShape, colour: str) -> None:
        """A child whose matte is its alpha, painted in one colour."""
        if isinstance(child, Layer):
            self.group(parent, child, colour)
            return
        shape = self.begun(child)
        if not shape.exists_at(self.frame):
            self.absent.append(shape.id)
            return
        outline = shape.at(self.frame)
        self._note_losses(shape, outline)
        if not shape.closed or not shape.visible or not (shape.invert or self._is_soft(shape)):
            path = self._path(parent, shape, outline)
            path.set("fill", colour if shape.closed else "none")
            if shape.opacity_at(self.frame) != 1.0:
                path.set("opacity", decimal(shape.opacity_at(self.frame)))
            return
        stencil = self._mask(parent, f"{self.ids[shape.id]}.stencil")
        self._stencil(stencil, shape, outline)
        cover = self._cover(parent, colour, stencil)
        if shape.opacity_at(self.frame) != 1.0:
            cover.set("opacity", decimal(shape.opacity_at(self.frame)))

    def _stencil(self, stencil: ET.Element, shape: RotoShape, outline: Outline) -> None:
        """A grey picture of a shape's matte, before its opacity; the shape's own path is in it."""
        light, dark = (DARK, LIGHT) if shape.invert else (LIGHT, DARK)
        self._rectangle(stencil, dark)
        has_curve = outline.feather is not None and bool(outline.feather.any())
        if has_curve:
            self._add_levels(stencil, outline, light, dark)
        parent = stencil
        if has_curve and shape.feather_at(self.frame):
            mode = "lighten" if (shape.feather_at(self.frame) > 0.0) is not shape.invert else "darken"
            parent = ET.SubElement(stencil, svg_tag("g"), {PART: "true", "style": f"mix-blend-mode:{mode}"})
            self._rectangle(parent, dark)
        if shape.feather_at(self.frame) >= 0.0:
            self._add_bands(parent, shape, shape.invert)
            self._path(parent, shape, outline).set(
                "fill", "none" if has_curve and not shape.feather_at(self.frame) else light
            )
            return
        clip = ET.SubElement(parent, svg_tag("clipPath"), {PART: "true", "id": f"{self.ids[shape.id]}.inside"})
        self._path(clip, shape, outline)
        inside = ET.SubElement(parent, svg_tag("g"), {AID: "true", "clip-path": f"url(#{clip.get('id')})"})
        self._rectangle(inside, light)
        self._add_bands(inside, shape, shape.invert)

    def _add_bands(self, parent: ET.Element, shape: RotoShape, invert: bool) -> None:
        for width, share in uniform_bands(shape.feather_at(self.frame)):
            level = round(255 * (1.0 - share if invert else share))
            grey = f"#{level:02x}{level:02x}{level:02x}"
            self._repeated(
                parent,
                self.ids[shape.id],
                fill="none",
                stroke=grey,
                **{"stroke-width": decimal(width), "stroke-linejoin": "round"},
            )

    def _add_levels(self, parent: ET.Element, outline: Outline, light: str, dark: str) -> None:
        """The mean of the outlines between an outline and its feather curve: each is laid on with its share."""
        for number, points in enumerate(curve_levels(outline), start=1):
            level = ET.SubElement(parent, svg_tag("g"), {AID: "true", "opacity": f"{1.0 / number:.9g}"})
            self._rectangle(level, dark)
            ET.SubElement(level, svg_tag("path"), {"d": path_data(points, True), "fill": light})

    def _path(self, parent: ET.Element, shape: RotoShape, outline: Outline) -> ET.Element:
        """The path of a shape with all that only we know of it."""
        path = ET.SubElement(parent, svg_tag("path"), self._attributes(shape))
        path.set("d", path_data(outline.points, outline.closed))
        path.set("data-roam-colour", " ".join(decimal(share) for share in shape.colour))
        values = {
            "blend": "" if shape.blend is BlendMode.ADD else shape.blend.value,
            "spline": "" if shape.spline is Spline.BEZIER else shape.spline.value,
            "feather": decimal(shape.feather_at(self.frame)) if shape.feather_at(self.frame) else "",
            "opacity": decimal(shape.opacity_at(self.frame)) if shape.opacity_at(self.frame) != 1.0 else "",
            "invert": "true" if shape.invert else "",
        }
        for word, value in values.items():
            if value:
                path.set(f"data-roam-{word}", value)
        if outline.feather is not None and outline.feather.any():
            path.set("data-roam-feather-curve", " ".join(decimal(float(value)) for value in outline.feather.ravel()))
        if not shape.closed:
            ends = (*outline.points[0, IN], *outline.points[-1, OUT])
            path.set("data-roam-ends", " ".join(decimal(float(value)) for value in ends))
        return path

    def _attributes(self, item: Layer | RotoShape) -> dict[str, str]:
        values = {"id": self.ids[item.id], LABEL: xml_text(item.name)}
        if not item.visible:
            values["display"] = "none"
        if item.locked:
            values[INSENSITIVE] = values["data-roam-locked"] = "true"
        return values

    def _is_soft(self, shape: RotoShape) -> bool:
        feather = shape.at(self.frame).feather
        return shape.feather_at(self.frame) != 0.0 or (feather is not None and bool(feather.any()))

    def _note_losses(self, shape: RotoShape, outline: Outline) -> None:
        if outline.feather is not None and outline.feather.any():
            more = sentence(", and joins its even feather roughly") if shape.feather_at(self.frame) else ""
            self.notes.append(
                sentence(
                    "The feather curve of {name!r} is written as outlines between it and the shape{more}: "
                    "who moves the shape's path in another program does not move them.",
                    name=shape.name,
                    more=more,
                )
            )
        if shape.is_blurred:
            self.notes.append(
                sentence("A still picture has no shutter: that of {name!r} is left out.", name=shape.name)
            )

    # ---- aids --------------------------------------------------------------------------------------------------------

    def _mask(self, parent: ET.Element, name: str) -> ET.Element:
        width, height = (str(length) for length in self.clip.size)
        whole = {"maskUnits": "userSpaceOnUse", "x": "0", "y": "0", "width": width, "height": height}
        return ET.SubElement(parent, svg_tag("mask"), {PART: "true", "id": name, **whole})

    def _rectangle(self, parent: ET.Element, colour: str, mix: str = "") -> ET.Element:
        """The whole picture in one colour."""
        width, height = (str(length) for length in self.clip.size)
        values = {AID: "true", "width": width, "height": height, "fill": colour}
        if mix:
            values["style"] = f"mix-blend-mode:{mix}"
        return ET.SubElement(parent, svg_tag("rect"), values)

    def _cover(self, parent: ET.Element, colour: str, mask: ET.Element) -> ET.Element:
        """The whole picture in one colour, seen through a mask."""
        cover = self._rectangle(parent, colour)
        cover.set("mask", f"url(#{mask.get('id')})")
        return cover

    def _repeated(self, parent: ET.Element, name: str, **values: str) -> None:
        ET.SubElement(parent, svg_tag("use"), {AID: "true", xlink_href(): f"#{name}", **values})
