"""After Effects `.jsx`: a script that puts every shape as a mask on the selected layer, or on a new solid.

Positions are pixels of the layer from its top-left corner, y down; handles are relative to their vertex; times are
seconds. The script is plain ASCII and old JavaScript (ECMAScript 3), and every name in it is a quoted string.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.interchange.flatten import flattened, opacity_steps
from roam_core.interchange.literals import javascript_literal
from roam_core.interchange.protocol import STANDARD, ExportOptions, ShapeWriter
from roam_core.roto import BlendMode, Keyframe, Project, RotoShape
from roam_core.roto.file import write_atomically

Array = NDArray[np.float64]

MODES = {
    BlendMode.ADD: "ADD",
    BlendMode.PLUS: "ADD",
    BlendMode.SUBTRACT: "SUBTRACT",
    BlendMode.INTERSECT: "INTERSECT",
    BlendMode.DIFFERENCE: "DIFFERENCE",
    BlendMode.MAX: "LIGHTEN",
}
HIDDEN = "NONE"
"""The mode of a mask that takes no part: After Effects knows no other way to hide one."""

DECIMALS = 6
MOST_MASKS = 127
"""On one layer."""

OUTER, INNER = 0, 1
"""Directions of After Effects' feather points."""


class AfterEffectsExporter:
    """Writes a script that builds a mask for every shape of a project."""

    name = "after-effects"
    title = "After Effects masks (script)"
    suffix = ".jsx"

    def export(self, project: Project, path: Path, options: ExportOptions = STANDARD) -> tuple[str, ...]:
        """Write `project` to `path`; what After Effects' masks cannot hold comes back as sentences."""
        text, notes = mask_script(project, options)
        options.advance(1.0, f"Writing {path.name}")
        write_atomically(path, text.encode("ascii"))
        return notes


def mask_script(project: Project, options: ExportOptions = STANDARD) -> tuple[str, tuple[str, ...]]:
    """The script for all shapes of `project`, and a sentence for each thing that it cannot hold.

    Frame f of the plate lies (f + offset - first frame) / fps seconds after the start of the layer.
    """
    clip = project.require_clip()
    flat = flattened(project, "After Effects")
    writer = _Writer(clip, options, len(flat.shapes))
    masks = [writer.mask(shape) for shape in flat.shapes]
    frame = {
        "width": clip.size[0],
        "height": clip.size[1],
        "aspect": clip.pixel_aspect,
        "fps": clip.fps,
        "first": clip.first,
        "last": clip.last,
    }
    lines = ",\n".join(f"    {javascript_literal(mask)}" for mask in masks)
    text = PROGRAM.replace("@CLIP@", javascript_literal(frame)).replace(
        "@MASKS@", f"[\n{lines}\n  ]" if masks else "[]"
    )
    if len(masks) > MOST_MASKS:
        writer.notes.append(
            f"After Effects takes {MOST_MASKS} masks on a layer: export fewer shapes than {len(masks)}."
        )
    return text, (*flat.notes, *writer.notes)


@dataclass
class _Writer(ShapeWriter):
    """Turns shapes into the plain values from which the script builds masks."""

    has_begun: bool = False

    def mask(self, shape: RotoShape) -> dict[str, Any]:
        shape = self.begun(shape)
        self._note_losses(shape)
        is_feathered = any(key.feather is not None and key.feather.any() for key in shape.keys)
        return {
            "name": shape.name,
            "mode": MODES[shape.blend] if shape.visible else HIDDEN,
            "closed": shape.closed,
            "inverted": shape.invert,
            "locked": shape.locked,
            "blurred": shape.motion_blur is not None,
            "color": list(shape.colour),
            "feather": abs(shape.feather_at(self.clip.first)),
            "expansion": shape.feather_at(self.clip.first) / 2.0,
            "opacity": 100.0 * shape.opacity_at(self.clip.first),
            "steps": [[self._frame(frame), 100.0 * value] for frame, value in opacity_steps(shape)],
            "keys": [self._key(key, shape.closed, is_feathered) for key in shape.keys],
        }

    def _key(self, key: Keyframe, closed: bool, is_feathered: bool) -> dict[str, Any]:
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
        return values

    def _frame(self, frame: int) -> int:
        return frame + self.options.frame_offset - self.clip.first

    def _note_losses(self, shape: RotoShape) -> None:
        if any(key.feather is not None and key.feather.any() for key in shape.keys):
            self.notes.append(
                f"After Effects' feather points lie square to the outline: the feather curve of {shape.name!r} keeps "
                "its width at each point, not its handles."
            )
        if shape.feather:
            self.notes.append(
                f"The feather of {shape.name!r} became a feather and an expansion of half its width, which together "
                "cover the same ground."
            )
        if shape.motion_blur is not None:
            self.notes.append(f"After Effects' shutter is the composition's: that of {shape.name!r} was left out.")
        if not shape.visible:
            self.notes.append(
                f"Masks cannot be hidden in After Effects: {shape.name!r} has the mode None instead of {shape.blend}."
            )
        elif not self.has_begun and shape.blend is not BlendMode.ADD:
            self.notes.append(
                f"{shape.name!r} lies lowest; After Effects begins with a full layer there, ROAM with none."
            )
        self.has_begun |= shape.visible


