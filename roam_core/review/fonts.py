"""Fonts: which of them has a character. What the font of a text lacks is looked for among those of the machine."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

import numpy as np
import OpenImageIO as oiio  # noqa: N813

SUFFIXES = frozenset({".ttf", ".ttc", ".otf"})
STYLES = (
    "bold", "italic", "oblique", "light", "thin", "black", "medium", "heavy", "demi", "condensed", "narrow", "mono",
    "serif", "math", "symbol", "emoji",
)  # fmt: skip
"""Words in the names of fonts that are not the plain one of their family."""
PLAIN = ("", "regular", "book", "roman")
"""What may stand in the name of a file behind that of the family, where it is the plain font."""
NEVER_A_CHARACTER = "\uffff"
"""What a font draws for this, it draws for every character that it lacks: nothing, or a box."""
PROBE, MARGIN = 24, 12
"""Size of the letters that are compared, and the pixels around them."""


class Run(NamedTuple):
    """A piece of a line that one font draws."""

    text: str
    font: str


@lru_cache(maxsize=512)
def runs(text: str, font: str) -> tuple[Run, ...]:
    """A line in pieces, each with the font that has its characters; `font` itself where no font has them.

    Spaces belong to what stands before them, where its font has one.
    """
    found: list[Run] = []
    for char in text:
        goes_on = bool(found) and char == " " and has(char, found[-1].font)
        drawn_by = found[-1].font if goes_on else font_of(char, font)
        if found and found[-1].font == drawn_by:
            found[-1] = Run(found[-1].text + char, drawn_by)
        else:
            found.append(Run(char, drawn_by))
    return tuple(found)


@lru_cache(maxsize=4096)
def font_of(char: str, font: str) -> str:
    """The font that draws a character: `font`, else the first of the machine that has it, else `font`."""
    if has(char, font) or not char.isprintable():
        return font
    return next((path for path in machine_fonts() if has(char, path)), font)


@lru_cache(maxsize=16384)
def has(char: str, font: str) -> bool:
    """Whether a font can draw a character; a space, whether it leaves one."""
    if char == " ":
        return not any(_drawn(char, font))
    return char.isprintable() and _drawn(char, font) != _drawn(NEVER_A_CHARACTER, font)


def lacking(text: str, font: str) -> str:
    """The characters of a text that no font here has, each once, in their order."""
    return "".join(dict.fromkeys(char for char in text if char.isprintable() and not has(char, font_of(char, font))))


@lru_cache(maxsize=1)
def machine_fonts() -> tuple[str, ...]:
    """The files of the fonts that are installed, plain ones first, by their names."""
    files = {path for folder in _folders() for path in _files(folder)}
    return tuple(str(path) for path in sorted(files, key=_order))


def file_named(font: str) -> str:
    """The installed font that is called so, as `DejaVu Sans` or `NotoSansCJK-Bold.ttc`; `font` where none is.

    OpenImageIO itself knows its own fonts alone, and those one folder deep among the machine's.
    """
    stem = font[: -len(suffix)] if (suffix := Path(font).suffix).lower() in SUFFIXES else font
    files = {_letters_of(Path(path).stem): path for path in reversed(machine_fonts())}
    wanted = _letters_of(stem)
    return next((files[wanted + style] for style in PLAIN if wanted and wanted + style in files), font)


def _letters_of(name: str) -> str:
    """A name without what tells its words apart: families have spaces there, files hyphens or nothing."""
    return "".join(filter(str.isalnum, name.lower()))


def _folders() -> list[Path]:
    home, environment = Path.home(), os.environ
    if sys.platform == "win32":
        own = environment.get("LOCALAPPDATA", str(home / "AppData" / "Local"))
        return [Path(environment.get("WINDIR", r"C:\Windows")) / "Fonts", Path(own) / "Microsoft" / "Windows" / "Fonts"]
    if sys.platform == "darwin":
        return [Path("/System/Library/Fonts"), Path("/Library/Fonts"), home / "Library" / "Fonts"]
    shared = environment.get("XDG_DATA_DIRS") or "/usr/local/share:/usr/share"
    own = environment.get("XDG_DATA_HOME") or str(home / ".local" / "share")
    return [*(Path(each) / "fonts" for each in (own, *shared.split(":")) if each), home / ".fonts"]


def _files(folder: Path) -> Iterator[Path]:
    for place, _, names in os.walk(folder):
        yield from (Path(place) / name for name in names if Path(name).suffix.lower() in SUFFIXES)


def _order(path: Path) -> tuple[int, str, str]:
    name = path.stem.lower()
    return sum(word in name for word in STYLES), name, str(path)


@lru_cache(maxsize=4096)
def _drawn(char: str, font: str) -> bytes:
    """The pixels of a character; none where the font cannot be read."""
    side = PROBE + 2 * MARGIN
    buffer = oiio.ImageBuf(oiio.ImageSpec(side, side, 1, "uint8"))
    oiio.ImageBufAlgo.zero(buffer)
    is_drawn = oiio.ImageBufAlgo.render_text(buffer, MARGIN, MARGIN + PROBE, char, PROBE, font, (1.0,))
    oiio.geterror()
    return np.asarray(buffer.get_pixels(oiio.UINT8)).tobytes() if is_drawn else b""
