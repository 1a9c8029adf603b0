"""Looking at the picture on a worker: what is found arrives, what is dropped does not."""

from __future__ import annotations

import threading

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from app.jobs.picture_work import PictureWork
from app.jobs.runner import Ending, Report, Runner
from roam_core.arrays import UInt8
from roam_core.errors import RoamError
from tests.gui.waiting import WAIT


@pytest.fixture
def pictures(runner: Runner) -> PictureWork:
    return PictureWork(runner)


def test_what_is_found_arrives_from_another_thread(pictures: PictureWork, qtbot: QtBot) -> None:
    found: list[str] = []
    with qtbot.waitSignal(pictures.looked, timeout=WAIT):
        pictures.find("edge", lambda _: threading.current_thread().name, found.append)
    assert found == ["roam-worker"]


def test_quiet_work_tells_nothing_and_long_work_its_end(pictures: PictureWork, qtbot: QtBot) -> None:
    ends: list[tuple[Ending, str]] = []
    heard: list[tuple[Ending, str]] = []
    pictures.finished.connect(lambda *end: heard.append(end))

    def refuse(_: Report) -> None:
        raise RoamError("There is nothing.")

    with qtbot.waitSignal(pictures.looked, timeout=WAIT):
        pictures.find("quiet", refuse, ends.append)
    assert heard == []
    with qtbot.waitSignal(pictures.looked, timeout=WAIT):
        pictures.find("long", refuse, ends.append, ended=lambda *end: ends.append(end))
    assert heard == ends == [(Ending.FAILED, "There is nothing.")]


def test_nothing_that_was_stopped_arrives(pictures: PictureWork, qtbot: QtBot, runner: Runner) -> None:
    go_on, found = threading.Event(), list[str]()
    ends: list[Ending] = []
    pictures.find("a", lambda _: go_on.wait(WAIT / 1000), found.append, ended=lambda ending, _: ends.append(ending))
    pictures.find("b", lambda _: "b", found.append)
    pictures.clear()
    go_on.set()
    assert ends == [Ending.CANCELLED]
    with qtbot.waitSignal(pictures.looked, timeout=WAIT):
        pictures.find("c", lambda _: "c", found.append)
    assert found == ["c"]


def test_a_picture_knows_how_much_of_the_plate_its_pixels_cover(pictures: PictureWork) -> None:
    pictures.show(4, np.zeros((50, 100, 3), dtype=np.uint8))
    assert pictures.shown is not None
    assert pictures.shown.frame == 4
    assert pictures.shown.scale((200, 150)) == (2.0, 3.0)
    pictures.show(5, None)
    assert pictures.shown is None


def test_where_a_proxy_is_shown_the_whole_picture_is_looked_at(runner: Runner) -> None:
    whole, calls = np.zeros((8, 12, 3), np.uint8), list[int]()

    def full_of(frame: int, pixels: UInt8) -> UInt8 | None:
        if len(pixels) == len(whole):
            return pixels
        calls.append(frame)
        return whole if frame == 1 else None

    pictures = PictureWork(runner, None, full_of)
    pictures.show(1, np.zeros((4, 6, 3), np.uint8))
    for _ in range(2):
        assert pictures.shown is not None
        assert pictures.shown.pixels is whole
        assert pictures.shown.scale((12, 8)) == (1.0, 1.0)
    assert calls == [1]  # it is made once
    pictures.show(2, np.zeros((4, 6, 3), np.uint8))
    assert pictures.shown is None
