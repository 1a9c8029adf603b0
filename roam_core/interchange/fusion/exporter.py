"""Fusion and DaVinci Resolve `.setting`: a chain of polygon masks as a Lua table that pastes into the flow.

Positions are measured from the image's centre, x in image widths and y in image heights, y up; handles are relative to
their anchor, L incoming and R outgoing. Each mask is the effect mask of the next: bottom first, as in ROAM. A layer
that acts as one is a chain of its own; a Background that is cut out by it is a picture, of which a bitmap mask makes
one mask of the chain. What never shows, hidden and open shapes, stands beside the chains.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.interchange.flatten import (
    Branch,
    branched,
    everything,
    has_feather_curve,
    hidden_notes,
    takes_part,
)
from roam_core.interchange.literals import lua_literal
from roam_core.interchange.protocol import STANDARD, ExportOptions, ShapeWriter, readied, settled, without_smooth_keys
from roam_core.interchange.text_exporter import TextExporter
from roam_core.interchange.timing import (
    beside_zeros,
    forwards,
    moments,
    opacity_keys,
    smooth_notes,
    straight_keys,
    tangent_notes,
    value_moments,
)
from roam_core.roto import BlendMode, Keyframe, Project, RotoShape
from roam_core.roto.animated import Animatable, ValueKey, mapped, value_at, values_of
from roam_core.translatable import N_, sentence

PAINT_MODES = {
    BlendMode.ADD: "Merge",
    BlendMode.PLUS: "Add",
    BlendMode.SUBTRACT: "Subtract",
    BlendMode.INTERSECT: "Multiply",
    BlendMode.DIFFERENCE: "Invert",
    BlendMode.MAX: "Maximum",
}
LUA_WORDS = frozenset(
    {"and", "break", "do", "else", "elseif", "end", "false", "for", "function", "goto", "if", "in", "local", "nil"}
    | {"not", "or", "ordered", "repeat", "return", "then", "true", "until", "while"}
)
LONGEST_TOOL = 60
TOOL_SPACING = 110
"""Units of the flow from one tool to the next."""

DEEPER = 99
"""Units of the flow from a chain to the branches that join it."""

FLOAT = 4
"""The depth of a Background that is 32 bit float."""

CLIPPING = ("ClippingMode", 'Value = FuID { "None" }')


class FusionExporter(TextExporter):
    """Writes every shape of a project as a polygon mask, chained in the order of compositing."""

    name = "fusion"
    title = N_("Fusion / DaVinci Resolve masks")
    suffix = ".setting"
    encoding = "utf-8"

    def document(self, project: Project, options: ExportOptions) -> tuple[str, tuple[str, ...]]:
        """The text; what Fusion's masks cannot hold is told."""
        return fusion_setting(project, options)


def fusion_setting(project: Project, options: ExportOptions = STANDARD) -> tuple[str, tuple[str, ...]]:
    """The Lua text with all shapes of `project`, and a sentence for each thing that it cannot hold."""
    clip = project.require_clip()
    root = branched(readied(project, options), timed_intersect=False)
    writer = _Writer(clip, options, max(len(list(root.shapes())), 1))
    if root.opacity == 1.0 and not root.invert:
        writer.chain(root)
    else:
        writer.chain(Branch("Root", (root,)))
    text = "\n".join(["{", " Tools = ordered() {", *writer.lines, " },", "}", ""])
    return text, settled(
        [*hidden_notes(project, root), *tangent_notes(project.root), *smooth_notes(project.root), *writer.notes],
        writer.losses,
        options,
    )


