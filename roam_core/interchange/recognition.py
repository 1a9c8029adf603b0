"""Formats of shapes told by their text: of the clipboard, and of files whose names say nothing."""

from __future__ import annotations

import codecs
import re
import stat
from collections.abc import Mapping
from pathlib import Path

HEAD_BYTES = 4096

SIGNS: Mapping[str, re.Pattern[str]] = {
    "json": re.compile(
        r'\A\s*\{(?:[^{\[]{0,400}?"format"\s*:\s*"roam-shapes"'
        r'|\s*"(?:info|images|annotations|categories|licenses)"\s*:|\s*"\d+"\s*:\s*\[\s*\[)'  # COCO, MLT
    ),
    "svg": re.compile(r"\A[^<]{0,10}(?:<[?!][^<]*){0,50}<(?:\w+:)?svg[\s>]"),
    "silhouette": re.compile(r"\A[^<]{0,10}(?:<[?!][^<]*){0,50}<Silhouette[\s>]"),
    "cvat": re.compile(r"\A[^<]{0,10}(?:<[?!][^<]*){0,50}<annotations[\s>]"),
    "fusion": re.compile(r"\A\s*\{\s*Tools\s*="),
    "nuke": re.compile(
        r"(?m)\A#!.*[Nn]uke|\A# Written by ROAM$|^version \d+\.\d+ v\d"
        r"|^[ \t]{0,99}(?:set cut_paste_input\b|Roto(?:Paint)?\d*[ \t]{0,9}\{|curves[ \t]{0,9}\{)"
    ),
}
"""By what text each format is known, by its importer's name; the first that fits is meant."""


def name_of(text: str) -> str | None:
    """The name of the importer whose shapes a text holds by its look, or None."""
    text = text.removeprefix("\ufeff")
    return next((name for name, sign in SIGNS.items() if sign.search(text)), None)


def format_of(path: Path) -> str | None:
    """The name of the importer that reads the file at `path`; None where it begins as no file of shapes does."""
    head = head_of(path, HEAD_BYTES)
    return None if head is None else name_of(head.decode("utf-8", "replace"))


def head_of(path: Path, count: int) -> bytes | None:
    """The first bytes of the plain file at `path`, without a byte order mark; None where it cannot be read."""
    try:
        if not stat.S_ISREG(path.stat().st_mode):
            return None
        with path.open("rb") as file:
            return file.read(count).removeprefix(codecs.BOM_UTF8)
    except (OSError, ValueError):  # or a name that no file can have
        return None
