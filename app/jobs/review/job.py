"""What reviewing takes time for, as jobs: movies, pictures and contact sheets; boil measured by the picture."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Signal

from roam_core.roto import RotoShape

from ...model.document import Document
from ...translation import tr, translated
from ..runner import Ending, Report, Runner

if TYPE_CHECKING:
    from roam_core.review.writing import ReviewRequest

ReadFrame = Callable[[int], Any]
WRITING, MEASURING = "review", "boil"


class ReviewJob(QObject):
    """Writes what others look at, and measures.

    `reading()` gives what reads frames of the plate that is open, in the engine's colours, for the worker: what is
    begun on one plate goes on with it while another one is open.

    Signals
    -------
    progress(fraction, text), finished(ending, sentence) : the job's news.
    written(path) : it was made as a whole.
    measured(shapes, boil) : the boil by the picture of shapes, as they were when it began, both by their ids.

    `is_told_of_writing`: whether `progress` or `finished` tells of what is written, and not of a measurement.

    Neither plate nor project file are written over. Files that ROAM did not make are, if `may_overwrite(paths)` says
    so: the artist, who is asked before anything is written.
    """

    progress = Signal(float, str)
    finished = Signal(object, str)
    written = Signal(object)
    measured = Signal(object, object)

    def __init__(
        self,
        document: Document,
        runner: Runner,
        reading: Callable[[], ReadFrame],
        parent: QObject | None = None,
        may_overwrite: Callable[[Sequence[Path]], bool] = lambda _: False,
    ) -> None:
        super().__init__(parent)
        self._document, self._runner, self._reading, self._may_overwrite = document, runner, reading, may_overwrite
        self.is_told_of_writing = False

    @property
    def is_writing(self) -> bool:
        return self._runner.running(WRITING) is not None

    def start(self, request: ReviewRequest) -> None:
        """Write what is asked for; its project is the snapshot."""
        self._start(_Writing(request, self._document.path, self._reading()))

    def stop(self) -> None:
        """Stop soon; finished pictures stay, a movie does not appear."""
        for kind in (WRITING, MEASURING):
            if (job := self._runner.running(kind)) is not None:
                job.cancel()

    def measure(self, shapes: Sequence[RotoShape]) -> None:
        """Measure how much shapes boil by the motion of the picture."""
        asked, read = {shape.id: shape for shape in shapes}, self._reading()

        def work(report: Report) -> str:
            # OpenCV loads while the window is up already: that must not delay it.
            from roam_core.review.picture_boil import boil_by_picture

            report.partial(boil_by_picture(read, tuple(asked.values()), report.token, report.progress))
            return tr("Boil is measured by the picture.")

        if self._runner.makes_wait(MEASURING):
            self._tell(MEASURING, 0.0, tr("Boil is measured when what is being written has ended."))
        job = self._runner.start(MEASURING, work)
        job.progress.connect(partial(self._tell, MEASURING))
        job.partial.connect(lambda boil: self.measured.emit(asked, boil))
        job.ended.connect(lambda ending, sentence: self._end(MEASURING, ending, sentence or tr("Stopped measuring.")))

    def _start(self, writing: _Writing) -> None:
        foreign: list[Path] = []

        def work(report: Report) -> str:
            foreign.extend(_foreign(writing))
            return "" if foreign else _write(report, writing)

        def end(ending: Ending, sentence: str) -> None:
            if ending is Ending.DONE and foreign and self._may_overwrite(foreign):
                self._start(replace(writing, overwrites=True))
            elif ending is Ending.DONE and foreign:
                self._end(WRITING, Ending.CANCELLED, tr("Nothing was written; the files that are there stay."))
            else:
                stopped = sentence or tr("Stopped; pictures that are finished stay.")
                self._end(WRITING, ending, stopped if ending is Ending.CANCELLED else sentence)
                if ending is Ending.DONE:
                    self.written.emit(writing.request.path)

        job = self._runner.start(WRITING, work)
        job.progress.connect(partial(self._tell, WRITING))
        job.ended.connect(end)

    def _tell(self, kind: str, fraction: float, text: str) -> None:
        self.is_told_of_writing = kind == WRITING
        self.progress.emit(fraction, text)

    def _end(self, kind: str, ending: Ending, sentence: str) -> None:
        self.is_told_of_writing = kind == WRITING
        self.finished.emit(ending, sentence)


@dataclass(frozen=True)
class _Writing:
    """What is asked for; `file` is the project's own, `read` reads its plate."""

    request: ReviewRequest
    file: Path | None
    read: ReadFrame
    overwrites: bool = False


def _foreign(writing: _Writing) -> tuple[Path, ...]:
    """The files that the artist must be asked about; `RoamError` for what is never written over."""
    from roam_core.interchange.targets import Sources, obstacles

    own = () if writing.file is None else (writing.file,)
    found = obstacles(writing.request.targets(), Sources.of_clip(writing.request.project.clip, *own))
    found.refuse_always()
    return () if writing.overwrites else found.foreign


def _write(report: Report, writing: _Writing) -> str:
    """The work, on the worker thread."""
    from roam_core.review.writing import write_review

    report.progress(0.0, tr("Writing {name} …", name=writing.request.path.name))
    return translated(write_review(writing.request, writing.read, report.token, report.progress))
