"""Blender `.py`: a script for Blender's text editor that builds a mask, one mask layer for each shape.

Mask space puts the image's centre at (0.5, 0.5), y up, and the longer side of the image has the length 1, in x by its
pixels and in y as it is shown (pixels may be wide); handles are absolute and the feather of a point is a weight in the
same unit. Blender lays edges half a pixel and more outside of the curve; outlines are moved inwards by as much. All of
it was measured by rendering with Blender itself. Where a layer acts as one it has a mask of its own, joined by nodes.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.interchange.blender.inset import inset
from roam_core.interchange.blender.program import PROGRAM
from roam_core.interchange.blender.steps import stepped
from roam_core.interchange.feather_curve import feather_radii
from roam_core.interchange.flatten import (
    Branch,
    branched,
    has_feather_curve,
    hidden_notes,
    parts_of,
    takes_part,
    without_timed_intersect,
)
from roam_core.interchange.literals import python_literal, whole
from roam_core.interchange.protocol import STANDARD, ExportOptions, ShapeWriter, readied, settled, without_smooth_keys
from roam_core.interchange.text_exporter import TextExporter
from roam_core.interchange.timing import (
    beside_zeros,
    opacity_keys,
    smooth_notes,
    straight_keys,
    tangent_notes,
    without_holds,
)
from roam_core.roto import BlendMode, Clip, Interpolation, Keyframe, Project, RotoShape
from roam_core.translatable import N_, sentence

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

LONG = 3.0
"""How much longer than its other side a picture may be before anybody is told of its softer edges."""


class BlenderExporter(TextExporter):
    """Writes a script that builds a mask with a layer for every shape of a project."""

    name = "blender"
    title = N_("Blender mask (script)")
    suffix = ".py"

    def document(self, project: Project, options: ExportOptions) -> tuple[str, tuple[str, ...]]:
        """The text; what Blender's masks cannot hold is told."""
        return blender_script(project, options)


def blender_script(project: Project, options: ExportOptions = STANDARD) -> tuple[str, tuple[str, ...]]:
    """The script for all shapes of `project`, and a sentence for each thing that a mask cannot hold."""
    clip = project.require_clip()
    root = branched(readied(project, options))
    hidden = hidden_notes(project, root)
    writer = _Writer(clip, options, max(len(list(root.shapes())), 1))
    root = without_timed_intersect(stepped(writer.keyed(root), clip, writer.notes), clip.size)
    parts = writer.parts(root) if root.opacity == 1.0 and not root.invert else [writer.branch(root)]
    if not parts:
        parts = [{"name": "ROAM", "layers": [], "blend": "add", "invert": False, "opacity": [1.0, []]}]
    frames = [frame + options.frame_offset for frame in (clip.first, clip.last)]
    text = PROGRAM.replace("@FRAMES@", str(frames)).replace("@PARTS@", python_literal(parts))
    return text, settled(
        [*hidden, *tangent_notes(project.root), *smooth_notes(project.root), *writer.notes, *ramp_notes(clip)],
        writer.losses,
        options,
    )


def unit(clip: Clip) -> Array:
    """How many pixels in x and in y have the length 1 in mask space."""
    result: Array = max(clip.size) * np.array([1.0, clip.pixel_aspect])
    return result


def mask_space(points: Array, clip: Clip) -> Array:
    """Positions `(..., 2)` in pixels as Blender measures them: the centre at (0.5, 0.5), y up."""
    result: Array = 0.5 + (points - np.array(clip.size) / 2.0) / unit(clip) * np.array([1.0, -1.0])
    return result


def edge(clip: Clip) -> Array:
    """How far outside of a curve without feather Blender lays the middle of the edge: pixels in x and in y.

    Its rasteriser softens an edge by a ramp that begins on the curve and ends a pixel of the shorter side beyond it, in
    a space in which the picture is a square. Measured by rendering, to a thousandth of a pixel.
    """
    size = np.array(clip.size, dtype=np.float64)
    result: Array = 0.5 * size / size.min() * unit(clip) / size.max()
    return result


def ramp_notes(clip: Clip) -> list[str]:
    """A sentence where the ramp of an edge is several pixels long: in pictures far longer than wide, or wider than
    long."""
    pixels = max(clip.size) / min(clip.size)
    if pixels < LONG:
        return []
    return [
        sentence(
            "Blender softens edges by up to {pixels:.1f} pixels in a picture of {width} x {height}.",
            pixels=pixels,
            width=clip.size[0],
            height=clip.size[1],
        )
    ]


def holds(shape: RotoShape) -> bool:
    """True when a mask layer shows the shape: Blender inverts after the opacity, ROAM before."""
    return not shape.invert or (shape.opacity == 1.0 and shape.lifetime is None)


