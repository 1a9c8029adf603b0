"""Blender `.py`: a script for Blender's text editor that builds a mask, one mask layer for each shape.

Mask space puts the image's centre at (0.5, 0.5), y up, and the longer side of the image as it is shown (its pixels may
be wide) has the length 1; handles are absolute and the feather of a point is a weight in the same unit. All of it was
measured by rendering with Blender itself.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.interchange.after_effects import feather_radii
from roam_core.interchange.flatten import flattened, opacity_steps, without_holds
from roam_core.interchange.literals import python_literal, whole
from roam_core.interchange.protocol import STANDARD, ExportOptions, ShapeWriter, without_smooth_keys
from roam_core.roto import BlendMode, Clip, Keyframe, Project, RotoShape
from roam_core.roto.file import write_atomically

Array = NDArray[np.float64]

BLENDS = {
    BlendMode.ADD: "MERGE_ADD",
    BlendMode.PLUS: "ADD",
    BlendMode.SUBTRACT: "MERGE_SUBTRACT",
    BlendMode.INTERSECT: "MUL",
    BlendMode.DIFFERENCE: "DIFFERENCE",
    BlendMode.MAX: "LIGHTEN",
}
LONGEST_NAME = 63
"""Bytes of a name in Blender."""

DECIMALS = 9


class BlenderExporter:
    """Writes a script that builds a mask with a layer for every shape of a project."""

    name = "blender"
    title = "Blender mask (script)"
    suffix = ".py"

    def export(self, project: Project, path: Path, options: ExportOptions = STANDARD) -> tuple[str, ...]:
        """Write `project` to `path`; what Blender's masks cannot hold comes back as sentences."""
        text, notes = blender_script(project, options)
        options.advance(1.0, f"Writing {path.name}")
        write_atomically(path, text.encode("ascii"))
        return notes


def blender_script(project: Project, options: ExportOptions = STANDARD) -> tuple[str, tuple[str, ...]]:
    """The script for all shapes of `project`, and a sentence for each thing that a mask cannot hold."""
    clip = project.require_clip()
    flat = flattened(project, "Blender")
    writer = _Writer(clip, options, len(flat.shapes))
    layers = [writer.layer(shape) for shape in flat.shapes]
    frames = [frame + options.frame_offset for frame in (clip.first, clip.last)]
    text = PROGRAM.replace("@FRAMES@", str(frames)).replace("@LAYERS@", python_literal(layers))
    return text, (*flat.notes, *writer.notes)


def mask_space(points: Array, clip: Clip) -> Array:
    """Positions `(..., 2)` in pixels as Blender measures them: the longer side of the shown image is 1, y up."""
    shown = np.array([clip.pixel_aspect, 1.0])
    size = np.array(clip.size) * shown
    result: Array = 0.5 + (points * shown - size / 2.0) / size.max() * np.array([1.0, -1.0])
    return result


@dataclass
class _Writer(ShapeWriter):
    """Turns shapes into the plain values from which the script builds mask layers."""

    def layer(self, shape: RotoShape) -> dict[str, Any]:
        shape = without_holds(without_smooth_keys(self.begun(shape)))
        self._note_losses(shape)
        return {
            "name": whole(shape.name),
            "blend": BLENDS[shape.blend],
            "invert": shape.invert,
            "hidden": not shape.visible,
            "locked": shape.locked,
            "closed": shape.closed,
            "alpha": shape.opacity_at(self.clip.first),
            "steps": [[self._frame(frame), value] for frame, value in opacity_steps(shape)],
            "keys": [[self._frame(key.frame), self._rows(key, shape)] for key in shape.keys],
        }

    def _rows(self, key: Keyframe, shape: RotoShape) -> list[list[float]]:
        """Each point as x, y, left x, left y, right x, right y and weight."""
        places = mask_space(key.points[:, [ANCHOR, IN, OUT]], self.clip).reshape(-1, 6)
        widths = np.maximum(np.maximum(feather_radii(key, shape.closed), shape.feather_at(self.clip.first)), 0.0)
        width, height = self.clip.size
        weights = np.minimum(widths / max(width * self.clip.pixel_aspect, height), 1.0)
        rows: list[list[float]] = np.round(np.column_stack([places, weights]), DECIMALS).tolist()
        return rows

    def _frame(self, frame: int) -> int:
        return frame + self.options.frame_offset

    def _note_losses(self, shape: RotoShape) -> None:
        if any(key.feather is not None and key.feather.any() for key in shape.keys):
            self.notes.append(
                f"Blender's feather lies square to the outline: the feather curve of {shape.name!r} keeps its width at "
                "each point, not its handles."
            )
        if shape.feather_at(self.clip.first) < 0.0 or any(
            (feather_radii(key, shape.closed) < 0.0).any() for key in shape.keys
        ):
            self.notes.append(f"Blender feathers outwards only: the inner feather of {shape.name!r} was left out.")
        if shape.invert and shape.opacity != 1.0:
            self.notes.append(f"Blender inverts after the opacity: {shape.name!r} is white outside there, not grey.")
        if shape.motion_blur is not None:
            self.notes.append(f"Blender blurs masks in its compositor: the shutter of {shape.name!r} was left out.")
        if shape.lifetime is not None and shape.blend is BlendMode.INTERSECT:
            self.notes.append(f"Outside its lifetime {shape.name!r} leaves nothing of what lies under it in Blender.")
        if len(shape.name.encode("utf-8", "replace")) > LONGEST_NAME:
            self.notes.append(f"Blender cuts names after {LONGEST_NAME} bytes: {shape.name[:20]!r}... is one.")


