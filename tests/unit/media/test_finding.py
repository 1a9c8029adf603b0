"""Where a plate may lie after a move, and what tells it from others."""

from __future__ import annotations

from pathlib import Path

import pytest

from roam_core.media.content import HASHED_BYTES, content_hash
from roam_core.media.finding import MOST_ENTRIES, is_there, places_near


def made(path: Path) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(path.name.encode())
    return path


@pytest.mark.parametrize(
    ("name", "there"),
    [
        ("plates", True),
        ("plates/a.1001.png", True),
        ("plates/a.%04d.png", True),
        ("plates/a.####.png", True),
        ("plates/b.%04d.png", False),
        ("plates/c.%04d.png", True),
        ("plates/c.####.PNG", True),
        ("plates/C.%04d.png", False),
        ("none/a.%04d.png", False),
        ("plates/a.1001.png/b.%04d.png", False),
        ("x" * 300, False),
        ("a\0b", False),
    ],
)
def test_a_place_holds_a_folder_a_file_or_a_frame_of_the_pattern(tmp_path: Path, name: str, there: bool) -> None:
    made(tmp_path / "plates" / "a.1001.png")
    made(tmp_path / "plates" / "c.1001.PNG")
    assert is_there(tmp_path / name) is there


@pytest.mark.parametrize(
    "place",
    [
        "job/comp/sh010/a.%04d.png",
        "job/comp/plates/sh010/a.%04d.png",
        "job/plates/sh010/a.%04d.png",
        "plates/sh010/a.%04d.png",
        "job/media/plates/sh010/a.%04d.png",
        "job/comp/a.%04d.png",
    ],
)
def test_a_plate_is_looked_for_below_the_project_and_the_folders_above(tmp_path: Path, place: str) -> None:
    made(tmp_path / place.replace("%04d", "1001"))
    (tmp_path / "job" / "comp").mkdir(parents=True, exist_ok=True)
    lost = Path("/shows/old/plates/sh010/a.%04d.png")
    assert tmp_path / place in list(places_near(tmp_path / "job" / "comp", lost))


def test_nothing_of_another_name_is_offered_and_the_nearest_comes_first(tmp_path: Path) -> None:
    made(tmp_path / "job" / "plates" / "b.1001.png")
    far, near = made(tmp_path / "plates" / "a.mov"), made(tmp_path / "job" / "a.mov")
    assert list(places_near(tmp_path / "job", Path("/old/plates/a.mov")))[:2] == [near, far]
    assert all(place.name == "a.mov" for place in places_near(tmp_path / "job", Path("/old/plates/a.mov")))


def test_the_search_is_bounded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for number in range(12):
        (tmp_path / f"{number:04d}").mkdir()
    asked: list[Path] = []
    monkeypatch.setattr("roam_core.media.finding.is_there", lambda path: bool(asked.append(path)))
    monkeypatch.setattr("roam_core.media.finding.MOST_ENTRIES", 5)
    assert list(places_near(tmp_path, Path("/old/a.mov"))) == []
    assert len({path.parts[len(tmp_path.parts)] for path in asked if tmp_path in path.parents} - {"a.mov", "old"}) == 5
    assert MOST_ENTRIES <= 1000


def test_another_beginning_or_length_is_another_hash(tmp_path: Path) -> None:
    path, found = tmp_path / "a", []
    for content in (b"one", b"two", b"one ", bytes(HASHED_BYTES) + b"1", bytes(HASHED_BYTES) + b"12"):
        path.write_bytes(content)
        found.append(content_hash(path))
    assert len(set(found)) == 5
    assert {len(each) for each in found} == {32}
    assert content_hash(tmp_path / "none") == ""
