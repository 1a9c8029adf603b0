"""Fusion and DaVinci Resolve `.setting`: a chain of polygon masks as a Lua table that pastes into the flow.

Positions are measured from the image's centre, x in image widths and y in image heights, y up; handles are relative to
their anchor, L incoming and R outgoing. Each mask is the effect mask of the next: bottom first, as in ROAM.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.interchange.flatten import flattened, opacity_steps, without_holds
from roam_core.interchange.literals import lua_literal
from roam_core.interchange.protocol import STANDARD, ExportOptions, ShapeWriter, without_smooth_keys
from roam_core.roto import BlendMode, Keyframe, Project, RotoShape
from roam_core.roto.file import write_atomically

Array = NDArray[np.float64]

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


class FusionExporter:
    """Writes every shape of a project as a polygon mask, chained in the order of compositing."""

    name = "fusion"
    title = "Fusion / DaVinci Resolve masks"
    suffix = ".setting"

    def export(self, project: Project, path: Path, options: ExportOptions = STANDARD) -> tuple[str, ...]:
        """Write `project` to `path`; what Fusion's masks cannot hold comes back as sentences."""
        text, notes = fusion_setting(project, options)
        options.advance(1.0, f"Writing {path.name}")
        write_atomically(path, text.encode("utf-8"))
        return notes


def fusion_setting(project: Project, options: ExportOptions = STANDARD) -> tuple[str, tuple[str, ...]]:
    """The Lua text with all shapes of `project`, and a sentence for each thing that it cannot hold."""
    clip = project.require_clip()
    flat = flattened(project, "Fusion")
    writer = _Writer(clip, options, len(flat.shapes))
    tools = [line for shape in flat.shapes for line in writer.mask(shape)]
    text = "\n".join(["{", " Tools = ordered() {", *tools, " },", "}", ""])
    return text, (*flat.notes, *writer.notes)


