"""What the operating system says: whether something is there; why it refused, in words that the window translates."""

from __future__ import annotations

import errno
import os
from pathlib import Path

from roam_core.translatable import N_, sentence

REASONS = {
    "EACCES": N_("Permission denied"),
    "EBUSY": N_("Device or resource busy"),
    "EDQUOT": N_("Disk quota exceeded"),
    "EEXIST": N_("File exists"),
    "EFBIG": N_("File too large"),
    "EIO": N_("Input/output error"),
    "EISDIR": N_("Is a directory"),
    "ELOOP": N_("Too many levels of symbolic links"),
    "EMFILE": N_("Too many open files"),
    "ENAMETOOLONG": N_("File name too long"),
    "ENODEV": N_("No such device"),
    "ENOENT": N_("No such file or directory"),
    "ENOMEM": N_("Cannot allocate memory"),
    "ENOSPC": N_("No space left on device"),
    "ENOTDIR": N_("Not a directory"),
    "EPERM": N_("Operation not permitted"),
    "EROFS": N_("Read-only file system"),
    "ESTALE": N_("Stale file handle"),
    "ETIMEDOUT": N_("Connection timed out"),
}
"""By the names of `errno`, in the words that a system speaking English has for them."""


def reason_of(error: Exception) -> str:
    """What went wrong with a file, without its name: a sentence that can be translated, or the system's own words."""
    number = error.errno if isinstance(error, OSError) else None
    known = REASONS.get(errno.errorcode.get(number, "")) if number is not None else None
    if known is not None:
        return sentence(known)
    return getattr(error, "strerror", None) or str(error)


def is_file(path: Path | str | None) -> bool:
    """Whether a file is there; what cannot be looked at, as on a share that is away, is not (`Path.is_file` raises)."""
    return path is not None and os.path.isfile(path)  # noqa: PTH113


def is_folder(path: Path | str | None) -> bool:
    """The same of a folder."""
    return path is not None and os.path.isdir(path)  # noqa: PTH112
