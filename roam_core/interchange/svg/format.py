"""SVG pictures of the shapes on single frames: layers as groups, each shape as one path of cubic Bezier curves.

Positions are pixels from the top-left corner, y down, as in ROAM. What any renderer paints is the matte: white, as
opaque as the matte is white (`svg.painting`). What SVG has no word for stands in attributes whose names begin with
`data-roam-`; drawing programs pass over them and the reader takes them up again.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path

from roam_core.atomic_write import write_atomically
from roam_core.interchange.naming import file_words, is_numbered, numbering
from roam_core.interchange.protocol import STANDARD, ExportOptions, KeyChoice, ShapeWriter, readied
from roam_core.interchange.reading import PLAIN, Imported, ImportOptions, quietly
from roam_core.interchange.svg.painting import Painter
from roam_core.interchange.svg.reading import SvgReader
from roam_core.interchange.svg.words import INKSCAPE, SODIPODI, SVG, XLINK, svg_tag
from roam_core.interchange.telling import gathered
from roam_core.roto import Clip, Keyframe, Layer, Project, RotoShape
from roam_core.translatable import N_, sentence

PAGE = "#404040"
"""The page's colour in Inkscape, before which white shapes are seen."""


class SvgFormat:
    """Writes the shapes as they are on one frame, or on every frame; reads the outlines of a drawing."""

    name = "svg"
    title = N_("SVG")
    suffix = ".svg"
    suffixes = (".svg",)

    def export(self, project: Project, path: Path, options: ExportOptions = STANDARD) -> tuple[str, ...]:
        """Write one picture: of the options' frame, or of the first that is written.

        Where the name of `path` says where a frame's number goes (`####` or `%04d`), one picture for every frame.
        """
        clip = project.require_clip()
        frames, frame = options.frames_of(clip), options.frame_of(clip)
        options = replace(options, frames=None)  # a picture shows one moment: there is no motion to be cut
        if not is_numbered(path.name):
            text, notes = svg_document(project, frame, options)
            options.advance(1.0, sentence("Writing {name}", name=path.name))
            write_atomically(path, text.encode("utf-8"))
            return notes
        writer = Painter(clip, replace(options, progress=None), len(project.shapes))
        root = _begun(readied(project, options).root, writer)
        options = replace(options, keys=KeyChoice.EVERY, smoothing=0.0)  # they are chosen, once for all pictures
        name_for, told = numbering(path.name, options.frame_offset), dict.fromkeys(writer.notes)
        absent: dict[str, list[int]] = {}
        for done, frame in enumerate(frames):
            options.advance(done / len(frames), sentence("Frame {frame}", frame=frame))
            picture = _picture(replace(project, root=_at(root, frame)), frame, replace(options, progress=None))
            write_atomically(path.with_name(name_for(frame)), picture.text.encode("utf-8"))
            told |= dict.fromkeys(picture.notes)
            for shape_id in picture.absent:
                absent.setdefault(shape_id, []).append(frame)
        names = {shape.id: shape.name for shape in project.shapes}
        return gathered([*told, *(_absence(names[shape_id], on) for shape_id, on in absent.items())])

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
    picture, names = (
        _picture(readied(project, options), frame, options),
        {shape.id: shape.name for shape in project.shapes},
    )
    absent = (_absence(names[shape_id], [frame]) for shape_id in picture.absent)
    return picture.text, gathered([*picture.notes, *absent])


@dataclass(frozen=True)
class _Picture:
    """A picture's text, what it cannot hold, and the ids of the shapes that do not exist on its frame."""

    text: str
    notes: tuple[str, ...]
    absent: tuple[str, ...]


def _begun(layer: Layer, writer: ShapeWriter) -> Layer:
    """The layer with the keys of every shape that are to be exported."""
    children = (_begun(child, writer) if isinstance(child, Layer) else writer.begun(child) for child in layer.children)
    return replace(layer, children=tuple(children))


def _at(layer: Layer, frame: int) -> Layer:
    """The layer whose shapes have the one key that a picture of the frame asks for, that it looks at no others."""
    return replace(
        layer,
        children=tuple(
            _at(child, frame) if isinstance(child, Layer) else replace(child, keys=(_key_at(child, frame),))
            for child in layer.children
        ),
    )


def _key_at(shape: RotoShape, frame: int) -> Keyframe:
    outline = shape.at(frame)
    return Keyframe(frame, outline.points, outline.feather)


def _picture(project: Project, frame: int, options: ExportOptions) -> _Picture:
    """The picture of a project that is `readied`."""
    clip, root = project.require_clip(), project.root
    width, height = (str(length) for length in clip.size)
    for prefix, space in {"": SVG, "inkscape": INKSCAPE, "sodipodi": SODIPODI, "xlink": XLINK}.items():
        ET.register_namespace(prefix, space)
    picture = ET.Element(svg_tag("svg"), width=width, height=height, viewBox=f"0 0 {width} {height}")
    picture.set("data-roam-frame", str(frame + options.frame_offset))
    ET.SubElement(picture, f"{{{SODIPODI}}}namedview", pagecolor=PAGE)
    items = [root, *root.items()]
    ids = dict(zip((item.id for item in items), file_words(item.name for item in items), strict=True))
    painter = Painter(clip, options, len(project.shapes), frame=frame, ids=ids)
    if root.visible and not root.locked and not root.invert and root.opacity_at(frame) == 1.0:
        painter.fill(picture, root)
    else:
        painter.group(picture, root)
    ET.indent(picture, " ")
    text = ET.tostring(picture, encoding="unicode", xml_declaration=False)
    return _Picture(f'<?xml version="1.0" encoding="UTF-8"?>\n{text}\n', tuple(painter.notes), tuple(painter.absent))


def _absence(name: str, frames: Iterable[int]) -> str:
    spans: list[list[int]] = []
    for frame in sorted(frames):
        if spans and spans[-1][1] == frame - 1:
            spans[-1][1] = frame
        else:
            spans.append([frame, frame])
    told = [str(first) if first == last else f"{first} to {last}" for first, last in spans[:4]]
    where = ", ".join(told)
    if len(spans) == 1 and spans[0][0] == spans[0][1]:
        return sentence("{name!r} does not exist on frame {frame}: it is left out.", name=name, frame=where)
    more = sentence(" and on others") if len(spans) > 4 else ""
    return sentence(
        "{name!r} does not exist on frames {frames}{more}: it is left out.", name=name, frames=where, more=more
    )
