"""Formats of shapes told by how their files begin, for files whose names say nothing."""

from __future__ import annotations

import codecs
import re
import stat
from pathlib import Path

HEAD_BYTES = 4096

_XML = rb"\s*(?:<\?xml[^>]*\?>\s*)?(?:<!--.*?-->\s*|<!DOCTYPE[^>]*>\s*)*"
_BEGINNINGS = (
    ("nuke", rb"# Written by ROAM\n|(?:\s*#[^\n]*\n)*\s*(?:version \d+\.\d+ v\d|set cut_paste_input |push )"),
    ("nuke", rb"\s*#!.*nuke[^\n]*\n"),
    ("silhouette", rb"\s*<!-- Silhouette |" + _XML + rb"<Silhouette[\s>]"),
    ("fusion", rb"\s*\{\s*Tools = ordered\("),
    ("svg", _XML + rb"<(?:svg:)?svg[\s>]"),
    ("cvat", _XML + rb"<annotations[\s>]"),
    ("json", rb'\s*\{\s*"(?:format": "roam-shapes"|info"|images"|annotations"|categories"|licenses"|\d+": ?\[\[)'),
)
_FORMATS = tuple((name, re.compile(pattern, re.DOTALL | re.IGNORECASE)) for name, pattern in _BEGINNINGS)


def format_of(path: Path) -> str | None:
    """The name of the importer that reads the file at `path`; None where it begins as no file of shapes does."""
    try:
        if not stat.S_ISREG(path.stat().st_mode):
            return None
        with path.open("rb") as file:
            head = file.read(HEAD_BYTES).removeprefix(codecs.BOM_UTF8)
    except (OSError, ValueError):
        return None
    return next((name for name, beginning in _FORMATS if beginning.match(head)), None)
