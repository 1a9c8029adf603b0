"""Opening and saving: what the File menu, drops on the window and the command line do to document and plate."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Signal

from roam_core.errors import RoamError
from roam_core.media.colour_spaces import config_trouble
from roam_core.media.unseen import unseen
from roam_core.propagate.shapes.departed import departed_settings
from roam_core.roto import Clip, Project, backups, file, project_lock
from roam_core.roto.fingerprint import Fingerprint
from roam_core.roto.project_lock import Holder
from roam_core.roto.relinking import is_renumbered

from ..jobs.decode import PlateReader
from ..jobs.found_clip import looked_at
from ..jobs.runner import Ending, Report, Runner, Work
from ..journal import recovery
from ..journal.recovery import Recovery
from ..model.document import PROJECT_SUFFIX, Document
from ..model.preferences import Preferences
from ..model.view_state import ViewState
from ..translation import tr, translated
from .claim import Claim
from .reading import (
    DEMO,
    Found,
    clip_project,
    demo_project,
    gaps_of,
    plate_of,
    read_as,
    read_project,
    read_version,
    reading_work,
    reloaded,
    with_numbers,
)
from .saving import NewVersion, save_new_version, save_onto
from .watching import Watching, doubt

if TYPE_CHECKING:
    from roam_core.media import PlateSource


class Files(QObject):
    """Reads and writes on the worker; the document changes when that is done.

    Signals
    -------
    progress(fraction, text), finished(ending, sentence) : news for the status bar.
    saving(path) : the document is about to be written to a file.
    saved() : the document was written to its file.
    not_saved(path, sentence, again) : it could not be written, and why, as `finished` tells, too; `again()` retries.
    doubted(path, doubt) : it was not written, because the file is not as it was left: the sentence says why.
    overtaken(show) : what was opened has come, but the document was changed meanwhile and not saved: it takes the
        document's place when `show` is called.
    contested(path, holder) : a project was not opened, because the `Holder` has it open.
    opened(path) : the project or clip that the artist named is open. demo_opened() : the demo is.
    renumbered(before) : the plate that was relinked, or opened with its project, has the pictures of the clip `before`
        under other numbers; the keys are on the frames on which they were.
    looked(found) : the clip that `look_at` was asked about, as a `FoundClip`.
    """

    progress = Signal(float, str)
    finished = Signal(object, str)
    saving = Signal(object)
    saved = Signal()
    not_saved = Signal(object, str, object)
    doubted = Signal(object, str)
    overtaken = Signal(object)
    contested = Signal(object, object)
    opened = Signal(object)
    demo_opened = Signal()
    looked = Signal(object)
    renumbered = Signal(object)

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        reader: PlateReader,
        runner: Runner,
        saver: Runner,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._document, self._view, self._reader, self._runner = document, view_state, reader, runner
        self._saver = saver
        """Only saves: none of them waits behind an export."""
        self.claim, self.watching = Claim(document, saver, self), Watching(document, saver, self)
        self.backups = Preferences().backups
        """How many older versions of a project are kept beside it."""
        self._written: Fingerprint | None = None
        self.version = NewVersion(document)
        self._last: Project | None = None
        """What was written last; the document may not know yet."""

    def new(self) -> None:
        """Begin an empty project; what was being opened is wanted no more."""
        if (job := self._runner.running("open")) is not None:
            job.drop()
        self._show(Found(Project(), None, ""))
        self._view.say("")  # what was said is of the project before, as that its track was stopped

    def open(self, path: Path) -> None:
        """Open a project file, an earlier version of one as a copy, or a clip as a new project."""
        if path.suffix.lower() == PROJECT_SUFFIX:
            self.open_project(path)
        elif backups.is_named_as_backup(path):
            self.open_copy(path)
        else:
            self.open_clip(path)

    def look_at(self, path: Path, layer: str = "", held: Clip | None = None) -> None:
        """Find out about a clip without opening it: about one of its layers, or the one that is found.

        `held` is the project's clip where it is that one.
        """

        def work(report: Report) -> str:
            report.progress(0.0, tr("Looking at {name} …", name=path.name))
            found = looked_at(path, layer, held)
            report.token.check()
            report.partial(found)
            return translated(config_trouble())

        job = self._runner.start("look", work)
        job.progress.connect(self.progress)
        job.partial.connect(self.looked)
        job.ended.connect(self.finished)

    def open_clip(
        self, path: Path, declare: Callable[[PlateSource], PlateSource] | None = None, layer: str = ""
    ) -> None:
        """Begin a project on a folder of images, a pattern, an image of a sequence, or a movie.

        `declare` gives the plate what the artist says of it against its files; `layer` is the one that was chosen.
        """

        def read() -> Found:
            project, source = clip_project(path, declare, layer)
            sentence = tr(
                "Opened {name}: {count} frames. {gaps}", name=path.name, count=len(source.frames), gaps=gaps_of(source)
            ).rstrip()
            told = (sentence, translated(unseen(source)), translated(config_trouble()))
            return Found(project, source, " ".join(filter(None, told)))

        self._open(tr("Opening {name} …", name=path.name), read, origin=path)

    @property
    def lacks_plate(self) -> bool:
        """True when the project has a clip that could not be opened."""
        return self._document.project.clip is not None and self._reader.source is None

    @property
    def plate(self) -> PlateSource | None:
        """The plate that is open."""
        return self._reader.source

    def open_plate(self, path: Path) -> None:
        """Give the project its plate, which lies elsewhere now, or another version of it.

        Its shapes stay, those drawn meanwhile, too, and so do frame and selection, the layer, where the files have it,
        and what the artist declared of the plate before. The project is to be saved.
        """
        project, before, sitting = self._document.project, self._reader.source, self._document.sitting
        work = reading_work(tr("Opening {name} …", name=path.name), lambda: read_version(project, before, path))
        self._start(work, lambda found: self._relink(found, sitting))

    def reload_plate(self) -> None:
        """Read the pictures of the project's plate anew, and take those that were written since it was opened."""
        project, sitting = self._document.project, self._document.sitting
        if project.clip is None:
            self._view.say(tr("There is no clip yet; open one."))
            return

        def take(found: Found) -> None:
            if found.is_unsaved:
                self._relink(found, sitting)
            elif sitting == self._document.sitting:
                self._reader.open(found.source)

        work = reading_work(tr("Opening {name} …", name=project.clip.name), lambda: reloaded(project))
        self._start(work, take)

    def read_plate_as(self, layer: str, declare: Callable[[PlateSource], PlateSource]) -> None:
        """Take another layer of the project's plate, or what the artist declares of it, from now on.

        All else stays. The project is to be saved where anything changed.
        """
        project, sitting = self._document.project, self._document.sitting

        def take(found: Found | Holder) -> None:
            if isinstance(found, Found) and found.project.clip != project.clip:
                self._relink(found, sitting)

        name = project.require_clip().name
        self._start(reading_work(tr("Opening {name} …", name=name), lambda: read_as(project, layer, declare)), take)

    def open_project(self, path: Path) -> None:
        """Open a project and its plate; without its plate it opens too, and says so.

        Where somebody else has it open nothing is opened: `contested` tells who.
        """

        def read() -> Found | Holder:
            return project_lock.holder(path) or read_project(path)

        self._open(tr("Opening {name} …", name=path.name), read, origin=path)

    def open_anyway(self, path: Path) -> None:
        """Open a project that somebody else has open, as if they had not."""
        self.claim.insist_on(path)
        self._open(tr("Opening {name} …", name=path.name), lambda: read_project(path), origin=path)

    def open_copy(self, path: Path) -> None:
        """Open what a project file holds as a new project, which has no file yet."""

        def read() -> Found:
            found = read_project(path)
            first = tr("A copy of {name}; save to keep it.", name=path.name)
            sentence = " ".join(filter(None, (first, translated(departed_settings(found.project.shapes)))))
            return Found(found.project, found.source, sentence, is_unsaved=True, before=found.before)

        self._open(tr("Opening {name} …", name=path.name), read)

    def open_demo(self) -> None:
        """Render the demo shot, if it is not there yet, and open it with its true outline as the first key."""

        def work(report: Report) -> str:
            project, source = demo_project(report)
            report.partial(Found(project, source, tr(DEMO)))
            return tr(DEMO)

        self._replace_by(work, then=self.demo_opened.emit)

    def open_recovered(self, found: Recovery) -> None:
        """Open what a journal holds, as unsaved changes of the artist's own file."""

        def read() -> Found:
            project, loss = recovery.load(found)
            source, problem = plate_of(project)
            first = " ".join(filter(None, (loss, problem))) or tr("Recovered; save to keep it.")
            project, before, numbers = with_numbers(project, source)
            sentence = " ".join(filter(None, (first, numbers, translated(departed_settings(project.shapes)))))
            return Found(
                project,
                source,
                sentence,
                found.original,
                found.fingerprint,
                is_unsaved=True,
                follows=found.journal,
                before=before,
            )

        self._open(tr("Recovering …"), read)

    def save(self, path: Path, *, anyway: bool = False) -> None:
        """Write the project as it is now; the artist goes on meanwhile.

        Where the file was changed, or is open elsewhere, nothing is written unless `anyway`: `doubted` tells.
        """
        document, kept = self._document, self.backups
        project, known = document.project, document.fingerprint if path == document.path else None
        is_modified = document.is_modified
        self.version.note_saved_onto(is_modified=is_modified)
        self.saving.emit(path)

        def work(report: Report) -> str:
            against = "" if anyway else doubt(path, known, self._written)
            if against:
                report.partial(against)
                return ""
            # What is written over against a warning is kept in any case.
            # Saved again as it is, it takes no backup away.
            is_there = (project is self._last or not is_modified) and file.is_saved(project, path)
            try:
                sentence = save_onto(project, path, 0 if is_there else max(kept, 1) if anyway else kept)
            except RoamError:
                if file.is_saved(project, path):  # it stands there, though the disk may not keep it
                    self._last, self._written = project, Fingerprint.of(path)
                raise
            self.claim.renew(path)
            self._last, self._written = project, Fingerprint.of(path)
            report.partial(self._written)
            return sentence

        self._save(work, path, again=lambda: self.save(path))

    def save_new_version(self, own: Path) -> None:
        """Write the project under the next version number beside `own`, over nothing; that becomes its file."""
        project, sitting = self._document.project, self._document.sitting
        self.version.is_begun = True

        def work(report: Report) -> str:
            path, sentence = save_new_version(project, own, report)
            self.version.note_made(path, sitting)
            self._last, self._written = project, Fingerprint.of(path)
            report.partial(self._written)
            return sentence

        self._save(work, own, again=lambda: self.save_new_version(own))

    @property
    def is_saving(self) -> bool:
        return self._saver.running("save") is not None

    @property
    def is_opening(self) -> bool:
        return self._runner.running("open") is not None

    def stop(self) -> None:
        """Stop opening; a save is never stopped."""
        for kind in ("open", "look"):
            if (job := self._runner.running(kind)) is not None:
                job.cancel()

    # ---- the rest is private

    def _save(self, work: Work, path: Path, again: Callable[[], None]) -> None:
        """Save on the worker, to `path` unless the work tells another; `again` does the same once more."""
        document, sitting, project = self._document, self._document.sitting, self._document.project
        last: str | Fingerprint | None = None

        def take(told: str | Path | Fingerprint) -> None:
            nonlocal last, path
            if isinstance(told, Path):
                path = told
                self.saving.emit(path)
            else:
                last = told

        def end(ending: Ending, sentence: str) -> None:
            if isinstance(last, str):
                self.finished.emit(Ending.CANCELLED, tr("{name} is not saved yet.", name=path.name))
                self.doubted.emit(path, last)
            elif ending is Ending.DONE and sitting == document.sitting:
                document.mark_saved(project, path, last)
                self.saved.emit()
            elif ending is Ending.FAILED:
                self.not_saved.emit(path, sentence, again)
            if not isinstance(last, str):
                self.finished.emit(ending, sentence)

        job = self._saver.start("save", work)
        job.partial.connect(take)
        job.ended.connect(end)

    def _open(self, text: str, read: Callable[[], Found | Holder], *, origin: Path | None = None) -> None:
        """Read on the worker and show what comes; `origin` is what `opened` tells afterwards."""
        self._replace_by(reading_work(text, read), origin, None if origin is None else lambda: self.opened.emit(origin))

    def _replace_by(self, work: Work, origin: Path | None = None, then: Callable[[], object] | None = None) -> None:
        """Let what `work` finds take the document's place, which the artist agreed to leave as it is now; `then` tells.

        What they do until it comes is theirs to decide about again.
        """
        left, was_drawing = self._document.project, self._view.is_in_use

        def take(found: Found | Holder) -> Callable[[], object] | None:
            draws = self._view.is_in_use and not was_drawing
            if not draws and (not self._document.is_modified or self._document.project is left):
                self._take(found, origin, then)
                return None
            return lambda: self._take(found, origin, then)

        self._start(work, take)

    def _start(self, work: Work, take: Callable[[Any], Callable[[], object] | None]) -> None:
        """Open on the worker; `take` gets what was found, and gives what is to be asked about first, if anything."""
        waiting: list[Callable[[], object]] = []

        def arrive(found: Found | Holder) -> None:
            if (show := take(found)) is not None:
                waiting.append(show)

        def end(ending: Ending, sentence: str) -> None:
            if not waiting:
                self.finished.emit(ending, sentence)
                return

            def show() -> None:
                waiting[-1]()
                self.finished.emit(ending, sentence)

            self.finished.emit(Ending.CANCELLED, tr("The project was changed meanwhile; nothing was opened."))
            if ending is Ending.DONE:
                self.overtaken.emit(show)

        job = self._runner.start("open", work)
        job.progress.connect(self.progress)
        job.partial.connect(arrive)
        job.ended.connect(end)

    def _take(self, found: Found | Holder, origin: Path | None, then: Callable[[], object] | None) -> None:
        if isinstance(found, Holder):
            self.contested.emit(origin, found)
            return
        self._show(found)
        if then is not None:
            then()
        if found.before is not None:
            self.renumbered.emit(found.before)

    def _relink(self, found: Found, sitting: int) -> None:
        """Give the project, as it is now, the clip that was found; not another one that was opened since.

        In and out stay as far as the clip has their frames; where they were its ends they are those of the new one.
        With pictures that are numbered anew they go along, and so does the playhead.
        """
        if sitting != self._document.sitting:
            return
        view, clip = self._view, found.project.require_clip()
        if view.is_in_use:
            view.set_tool("select")  # a shape that is half drawn is finished: with another clip it would be dropped
        frame, selection, layers = view.frame, view.selection, view.layers
        replaced = self._document.project.require_clip()
        before, (first, stop) = replaced.frame_range, view.play_range
        offset = clip.first - replaced.first if is_renumbered(replaced, clip) else 0
        self._reader.open(None)
        self._document.relink(clip)
        view.set_play_range(
            clip.first if first == before.start else max(first + offset, clip.first),
            clip.last + 1 if stop == before.stop else min(stop + offset, clip.last + 1),
        )
        view.set_frame(min(max(frame + offset, clip.first), clip.last))
        view.select(selection.shapes, selection.points, layers)
        self._reader.open(found.source)
        if offset:
            self.renumbered.emit(replaced)

    def _show(self, found: Found) -> None:
        # The old plate goes first and the new one comes last: no frame is ever asked of the wrong one.
        self._reader.open(None)
        if found.is_unsaved:
            self._document.recover(found.project, found.path, found.fingerprint, found.follows)
        else:
            self._document.open(found.project, found.path, found.fingerprint)
        # One of several would be tracked without the others; with none in hand all are.
        shapes = found.project.shapes
        self._view.select(frozenset(shape.id for shape in shapes) if len(shapes) == 1 else frozenset())
        self._reader.open(found.source)
