"""Opening and saving: what the File menu, drops on the window and the command line do to document and plate."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Signal

from roam_core.errors import RoamError
from roam_core.interchange.authorship import is_project
from roam_core.propagate.shapes.departed import departed_settings
from roam_core.roto import BlendMode, Clip, Project, backups, edit, file, project_lock
from roam_core.roto.fingerprint import Fingerprint
from roam_core.roto.migrate import UNION_SINCE
from roam_core.roto.project_lock import Holder
from roam_core.roto.relinking import other_content, other_size, relinked

from ..jobs.decode import PlateReader
from ..jobs.found_clip import looked_at
from ..jobs.runner import Ending, Report, Runner, Work
from ..journal import recovery
from ..journal.recovery import Recovery
from ..model.document import PROJECT_SUFFIX, Document
from ..model.preferences import Preferences
from ..model.view_state import ViewState
from ..translation import N_, tr, translated
from .claim import Claim

if TYPE_CHECKING:
    from roam_core.media import PlateSource

DEMO = N_(
    "The demo shot: press <track.forward> to track the shape, <track.stop> to stop; drag its points to correct it."
)
SUMMED = N_(
    "It joins soft edges as older versions did (Plus), so that its mattes stay as they were; "
    "choose Add in the Shape panel where they are to join as in other programs."
)


@dataclass(frozen=True)
class Found:
    """What was opened: the project, its plate or None, and the sentence about it.

    `path` is the file that saving writes to, `fingerprint` that of the file that was read; `follows` is the journal
    that the project was recovered from. It is unsaved work where no file holds it.
    """

    project: Project
    source: Any
    sentence: str
    path: Path | None = None
    fingerprint: Fingerprint | None = None
    is_unsaved: bool = False
    follows: Path | None = None


class Files(QObject):
    """Reads and writes on the worker; the document changes when that is done.

    Signals
    -------
    progress(fraction, text), finished(ending, sentence) : news for the status bar.
    saved() : the document was written to its file.
    not_saved() : it could not be written; the sentence is told by `finished`.
    doubted(path, doubt) : it was not written, because the file is not as it was left: the sentence says why.
    contested(path, holder) : a project was not opened, because the `Holder` has it open.
    opened(path) : the project or clip that the artist named is open.
    looked(found) : the clip that `look_at` was asked about, as a `FoundClip`.
    """

    progress = Signal(float, str)
    finished = Signal(object, str)
    saved = Signal()
    not_saved = Signal()
    doubted = Signal(object, str)
    contested = Signal(object, object)
    opened = Signal(object)
    looked = Signal(object)

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
        self.claim = Claim(document, saver, self)
        self.backups = Preferences().backups
        """How many older versions of a project are kept beside it."""
        self._written: Fingerprint | None = None
        self._sitting = 0
        document.replaced.connect(self._begin_sitting)

    def new(self) -> None:
        """Begin an empty project; what was being opened is wanted no more."""
        if (job := self._runner.running("open")) is not None:
            job.drop()
        self._show(Found(Project(), None, ""))

    def open(self, path: Path) -> None:
        """Open a project file, or a clip as a new project."""
        if path.suffix.lower() == PROJECT_SUFFIX:
            self.open_project(path)
        else:
            self.open_clip(path)

    def look_at(self, path: Path, layer: str = "") -> None:
        """Find out about a clip without opening it: about one of its layers, or the one that is found."""

        def work(report: Report) -> str:
            report.progress(0.0, tr("Looking at {name} …", name=path.name))
            report.partial(looked_at(path, layer))
            return ""

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
                "Opened {name}: {count} frames. {gaps}", name=path.name, count=len(source.frames), gaps=_gaps(source)
            ).rstrip()
            return Found(project, source, sentence)

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

        Its shapes stay, and so do the layer, where the files have it, and what the artist declared of the plate before.
        The project is to be saved.
        """
        project, home, fingerprint = self._document.project, self._document.path, self._document.fingerprint
        before = self._reader.source

        def read() -> Found:
            source = _version_of(project.require_clip(), before, path)
            sentence = _differences(project, source) or tr(
                "The plate is {name} now; save to keep that.", name=source.path.name
            )
            clip = replace(Clip.of(source), extra=project.require_clip().extra)
            return Found(replace(project, clip=clip), source, sentence, home, fingerprint, is_unsaved=True)

        self._open(tr("Opening {name} …", name=path.name), read)

    def open_project(self, path: Path) -> None:
        """Open a project and its plate; without its plate it opens too, and says so.

        Where somebody else has it open nothing is opened: `contested` tells who.
        """

        def read() -> Found | Holder:
            return project_lock.holder(path) or _read_project(path)

        self._open(tr("Opening {name} …", name=path.name), read, origin=path)

    def open_anyway(self, path: Path) -> None:
        """Open a project that somebody else has open, as if they had not."""
        self.claim.insist_on(path)
        self._open(tr("Opening {name} …", name=path.name), lambda: _read_project(path), origin=path)

    def open_copy(self, path: Path) -> None:
        """Open what a project file holds as a new project, which has no file yet."""

        def read() -> Found:
            found = _read_project(path)
            first = tr("A copy of {name}; save to keep it.", name=path.name)
            sentence = " ".join(filter(None, (first, departed_settings(found.project.shapes))))
            return Found(found.project, found.source, sentence, is_unsaved=True)

        self._open(tr("Opening {name} …", name=path.name), read)

    def open_demo(self) -> None:
        """Render the demo shot, if it is not there yet, and open it with its true outline as the first key."""

        def work(report: Report) -> str:
            project, source = _demo_project(report)
            report.partial(Found(project, source, tr(DEMO)))
            return tr(DEMO)

        self._start(work)

    def open_recovered(self, found: Recovery) -> None:
        """Open what a journal holds, as unsaved changes of the artist's own file."""

        def read() -> Found:
            project, loss = recovery.load(found)
            source, problem = plate_of(project)
            first = " ".join(filter(None, (loss, problem))) or tr("Recovered; save to keep it.")
            sentence = " ".join(filter(None, (first, departed_settings(project.shapes))))
            return Found(
                project, source, sentence, found.original, found.fingerprint, is_unsaved=True, follows=found.journal
            )

        self._open(tr("Recovering …"), read)

    def save(self, path: Path, *, anyway: bool = False) -> None:
        """Write the project as it is now; the artist goes on meanwhile.

        Where the file was changed, or is open elsewhere, nothing is written unless `anyway`: `doubted` tells.
        """
        document, kept, sitting = self._document, self.backups, self._sitting
        project, known = document.project, document.fingerprint if path == document.path else None
        told: list[str | Fingerprint | None] = []

        def work(report: Report) -> str:
            doubt = "" if anyway else _doubt(path, known, self._written)
            if doubt:
                report.partial(doubt)
                return ""
            # What is written over against a warning is kept in any case.
            warning = _rotated(path, max(kept, 1) if anyway else kept)
            file.save(project, path)
            self._written = Fingerprint.of(path)
            report.partial(self._written)
            return tr("Saved {name}. {warning}", name=path.name, warning=warning).rstrip()

        def end(ending: Ending, sentence: str) -> None:
            last = told[-1] if told else None
            if isinstance(last, str):
                self.finished.emit(Ending.CANCELLED, tr("{name} is not saved yet.", name=path.name))
                self.doubted.emit(path, last)
            elif ending is Ending.DONE and sitting == self._sitting:
                self._document.mark_saved(project, path, last)
                self.saved.emit()
            elif ending is Ending.FAILED:
                self.not_saved.emit()
            if not isinstance(last, str):
                self.finished.emit(ending, sentence)

        job = self._saver.start("save", work)
        job.partial.connect(told.append)
        job.ended.connect(end)

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

    def _open(
        self,
        text: str,
        read: Callable[[], Found | Holder],
        *,
        origin: Path | None = None,
    ) -> None:
        """Read on the worker and show what comes; `origin` is what `opened` tells afterwards."""

        def work(report: Report) -> str:
            report.progress(0.0, text)
            found = read()
            report.partial(found)
            return found.sentence if isinstance(found, Found) else ""

        self._start(work, origin=origin)

    def _start(self, work: Work, *, origin: Path | None = None) -> None:
        job = self._runner.start("open", work)
        job.progress.connect(self.progress)
        job.partial.connect(lambda found: self._take(found, origin))
        job.ended.connect(self.finished)

    def _take(self, found: Found | Holder, origin: Path | None) -> None:
        if isinstance(found, Holder):
            self.contested.emit(origin, found)
            return
        self._show(found)
        if origin is not None:
            self.opened.emit(origin)

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

    def _begin_sitting(self) -> None:
        """Another project is shown: a save of the one before says nothing about it."""
        self._sitting += 1


