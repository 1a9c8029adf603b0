"""Whether what a command is to write can be written: asked before any work is done for it."""

from __future__ import annotations

from pathlib import Path

from roam_core.atomic_write import make_folder, require_open, writable_target
from roam_core.errors import RoamError


def require_target(path: Path) -> None:
    """Refuse a file that could not be written at the end, before any work is done for it."""
    if path.is_dir():
        raise RoamError(f"{path} is a folder; name the file to write.")
    require_writable(path.parent, create=False)
    writable_target(path)


def require_writable(folder: Path, *, create: bool) -> None:
    """Refuse a target before any work is done for it; make the folder where that is asked for."""
    if folder.exists() and not folder.is_dir():
        raise RoamError(f"{folder} is a file; name a folder to write to.")
    if create:
        make_folder(folder)
    if not folder.is_dir():
        raise RoamError(f"The folder {folder} does not exist; make it first, or name another.")
    require_open(folder)
