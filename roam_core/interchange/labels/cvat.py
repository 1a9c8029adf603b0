"""CVAT's XML for video (version 1.1): each shape as a track of polygons whose keyframes are the shape's keys.

Source: the format's published description. Positions are pixels from the image's top-left corner, y down; frames count
from 0, the clip's first. A polygon with `keyframe="1"` was set by somebody, CVAT moves its points straight to the next;
`outside="1"` ends a track until the next keyframe; a larger `z_order` is nearer.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from roam_core.interchange.authorship import MARK
from roam_core.interchange.flatten import is_feathered
from roam_core.interchange.labels.pictures import file_names_of
from roam_core.interchange.labels.polygons import JOINING, STRAYING, Flattener
from roam_core.interchange.labels.presence import below_zero, is_dimmed, stretches
from roam_core.interchange.protocol import STANDARD, ExportOptions, ShapeWriter, readied, settled, without_smooth_keys
from roam_core.interchange.telling import MODE_WORDS
from roam_core.interchange.text_exporter import TextExporter
from roam_core.interchange.timing import without_holds
from roam_core.interchange.xml import xml_text
from roam_core.roto import Clip, Layer, Project, RotoShape
from roam_core.translatable import N_, listed, sentence

NAME = "name"
"""The attribute of a track that holds the shape's name where the label is that of its layer."""


@dataclass(frozen=True)
class CvatExporter(TextExporter):
    """Writes every shape as a track; its label is the name of the layer in the root that it lies in, or its own.

    Attributes
    ----------
    asks_plate : it is told where the plate lacks pictures, for which its folder is read.
    """

    asks_plate: bool = True

    name = "cvat"
    title = N_("CVAT for video")
    suffix = ".xml"
    encoding = "utf-8"

    def document(self, project: Project, options: ExportOptions) -> tuple[str, tuple[str, ...]]:
        """The text and what is told of it."""
        text, notes, losses = cvat_document(project, options)
        if self.asks_plate:
            notes += _gaps(project.require_clip())
        return text, settled(notes, losses, options)


def cvat_document(project: Project, options: ExportOptions = STANDARD) -> tuple[str, list[str], list[str]]:
    """The text with all shapes, sentences on what it cannot hold, and on what it shows otherwise."""
    project = readied(project, options, are_labels=True)
    clip = project.require_clip()
    writer = _Writer(clip, options, len(project.shapes))
    frames = options.frames_of(clip)
    writer.add(project.root, "")
    root = ET.Element("annotations")
    ET.SubElement(root, "version").text = "1.1"
    task = ET.SubElement(ET.SubElement(root, "meta"), "task")
    for word, value in (("name", clip.path.name), ("size", len(clip.frame_range)), ("mode", "interpolation")):
        ET.SubElement(task, word).text = xml_text(str(value))
    ET.SubElement(task, "start_frame").text = str(frames[0] - clip.first + options.frame_offset)
    ET.SubElement(task, "stop_frame").text = str(frames[-1] - clip.first + options.frame_offset)
    labels = ET.SubElement(task, "labels")
    for name in dict.fromkeys(label for label, _ in writer.tracks):
        label = ET.SubElement(labels, "label")
        ET.SubElement(label, "name").text = xml_text(name)
        attribute = ET.SubElement(ET.SubElement(label, "attributes"), "attribute")
        for word, value in ((NAME, NAME), ("mutable", "False"), ("input_type", "text"), ("default_value", "")):
            ET.SubElement(attribute, word).text = value
        ET.SubElement(attribute, "values")
    size = ET.SubElement(task, "original_size")
    for word, length in zip(("width", "height"), clip.size, strict=True):
        ET.SubElement(size, word).text = str(length)
    for number, (name, track) in enumerate(writer.tracks):
        track.set("id", str(number))
        track.set("label", xml_text(name))
        root.append(track)
    writer.notes += [STRAYING, *below_zero("CVAT", clip, options)]
    ET.indent(root, " ")
    text = ET.tostring(root, encoding="unicode", xml_declaration=False)
    return f'<?xml version="1.0" encoding="utf-8"?>\n<!-- {MARK} -->\n{text}\n', writer.notes, writer.losses


def _gaps(clip: Clip) -> list[str]:
    """A sentence where pictures of the plate are missing: CVAT numbers those that it is given, without gaps."""
    files = file_names_of(clip) or dict.fromkeys(clip.frame_range, "")
    missing = [frame for frame in clip.frame_range if frame not in files]
    if not missing:
        return []
    return [
        sentence(
            "CVAT counts pictures without gaps, and {plate} lacks {count}: fill them, or from frame {first} on shapes "
            "lie on other pictures there.",
            plate=clip.name,
            count=len(missing),
            first=missing[0],
        )
    ]


