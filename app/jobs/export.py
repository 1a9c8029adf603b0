"""Exports as a job: a snapshot of the project is written on the worker, while the artist goes on."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from app.document import Document
from app.jobs.runner import Ending, Report, Runner

if TYPE_CHECKING:
    from roam_core.interchange import ExportOptions


class Export(QObject):
    """Writes shapes and mattes in the formats of `roam_core.interchange`.

    Signals
    -------
    progress(fraction, text), finished(ending, sentence) : the job's news.
    noted(sentences) : a tuple: what the format cannot hold and was left out or changed, before `finished`.
    """

    progress = Signal(float, str)
    finished = Signal(object, str)
    noted = Signal(object)

    def __init__(self, document: Document, runner: Runner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document, self._runner = document, runner

    def start(self, format_name: str, path: Path, options: ExportOptions | None = None) -> None:
        """Write the project as it is now to `path` (a file, or for mattes a folder) in the format of that name."""
        project = self._document.project

        def work(report: Report) -> str:
            from roam_core.interchange import EXPORTERS, ExportOptions

            report.progress(0.0, f"Exporting to {path.name} …")
            told = replace(options or ExportOptions(), progress=report.progress, token=report.token)
            losses = EXPORTERS[format_name].export(project, path, told)
            report.partial(losses)
            return " ".join([f"Exported to {path}.", *losses])

        job = self._runner.start("export", work)
        job.progress.connect(self.progress)
        job.partial.connect(self.noted)
        job.ended.connect(self._end)

    def stop(self) -> None:
        """Stop the export; files that are written whole stay."""
        if (job := self._runner.running("export")) is not None:
            job.cancel()

    def _end(self, ending: Ending, sentence: str) -> None:
        stopped = "Export stopped; the files that are finished stay."
        self.finished.emit(ending, stopped if ending is Ending.CANCELLED else sentence)
