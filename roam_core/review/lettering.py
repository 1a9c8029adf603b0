"""Text on pictures, by OpenImageIO's renderer; its package brings a font with the letters of Western Europe.

What a font lacks is drawn by another one of the machine (`roam_core.review.fonts`).
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import OpenImageIO as oiio  # noqa: N813

from roam_core.arrays import Float32, UInt8
from roam_core.errors import RoamError
from roam_core.review.fonts import Run, file_named, has, runs
from roam_core.translatable import sentence

UNKNOWN = "?"
"""Stands for a character that no font has."""
BEHIND = "i"
"""Written behind a piece of a line to tell where the next one begins: trailing spaces have no width of their own."""
ELLIPSIS = "..."
LEADING = 1.3
"""Height of a line in heights of the letters."""
PAD = 0.35
"""Around text, in heights of the letters."""
VEIL = 0.55
"""How much of the picture a box behind text hides."""
Colour = tuple[int, int, int]
WHITE: Colour = (255, 255, 255)


@lru_cache(maxsize=512)
def text_width(text: str, size: int, font: str = "") -> int:
    """Pixels that a line of text takes up."""
    if not text:
        return 0
    *before, last = runs(text, font)
    return sum(_advance(run, size) for run in before) + _extent(_drawable(last), size, last.font)


def wrapped(text: str, width: int, size: int, font: str = "", most: int = 0) -> list[str]:
    """The lines of a text that are no wider than `width` pixels, broken at spaces, or anywhere in a longer word.

    With `most` above zero no more lines than that; the last one then ends in an ellipsis.
    """
    lines = [line for paragraph in text.splitlines() for line in _broken(paragraph, width, size, font)]
    if most and len(lines) > most:
        last = lines[most - 1]
        while last and text_width(f"{last}{ELLIPSIS}", size, font) > width:
            last = last[:-1]
        lines = [*lines[: most - 1], f"{last}{ELLIPSIS}"]
    return lines


def write(pixels: UInt8, text: str, at: tuple[int, int], size: int, colour: Colour = WHITE, font: str = "") -> None:
    """Write one line into `pixels (h, w, 3)`; `at` is the corner at its left end and top. What lies outside is lost."""
    if text.strip():
        _lay(pixels, _letters(text, size, font), at, colour)


def write_boxed(
    pixels: UInt8, lines: list[str], corner: tuple[str, str], size: int, colour: Colour = WHITE, font: str = ""
) -> None:
    """Write lines on a dark veil in a corner of `pixels (h, w, 3)`: ("left" or "right", "top" or "bottom")."""
    if not lines:
        return
    pad, step = round(PAD * size), round(LEADING * size)
    width, height = max(text_width(line, size, font) for line in lines) + 2 * pad, box_height(len(lines), size)
    left = 0 if corner[0] == "left" else pixels.shape[1] - width
    top = 0 if corner[1] == "top" else pixels.shape[0] - height
    box = pixels[max(top, 0) : top + height, max(left, 0) : left + width]
    box[:] = np.rint(box * (1.0 - VEIL)).astype(np.uint8)
    for k, line in enumerate(lines):
        write(pixels, line, (left + pad, top + pad // 2 + k * step), size, colour, font)


def box_height(lines: int, size: int) -> int:
    """Pixels from top to bottom that so many lines in a box take up."""
    return round(LEADING * size) * lines + round(PAD * size)


def lines_in(rows: int, size: int) -> int:
    """How many lines a box of so many pixels from top to bottom has room for."""
    return max((rows - round(PAD * size)) // round(LEADING * size), 0)


def _broken(text: str, width: int, size: int, font: str) -> list[str]:
    lines, line = [], ""
    for word in text.split():
        longer = f"{line} {word}" if line else word
        if text_width(longer, size, font) <= width:
            line = longer
            continue
        if line:
            lines.append(line)
        while text_width(word, size, font) > width and len(word) > 1:
            fits = next((k for k in range(len(word) - 1, 1, -1) if text_width(word[:k], size, font) <= width), 1)
            lines.append(word[:fits])
            word = word[fits:]
        line = word
    return [*lines, line] if line else lines


def _lay(pixels: UInt8, letters: Float32, at: tuple[int, int], colour: Colour) -> None:
    """Blend a colour into pixels by the coverage `letters (h, w)`, whose corner lies at `at`."""
    left, top = max(at[0], 0), max(at[1], 0)
    part = letters[top - at[1] :, left - at[0] :][: max(pixels.shape[0] - top, 0), : max(pixels.shape[1] - left, 0)]
    if not part.size:
        return
    region = pixels[top : top + part.shape[0], left : left + part.shape[1]]
    cover = part[:, :, None]
    region[:] = np.rint(region * (1.0 - cover) + np.asarray(colour, np.float32) * cover).astype(np.uint8)


@lru_cache(maxsize=256)
def _letters(text: str, size: int, font: str) -> Float32:
    """The coverage `(h, w)` of a line in [0, 1]; its height is that of a line, letters stand on the same base."""
    width, height = text_width(text, size, font) + 2, round(LEADING * size) + 2
    buffer = oiio.ImageBuf(oiio.ImageSpec(width, height, 1, "float"))
    oiio.ImageBufAlgo.zero(buffer)
    left = 0
    for run in runs(text, font):
        oiio.ImageBufAlgo.render_text(buffer, left, size, _drawable(run), size, run.font, (1.0,))
        left += _advance(run, size)
    letters = np.asarray(buffer.get_pixels(oiio.FLOAT), dtype=np.float32).reshape(height, width)
    letters.setflags(write=False)
    return letters


def _advance(run: Run, size: int) -> int:
    """Pixels from the begin of a piece of a line to that of the next one."""
    return _extent(_drawable(run) + BEHIND, size, run.font) - _extent(BEHIND, size, run.font)


def _extent(text: str, size: int, font: str) -> int:
    return int(oiio.ImageBufAlgo.text_size(text, size, font).xend)


def _drawable(run: Run) -> str:
    return "".join(char if has(char, run.font) else UNKNOWN for char in run.text)


def required_font(font: str) -> str:
    """The font of this name or file as it is drawn by: itself, or the file of the machine that is called so.

    Raises `RoamError` where there is none.
    """
    found = font if _is_readable(font) else file_named(font)
    if _is_readable(found):
        return found
    if not font:
        raise RoamError(sentence("There is no font for text."))
    raise RoamError(sentence("There is no font {font!r}; name the file of one.", font=font))


def _is_readable(font: str) -> bool:
    is_there = bool(oiio.ImageBufAlgo.text_size("0", 16, font).defined)
    oiio.geterror()
    return is_there