@dataclass
class _Writer(ShapeWriter):
    tracks: list[tuple[str, ET.Element]] = field(default_factory=list)

    def add(self, layer: Layer, label: str, around: tuple[Layer, ...] = ()) -> None:
        """The shapes of a layer, which lies in those `around` it, and of layers in it; `label` is "" in the root."""
        self._tell_layer(layer)
        for child in layer.children:
            if not layer.visible:
                child = replace(child, visible=False)
            if isinstance(child, Layer):
                self.add(child, label or child.name, (*around, layer))
            else:
                self._add_track(child, label or child.name, (*around, layer))

    def _tell_layer(self, layer: Layer) -> None:
        mode = "" if layer.blend in JOINING else sentence("the mode {mode!r}", mode=MODE_WORDS[layer.blend])
        lost = list(filter(None, (mode, sentence("the inversion") if layer.invert else "")))
        if lost and layer.visible:
            self.losses.append(
                sentence("CVAT has no layers of masks: {name!r} loses {lost}.", name=layer.name, lost=listed(lost))
            )
        if is_dimmed(layer, self.options.frames_of(self.clip)):
            self._tell_left([sentence("opacity")], layer.name)

    def _add_track(self, shape: RotoShape, label: str, around: tuple[Layer, ...]) -> None:
        shape = self.begun(shape)
        if shape.point_count < (3 if shape.closed else 2):
            self.notes.append(sentence("{name!r} has too few points for CVAT: it is left out.", name=shape.name))
            return
        self._tell(shape)
        moving = without_holds(without_smooth_keys(shape))
        flattener, track = Flattener(moving), ET.Element("track", source="manual")
        for frame, is_there in sorted(self._frames(moving, around).items()):
            places = flattener.places(moving.at(frame).points)
            values = {
                "frame": str(frame - self.clip.first + self.options.frame_offset),
                "keyframe": "1",
                "outside": "0" if is_there else "1",
                "occluded": "0",
                "points": ";".join(f"{x:.3f},{y:.3f}" for x, y in places.tolist()),
                "z_order": str(len(self.tracks)),
            }
            element = ET.SubElement(track, "polygon" if shape.closed else "polyline", values)
            if shape.name != label:
                ET.SubElement(element, "attribute", name=NAME).text = xml_text(shape.name)
        if len(track):
            self.tracks.append((label, track))

    def _frames(self, shape: RotoShape, around: tuple[Layer, ...]) -> dict[int, bool]:
        """The keyframes of a track, and whether the shape is there from each on: within the clip, where it is seen."""
        frames = self.options.frames_of(self.clip)
        found: dict[int, bool] = {}
        for start, stop in stretches(shape, around, frames):
            found.update(dict.fromkeys((frame for frame in shape.frames if start <= frame < stop), True))
            found[start] = True
            if shape.frames[0] < stop - 1 < shape.frames[-1]:
                found[stop - 1] = True
            if stop <= frames[-1]:
                found[stop] = False
        if not found:
            self.notes.append(
                sentence("{name!r} does not exist on the frames that are written: it is left out.", name=shape.name)
            )
        return found

    def _tell(self, shape: RotoShape) -> None:
        name = f"{shape.name!r}"
        if shape.closed and shape.visible and (shape.invert or shape.blend not in JOINING):
            mode = sentence("mode {mode!r}", mode=MODE_WORDS[shape.blend])
            what = sentence("inversion") if shape.invert else mode
            self.losses.append(
                sentence("Polygons of CVAT only add: the {what} of {name} is lost.", what=what, name=name)
            )
        dim = is_dimmed(shape, self.options.frames_of(self.clip))
        kinds = (
            (sentence("feather"), is_feathered(shape)),
            (sentence("opacity"), dim),
            (sentence("motion blur"), shape.is_blurred),
        )
        if left := [word for word, is_so in kinds if is_so]:
            self._tell_left(left, shape.name)
        if not shape.visible:
            self.notes.append(
                sentence("CVAT hides no tracks in a file: the invisible {name} is seen there.", name=name)
            )

    def _tell_left(self, left: Sequence[str], name: str) -> None:
        self.notes.append(
            sentence("Labels are hard and opaque, without the {left} of {name!r}.", left=listed(left), name=name)
        )
