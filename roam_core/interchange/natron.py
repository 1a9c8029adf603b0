"""Natron `.py`: a script for Natron's script editor that builds a Roto node with layers, shapes and feather points.

Positions are pixels from the image's lower left corner, y up; handles and feather points are absolute. Layers of a Roto
node only group. Where a layer acts as one it is a Roto node of its own, joined by Merge nodes. Sums go beyond 1; where
something is taken from one, a Merge node with what is white everywhere cuts it off there.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.interchange.flatten import (
    TAKING,
    Branch,
    branched,
    dimmed_first,
    everything,
    has_feather_curve,
    hidden_notes,
    parts_of,
    takes_part,
    without_timed_intersect,
)
from roam_core.interchange.literals import python_literal, whole
from roam_core.interchange.protocol import STANDARD, ExportOptions, ShapeWriter, readied, settled, without_smooth_keys
from roam_core.interchange.text_exporter import TextExporter
from roam_core.interchange.timing import forwards, lifetime_steps, moments, smooth_notes, straight_keys, tangent_notes
from roam_core.roto import BlendMode, Layer, Project, RotoShape
from roam_core.roto.animated import values_of
from roam_core.translatable import N_, sentence

OPERATORS = {
    BlendMode.ADD: "eMergeOver",
    BlendMode.PLUS: "eMergePlus",
    BlendMode.SUBTRACT: "eMergeStencil",
    BlendMode.INTERSECT: "eMergeMask",
    BlendMode.DIFFERENCE: "eMergeDifference",
    BlendMode.MAX: "eMergeMax",
}
OPERATIONS = {
    BlendMode.ADD: "over",
    BlendMode.PLUS: "plus",
    BlendMode.SUBTRACT: "stencil",
    BlendMode.INTERSECT: "mask",
    BlendMode.DIFFERENCE: "difference",
    BlendMode.MAX: "max",
}
"""Of a Merge node; A is what lies above."""

DECIMALS = 6


class NatronExporter(TextExporter):
    """Writes a script that builds a Roto node with all layers and shapes of a project."""

    name = "natron"
    title = N_("Natron Roto node (script)")
    suffix = ".py"

    def document(self, project: Project, options: ExportOptions) -> tuple[str, tuple[str, ...]]:
        """The text; what Natron's shapes cannot hold is told."""
        return natron_script(project, options)


def natron_script(project: Project, options: ExportOptions = STANDARD) -> tuple[str, tuple[str, ...]]:
    """The script for all layers and shapes of `project`, and a sentence for each thing that it cannot hold."""
    clip = project.require_clip()
    root = branched(readied(project, options))
    cuts_sums = takes_from_sums(root)
    is_one_node = root.is_flat and not cuts_sums
    if not is_one_node:
        root = without_timed_intersect(root, clip.size)  # a node whose shape is not there is black
    shapes = list(root.shapes())
    flat = {shape.id: shape for shape in shapes}
    writer = _Writer(clip, options, max(len(shapes), 1), flat=flat, cuts_sums=cuts_sums)
    if is_one_node:
        parts = [writer.part("ROAM", writer.children(project.root))]
    else:
        parts = writer.parts(root) if root.opacity == 1.0 and not root.invert else [writer.branch(root)]
    text = PROGRAM.replace("@PARTS@", python_literal(parts))
    return text, settled(
        [*hidden_notes(project, root), *tangent_notes(project.root), *smooth_notes(project.root), *writer.notes],
        writer.losses,
        options,
    )


def takes_from_sums(root: Branch) -> bool:
    """True where a sum is inverted, dimmed, or has something over it that takes from it: it must not be beyond 1."""
    modes = [item.blend for item in root.items if takes_part(item)]
    if root.is_flat:
        after = modes[modes.index(BlendMode.PLUS) :] if BlendMode.PLUS in modes else []
        return any(mode in TAKING or mode is BlendMode.DIFFERENCE for mode in after)
    inner = (takes_from_sums(replace(item, invert=True)) for item in root.items if isinstance(item, Branch))
    return BlendMode.PLUS in modes or any(inner)