@dataclass
class _Writer(ShapeWriter):
    """Turns shapes into tools; remembers the names that are taken and the mask before."""

    taken: set[str] = field(default_factory=set)
    below: str = ""

    def mask(self, shape: RotoShape) -> list[str]:
        """The lines of a mask tool and of the spline that animates it."""
        shape = without_holds(without_smooth_keys(self.begun(shape)))
        self._note_losses(shape)
        tool = self._tool_name(shape.name)
        place = (self.done - 1) * TOOL_SPACING
        lines = [
            f"  {tool} = PolylineMask {{",
            *([] if shape.visible else ["   PassThrough = true,"]),
            *(["   Locked = true,"] if shape.locked else []),
            "   NameSet = true,",
            "   Inputs = {",
            *(f"    {name} = Input {{ {value}, }}," for name, value in self._inputs(shape, tool)),
            "   },",
            f"   ViewInfo = OperatorInfo {{ Pos = {{ {place}, 0 }} }},",
            "  },",
            *self._path(shape, f"{tool}Polyline"),
            *self._level(shape, f"{tool}Level"),
        ]
        self.below = tool
        return lines

    def _inputs(self, shape: RotoShape, tool: str) -> list[tuple[str, str]]:
        width, height = self.clip.size
        values: list[tuple[str, str]] = []
        if self.below:
            values.append(("EffectMask", f'SourceOp = "{self.below}", Source = "Mask"'))
        values += [
            ("PaintMode", f'Value = FuID {{ "{PAINT_MODES[shape.blend]}" }}'),
            ("Invert", f"Value = {int(shape.invert)}"),
            ("UseFrameFormatSettings", "Value = 0"),
            ("OutputSize", 'Value = FuID { "Custom" }'),
            ("MaskWidth", f"Value = {width}"),
            ("MaskHeight", f"Value = {height}"),
            ("PixelAspect", f"Value = {{ {self.clip.pixel_aspect:g}, 1 }}"),
            ("ClippingMode", 'Value = FuID { "None" }'),
        ]
        feather = shape.feather_at(self.clip.first)
        if feather:
            values.append(("SoftEdge", f"Value = {_decimal(abs(feather) / width)}"))
            values.append(("BorderWidth", f"Value = {_decimal(feather / 2.0 / width)}"))
        if shape.lifetime is not None:
            values.append(("Level", f'SourceOp = "{tool}Level", Source = "Value"'))
        elif shape.opacity != 1.0:
            values.append(("Level", f"Value = {_decimal(shape.opacity_at(self.clip.first))}"))
        return [*values, *_motion_blur(shape), *self._ends(shape, tool)]

    def _ends(self, shape: RotoShape, tool: str) -> list[tuple[str, str]]:
        return [
            ("Comments", f"Value = {lua_literal(shape.name)}"),
            ("Polyline", f'SourceOp = "{tool}Polyline", Source = "Value"'),
            ("Polyline2", "Value = Polyline { }, Disabled = true"),
        ]

    def _path(self, shape: RotoShape, spline: str) -> list[str]:
        red, green, blue = (round(255.0 * share) for share in shape.colour)
        lines = [
            f"  {spline} = BezierSpline {{",
            f"   SplineColor = {{ Red = {red}, Green = {green}, Blue = {blue} }},",
            "   NameSet = true,",
            "   KeyFrames = {",
        ]
        for index, key in enumerate(shape.keys):
            lines += [
                f"    [{self._frame(key.frame)}] = {{ {index}, Flags = {{ Linear = true, LockedY = true }}, "
                "Value = Polyline {",
                *(["      Closed = true,"] if shape.closed else []),
                "      Points = {",
                *(f"       {{ {point} }}," for point in self._points(key)),
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

    def _level(self, shape: RotoShape, spline: str) -> list[str]:
        """The opacity of a shape with a lifetime: straight from value to value on neighbouring frames."""
        steps = opacity_steps(shape)
        if not steps:
            return []
        keys = dict(steps) | {frame - 1: value for (frame, _), (_, value) in zip(steps[1:], steps, strict=False)}
        lines = [f"  {spline} = BezierSpline {{", "   NameSet = true,", "   KeyFrames = {"]
        for frame in sorted(keys):
            lines.append(f"    [{self._frame(frame)}] = {{ {_decimal(keys[frame])}, Flags = {{ Linear = true }} }},")
        return [*lines, "   },", "  },"]

    def _frame(self, frame: int) -> int:
        return frame + self.options.frame_offset

    def _note_losses(self, shape: RotoShape) -> None:
        if any(key.feather is not None and key.feather.any() for key in shape.keys):
            self.notes.append(f"The feather curve of {shape.name!r} was left out: Fusion's masks have one soft edge.")
        if shape.feather:
            self.notes.append(
                f"Fusion softens on both sides of an outline: {shape.name!r} may look a little different."
            )
        if shape.blend is not BlendMode.ADD and not self.below:
            self.notes.append(f"{shape.name!r} lies lowest, where Fusion may not {shape.blend.value} as ROAM does.")

    def _tool_name(self, name: str) -> str:
        """An identifier for a tool, as near to the shape's name as Fusion allows, and free."""
        stem = re.sub(r"[^A-Za-z0-9_]+", "_", name)[:LONGEST_TOOL].strip("_")
        if not stem or stem[0].isdigit() or stem.lower() in LUA_WORDS:
            stem = f"Shape_{stem}".rstrip("_")
        free, number = stem, 1
        while not self.taken.isdisjoint(names := {free, f"{free}Polyline", f"{free}Level"}):
            number += 1
            free = f"{stem}_{number}"
        self.taken |= names
        return free


def _motion_blur(shape: RotoShape) -> list[tuple[str, str]]:
    """Fusion's shutter in degrees, its centre in half shutters from the frame."""
    blur = shape.motion_blur
    if blur is None:
        return []
    bias = 0.0 if blur.shutter == 0.0 else (blur.phase + blur.shutter / 2.0) / (blur.shutter / 2.0)
    values = (("MotionBlur", 1.0), ("Quality", blur.samples), ("ShutterAngle", 360.0 * blur.shutter))
    return [(name, f"Value = {_decimal(value)}") for name, value in (*values, ("CenterBias", bias))]


def _decimal(value: float) -> str:
    """Ten decimals without trailing zeros: a millionth of a pixel at any size, and no exponent."""
    return f"{value:.10f}".rstrip("0").rstrip(".") if round(value, 10) else "0"
