"""Entries of a journal file: whole ones come back, a torn last one is passed over, a damaged one is known."""

from __future__ import annotations

from pathlib import Path

import pytest

from app.journal.record import Damaged, Entry, append, encoded, entries

ROW = [
    Entry({"kind": "begin"}),
    Entry({"kind": "edit", "name": "\udce9"}, "text\nof two lines"),
    Entry({"kind": "end"}),
]


@pytest.fixture
def path(tmp_path: Path) -> Path:
    path = tmp_path / "0001.journal"
    with path.open("xb", buffering=0) as stream:
        assert sum(append(stream, entry) for entry in ROW) == sum(len(encoded(entry)) for entry in ROW)
    return path


def read(path: Path) -> tuple[list[Entry], bool]:
    found: list[Entry] = []
    try:
        for entry in entries(path):
            found.append(entry)
    except Damaged:
        return found, True
    return found, False


def test_entries_come_back(path: Path) -> None:
    assert read(path) == (ROW, False)


def test_a_file_cut_anywhere_gives_the_entries_before_the_cut(path: Path) -> None:
    content = path.read_bytes()
    ends = [sum(len(encoded(entry)) for entry in ROW[:count]) for count in range(len(ROW) + 1)]
    for cut in range(len(content)):
        path.write_bytes(content[:cut])
        assert read(path) == (ROW[: sum(end <= cut for end in ends) - 1], False)


def test_a_changed_byte_ends_the_row_there_and_never_gives_another_entry(path: Path) -> None:
    content = bytearray(path.read_bytes())
    first = len(encoded(ROW[0]))
    for place in range(len(content)):
        changed = content.copy()
        changed[place] ^= 0x15
        path.write_bytes(changed)
        found, is_damaged = read(path)
        assert found == ROW[: len(found)]
        assert len(found) < len(ROW)
        assert len(found) >= (place >= first)
        assert is_damaged or found == ROW[: len(found)]
