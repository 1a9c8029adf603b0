"""What passes between the window's process and one that decodes: lines of JSON, and pixels in a file that both share.

Nothing that comes back is believed: an answer is bounded in length, a picture in its size, and of its pixels a copy is
kept which the other process cannot change.
"""

from __future__ import annotations

import json
import math
import os
import re
import tempfile
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from roam_core.arrays import Image
from roam_core.errors import RoamError
from roam_core.media.measure import MAX_PIXELS
from roam_core.system_errors import reason_of
from roam_core.translatable import Sentence, sentence

MOST_LINE = 1 << 24
"""Bytes of an answer: the names of some hundred thousand layers."""
MOST_BYTES = 1 << 30
"""Of a picture: the largest that is accepted has 576 MiB."""
TYPES = frozenset({"bool", "uint8", "uint16", "uint32", "int8", "int16", "int32", "float16", "float32", "float64"})

DEEPEST = 16
"""How deep sentences may lie in one another."""
MOST_TEXT = 1 << 20
"""Characters that a sentence may have, filled in."""
LONGEST_NUMBER, LONGEST_ESCAPE = 6000, 10
"""Characters of a number that JSON can hold, and of one character of a text that is quoted."""
_PLACE = re.compile(r"\{[^\W\d]\w*(?:!r)?(?::[.,]?\d{0,2}[a-z]?)?\}")
"""Of a template: no more than a name and the form of a number."""


class NoRoom(RoamError):
    """The pixels of no file can pass between the processes: that is none of the file's fault."""


class Garbled(Exception):
    """An answer that no decoder of ours gives."""


@dataclass(frozen=True)
class Answer:
    """What a process answered: the fields of its line, and the pixels that it left in the shared file."""

    fields: dict[str, Any]
    pixels: Image | None = field(default=None, compare=False)

    @property
    def picture(self) -> Image:
        """The pixels. Raises `RoamError` where there are none."""
        if self.pixels is None:
            raise _garbled("picture")
        return self.pixels

    def text(self, name: str) -> str:
        """A field that is a text. Raises `RoamError` where it is none."""
        return str(self._field(name, str))

    def number(self, name: str) -> float:
        """A field that is a finite number. Raises `RoamError` where it is none."""
        value = float(self._field(name, int, float))
        if not math.isfinite(value):
            raise _garbled(name)
        return value

    def texts(self, name: str) -> tuple[str, ...]:
        """A field that is a list of texts. Raises `RoamError` where it is none."""
        return tuple(map(str, self._field(name, list)))

    def size(self) -> tuple[int, int]:
        """The field `size`, (width, height). Raises `RoamError` where it is none, or larger than is accepted."""
        match self._field("size", list):
            case [int(width), int(height)] if width > 0 and height > 0 and width * height <= MAX_PIXELS:
                return width, height
        raise _garbled("size")

    def _field(self, name: str, *types: type) -> Any:
        value = self.fields.get(name)
        if not isinstance(value, types):
            raise _garbled(name)
        return value


def _garbled(name: str) -> RoamError:
    return RoamError(
        sentence("The process that decodes answered without a {name} that makes sense; the file is damaged.", name=name)
    )


class SharedFile:
    """A file in memory, or in the folder for temporary files where there are none such, that two processes know.

    Attributes
    ----------
    name : by which the other process opens it. handle : what it inherits for that; -1 where nothing is needed.

    Raises
    ------
    NoRoom
        when it cannot be made.
    """

    def __init__(self) -> None:
        self.handle = -1
        try:
            if hasattr(os, "memfd_create"):
                self.handle = os.memfd_create("roam-picture")
                self.name = f"/proc/self/fd/{self.handle}"
                self._file: BinaryIO = os.fdopen(self.handle, "r+b", buffering=0)
            else:
                handle, self.name = tempfile.mkstemp(prefix="roam-picture-")
                self._file = os.fdopen(handle, "r+b", buffering=0)
        except OSError as error:
            raise _no_room(error) from None

    def read(self, shape: tuple[int, ...], kind: str) -> Image:
        """A copy of the pixels at its beginning."""
        picture = np.empty(shape, kind)
        into = picture.reshape(-1).view(np.uint8).data
        self._file.seek(0)
        done = 0
        while done < len(into):
            count = self._file.readinto(into[done:])  # type: ignore[attr-defined]  # an unbuffered file has it
            if not count:
                raise Garbled(sentence("fewer pixels than were told"))
            done += count
        return picture

    def let_go_of_name(self) -> None:
        """Have nothing of it be left however this process ends: both have it open by now, and need no name of it.

        Windows keeps the name of a file that is open.
        """
        if self.handle < 0:
            with suppress(OSError):
                Path(self.name).unlink()

    def close(self) -> None:
        """Let go of it."""
        self._file.close()
        self.let_go_of_name()


