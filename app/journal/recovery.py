"""Recoveries: what journals hold of sessions that ended without closing, and of older ones; reading never changes them.

A recovery that the artist declines, or takes, or that turns out to lie in the artist's file, is remembered in an empty
file beside its journal. What was none of these is kept for ever; of what was settled, the newest sessions.
"""

from __future__ import annotations

import os
import shutil
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from roam_core.errors import RoamError
from roam_core.roto import Project, file
from roam_core.roto.backups import backup_path
from roam_core.roto.fingerprint import Fingerprint
from roam_core.system_errors import is_file, reason_of

from ..model.preferences import MOST_BACKUPS
from ..translation import moment, tr, translated
from .delta import Delta, applied
from .record import Damaged, Entry, entries
from .session import DECLINED, RECOVERED, SAVED, is_held, journals
from .writer import ROOT, VERSION

KEPT_SESSIONS = 10
"""Sessions kept whose work was saved, thrown away or recovered."""
JUST_NOW = 60.0
"""Seconds in which a window that begins may not have locked its folder yet."""
UNFIT = (KeyError, TypeError, ValueError, AttributeError, OverflowError, RecursionError)
"""What a header raises that does not say what it should."""
LATEST = 4e9
"""A time beyond this year 2096 is none."""


@dataclass(frozen=True)
class Recovery:
    """Work that one journal holds and no file of the artist.

    Attributes
    ----------
    journal : its file.
    original : the artist's file, or None for an untitled project.
    digest : SHA-256 of that file as the work builds on it; "" where there is none.
    when : the time of the last edit, in seconds since the epoch.
    edits, tracked, shapes : how many edits, but those that only brought tracked or filled frames; how many of these
        frames; and how many shapes and layers both touched.
    settled : "" while it is to be offered; else what became of it: saved, discarded, declined or recovered.
    saved_to : the file to which it was about to be saved last, where that is another one.
    is_recovered : True where the first of the edits is work that was recovered from another journal.
    is_damaged : True where the journal cannot be read to its end.
    """

    journal: Path
    original: Path | None
    digest: str
    when: float
    edits: int = 0
    tracked: int = 0
    shapes: int = 0
    settled: str = ""
    saved_to: Path | None = None
    is_recovered: bool = False
    is_damaged: bool = False

    @property
    def fingerprint(self) -> Fingerprint | None:
        """Of the artist's file as the work builds on it: known by its content alone."""
        return Fingerprint(-1, -1, self.digest) if self.digest else None

    @property
    def name(self) -> str:
        """The project's name for a title."""
        return self.original.name if self.original else tr("untitled")

    @property
    def sentence(self) -> str:
        """What would come back."""
        edits = max(self.edits - self.is_recovered, 0)
        counted = [
            tr("%n edit(s)", "", edits) if edits else "",
            tr("%n tracked frame(s)", "", self.tracked) if self.tracked else "",
        ]
        recovered = [tr("recovered work")] if self.is_recovered else []
        words = [*recovered, *(word for word in counted if word)] or [tr("changes")]
        what = tr(" and ").join(filter(None, (", ".join(words[:-1]), words[-1])))
        what = what[:1].upper() + what[1:]
        where = tr(" in %n shape(s)", "", self.shapes) if self.shapes else ""
        since = tr(" since the last save") if self.original else ""
        damage = tr("; what came after them is damaged") if self.is_damaged else ""
        return f"{what}{where}{since}{damage}"

    @property
    def day(self) -> str:
        return moment(self.when, "HH:mm:ss")


def recoveries(root: Path, own: Path | None = None, elsewhere: Sequence[Path] = ()) -> list[Recovery]:
    """All work that journals hold, the newest first: in the folder `root`, and in others where they were kept before.

    Sessions of windows that are open are left out, but for that of this window, in the folder `own`: of it what came
    to its end, such as changes that the artist chose not to save.
    """
    ended = [] if own is None else [journal for journal in journals(own) if _has_ended(journal)]
    closed = [
        journal for place in (root, *elsewhere) for folder in _closed_sessions(place) for journal in journals(folder)
    ]
    found = [_settled_by_file(each) for each in map(_looked_at, [*closed, *ended]) if each]
    return sorted(found, key=lambda each: each.when, reverse=True)


