"""Copying for other programs as a job: the text of nodes is made on the worker and handed over when it is whole."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from roam_core.roto import Project

from ..translation import tr, translated
from .runner import Ending, Report, Runner


class Copying(QObject):
    """Makes text of shapes in the formats of `roam_core.interchange`.

    Signals
    -------
    progress(fraction, text), finished(ending, sentence) : the job's news; the sentence tells what was left out, too.
    copied(text) : ready to be pasted, before `finished`.
    """

    progress = Signal(float, str)
    finished = Signal(object, str)
    copied = Signal(object)

    def __init__(self, runner: Runner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._runner = runner

    def start(self, format_name: str, program: str, project: Project) -> None:
        """Make the text of all shapes of a project for a program."""

        def work(report: Report) -> str:
            from roam_core.interchange import ExportOptions
            from roam_core.interchange.clipboard import node_text

            report.progress(0.0, tr("Copying for {program} …", program=program))
            options = ExportOptions(lossy=True, progress=report.progress, token=report.token)
            text, notes = node_text(format_name, project, options)
            report.partial(text)
            shapes = tr("%n shape(s)", "", len(project.shapes))
            return " ".join(
                [
                    tr("Copied {shapes} for {program}; paste there.", shapes=shapes, program=program),
                    *map(translated, notes),
                ]
            )

        job = self._runner.start("copy", work)
        job.progress.connect(self.progress)
        job.partial.connect(self.copied)
        job.ended.connect(self._end)

    def stop(self) -> None:
        """Stop it; the clipboard stays as it is."""
        if (job := self._runner.running("copy")) is not None:
            job.cancel()

    def _end(self, ending: Ending, sentence: str) -> None:
        self.finished.emit(ending, tr("Nothing was copied.") if ending is Ending.CANCELLED else sentence)