def feather_radii(key: Keyframe, closed: bool) -> Array:
    """How far the feather curve lies from each anchor `(P,)`, pixels: outside of the outline positive.

    The outside is told by the polygon of the anchors; on an open path it is the right-hand side on the screen.
    """
    if key.feather is None:
        return np.zeros(len(key.points))
    anchor, offset = key.points[:, ANCHOR], key.feather[:, ANCHOR]
    ahead, behind = np.roll(anchor, -1, axis=0), np.roll(anchor, 1, axis=0)
    if not closed:
        ahead[-1], behind[0] = anchor[-1], anchor[0]
    along = ahead - behind
    area = float((anchor[:, 0] * ahead[:, 1] - ahead[:, 0] * anchor[:, 1]).sum())
    side = along[:, 1] * offset[:, 0] - along[:, 0] * offset[:, 1]
    if closed and area < 0.0:
        side = -side
    lengths: Array = np.hypot(offset[:, 0], offset[:, 1])
    return np.where(side < 0.0, -lengths, lengths)


def _rounded(values: Array) -> Any:
    return (np.round(values, DECIMALS) + 0.0).tolist()


PROGRAM = """\
// Masks from ROAM. In After Effects: File > Scripts > Run Script File.
// With one layer selected the masks go onto it, scaled to its size; otherwise onto a new solid.
(function () {
  var clip = @CLIP@;
  var masks = @MASKS@;

  function composition() {
    var item = app.project.activeItem;
    if (item && item instanceof CompItem) { return item; }
    var seconds = (clip.last - clip.first + 1) / clip.fps;
    item = app.project.items.addComp("ROAM", clip.width, clip.height, clip.aspect, seconds, clip.fps);
    item.openInViewer();
    return item;
  }

  function target(comp) {
    var picked = comp.selectedLayers;
    if (picked.length === 1 && picked[0].property("ADBE Mask Parade")) { return picked[0]; }
    return comp.layers.addSolid([1, 1, 1], "ROAM", clip.width, clip.height, clip.aspect, comp.duration);
  }

  function scaled(pairs, x, y) {
    var result = [];
    for (var i = 0; i < pairs.length; i++) { result.push([pairs[i][0] * x, pairs[i][1] * y]); }
    return result;
  }

  function outline(key, closed, x, y) {
    var shape = new Shape(), count = key.v.length, mean = Math.sqrt(x * y);
    shape.vertices = scaled(key.v, x, y);
    shape.inTangents = scaled(key.i, x, y);
    shape.outTangents = scaled(key.o, x, y);
    shape.closed = closed;
    if (key.r) {
      var segments = [], places = [], radii = [], types = [], zeros = [];
      for (var i = 0; i < count; i++) {
        var isLast = !closed && i === count - 1 && count > 1;
        segments.push(isLast ? i - 1 : i);
        places.push(isLast ? 1 : 0);
        radii.push(key.r[i] * mean);
        types.push(key.r[i] < 0 ? 1 : 0);
        zeros.push(0);
      }
      shape.featherSegLocs = segments;
      shape.featherRelSegLocs = places;
      shape.featherRadii = radii;
      shape.featherTypes = types;
      shape.featherInterps = zeros;
      shape.featherTensions = zeros;
      shape.featherRelCornerAngles = zeros;
    }
    return shape;
  }

  function moves(path, keys) {
    var kinds = {
      "linear": KeyframeInterpolationType.LINEAR,
      "hold": KeyframeInterpolationType.HOLD,
      "smooth": KeyframeInterpolationType.BEZIER
    };
    for (var i = 0; i < keys.length; i++) {
      var before = i === 0 ? "linear" : keys[i - 1].t;
      if (before === "hold") { before = "linear"; }
      if (before === "smooth" || keys[i].t === "smooth") {
        var ease = [new KeyframeEase(0, 100 / 3)];
        path.setTemporalEaseAtKey(i + 1, ease, ease);
      }
      path.setInterpolationTypeAtKey(i + 1, kinds[before], kinds[keys[i].t]);
    }
  }

  function show(mask, data, start) {
    var opacity = mask.property("ADBE Mask Opacity");
    if (data.steps.length === 0) { opacity.setValue(data.opacity); return; }
    for (var i = 0; i < data.steps.length; i++) {
      opacity.setValueAtTime(start + data.steps[i][0] / clip.fps, data.steps[i][1]);
    }
    for (i = 0; i < data.steps.length; i++) {
      opacity.setInterpolationTypeAtKey(i + 1, KeyframeInterpolationType.HOLD, KeyframeInterpolationType.HOLD);
    }
  }

  function add(layer, data) {
    var x = layer.width / clip.width, y = layer.height / clip.height, times = [], shapes = [];
    var mask = layer.property("ADBE Mask Parade").addProperty("ADBE Mask Atom");
    try { mask.name = data.name; } catch (error) { mask.name = data.name.substring(0, 31); }
    var path = mask.property("ADBE Mask Shape");
    for (var i = 0; i < data.keys.length; i++) {
      times.push(layer.startTime + data.keys[i].f / clip.fps);
      shapes.push(outline(data.keys[i], data.closed, x, y));
    }
    path.setValuesAtTimes(times, shapes);
    moves(path, data.keys);
    mask.maskMode = MaskMode[data.mode];
    mask.inverted = data.inverted;
    mask.color = data.color;
    mask.maskMotionBlur = data.blurred ? MaskMotionBlur.ON : MaskMotionBlur.OFF;
    mask.property("ADBE Mask Feather").setValue([data.feather * x, data.feather * y]);
    mask.property("ADBE Mask Offset").setValue(data.expansion * Math.sqrt(x * y));
    show(mask, data, layer.startTime);
    if (typeof MaskFeatherFalloff !== "undefined") { mask.maskFeatherFalloff = MaskFeatherFalloff.FFO_LINEAR; }
    mask.locked = data.locked;
  }

  app.beginUndoGroup("Masks from ROAM");
  var layer = target(composition());
  for (var k = 0; k < masks.length; k++) { add(layer, masks[k]); }
  app.endUndoGroup();
})();
"""
