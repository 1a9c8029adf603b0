"""Imports as a job: a file of shapes is read on the worker, then put on top of the project as one undo step."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Signal

from app.document import Document
from app.jobs.runner import Ending, Report, Runner
from roam_core.roto import edit

if TYPE_CHECKING:
    from roam_core.interchange import MaskOptions

SHAPE_FILES = (".nk", ".gizmo", ".fxs", ".sfx", ".svg", ".json")
"""Suffixes of files that hold shapes and cannot be a clip or a project."""


class Import(QObject):
    """Reads shapes in the formats of `roam_core.interchange`.

    Signals
    -------
    progress(fraction, text), finished(ending, sentence) : the job's news.
    """

    progress = Signal(float, str)
    finished = Signal(object, str)

    def __init__(self, document: Document, runner: Runner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document, self._runner = document, runner
        document.replaced.connect(self.stop)

    def start(self, path: Path, masks: MaskOptions | None = None) -> None:
        """Read a file of shapes, or a folder of masks as `masks` say, into the project's clip."""
        project = self._document.project

        def work(report: Report) -> str:
            from roam_core.interchange import ImportOptions, MaskOptions, read_shapes

            report.progress(0.0, f"Reading {path.name} …")
            options = ImportOptions(masks=masks or MaskOptions(), progress=report.progress, token=report.token)
            imported = read_shapes(path, project.require_clip(), options)
            count = sum(1 for _ in imported.layer.shapes())
            if count:
                report.partial(imported)
            return " ".join([f"Read {count} shape(s) from {path.name}.", *imported.notes])

        job = self._runner.start("import", work)
        job.progress.connect(self.progress)
        job.partial.connect(self._put_in)
        job.ended.connect(self._end)

    def stop(self) -> None:
        """Stop reading; nothing of the file is taken."""
        if (job := self._runner.running("import")) is not None:
            job.drop()

    def _put_in(self, imported: Any) -> None:
        project, _ = edit.add_items(self._document.project, imported.layer.children)
        self._document.apply("Import shapes", project)

    def _end(self, ending: Ending, sentence: str) -> None:
        self.finished.emit(ending, "Import stopped." if ending is Ending.CANCELLED else sentence)
