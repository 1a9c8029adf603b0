"""Imports as a job: shapes of a file or of a text are read on the worker, then put on top as one undo step."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from roam_core.roto import Clip, edit

from ..model.document import Document
from ..model.reasons import outdated_by
from ..translation import tr, translated
from .runner import Ending, Job, Report, Runner

if TYPE_CHECKING:
    from roam_core.interchange import Imported, ImportOptions, MaskOptions


_numbers = itertools.count(1)


class Import(QObject):
    """Reads shapes in the formats of `roam_core.interchange`, one file or text after the other.

    Signals
    -------
    progress(fraction, text), finished(ending, sentence) : the job's news.
    came_in(ids) : layers and shapes were put in, with these ids (a frozenset); before `finished`.
    """

    progress = Signal(float, str)
    finished = Signal(object, str)
    came_in = Signal(object)

    def __init__(self, document: Document, runner: Runner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document, self._runner = document, runner
        self._jobs: list[Job] = []
        """What is being read, and what waits for that."""
        document.replaced.connect(self.stop)

    def start(self, path: Path, masks: MaskOptions | None = None) -> None:
        """Read a file of shapes, or a folder of masks as `masks` say, into the project's clip."""

        def read(clip: Clip, options: ImportOptions) -> Imported:
            from roam_core.interchange import read_shapes

            return read_shapes(path, clip, options if masks is None else replace(options, masks=masks))

        self._start(path.name, read, tr("Import shapes"))

    def paste(self, text: str) -> None:
        """Read a text of another program, or of our own files of shapes, into the project's clip."""

        def read(clip: Clip, options: ImportOptions) -> Imported:
            from roam_core.interchange.clipboard import read_text

            return read_text(text, clip, options)

        self._start(tr("the clipboard"), read, tr("Paste"))

    def _start(self, name: str, read: Callable[[Clip, ImportOptions], Imported], step: str) -> None:
        project = self._document.project

        def work(report: Report) -> str:
            from roam_core.interchange import ImportOptions

            report.progress(0.0, tr("Reading {name} …", name=name))
            imported = read(project.require_clip(), ImportOptions(progress=report.progress, token=report.token))
            count = sum(1 for _ in imported.layer.shapes())
            if count:
                report.partial(imported)
            return " ".join(
                [
                    tr("Read {shapes} from {name}.", shapes=tr("%n shape(s)", "", count), name=name),
                    *map(translated, imported.notes),
                ]
            )

        outdated: list[str] = []

        def end(ending: Ending, sentence: str) -> None:
            self._jobs.remove(job)
            told = " ".join(filter(None, [sentence, *outdated]))
            self.finished.emit(ending, tr("Import stopped.") if ending is Ending.CANCELLED else told)

        # A kind of its own: what is being read comes in, and this one waits for it.
        job = self._runner.start(f"import {next(_numbers)}", work)
        self._jobs.append(job)
        job.progress.connect(self.progress)
        job.partial.connect(lambda imported: outdated.append(self._put_in(step, imported)))
        job.ended.connect(end)

    def stop(self) -> None:
        """Stop reading; nothing is taken of what has not come in."""
        for job in list(self._jobs):
            job.drop()

    def _put_in(self, step: str, imported: Imported) -> str:
        """Put what was read on top of the project; gives the sentence of what it made out of date."""
        before = self._document.project
        project, ids = edit.add_items(before, imported.layer.children)
        self._document.apply(step, project)
        self.came_in.emit(frozenset(ids))
        return outdated_by(before, project)
