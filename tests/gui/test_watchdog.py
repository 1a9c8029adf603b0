"""The watchdog itself: it sees an event that takes too long, and only that. Its clock is turned by hand here."""

from __future__ import annotations

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QKeyEvent
from PySide6.QtWidgets import QLineEdit
from pytestqt.qtbot import QtBot

from tests.gui.watchdog import LIMIT, WatchedApplication

MOMENT = 0.001


class Clock:
    """Goes on a moment whenever it is read; `pace` is how slow the processor has become."""

    def __init__(self) -> None:
        self.seconds, self.pace = 0.0, 1.0

    def __call__(self) -> float:
        self.seconds += MOMENT * self.pace
        return self.seconds

    def work(self, seconds: float) -> None:
        self.seconds += seconds * self.pace


@pytest.fixture(autouse=True)
def nothing_blocks() -> None:
    """These tests watch for themselves."""


@pytest.fixture
def clock(qapp: WatchedApplication, monkeypatch: pytest.MonkeyPatch) -> Clock:
    clock = Clock()
    monkeypatch.setattr(qapp, "clock", clock)
    return clock


class Glutton(QLineEdit):
    """Takes its time over every key."""

    def __init__(self, clock: Clock) -> None:
        super().__init__()
        self.clock, self.seconds = clock, 0.0

    def keyPressEvent(self, event: QKeyEvent) -> None:
        self.clock.work(self.seconds)


def test_an_event_that_takes_too_long_is_seen(qtbot: QtBot, qapp: WatchedApplication, clock: Clock) -> None:
    glutton = Glutton(clock)
    qtbot.addWidget(glutton)
    with qapp.watching() as blocks:
        glutton.seconds = 0.5 * LIMIT
        qtbot.keyClick(glutton, Qt.Key.Key_A)
        assert blocks == []
        glutton.seconds = 2.0 * LIMIT
        qtbot.keyClick(glutton, Qt.Key.Key_A)
        (block,) = blocks
    assert (block.event, block.receiver) == ("KeyPress", "Glutton")
    assert 2.0 * LIMIT <= block.seconds < 3.0 * LIMIT


def test_an_action_that_takes_too_long_is_seen_however_it_is_triggered(qapp: WatchedApplication, clock: Clock) -> None:
    action = QAction("Heavy")
    action.setObjectName("file.heavy")
    action.triggered.connect(lambda: clock.work(2.0 * LIMIT))
    with qapp.watching() as blocks:
        action.trigger()
    assert [str(block).split(" took")[0] for block in blocks] == ["Trigger of QAction file.heavy"]


def test_a_processor_that_has_become_slower_is_not_held_against_a_test(qapp: WatchedApplication, clock: Clock) -> None:
    action = QAction("Plain")
    action.triggered.connect(lambda: clock.work(0.5 * LIMIT))
    with qapp.watching() as blocks:
        clock.pace = 5.0
        action.trigger()
    assert blocks == []


def test_unwatched_nothing_is_measured(qapp: WatchedApplication, clock: Clock) -> None:
    action = QAction("Heavy")
    action.triggered.connect(lambda: clock.work(2.0 * LIMIT))
    with qapp.watching() as blocks:
        pass
    read = clock.seconds
    action.trigger()
    assert clock.seconds == read + 2.0 * LIMIT
    assert blocks == []