def offered(found: list[Recovery], path: Path | None = None) -> list[Recovery]:
    """Those that nobody answered for yet; where `path` is given, only those of that project."""
    return [each for each in found if not each.settled and (path is None or _is_same(each.original, path))]


def unsaved_on(found: list[Recovery], clip: Path) -> list[Recovery]:
    """Those that nobody answered for yet of projects on the clip at this path that have no file."""

    def is_on_it(each: Recovery) -> bool:
        try:
            held = load(each)[0].clip
        except RoamError:
            return False
        return held is not None and _is_same(held.path, clip)

    return [each for each in offered(found) if each.original is None and is_on_it(each)]


def decline(recovery: Recovery) -> None:
    """Offer it no more by itself; raises `RoamError` when that cannot be remembered."""
    try:
        recovery.journal.with_suffix(DECLINED).touch()
    except OSError as error:
        raise RoamError(
            tr("{journal} cannot be marked: {reason}.", journal=recovery.journal, reason=translated(reason_of(error)))
        ) from None


def load(recovery: Recovery) -> tuple[Project, str]:
    """The project as the journal knew it last, and a sentence where something of it is lost.

    Raises `RoamError` when nothing of it can be read.
    """
    found, problem = [], ""
    try:
        for entry in entries(recovery.journal):
            found.append(entry)
    except Damaged:
        problem = tr("The journal is damaged: what came after its last sound entry is lost.")
    except OSError as error:
        raise RoamError(
            tr("{journal} cannot be read: {reason}.", journal=recovery.journal, reason=translated(reason_of(error)))
        ) from None
    if not found or found[0].kind != "begin":
        raise RoamError(
            tr("The journal {journal} has no beginning; nothing of it can be recovered.", journal=recovery.journal)
        )
    project, done = _base(recovery, found)
    for entry in [entry for entry in found if entry.kind == "edit"][done:]:
        try:
            project = _after(project, entry)
        except (RoamError, *UNFIT):
            return project, tr("The journal is damaged: its last edits could not be put together.")
    return project, problem


def prune(root: Path) -> None:
    """Drop all but the newest sessions whose journals are all settled; nothing that may still be wanted goes."""
    folders = _closed_sessions(root)
    empty = [folder for folder in folders if not journals(folder)]
    settled = [folder for folder in folders if folder not in empty and all(map(_is_done, journals(folder)))]
    long_ago = time.time() - JUST_NOW
    for folder in [*settled[:-KEPT_SESSIONS], *(each for each in empty if each.stat().st_mtime < long_ago)]:
        shutil.rmtree(folder, ignore_errors=True)


def _closed_sessions(root: Path) -> list[Path]:
    """The folders of windows that are open no more, oldest first; none where `root` cannot be read."""
    try:
        return [folder for folder in sorted(root.iterdir()) if folder.is_dir() and not is_held(folder)]
    except OSError:
        return []


def _has_ended(journal: Path) -> bool:
    """Whether nothing more will be written to a journal."""
    try:
        return any(entry.kind == "end" for entry in entries(journal))
    except (Damaged, OSError):
        return False


def _is_done(journal: Path) -> bool:
    """Whether nothing of a journal is left to be recovered: saved, thrown away, or taken over by another one."""
    found = _looked_at(journal)
    if found is None:
        return not _is_unreadable(journal)
    return found.settled in ("saved", "discarded", "recovered")


def _is_unreadable(journal: Path) -> bool:
    try:
        return sum(1 for _ in entries(journal)) == 0
    except (Damaged, OSError):
        return True


def _looked_at(journal: Path) -> Recovery | None:
    """What a journal holds, by its headers alone; None where that is nothing."""
    found, is_damaged = None, False
    edited: set[str] = set()
    try:
        for entry in entries(journal):
            found = _with(found, entry, journal, edited)
    except (Damaged, *UNFIT):
        is_damaged = True
    except OSError:
        return None
    if found is None or not (found.edits or found.tracked):
        return None
    return replace(found, shapes=len(edited), is_damaged=is_damaged, settled=found.settled or _marked(journal))