def clip_project(
    path: Path, declare: Callable[[PlateSource], PlateSource] | None = None, layer: str = ""
) -> tuple[Project, PlateSource]:
    """A new project on a clip, and the clip's source. Raises `RoamError` when there is no clip at `path`."""
    from roam_core.media import open_clip
    from roam_core.media.colour_spaces import definition_of

    source = open_clip(path, layer)
    if declare is not None:
        source = declare(source)
    definition_of(source.colour_space)  # kept from now on: stamps ask for it in the window's thread
    return Project(Clip.of(source)), source


def _version_of(clip: Clip, before: PlateSource | None, path: Path) -> PlateSource:
    """The plate at `path`, read as the project's `clip` is; what was declared of the plate `before` holds."""
    from roam_core.media import declared, open_clip
    from roam_core.media.declared import DeclaredPlate

    source = open_clip(path)
    if clip.layer in source.layers:
        source = open_clip(path, clip.layer)
    if isinstance(before, DeclaredPlate):
        source = declared(source, clip.colour_space, clip.fps, clip.pixel_aspect)
    return source


def _demo_project(report: Report) -> tuple[Project, Any]:
    from roam_core.installation import demo

    from ..folders import cache_folder

    folder = cache_folder() / demo.cache_name()
    try:

        def tell(fraction: float, text: str) -> None:
            frame = text.rpartition(" ")[2]  # what is rendered says it in English, the number last
            done = tr("The demo shot is rendered …")
            report.progress(
                fraction, tr("Rendering the demo shot, frame {frame} …", frame=frame) if fraction < 1.0 else done
            )

        demo.write_frames(folder, tell)
    except OSError as error:
        raise RoamError(
            tr("The demo shot cannot be written to {folder}: {reason}.", folder=folder, reason=error.strerror or error)
        ) from None
    project, source = clip_project(folder)
    project, _ = edit.new_shape(project, demo.true_points(demo.FIRST), demo.FIRST, name="Manta")
    return project, source


