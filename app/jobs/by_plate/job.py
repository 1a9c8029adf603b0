"""PlateJob: shapes are changed on the worker, which looks at the plate, and put in as one undo step."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, ClassVar

from PySide6.QtCore import QObject, Signal

from roam_core.roto import RotoShape

from ...model.document import Document
from ...translation import tr
from ..runner import Ending, Report, Runner

ReadFrame = Callable[[int], Any]
Work = Callable[[Report, ReadFrame], str]
"""Told where to report and what reads frames: posts the changed shapes, returns what was done in a sentence."""


class PlateJob(QObject):
    """A job of one kind. `read(frame)` gives plate frames in the engine's colours; the worker calls it.

    Signals
    -------
    progress(fraction, text), finished(ending, sentence) : the job's news.
    """

    progress = Signal(float, str)
    finished = Signal(object, str)

    KIND: ClassVar[str]
    STEP: ClassVar[str]
    """What the undo step is called."""
    STOPPED: ClassVar[str]
    """What is said where it was stopped."""

    def __init__(self, document: Document, runner: Runner, read: ReadFrame, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document, self._runner, self._read = document, runner, read
        self._left = 0
        """Shapes of the last job that were edited or locked while it ran."""
        document.replaced.connect(self.drop)

    def stop(self) -> None:
        """Stop soon; nothing is changed."""
        if (job := self._runner.running(self.KIND)) is not None:
            job.cancel()

    def drop(self) -> None:
        """Stop now: nothing that is still found may reach the document."""
        if (job := self._runner.running(self.KIND)) is not None:
            job.drop()

    def _begin(self, asked: Sequence[RotoShape], work: Work, saying: str) -> None:
        """Start `work`, which posts as many shapes as are `asked`, in that order."""
        read, self._left = self._read, 0
        job = self._runner.start(self.KIND, lambda report: work(report, read))
        job.partial.connect(lambda changed: self._apply(asked, changed))
        job.progress.connect(self.progress)
        job.ended.connect(self._end)
        self.progress.emit(0.0, saying)

    def _apply(self, before: Sequence[RotoShape], after: Sequence[RotoShape]) -> None:
        """Put in what was found, but for shapes that were edited, locked or taken away meanwhile.

        A name, a colour or an eye that was changed stays so.
        """
        project = self._document.project
        for old, new in zip(before, after, strict=True):
            now = project.shape(old.id) if project.has(old.id) else None
            if now is None or project.is_locked(old.id) or _looking_as(now, old) != old:
                self._left += 1
            elif new != old:
                project = project.with_shape(_looking_as(new, now))
        if project is not self._document.project:
            self._document.apply(tr(self.STEP), project)

    def _end(self, ending: Ending, sentence: str) -> None:
        if ending is Ending.CANCELLED:
            sentence = tr(self.STOPPED)
        elif self._left:
            sentence += tr(
                " {shapes} edited or locked meanwhile: left as they are.", shapes=tr("%n shape(s)", "", self._left)
            )
        self.finished.emit(ending, sentence)


def _looking_as(shape: RotoShape, other: RotoShape) -> RotoShape:
    """The shape with what of another one no job goes by."""
    return replace(shape, name=other.name, colour=other.colour, visible=other.visible)
