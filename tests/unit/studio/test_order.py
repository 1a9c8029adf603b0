"""The longest jobs are begun first."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from roam_core.studio.order import longest_first
from roam_core.studio.tasks import Task, pieces
from tests.unit.cli.conftest import SHOT, write_picture


@pytest.fixture
def plates(tmp_path: Path) -> dict[str, Path]:
    """Three plates of 2, 4 and 3 pictures, and two movies (nobody reads them), of 10 and 20 bytes."""
    made = {}
    for name, count in (("two", 2), ("four", 4), ("three", 3)):
        made[name] = tmp_path / name
        made[name].mkdir()
        for frame in SHOT.frames[:count]:
            write_picture(made[name] / f"plate.{frame}.png", SHOT.read(frame))
    for name, count in (("small.mov", 10), ("large.mov", 20)):
        made[name] = tmp_path / name
        made[name].write_bytes(b"x" * count)
    return made


def job(name: str, plate: object, **options: Any) -> list[Task]:
    return [
        Task(name, "1-track", ("track",), "out", plate=str(plate), settings={"options": options}),
        Task(name, "2-render", ("render",), "out"),
    ]


def names(jobs: list[list[Task]]) -> list[str]:
    return [tasks[0].job for tasks in longest_first(jobs)]


def test_the_longest_comes_first(plates: dict[str, Path]) -> None:
    assert names([job(name, plates[name]) for name in ("two", "four", "three")]) == ["four", "three", "two"]


def test_frames_that_are_left_out_do_not_count(plates: dict[str, Path]) -> None:
    first = SHOT.frames[0]
    short = job("short", plates["four"], start=first + 1, end=first + 1)
    assert names([short, job("two", plates["two"])]) == ["two", "short"]


def test_movies_come_first_and_what_solves_nothing_last(plates: dict[str, Path]) -> None:
    mattes = [Task(name, "1-render", ("render",), "out") for name in ("b", "a")]
    jobs = [[task] for task in mattes]
    jobs += [job(name, plates[name]) for name in ("four", "small.mov", "large.mov")]
    assert names(jobs) == ["large.mov", "small.mov", "four", "b", "a"]


def test_a_plate_that_is_not_there_is_no_error_here(plates: dict[str, Path], tmp_path: Path) -> None:
    assert names([job("gone", tmp_path / "gone"), job("two", plates["two"])]) == ["two", "gone"]


def test_the_longest_gap_of_a_fill_comes_first() -> None:
    task = Task("a", "1-fill", ("fill", "p.roam", "--save", "x"), "out", can_split=True)
    parts, _ = pieces(task, [((1, 3), ["a"]), ((3, 9), ["a"]), ((9, 12), ["a"])])
    assert [part.settings["span"] for part in parts] == [[3, 9], [9, 12], [1, 3]]
