"""Nuke `.nk`: one Roto node as text that can be pasted into a script or imported.

The node's `curves` knob is a Tcl list (Foundry, NDK developer guide, "Roto serialisation format"). Numbers are single
precision in hexadecimal; y points up from the image's lower edge; handles are relative to their anchor, in the order
incoming handle, anchor, outgoing handle; keys carry a value and a slope in units per frame on either side.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

import numpy as np

from roam_core.geometry.bezier import ANCHOR
from roam_core.interchange.keys.reduction import Motion
from roam_core.interchange.nuke.attributes import BLEND_MODES, shape_attributes
from roam_core.interchange.nuke.graph import OPERATIONS, Joined, Painted, is_one_node, steps, told
from roam_core.interchange.nuke.keys import (
    KeyedCurves,
    feather_slopes,
    feather_triples,
    outline_slopes,
    outline_triples,
    timed_keys,
)
from roam_core.interchange.nuke.names import LAYER_KNOB, Names, knob_text, layer_word, roto_string
from roam_core.interchange.nuke.text import (
    HEAD,
    LOCKED,
    OPEN,
    RELATIVE_TANGENTS,
    RENDERABLE,
    ROOT_FLAGS,
    attribute_list,
    knob_curve,
    number,
    numbers,
)
from roam_core.interchange.protocol import STANDARD, ExportOptions, ShapeWriter, readied
from roam_core.interchange.telling import gathered
from roam_core.interchange.text_exporter import TextExporter
from roam_core.roto import BlendMode, Layer, Project, RotoShape
from roam_core.roto.animated import Animatable
from roam_core.translatable import N_

XPOS = 110
"""How far apart nodes stand in the graph."""


class NukeExporter(TextExporter):
    """Writes all layers and shapes of a project as one Roto node."""

    name = "nuke"
    title = N_("Nuke Roto node")
    suffix = ".nk"
    encoding = "utf-8"

    def document(self, project: Project, options: ExportOptions) -> tuple[str, tuple[str, ...]]:
        """The script; everything that ROAM knows of a shape has its place in it."""
        return roto_document(project, options)

    def pieces(self, project: Project, options: ExportOptions) -> tuple[Iterable[str], tuple[str, ...]]:
        """The script line by line: put together it takes several times the room of the file."""
        return _pieces(project, options)


def roto_document(project: Project, options: ExportOptions = STANDARD) -> tuple[str, tuple[str, ...]]:
    """The text of a script with all shapes of `project`, and a sentence for each thing that it says otherwise.

    One Roto node holds them all, unless a layer must be a matte of its own (`nuke.graph`): then several, and the nodes
    that join them.
    """
    pieces, notes = _pieces(project, options)
    return "".join(pieces), notes


def _pieces(project: Project, options: ExportOptions) -> tuple[list[str], tuple[str, ...]]:
    project = readied(project, options)
    clip = project.require_clip()
    writer = _Writer(clip, options, len(project.shapes), names=Names.of(project.root))
    writer.notes += (*told(project.root), *writer.names.notes())
    nodes = writer.roto(project.root, 1) if is_one_node(project.root) else writer.joined(project.root)
    return [HEAD, *nodes], gathered(writer.notes)


@dataclass
class _Writer(ShapeWriter):
    """Turns layers and shapes into lines of nested lists."""

    names: Names = field(default_factory=Names)

    def roto(self, root: Layer, number_of: int, *, is_over: bool = False) -> Iterator[str]:
        """A Roto node that paints what lies in a layer, over the last node's matte or over nothing."""
        width, height = self.clip.size
        first, last = (frame + self.options.frame_offset for frame in (self.clip.first, self.clip.last))
        label, names = self.names.within(root).lines()
        lines = [
            "Roto {",
            *([] if is_over else [" inputs 0"]),
            " output alpha",
            f' format "{width} {height} 0 0 {width} {height} {self.clip.pixel_aspect:g} ROAM_{width}x{height}"',
            f" curves {{{{{{v {number(1.2)}}}",
            "  {f 0}",
            "  {n",
            *self.layer(root, "   ", is_root=True),
            "  }}}",
            f" name Roto{number_of}",
            *label,
            " selected true",
            f" xpos {XPOS * (number_of - 1)}",
            " ypos 0",
            " addUserKnob {20 ROAM}",
            ' addUserKnob {3 first_frame l "first frame"}',
            f" first_frame {first}",
            ' addUserKnob {3 last_frame l "last frame"}',
            f" last_frame {last}",
            *names,
            "}",
        ]
        return (part for line in lines for part in (line, "\n"))

    def joined(self, root: Layer) -> Iterator[str]:
        """The nodes of `nuke_graph.steps`, in the order of a script: each takes the last ones that are left."""
        rotos = 0
        for step in steps(root):
            if isinstance(step, Painted):
                rotos += 1
                yield from self.roto(step.layer, rotos, is_over=step.is_over)
            elif isinstance(step, Joined):
                yield _node("Merge2", ["inputs 2", f"operation {OPERATIONS[step.mode]}"])
                if step.mode is BlendMode.PLUS:
                    yield _node("Clamp", ["channels alpha"])
            else:
                yield from self._finished(step.layer)

    def _finished(self, layer: Layer) -> Iterator[str]:
        if layer.invert:
            yield _node("Invert", ["channels alpha"])
        if layer.opacity != 1.0:
            value = knob_curve(layer.opacity, self.options.frame_offset)
            yield _node("Multiply", ["channels alpha", f"value {value}"])
        name = LAYER_KNOB
        yield _node(
            "NoOp",
            [
                f"label {knob_text(layer.name)}",
                "addUserKnob {20 ROAM}",
                f"addUserKnob {{1 {name} l layer +INVISIBLE}}",
                f"{name} {layer_word(layer)}",
            ],
        )

    def layer(self, layer: Layer, indent: str, *, is_root: bool = False) -> list[str]:
        width, height = self.clip.size
        attributes: list[tuple[str, Animatable]] = []
        if not layer.visible:
            attributes.append(("vis", 0))
        if not is_root or layer.opacity != 1.0:
            attributes.append(("opc", layer.opacity))
        if layer.invert:
            attributes.append(("inv", 1))
        if BLEND_MODES[layer.blend] and not is_root:  # an invisible one: others have a node of their own
            attributes.append(("bm", BLEND_MODES[layer.blend]))
        flags = (ROOT_FLAGS if is_root else RENDERABLE) | (LOCKED if layer.locked else 0)
        lines = [
            f"{indent}{{layer {'Root' if is_root else roto_string(self.names.by_id[layer.id])}",
            f"{indent} {{f {flags}}}",
            f"{indent} {{t {number(width / 2)} {number(height / 2)}}}",
            f"{indent} {attribute_list(attributes, self.options.frame_offset)}",
        ]
        for child in reversed(layer.children):  # Nuke lists what lies on top first
            inner = indent + " "
            lines += self.layer(child, inner) if isinstance(child, Layer) else self.shape(child, inner)
        lines[-1] += "}"
        return lines

    def shape(self, shape: RotoShape, indent: str) -> list[str]:
        shape, slopes = self.begun_for(shape, Motion.CUBIC)
        height = self.clip.size[1]
        timed = timed_keys(shape, slopes, self.options.frame_offset)
        outline = timed.curves([outline_triples(key.points, height) for key in timed.keys], outline_slopes)
        attributes = shape_attributes(shape, self.clip, self.options.frame_offset)
        pivot = shape.keys[0].points[:, ANCHOR].mean(axis=0)
        name, flags = roto_string(self.names.by_id[shape.id]), RELATIVE_TANGENTS | (0 if shape.closed else OPEN)
        feather = [indent + "  idem"]
        if any(key.feather is not None for key in timed.keys):
            values = [feather_triples(key.points, key.feather) for key in timed.keys]
            feather = _control_curve(timed.curves(values, feather_slopes), flags, indent + "  ")
        return [
            f"{indent}{{curvegroup {name} {RENDERABLE | (LOCKED if shape.locked else 0)} bezier",
            f"{indent} {{",
            *_control_curve(outline, flags, indent + "  "),
            *feather,
            f"{indent} }}",
            f"{indent} {{tx {number(timed.times[0])} {number(pivot[0])} {number(height - pivot[1])}}}",
            f"{indent} {attribute_list(attributes, self.options.frame_offset)}}}",
        ]