def write_pixels(file: BinaryIO, picture: Image) -> dict[str, Any]:
    """Leave pixels in the shared file; what the other side has to know of them.

    Raises
    ------
    NoRoom
        when they cannot be written.
    """
    pixels = np.ascontiguousarray(picture)
    view = pixels.reshape(-1).view(np.uint8).data
    try:
        file.seek(0)
        while len(view):
            view = view[file.write(view) :]
    except OSError as error:
        raise _no_room(error) from None
    return {"shape": list(pixels.shape), "type": pixels.dtype.name}


def _no_room(error: OSError) -> NoRoom:
    place = sentence("in memory")
    if not hasattr(os, "memfd_create"):
        place = sentence("in {folder}", folder=tempfile.gettempdir())
    return NoRoom(
        sentence(
            "There is no room for decoded pictures {place} ({reason}); make room there, raise the limit of a file's "
            "size, or set ROAM_DECODER=inside to do without.",
            place=place,
            reason=reason_of(error),
        )
    )


def packed(text: str) -> Any:
    """A text as values of JSON: of a sentence its template and what it is filled with, for the window to translate."""
    if not isinstance(text, Sentence):
        return text
    plain = {name: value.item() if isinstance(value, np.generic) else value for name, value in text.values.items()}
    values = {
        name: packed(value) if isinstance(value, str) else value if isinstance(value, int | float) else str(value)
        for name, value in plain.items()
    }
    return [text.template, values]


def unpacked(told: Any, depth: int = 0) -> str:
    """The text that `packed` was given. Raises `Garbled` for what it does not give: a template has plain places."""
    match told:
        case str():
            return told
        case [str(template), dict(values)] if depth < DEEPEST and not set("{}") & set(_PLACE.sub("", template)):
            filled = {
                name: value if isinstance(value, int | float) else unpacked(value, depth + 1)
                for name, value in values.items()
            }
            widest = max((_widest(value) for value in filled.values()), default=0)
            if len(template) + len(_PLACE.findall(template)) * widest <= MOST_TEXT:
                with suppress(LookupError, ValueError, TypeError, OverflowError):
                    return sentence(template, **filled)
    raise Garbled(sentence("no sentence"))


def _widest(value: object) -> int:
    """Characters that a value fills a place with, at most."""
    return LONGEST_ESCAPE * len(value) if isinstance(value, str) else LONGEST_NUMBER


def taken(line: bytes, shared: SharedFile) -> Answer:
    """The answer of a line, with its pixels. Raises `Garbled`."""
    try:
        told = json.loads(line)
        told.get("picture")
    except (ValueError, AttributeError, RecursionError):
        raise Garbled(sentence("no line of JSON")) from None
    if (picture := told.pop("picture", None)) is None:
        return Answer(told)
    try:
        shape, kind = tuple(map(int, picture["shape"])), str(picture["type"])
    except (KeyError, TypeError, ValueError, OverflowError):
        raise Garbled(sentence("no picture")) from None
    if kind not in TYPES or not _is_possible(shape, np.dtype(kind).itemsize):
        raise Garbled(sentence("an impossible picture"))
    return Answer(told, shared.read(shape, kind))


def _is_possible(shape: tuple[int, ...], size: int) -> bool:
    return len(shape) in (2, 3) and all(side >= 0 for side in shape) and math.prod(shape) * size <= MOST_BYTES
