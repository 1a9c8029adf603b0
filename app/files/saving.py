"""What saving a project does on its worker: onto a file, with older versions kept beside it, or as a new version."""

from __future__ import annotations

from pathlib import Path

from roam_core.atomic_write import NameTaken
from roam_core.errors import RoamError
from roam_core.interchange.authorship import is_project
from roam_core.roto import Project, backups, file
from roam_core.roto.version_names import next_version

from ..jobs.runner import Report
from ..translation import sentence_of, tr


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
