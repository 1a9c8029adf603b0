"""The status bar's right end: the memory that frames take, in a unit that shows it."""

from __future__ import annotations

import pytest
from pytestqt.qtbot import QtBot

from app.jobs.under_way import UnderWay
from app.panels.status import StatusBar
from app.view_state import ViewState

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
