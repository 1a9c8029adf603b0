"""Formats of shapes told by their text, of the clipboard and of files whose names say nothing; and files as text."""

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
    "fusion": re.compile(r"\A\s*(?:Composition\s*\{|\{\s*Tools\s*=)"),
    "nuke": re.compile(
        r"(?m)\A#!.*[Nn]uke|\A# Written by ROAM$|^version \d+\.\d+ v\d"
        r"|^[ \t]{0,99}(?:set cut_paste_input\b|Roto(?:Paint)?\d*[ \t]{0,9}\{|curves[ \t]{0,9}\{)"
    ),
}
"""By what text each format is known, by its importer's name; the first that fits is meant."""


_WINDOWS = {0xDC00 + byte: bytes([byte]).decode("cp1252", "replace") for byte in range(0x80, 0x100)}
"""The letters of Western Windows for what Python makes of bytes that are no UTF-8."""


def name_of(text: str) -> str | None:
    """The name of the importer whose shapes a text holds by its look, or None."""
    text = text.removeprefix("\ufeff")
    return next((name for name, sign in SIGNS.items() if sign.search(text)), None)


def format_of(path: Path) -> str | None:
    """The name of the importer that reads the file at `path`; None where it begins as no file of shapes does."""
    head = head_of(path, HEAD_BYTES)
    return None if head is None else name_of(text_of(head))


def text_of(content: bytes) -> str:
    """A file as text: UTF-16 with the byte order mark that Windows writes, UTF-8, or what Windows wrote before that.

    Single bytes that are no UTF-8 are letters of Western Windows, whatever lies around them. Those that are none there
    either are replaced, and a mark of UTF-8 is taken off.
    """
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return content.decode("utf-16", "replace")
    content = content.removeprefix(codecs.BOM_UTF8)
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError as error:
        is_cut = error.end == len(content) and error.reason == "unexpected end of data"
        if is_cut:
            return content.decode("utf-8", "replace")
        return content.decode("utf-8", "surrogateescape").translate(_WINDOWS)


def head_of(path: Path, count: int) -> bytes | None:
    """The first bytes of the plain file at `path`, without a byte order mark; None where it cannot be read."""
    try:
        if not stat.S_ISREG(path.stat().st_mode):
            return None
        with path.open("rb") as file:
            return file.read(count).removeprefix(codecs.BOM_UTF8)
    except (OSError, ValueError):  # or a name that no file can have
        return None
