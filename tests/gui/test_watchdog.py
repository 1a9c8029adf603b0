"""The watchdog itself: it sees an event that takes too long, and only that."""

from __future__ import annotations

import time

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QKeyEvent
from PySide6.QtWidgets import QLineEdit
from pytestqt.qtbot import QtBot

from tests.gui.watchdog import LIMIT, WatchedApplication

TOO_LONG = 5.0 * LIMIT
"""Seconds that are too long on a processor of five times the pace, too."""


def work_for(seconds: float) -> None:
    end = time.thread_time() + seconds
    while time.thread_time() < end:
        pass


class Glutton(QLineEdit):
    """Takes its time over every key."""

    seconds = 0.0

    def keyPressEvent(self, event: QKeyEvent) -> None:
        work_for(self.seconds)


def test_an_event_that_takes_too_long_is_seen(qtbot: QtBot, qapp: WatchedApplication) -> None:
    glutton = Glutton()
    qtbot.addWidget(glutton)
    with qapp.watching() as blocks:
        qtbot.keyClick(glutton, Qt.Key.Key_A)
        assert blocks == []
        glutton.seconds = TOO_LONG
        qtbot.keyClick(glutton, Qt.Key.Key_A)
        (block,) = blocks
        blocks.clear()
    assert (block.event, block.receiver) == ("KeyPress", "Glutton")
    assert block.seconds > LIMIT


def test_an_action_that_takes_too_long_is_seen_however_it_is_triggered(qapp: WatchedApplication) -> None:
    action = QAction("Heavy")
    action.setObjectName("file.heavy")
    action.triggered.connect(lambda: work_for(TOO_LONG))
    with qapp.watching() as blocks:
        action.trigger()
    assert [str(block).split(" took")[0] for block in blocks] == ["Trigger of QAction file.heavy"]


def test_waiting_is_not_held_against_a_test(qapp: WatchedApplication) -> None:
    action = QAction("Sleepy")
    action.triggered.connect(lambda: time.sleep(TOO_LONG))
    with qapp.watching() as blocks:
        action.trigger()
    assert blocks == []
