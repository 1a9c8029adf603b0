"""Objects of which little is to be seen, in the window: tracked in one run, and looked at with edges and joints."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.jobs.runner import Ending
from tests.gui.waiting import WAIT
from tests.gui.windows import opened_window
from tests.unit.propagate.figures import odd_objects, written

OBJECTS = odd_objects()


@pytest.mark.parametrize("name", list(OBJECTS))
def test_odd_parts_are_tracked_in_the_window(qtbot: QtBot, tmp_path: Path, name: str) -> None:
    figure, shapes = OBJECTS[name]
    with opened_window(qtbot, written(figure, shapes, tmp_path), tmp_path / "state") as window:
        for switch in ("view.edges", "view.joints"):
            window.actions_by_id[switch].trigger()
        window.view_state.select(frozenset())
        with qtbot.waitSignal(window.propagation.finished, timeout=WAIT) as finished:
            qtbot.keyClick(window.canvas, Qt.Key.Key_BracketRight)
        ending, sentence = finished.args
        assert ending is Ending.DONE
        assert sentence.startswith("Tracked ")
        assert [shape.frames for shape in window.document.project.shapes] == [tuple(figure.frames)] * len(shapes)
        assert window.document.undo_stack.count() == 1
        for frame in figure.frames:
            window.view_state.set_frame(frame)
            qtbot.waitUntil(lambda: len(window.edge_kinds.here()) == len(shapes), timeout=WAIT)
        qtbot.keyClick(window.canvas, Qt.Key.Key_N)
        assert window.view_state.message
