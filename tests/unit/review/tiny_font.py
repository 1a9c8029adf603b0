"""A font file with a filled square for each of a few characters, and an empty frame for all others, as many have."""

from __future__ import annotations

import struct
from pathlib import Path

UNITS, SIDE = 1000, 800


def write_font(path: Path, characters: str) -> Path:
    """Write a TrueType font of those characters; they are as wide as high."""
    codes = sorted(map(ord, characters))
    frame = _glyph([_square(0, SIDE), _square(200, SIDE - 200)[::-1]])
    glyphs = [frame, *[_glyph([_square(0, SIDE)])] * len(codes)]
    offsets = [sum(map(len, glyphs[:count])) for count in range(len(glyphs) + 1)]
    tables = {
        b"cmap": _cmap(codes),
        b"glyf": b"".join(glyphs),
        b"head": struct.pack(
            ">IIIIHHQQhhhhHHhhh", 0x10000, 0x10000, 0, 0x5F0F3CF5, 3, UNITS, 0, 0, 0, 0, SIDE, SIDE, 0, 8, 2, 1, 0
        ),
        b"hhea": struct.pack(">IhhhHhhhhhhhhhhhH", 0x10000, SIDE, 0, 0, UNITS, *[0] * 11, len(glyphs)),
        b"hmtx": struct.pack(">Hh", UNITS, 0) * len(glyphs),
        b"loca": struct.pack(f">{len(offsets)}I", *offsets),
        b"maxp": struct.pack(">IHHHHHHHHHHHHHH", 0x10000, len(glyphs), 8, 2, 0, 0, 1, *[0] * 8),
    }
    place, directory, body = 12 + 16 * len(tables), b"", b""
    for tag, table in tables.items():
        padded = table + b"\0" * (-len(table) % 4)
        directory += struct.pack(">4sIII", tag, 0, place + len(body), len(table))
        body += padded
    path.write_bytes(struct.pack(">IHHHH", 0x10000, len(tables), 64, 2, 48) + directory + body)
    return path


def _square(low: int, high: int) -> list[tuple[int, int]]:
    return [(low, low), (low, high), (high, high), (high, low)]


def _glyph(contours: list[list[tuple[int, int]]]) -> bytes:
    """A simple glyph of straight lines, its coordinates as steps of two bytes."""
    points = [point for contour in contours for point in contour]
    ends = [4 * count - 1 for count in range(1, len(contours) + 1)]
    steps = [(x - before[0], y - before[1]) for (x, y), before in zip(points, [(0, 0), *points], strict=False)]
    outline = struct.pack(f">hhhhh{len(ends)}HH", len(contours), 0, 0, SIDE, SIDE, *ends, 0) + b"\1" * len(points)
    outline += b"".join(struct.pack(f">{len(points)}h", *axis) for axis in zip(*steps, strict=True))
    return outline + b"\0" * (-len(outline) % 4)


def _cmap(codes: list[int]) -> bytes:
    """One segment for each character, and the last one that the format asks for."""
    ends = [*codes, 0xFFFF]
    deltas = [(glyph - code) % 65536 for glyph, code in enumerate(codes, 1)] + [1]
    count = len(ends)
    lists = struct.pack(f">{count}HH{count}H{count}H{count}H", *ends, 0, *ends, *deltas, *[0] * count)
    table = struct.pack(">HHHHHHH", 4, 14 + len(lists), 0, 2 * count, 0, 0, 0) + lists
    return struct.pack(">HHHHI", 0, 1, 3, 1, 12) + table
