"""Silhouette `.fxs`: layers and shapes as XML.

Coordinates are measured from the image's centre in units of its height, y down, handles absolute in the order point,
incoming handle, outgoing handle, of B-splines the control points alone; keys are numbered from the session's first
frame. Silhouette's makers publish no
description: what stands here follows the exporters that artists use to bring shapes into it.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import bezier, bspline
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.interchange.authorship import MARK
from roam_core.interchange.flatten import everything, is_feathered, shown_shapes, untimed_intersect
from roam_core.interchange.protocol import STANDARD, ExportOptions, ShapeWriter, readied, settled, without_smooth_keys
from roam_core.interchange.sums import UNIONS, Item, is_shown, soft_sums
from roam_core.interchange.text_exporter import TextExporter
from roam_core.interchange.timing import opacity_keys, smooth_notes, tangent_notes
from roam_core.interchange.xml import xml_text
from roam_core.roto import (
    Animated,
    BlendMode,
    Clip,
    Interpolation,
    Keyframe,
    Layer,
    Project,
    RotoShape,
    Spline,
)
from roam_core.roto.animated import Animatable, is_always, product
from roam_core.translatable import N_, sentence

MODES = {
    BlendMode.ADD: "Add",
    BlendMode.PLUS: "Add",
    BlendMode.SUBTRACT: "Subtract",
    BlendMode.INTERSECT: "Inside",
    BlendMode.DIFFERENCE: "Difference",
    BlendMode.MAX: "Max",
}
PATH_KINDS = {Spline.BEZIER: "Bezier", Spline.BSPLINE: "Bspline"}
SCALED_BY_THEIR_LAYER = {BlendMode.ADD, BlendMode.PLUS, BlendMode.DIFFERENCE, BlendMode.MAX}
"""Scaling these scales what they do in the layer; those that subtract or lie inside act on what is scaled."""


VEIL = "Opacity of "
"""How the name of a shape begins that holds the opacity of its layer, whose name follows."""


class SilhouetteExporter(TextExporter):
    """Writes all layers and shapes of a project as a Silhouette shape file."""

    name = "silhouette"
    title = N_("Silhouette shapes")
    suffix = ".fxs"
    encoding = "utf-8"

    def document(self, project: Project, options: ExportOptions) -> tuple[str, tuple[str, ...]]:
        """The text; what Silhouette's file cannot hold is told."""
        return silhouette_document(project, options)

    def pieces(self, project: Project, options: ExportOptions) -> tuple[Iterable[str], tuple[str, ...]]:
        """The file shape by shape: put together it takes the room of the file once more."""
        return _pieces(project, options)


def silhouette_document(project: Project, options: ExportOptions = STANDARD) -> tuple[str, tuple[str, ...]]:
    """The text of a shape file with all shapes of `project`, and a sentence for each thing that it cannot hold.

    The key of frame f is numbered f minus the clip's first frame plus the options' offset; the session's own range
    stays the plate's.
    """
    pieces, notes = _pieces(project, options)
    return "".join(pieces), notes


def _pieces(project: Project, options: ExportOptions) -> tuple[Iterator[str], tuple[str, ...]]:
    project = readied(project, options)
    clip = project.require_clip()
    session = ET.Element(
        "Silhouette",
        width=str(clip.size[0]),
        height=str(clip.size[1]),
        pixelAspect=f"{clip.pixel_aspect:g}",
        workRangeStart=str(clip.first),
        workRangeEnd=str(clip.last),
        sessionStartFrame=str(clip.first),
    )
    shown = frozenset(shape.id for shape in shown_shapes(project.root))
    writer = _Writer(clip, options, len(project.shapes), shown=shown)
    writer.notes += [*tangent_notes(project.root), *smooth_notes(project.root)]
    project = replace(project, root=writer.veiled(_without_timed_intersect(project.root, clip.size)))
    writer.total = len(project.shapes)
    root = ET.SubElement(session, "Layer", type="Layer", label=xml_text(project.root.name), expanded="True")
    if not project.root.visible or project.root.locked:
        root.attrib.update(_flags(project.root))
    writer.fill_layer(root, replace(project.root, blend=BlendMode.ADD), 1.0)
    lost = [item.id for item in soft_sums(project.root)]
    sums = [item for item in project.root.items() if item.blend is BlendMode.PLUS]
    for told, items in (
        (writer.losses, [item for item in sums if item.id in lost]),
        (writer.notes, [item for item in sums if item.id not in lost]),
    ):
        if items:
            told.append(
                sentence(
                    "Silhouette has one Add for ROAM's add and plus: that is what {some} becomes.", some=_some(items)
                )
            )
    return _text(session, writer.keys), settled(writer.notes, writer.losses, options)