@dataclass
class _Writer(ShapeWriter):
    """Turns layers and shapes into the plain values from which the script builds items and nodes."""

    flat: dict[str, RotoShape] = field(default_factory=dict)
    cuts_sums: bool = False

    def part(self, name: str, items: list[dict[str, Any]], blend: BlendMode = BlendMode.ADD) -> dict[str, Any]:
        """A Roto node, and how it is merged with what lies under it."""
        return {"name": whole(name), "items": items, "operation": OPERATIONS[blend], "mix": [1.0, []]}

    def parts(self, branch: Branch) -> list[dict[str, Any]]:
        """What Merge nodes join, bottom first: Roto nodes and branches."""
        parts: list[dict[str, Any]] = []
        for part in parts_of(branch, lambda shape: shape.blend is not BlendMode.PLUS):
            is_sum = bool(parts) and part.blend is BlendMode.PLUS
            if isinstance(part.content, Branch):
                parts += [self.branch(part.content), *self._cut(is_sum)]
                continue
            name = next((shape.name for shape in part.content if takes_part(shape)), "ROAM")
            # What is merged by a node is drawn above nothing in its own.
            mode = BlendMode.ADD if parts else None
            items = [self._shape(shape, mode) for shape in reversed(part.content)]
            parts += [self.part(name, items, part.blend), *self._cut(is_sum)]
        return parts

    def _cut(self, is_sum: bool) -> list[dict[str, Any]]:
        """What cuts a sum off at 1: the lesser of it and of a shape around everything."""
        return [self.part("Everything", [self._everything()]) | {"operation": "min"}] if is_sum else []

    def _everything(self) -> dict[str, Any]:
        return self._shape(everything("Everything", self.clip.size, self.clip.first), None)

    def branch(self, branch: Branch) -> dict[str, Any]:
        """A branch and its parts; an inverted one is taken from a shape around everything."""
        branch = dimmed_first(branch)
        inner = self.parts(branch)
        if branch.invert:
            taken = {"name": whole(branch.name), "parts": inner, "operation": "stencil", "mix": [1.0, []]}
            inner = [self.part("Everything", [self._everything()]), taken]
        mix = self.value_rows(branch.opacity, straight_keys(branch.opacity))
        return {"name": whole(branch.name), "parts": inner, "operation": OPERATIONS[branch.blend], "mix": mix}

    def children(self, layer: Layer) -> list[dict[str, Any]]:
        """Items of a layer, the topmost first, as Natron lists them."""
        return [
            self._layer(child) if isinstance(child, Layer) else self._shape(self.flat[child.id], None)
            for child in reversed(layer.children)
        ]

    def _layer(self, layer: Layer) -> dict[str, Any]:
        return {
            "name": whole(layer.name),
            "locked": layer.locked,
            "visible": layer.visible,
            "children": self.children(layer),
        }

    def _shape(self, shape: RotoShape, mode: BlendMode | None) -> dict[str, Any]:
        """One shape, by its own mode where `mode` is None."""
        shape = without_smooth_keys(self.begun(shape))
        blur = None if shape.motion_blur is None else forwards(shape.motion_blur)
        if has_feather_curve(shape) and any(values_of(shape.feather)):
            self.notes.append(
                sentence(
                    "{name!r} has a feather curve and a uniform feather; Natron adds one to the other.", name=shape.name
                )
            )
        if shape.blend is BlendMode.PLUS and takes_part(shape) and not self.cuts_sums:
            self.notes.append(
                sentence("Natron's Plus goes beyond 1 where {name!r} overlaps what lies under it.", name=shape.name)
            )
        return {
            "name": whole(shape.name),
            "locked": shape.locked,
            "visible": shape.visible,
            "closed": shape.closed,
            "inverted": shape.invert,
            "operator": OPERATORS[shape.blend if mode is None else mode],
            "color": list(shape.colour),
            "opacity": self.value_rows(shape.opacity, straight_keys(shape.opacity)),
            "feather": self.value_rows(shape.feather, straight_keys(shape.feather)),
            "activated": [[self.numbered(frame), is_active] for frame, is_active in lifetime_steps(shape)],
            "blur": None if blur is None or not blur.is_seen else [blur.samples, blur.shutter, blur.phase],
            "keys": [
                [
                    moment.time,
                    self._rows(moment.key.points),
                    self._rows(
                        moment.key.points if moment.key.feather is None else moment.key.points + moment.key.feather
                    ),
                ]
                for moment in moments(shape, self.options.frame_offset)
            ],
        }

    def _rows(self, points: Array) -> list[list[float]]:
        """Each point as x, y, left x, left y, right x, right y; y up."""
        upright = np.array([0.0, self.clip.size[1]]) + points[:, [ANCHOR, IN, OUT]] * np.array([1.0, -1.0])
        rows: list[list[float]] = (np.round(upright.reshape(-1, 6), DECIMALS) + 0.0).tolist()
        return rows


