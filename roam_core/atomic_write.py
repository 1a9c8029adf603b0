"""Files put in place whole or not at all: written beside their place, flushed to the disk, then renamed.

Everything that ROAM writes for an artist goes this way: projects, exports, mattes, settings.
"""

from __future__ import annotations

import ctypes
import errno
import os
import re
import secrets
import stat
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from ctypes.wintypes import BOOL, DWORD, HANDLE
from pathlib import Path
from typing import Any

from roam_core.errors import RoamError
from roam_core.system_errors import reason_of
from roam_core.translatable import sentence

STALE_SECONDS = 3600.0
"""A temporary file that was not touched for so long, and whose process is gone, was left by a killed process."""

_TEMPORARY = re.compile(r"\.roam-(?P<process>[0-9]+)-[0-9a-f]{16}\.tmp")
_NO_FLUSHING = frozenset({errno.EINVAL, errno.ENOTSUP, errno.EOPNOTSUPP, errno.ENOSYS})
"""How file systems say that they flush nothing: some shares, and some that run outside of the kernel."""
_NO_FOLDERS = _NO_FLUSHING | {errno.EBADF, errno.EACCES, errno.EPERM, errno.EISDIR}
"""How file systems say that a folder cannot be flushed."""
_NO_PERMISSIONS = frozenset({errno.EPERM, errno.EACCES, errno.ENOTSUP, errno.EOPNOTSUPP, errno.EINVAL, errno.ENOSYS})
"""How file systems say that they keep no permissions, or let none be set: shares, memory cards, disks of Windows."""

SYNCHRONIZE, ACCESS_DENIED, WAIT_TIMEOUT, MOST_ON_WINDOWS = 0x100000, 5, 0x102, 0xFFFFFFFF
"""Of Windows: to be allowed to wait for a process; the answers that it is another user's and that it has not ended; the
last number of one."""


class NameTaken(RoamError):
    """What was to be written as a new file has a file in its place already."""


_swept: set[Path] = set()
"""Folders that this process looked through already."""


def write_atomically(
    path: Path,
    content: bytes | Iterable[bytes],
    *,
    flushes: bool = True,
    before_replacing: Callable[[], object] | None = None,
    replaces: bool = True,
) -> None:
    """Put `content`, whole or in pieces, at `path`: at every moment the old file is there, or the new one.

    A symbolic link stays, and what it points to is replaced. The file keeps its permissions, where the disk lets them
    be set. File and folder are flushed to the disk, unless it is said that this takes too long (`flushes`). The first
    call for a folder removes what killed processes left there.

    `before_replacing` is called when all of the content lies beside its place, as to keep the old file as a backup: a
    write that fails before has changed nothing. What it raises ends the write, and the old file stays.

    With `replaces` off nothing is written over: not what comes there while the content is written, either.

    Raises
    ------
    NameTaken
        with `replaces` off, when something is there.
    RoamError
        when it cannot be written; also for a read-only file, and for what is no regular file. The old file stays.
        Where the new one stands already, and the disk fails as it is to keep its name, the sentence says so.
    """
    if not replaces and os.path.lexists(path):
        raise _taken(path)
    target = writable_target(path)
    if target.parent not in _swept:
        _swept.add(target.parent)
        sweep(target.parent)
    temporary = temporary_beside(target)
    try:
        _write(temporary, [content] if isinstance(content, bytes) else content, flushes)
        if target.exists():
            _set_permissions(temporary, stat.S_IMODE(target.stat().st_mode) & 0o777)
        if before_replacing is not None:
            before_replacing()
        if replaces:
            temporary.replace(target)
        else:
            _put_as_new(temporary, target)
    except OSError as error:
        _remove(temporary)
        raise RoamError(
            sentence(
                "{path} cannot be written: {reason} ({folder}).",
                path=path,
                reason=reason_of(error),
                folder=target.parent,
            )
        ) from None
    except BaseException:
        _remove(temporary)
        raise
    if flushes:
        _keep_name(path, target.parent)


def make_folder(folder: Path) -> None:
    """Have a folder be there, with those around it.

    Raises
    ------
    RoamError
        when it cannot be made.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise RoamError(
            sentence("The folder {folder} cannot be made: {reason}.", folder=folder, reason=reason_of(error))
        ) from None


@contextmanager
def new_folder(folder: Path) -> Iterator[None]:
    """Have a folder be there for a `with` block; where that fails, one that was made for it and is empty goes again.

    Raises as `make_folder`.
    """
    was_there = folder.exists()
    make_folder(folder)
    try:
        yield
    except BaseException:
        if not was_there:
            with suppress(OSError):  # something lies in it by now
                folder.rmdir()
        raise


def require_open(folder: Path) -> None:
    """Refuse a folder in which this user may make no files, in a `RoamError`."""
    if not os.access(folder, os.W_OK | os.X_OK):
        raise RoamError(
            sentence(
                "The folder {folder} cannot be written to; choose another or change its permissions.", folder=folder
            )
        )


def temporary_beside(target: Path) -> Path:
    """A new name in the folder of `target` that tells whose it is, and is short however long the target's name is."""
    return target.with_name(f".roam-{os.getpid()}-{secrets.token_hex(8)}.tmp")


