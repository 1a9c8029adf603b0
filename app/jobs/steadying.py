"""Steadying outlines as a job: tracked keys are moved on the worker, and put in as one undo step."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from PySide6.QtCore import QObject, Signal

from roam_core.roto import RotoShape

from ..model.document import Document
from ..translation import tr, translated
from .runner import Ending, Report, Runner

ReadFrame = Callable[[int], Any]
KIND = "steady"


class Steadying(QObject):
    """Takes boil off finished keys. `read(frame)` gives plate frames in the engine's colours; the worker calls it.

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

    def start(self, shape_ids: Sequence[str], frames: range, strength: float) -> None:
        """Steady the tracked keys of closed shapes in `frames` by `strength`, in [0, 1]."""
        project, read, self._left = self._document.project, self._read, 0
        asked = [project.shape(shape_id) for shape_id in shape_ids]
        job = self._runner.start(KIND, lambda report: _steady(report, read, asked, frames, strength))
        job.partial.connect(lambda steady: self._apply(asked, steady))
        job.progress.connect(self.progress)
        job.ended.connect(self._end)
        self.progress.emit(0.0, tr("Steadying the outlines …"))

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
            self._document.apply(tr("Steady the outline"), project)

    def _end(self, ending: Ending, sentence: str) -> None:
        if ending is Ending.CANCELLED:
            sentence = tr("Stopped; no key was moved.")
        elif self._left:
            sentence += tr(" {shapes} edited meanwhile: left as they are.", shapes=tr("%n shape(s)", "", self._left))
        self.finished.emit(ending, sentence)


def _steady(report: Report, read: ReadFrame, asked: Sequence[RotoShape], frames: range, strength: float) -> str:
    """The work, on the worker thread."""
    # OpenCV and SciPy load while the window is up already: that must not delay it.
    from roam_core.params.steadiness import RESIDUAL, STEADINESS
    from roam_core.propagate.steadiness.steadying import steadying, told

    found = steadying(read, asked, frames, strength, STEADINESS, RESIDUAL, report.token, report.progress)
    report.partial(found.shapes)
    return translated(told(found))
