"""All formats, to write by name and to read by suffix. A new one is a room or file of this package and a line here."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from roam_core.arguments import path_of, shown
from roam_core.bounded import require_regular
from roam_core.errors import RoamError
from roam_core.interchange.after_effects.exporter import AfterEffectsExporter
from roam_core.interchange.authorship import is_project
from roam_core.interchange.blender.exporter import BlenderExporter
from roam_core.interchange.fusion.exporter import FusionExporter
from roam_core.interchange.fusion.reading import FusionImporter
from roam_core.interchange.json_files import JsonImporter
from roam_core.interchange.labels.coco import CocoExporter
from roam_core.interchange.labels.cvat import CvatExporter
from roam_core.interchange.labels.cvat_reading import CvatImporter
from roam_core.interchange.masks.importer import MaskImporter
from roam_core.interchange.mattes.exporter import MatteExporter
from roam_core.interchange.mlt.exporter import MltExporter
from roam_core.interchange.natron import NatronExporter
from roam_core.interchange.nuke.exporter import NukeExporter
from roam_core.interchange.nuke.python_script import NukePythonExporter
from roam_core.interchange.nuke.reading import NukeImporter
from roam_core.interchange.nuke.tracks import NukeTracksExporter
from roam_core.interchange.plain_json import JsonFormat
from roam_core.interchange.protocol import STANDARD, Exporter, ExportOptions
from roam_core.interchange.reading import PLAIN, Imported, Importer, ImportOptions
from roam_core.interchange.recognition import format_of
from roam_core.interchange.silhouette.exporter import SilhouetteExporter
from roam_core.interchange.silhouette.reading import SilhouetteImporter
from roam_core.interchange.svg.format import SvgFormat
from roam_core.interchange.targets import PROJECT
from roam_core.roto import Clip, Project
from roam_core.translatable import sentence


class Exporters(dict[str, Exporter]):
    """Formats by name; asking for one that is not there is answered with those that are."""

    def __init__(self, exporters: Iterable[Exporter]) -> None:
        super().__init__((exporter.name, exporter) for exporter in exporters)

    def __missing__(self, name: str) -> Exporter:
        raise RoamError(
            sentence(
                "There is no export format {name!r}; there are: {known}.", name=name, known=", ".join(sorted(self))
            )
        )


def exporter_for(name: str) -> Exporter:
    """The format of that name, or a `RoamError` that lists those that are there."""
    return EXPORTERS[name]


EXPORTERS = Exporters(
    [
        NukeExporter(),
        NukePythonExporter(),
        NukeTracksExporter(),
        SilhouetteExporter(),
        AfterEffectsExporter(),
        FusionExporter(),
        BlenderExporter(),
        NatronExporter(),
        SvgFormat(),
        JsonFormat(),
        CocoExporter(),
        CvatExporter(),
        MltExporter(),
        MatteExporter(),
    ]
)


IMPORTERS: tuple[Importer, ...] = (
    NukeImporter(),
    SilhouetteImporter(),
    FusionImporter(),
    SvgFormat(),
    JsonImporter(),
    CvatImporter(),
    MaskImporter(),
)
"""Every format that can be read."""
SHAPE_SUFFIXES = tuple(
    suffix for importer in IMPORTERS if not isinstance(importer, MaskImporter) for suffix in importer.suffixes
)
"""Of files that hold shapes themselves; a mask's may be that of a clip as well."""


def importer_for(path: Path) -> Importer:
    """The format that reads files of this suffix, or folders; else a `RoamError`, which lists those that are read.

    Where no format has the suffix, or there is none, a file of shapes is known by how it begins.
    """
    suffix = "" if os.path.isdir(path) else path.suffix.lower() or "none"  # noqa: PTH112 - no error for a long name
    for importer in IMPORTERS:
        if suffix in importer.suffixes:
            return importer
    if (name := format_of(path)) is not None:
        return next(importer for importer in IMPORTERS if importer.name == name)
    if not os.path.lexists(path):
        raise RoamError(
            sentence("{path} does not exist; give a file of shapes, a mask or a folder of masks.", path=path)
        )
    require_regular(path)
    if suffix == PROJECT or is_project(path):
        raise RoamError(
            sentence(
                "{path} is a project; export its shapes (--to json) and import those, or copy them from "
                "window to window.",
                path=path,
            )
        )
    known = ", ".join(suffix for importer in IMPORTERS for suffix in importer.suffixes if suffix)
    raise RoamError(
        sentence(
            "{path} has no suffix that ROAM reads shapes from; it reads: {known}, and folders of masks.",
            path=path,
            known=known,
        )
    )


def holds_shapes(path: Path) -> bool:
    """Whether a file is one of shapes: by its suffix, or, where no format has that, by how it begins."""
    suffix = path.suffix.lower()
    if any(suffix and suffix in importer.suffixes for importer in IMPORTERS):
        return suffix in SHAPE_SUFFIXES
    return format_of(path) is not None


def read_shapes(path: str | Path, clip: Clip, options: ImportOptions = PLAIN) -> Imported:
    """Read the shapes of a file, or of a folder of masks, into pixels and frames of `clip`.

    The suffix tells the format: `.nk`, `.fxs`, `.sfx`, `.setting`, `.comp`, `.svg`, `.json`, `.xml`, and of other files
    how they begin; a picture or a folder is a sequence of masks. `roam_core.edit.add_items` puts what was read into a
    project.

    Raises
    ------
    ValueError
        when the path, the clip or the options are none.
    RoamError
        when the suffix is not known, the file cannot be read, is none of its format, or is too large.
    """
    path = path_of(path)
    if not isinstance(clip, Clip):
        raise ValueError(
            f"shapes are read into the pixels of a Clip, such as Clip.of(open_clip(path)), not {shown(clip)}"
        )
    _require_options(options, ImportOptions)
    return importer_for(path).read(path, clip, options)


def write_shapes(project: Project, path: str | Path, name: str, options: ExportOptions = STANDARD) -> tuple[str, ...]:
    """Write all shapes of a project for another program; a file that is there is replaced.

    Parameters
    ----------
    project : a project with a clip.
    path : the file; for mattes, and for SVG of every frame, a pattern such as `matte.####.png`.
    name : of the format, as `roam export --to` takes it: `nuke`, `silhouette`, `after-effects`, `fusion`, `blender`,
        `natron`, `svg`, `json` and the others of `roam_core.interchange.EXPORTERS`.
    options : which keys and frames, how exactly, and whether what the format cannot hold may be lost.

    Returns
    -------
    One sentence for each thing that the format cannot hold and that was therefore left out or changed.

    Raises
    ------
    ValueError
        when the project, the path or the options are none.
    LossyExport
        when the mattes would differ in the other program, and the options are not `lossy`.
    RoamError
        when the format is not known, the project has no clip, or the file cannot be written.
    """
    if not isinstance(project, Project):
        raise ValueError(f"shapes are written of a Project, as edit.add_shape makes it, not of {shown(project)}")
    _require_options(options, ExportOptions)
    return exporter_for(name).export(project, path_of(path), options)


def _require_options(options: Any, kind: type) -> None:
    if not isinstance(options, kind):
        raise ValueError(f"options are {kind.__name__}(...), not {shown(options)}")
