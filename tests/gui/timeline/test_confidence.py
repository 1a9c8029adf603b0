"""The confidence plot: its lines, what a click on it takes into the hand, what it tells of a frame."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtGui import QHelpEvent
from PySide6.QtWidgets import QApplication, QToolTip
from pytestqt.qtbot import QtBot

from app.model.document import Document
from app.model.view_state import ViewState
from app.timeline.confidence import _with_gaps
from app.timeline.marks import on_each_frame
from app.timeline.timeline import Timeline
from roam_core.roto import Keyframe, Origin, edit
from tests.gui.timeline.places import SQUARE, x_of


def test_the_confidence_line_has_a_hole_where_nothing_was_tracked() -> None:
    frames, values = _with_gaps(np.array([[1, 0.5], [2, 0.6], [7, 0.7]]))
    assert np.array_equal(np.isnan(frames), [False, False, True, False])
    assert np.array_equal(np.isnan(values), [False, False, True, False])


def test_a_click_on_the_plot_takes_the_line_under_it_and_tells_its_doubts(
    qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    second = document.project.shape("shape-2")
    sure = Keyframe(
        1015, SQUARE, origin=Origin.ENGINE, confidence=0.9, vertex_confidence=np.array([0.9, 0.2, 0.9, 0.1])
    )
    document.apply("Sure", document.project.with_shape(edit.set_engine_keys(second, [sure])))
    lines, plot = timeline.confidence.lines, timeline.confidence
    x = x_of(timeline, 1015) + 2 - lines.x()
    for value, name in ((0.25, "shape-1"), (0.85, "shape-2")):
        view_state.select(frozenset())
        view_state.set_frame(1001)
        qtbot.mouseClick(lines.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(x, round(plot.value_y(value))))
        assert view_state.frame == 1015
        assert view_state.selection.shapes == {name}
    assert view_state.selection.points == {("shape-2", 1), ("shape-2", 3)}  # ready under the hand
    assert view_state.message == (
        "Frame 1015: the confidence of Shape 2 is 0.90. 2 of its 4 points are doubtful and ringed."
    )


def test_a_drag_over_the_plot_only_scrubs(qtbot: QtBot, timeline: Timeline, view_state: ViewState) -> None:
    port = timeline.confidence.lines.viewport()
    start, end = (QPoint(x_of(timeline, frame) + 2 - timeline.confidence.lines.x(), 30) for frame in (1005, 1015))
    qtbot.mousePress(port, Qt.MouseButton.LeftButton, pos=start)
    qtbot.mouseMove(port, end)
    qtbot.mouseRelease(port, Qt.MouseButton.LeftButton, pos=end)
    assert view_state.frame == 1015
    assert view_state.selection.shapes == frozenset()


def test_the_worst_of_all_shapes_is_told_on_each_frame() -> None:
    first, second = np.array([[1, 0.5], [2, 0.6], [7, 0.7]]), np.array([[2, 0.2], [3, 0.9]])
    assert on_each_frame(np.minimum, [first, second]).tolist() == [[1, 0.5], [2, 0.2], [3, 0.9], [7, 0.7]]
    assert on_each_frame(np.minimum, []).shape == (0, 2)


def test_the_least_line_is_there_for_several_shapes_and_doubt_is_filled(
    timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    lines = timeline.confidence.lines
    assert len(lines._least.frames) == 18
    assert len(lines._doubt.opts["x0"]) == 18
    view_state.select(frozenset({"shape-2"}))
    assert len(lines._least.frames) == 0
    assert lines._doubt.opts["x0"].tolist() == list(range(1011, 1020))
    view_state.select(frozenset())
    for shape in document.project.shapes:
        document.apply("Clear", document.project.with_shape(edit.delete_engine_keys(shape)))
    assert len(lines._doubt.opts["x0"]) == 0


def test_a_tip_tells_the_shapes_of_a_frame_the_worst_first(
    timeline: Timeline, document: Document, monkeypatch: pytest.MonkeyPatch
) -> None:
    sure = Keyframe(1015, SQUARE, origin=Origin.ENGINE, confidence=0.1)
    shape = document.project.shape("shape-2")
    document.apply("Doubt", document.project.with_shape(edit.set_engine_keys(shape, [sure])))
    told: list[str] = []
    monkeypatch.setattr(QToolTip, "showText", lambda _at, text, _widget: told.append(text))
    port = timeline.confidence.lines.viewport()
    for frame in (1015, 1045):
        at = QPoint(x_of(timeline, frame) - timeline.confidence.lines.x(), 20)
        QApplication.sendEvent(port, QHelpEvent(QEvent.Type.ToolTip, at, port.mapToGlobal(at)))
    assert told == ["Frame 1015\n0.10  Shape 2\n0.20  Shape 1", "Frame 1045\nNothing is tracked here"]


def test_another_button_than_the_left_one_neither_goes_to_a_frame_nor_selects(
    qtbot: QtBot, timeline: Timeline, view_state: ViewState
) -> None:
    frame, port = view_state.frame, timeline.confidence.lines.viewport()
    at = QPoint(x_of(timeline, 1015) + 2 - timeline.confidence.lines.x(), 30)
    qtbot.mouseClick(port, Qt.MouseButton.RightButton, pos=at)
    assert (view_state.frame, view_state.selection.shapes) == (frame, frozenset())


def test_a_line_is_made_anew_where_its_shape_changed_and_no_other(timeline: Timeline, document: Document) -> None:
    lines = timeline.confidence.lines
    before = dict(lines._thin.lines)
    sure = Keyframe(1015, SQUARE, origin=Origin.ENGINE, confidence=0.7)
    changed = replace(edit.set_engine_keys(document.project.shape("shape-2"), [sure]), colour=(1.0, 0.0, 0.0))
    document.apply("Track", document.project.with_shape(changed))
    assert lines._thin.lines["shape-1"] is before["shape-1"]
    assert 0.7 in lines._thin.lines["shape-2"].values
    assert lines._thin.lines["shape-2"].colour.getRgbF()[:3] == (1.0, 0.0, 0.0)


def test_all_lines_are_one_item_of_the_plot(timeline: Timeline, document: Document, view_state: ViewState) -> None:
    lines = timeline.confidence.lines
    view_state.select(frozenset({"shape-1"}))
    assert list(lines._thin.lines) == ["shape-1"]
    items = len(lines.scene().items())
    view_state.select(frozenset({"shape-1", "shape-2"}))
    assert set(lines._thin.lines) == {"shape-1", "shape-2"}
    assert len(lines.scene().items()) == items


def test_lines_are_painted_in_the_colours_of_their_shapes(timeline: Timeline, document: Document) -> None:
    for colour in ((1.0, 0.0, 0.0), (0.0, 0.0, 1.0)):
        document.apply("Colour", document.project.with_shape(replace(document.project.shape("shape-2"), colour=colour)))
        picture = timeline.confidence.lines.grab().toImage()
        seen = {picture.pixelColor(x, y).getRgb()[:3] for x in range(picture.width()) for y in range(picture.height())}
        assert tuple(round(255 * part) for part in colour) in seen


def test_a_shape_has_no_part_in_frames_on_which_it_does_not_exist(
    qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    """No line of it runs there; its tracked frames stay for when its life is made longer."""
    sure = Keyframe(1015, SQUARE, origin=Origin.ENGINE, confidence=0.9)
    project = document.project.with_shape(edit.set_engine_keys(document.project.shape("shape-2"), [sure]))
    document.apply("Shorten", edit.set_properties(project, "shape-1", lifetime=(1001, 1010)))
    lines, plot = timeline.confidence.lines, timeline.confidence
    assert lines.tip(1015) == "Frame 1015\n0.90  Shape 2"
    assert "0.20  Shape 1" in lines.tip(1008)
    x = x_of(timeline, 1015) + 2 - lines.x()
    qtbot.mouseClick(lines.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(x, round(plot.value_y(0.2))))
    assert view_state.selection.shapes == {"shape-2"}
