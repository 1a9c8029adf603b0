"""Opening and saving: what the File menu, drops on the window and the command line do to document and plate."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Signal

from app.document import Document
from app.jobs.decode import PlateReader
from app.jobs.runner import Ending, Report, Runner, Work
from app.view_state import ViewState
from roam_core.errors import RoamError
from roam_core.roto import Clip, Project, edit, file
from roam_core.roto.relinking import other_content, other_size, relinked

if TYPE_CHECKING:
    from roam_core.media import PlateSource

DEMO = "The demo shot: press <track.forward> to track the shape, <track.stop> to stop; drag its points to correct it."
PROJECT_SUFFIX = ".roam"


class Files(QObject):
    """Reads and writes on the worker; the document changes when that is done.

    Signals
    -------
    progress(fraction, text), finished(ending, sentence) : news for the status bar.
    saved() : the document was written to its file.
    opened(path) : the project or clip that the artist named is open.
    looked(found) : the clip that `look_at` was asked about, as a `FoundClip`.
    """

    progress = Signal(float, str)
    finished = Signal(object, str)
    saved = Signal()
    opened = Signal(object)
    looked = Signal(object)

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        reader: PlateReader,
        runner: Runner,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._document, self._view, self._reader, self._runner = document, view_state, reader, runner

    def new(self) -> None:
        """Begin an empty project; what was being opened is wanted no more."""
        if (job := self._runner.running("open")) is not None:
            job.drop()
        self._show(Project(), None, None, False)

    def open(self, path: Path) -> None:
        """Open a project file, or a clip as a new project."""
        if path.suffix.lower() == PROJECT_SUFFIX:
            self.open_project(path)
        else:
            self.open_clip(path)

    def look_at(self, path: Path) -> None:
        """Find out about a clip without opening it."""

        def work(report: Report) -> str:
            from app.clip_dialog import looked_at

            report.progress(0.0, f"Looking at {path.name} …")
            report.partial(looked_at(path))
            return ""

        job = self._runner.start("look", work)
        job.progress.connect(self.progress)
        job.partial.connect(self.looked)
        job.ended.connect(self.finished)

    def open_clip(self, path: Path, declare: Callable[[PlateSource], PlateSource] | None = None) -> None:
        """Begin a project on a folder of images, a pattern, an image of a sequence, or a movie.

        `declare` gives the plate what the artist says of it against its files.
        """

        def read() -> tuple[Project, Any, str]:
            project, source = clip_project(path, declare)
            return project, source, f"Opened {path.name}: {len(source.frames)} frames. {_gaps(source)}".rstrip()

        self._open(f"Opening {path.name} …", read, None, origin=path)

    @property
    def lacks_plate(self) -> bool:
        """True when the project has a clip that could not be opened."""
        return self._document.project.clip is not None and self._reader.source is None

    @property
    def plate(self) -> PlateSource | None:
        """The plate that is open."""
        return self._reader.source

    def open_plate(self, path: Path) -> None:
        """Give the project its plate, which lies elsewhere now; its shapes stay, and it is to be saved."""
        project = self._document.project

        def read() -> tuple[Project, Any, str]:
            found, source = clip_project(path)
            said = _differences(project, source) or f"The plate is {path.name} now; save to keep that."
            return replace(project, clip=found.clip), source, said

        self._open(f"Opening {path.name} …", read, self._document.path, is_unsaved=True)

    def open_project(self, path: Path) -> None:
        """Open a project and its plate; without its plate it opens too, and says so."""
        self._open(f"Opening {path.name} …", lambda: _read_project(path), path, origin=path)

    def open_demo(self) -> None:
        """Render the demo shot, if it is not there yet, and open it with its true outline as the first key."""

        def work(report: Report) -> str:
            project, source = _demo_project(report)
            report.partial((project, source))
            return DEMO

        self._start(work, None)

    def open_recovered(self, read: Callable[[], Project], original: Path | None) -> None:
        """Open an autosaved project as unsaved changes of the artist's own file."""

        def recovered() -> tuple[Project, Any, str]:
            project = read()
            source, problem = _plate_of(project)
            return project, source, problem or "Recovered; save to keep it."

        self._open("Recovering …", recovered, original, is_unsaved=True)

    def save(self, path: Path) -> None:
        """Write the project as it is now; the artist goes on meanwhile."""
        project = self._document.project

        def work(report: Report) -> str:
            file.save(project, path)
            return f"Saved {path.name}."

        job = self._runner.start("save", work)
        job.ended.connect(lambda ending, sentence: self._saved(ending, sentence, project, path))

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
        read: Callable[[], tuple[Project, Any, str]],
        path: Path | None,
        *,
        is_unsaved: bool = False,
        origin: Path | None = None,
    ) -> None:
        """Read on the worker and show what comes; `origin` is what `opened` tells afterwards."""

        def work(report: Report) -> str:
            report.progress(0.0, text)
            project, source, sentence = read()
            report.partial((project, source))
            return sentence

        self._start(work, path, is_unsaved=is_unsaved, origin=origin)

    def _start(self, work: Work, path: Path | None, *, is_unsaved: bool = False, origin: Path | None = None) -> None:
        job = self._runner.start("open", work)
        job.progress.connect(self.progress)
        job.partial.connect(lambda found: self._show(found[0], found[1], path, is_unsaved))
        if origin is not None:
            job.partial.connect(lambda _: self.opened.emit(origin))
        job.ended.connect(self.finished)

    def _show(self, project: Project, source: Any, path: Path | None, is_unsaved: bool) -> None:
        # The old plate goes first and the new one comes last: no frame is ever asked of the wrong one.
        self._reader.open(None)
        if is_unsaved:
            self._document.recover(project, path)
        else:
            self._document.open(project, path)
        self._view.select(frozenset(shape.id for shape in project.shapes[-1:]))
        self._reader.open(source)

    def _saved(self, ending: Ending, sentence: str, project: Project, path: Path) -> None:
        if ending is Ending.DONE:
            self._document.mark_saved(project, path)
            self.saved.emit()
        self.finished.emit(ending, sentence)


