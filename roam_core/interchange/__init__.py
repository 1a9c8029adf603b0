"""Roto shapes to and from other programs: one file per format, one small protocol."""

from roam_core.interchange.mattes import write_matte, write_mattes
from roam_core.interchange.protocol import Exporter, ExportOptions, KeyChoice
from roam_core.interchange.registry import EXPORTERS, exporter_for

__all__ = ["EXPORTERS", "ExportOptions", "Exporter", "KeyChoice", "exporter_for", "write_matte", "write_mattes"]