PROGRAM = """\
# Shapes from ROAM. In Natron: paste this into the script editor and run it; `app` is the open project there.
import json

import NatronEngine

PARTS = json.loads(@PARTS@)


def named(item, name, number):
    item.setScriptName("Roam%d" % number)
    item.setLabel(name)


def put(bezier, knob, value):
    param = bezier.getParam(knob)
    if param is not None:
        param.setValue(value)


def animate(param, value):
    number, keys = value
    if param is None:
        return
    if not keys:
        param.setValue(number)
    kinds = NatronEngine.Natron.KeyframeTypeEnum
    for frame, number, holds in keys:
        param.setValueAtTime(number, frame)
    for frame, number, holds in keys:
        kind = kinds.eKeyframeTypeConstant if holds else kinds.eKeyframeTypeLinear
        param.setInterpolationAtTime(frame, kind)


def add_shape(roto, parent, data, number):
    keys = data["keys"]
    first = keys[0][1]
    bezier = roto.createBezier(first[0][0], first[0][1], keys[0][0])
    named(bezier, data["name"], number)
    parent.addItem(bezier)
    for row in first[1:]:
        bezier.addControlPoint(row[0], row[1])
    for frame, outline, feather in keys:
        for index in range(len(outline)):
            bezier.setPointAtIndex(index, frame, *outline[index])
            bezier.setFeatherPointAtIndex(index, frame, *feather[index])
    bezier.setCurveFinished(data["closed"])
    bezier.setCompositingOperator(getattr(NatronEngine.Natron.MergingFunctionEnum, data["operator"]))
    bezier.setOverlayColor(*data["color"])
    animate(bezier.getOpacityParam(), data["opacity"])
    animate(bezier.getFeatherDistanceParam(), data["feather"])
    put(bezier, "inverted", data["inverted"])
    if data["activated"]:
        put(bezier, "lifeTime", 4)
        for frame, is_active in data["activated"]:
            bezier.setActivated(frame, is_active)
    if data["blur"]:
        samples, shutter, phase = data["blur"]
        put(bezier, "motionBlur", samples)
        put(bezier, "motionBlurShutter", shutter)
        put(bezier, "motionBlurShutterOffset", 3)
        put(bezier, "motionBlurCustomShutterOffset", phase)
    bezier.setVisible(data["visible"])
    bezier.setLocked(data["locked"])


def add_items(roto, parent, items, number):
    for data in items:
        number += 1
        if "children" not in data:
            add_shape(roto, parent, data, number)
            continue
        layer = roto.createLayer()
        named(layer, data["name"], number)
        parent.addItem(layer)
        number = add_items(roto, layer, data["children"], number)
        layer.setVisible(data["visible"])
        layer.setLocked(data["locked"])
    return number


def roto(part):
    node = app.createNode("fr.inria.built-in.Roto")
    node.setLabel(part["name"])
    context = node.getRotoContext()
    add_items(context, context.getBaseLayer(), part["items"], 0)
    return node


def merged(part, under, above):
    # Input 0 is B, which lies under input 1, A.
    node = app.createNode("net.sf.openfx.MergePlugin")
    node.setLabel(part["name"])
    node.getParam("operation").set(part["operation"])
    animate(node.getParam("mix"), part["mix"])
    if under is not None:
        node.connectInput(0, under)
    node.connectInput(1, above)
    return node


def matte(part):
    if "items" in part:
        return roto(part)
    node = None
    for inner in part["parts"]:
        above = matte(inner)
        is_plain = node is None and inner["mix"] == [1.0, []]
        node = above if is_plain else merged(inner, node, above)
    return roto({"name": part["name"], "items": []}) if node is None else node


matte({"name": "ROAM", "parts": PARTS})
"""
