"""The status bar: a sentence that is cut with a sign of it, the memory of the frames in a unit that shows it."""

from __future__ import annotations

import pytest
from PySide6.QtGui import QImage
from pytestqt.qtbot import QtBot

from app.jobs.under_way import UnderWay
from app.model.view_state import ViewState
from app.panels.bars.status import Sentence, StatusBar

MB, GB = 2**20, 2**30


@pytest.mark.parametrize(
    ("used", "limit", "told"),
    [
        (0, GB, "memory 0 MB of 1.0 GB"),
        (960 * 540 * 3, GB, "memory 1.5 MB of 1.0 GB"),
        (75 * MB, GB, "memory 75 MB of 1.0 GB"),
        (3 * GB // 2, 8 * GB, "memory 1.5 GB of 8.0 GB"),
        (0, 0, ""),  # no plate
    ],
)
def test_the_memory_of_the_frames(qtbot: QtBot, view_state: ViewState, used: int, limit: int, told: str) -> None:
    status = StatusBar(view_state, UnderWay())
    qtbot.addWidget(status)
    status.show_memory(used, limit)
    assert status._memory.text() == told


def test_a_sentence_without_room_keeps_its_beginning_and_its_end(qtbot: QtBot) -> None:
    sentence = Sentence()
    qtbot.addWidget(sentence)

    def looks(text: str, width: int) -> QImage:
        sentence.setText(text)
        sentence.resize(width, 26)
        return sentence.grab().toImage()

    one, two = (f"/shots/of/a/long/show/{name}/with/a/long/name.roam cannot be written" for name in ("one", "two"))
    three = one.replace("cannot be written", "is written")
    assert looks(one, 120) == looks(two, 120)
    assert looks(one, 120) != looks(three, 120)
    assert looks(one, 600) != looks(two, 600)