def clip_project(
    path: Path, declare: Callable[[PlateSource], PlateSource] | None = None
) -> tuple[Project, PlateSource]:
    """A new project on a clip, and the clip's source. Raises `RoamError` when there is no clip at `path`."""
    from roam_core.media import open_clip

    source = open_clip(path)
    if declare is not None:
        source = declare(source)
    return Project(Clip.of(source)), source


def _demo_project(report: Report) -> tuple[Project, Any]:
    from app.folders import cache_folder
    from resources import demo

    folder = cache_folder() / demo.cache_name()
    try:
        demo.write_frames(folder, lambda fraction, text: report.progress(fraction, f"{text.capitalize()} …"))
    except OSError as error:
        raise RoamError(f"The demo shot cannot be written to {folder}: {error.strerror or error}.") from None
    project, source = clip_project(folder)
    project, _ = edit.new_shape(project, demo.true_points(demo.FIRST), demo.FIRST, name="Manta")
    return project, source


def _read_project(path: Path) -> tuple[Project, Any, str]:
    stored = file.load(path)
    project = relinked(stored, path.parent)
    source, problem = _plate_of(project)
    moved = "" if project is stored else f" Its plate was found at {project.require_clip().path}; save to keep that."
    return project, source, problem or f"Opened {path.name}.{moved}"


def _plate_of(project: Project) -> tuple[Any, str]:
    """The plate of a project, or None and why it could not be opened; or the plate and what differs from before."""
    from roam_core.media import declared, open_clip

    if (clip := project.clip) is None:
        return None, ""
    try:
        source = declared(open_clip(clip.path), clip.colour_space, clip.fps, clip.pixel_aspect)
    except RoamError as error:
        return None, f"The plate could not be opened; choose it again in the File menu. {error}"
    return source, _differences(project, source)


def _differences(project: Project, source: PlateSource) -> str:
    """What tells a plate from the one that the project was made on, as a sentence; "" where nothing does."""
    if project.clip is None:
        return ""
    found = Clip.of(source)
    return other_size(project.clip, found) or other_content(project.clip, found)


def _gaps(source: Any) -> str:
    missing = len(source.missing)
    return f"{missing} frame{'s are' if missing > 1 else ' is'} missing." if missing else ""