def _settled_by_file(found: Recovery) -> Recovery:
    """As saved where the artist's file, or the one that it was to be saved to, holds just this work: the program ended
    after it wrote the file, but before it wrote that down. Remembered, for the file may change again."""
    if found.settled or found.is_damaged:
        return found
    written = [place for place in (found.original, found.saved_to) if place is not None and is_file(place)]
    places = [place for place in written if place != found.original or not _is_as_it_was(found, place)]
    if not places:
        return found
    try:
        project, loss = load(found)
    except RoamError:
        return found
    if loss or not any(file.is_saved(project, place) for place in places):
        return found
    with suppress(OSError):  # found out again the next time
        found.journal.with_suffix(SAVED).touch()
    return replace(found, settled="saved")


def _is_as_it_was(found: Recovery, original: Path) -> bool:
    """Whether the artist's file holds, as far as can be read, what the work builds on."""
    now = Fingerprint.of(original)
    return now is None or now.digest == found.digest


def _with(found: Recovery | None, entry: Entry, journal: Path, edited: set[str]) -> Recovery | None:
    """A recovery with one more entry."""
    header = entry.header
    if entry.kind == "begin":
        if header["version"] > VERSION:
            raise ValueError("of a newer program")
        original = header["original"]
        path = None if original is None else Path(original)
        is_recovered = header.get("follows") is not None
        return Recovery(journal, path, str(header["digest"] or ""), _time(header), is_recovered=is_recovered)
    if found is None:
        raise ValueError("an entry before the beginning")
    if entry.kind == "edit":
        edited.update(header["ids"])
        edits = found.edits + max(header["edits"] - header["tracked"], 0)  # a fill is one edit of many frames
        tracked = found.tracked + header["tracked"]
        settled = "" if header["is_modified"] else "saved"  # undone up to what the file holds
        return replace(found, when=_time(header), edits=edits, tracked=tracked, settled=settled)
    if entry.kind == "saving":
        return replace(found, saved_to=Path(header["path"]))
    return replace(found, settled=str(header["why"])) if entry.kind == "end" else found


def _time(header: Mapping[str, Any]) -> float:
    """When an entry was written."""
    when = float(header["time"])
    if not 0.0 <= when <= LATEST:
        raise ValueError(f"{when} is no time")
    return when


def _marked(journal: Path) -> str:
    marks = {"recovered": RECOVERED, "saved": SAVED, "declined": DECLINED}
    return next((word for word, suffix in marks.items() if journal.with_suffix(suffix).exists()), "")


def _base(recovery: Recovery, found: list[Entry]) -> tuple[Project, int]:
    """The last whole project that can be read, and after how many edits it was written."""
    for entry in reversed([entry for entry in found if entry.kind == "base"]):
        try:
            path = recovery.journal.with_name(Path(str(entry.header["name"])).name)
            text = path.read_text(encoding="utf-8")
            return file.loads(text, Path(entry.header["folder"]), str(path)), int(entry.header["after"])
        except (OSError, RoamError, *UNFIT):
            continue
    begin = found[0].header
    if not begin.get("is_on_file"):
        return Project(), 0
    digest = str(begin.get("digest"))
    if recovery.original is not None and (place := _as_it_was(recovery.original, digest)) is not None:
        return file.load(place), 0
    raise RoamError(
        tr("The journal builds on {name} as it was, and that file has changed or gone.", name=recovery.name)
    )


def _as_it_was(original: Path, digest: str) -> Path | None:
    """The artist's file, or the backup of it, that holds what a journal builds on: a save may have come between."""
    for place in (original, *(backup_path(original, number) for number in range(1, MOST_BACKUPS + 1))):
        if (now := Fingerprint.of(place)) is not None and now.digest == digest:
            return place
    return None


def _after(project: Project, entry: Entry) -> Project:
    """The project with the edit of an entry."""
    header: dict[str, Any] = entry.header
    parts = file.loads(entry.text, ROOT)
    if parts.clip is not None:
        parts = replace(parts, clip=replace(parts.clip, path=Path(header["clip"])))
    dropped = {str(item_id): tuple(frames) for item_id, frames in header["dropped"].items()}
    partly = tuple(map(str, header.get("partly", ())))  # version 1 has none
    return applied(project, Delta(parts, header["tree"], dropped, partly=partly))


def _is_same(original: Path | None, path: Path) -> bool:
    return original is not None and os.path.realpath(original) == os.path.realpath(path)