@dataclass
class _Writer(ShapeWriter):
    """Turns shapes into tools, and remembers the names that are taken.

    Attributes
    ----------
    lines : of all tools so far.
    images : tools that make a picture of a mask, by the mask's name.
    depth : of the chain that is being written.
    """

    taken: set[str] = field(default_factory=set)
    lines: list[str] = field(default_factory=list)
    images: dict[str, str] = field(default_factory=dict)
    depth: int = 0
    tools: int = 0

    def chain(self, branch: Branch) -> str:
        """Write the masks of a branch, each joined with the one before; the name of the last, "" where none shows."""
        below, is_grey = "", False
        for item in branch.items:
            if not takes_part(item):
                assert isinstance(item, RotoShape)
                self._mask(item, "", PAINT_MODES[item.blend])
                continue
            is_grey = is_grey or has_grey(item)
            below = self._branch(item, below) if isinstance(item, Branch) else self._shape(item, below, is_grey)
        return below

    def _branch(self, branch: Branch, below: str) -> str:
        """A chain of its own, joined as one mask."""
        self.depth += 1
        source = self.chain(branch)
        if not source:
            source = self._mask(everything(branch.name, self.clip.size, self.clip.first), "", "Merge")
            branch = replace(branch, invert=not branch.invert)
        self.depth -= 1
        keys = straight_keys(branch.opacity)
        if branch.blend is BlendMode.ADD and not (branch.invert and branch.opacity != 1.0):
            return self._bitmap(branch.name, source, below, "Merge", branch.invert, branch.opacity, keys)
        # In which order a mask inverts and dims is not known.
        if branch.invert:
            source = self._bitmap(branch.name, source, "", "Merge", invert=True)
        if branch.opacity != 1.0:
            source = self._bitmap(branch.name, source, "", "Merge", False, branch.opacity, keys)
        return self._joined(branch.name, source, below, branch.blend)

    def _shape(self, shape: RotoShape, below: str, is_grey: bool) -> str:
        """A mask that is joined with the chain below it; several tools where one mode would not show the same.

        `is_grey` says whether the mask or the chain has grey beside that of hard edges.
        """
        is_dimmed = shape.opacity != 1.0 or shape.lifetime is not None
        if shape.invert and is_dimmed:
            alone = self._mask(replace(shape, opacity=1.0, lifetime=None), "", "Merge")
            alone = self._bitmap(shape.name, alone, "", "Merge", False, shape.opacity, opacity_keys(shape))
            return self._joined(shape.name, alone, below, shape.blend)
        if shape.blend is BlendMode.SUBTRACT and is_grey and not is_dimmed:
            return self._mask(replace(shape, invert=not shape.invert), below, "Multiply")
        if shape.blend in (BlendMode.SUBTRACT, BlendMode.DIFFERENCE) and is_grey:
            return self._joined(shape.name, self._mask(shape, "", "Merge"), below, shape.blend)
        return self._mask(shape, below, PAINT_MODES[shape.blend])

    def _joined(self, name: str, alone: str, below: str, blend: BlendMode) -> str:
        """A mask that stands alone, joined with a chain; exactly, where the two are grey as well."""
        if blend is BlendMode.SUBTRACT:  # Subtract takes grey from grey, ours multiplies by what is left
            return self._bitmap(name, alone, below, "Multiply", invert=True)
        if blend is BlendMode.DIFFERENCE:  # 1 - ((1 - greater) + lesser); Invert is no difference of greys
            greater, lesser = (self._bitmap(name, alone, below, mode) for mode in ("Maximum", "Minimum"))
            inverse = self._bitmap(name, greater, lesser, "Add", invert=True)
            return self._bitmap(name, inverse, "", "Merge", invert=True)
        return self._bitmap(name, alone, below, PAINT_MODES[blend])

    def _mask(self, shape: RotoShape, below: str, mode: str) -> str:
        """A polygon mask and the splines that animate it; its name."""
        shape = without_smooth_keys(self.begun(shape))
        self._note_losses(shape)
        tool = self._tool_name(shape.name)
        values = [*self._joint(below, mode, shape.invert), *self._frame_format("MaskWidth", "MaskHeight"), CLIPPING]
        splines = self._keyed(values, tool, "Level", shape.opacity, opacity_keys(shape), 1.0)
        width, soft = self.clip.size[0], beside_zeros(shape.feather)
        for name, feather in (
            ("SoftEdge", mapped(soft, lambda wide: abs(wide) / width)),
            ("BorderWidth", mapped(soft, lambda wide: wide / 2.0 / width)),
        ):
            splines += self._keyed(values, tool, name, feather, straight_keys(feather), 0.0)
        values += [
            *_motion_blur(shape),
            ("Comments", f"Value = {lua_literal(shape.name)}"),
            ("Polyline", f'SourceOp = "{tool}Polyline", Source = "Value"'),
            ("Polyline2", "Value = Polyline { }, Disabled = true"),
        ]
        self._write(tool, "PolylineMask", values, shape)
        self.lines += [*self._path(shape, f"{tool}Polyline"), *splines]
        return tool

    def _bitmap(
        self,
        name: str,
        source: str,
        below: str,
        mode: str,
        invert: bool = False,
        level: Animatable = 1.0,
        keys: Sequence[ValueKey] = (),
    ) -> str:
        """A mask made of another one, by a picture of it; its name."""
        image = self.images.get(source)
        if image is None:
            image = self.images[source] = self._tool_name(f"{source}Image")
            white = [(f"TopLeft{part}", "Value = 1") for part in ("Red", "Green", "Blue", "Alpha")]
            values = [*self._frame_format("Width", "Height"), ("Depth", f"Value = {FLOAT}"), *white]
            self._write(image, "Background", [*values, ("EffectMask", f'SourceOp = "{source}", Source = "Mask"')])
        tool = self._tool_name(f"{name} joined")
        values = [
            *self._joint(below, mode, invert),
            *self._frame_format("MaskWidth", "MaskHeight"),
            CLIPPING,
            ("Image", f'SourceOp = "{image}", Source = "Output"'),
            ("Channel", 'Value = FuID { "Alpha" }'),
        ]
        splines = self._keyed(values, tool, "Level", level, keys, 1.0)
        self._write(tool, "BitmapMask", [*values, ("Comments", f"Value = {lua_literal(name)}")])
        self.lines += splines
        return tool

    def _write(self, tool: str, kind: str, values: list[tuple[str, str]], shape: RotoShape | None = None) -> None:
        place, self.tools = self.tools * TOOL_SPACING, self.tools + 1
        self.lines += [
            f"  {tool} = {kind} {{",
            *(["   PassThrough = true,"] if shape is not None and not shape.visible else []),
            *(["   Locked = true,"] if shape is not None and shape.locked else []),
            "   NameSet = true,",
            "   Inputs = {",
            *(f"    {name} = Input {{ {value}, }}," for name, value in values),
            "   },",
            f"   ViewInfo = OperatorInfo {{ Pos = {{ {place}, {-DEEPER * self.depth} }} }},",
            "  },",
        ]

    def _joint(self, below: str, mode: str, invert: bool) -> list[tuple[str, str]]:
        """How a mask joins the one below it."""
        effect = [("EffectMask", f'SourceOp = "{below}", Source = "Mask"')] if below else []
        return [*effect, ("PaintMode", f'Value = FuID {{ "{mode}" }}'), ("Invert", f"Value = {int(invert)}")]

    def _frame_format(self, width: str, height: str) -> list[tuple[str, str]]:
        return [
            ("UseFrameFormatSettings", "Value = 0"),
            (width, f"Value = {self.clip.size[0]}"),
            (height, f"Value = {self.clip.size[1]}"),
            ("PixelAspect", f"Value = {{ {self.clip.pixel_aspect:g}, 1 }}"),
        ]

    def _keyed(
        self,
        values: list[tuple[str, str]],
        tool: str,
        name: str,
        value: Animatable,
        keys: Sequence[ValueKey],
        standard: float,
    ) -> list[str]:
        """Add an input that is not `standard` to `values`; the lines of its spline where it has keys."""
        if not keys:
            number = value_at(value, self.clip.first)
            if number != standard:
                values.append((name, f"Value = {_decimal(number)}"))
            return []
        values.append((name, f'SourceOp = "{tool}{name}", Source = "Value"'))
        lines = [f"  {tool}{name} = BezierSpline {{", "   NameSet = true,", "   KeyFrames = {"]
        for time, number in value_moments(keys, self.options.frame_offset):
            lines.append(f"    [{_decimal(time)}] = {{ {_decimal(number)}, Flags = {{ Linear = true }} }},")
        return [*lines, "   },", "  },"]

    def _path(self, shape: RotoShape, spline: str) -> list[str]:
        red, green, blue = (round(255.0 * share) for share in shape.colour)
        lines = [
            f"  {spline} = BezierSpline {{",
            f"   SplineColor = {{ Red = {red}, Green = {green}, Blue = {blue} }},",
            "   NameSet = true,",
            "   KeyFrames = {",
        ]
        for index, moment in enumerate(moments(shape, self.options.frame_offset)):
            lines += [
                f"    [{_decimal(moment.time)}] = {{ {index}, Flags = {{ Linear = true, LockedY = true }}, "
                "Value = Polyline {",
                *(["      Closed = true,"] if shape.closed else []),
                "      Points = {",
                *(f"       {{ {point} }}," for point in self._points(moment.key)),
                "      },",
                "    } },",
            ]
        return [*lines, "   },", "  },"]

    def _points(self, key: Keyframe) -> list[str]:
        width, height = self.clip.size
        anchor = key.points[:, ANCHOR]
        scale = np.array([1.0 / width, -1.0 / height])
        centre = (anchor - np.array([width, height]) / 2.0) * scale
        incoming, outgoing = ((key.points[:, part] - anchor) * scale for part in (IN, OUT))
        names = ("X", "Y", "LX", "LY", "RX", "RY")
        rows = np.concatenate([centre, incoming, outgoing], axis=1).tolist()
        return [", ".join(f"{name} = {_decimal(v)}" for name, v in zip(names, row, strict=True)) for row in rows]

    def _note_losses(self, shape: RotoShape) -> None:
        if has_feather_curve(shape):
            lost = self.losses if takes_part(shape) else self.notes
            lost.append(
                sentence(
                    "The feather curve of {name!r} is lost: Fusion's masks have one soft edge all around.",
                    name=shape.name,
                )
            )
        if any(values_of(shape.feather)):
            self.notes.append(
                sentence(
                    "Fusion softens on both sides of an outline: {name!r} may look a little different.", name=shape.name
                )
            )

    def _tool_name(self, name: str) -> str:
        """An identifier for a tool, as near to the shape's name as Fusion allows, and free."""
        stem = re.sub(r"[^A-Za-z0-9_]+", "_", name)[:LONGEST_TOOL].strip("_")
        if not stem or stem[0].isdigit() or stem.lower() in LUA_WORDS:
            stem = f"Shape_{stem}".rstrip("_")
        free, number = stem, 1
        parts = ("", "Polyline", "Level", "SoftEdge", "BorderWidth")
        while not self.taken.isdisjoint(names := {f"{free}{part}" for part in parts}):
            number += 1
            free = f"{stem}_{number}"
        self.taken |= names
        return free


def has_grey(item: RotoShape | Branch) -> bool:
    """True for what is neither black nor white, beside the pixels of hard edges."""
    if isinstance(item, Branch):
        return item.opacity != 1.0 or any(has_grey(inner) for inner in item.items if takes_part(inner))
    return item.opacity != 1.0 or any(values_of(item.feather)) or item.is_blurred


def _motion_blur(shape: RotoShape) -> list[tuple[str, str]]:
    """Fusion's shutter in degrees, its centre in half shutters from the frame."""
    blur = shape.motion_blur
    if blur is None or not blur.is_seen:
        return []
    blur = forwards(blur)
    bias = (blur.phase + blur.shutter / 2.0) / (blur.shutter / 2.0)
    values = (("MotionBlur", 1.0), ("Quality", blur.samples), ("ShutterAngle", 360.0 * blur.shutter))
    return [(name, f"Value = {_decimal(value)}") for name, value in (*values, ("CenterBias", bias))]


def _decimal(value: float) -> str:
    """Ten decimals without trailing zeros: a millionth of a pixel at any size, and no exponent."""
    return f"{value:.10f}".rstrip("0").rstrip(".") if round(value, 10) else "0"
