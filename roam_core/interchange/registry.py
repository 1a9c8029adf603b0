"""All formats, to write by name and to read by suffix. A new one is a room or file of this package and a line here."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from roam_core.errors import RoamError
from roam_core.interchange.after_effects.exporter import AfterEffectsExporter
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
from roam_core.interchange.protocol import Exporter
from roam_core.interchange.reading import PLAIN, Imported, Importer, ImportOptions
from roam_core.interchange.silhouette.exporter import SilhouetteExporter
from roam_core.interchange.silhouette.reading import SilhouetteImporter
from roam_core.interchange.svg.format import SvgFormat
from roam_core.roto import Clip


class Exporters(dict[str, Exporter]):
    """Formats by name; asking for one that is not there is answered with those that are."""

    def __init__(self, exporters: Iterable[Exporter]) -> None:
        super().__init__((exporter.name, exporter) for exporter in exporters)

    def __missing__(self, name: str) -> Exporter:
        raise RoamError(f"There is no export format {name!r}; there are: {', '.join(sorted(self))}.")


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


def importer_for(path: Path) -> Importer:
    """The format that reads files of this suffix, or folders; a `RoamError` lists those that are read."""
    suffix = "" if path.is_dir() else path.suffix.lower() or "none"
    for importer in IMPORTERS:
        if suffix in importer.suffixes:
            return importer
    known = ", ".join(suffix for importer in IMPORTERS for suffix in importer.suffixes if suffix)
    raise RoamError(f"{path} has no suffix that ROAM reads shapes from; it reads: {known}, and folders of masks.")


def read_shapes(path: Path, clip: Clip, options: ImportOptions = PLAIN) -> Imported:
    """Read the shapes of a file, whatever its format, into pixels and frames of `clip`.

    Raises `RoamError` when the suffix is not known, the file cannot be read, is none of its format, or is too large.
    """
    return importer_for(path).read(path, clip, options)
