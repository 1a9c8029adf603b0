"""What a journal builds on: the project of the artist's file, or one that no file holds."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from roam_core.roto import Project
from roam_core.roto.fingerprint import Fingerprint


@dataclass(frozen=True)
class Beginning:
    """What a journal builds on.

    `original` is the artist's file, `fingerprint` that of the file when it was read or saved last. Where `is_on_file`
    it holds `project`; else no file does. `follows` is the journal that the project was recovered from.
    """

    project: Project
    original: Path | None = None
    fingerprint: Fingerprint | None = None
    is_on_file: bool = False
    follows: Path | None = None

    @classmethod
    def on_file(cls, project: Project, original: Path | None, fingerprint: Fingerprint | None) -> Beginning:
        """A project that lies in a file, if the file's name and fingerprint are known."""
        return cls(project, original, fingerprint, original is not None and fingerprint is not None)