def _text(session: ET.Element, keys: Sequence[str]) -> Iterator[str]:
    """The file of a session, with the keys of each shape in place of the comment that has their number."""
    ET.indent(session, " ")
    yield f"<!-- Silhouette Shape File -->\n<!-- {MARK} -->\n"
    parts = re.split(r"<!--(\d+)-->", ET.tostring(session, encoding="unicode"))  # in names, `<` is escaped
    for number, part in enumerate(parts):
        yield keys[int(part)] if number % 2 else part
    yield "\n"


def _some(items: Sequence[Item]) -> str:
    """The names of some items, of which six are enough."""
    names = ", ".join(repr(item.name) for item in items[:6])
    return sentence("{names} and others", names=names) if len(items) > 6 else names


def normalised(points: Array, clip: Clip) -> Array:
    """Positions `(..., 2)` in pixels as Silhouette measures them: from the centre, in image heights, y down."""
    width, height = clip.size
    result: Array = (points - np.array([width, height]) / 2.0) / height * np.array([clip.pixel_aspect, 1.0])
    return result


@dataclass
class _Writer(ShapeWriter):
    """Fills XML elements from layers and shapes; gathers what is lost on the way.

    `shown` has the ids of shapes that make the matte. `keys` has the outlines of each shape as text, for which a
    comment stands among the elements: an element for each point takes many times the room.
    """

    KINDS = frozenset(PATH_KINDS)

    shown: frozenset[str] = frozenset()
    keys: list[str] = field(default_factory=list)

    def veiled(self, layer: Layer) -> Layer:
        """The layer with a shape of its opacity lying inside of all that is in it, where its shapes cannot have it."""
        children = tuple(self.veiled(child) if isinstance(child, Layer) else child for child in layer.children)
        layer = replace(layer, children=children)
        if is_always(layer.opacity, 1.0) or not is_shown(layer) or _folds(layer):
            return layer
        name = f"{VEIL}{layer.name}"
        self.notes.append(
            sentence(
                "Silhouette layers have no opacity: that of {name!r} is a shape inside, {veil!r}.",
                name=layer.name,
                veil=name,
            )
        )
        veil = everything(name, self.clip.size, self.clip.first)
        veil = replace(veil, id=f"{layer.id} opacity", blend=BlendMode.INTERSECT, opacity=layer.opacity)
        held = layer.children if not layer.invert else (replace(layer, opacity=1.0, blend=BlendMode.ADD),)
        return replace(layer, children=(*held, veil), opacity=1.0, invert=False)

    def fill_layer(self, element: ET.Element, layer: Layer, opacity: Animatable, depth: int = 1) -> None:
        """Properties and children of a layer, `depth` elements deep in the file.

        `opacity` is what the layers around it leave of its shapes'.
        """
        opacity = product(opacity, layer.opacity)
        if layer.opacity != 1.0:
            self.notes.append(
                sentence("Silhouette layers have no opacity: that of {name!r} goes into its shapes.", name=layer.name)
            )
        properties = ET.SubElement(element, "Properties")
        _constant(properties, "color", "(1.000000,1.000000,1.000000)")
        _constant(properties, "invert", _truth(layer.invert))
        _constant(properties, "mode", MODES[layer.blend])
        objects = ET.SubElement(properties, "Property", id="objects", constant="True", expanded="True")
        for child in layer.children:  # bottom first, as in ROAM
            if isinstance(child, Layer):
                inner = ET.SubElement(objects, "Object", type="Layer", label=xml_text(child.name), expanded="True")
                inner.attrib.update(_flags(child))
                self.fill_layer(inner, child, opacity if child.blend in SCALED_BY_THEIR_LAYER else 1.0, depth + 3)
            else:
                self.add_shape(objects, child, opacity, depth + 3)

    def add_shape(self, objects: ET.Element, shape: RotoShape, opacity: Animatable, depth: int) -> None:
        shape = without_smooth_keys(self.begun(shape))
        if shape.point_count < 2 and _is_loop(shape):
            self.notes.append(
                sentence(
                    "Silhouette refuses shapes of a single point: {name!r} gets another one halfway around.",
                    name=shape.name,
                )
            )
            shape = shape.map_points(lambda points: bezier.split(points, 0, 0.5))
        elif shape.point_count < 2:
            self.notes.append(
                sentence("Silhouette refuses shapes of a single point: {name!r} is left out.", name=shape.name)
            )
            return
        self._note_losses(shape)
        kind = PATH_KINDS[shape.spline]
        element = ET.SubElement(objects, "Object", type="Shape", label=xml_text(shape.name), shape_type=kind)
        element.attrib.update(_flags(shape))
        properties = ET.SubElement(element, "Properties")
        share = opacity if shape.blend in SCALED_BY_THEIR_LAYER else 1.0
        self._add_opacity(properties, shape, product(shape.opacity, share))
        _constant(properties, "motionBlur", _truth(shape.is_blurred))
        _constant(properties, "outlineColor", _tuple(np.array(shape.colour)))
        _constant(properties, "mode", MODES[shape.blend])
        _constant(properties, "invert", _truth(shape.invert))
        path = ET.SubElement(properties, "Property", id="path")
        indent = "\n" + " " * (depth + 3)
        path.append(ET.Comment(str(len(self.keys))))
        self.keys.append(indent.join(self._path_key(key, shape, indent) for key in shape.keys))

    def _note_losses(self, shape: RotoShape) -> None:
        if is_feathered(shape):
            lost = self.losses if shape.id in self.shown else self.notes
            lost.append(
                sentence(
                    "The feather of {name!r} is lost: how a Silhouette file holds it is not known.", name=shape.name
                )
            )
        if shape.is_blurred:
            self.notes.append(
                sentence("Silhouette's shutter is the session's: that of {name!r} is left out.", name=shape.name)
            )

    def _add_opacity(self, properties: ET.Element, shape: RotoShape, opacity: Animatable) -> None:
        """A constant or keys; for a lifetime they hold zero before and after it."""
        if shape.lifetime is None and not isinstance(opacity, Animated):
            _constant(properties, "opacity", f"{100.0 * opacity:.6f}")
            return
        entry = ET.SubElement(properties, "Property", id="opacity")
        for key in opacity_keys(replace(shape, opacity=opacity)):
            interp = "hold" if key.interpolation is Interpolation.HOLD else "linear"
            element = ET.SubElement(entry, "Key", frame=self._frame(key.frame), interp=interp)
            element.text = f"{100.0 * key.value:.6f}"

    def _path_key(self, key: Keyframe, shape: RotoShape, indent: str) -> str:
        interp = "hold" if key.interpolation is Interpolation.HOLD else "linear"
        if shape.spline is Spline.BSPLINE:
            held = bspline.control_polygon(key.points, shape.closed)[:, None]
        else:
            held = key.points[:, [ANCHOR, IN, OUT]]
        points = (",".join(map(_tuple, point)) for point in normalised(held, self.clip))
        lines = (
            f'<Key frame="{self._frame(key.frame)}" interp="{interp}">',
            f' <Path closed="{shape.closed}" type="{PATH_KINDS[shape.spline]}">',
            *(f"  <Point>{point}</Point>" for point in points),
            " </Path>",
            "</Key>",
        )
        return indent.join(lines)

    def _frame(self, frame: int) -> str:
        return str(frame - self.clip.first + self.options.frame_offset)


