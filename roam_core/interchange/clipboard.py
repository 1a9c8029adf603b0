"""Shapes by way of the clipboard: nodes as text that other programs paste, and text of theirs that holds shapes."""

from __future__ import annotations

import tempfile
from dataclasses import replace
from pathlib import Path

from roam_core.errors import RoamError
from roam_core.interchange.protocol import STANDARD, ExportOptions
from roam_core.interchange.reading import CLIPBOARD, PLAIN, Imported, Importer, ImportOptions
from roam_core.interchange.recognition import name_of
from roam_core.interchange.registry import EXPORTERS, IMPORTERS
from roam_core.roto import Clip, Project
from roam_core.translatable import sentence


def node_text(name: str, project: Project, options: ExportOptions = STANDARD) -> tuple[str, tuple[str, ...]]:
    """The text of the nodes that the export format `name` makes of all shapes, and what it notes.

    Raises `LossyExport` as exports to files do, unless the options are `lossy`.
    """
    exporter = EXPORTERS[name]
    with tempfile.TemporaryDirectory(prefix="roam-") as folder:
        path = Path(folder) / f"shapes{exporter.suffix}"
        notes = exporter.export(project, path, options)
        return path.read_text(encoding="utf-8"), notes


def format_of(text: str) -> Importer | None:
    """The format whose shapes the text holds by its look, or None."""
    name = name_of(text)
    return next((importer for importer in IMPORTERS if importer.name == name), None)


def read_text(text: str, clip: Clip, options: ImportOptions = PLAIN) -> Imported:
    """Read the shapes of a text, whatever its format, into pixels and frames of `clip`, as of a file.

    Raises `RoamError` when the text is of no format that is read, is damaged, or goes beyond the limits of files.
    """
    importer = format_of(text)
    if importer is None:
        raise RoamError(sentence("The clipboard holds no shapes of a kind that ROAM reads."))
    return importer.read(CLIPBOARD, clip, replace(options, content=text.encode("utf-8", "surrogatepass")))
