"""The ruler under the hand: in and out dragged by their brackets, frames that are missing, what it says."""

from __future__ import annotations

from dataclasses import replace

import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QHelpEvent
from PySide6.QtWidgets import QApplication, QToolTip
from pytestqt.qtbot import QtBot

from app.model.view_state import ViewState
from app.timeline.ruler import HINT
from app.timeline.scale import LABEL_WIDTH
from app.timeline.timeline import Timeline
from tests.gui.timeline.places import x_of

LOW = 24
"""The height of the brackets; above it the ruler scrubs."""


def edge(timeline: Timeline, frame: int) -> int:
    """The boundary before a frame, in pixels."""
    return round(timeline.axis.scale.x(frame - 0.5))


def drag(qtbot: QtBot, timeline: Timeline, start: QPoint, end: QPoint) -> None:
    qtbot.mousePress(timeline.ruler, Qt.MouseButton.LeftButton, pos=start)
    qtbot.mouseMove(timeline.ruler, (start + end) / 2)
    qtbot.mouseMove(timeline.ruler, end)
    qtbot.mouseRelease(timeline.ruler, Qt.MouseButton.LeftButton, pos=end)


def test_in_and_out_are_dragged_and_snap_to_frames(qtbot: QtBot, timeline: Timeline, view_state: ViewState) -> None:
    frame = view_state.frame
    drag(qtbot, timeline, QPoint(edge(timeline, 1001) + 2, LOW), QPoint(edge(timeline, 1010) + 4, LOW))
    drag(qtbot, timeline, QPoint(edge(timeline, 1049) - 2, LOW), QPoint(edge(timeline, 1031) - 4, LOW))
    assert view_state.play_range == (1010, 1031)
    assert view_state.frame == frame


def test_in_and_out_do_not_pass_each_other_nor_leave_the_clip(
    qtbot: QtBot, timeline: Timeline, view_state: ViewState
) -> None:
    view_state.set_play_range(1010, 1020)
    drag(qtbot, timeline, QPoint(edge(timeline, 1010), LOW), QPoint(edge(timeline, 1040), LOW))
    assert view_state.play_range == (1019, 1020)
    drag(qtbot, timeline, QPoint(edge(timeline, 1020) + 3, LOW), QPoint(9000, LOW))
    assert view_state.play_range == (1019, 1049)
    drag(qtbot, timeline, QPoint(edge(timeline, 1019), LOW), QPoint(-500, LOW))
    assert view_state.play_range == (1001, 1049)


def test_above_the_brackets_the_ruler_scrubs(qtbot: QtBot, timeline: Timeline, view_state: ViewState) -> None:
    view_state.set_play_range(1010, 1020)
    drag(qtbot, timeline, QPoint(edge(timeline, 1010), 6), QPoint(x_of(timeline, 1015), 6))
    assert view_state.play_range == (1010, 1020)
    assert view_state.frame == 1015


def test_the_pointer_tells_where_a_bracket_is(qtbot: QtBot, timeline: Timeline, view_state: ViewState) -> None:
    view_state.set_play_range(1010, 1020)
    for x, shape in ((edge(timeline, 1020), Qt.CursorShape.SizeHorCursor), (x_of(timeline, 1015), None)):
        qtbot.mouseMove(timeline.ruler, QPoint(x, LOW))
        assert timeline.ruler.cursor().shape() is (shape or Qt.CursorShape.ArrowCursor)


def test_frames_that_are_missing_are_hatched(timeline: Timeline) -> None:
    picture = timeline.ruler.grab().toImage()

    def colours(frame: int) -> set[str]:
        columns = range(edge(timeline, frame) + 2, edge(timeline, frame + 1) - 2)
        return {picture.pixelColor(x, y).name() for x in columns for y in range(22, 29)}

    assert len(colours(1033) - colours(1036)) >= 2  # the background of the gap, and lines across it


@pytest.mark.parametrize(
    ("place", "tip"),
    [("in", "In: frame 1010."), ("out", "Out: frame 1019."), ("gap", "Frame 1033 is missing"), ("", HINT)],
)
def test_it_says_what_lies_under_the_pointer(
    timeline: Timeline, view_state: ViewState, monkeypatch: pytest.MonkeyPatch, place: str, tip: str
) -> None:
    view_state.set_play_range(1010, 1020)
    spots = {"in": edge(timeline, 1010), "out": edge(timeline, 1020), "gap": x_of(timeline, 1033)}
    at = QPoint(spots.get(place, x_of(timeline, 1040)), LOW)
    told: list[str] = []
    monkeypatch.setattr(QToolTip, "showText", lambda _at, text, _widget: told.append(text))
    QApplication.sendEvent(timeline.ruler, QHelpEvent(QEvent.Type.ToolTip, at, timeline.ruler.mapToGlobal(at)))
    assert told[0].startswith(tip)
    assert timeline.ruler.tip_at(QPointF(at)) == told[0]


def test_a_press_beside_the_frames_leaves_the_playhead_where_it_is(
    qtbot: QtBot, timeline: Timeline, view_state: ViewState
) -> None:
    """It went to the first frame."""
    view_state.set_frame(1020)
    drag(qtbot, timeline, QPoint(40, 8), QPoint(60, 8))
    assert view_state.frame == 1020
    drag(qtbot, timeline, QPoint(x_of(timeline, 1020), 8), QPoint(40, 8))
    assert view_state.frame == 1001


def test_a_bracket_under_the_names_is_out_of_reach(qtbot: QtBot, timeline: Timeline, view_state: ViewState) -> None:
    """A press on what was not seen took it along."""
    view_state.set_play_range(1010, 1040)
    timeline.axis.set_scale(replace(timeline.axis.scale, pixels=20.0, first=1010.2))
    x = edge(timeline, 1010)
    assert 0 < x < LABEL_WIDTH
    drag(qtbot, timeline, QPoint(x, LOW), QPoint(x_of(timeline, 1020), LOW))
    assert view_state.play_range == (1010, 1040)
