"""SVG pictures of the shapes on single frames: layers as groups, each shape as one path of cubic Bezier curves.

Positions are pixels from the top-left corner, y down, as in ROAM. What SVG has no word for stands in attributes whose
names begin with `data-roam-`; drawing programs pass over them and the reader takes them up again.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import dataclass, field, replace
from itertools import pairwise
from pathlib import Path

import numpy as np

from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.interchange.naming import file_words, is_numbered, numbering
from roam_core.interchange.protocol import STANDARD, ExportOptions, ShapeWriter, with_chosen_keys
from roam_core.interchange.reading import PLAIN, Imported, ImportOptions, quietly
from roam_core.interchange.stilled import stilled
from roam_core.interchange.svg_reading import SvgReader
from roam_core.interchange.svg_words import INKSCAPE, LABEL, SVG
from roam_core.interchange.xml import xml_text
from roam_core.roto import BlendMode, Clip, Layer, Outline, Project, RotoShape, Spline
from roam_core.roto.file import write_atomically

FILL_OPACITY = 0.35


class SvgFormat:
    """Writes the shapes as they are on one frame, or on every frame; reads the outlines of a drawing."""

    name = "svg"
    title = "SVG"
    suffix = ".svg"
    suffixes = (".svg",)

    def export(self, project: Project, path: Path, options: ExportOptions = STANDARD) -> tuple[str, ...]:
        """Write one picture: of the options' frame, or of the first that is written.

        Where the name of `path` says where a frame's number goes (`####` or `%04d`), one picture for every frame.
        """
        clip, project = project.require_clip(), stilled(project)
        frames, frame = options.frames_of(clip), options.frame_of(clip)
        options = replace(options, frames=None)  # a picture shows one moment: there is no motion to be cut
        if not is_numbered(path.name):
            text, notes = svg_document(project, frame, options)
            options.advance(1.0, f"Writing {path.name}")
            write_atomically(path, text.encode("utf-8"))
            return notes
        smoothed: list[str] = []
        project = replace(project, root=with_chosen_keys(project.root, options, smoothed))
        options = replace(options, smoothing=0.0)
        name_for, told = numbering(path.name, options.frame_offset), dict.fromkeys(smoothed)
        for done, frame in enumerate(frames):
            options.advance(done / len(frames), f"Frame {frame}")
            text, notes = svg_document(project, frame, replace(options, progress=None))
            write_atomically(path.with_name(name_for(frame)), text.encode("utf-8"))
            told |= dict.fromkeys(notes)
        return tuple(told)

    def files(self, project: Project, path: Path, options: ExportOptions = STANDARD) -> tuple[Path, ...]:
        """The pictures that `export` writes."""
        if not is_numbered(path.name):
            return (path,)
        name_for = numbering(path.name, options.frame_offset)
        return tuple(path.with_name(name_for(frame)) for frame in options.frames_of(project.require_clip()))

    @quietly
    def read(self, path: Path, clip: Clip, options: ImportOptions = PLAIN) -> Imported:
        """Read all outlines of a drawing as shapes with one key, on the clip's first frame."""
        return SvgReader(path, clip, options).shapes()


def svg_document(project: Project, frame: int, options: ExportOptions = STANDARD) -> tuple[str, tuple[str, ...]]:
    """The picture of all shapes of `project` on one frame, and a sentence for each thing that it cannot hold."""
    project = stilled(project)
    clip = project.require_clip()
    width, height = (str(length) for length in clip.size)
    ET.register_namespace("", SVG)
    ET.register_namespace("inkscape", INKSCAPE)
    picture = ET.Element(f"{{{SVG}}}svg", width=width, height=height, viewBox=f"0 0 {width} {height}")
    picture.set("data-roam-frame", str(frame + options.frame_offset))
    items = [project.root, *project.root.items()]
    ids = dict(zip((item.id for item in items), file_words(item.name for item in items), strict=True))
    writer = _Writer(clip, options, len(project.shapes), frame=frame, ids=ids)
    writer.fill(picture, project.root)
    if project.root.opacity != 1.0 or project.root.invert or not project.root.visible:
        writer.notes.append("The root layer's own opacity, inversion and visibility were left out.")
    ET.indent(picture, " ")
    text = ET.tostring(picture, encoding="unicode", xml_declaration=False)
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{text}\n', tuple(writer.notes)


