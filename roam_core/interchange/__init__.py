"""Roto shapes to and from other programs: one file per format, one small protocol.

Each name is loaded when it is first asked for: what tells whose a file is (`authorship`) does not wait for all formats.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from roam_core.on_demand import offered

if TYPE_CHECKING:
    from roam_core.interchange.mattes.exporter import write_matte, write_mattes
    from roam_core.interchange.protocol import Exporter, ExportOptions, KeyChoice
    from roam_core.interchange.reading import Imported, Importer, ImportOptions, MaskOptions
    from roam_core.interchange.registry import (
        EXPORTERS,
        IMPORTERS,
        exporter_for,
        importer_for,
        read_shapes,
        write_shapes,
    )

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

_ROOMS = {
    "roam_core.interchange.mattes.exporter": ("write_matte", "write_mattes"),
    "roam_core.interchange.protocol": ("ExportOptions", "Exporter", "KeyChoice"),
    "roam_core.interchange.reading": ("ImportOptions", "Imported", "Importer", "MaskOptions"),
    "roam_core.interchange.registry": (
        "EXPORTERS",
        "IMPORTERS",
        "exporter_for",
        "importer_for",
        "read_shapes",
        "write_shapes",
    ),
}
__getattr__, __dir__ = offered(__name__, _ROOMS)