def _read_project(path: Path) -> Found:
    # Before it is read: what is written meanwhile is a change.
    fingerprint = Fingerprint.of(path)
    stored, version = file.load_versioned(path)
    project = relinked(stored, path.parent)
    source, problem = plate_of(project)
    moved = (
        ""
        if project is stored
        else tr(" Its plate was found at {path}; save to keep that.", path=project.require_clip().path)
    )
    more = filter(None, (_older(project, version), departed_settings(project.shapes)))
    sentence = " ".join([problem or tr("Opened {name}.{moved}", name=path.name, moved=moved), *more])
    return Found(project, source, sentence, path, fingerprint)


def _older(project: Project, version: int) -> str:
    """What an artist must know of a project whose file is of an older version; mostly nothing."""
    is_summed = version < UNION_SINCE and any(item.blend is BlendMode.PLUS for item in project.root.items())
    return tr(SUMMED) if is_summed else ""


def _doubt(path: Path, known: Fingerprint | None, written: Fingerprint | None) -> str:
    """Why a file is better not written over; empty where nothing speaks against it.

    `known` is the file as the document knows it, `written` what was written last: the document may not know yet.
    """
    if (other := project_lock.holder(path)) is not None:
        return f"{path.name} is {other.sentence}."
    if known is not None and path.exists() and not any(each and each.is_of(path) for each in (known, written)):
        return tr("{name} was changed by another program since it was opened or saved here.", name=path.name)
    return ""


def _rotated(path: Path, count: int) -> str:
    """Keep older versions of the file; a sentence where that cannot be. It never stands in the way of saving."""
    try:
        backups.rotate(path, count, is_project)
    except RoamError as error:
        return str(error)
    return ""


def plate_of(project: Project) -> tuple[Any, str]:
    """The plate of a project, or None and why it could not be opened; or the plate and what differs from before."""
    from roam_core.media import declared, open_clip
    from roam_core.media.colour_spaces import definition_of

    if (clip := project.clip) is None:
        return None, ""
    definition_of(clip.colour_space)
    try:
        source = declared(open_clip(clip.path, clip.layer), clip.colour_space, clip.fps, clip.pixel_aspect)
    except RoamError as error:
        return None, tr("The plate could not be opened; choose it again in the File menu. {error}", error=error)
    return source, _differences(project, source)


def _differences(project: Project, source: PlateSource) -> str:
    """What tells a plate from the one that the project was made on, as a sentence; "" where nothing does."""
    if project.clip is None:
        return ""
    found = Clip.of(source)
    return translated(other_size(project.clip, found) or other_content(project.clip, found))


def _gaps(source: Any) -> str:
    missing = len(source.missing)
    return tr("%n frame(s) is/are missing.", "", missing) if missing else ""
