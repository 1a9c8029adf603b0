"""After Effects `.jsx`: a script that puts every shape as a mask on the selected layer, or on a new solid.

Positions are pixels of the layer from its top-left corner, y down; handles are relative to their vertex; times are
seconds. The script is plain ASCII and old JavaScript (ECMAScript 3), and every name in it is a quoted string.

Masks of a layer are joined one after the other. Where layers of shapes act as one, compositions join them in white on
black, by blending modes over what is opaque: Normal in white is the union, in black it subtracts, Screen adds a
composition, Difference inverts it above white. The outcome is the layer's luma matte.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.interchange.after_effects.program import PROGRAM
from roam_core.interchange.feather_curve import feather_radii
from roam_core.interchange.flatten import (
    Branch,
    Part,
    branched,
    dimmed_first,
    has_feather_curve,
    hidden_notes,
    parts_of,
    takes_part,
)
from roam_core.interchange.keys.reduction import Motion
from roam_core.interchange.literals import Literal, javascript_literal, javascript_pieces
from roam_core.interchange.protocol import STANDARD, ExportOptions, ShapeWriter, readied, settled
from roam_core.interchange.telling import MODE_WORDS
from roam_core.interchange.text_exporter import TextExporter
from roam_core.interchange.timing import beside_zeros, opacity_keys, straight_keys, tangent_notes
from roam_core.roto import BlendMode, Interpolation, Keyframe, Project, RotoShape
from roam_core.roto.animated import Animatable, ValueKey, mapped, value_at, values_of
from roam_core.translatable import N_, sentence

MODES = {
    BlendMode.ADD: "ADD",
    BlendMode.SUBTRACT: "SUBTRACT",
    BlendMode.INTERSECT: "INTERSECT",
    BlendMode.DIFFERENCE: "DIFFERENCE",
    BlendMode.MAX: "LIGHTEN",
}
LAYER_MODES = {
    BlendMode.ADD: "SCREEN",
    BlendMode.SUBTRACT: "MULTIPLY",
    BlendMode.INTERSECT: "MULTIPLY",
    BlendMode.DIFFERENCE: "DIFFERENCE",
    BlendMode.MAX: "LIGHTEN",
    BlendMode.PLUS: "ADD",
}
"""Blending modes of opaque layers in white on black; what subtracts is inverted first."""

OPAQUE = (BlendMode.DIFFERENCE, BlendMode.MAX, BlendMode.PLUS)
"""Modes for which a shape needs a picture of its own; in the others its white or black lies above what is there."""

HIDDEN = "NONE"
"""The mode of a mask that takes no part: After Effects knows no other way to hide one."""

DECIMALS = 6
MOST_MASKS = 127
"""On one layer."""

OUTER, INNER = 0, 1
"""Directions of After Effects' feather points."""


class AfterEffectsExporter(TextExporter):
    """Writes a script that builds a mask for every shape of a project."""

    name = "after-effects"
    title = N_("After Effects masks (script)")
    suffix = ".jsx"

    def document(self, project: Project, options: ExportOptions) -> tuple[str, tuple[str, ...]]:
        """The text; what After Effects' masks cannot hold is told."""
        return mask_script(project, options)

    def pieces(self, project: Project, options: ExportOptions) -> tuple[Iterable[str], tuple[str, ...]]:
        """The script mask by mask: put together it takes the room of the file once more."""
        return _script_pieces(project, options)


def mask_script(project: Project, options: ExportOptions = STANDARD) -> tuple[str, tuple[str, ...]]:
    """The script for all shapes of `project`, and a sentence for each thing that it cannot hold.

    Frame f of the plate lies (f + offset - first frame) / fps seconds after the start of a layer that is there; a
    composition that the script makes begins with the plate's first frame, and gives it its number and the offset.
    """
    pieces, notes = _script_pieces(project, options)
    return "".join(pieces), notes


def _script_pieces(project: Project, options: ExportOptions) -> tuple[Iterator[str], tuple[str, ...]]:
    clip = project.require_clip()
    root = branched(readied(project, options), timed_intersect=False)
    shapes = list(root.shapes())
    writer = _Writer(clip, options, len(shapes))
    parts = writer.parts(root) if root.opacity == 1.0 and not root.invert else [writer.branch(root)]
    if not shapes or (len(parts) == 1 and "masks" in parts[0] and any(takes_part(shape) for shape in shapes)):
        parts = [{"masks": [], **(parts[0] if parts else {}), "isFlat": True}]
    frame = {
        "width": clip.size[0],
        "height": clip.size[1],
        "aspect": clip.pixel_aspect,
        "fps": clip.fps,
        "first": clip.first + options.frame_offset,
        "length": len(clip.frame_range),
        "offset": options.frame_offset,
        "blurred": any(shape.is_blurred for shape in shapes),
    }
    told = [*hidden_notes(project, root), *tangent_notes(project.root), *writer.notes]
    return _program(frame, parts), settled(told, writer.losses, options)


def _program(frame: dict[str, Any], parts: list[dict[str, Any]]) -> Iterator[str]:
    head, tail = (part.replace("@CLIP@", javascript_literal(frame)) for part in PROGRAM.split("@PARTS@"))
    yield f"{head}["
    for number, part in enumerate(parts):
        yield f"{',' if number else ''}\n    "
        yield from javascript_pieces(part)
    yield f"\n  ]{tail}"


