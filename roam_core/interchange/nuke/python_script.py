"""Nuke, by a Python script: the same nodes made through `nuke.rotopaint`, as a cross-check of the pasted text.

Run it in Nuke's script editor. The part that does the work is the same in every script; what the project holds stands
in front of it as JSON in ASCII, so that no name can be anything but a name. It runs under Python 2.7 and 3.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from dataclasses import astuple, dataclass, field
from typing import Any

from roam_core.interchange.keys.reduction import Motion
from roam_core.interchange.nuke.attributes import BLEND_MODES, shape_attributes
from roam_core.interchange.nuke.graph import OPERATIONS, Joined, Painted, Step, is_one_node, steps, told
from roam_core.interchange.nuke.keys import (
    KeyedCurves,
    feather_slopes,
    feather_triples,
    outline_slopes,
    outline_triples,
    timed_keys,
    value_curve,
)
from roam_core.interchange.nuke.names import KNOB, LAYER_KNOB, Names, inert, layer_word
from roam_core.interchange.protocol import STANDARD, ExportOptions, ShapeWriter, readied
from roam_core.interchange.telling import gathered
from roam_core.interchange.text_exporter import TextExporter
from roam_core.interchange.timing import straight_keys, value_moments
from roam_core.roto import Animated, BlendMode, Layer, Project, RotoShape
from roam_core.roto.animated import Animatable
from roam_core.translatable import N_

SCRIPT = '''# Shapes from ROAM for Nuke's script editor: makes a Roto node, or several that are joined.
import json
import sys

import nuke
import nuke.rotopaint as rp

DOCUMENT = json.loads(
%s
)


def text(name):
    """Python 2's classes take bytes."""
    return name.encode("utf-8") if sys.version_info[0] < 3 else name


def attributes_of(item, values):
    """Numbers; or keys: times, values, and slopes on either side."""
    attributes = item.getAttributes()
    for name, value in values:
        if not isinstance(value, list):
            attributes.set(str(name), value)
            continue
        times, numbers, left, right = value
        for time, number in zip(times, numbers):
            attributes.set(time, str(name), number)
        sloped(attributes.getCurve(str(name)), times, numbers, right[:-1], left[1:])


def animate(point, times, columns, weight):
    """One control point."""
    x, y = columns
    for index, time in enumerate(times):
        point.addPositionKey(time, rp.CVec3(x[0][index], y[0][index], weight))
    for axis, (values, leaving, reaching) in enumerate(columns):
        sloped(point.getPositionAnimCurve(axis), times, values, leaving, reaching)


def sloped(curve, times, values, leaving, reaching):
    """Slopes of the keys. A key's type is InterpolationType plus one: 2 is straight, 3 cubic with these slopes."""
    straight = [
        abs(slope - (values[i + 1] - values[i]) / (times[i + 1] - times[i])) < 1e-6
        and abs(reaching[i] - slope) < 1e-6
        for i, slope in enumerate(leaving)
    ]
    for index in range(len(times)):
        key = curve.getKey(index)
        if all(straight[max(index - 1, 0) : index + 1]):
            key.interpolationType = 2
            continue
        key.interpolationType = 3
        key.la = key.ra = 1.0
        key.lslope = reaching[index - 1] if index else 0.0
        key.rslope = leaving[index] if index < len(leaving) else 0.0


def make_shape(knob, values):
    shape = rp.Shape(knob, type="bezier")
    shape.name = text(values["name"])
    curves = values["curves"]
    for entry in range(0, len(curves[0]), 3):
        shape.append(rp.AnimControlPoint(curves[0][entry + 1][0][0][0], curves[0][entry + 1][1][0][0]))
    for index, point in enumerate(shape):
        parts = [(point.leftTangent, 0.0), (point.center, 1.0), (point.rightTangent, 0.0)]
        feathers = [(point.featherLeftTangent, 0.0), (point.featherCenter, 0.0), (point.featherRightTangent, 0.0)]
        for group, entries in zip((parts, feathers), curves):
            for (part, weight), columns in zip(group, entries[3 * index : 3 * index + 3]):
                animate(part, values["times"], columns, weight)
    attributes_of(shape, values["attributes"])
    if values["open"]:
        shape.setFlag(rp.FlagType.eOpenFlag, True)
    if values["locked"]:
        shape.locked = True
    return shape


def fill(knob, parent, children):
    for values in children:
        if "children" in values:
            layer = rp.Layer(knob)
            layer.name = text(values["name"])
            attributes_of(layer, values["attributes"])
            layer.locked = values["locked"]
            parent.append(layer)
            fill(knob, layer, values["children"])
        else:
            parent.append(make_shape(knob, values))


def put(knob, value):
    """A value; or a list of times and values between which it moves straight."""
    if not isinstance(value, list):
        knob.setValue(value)
        return
    knob.setAnimated()
    for time, number in value:
        knob.setValueAt(number, time)
    for curve in knob.animations():
        curve.changeInterpolation(curve.keys(), nuke.LINEAR)


def remember(node, values):
    """Labels to read, and what ROAM's reader takes names from."""
    node["label"].setValue(text(values["label"]))
    for name, value in values["knobs"]:
        node.addKnob(nuke.String_Knob(name, name, value))


def roto(values, left):
    node = nuke.nodes.Roto()
    node["output"].setValue("alpha")
    if values["over"]:
        node.setInput(0, left.pop())
    knob = node["curves"]
    root = knob.rootLayer
    attributes_of(root, values["root"]["attributes"])
    fill(knob, root, values["root"]["children"])
    knob.changed()
    return node


