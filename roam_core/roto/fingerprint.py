"""Fingerprint: what tells whether a file on the disk is still the one that was read or written."""

from __future__ import annotations

import hashlib
import stat
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Fingerprint:
    """Size in bytes, time of the last change in nanoseconds, and SHA-256 of the content."""

    size: int
    changed: int
    digest: str

    @classmethod
    def of(cls, path: Path) -> Fingerprint | None:
        """Of the regular file at `path`; None where it is none, as a pipe that never ends, or cannot be read."""
        try:
            found = path.stat()
            if not stat.S_ISREG(found.st_mode):
                return None
            with path.open("rb") as file:
                digest = hashlib.file_digest(file, "sha256").hexdigest()
        except (OSError, ValueError):  # or a name that no file can have
            return None
        return cls(found.st_size, found.st_mtime_ns, digest)

    def is_of(self, path: Path) -> bool:
        """True where the file holds what it held: by size and time at a glance, else by its content."""
        try:
            found = path.stat()
        except OSError:
            return False
        if (found.st_size, found.st_mtime_ns) == (self.size, self.changed):
            return True
        now = Fingerprint.of(path)
        return now is not None and now.digest == self.digest
