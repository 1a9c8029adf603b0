"""Backups of a file before it is replaced: `NAME.1` is the newest, `NAME.2` the one before, and so on."""

from __future__ import annotations

import contextlib
import filecmp
import os
import re
import shutil
from collections.abc import Callable, Sequence
from pathlib import Path

from roam_core.atomic_write import flush_file, flush_folder, temporary_beside
from roam_core.errors import RoamError
from roam_core.system_errors import reason_of
from roam_core.translatable import sentence

LONGEST_NAME = 255
"""Bytes that a file name may have."""

_BACKUP = re.compile(r".+\.roam\.[1-9][0-9]?", re.IGNORECASE | re.DOTALL)


def is_named_as_backup(path: Path) -> bool:
    """Whether `path` is named as a backup of a project is, such as `shot.roam.1`."""
    return _BACKUP.fullmatch(path.name) is not None


def backup_path(path: Path, number: int) -> Path:
    """Where backup `number` of the file at `path` lies; of a name that is too long the end is left out.

    Of a symbolic link it lies beside what that leads to.
    """
    path = Path(os.path.realpath(path)) if path.is_symlink() else path
    suffix = f".{number}"
    name = os.fsencode(path.name)[: LONGEST_NAME - len(suffix)]
    while True:
        try:
            return path.with_name(name.decode("utf-8", "surrogateescape" if _is_odd(path) else "strict") + suffix)
        except UnicodeDecodeError:  # cut within a letter
            name = name[:-1]


def rotate(path: Path, count: int, is_ours: Callable[[Path], bool] = lambda _: True) -> Path | None:
    """Keep the file at `path` as its backup 1; the backups before it move up by one, and the one after `count` goes.

    Call it just before the file is replaced, when all that takes its place is written: else a save that fails, as on a
    full disk, takes the oldest backup away. `path` itself is never moved: at every moment it is there, whole. Of a
    symbolic link the file behind it is kept, beside that file. What has the name of a backup and is not ours is passed
    over.

    Returns where the file is kept; None, and nothing happens, where there is no file, where `count` is below 1, or
    where the newest backup holds the same already: a save that failed had it kept.

    Raises
    ------
    RoamError
        when the backup cannot be kept; the file and at least all backups but the oldest are then still there.
    """
    target = Path(os.path.realpath(path))
    temporary = temporary_beside(target)
    try:
        if count < 1 or not target.is_file():
            return None
        named = [backup_path(target, number) for number in range(1, count + 1)]
        places = [place for place in named if not os.path.lexists(place) or is_ours(place)]
        if not places:
            raise RoamError(
                sentence("No backup of {path} can be kept: files of others have the names of its backups.", path=path)
            )
        if _is_same(target, places[0]):
            return None
        _keep(target, temporary)
        for number in range(_first_free(places), 0, -1):
            places[number - 1].replace(places[number])
        temporary.replace(places[0])
        flush_folder(target.parent)
        return places[0]
    except OSError as error:
        raise RoamError(
            sentence(
                "No backup of {path} can be kept: {reason} ({folder}).",
                path=path,
                reason=reason_of(error),
                folder=target.parent,
            )
        ) from None
    finally:
        with contextlib.suppress(OSError):
            temporary.unlink(missing_ok=True)


def _is_odd(path: Path) -> bool:
    """Whether the name holds bytes that are no UTF-8."""
    return any("\ud800" <= letter <= "\udfff" for letter in path.name)


def _is_same(target: Path, place: Path) -> bool:
    """Whether the newest backup is the file itself, or, on a disk without links, a copy of it."""
    try:
        return target.samefile(place) or filecmp.cmp(target, place, shallow=False)
    except OSError:
        return False


def _first_free(places: Sequence[Path]) -> int:
    """The first place without a backup, or the last one, whose backup then goes."""
    return next((number for number, place in enumerate(places) if not place.exists()), len(places) - 1)


def _keep(target: Path, temporary: Path) -> None:
    """A second name for the file, or a copy on file systems that have none."""
    try:
        os.link(target, temporary)
    except OSError:
        shutil.copyfile(target, temporary)
        with contextlib.suppress(OSError):  # a disk without links may have no permissions or times to set either
            shutil.copystat(target, temporary)
        with temporary.open("rb+") as file:
            flush_file(file.fileno())
