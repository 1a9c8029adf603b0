"""Keeping small settings files: whole or not at all, and without making the window wait for the disk."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Mapping
from pathlib import Path

from roam_core.errors import RoamError


def keep_json(path: Path, document: Mapping[str, object]) -> None:
    """Write a document by way of a temporary file in the same folder.

    Unlike a project it is not flushed to the disk: that may take longer than the window may stand still, and what is
    set here can be set again. Raises `RoamError` when it cannot be written.
    """
    temporary = ""
    try:
        handle, temporary = tempfile.mkstemp(prefix=f".{path.name}.", suffix=".tmp", dir=path.parent)
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            json.dump(document, file, indent=1)
        Path(temporary).replace(path)
    except OSError as error:
        if temporary:
            Path(temporary).unlink(missing_ok=True)
        raise RoamError(f"{path} cannot be written: {error.strerror or error}.") from None