PROGRAM = """\
# Masks from ROAM. In Blender: open this in the text editor and run it; then pick the mask "ROAM" in an image editor in
# mask mode, or in the compositor's Mask node with "Scene Size".
import json

import bpy

FRAMES = @FRAMES@
LAYERS = json.loads(@LAYERS@)


def new_layer(mask, data):
    layer = mask.layers.new()
    layer.name = data["name"]
    layer.blend = data["blend"]
    layer.invert = data["invert"]
    layer.falloff = "LINEAR"
    layer.use_fill_overlap = True
    layer.hide = layer.hide_render = data["hidden"]
    spline = layer.splines.new()
    spline.use_cyclic = data["closed"]
    spline.use_fill = data["closed"]
    spline.offset_mode = "EVEN"
    spline.weight_interpolation = "LINEAR"
    spline.points.add(len(data["keys"][0][1]) - 1)
    for point in spline.points:
        point.handle_left_type = point.handle_right_type = "FREE"
        point.select = True
    return layer


def place(layer, rows):
    for point, row in zip(layer.splines[0].points, rows):
        point.co, point.handle_left, point.handle_right = row[0:2], row[2:4], row[4:6]
        point.weight = row[6]


def fade(layer, data):
    layer.alpha = data["alpha"]
    for (frame, value), (stop, _) in zip(data["steps"], data["steps"][1:] + [[None, None]]):
        for moment in {frame, frame if stop is None else stop - 1}:
            layer.alpha = value
            layer.keyframe_insert("alpha", frame=moment)


def insert_keys(mask, layers):
    # Shape keys are made by an operator alone, which wants an image editor in mask mode, and which acts on every layer
    # that is not locked.
    area = bpy.context.window_manager.windows[0].screen.areas[0]
    before = area.type
    area.type = "IMAGE_EDITOR"
    space = area.spaces.active
    space.mode, space.mask = "MASK", mask
    region = [region for region in area.regions if region.type == "WINDOW"][0]
    window = bpy.context.window_manager.windows[0]
    try:
        with bpy.context.temp_override(window=window, area=area, region=region, space_data=space):
            for layer, data in zip(layers, LAYERS):
                for other in layers:
                    other.hide_select = other != layer
                    other.hide = other != layer
                for frame, rows in data["keys"]:
                    bpy.context.scene.frame_set(frame)
                    place(layer, rows)
                    bpy.ops.mask.shape_key_insert()
    finally:
        space.mask = None
        area.type = before
    for layer, data in zip(layers, LAYERS):
        layer.hide, layer.hide_select = data["hidden"], data["locked"]


current = bpy.context.scene.frame_current
mask = bpy.data.masks.new("ROAM")
mask.frame_start, mask.frame_end = FRAMES
layers = [new_layer(mask, data) for data in LAYERS]
insert_keys(mask, layers)
for layer, data in zip(layers, LAYERS):
    fade(layer, data)
bpy.context.scene.frame_set(current)
"""