def sweep(folder: Path) -> None:
    """Remove the temporary files of ours in `folder` that killed processes left; others are never touched."""
    with suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            match = _TEMPORARY.fullmatch(entry.name)
            if match and _is_stale(entry, int(match["process"])):
                _remove(Path(entry.path))


def flush_file(handle: int) -> None:
    """Flush an open file to the disk; on a file system that has no such thing, as some shares, it does what it does.

    Raises
    ------
    OSError
        when the disk fails.
    """
    try:
        os.fsync(handle)
    except OSError as error:
        if error.errno not in _NO_FLUSHING:
            raise


def flush_folder(folder: Path) -> None:
    """Flush the names in a folder to the disk, where the system can.

    Raises
    ------
    OSError
        when the disk fails.
    """
    if not hasattr(os, "O_DIRECTORY"):  # Windows
        return
    handle = -1
    try:
        handle = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
        os.fsync(handle)
    except OSError as error:
        if error.errno not in _NO_FOLDERS:
            raise
    finally:
        if handle >= 0:
            os.close(handle)


def is_alive(process: int) -> bool:
    """Whether a process of this machine runs."""
    if process <= 0:
        return False
    if sys.platform == "win32":
        return _runs_on_windows(process)
    try:
        os.kill(process, 0)
    except (ProcessLookupError, OverflowError):
        return False
    except OSError:
        return True
    return True


def _runs_on_windows(process: int) -> bool:
    """The same on Windows, where asking by a signal would end it. What nobody may ask about runs."""
    if process > MOST_ON_WINDOWS:
        return False
    library: Any = ctypes  # what Windows alone has of it
    kernel = library.WinDLL("kernel32", use_last_error=True)
    kernel.OpenProcess.argtypes, kernel.OpenProcess.restype = (DWORD, BOOL, DWORD), HANDLE
    kernel.WaitForSingleObject.argtypes, kernel.WaitForSingleObject.restype = (HANDLE, DWORD), DWORD
    kernel.CloseHandle.argtypes, kernel.CloseHandle.restype = (HANDLE,), BOOL
    handle = kernel.OpenProcess(SYNCHRONIZE, False, process)
    if not handle:
        return bool(library.get_last_error() == ACCESS_DENIED)
    try:
        return bool(kernel.WaitForSingleObject(handle, 0) == WAIT_TIMEOUT)  # it ends the wait where it has ended
    finally:
        kernel.CloseHandle(handle)


def writable_target(path: Path) -> Path:
    """The file that is to be replaced: `path`, or what it links to.

    Raises
    ------
    RoamError
        when it may not be: it is read-only, or no regular file.
    """
    try:
        target = Path(os.path.realpath(path))
        mode = target.stat().st_mode
    except FileNotFoundError:
        return target
    except (OSError, ValueError) as error:
        raise RoamError(sentence("{path} cannot be written: {reason}.", path=path, reason=reason_of(error))) from None
    if stat.S_ISDIR(mode):
        raise RoamError(sentence("{path} cannot be written: it is a folder.", path=path))
    if not stat.S_ISREG(mode):
        raise RoamError(sentence("{path} cannot be written: it is no regular file.", path=path))
    if not mode & 0o222 or not os.access(target, os.W_OK):
        raise RoamError(
            sentence("{path} cannot be written: it is read-only; change its permissions, or save elsewhere.", path=path)
        )
    return target


def _write(temporary: Path, pieces: Iterable[bytes], flushes: bool) -> None:
    handle = os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0), 0o666)
    with os.fdopen(handle, "wb") as file:
        for piece in pieces:
            file.write(piece)
        file.flush()
        if flushes:
            flush_file(file.fileno())


def _keep_name(path: Path, folder: Path) -> None:
    """Flush the name of a file that was put in its place."""
    try:
        flush_folder(folder)
    except OSError as error:
        raise RoamError(
            sentence(
                "{path} is written, but the disk may not keep it: {reason} ({folder}); save elsewhere, too.",
                path=path,
                reason=reason_of(error),
                folder=folder,
            )
        ) from None


def _set_permissions(temporary: Path, mode: int) -> None:
    """Have a file bear `mode`; on a disk that lets no permissions be set it bears those that the disk gives."""
    if stat.S_IMODE(temporary.stat().st_mode) == mode:
        return
    try:
        temporary.chmod(mode)
    except OSError as error:
        if error.errno not in _NO_PERMISSIONS:
            raise


def _put_as_new(temporary: Path, target: Path) -> None:
    """Give a file that was written its name, unless something has that name.

    In one step; on a disk without links in two, and who is killed between them leaves an empty file.
    """
    try:
        try:
            os.link(temporary, target)
        except FileExistsError:
            raise
        except OSError:  # a disk without links: the name is taken first
            os.close(os.open(target, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o666))
            try:
                temporary.replace(target)
            except OSError:
                _remove(target)
                raise
        else:
            _remove(temporary)
    except FileExistsError:
        raise _taken(target) from None


def _taken(path: Path) -> NameTaken:
    return NameTaken(sentence("{path} is there already; nothing is written over it.", path=path))


def _is_stale(entry: os.DirEntry[str], process: int) -> bool:
    try:
        found = entry.stat(follow_symlinks=False)
    except OSError:
        return False
    old = time.time() - found.st_mtime > STALE_SECONDS
    return old and stat.S_ISREG(found.st_mode) and not is_alive(process)


def _remove(temporary: Path) -> None:
    with suppress(OSError):
        temporary.unlink()