@dataclass
class _Writer(ShapeWriter):
    """Turns layers and shapes into elements."""

    KINDS = frozenset(Spline)

    frame: int = 0
    ids: dict[str, str] = field(default_factory=dict)

    def fill(self, parent: ET.Element, layer: Layer) -> None:
        """The children of a layer, bottom first: SVG paints in this order too."""
        for child in layer.children:
            if isinstance(child, Layer):
                group = ET.SubElement(parent, f"{{{SVG}}}g", self._attributes(child))
                group.set(f"{{{INKSCAPE}}}groupmode", "layer")
                self.fill(group, child)
            else:
                self._add_path(parent, child)

    def _add_path(self, parent: ET.Element, shape: RotoShape) -> None:
        shape = self.begun(shape)
        if not shape.exists_at(self.frame):
            self.notes.append(f"{shape.name!r} does not exist on frame {self.frame}: it was left out.")
            return
        outline = shape.at(self.frame)
        self._note_losses(shape)
        colour = "#" + "".join(f"{round(255 * min(max(share, 0.0), 1.0)):02x}" for share in shape.colour)
        path = ET.SubElement(parent, f"{{{SVG}}}path", self._attributes(shape))
        path.set("d", path_data(outline))
        path.set("fill", colour if shape.closed else "none")
        path.set("fill-opacity", f"{FILL_OPACITY}")
        path.set("stroke", colour)
        if shape.blend is not BlendMode.ADD:
            path.set("data-roam-blend", shape.blend.value)
        if shape.spline is not Spline.BEZIER:
            path.set("data-roam-spline", shape.spline.value)
        if shape.feather:
            path.set("data-roam-feather", _decimal(shape.feather_at(self.frame)))
        if not shape.closed:
            ends = (*outline.points[0, IN], *outline.points[-1, OUT])
            path.set("data-roam-ends", " ".join(_decimal(float(value)) for value in ends))

    def _attributes(self, item: Layer | RotoShape) -> dict[str, str]:
        values = {"id": self.ids[item.id], LABEL: xml_text(item.name)}
        if not item.visible:
            values["display"] = "none"
        if item.opacity != 1.0:
            values["opacity"] = _decimal(item.opacity_at(self.frame))
        if item.invert:
            values["data-roam-invert"] = "true"
        if item.locked:
            values["data-roam-locked"] = "true"
        return values

    def _note_losses(self, shape: RotoShape) -> None:
        outline = shape.at(self.frame)
        if outline.feather is not None and outline.feather.any():
            self.notes.append(f"SVG has no feather curves: that of {shape.name!r} was left out.")
        if shape.motion_blur is not None:
            self.notes.append(f"A still picture has no shutter: that of {shape.name!r} was left out.")


def path_data(outline: Outline) -> str:
    """An outline as the data of a path; the segment that closes it is written out, so that its handles are kept."""
    points = np.concatenate([outline.points, outline.points[:1]]) if outline.closed else outline.points
    words = [f"M {_pair(points[0, ANCHOR])}"]
    for start, end in pairwise(points):
        is_straight = (start[OUT] == start[ANCHOR]).all() and (end[IN] == end[ANCHOR]).all()
        places = [end[ANCHOR]] if is_straight else [start[OUT], end[IN], end[ANCHOR]]
        words.append(" ".join(["L" if is_straight else "C", *(_pair(place) for place in places)]))
    return " ".join([*words, "Z"] if outline.closed else words)


def _pair(place: np.ndarray[tuple[int], np.dtype[np.float64]]) -> str:
    return f"{_decimal(float(place[0]))},{_decimal(float(place[1]))}"


def _decimal(value: float) -> str:
    """Six decimals without trailing zeros."""
    return f"{value:.6f}".rstrip("0").rstrip(".") if round(value, 6) else "0"