@dataclass
class _Writer(ShapeWriter):
    """Turns shapes into the plain values from which the script builds masks, their layers, and nodes that join them."""

    def keyed(self, branch: Branch) -> Branch:
        """The branch with the keys that are to be exported, and what is lost told."""
        items = (self.keyed(item) if isinstance(item, Branch) else self._begun(item) for item in branch.items)
        return replace(branch, items=tuple(items))

    def _begun(self, shape: RotoShape) -> RotoShape:
        shape = self.begun(shape)
        self._note_losses(shape)
        return shape

    def parts(self, branch: Branch) -> list[dict[str, Any]]:
        """What is joined by nodes, bottom first: masks and branches."""
        parts = []
        for part in parts_of(branch, holds):
            if isinstance(part.content, Branch):
                parts.append(self.branch(part.content))
                continue
            # What is joined by a node is drawn above nothing in its own mask.
            shapes = part.content if not parts else tuple(replace(each, blend=BlendMode.ADD) for each in part.content)
            parts.append(self._mask(shapes, part.blend))
        return parts

    def branch(self, branch: Branch) -> dict[str, Any]:
        """A branch and its parts."""
        return {
            "name": whole(branch.name),
            "parts": self.parts(branch),
            "blend": branch.blend.value,
            "invert": branch.invert,
            "opacity": self.value_rows(branch.opacity, straight_keys(branch.opacity)),
        }

    def _mask(self, shapes: tuple[RotoShape, ...], blend: BlendMode) -> dict[str, Any]:
        """A mask with a layer for each shape; what a layer cannot show alone is dimmed by a node."""
        opacity: list[Any] = [1.0, []]
        if not all(holds(shape) or not takes_part(shape) for shape in shapes):
            (shape,) = (shape for shape in shapes if takes_part(shape))
            opacity = self.value_rows(shape.opacity, opacity_keys(shape))
            shapes = tuple(replace(each, opacity=1.0, lifetime=None) if each is shape else each for each in shapes)
        name = next((shape.name for shape in shapes if takes_part(shape)), "ROAM")
        layers = [self.layer(shape) for shape in shapes]
        return {"name": whole(name), "layers": layers, "blend": blend.value, "invert": False, "opacity": opacity}

    def layer(self, shape: RotoShape) -> dict[str, Any]:
        """One mask layer."""
        shape = without_holds(without_smooth_keys(with_feather_keys(shape)))
        return {
            "name": whole(shape.name),
            "blend": BLENDS[shape.blend],
            "invert": shape.invert,
            "hidden": not shape.visible,
            "locked": shape.locked,
            "closed": shape.closed,
            "alpha": self.value_rows(shape.opacity, opacity_keys(shape)),
            "keys": [[self.numbered(key.frame), self._rows(key, shape)] for key in shape.keys],
        }

    def _rows(self, key: Keyframe, shape: RotoShape) -> list[list[float]]:
        """Each point as x, y, left x, left y, right x, right y and weight."""
        feather, radii, apart = shape.feather_at(key.frame), feather_radii(key, shape.closed), edge(self.clip)
        widths, points = np.maximum(np.maximum(radii, feather), 0.0), key.points
        if (radii < 0.0).any() and key.feather is not None:  # softened from the curve inside out to the outline
            inner = radii < 0.0
            points, widths = np.where(inner[:, None, None], points + key.feather, points), np.abs(radii)
        elif feather < 0.0 and shape.closed:
            points, widths = inset(points, -feather), np.full(len(points), -feather)
        elif not widths.any() and shape.closed:
            points = inset(points / apart, 1.0) * apart
        places = mask_space(points[:, [ANCHOR, IN, OUT]], self.clip).reshape(-1, 6)
        # Blender feathers evenly in the shown picture; where pixels are wide the mean of both ways is kept.
        weights = np.minimum(widths / np.sqrt(unit(self.clip).prod()), 1.0)
        rows: list[list[float]] = np.round(np.column_stack([places, weights]), DECIMALS).tolist()
        return rows

    def _note_losses(self, shape: RotoShape) -> None:
        rows, height = max(self.clip.size) * self.clip.pixel_aspect, self.clip.size[1]
        away = max(float(np.abs(key.points[..., 1] - height / 2.0).max()) for key in shape.keys)
        if takes_part(shape) and height > rows + 1e-6 and away > rows / 2.0:
            self.losses.append(
                sentence(
                    "Blender cuts masks off where pixels are this narrow: {name!r} reaches beyond the middle "
                    "{rows:.0f} of {height} rows.",
                    name=shape.name,
                    rows=rows,
                    height=height,
                )
            )
        if has_feather_curve(shape):
            self.notes.append(
                sentence(
                    "Blender's feather lies square to the outline: the feather curve of {name!r} keeps its "
                    "width at each point, not its handles.",
                    name=shape.name,
                )
            )
        if feather_steps(shape):
            self.notes.append(
                sentence(
                    "Blender's feather slides from key to key: that of {name!r}, which steps, does so during the last "
                    "frame before each step.",
                    name=shape.name,
                )
            )
        if shape.is_blurred:
            self.notes.append(
                sentence("Blender blurs masks in its compositor: the shutter of {name!r} is left out.", name=shape.name)
            )
        if len(shape.name.encode("utf-8", "replace")) > LONGEST_NAME:
            self.notes.append(
                sentence(
                    "Blender cuts names after {longest_name} bytes: {name!r}... is one.",
                    longest_name=LONGEST_NAME,
                    name=shape.name[:20],
                )
            )


def feather_steps(shape: RotoShape) -> list[int]:
    """The frames on which the uniform feather jumps from what was held to a key."""
    return [
        after.frame
        for before, after in pairwise(straight_keys(shape.feather))
        if before.interpolation is Interpolation.HOLD and before.value != after.value
    ]


def with_feather_keys(shape: RotoShape) -> RotoShape:
    """The shape with keys where its uniform feather has some, for programs that keep the two together.

    They move straight from key to key: a feather that is held has one right before its step, too.
    """
    steps = feather_steps(shape)
    soft = {*(key.frame for key in straight_keys(beside_zeros(shape.feather))), *(frame - 1 for frame in steps)}
    frames = sorted(soft.difference(shape.frames))
    if not frames:
        return shape
    keys = []
    for frame in frames:
        outline = shape.at(frame)
        before = next((key for key in reversed(shape.keys) if key.frame < frame), None)
        keys.append(
            Keyframe(
                frame,
                outline.points,
                outline.feather,
                interpolation=before.interpolation if before else Interpolation.LINEAR,
            )
        )
    return without_smooth_keys(shape).with_keys(keys)
