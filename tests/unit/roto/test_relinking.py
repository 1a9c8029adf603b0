"""A project's plate after a move: taken again if it is the same, and named where it is another."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

from roam_core.media import open_clip
from roam_core.roto import Clip, Project, file
from roam_core.roto.relinking import is_renumbered, other_content, other_size, relinked


def plate(folder: Path, value: int = 10, size: tuple[int, int] = (8, 6), frames: int = 2) -> Path:
    """A sequence of plain pictures; its pattern."""
    folder.mkdir(parents=True)
    for frame in range(1001, 1001 + frames):
        cv2.imwrite(str(folder / f"a.{frame}.png"), np.full((size[1], size[0], 3), value, np.uint8))
    return folder / "a.%04d.png"


@pytest.fixture
def shows(tmp_path: Path) -> Path:
    """A folder so deep that a search from one within it does not leave this test's own."""
    folder = tmp_path / "disk" / "shows"
    folder.mkdir(parents=True)
    return folder


@pytest.fixture
def project(shows: Path) -> Project:
    """A project on a plate at `plates/sh010`, its file in `work`."""
    pattern = plate(shows / "plates" / "sh010")
    found = Project(replace(Clip.of(open_clip(pattern)), colour_space="log", extra={"later": 1}))
    (shows / "work").mkdir()
    file.save(found, shows / "work" / "a.roam")
    return found


def test_a_project_and_plate_that_moved_together_are_found_by_the_relative_path(project: Project, shows: Path) -> None:
    (shows / "job").mkdir()
    for name in ("work", "plates"):
        (shows / name).rename(shows / "job" / name)
    plate(shows / "plates" / "sh010", 99)
    again = file.load(shows / "job" / "work" / "a.roam").require_clip()
    assert again.path == shows / "job" / "plates" / "sh010" / "a.%04d.png"


def test_a_project_that_moved_alone_finds_its_plate_where_it_was(project: Project, shows: Path) -> None:
    (shows / "far" / "away").mkdir(parents=True)
    moved = (shows / "work" / "a.roam").rename(shows / "far" / "away" / "a.roam")
    assert file.load(moved).require_clip() == project.require_clip()


def test_a_plate_that_moved_is_found_near_the_project(project: Project, shows: Path) -> None:
    (shows / "work" / "media").mkdir()
    (shows / "plates").rename(shows / "work" / "media" / "plates")
    loaded = file.load(shows / "work" / "a.roam")
    again = relinked(loaded, shows / "work").require_clip()
    assert again == replace(project.require_clip(), path=shows / "work" / "media" / "plates" / "sh010" / "a.%04d.png")


@pytest.mark.parametrize("left", [[], [".DS_Store"]])
def test_an_empty_folder_that_a_move_leaves_is_no_plate(shows: Path, left: list[str]) -> None:
    """A move of the files, and a disk that is away, leave a folder where the plate was: it was looked for no more."""
    place = plate(shows / "plates" / "sh010").parent
    work = shows / "work" / "a.roam"
    work.parent.mkdir()
    file.save(Project(Clip.of(open_clip(place))), work)
    moved = (shows / "work" / "sh010").absolute()
    place.rename(moved)
    place.mkdir()
    for name in left:
        (place / name).touch()
    assert relinked(file.load(work), work.parent).require_clip().path == moved


def gone(shows: Path) -> Path:
    """A place that is too deep for a search."""
    folder = shows / "gone" / "for"
    folder.mkdir(parents=True, exist_ok=True)
    return folder / "good"


@pytest.mark.parametrize("other", [{"value": 99}, {"size": (9, 6)}], ids=["content", "size"])
def test_another_plate_of_the_name_is_passed_over(project: Project, shows: Path, other: dict[str, int]) -> None:
    (shows / "plates").rename(gone(shows))
    plate(shows / "work" / "sh010", **other)
    loaded = file.load(shows / "work" / "a.roam")
    assert relinked(loaded, shows / "work") is loaded
    gone(shows).rename(shows / "found")
    assert relinked(loaded, shows / "work").require_clip().path == shows / "found" / "sh010" / "a.%04d.png"


def test_without_a_fingerprint_size_and_frames_decide(project: Project, shows: Path) -> None:
    old = replace(project, clip=replace(project.require_clip(), content=""))
    (shows / "plates").rename(gone(shows))
    plate(shows / "work" / "plates" / "sh010", 99, frames=3)
    assert relinked(old, shows / "work") is old
    plate(shows / "work" / "sh020", 99)
    assert relinked(old, shows / "work") is old
    plate(shows / "work" / "sh010", 99)
    assert relinked(old, shows / "work").require_clip().path.parent == shows / "work" / "sh010"


def test_a_plate_in_its_place_and_a_project_without_one_stay(project: Project, shows: Path) -> None:
    assert relinked(project, shows) is project
    empty = Project()
    assert relinked(empty, shows) is empty


def test_what_differs_is_told(project: Project) -> None:
    clip = project.require_clip()
    larger, other = replace(clip, size=(854, 480)), replace(clip, content="0" * 32)
    assert "is 854x480 now; the project was made for 8x6." in other_size(clip, larger)
    assert other_size(clip, other) == ""
    assert "is not that of the plate that the project was made on" in other_content(clip, other)
    assert [other_content(clip, each) for each in (larger, replace(clip, content=""))] == ["", ""]
    assert other_content(replace(clip, content=""), clip) == ""


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        ({}, True),
        ({"first": 1001, "last": 1010}, False),  # the same numbers
        ({"last": 11}, False),  # a shorter cut
        ({"content": "other"}, False),
        ({"content": ""}, False),
        ({"size": (8, 8)}, False),
        ({"layer": "beauty"}, False),
        ({"colour_space": "log"}, False),
    ],
)
def test_a_plate_is_renumbered_where_it_has_the_same_pictures_under_other_numbers(
    change: dict[str, Any], expected: bool
) -> None:
    before = Clip(Path("plate"), 1001, 1010, (8, 6), content="same")
    assert is_renumbered(before, replace(before, **({"first": 1, "last": 10} | change))) is expected


def test_a_clip_that_knows_no_content_is_not_told_to_be_renumbered() -> None:
    before = Clip(Path("plate"), 1001, 1010, (8, 6))
    assert not is_renumbered(before, replace(before, first=1, last=10))