def main():
    """Each step takes the last nodes that are left, and leaves one."""
    left = []
    for step in DOCUMENT:
        if step["node"] == "Roto":
            node = roto(step, left)
        else:
            node = getattr(nuke.nodes, step["node"])()
            for name, value in step["set"]:
                put(node[name], value)
            for index in range(step["inputs"]):
                node.setInput(index, left.pop())
        if step["label"] or step["knobs"]:
            remember(node, step)
        left.append(node)


main()
'''


class NukePythonExporter(TextExporter):
    """Writes all layers and shapes of a project as a Python script for Nuke."""

    name = "nuke-python"
    title = N_("Nuke Python script")
    suffix = ".py"

    def document(self, project: Project, options: ExportOptions) -> tuple[str, tuple[str, ...]]:
        """The script and what is told of it."""
        return python_document(project, options)


def python_document(project: Project, options: ExportOptions = STANDARD) -> tuple[str, tuple[str, ...]]:
    """The text of a script that makes all shapes of `project`, and a sentence for each thing that it says otherwise."""
    project = readied(project, options)
    root = project.root
    writer = _Writer(project.require_clip(), options, len(project.shapes), names=Names.of(root))
    writer.notes += (*told(root), *writer.names.notes())
    made = [writer.roto(root)] if is_one_node(root) else [node for step in steps(root) for node in writer.nodes(step)]
    document = json.dumps(made, ensure_ascii=True, allow_nan=False)
    pieces = (document[start : start + 100] for start in range(0, len(document), 100))
    return SCRIPT % "\n".join(f"    {piece!r}" for piece in pieces), gathered(writer.notes)


@dataclass
class _Writer(ShapeWriter):
    """Turns layers and shapes into plain values."""

    names: Names = field(default_factory=Names)

    def nodes(self, step: Step) -> Iterator[dict[str, Any]]:
        """The nodes of a step, each with the number of last ones that it takes."""
        if isinstance(step, Painted):
            yield self.roto(step.layer, is_over=step.is_over)
        elif isinstance(step, Joined):
            yield _node("Merge2", 2, [("operation", OPERATIONS[step.mode])])
            if step.mode is BlendMode.PLUS:
                yield _node("Clamp", 1, [("channels", "alpha")])
        else:
            layer = step.layer
            if layer.invert:
                yield _node("Invert", 1, [("channels", "alpha")])
            if layer.opacity != 1.0:
                value: Any = layer.opacity
                if isinstance(value, Animated):
                    value = value_moments(straight_keys(value), self.options.frame_offset)
                yield _node("Multiply", 1, [("channels", "alpha"), ("value", value)])
            yield {**_node("NoOp", 1, []), "label": inert(layer.name), "knobs": [(LAYER_KNOB, layer_word(layer))]}

    def attributes(self, values: Iterable[tuple[str, Animatable]]) -> list[tuple[str, Any]]:
        """Names with numbers, or with times, values, and slopes on either side."""
        return [
            (name, astuple(value_curve(value, self.options.frame_offset)) if isinstance(value, Animated) else value)
            for name, value in values
        ]

    def roto(self, root: Layer, *, is_over: bool = False) -> dict[str, Any]:
        """A Roto node that paints what lies in a layer."""
        names = self.names.within(root)
        knobs = [(KNOB, names.knob)] if names.changed else []
        return {**_node("Roto", 0, []), "over": is_over, "root": self.layer(root), "label": names.label, "knobs": knobs}

    def layer(self, layer: Layer) -> dict[str, Any]:
        attributes = [("vis", float(layer.visible)), ("opc", layer.opacity), ("inv", float(layer.invert))]
        attributes.append(("bm", BLEND_MODES[layer.blend]))
        children = (  # Nuke's topmost comes first
            self.layer(child) if isinstance(child, Layer) else self.shape(child) for child in reversed(layer.children)
        )
        return {
            "name": self.names.by_id.get(layer.id, "Root"),
            "attributes": self.attributes(attributes),
            "locked": layer.locked,
            "children": list(children),
        }

    def shape(self, shape: RotoShape) -> dict[str, Any]:
        shape, slopes = self.begun_for(shape, Motion.CUBIC)
        timed = timed_keys(shape, slopes, self.options.frame_offset)
        height = self.clip.size[1]
        curves = [timed.curves([outline_triples(key.points, height) for key in timed.keys], outline_slopes)]
        if any(key.feather is not None for key in timed.keys):
            values = [feather_triples(key.points, key.feather) for key in timed.keys]
            curves.append(timed.curves(values, feather_slopes))
        return {
            "name": self.names.by_id[shape.id],
            "open": not shape.closed,
            "locked": shape.locked,
            "attributes": self.attributes(shape_attributes(shape, self.clip, self.options.frame_offset)),
            "times": timed.times,
            "curves": [_entries(each) for each in curves],
        }


def _entries(curves: KeyedCurves) -> list[list[tuple[list[float], list[float], list[float]]]]:
    """For each entry (in, point, out of each point in turn) its x and y: values, slopes leaving and reaching."""
    sides = (curves.values.T, curves.leaving.T, curves.reaching.T)
    columns = list(zip(*(side.tolist() for side in sides), strict=True))
    return [list(pair) for pair in zip(columns[::2], columns[1::2], strict=True)]


def _node(species: str, inputs: int, values: list[tuple[str, Any]]) -> dict[str, Any]:
    return {"node": species, "inputs": inputs, "set": values, "label": "", "knobs": []}