def _without_timed_intersect(layer: Layer, size: tuple[int, int]) -> Layer:
    """The layer without intersecting shapes of a lifetime: outside of it, their opacity of zero would take all."""
    children: list[Item] = []
    for child in layer.children:
        children += (
            [_without_timed_intersect(child, size)] if isinstance(child, Layer) else untimed_intersect(child, size)
        )
    return replace(layer, children=tuple(children))


def _folds(layer: Layer) -> bool:
    """True where scaling what lies in a layer scales its joint matte, which no inversion and no union of two does."""
    if layer.invert:
        return False
    under: list[Item] = []
    for child in filter(is_shown, layer.children):
        if child.blend in UNIONS and any(_may_overlap(child, each) for each in under):
            return False
        if isinstance(child, Layer) and child.blend in SCALED_BY_THEIR_LAYER and not _folds(child):
            return False
        under.append(child)
    return True


def _is_loop(shape: RotoShape) -> bool:
    """Whether a shape of a single point goes around something by its handles."""
    return shape.closed and any(bool((key.points != key.points[:, :1]).any()) for key in shape.keys)


def _may_overlap(first: Item, second: Item) -> bool:
    """False where the boxes around two shapes or layers, over all frames, do not meet."""
    (low, high), (below, above) = _box(first), _box(second)
    return bool((low <= above).all() and (below <= high).all())


def _box(item: Item) -> tuple[Array, Array]:
    inside = [item, *item.items()] if isinstance(item, Layer) else [item]
    if any(each.invert for each in inside):
        return np.full(2, -np.inf), np.full(2, np.inf)
    points = [key.points.reshape(-1, 2) for each in inside if isinstance(each, RotoShape) for key in each.keys]
    whole = np.concatenate(points) if points else np.full((1, 2), np.nan)
    return whole.min(axis=0) - 1.0, whole.max(axis=0) + 1.0


def _flags(item: Layer | RotoShape) -> dict[str, str]:
    return {"hidden": str(not item.visible), "locked": str(item.locked)}


def _constant(properties: ET.Element, name: str, value: str) -> None:
    ET.SubElement(ET.SubElement(properties, "Property", constant="True", id=name), "Value").text = value


def _truth(value: bool) -> str:
    return "true" if value else "false"


def _tuple(values: Array) -> str:
    """Always six decimals: Silhouette may refuse a number with an exponent."""
    return "(" + ",".join(f"{value:.6f}" for value in values.tolist()) + ")"
