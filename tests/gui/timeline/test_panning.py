"""Panning: the middle button over every part of the timeline, and the bar that shows the piece of time in sight."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from app.model.document import Document
from app.model.view_state import ViewState
from app.timeline.panning import FINENESS
from app.timeline.timeline import Timeline
from roam_core.roto import Clip, Project
from tests.gui.timeline.places import x_of

MIDDLE = Qt.MouseButton.MiddleButton


def zoomed(timeline: Timeline) -> None:
    timeline.axis.set_scale(timeline.axis.scale.zoomed(3.0, x_of(timeline, 1024)))


@pytest.mark.parametrize("part", ["ruler", "rows", "plot"])
def test_the_middle_button_drags_time_along(qtbot: QtBot, timeline: Timeline, view_state: ViewState, part: str) -> None:
    zoomed(timeline)
    before, frame = timeline.axis.scale, view_state.frame
    parts: dict[str, QWidget] = {
        "ruler": timeline.ruler,
        "rows": timeline.rows.viewport(),
        "plot": timeline.confidence.lines.viewport(),
    }
    qtbot.mousePress(parts[part], MIDDLE, pos=QPoint(500, 10))
    qtbot.mouseMove(parts[part], QPoint(500 - round(2 * before.pixels), 10))
    qtbot.mouseRelease(parts[part], MIDDLE, pos=QPoint(400, 10))
    assert timeline.axis.scale.first == pytest.approx(before.first + 2, abs=0.1)
    qtbot.mouseMove(parts[part], QPoint(100, 10))
    assert timeline.axis.scale.first == pytest.approx(before.first + 2, abs=0.1)
    assert view_state.frame == frame


def test_the_bar_is_there_while_a_part_is_out_of_sight_and_moves_it(qtbot: QtBot, timeline: Timeline) -> None:
    assert not timeline.bar.isVisible()
    zoomed(timeline)
    assert timeline.bar.isVisible()
    bar, scale = timeline.bar.bar, timeline.axis.scale
    assert bar.value() == round((scale.first - 1001) * FINENESS)
    bar.setValue(bar.maximum())
    assert timeline.axis.scale.last == pytest.approx(1049, abs=0.02)
    bar.setValue(bar.minimum())
    assert timeline.axis.scale.first == pytest.approx(1001)
    timeline.axis.fit()
    assert not timeline.bar.isVisible()


@pytest.mark.parametrize("last", [103_680_047, 999_999_999])
def test_frames_have_up_to_nine_digits(timeline: Timeline, document: Document, last: int) -> None:
    """Steps of the bar were counted from frame 0, and were too many for it."""
    document.open(Project(Clip(Path("plate"), 103_680_000, last, (64, 48))), None)
    scale, bar = timeline.axis.scale, timeline.bar.bar
    timeline.axis.set_scale(scale.zoomed(3.0, scale.x(last)))
    assert timeline.bar.isVisible()
    bar.setValue(bar.minimum())
    assert timeline.axis.scale.first == pytest.approx(103_680_000)
    bar.setValue(bar.maximum())
    assert timeline.axis.scale.last == pytest.approx(last + 1)
