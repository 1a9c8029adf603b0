"""`--overwrite`: the user's word that files may be written over that are not of ROAM's making."""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

from roam_core.errors import RoamError
from roam_core.interchange.authorship import HEAD_BYTES, is_project
from roam_core.interchange.recognition import head_of
from roam_core.interchange.targets import BACKUPS, kept_aside
from roam_core.roto import Project, file
from roam_core.roto.backups import rotate
from roam_core.roto.fingerprint import Fingerprint
from roam_core.roto.project_lock import holder, release, take


def add_overwrite(parser: argparse.ArgumentParser) -> None:
    """Declare the option."""
    parser.add_argument(
        "--overwrite",
        action="store_true",
        help="write over files that ROAM did not make (never over what the command reads)",
    )


def project_writer(target: Path, read: Path | None = None) -> Callable[[Project], bool]:
    """A function that writes projects to `target`. Ask for it before `read`, the project to work on, is read.

    A project that is there is kept aside first, and the user is told, unless it is what was read or written last:
    another one, and what somebody else saved there meanwhile. What was read is kept aside, too, without a word, as by
    the window: once, when something else takes its place. The function gives True where somebody else had saved there.
    """
    is_as_read = read is not None and target.exists() and read.exists() and target.samefile(read)
    known = Fingerprint.of(target) if is_as_read else None

    def write(project: Project) -> bool:
        nonlocal known
        is_contested = False

        def keep() -> None:
            nonlocal is_as_read, is_contested
            if is_as_read and known is not None and known.is_of(target) and not file.is_saved(project, target):
                is_as_read = False
                _keep_read(target)
            if (known is None or not known.is_of(target)) and (kept := kept_aside(target)) is not None:
                if known is None:
                    said = f"The project that was {target} is kept as {kept.name}."
                else:
                    is_contested = True
                    said = (
                        f"roam: {target} was changed by somebody else meanwhile; what it held is kept as {kept.name}."
                    )
                print(said, file=sys.stderr)

        file.save(project, target, before_replacing=keep)
        known = Fingerprint.of(target)
        return is_contested

    return write


def _keep_read(target: Path) -> None:
    """Keep what was read as the newest backup. Where that cannot be it is told, and stands in the way of nothing."""
    try:
        rotate(target, BACKUPS, is_project)  # it was read as a project, in whatever order its fields stand
    except RoamError as error:
        print(f"roam: {error}", file=sys.stderr)


def require_own(target: Path, read: Iterable[Path], *, overwrite: bool, mark: bytes | None = None) -> None:
    """Refuse to write onto what a command reads, and without the user's word onto what does not bear our `mark`."""
    if target.exists() and any(path.exists() and target.samefile(path) for path in read):
        raise RoamError(f"{target} is read for this and is never written over; name another place.")
    head = head_of(target, HEAD_BYTES) if target.is_file() else b""
    if overwrite or head == b"" or (mark is not None and head is not None and re.search(mark, head)):
        return
    raise RoamError(f"{target} is there already; name another place, or say --overwrite.")


@contextmanager
def claimed(target: Path) -> Iterator[None]:
    """For the length of a `with` block the project that will be written is open here, as windows and commands tell.

    Who else has it open is told; the lock stays theirs.
    """
    if (found := holder(target)) is not None:
        print(f"roam: {target} is {found.sentence}; it is written all the same. Open it anew there.", file=sys.stderr)
    mine = take(target)
    try:
        yield
    finally:
        if mine is not None:
            release(target, mine)
