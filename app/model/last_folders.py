"""LastFolders: where the artist last saved and opened each kind of thing; the next chooser begins there."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path

from roam_core.system_errors import is_folder


class Purpose(StrEnum):
    """What a chooser is opened for."""

    PROJECT = "project"
    CLIP = "clip"
    SHAPES = "shapes"
    MASK = "mask"
    EXPORT = "export"


class LastFolders:
    """The folder that was used last for each purpose. Never saved in the project; it comes back with the window."""

    def __init__(self) -> None:
        self._folders: dict[Purpose, Path] = {}

    def note(self, purpose: Purpose, folder: Path) -> None:
        """Remember that a folder was used."""
        self._folders[purpose] = folder

    def of(self, purpose: Purpose) -> Path | None:
        """The folder that was used last; None where there was none, or it is gone."""
        folder = self._folders.get(purpose)
        return folder if is_folder(folder) else None

    def remembered(self) -> dict[str, dict[str, str]]:
        """What comes back when the window is opened again."""
        return {"last": {purpose.value: str(folder) for purpose, folder in self._folders.items()}}

    def recall(self, kept: dict[str, dict[str, str]]) -> None:
        """Take back what `remembered` gave; what makes no sense is left out."""
        for name, folder in kept.get("last", {}).items():
            if name in set(Purpose) and isinstance(folder, str) and folder and "\0" not in folder:
                self.note(Purpose(name), Path(folder))
