"""Natron `.py`: a script for Natron's script editor that builds a Roto node with layers, shapes and feather points.

Positions are pixels from the image's lower left corner, y up; handles and feather points are absolute.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.interchange.flatten import flattened, lifetime_steps, without_holds
from roam_core.interchange.literals import python_literal, whole
from roam_core.interchange.protocol import STANDARD, ExportOptions, ShapeWriter, without_smooth_keys
from roam_core.roto import BlendMode, Layer, Project, RotoShape
from roam_core.roto.file import write_atomically

Array = NDArray[np.float64]

OPERATORS = {
    BlendMode.ADD: "eMergeOver",
    BlendMode.PLUS: "eMergePlus",
    BlendMode.SUBTRACT: "eMergeStencil",
    BlendMode.INTERSECT: "eMergeMask",
    BlendMode.DIFFERENCE: "eMergeDifference",
    BlendMode.MAX: "eMergeMax",
}
DECIMALS = 6


class NatronExporter:
    """Writes a script that builds a Roto node with all layers and shapes of a project."""

    name = "natron"
    title = "Natron Roto node (script)"
    suffix = ".py"

    def export(self, project: Project, path: Path, options: ExportOptions = STANDARD) -> tuple[str, ...]:
        """Write `project` to `path`; what Natron's shapes cannot hold comes back as sentences."""
        text, notes = natron_script(project, options)
        options.advance(1.0, f"Writing {path.name}")
        write_atomically(path, text.encode("ascii"))
        return notes


def natron_script(project: Project, options: ExportOptions = STANDARD) -> tuple[str, tuple[str, ...]]:
    """The script for all layers and shapes of `project`, and a sentence for each thing that it cannot hold."""
    clip = project.require_clip()
    flat = flattened(project, "Natron")
    writer = _Writer(clip, options, len(flat.shapes), flat={shape.id: shape for shape in flat.shapes})
    tree = writer.children(project.root)
    return PROGRAM.replace("@TREE@", python_literal(tree)), (*flat.notes, *writer.notes)


@dataclass
class _Writer(ShapeWriter):
    """Turns layers and shapes into the plain values from which the script builds items."""

    flat: dict[str, RotoShape] = field(default_factory=dict)

    def children(self, layer: Layer) -> list[dict[str, Any]]:
        """Items of a layer, the topmost first, as Natron lists them."""
        return [
            self._layer(child) if isinstance(child, Layer) else self._shape(self.flat[child.id])
            for child in reversed(layer.children)
        ]

    def _layer(self, layer: Layer) -> dict[str, Any]:
        return {
            "name": whole(layer.name),
            "locked": layer.locked,
            "visible": layer.visible,
            "children": self.children(layer),
        }

    def _shape(self, shape: RotoShape) -> dict[str, Any]:
        shape = without_holds(without_smooth_keys(self.begun(shape)))
        blur = shape.motion_blur
        if any(key.feather is not None and key.feather.any() for key in shape.keys) and shape.feather:
            self.notes.append(
                f"{shape.name!r} has a feather curve and a uniform feather; Natron adds one to the other."
            )
        return {
            "name": whole(shape.name),
            "locked": shape.locked,
            "visible": shape.visible,
            "closed": shape.closed,
            "inverted": shape.invert,
            "operator": OPERATORS[shape.blend],
            "color": list(shape.colour),
            "opacity": shape.opacity,
            "feather": shape.feather,
            "activated": [[self._frame(frame), is_active] for frame, is_active in lifetime_steps(shape)],
            "blur": None if blur is None else [blur.samples, blur.shutter, blur.phase],
            "keys": [
                [
                    self._frame(key.frame),
                    self._rows(key.points),
                    self._rows(key.points if key.feather is None else key.points + key.feather),
                ]
                for key in shape.keys
            ],
        }

    def _rows(self, points: Array) -> list[list[float]]:
        """Each point as x, y, left x, left y, right x, right y; y up."""
        upright = np.array([0.0, self.clip.size[1]]) + points[:, [ANCHOR, IN, OUT]] * np.array([1.0, -1.0])
        rows: list[list[float]] = (np.round(upright.reshape(-1, 6), DECIMALS) + 0.0).tolist()
        return rows

    def _frame(self, frame: int) -> int:
        return frame + self.options.frame_offset


PROGRAM = """\
# Shapes from ROAM. In Natron: paste this into the script editor and run it; `app` is the open project there.
import json

import NatronEngine

TREE = json.loads(@TREE@)


def named(item, name, number):
    item.setScriptName("Roam%d" % number)
    item.setLabel(name)


def put(bezier, knob, value):
    param = bezier.getParam(knob)
    if param is not None:
        param.setValue(value)


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
    bezier.getOpacityParam().setValue(data["opacity"])
    bezier.getFeatherDistanceParam().setValue(data["feather"])
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


node = app.createNode("fr.inria.built-in.Roto")
roto = node.getRotoContext()
add_items(roto, roto.getBaseLayer(), TREE, 0)
"""
