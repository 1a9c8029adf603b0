"""Exports as a job: a snapshot of the project is written on the worker, while the artist goes on."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from roam_core.roto import Project
from roam_core.roto.layers import only

from ..model.document import Document
from ..translation import tr, translated
from .runner import Ending, Job, Report, Runner

if TYPE_CHECKING:
    from roam_core.interchange import ExportOptions


MATTES = "mattes"
"""The name of the format whose files are pictures: it is written to a folder, and knows nothing of fewer keys."""
_numbers = itertools.count(1)


class Export(QObject):
    """Writes shapes and mattes in the formats of `roam_core.interchange`, one export after the other.

    `current` is the number, as `start` gave it, of the export that a signal tells of.

    Signals
    -------
    progress(fraction, text), finished(ending, sentence) : the job's news.
    noted(sentences) : a tuple: where it was written to, and what the format cannot hold and was left out or changed;
        before `finished`.
    written(path) : an export was made as a whole, to the file or folder that was asked for.
    failed(request, sentence) : one could not be made, and why; `finished` tells that, too. `again` takes the request.

    What the project is made of (plate, project file) is never written over. Files that ROAM did not make are, if
    `may_overwrite(paths)` says so: the artist, who is asked before anything is written. So is `may_lose(losses)` where
    the mattes would differ in the other program and the options do not say that this was seen (`lossy`).
    """

    progress = Signal(float, str)
    finished = Signal(object, str)
    noted = Signal(object)
    written = Signal(object)
    failed = Signal(object, str)

    def __init__(
        self,
        document: Document,
        runner: Runner,
        parent: QObject | None = None,
        may_overwrite: Callable[[Sequence[Path]], bool] = lambda _: False,
        may_lose: Callable[[Sequence[str]], bool] = lambda _: False,
    ) -> None:
        super().__init__(parent)
        self._document, self._runner = document, runner
        self._may_overwrite, self._may_lose = may_overwrite, may_lose
        self._jobs: dict[Job, int] = {}
        """What is being written, and what waits for that, with their numbers."""
        self._begun: Job | None = None
        """The one that is being written."""
        self.current = 0

    @property
    def runner(self) -> Runner:
        """Where exports are made, and where what they would lose is found out."""
        return self._runner

    def start(
        self,
        format_name: str,
        path: Path,
        options: ExportOptions | None = None,
        shapes: Collection[str] | None = None,
    ) -> int:
        """Write the project as it is now to `path` (a file, or for mattes a folder) in the format of that name.

        Of the shapes only those of the ids `shapes`, all for None. Waits for the exports before it. Gives its number.
        """
        project, file, number = self._document.project, self._document.path, next(_numbers)
        self._start(Request(number, only(project, shapes), file, format_name, path, options))
        return number

    def again(self, request: Request, path: Path | None = None) -> int:
        """Write what was asked for, as the project was then, to the same place or another; gives its new number.

        What the artist has answered about its files holds for the same place, about its losses anywhere.
        """
        request = replace(request, number=next(_numbers))
        if path is not None:
            request = replace(request, path=path, overwrites=False)
        self._start(request)
        return request.number

    def _start(self, request: Request) -> None:
        foreign: list[Path] = []
        losses: list[str] = []

        def work(report: Report) -> str:
            from roam_core.interchange.protocol import LossyExport

            foreign.extend(_foreign(request))
            if foreign:
                return ""
            try:
                return _export(report, request)
            except LossyExport as refusal:
                losses.extend(refusal.losses)
                return ""

        def end(ending: Ending, sentence: str) -> None:
            del self._jobs[job]
            is_asked = ending is Ending.DONE and bool(foreign or losses)
            if is_asked and foreign and self._may_overwrite(foreign):
                self._start(replace(request, overwrites=True))
            elif is_asked and losses and self._may_lose(losses):
                self._start(replace(request, loses=True))
            else:
                self.current = request.number  # others may have been told of while the artist was asked
                if is_asked:
                    ending, sentence = Ending.CANCELLED, tr("Nothing was exported; the files that are there stay.")
                self._end(ending, sentence)
                if ending is Ending.DONE:
                    self.written.emit(request.path)
                elif ending is Ending.FAILED:
                    self.failed.emit(request, sentence)

        def begin() -> None:
            self._begun = job

        def tell(fraction: float, text: str) -> None:
            self.current = request.number
            self.progress.emit(fraction, text)

        def note(losses: object) -> None:
            self.current = request.number
            self.noted.emit(losses)

        # A kind of its own: what is being written goes on, and this one waits for it.
        job = self._runner.start(f"export {next(_numbers)}", work)
        self._jobs[job] = request.number
        job.started.connect(begin)
        job.progress.connect(tell)
        job.partial.connect(note)
        job.ended.connect(end)

    @property
    def is_writing(self) -> bool:
        return bool(self._jobs)

    def stop(self, number: int | None = None) -> None:
        """Stop the export of that number, all for None; files that are written whole stay."""
        for job, own in list(self._jobs.items()):
            if number in (None, own):
                if job is self._begun:
                    job.cancel()
                else:
                    job.drop()  # what waits need not wait for that, too

    def _end(self, ending: Ending, sentence: str) -> None:
        stopped = sentence or tr("Export stopped; the files that are finished stay.")
        self.finished.emit(ending, stopped if ending is Ending.CANCELLED else sentence)


@dataclass(frozen=True)
class Request:
    """A snapshot of everything that is asked for; `file` is the project's own."""

    number: int
    project: Project
    file: Path | None
    format_name: str
    path: Path
    options: ExportOptions | None
    overwrites: bool = False
    loses: bool = False

    @property
    def is_folder(self) -> bool:
        """Whether `path` is a folder of pictures."""
        return self.format_name == MATTES


def _foreign(request: Request) -> tuple[Path, ...]:
    """The files that the artist must be asked about; `RoamError` for what is never written over."""
    from roam_core.interchange import EXPORTERS, ExportOptions
    from roam_core.interchange.targets import Sources, exported, obstacles

    project, own = request.project, () if request.file is None else (request.file,)
    targets = exported(EXPORTERS[request.format_name], project, request.path, request.options or ExportOptions())
    found = obstacles(targets, Sources.of_clip(project.clip, *own))
    found.refuse_always()
    return () if request.overwrites else found.foreign


def _export(report: Report, request: Request) -> str:
    """The work, on the worker thread."""
    from roam_core.interchange import EXPORTERS, ExportOptions

    path = request.path
    report.progress(0.0, tr("Exporting to {name} …", name=path.name))
    options = request.options or ExportOptions()
    lossy = options.lossy or request.loses
    used = replace(options, lossy=lossy, progress=report.progress, token=report.token)
    losses = EXPORTERS[request.format_name].export(request.project, path, used)
    told = _written(request, options), *map(translated, losses)
    report.partial(told)
    return " ".join(told)


def _written(request: Request, options: ExportOptions) -> str:
    """Where it was written to: formats of one shape a file write beside the name that was chosen."""
    from roam_core.interchange import EXPORTERS
    from roam_core.interchange.targets import exported

    path, others = request.path, 0
    if not request.is_folder:
        (path, _), *more = exported(EXPORTERS[request.format_name], request.project, path, options)
        others = len(more)
    if others:
        return tr("Exported to {path} and %n other file(s) beside it.", "", others, path=path)
    return tr("Exported to {path}.", path=path)