@dataclass
class _Writer(ShapeWriter):
    """Turns layers into the plain values from which the script builds compositions, and each mask into its text."""

    def parts(self, branch: Branch) -> list[dict[str, Any]]:
        """The layers of a composition, bottom first: solids with masks, and compositions."""
        return [
            self.branch(part.content) if isinstance(part.content, Branch) else self._masks(part.content, part.blend)
            for part in _within_bounds(parts_of(branch, lambda shape: shape.blend in MODES))
        ]

    def branch(self, branch: Branch) -> dict[str, Any]:
        """A composition of its own; an inverted one lies above white and takes from it."""
        branch = dimmed_first(branch)
        if branch.blend is BlendMode.SUBTRACT:  # to multiply by what is left
            branch = replace(branch, invert=not branch.invert)
        inner = self.parts(branch)
        if branch.invert:
            inner = [
                {"name": "Everything", "grey": 1, "masks": [], "blend": "NORMAL", "opacity": 100.0},
                {"name": branch.name, "parts": inner, "blend": "DIFFERENCE", "opacity": 100.0},
            ]
        opacity = self._value(mapped(branch.opacity, lambda share: 100.0 * share))
        return {"name": branch.name, "parts": inner, "blend": LAYER_MODES[branch.blend], "opacity": opacity}

    def _masks(self, shapes: tuple[RotoShape, ...], blend: BlendMode) -> dict[str, Any]:
        """A solid with masks; black where it takes away from what lies under it."""
        grey, mode = 1, None
        if blend in OPAQUE:
            mode = BlendMode.ADD
        elif blend is not BlendMode.ADD:
            # Black that leaves out the shape is an intersection; a mask that subtracts leaves out, above a full layer.
            grey, mode = 0, BlendMode.ADD if blend is BlendMode.SUBTRACT else BlendMode.SUBTRACT
        masks = [self.mask(shape, mode or shape.blend) for shape in shapes]
        name = next((shape.name for shape in shapes if takes_part(shape)), "ROAM")
        # A solid whose masks all have the mode None would be full.
        opacity = 100.0 if any(takes_part(shape) for shape in shapes) else 0.0
        solid = {"name": name, "grey": grey, "masks": masks, "blend": "NORMAL", "opacity": opacity}
        if blend in OPAQUE:
            return {"name": name, "parts": [solid], "blend": LAYER_MODES[blend], "opacity": 100.0}
        return solid

    def mask(self, shape: RotoShape, blend: BlendMode) -> Literal:
        """One mask as text: the numbers of its keys would take several times the room."""
        shape, _ = self.begun_for(shape, Motion.EASED)
        self._note_losses(shape)
        is_feathered, feather = has_feather_curve(shape), beside_zeros(shape.feather)
        mask = {
            "name": shape.name,
            "mode": MODES.get(blend, "ADD") if shape.visible else HIDDEN,
            "closed": shape.closed,
            "inverted": shape.invert,
            "locked": shape.locked,
            "blurred": shape.is_blurred,
            "color": list(shape.colour),
            "feather": self._value(mapped(feather, abs)),
            "expansion": self._value(mapped(feather, lambda width: width / 2.0)),
            "opacity": self._keyed(opacity_keys(shape), shape.opacity, 100.0),
            "keys": [self._key(key, shape.closed, is_feathered) for key in shape.keys],
        }
        return Literal("".join(javascript_pieces(mask)))

    def _value(self, value: Animatable) -> Any:
        return self._keyed(straight_keys(value), value)

    def _keyed(self, keys: tuple[ValueKey, ...], value: Animatable, scale: float = 1.0) -> Any:
        """A number, or keys as frame, number and whether it holds."""
        if not keys:
            return scale * value_at(value, self.clip.first)
        return [[self._frame(key.frame), scale * key.value, key.interpolation is Interpolation.HOLD] for key in keys]

    def _key(self, key: Keyframe, closed: bool, is_feathered: bool) -> Literal:
        anchor = key.points[:, ANCHOR]
        values: dict[str, Any] = {
            "f": self._frame(key.frame),
            "t": key.interpolation.value,
            "v": _rounded(anchor),
            "i": _rounded(key.points[:, IN] - anchor),
            "o": _rounded(key.points[:, OUT] - anchor),
        }
        if is_feathered:
            values["r"] = _rounded(feather_radii(key, closed))
        return Literal(javascript_literal(values))

    def _frame(self, frame: int) -> int:
        return frame - self.clip.first

    def _note_losses(self, shape: RotoShape) -> None:
        if has_feather_curve(shape):
            self.notes.append(
                sentence(
                    "After Effects' feather points lie square to the outline: the feather curve of {name!r} "
                    "keeps its width at each point, not its handles.",
                    name=shape.name,
                )
            )
        if any(values_of(shape.feather)):
            self.notes.append(
                sentence(
                    "The feather of {name!r} becomes a feather and an expansion of half its width, which "
                    "together cover the same ground.",
                    name=shape.name,
                )
            )
        if shape.is_blurred:
            self.notes.append(
                sentence("After Effects' shutter is the composition's: that of {name!r} is left out.", name=shape.name)
            )
        if not shape.visible:
            self.notes.append(
                sentence(
                    "Masks cannot be hidden in After Effects: {name!r} has the mode None instead of {blend}.",
                    name=shape.name,
                    blend=MODE_WORDS[shape.blend],
                )
            )


def _within_bounds(parts: list[Part]) -> list[Part]:
    """The parts with no more masks on a layer than After Effects takes."""
    return [piece for part in parts for piece in _pieces(part)]


def _pieces(part: Part) -> Iterator[Part]:
    if isinstance(part.content, Branch) or len(part.content) <= MOST_MASKS:
        yield part
        return
    yield Part(part.blend, part.content[:MOST_MASKS])
    for shape in part.content[MOST_MASKS:]:
        yield Part(shape.blend if takes_part(shape) else BlendMode.ADD, (shape,))


def _rounded(values: Array) -> Any:
    return (np.round(values, DECIMALS) + 0.0).tolist()
