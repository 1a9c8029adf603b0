"""What saving a project does on its worker: onto a file, with older versions kept beside it, or as a new version."""

from __future__ import annotations

from pathlib import Path

from roam_core.atomic_write import NameTaken
from roam_core.errors import RoamError
from roam_core.interchange.authorship import is_project
from roam_core.roto import Project, backups, file
from roam_core.roto.version_names import next_version

from ..jobs.runner import Report
from ..model.document import Document
from ..translation import sentence_of, tr


class NewVersion:
    """The new version that was made last, and whether one is begun.

    Attributes
    ----------
    is_begun : whether the last save is that of a new version: while it goes on the project's file is another one in a
        moment.
    """

    def __init__(self, document: Document) -> None:
        self._document = document
        self._made: tuple[Path, int] | None = None  # the file, and in which sitting
        self.is_begun = False

    def note_made(self, path: Path, sitting: int) -> None:
        """A version was written, of the project of a sitting."""
        self._made = path, sitting

    def note_saved_onto(self, *, is_modified: bool) -> None:
        """The project is saved plainly: with changes the file is no longer the version as it was made."""
        self.is_begun = False
        if is_modified:
            self._made = None

    @property
    def is_unchanged(self) -> bool:
        """Whether the project's file is a version that was made since it was opened, and nothing changed."""
        document = self._document
        return self._made == (document.path, document.sitting) and not document.is_modified


def save_onto(project: Project, path: Path, backup_count: int) -> str:
    """Write the project to `path`, and keep that many older versions of what is there. Returns what is to be said."""
    warnings: list[str] = []
    file.save(project, path, before_replacing=lambda: warnings.append(_rotated(path, backup_count)))
    return tr("Saved {name}. {warning}", name=path.name, warning=" ".join(warnings)).rstrip()


def save_new_version(project: Project, own: Path, report: Report) -> tuple[Path, str]:
    """Write the project beside its file `own`, under the next number that nothing there has, and over nothing.

    Each name that is tried is told as a part of the work. Returns the one that it was, and what is to be said.
    """
    taken: set[str] = set()
    while True:
        name, there = next_version(own.name, taken | _names_in(own.parent))
        path = own.with_name(name)
        report.partial(path)
        try:
            file.save(project, path, replaces=False)
        except NameTaken:  # somebody else took it just now
            taken.add(name)
            continue
        return path, (
            tr("Saved as {name}: {there} exists already.", name=name, there=there)
            if there
            else tr("Saved {name}. {warning}", name=name, warning="").rstrip()
        )


def _names_in(folder: Path) -> set[str]:
    """What lies in a folder; nothing where that cannot be told: writing there then says why."""
    try:
        return {path.name for path in folder.iterdir()}
    except OSError:
        return set()


def _rotated(path: Path, count: int) -> str:
    """Keep older versions of the file; a sentence where that cannot be. It never stands in the way of saving."""
    try:
        backups.rotate(path, count, is_project)
    except RoamError as error:
        return sentence_of(error)
    return ""