def _node(species: str, knobs: list[str]) -> str:
    return "\n".join([f"{species} {{", *(f" {knob}" for knob in knobs), "}", ""])


# ---- points and keys -------------------------------------------------------------------------------------------------


def _control_curve(curves: KeyedCurves, flags: int, indent: str) -> list[str]:
    """The `cc` list of an outline or feather curve."""
    stamps = " ".join(numbers(curves.times))
    if len(curves.times) == 1:
        columns = numbers(curves.values[0])
    else:
        columns, stamps = _key_lists(curves), f"{{{stamps}}}"
    points = [f"{indent}  {{{x} {y}}}" for x, y in zip(columns[::2], columns[1::2], strict=True)]
    return [f"{indent}{{cc", f"{indent} {{f {flags}}}", f"{indent} {{px {stamps}", *points, f"{indent} }}}}"]


def _key_lists(curves: KeyedCurves) -> list[str]:
    """The key lists of all columns. A column that never changes has one key for all times."""
    still = np.zeros((1, curves.values.shape[1]))
    sides = [curves.values, np.vstack([still, curves.reaching]), np.vstack([curves.leaving, still])]
    table = np.stack(sides, axis=-1).astype(np.float32).astype(np.float64)
    constant = (table == [1, 0, 0] * table[:1]).all(axis=(0, 2))
    lists = []
    for column in range(table.shape[1]):
        if constant[column]:
            lists.append(f"{{{{{number(curves.values[0, column])} -}}}}")
            continue
        words = iter(numbers(table[:, column].ravel()))
        keys = (f"{{{value} {left} 1 {right} 1}}" for value, left, right in zip(words, words, words, strict=True))
        lists.append(f"{{{' '.join(keys)}}}")
    return lists
