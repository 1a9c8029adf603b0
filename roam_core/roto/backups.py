"""Backups: older versions of a file beside it, as `name.1` (the newest) to `name.N`."""

from __future__ import annotations

import shutil
from pathlib import Path

from roam_core.errors import RoamError


def rotate(path: Path, count: int) -> None:
    """Keep the file at `path` as `path.name.1` before it is replaced; older ones move up, those beyond `count` go.

    Raises `RoamError` when they cannot be moved; the file itself is never touched.
    """
    if count < 1 or not path.is_file():
        return
    names = [path.with_name(f"{path.name}.{number}") for number in range(1, count + 1)]
    try:
        for newer, older in zip(reversed(names[:-1]), reversed(names[1:]), strict=True):
            if newer.exists():
                newer.replace(older)
        copy = path.with_name(f".{path.name}.backup.tmp")
        shutil.copy2(path, copy)
        copy.replace(names[0])
    except OSError as error:
        raise RoamError(f"The backups of {path} cannot be kept: {error.strerror}.") from None
