"""PictureWork: what drawing tools want found in the picture that is shown, off the window's thread."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from PySide6.QtCore import QObject, Signal

from roam_core.arrays import UInt8

from ..translation import tr
from .runner import Ending, Job, Report, Runner

Spot = tuple[float, float]


@dataclass(frozen=True, eq=False)
class Shown:
    """The picture of `frame`: `pixels (h, w, 3)` uint8 as on the screen, whole where that shows a proxy."""

    frame: int
    pixels: UInt8

    def scale(self, size: tuple[int, int]) -> Spot:
        """The size of one of its pixels in those of a plate of `size` (width, height)."""
        height, width = self.pixels.shape[:2]
        return size[0] / width, size[1] / height


class PictureWork(QObject):
    """Keeps the picture that is shown, and looks at it on a worker.

    `full_of` gives the whole picture of a frame for what is on the screen of it, which may be a proxy; None: not yet.

    Signals
    -------
    progress(fraction, text), finished(ending, sentence) : news of work that says what it does.
    looked() : something was found, or the looking is over.
    """

    progress = Signal(float, str)
    finished = Signal(object, str)
    looked = Signal()

    def __init__(
        self,
        runner: Runner,
        parent: QObject | None = None,
        full_of: Callable[[int, UInt8], UInt8 | None] = lambda _, pixels: pixels,
    ) -> None:
        super().__init__(parent)
        self._runner = runner
        self._jobs: set[Job] = set()
        self._shown: Shown | None = None
        self._full_of = full_of

    @property
    def shown(self) -> Shown | None:
        """The picture that is on the screen, in the plate's own size: a proxy changes nothing that is found."""
        if self._shown is not None and (full := self._full_of(self._shown.frame, self._shown.pixels)) is not None:
            self._shown = self._shown if full is self._shown.pixels else Shown(self._shown.frame, full)
            return self._shown
        return None

    def show(self, frame: int, pixels: UInt8 | None) -> None:
        """The picture of `frame` is on the screen; None where the plate has none."""
        self._shown = None if pixels is None else Shown(frame, pixels)

    def clear(self) -> None:
        """Another plate is opened: nothing that was looked for in the old one arrives."""
        self._shown = None
        self.stop()

    def find(
        self,
        kind: str,
        look: Callable[[Report], Any],
        take: Callable[[Any], object],
        *,
        ended: Callable[[Ending, str], object] | None = None,
    ) -> Job:
        """Call `look` on the worker and give what it found to `take`, on the window's thread.

        Work of the same `kind` that is not done is dropped. With `ended` it is long work: its progress and its end are
        told, and `ended` hears how it ended.
        """

        def work(report: Report) -> str:
            report.partial(look(report))
            return ""

        job = self._runner.start(kind, work)
        self._jobs.add(job)
        job.partial.connect(take)
        if ended is not None:
            job.progress.connect(self.progress)
        job.ended.connect(lambda ending, sentence: self._end(job, ending, sentence, ended))
        return job

    def stop(self) -> None:
        """Drop all that is looked for."""
        for job in list(self._jobs):
            job.drop()

    def _end(self, job: Job, ending: Ending, sentence: str, ended: Callable[[Ending, str], object] | None) -> None:
        self._jobs.discard(job)
        if ended is not None:
            self.finished.emit(ending, tr("Stopped.") if ending is Ending.CANCELLED else sentence)
            ended(ending, sentence)
        self.looked.emit()
