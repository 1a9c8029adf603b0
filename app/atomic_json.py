"""Keeping small settings files: written whole or not at all, read within bounds, and set aside where damaged."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeVar

from roam_core.atomic_write import write_atomically
from roam_core.bounded import bounded_bytes
from roam_core.errors import RoamError
from roam_core.system_errors import reason_of

from .translation import sentence_of, tr, translated

Value = TypeVar("Value")

MOST_BYTES = 1 << 20
"""Of a settings file: those that ROAM writes are a few KiB."""


def load_json(path: Path) -> dict[str, Any]:
    """The document of a settings file; empty where there is none.

    Raises
    ------
    RoamError
        when it cannot be read, is longer than `MOST_BYTES`, or is no JSON object.
    """
    if not os.path.lexists(path):
        return {}
    try:
        document = json.loads(bounded_bytes(path, MOST_BYTES, tr("it is damaged")))
    except (ValueError, RecursionError):
        raise RoamError(tr("{path} is damaged.", path=path)) from None
    if not isinstance(document, dict):
        raise RoamError(tr("{path} is damaged.", path=path))
    return document


def loaded(path: Path, load: Callable[[Path], Value], default: Value) -> tuple[Value, str]:
    """What `load` makes of a settings file, and an empty text; where it refuses, the default, and what became of it.

    A damaged file is set aside, so that nothing of it is lost when the next one is written.
    """
    try:
        return load(path), ""
    except RoamError as error:
        return default, f"{sentence_of(error)} {set_aside(path)}"


def set_aside(path: Path) -> str:
    """Rename a damaged file, or whatever is in its place, to `NAME.damaged`; one sentence that tells it."""
    numbers = ("", *(f"-{number}" for number in range(2, 100)))
    names = (path.with_name(f"{path.name}.damaged{number}") for number in numbers)
    aside = next((name for name in names if not os.path.lexists(name)), path.with_name(f"{path.name}.damaged"))
    try:
        path.rename(aside)
    except OSError as error:
        return tr("The defaults are used; it could not be set aside ({reason}).", reason=translated(reason_of(error)))
    return tr("The defaults are used; it was set aside as {name}.", name=aside.name)


def keep_json(path: Path, document: Mapping[str, object]) -> None:
    """Write a document, whole or not at all.

    Unlike a project it is not flushed to the disk: that may take longer than the window may stand still, and what is
    set here can be set again. Raises `RoamError` when it cannot be written.
    """
    write_atomically(path, json.dumps(document, indent=1).encode(), flushes=False)
