"""Roto shapes to and from other programs: one file per format, one small protocol."""

from roam_core.interchange.mattes.exporter import write_matte, write_mattes
from roam_core.interchange.protocol import Exporter, ExportOptions, KeyChoice
from roam_core.interchange.reading import Imported, Importer, ImportOptions, MaskOptions
from roam_core.interchange.registry import EXPORTERS, IMPORTERS, exporter_for, importer_for, read_shapes, write_shapes

__all__ = [
    "EXPORTERS",
    "IMPORTERS",
    "ExportOptions",
    "Exporter",
    "ImportOptions",
    "Imported",
    "Importer",
    "KeyChoice",
    "MaskOptions",
    "exporter_for",
    "importer_for",
    "read_shapes",
    "write_matte",
    "write_mattes",
    "write_shapes",
]
