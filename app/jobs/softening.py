"""Matching the plate's edge as a job: it is measured on the worker, and shapes are made as soft in one undo step."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from PySide6.QtCore import QObject, Signal

from roam_core.roto import Project, RotoShape

from ..model.document import Document
from ..translation import tr, translated
from .runner import Ending, Report, Runner

ReadFrame = Callable[[int], Any]
KIND = "soften"


class Softening(QObject):
    """Makes shapes as soft as the plate. `read(frame)` gives plate frames in the engine's colours; the worker calls it.

    Signals
    -------
    progress(fraction, text), finished(ending, sentence) : the job's news.
    """

    progress = Signal(float, str)
    finished = Signal(object, str)

    def __init__(self, document: Document, runner: Runner, read: ReadFrame, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document, self._runner, self._read = document, runner, read
        self._left = 0
        """Shapes of the last job that were edited while it ran."""
        document.replaced.connect(self.drop)

    def start(self, shape_ids: Sequence[str]) -> None:
        """Measure the edge of closed shapes on all their keys, then set motion blur and feather."""
        project, read, self._left = self._document.project, self._read, 0
        asked = [project.shape(shape_id) for shape_id in shape_ids]
        job = self._runner.start(KIND, lambda report: _soften(report, read, project, asked))
        job.partial.connect(lambda soft: self._apply(asked, soft))
        job.progress.connect(self.progress)
        job.ended.connect(self._end)
        self.progress.emit(0.0, tr("Looking at the plate's edge …"))

    def stop(self) -> None:
        """Stop soon; nothing is changed."""
        if (job := self._runner.running(KIND)) is not None:
            job.cancel()

    def drop(self) -> None:
        """Stop now: nothing that is still found may reach the document."""
        if (job := self._runner.running(KIND)) is not None:
            job.drop()

    def _apply(self, before: Sequence[RotoShape], after: Sequence[RotoShape]) -> None:
        """Put in what was found, but for shapes that were edited or taken away meanwhile."""
        project = self._document.project
        for old, new in zip(before, after, strict=True):
            if not project.has(old.id) or project.shape(old.id) != old:
                self._left += 1
            elif new != old:
                project = project.with_shape(new)
        if project is not self._document.project:
            self._document.apply(tr("Match the plate's edge"), project)

    def _end(self, ending: Ending, sentence: str) -> None:
        if ending is Ending.CANCELLED:
            sentence = tr("Stopped; no edge was changed.")
        elif self._left:
            sentence += tr(" {shapes} edited meanwhile: left as they are.", shapes=tr("%n shape(s)", "", self._left))
        self.finished.emit(ending, sentence)


def _soften(report: Report, read: ReadFrame, project: Project, asked: Sequence[RotoShape]) -> str:
    """The work, on the worker thread."""
    # OpenCV loads while the window is up already: that must not delay it.
    from roam_core.matte.softening import matched, told
    from roam_core.matte.softness import measured
    from roam_core.params import SOFTNESS

    found = measured(read, asked, project.shapes, SOFTNESS, report.token, report.progress)
    soft = [matched(shape, found, SOFTNESS, blur=True, feather=True) for shape in asked]
    report.partial(soft)
    return translated(told(found, asked, soft))
