"""The transport: switches that exclude each other, the frame and the range as numbers, the speed in words."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QSpinBox, QToolButton, QWidget
from pytestqt.qtbot import QtBot

from app.actions.actions import Actions
from app.actions.keymaps import load_keymap
from app.features.navigation import Navigation
from app.features.playback import Playback, Repeat
from app.model.document import Document
from app.model.view_state import ViewState
from app.timeline.transport import Transport
from roam_core.roto import Project
from tests.gui.timeline.places import CLIP


class Clock:
    now = 0.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def playback(view_state: ViewState, clock: Clock) -> Iterator[Playback]:
    playback = Playback(view_state, clock=clock)
    yield playback
    playback.pause()


@pytest.fixture
def transport(qtbot: QtBot, document: Document, view_state: ViewState, playback: Playback) -> Iterator[Transport]:
    window = QWidget()
    qtbot.addWidget(window)
    actions = Actions(window, window, load_keymap())
    transport = Transport(Navigation(document, view_state), view_state, playback, actions)
    actions.connect_all(playback.handlers())
    qtbot.addWidget(transport)
    document.open(Project(CLIP), None)
    transport.show()
    yield transport
    window.close()  # it holds the actions up to here


def button(transport: Transport, name: str) -> QToolButton:
    return next(each for each in transport.findChildren(QToolButton) if each.defaultAction().objectName() == name)


def click(qtbot: QtBot, transport: Transport, name: str) -> None:
    qtbot.mouseClick(button(transport, name), Qt.MouseButton.LeftButton)


def test_loop_and_ping_pong_exclude_each_other(qtbot: QtBot, transport: Transport, playback: Playback) -> None:
    seen = []
    for name in ("time.ping_pong", "time.loop", "time.loop", "time.ping_pong", "time.ping_pong"):
        click(qtbot, transport, name)
        lit = [button(transport, each).isChecked() for each in ("time.loop", "time.ping_pong")]
        seen.append((playback.repeat, lit))
    assert seen == [
        (Repeat.PING_PONG, [False, True]),
        (Repeat.LOOP, [True, False]),
        (Repeat.ONCE, [False, False]),
        (Repeat.PING_PONG, [False, True]),
        (Repeat.ONCE, [False, False]),
    ]


def test_the_speed_is_told_and_what_is_really_shown(
    qtbot: QtBot, transport: Transport, playback: Playback, clock: Clock
) -> None:
    assert transport._speed.text() == "24 fps"
    click(qtbot, transport, "time.play")
    click(qtbot, transport, "time.play")
    for number in range(12):
        clock.now += 0.1
        playback.note_picture(number)
    assert transport._speed.text() == "10 of 24 fps × 2"
    click(qtbot, transport, "time.pause")
    assert transport._speed.text() == "24 fps"


def test_an_end_of_the_range_that_is_typed_beyond_the_other_takes_it_along(
    qtbot: QtBot, transport: Transport, view_state: ViewState
) -> None:
    def typed(field: QSpinBox, frame: int) -> tuple[int, int]:
        field.setFocus()
        field.selectAll()
        qtbot.keyClicks(field, str(frame))
        qtbot.keyClick(field, Qt.Key.Key_Return)
        return view_state.play_range

    first, last = CLIP.frame_range[0], CLIP.frame_range[-1]
    assert typed(transport._out, first + 3) == (first, first + 4)
    assert typed(transport._in, first + 8) == (first + 8, first + 9)
    assert transport._out.value() == first + 8
    assert typed(transport._out, first + 5) == (first + 5, first + 6)
    assert transport._in.value() == first + 5
    assert typed(transport._in, last + 100) == (last, last + 1)
