"""Exporters whose result is one text: what they make is written whole, or not at all."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import ClassVar

from roam_core.atomic_write import write_atomically
from roam_core.interchange.protocol import STANDARD, ExportOptions
from roam_core.roto import Project
from roam_core.translatable import sentence

CHUNK = 1 << 20
"""Letters that are encoded at once."""


class TextExporter(ABC):
    """An `Exporter` whose file is one text, in `encoding`."""

    name: ClassVar[str]
    title: ClassVar[str]
    suffix: ClassVar[str]
    encoding: ClassVar[str] = "ascii"

    @abstractmethod
    def document(self, project: Project, options: ExportOptions) -> tuple[str, tuple[str, ...]]:
        """The text of the file, and what is told of it; raises as `Exporter.export` does."""

    def export(self, project: Project, path: Path, options: ExportOptions = STANDARD) -> tuple[str, ...]:
        """Write `project` to `path`, which appears when it is whole; what the format cannot hold comes back told."""
        pieces, told = self.pieces(project, options)
        write_atomically(path, self._encoded(pieces, path.name, options))
        return told

    def pieces(self, project: Project, options: ExportOptions) -> tuple[Iterable[str], tuple[str, ...]]:
        """As `document`, with the text in pieces, which need not all be there at once; by default parts of it."""
        text, told = self.document(project, options)
        return (text[start : start + CHUNK] for start in range(0, len(text), CHUNK)), told

    def _encoded(self, pieces: Iterable[str], name: str, options: ExportOptions) -> Iterator[bytes]:
        for piece in pieces:
            options.advance(1.0, sentence("Writing {name}", name=name))
            yield piece.encode(self.encoding)
