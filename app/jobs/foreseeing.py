"""What an export would lose, found out on the worker while the artist looks at the dialog."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer, Signal

from roam_core.roto import Project
from roam_core.roto.layers import only

from .runner import Ending, Report, Runner

if TYPE_CHECKING:
    from roam_core.interchange import ExportOptions

PAUSE = 150
"""Milliseconds without another question after which one is looked into: fields are turned, points are dragged."""


class Foresight(QObject):
    """Asks `roam_core.interchange.foresight`; only the latest question is answered.

    Signals
    -------
    seen(foreseen) : the `Foreseen` of the latest question.
    refused(sentence) : the export would be refused, whatever is lost; the sentence says why.
    """

    seen = Signal(object)
    refused = Signal(str)

    def __init__(self, runner: Runner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._runner = runner
        self._question: tuple[str, Project, ExportOptions, Collection[str] | None] | None = None
        self._timer = QTimer(self, singleShot=True, interval=PAUSE)
        self._timer.timeout.connect(self._look)

    def ask(
        self, format_name: str, project: Project, options: ExportOptions, shapes: Collection[str] | None = None
    ) -> None:
        """Find out before long about an export of the shapes of these ids, all for None."""
        self.drop()
        self._question = format_name, project, options, shapes
        self._timer.start()

    def drop(self) -> None:
        """The last question needs no answer any more."""
        self._timer.stop()
        self._question = None
        if (job := self._runner.running("foresight")) is not None:
            job.drop()

    def _look(self) -> None:
        if self._question is None:
            return
        format_name, project, options, shapes = self._question

        def work(report: Report) -> str:
            from roam_core.interchange import EXPORTERS
            from roam_core.interchange.foresight import foreseen

            chosen = only(project, shapes)
            report.partial(foreseen(EXPORTERS[format_name], chosen, replace(options, token=report.token)))
            return ""

        job = self._runner.start("foresight", work)
        job.partial.connect(self.seen)
        job.ended.connect(self._end)

    def _end(self, ending: Ending, sentence: str) -> None:
        if ending is Ending.FAILED:
            self.refused.emit(sentence)
