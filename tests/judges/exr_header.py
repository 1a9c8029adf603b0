"""The header of an OpenEXR file, read byte by byte from the published layout of the format."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import NamedTuple

MAGIC = bytes.fromhex("762f3101")


class Attribute(NamedTuple):
    """One attribute: the name of its type and its bytes."""

    kind: str
    content: bytes


def header(path: Path) -> dict[str, Attribute]:
    """The attributes of a file of a single part, by name."""
    content = path.read_bytes()
    assert content[:4] == MAGIC
    (version,) = struct.unpack_from("<I", content, 4)
    assert version & 0xFF == 2
    place, found = 8, dict[str, Attribute]()
    while content[place]:
        name, kind = (text.decode("ascii") for text in content[place:].split(b"\0", 2)[:2])
        place += len(name) + len(kind) + 2
        (size,) = struct.unpack_from("<i", content, place)
        found[name] = Attribute(kind, content[place + 4 : place + 4 + size])
        place += 4 + size
    return found


def rate(attributes: dict[str, Attribute]) -> tuple[int, int]:
    """Frames a second, as numerator and denominator."""
    kind, content = attributes["framesPerSecond"]
    assert kind == "rational"
    numerator, denominator = struct.unpack("<iI", content)
    return numerator, denominator


def time_code(attributes: dict[str, Attribute]) -> str:
    """The time code as it is read aloud: `;` before the frames where numbers are dropped, `.2` after a second frame."""
    kind, content = attributes["timeCode"]
    assert kind == "timecode"
    packed, user = struct.unpack("<II", content)
    assert user == 0

    def digits(place: int, tens_bits: int) -> int:
        return (packed >> place & 0xF) + 10 * (packed >> (place + 4) & (1 << tens_bits) - 1)

    hours, minutes, seconds, frames = digits(24, 2), digits(16, 3), digits(8, 3), digits(0, 2)
    assert not packed & ~0x3F7F7F3F & ~(1 << 6 | 1 << 15), "bits that nobody asked for"
    mark = ";" if packed >> 6 & 1 else ":"
    return f"{hours:02d}:{minutes:02d}:{seconds:02d}{mark}{frames:02d}" + (".2" if packed >> 15 & 1 else "")
