"""The timeline under the hand: scrubbing, keys that are clicked, zoom, rows of many shapes."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QPainter, QWheelEvent
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from app import style
from app.model.document import Document
from app.model.view_state import ViewState
from app.timeline.confidence import LEAST_HEIGHT
from app.timeline.keys import row_painter
from app.timeline.keys.row_painter import ROW
from app.timeline.timeline import Timeline
from roam_core.roto import Project, RotoShape, edit
from tests.gui.timeline.places import SQUARE, row_middle, x_of
from tests.gui.waiting import WAIT


def wheel(widget: QWidget, x: int, turn: int, modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier) -> None:
    place = QPointF(x, 5)
    event = QWheelEvent(
        place, QPointF(widget.mapToGlobal(place.toPoint())), QPoint(), QPoint(0, turn), Qt.MouseButton.NoButton,
        modifiers, Qt.ScrollPhase.NoScrollPhase, False,
    )  # fmt: skip
    QApplication.sendEvent(widget, event)


def test_the_whole_clip_is_in_sight_when_it_opens(timeline: Timeline) -> None:
    scale = timeline.axis.scale
    assert scale.clip == (1001, 1049)
    assert scale.first == 1001
    assert scale.last == pytest.approx(1049)


def test_a_light_frame_shows_that_the_rows_have_the_keyboard(qtbot: QtBot, timeline: Timeline) -> None:
    """There Del means keys, and nothing told it."""
    timeline.activateWindow()

    def corner() -> str:
        return timeline.rows.viewport().grab().toImage().pixelColor(0, 0).name()

    timeline.rows.clearFocus()
    assert corner() != style.TEXT
    timeline.rows.setFocus(Qt.FocusReason.TabFocusReason)
    qtbot.waitUntil(lambda: timeline.rows.hasFocus(), timeout=WAIT)
    assert corner() == style.TEXT
    timeline.rows.clearFocus()
    assert corner() != style.TEXT


def test_dragging_on_the_ruler_scrubs(qtbot: QtBot, timeline: Timeline, view_state: ViewState) -> None:
    ruler = timeline.ruler
    qtbot.mousePress(ruler, Qt.MouseButton.LeftButton, pos=QPoint(x_of(timeline, 1005), 10))
    assert view_state.frame == 1005
    qtbot.mouseMove(ruler, QPoint(x_of(timeline, 1012), 10))
    assert view_state.frame == 1012
    qtbot.mouseMove(ruler, QPoint(5000, 10))
    assert view_state.frame == 1048
    qtbot.mouseRelease(ruler, Qt.MouseButton.LeftButton, pos=QPoint(5000, 10))


def test_a_click_near_a_key_goes_to_it_and_selects_its_shape(
    qtbot: QtBot, timeline: Timeline, view_state: ViewState
) -> None:
    place = QPoint(x_of(timeline, 1030) + 5, row_middle(0))
    qtbot.mouseClick(timeline.rows.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert view_state.frame == 1030
    assert view_state.selection.shapes == {"shape-2"}  # the top row is the top-most shape


def test_a_click_beside_the_keys_scrubs_and_selects_nothing(
    qtbot: QtBot, timeline: Timeline, view_state: ViewState
) -> None:
    place = QPoint(x_of(timeline, 1040), row_middle(0))
    qtbot.mouseClick(timeline.rows.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert view_state.frame == 1040
    assert view_state.selection.shapes == frozenset()


def test_a_click_on_a_name_selects_and_shift_adds(qtbot: QtBot, timeline: Timeline, view_state: ViewState) -> None:
    rows, button = timeline.rows.viewport(), Qt.MouseButton.LeftButton
    qtbot.mouseClick(rows, button, pos=QPoint(40, row_middle(1)))
    assert view_state.selection.shapes == {"shape-1"}
    qtbot.mouseClick(rows, button, Qt.KeyboardModifier.ShiftModifier, pos=QPoint(40, row_middle(0)))
    assert view_state.selection.shapes == {"shape-1", "shape-2"}
    assert view_state.frame == 1001


def test_the_wheel_zooms_at_the_pointer_and_a_double_click_fits(qtbot: QtBot, timeline: Timeline) -> None:
    before, x = timeline.axis.scale, x_of(timeline, 1020)
    wheel(timeline.rows.viewport(), x, 360)
    zoomed = timeline.axis.scale
    assert zoomed.pixels > before.pixels * 1.5
    assert zoomed.frame(x) == 1020
    wheel(timeline.ruler, x, -120, Qt.KeyboardModifier.ShiftModifier)
    assert timeline.axis.scale.first > zoomed.first
    qtbot.mouseDClick(timeline.ruler, Qt.MouseButton.LeftButton, pos=QPoint(x, 10))
    assert timeline.axis.scale == before


def test_two_fingers_that_stray_a_little_sideways_zoom(timeline: Timeline) -> None:
    """A touchpad turns both ways at once: time was panned by what strayed."""
    before, ruler, at = timeline.axis.scale, timeline.ruler, QPointF(x_of(timeline, 1020), 5)
    for turn, zooms in ((QPoint(3, 120), True), (QPoint(120, 3), False)):
        event = QWheelEvent(
            at, QPointF(ruler.mapToGlobal(at.toPoint())), QPoint(), turn, Qt.MouseButton.NoButton,
            Qt.KeyboardModifier.NoModifier, Qt.ScrollPhase.NoScrollPhase, False,
        )  # fmt: skip
        QApplication.sendEvent(ruler, event)
        after = timeline.axis.scale
        assert (after.pixels > before.pixels) is zooms
        before = after


def test_time_is_zoomed_at_the_playhead_by_keys(timeline: Timeline, view_state: ViewState) -> None:
    handlers, before = timeline.handlers(), timeline.axis.scale
    view_state.set_frame(1020)
    x = before.x(1020)
    handlers["view.zoom_in_time"]()
    assert timeline.axis.scale.pixels == pytest.approx(1.25 * before.pixels)
    assert timeline.axis.scale.x(1020) == pytest.approx(x)
    wheel(timeline.ruler, x_of(timeline, 1040), 1200)
    assert timeline.axis.scale.first > 1020
    handlers["view.zoom_out_time"]()
    assert timeline.axis.scale.first <= 1020 < timeline.axis.scale.last
    for _ in range(20):
        handlers["view.zoom_out_time"]()
    assert timeline.axis.scale == before


def test_the_strip_follows_the_playhead(timeline: Timeline, view_state: ViewState) -> None:
    wheel(timeline.ruler, x_of(timeline, 1002), 1200)
    view_state.set_frame(1045)
    scale = timeline.axis.scale
    assert scale.first <= 1045 < scale.last


def test_every_kind_of_mark_is_painted(timeline: Timeline, document: Document) -> None:
    with_marks = timeline.rows.viewport().grab().toImage()
    project = document.project
    for shape in project.shapes:
        project = project.with_shape(edit.delete_engine_keys(shape))
    document.apply("Clear", project)
    without = timeline.rows.viewport().grab().toImage()
    x, middle = x_of(timeline, 1015), ROW // 2
    for below in (0, 8):  # the tick, and the notch of a doubt under it
        assert with_marks.pixelColor(x, middle + below) != without.pixelColor(x, middle + below)
    key = x_of(timeline, 1030)
    assert without.pixelColor(key, middle) == with_marks.pixelColor(key, middle)
    assert without.pixelColor(key, middle) != without.pixelColor(key + 40, middle)


@pytest.mark.parametrize("zoom", [1.0, 1.6, 1.75, 1.9, 2.05])
def test_no_label_touches_the_tab_of_the_playhead(timeline: Timeline, view_state: ViewState, zoom: float) -> None:
    ruler, axis, backgrounds = timeline.ruler, timeline.axis, {style.WINDOW, style.PANEL}
    axis.set_scale(axis.scale.zoomed(zoom, x_of(timeline, 1020)))

    def colours(columns: Iterable[int]) -> set[str]:
        picture = ruler.grab().toImage()
        return {picture.pixelColor(x, y).name() for x in columns for y in range(2, 18)}

    for frame in range(1014, 1026):
        view_state.set_frame(frame)
        left, right = int(ruler._tab().left()), int(ruler._tab().right()) + 2
        assert colours([*range(left - 3, left), *range(right, right + 2)]) <= backgrounds, frame
    label = range(x_of(timeline, 1020) - 12, x_of(timeline, 1020) + 12)
    assert not colours(label) <= backgrounds  # far from the tab the label is there


def test_the_plot_takes_the_height_that_the_rows_leave(qtbot: QtBot, timeline: Timeline, document: Document) -> None:
    rows, plot = timeline.rows, timeline.confidence

    def heights() -> tuple[int, int]:
        return rows.height(), plot.height()

    whole = timeline.height() - timeline.ruler.height() - timeline.boil.height()
    qtbot.waitUntil(lambda: heights() == (2 * ROW, whole - 2 * ROW), timeout=WAIT)
    assert plot.geometry().top() == rows.geometry().bottom() + 1
    lines = plot.lines
    for value in (0.0, 0.5, 1.0):  # the scale's values stand beside the lines' own
        drawn = lines.mapFromScene(lines._box.mapViewToScene(QPointF(1001, value)))
        assert abs(drawn.y() - plot.value_y(value)) <= 1.5
    project = document.project
    for _ in range(48):
        project, _shape = edit.new_shape(project, SQUARE, 1001)
    document.apply("Many", project)
    qtbot.waitUntil(lambda: heights() == (whole - LEAST_HEIGHT, LEAST_HEIGHT), timeout=WAIT)


def test_only_visible_rows_and_one_mark_a_pixel_are_drawn(timeline: Timeline, document: Document) -> None:
    """What makes 50 shapes of 2000 frames quick: work is bounded by pixels, not by keys."""
    scale = timeline.axis.scale
    crowded = np.arange(scale.clip[0] * 100, scale.clip[1] * 100) / 100
    columns = row_painter.columns(crowded, scale)
    assert len(columns) <= scale.width + 3
    project = document.project
    for _ in range(48):
        project, _shape = edit.new_shape(project, SQUARE, 1001)
    document.apply("Many", project)
    bar = timeline.rows.verticalScrollBar()
    assert bar.maximum() == 50 * ROW - timeline.rows.viewport().height()
    bar.setValue(10 * ROW)
    top = timeline.rows.shape_at(5)
    assert top is timeline.rows.rows()[10]


def test_scrubbing_paints_no_row_again(
    timeline: Timeline, view_state: ViewState, monkeypatch: pytest.MonkeyPatch
) -> None:
    painted: list[str] = []
    paint = row_painter._paint_marks

    def recorded(painter: QPainter, shape: RotoShape, *look: Any) -> None:
        painted.append(shape.id)
        paint(painter, shape, *look)

    monkeypatch.setattr(row_painter, "_paint_marks", recorded)
    timeline.rows.viewport().grab()
    painted.clear()
    view_state.set_frame(1020)
    timeline.rows.viewport().grab()
    assert painted == []
    view_state.select(frozenset({"shape-1"}))
    timeline.rows.viewport().grab()
    assert painted == ["shape-1"]


def test_a_selected_row_scrolls_into_sight(timeline: Timeline, document: Document, view_state: ViewState) -> None:
    project = document.project
    for _ in range(48):
        project, _shape = edit.new_shape(project, SQUARE, 1001)
    document.apply("Many", project)
    view_state.select(frozenset({"shape-1"}))
    rows = timeline.rows
    assert rows.shape_at(rows.viewport().height() - 3) is document.project.shape("shape-1")
    timeline.resize(timeline.width(), 700)
    timeline.grab()
    timeline.resize(timeline.width(), 260)  # the curve editor takes room of the rows, too
    timeline.grab()
    assert rows.shape_at(rows.viewport().height() - 3) is document.project.shape("shape-1")


def test_without_a_clip_there_is_no_time_to_see(timeline: Timeline, document: Document) -> None:
    document.open(Project(), None)
    picture = timeline.ruler.grab().toImage()
    assert {picture.pixelColor(x, 10).name() for x in range(0, picture.width(), 3)} == {picture.pixelColor(1, 1).name()}
