"""The rows of planar tracks: there while something is tracked, they tell how far, and hold its adjust keys."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QColor
from pytestqt.qtbot import QtBot

from app import style
from app.model.document import Document
from app.model.view_state import ViewState
from app.timeline.keys.row_painter import ROW
from app.timeline.timeline import Timeline
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Layer, edit
from roam_core.roto.following import followed, pinned, surface_at, with_moving_layer
from tests.gui.timeline.places import x_of
from tests.gui.waiting import WAIT

LEFT, RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton
SQUARE = polygon_points([(10.0, 10.0), (30.0, 10.0), (30.0, 26.0), (10.0, 26.0)])
FIRST, DOUBTED, HIDDEN, ADJUSTED = 1005, 1010, 1012, 1014


@pytest.fixture
def tracked(qtbot: QtBot, timeline: Timeline, document: Document) -> str:
    """A tracked layer, doubted on one frame, hidden on another, with an adjust key; its id."""
    project, shape = edit.new_shape(document.project, SQUARE, FIRST)
    project, layer_id = with_moving_layer(project, [shape.id], FIRST)
    for frame in range(FIRST + 1, 1017):
        trust = {DOUBTED: 0.4, HIDDEN: 0.0}.get(frame, 0.95)
        project = followed(project, layer_id, FIRST, frame, np.eye(3), trust)
    project = pinned(project, layer_id, ADJUSTED, surface_at(project, layer_id, ADJUSTED) + 2.0)
    document.apply("Planar track", project)
    qtbot.waitUntil(timeline.tracks.isVisible, timeout=WAIT)
    return layer_id


def test_the_row_comes_and_goes_with_the_track(timeline: Timeline, document: Document, tracked: str) -> None:
    assert [layer.id for layer in timeline.tracks.rows()] == [tracked]
    assert timeline.tracks.height() == ROW
    document.undo_stack.undo()
    assert not timeline.tracks.isVisible()


def test_doubt_is_filled_in(timeline: Timeline, document: Document, tracked: str) -> None:
    image = timeline.tracks.grab().toImage()
    ratio = image.devicePixelRatio()

    def inks(frame: int) -> set[str]:
        x = round(x_of(timeline, frame) * ratio) - 2
        return {QColor(image.pixel(x, round(y * ratio))).name() for y in range(2, ROW - 2)}

    assert style.DOUBT in inks(DOUBTED)
    assert style.DOUBT in inks(HIDDEN)
    assert style.DOUBT not in inks(FIRST + 2)


def test_tips_say_what_lies_there(timeline: Timeline, tracked: str) -> None:
    def tip(frame: int) -> str:
        return timeline.tracks.tip_at(QPointF(x_of(timeline, frame), 8))

    assert tip(DOUBTED) == f"Frame {DOUBTED}: confidence 0.40, worth a look"
    assert "hidden" in tip(HIDDEN)
    assert "an adjust key of Planar 1" in tip(ADJUSTED)
    assert tip(1017).endswith("not tracked")
    assert timeline.tracks.tip_at(QPointF(20, 8)).startswith("The motion of Planar 1")


def test_clicks_go_to_frames_and_select(
    qtbot: QtBot, timeline: Timeline, view_state: ViewState, document: Document, tracked: str
) -> None:
    qtbot.mouseClick(timeline.tracks, LEFT, pos=QPoint(round(x_of(timeline, DOUBTED)), 8))
    assert view_state.frame == DOUBTED
    qtbot.mouseClick(timeline.tracks, LEFT, pos=QPoint(round(x_of(timeline, ADJUSTED)) + 3, 8))
    assert view_state.frame == ADJUSTED
    view_state.select(frozenset())
    qtbot.mouseClick(timeline.tracks, LEFT, pos=QPoint(30, 8))
    assert view_state.selection.shapes == {"shape-3"}


def test_a_right_click_takes_an_adjust_key_away(
    qtbot: QtBot, timeline: Timeline, document: Document, tracked: str
) -> None:
    qtbot.mouseClick(timeline.tracks, RIGHT, pos=QPoint(round(x_of(timeline, ADJUSTED)), 8))
    layer = document.project.find(tracked)
    assert isinstance(layer, Layer)
    assert layer.transform.adjusted == (FIRST,)
    assert document.undo_stack.undoText() == "Remove adjust key"


def test_the_tracks_of_the_selection_are_shown(
    timeline: Timeline, document: Document, view_state: ViewState, tracked: str
) -> None:
    project, other = edit.new_shape(document.project, SQUARE, FIRST)
    project, layer_id = with_moving_layer(project, [other.id], FIRST)
    document.apply("Track", followed(project, layer_id, FIRST, FIRST + 1, np.eye(3), 1.0))
    assert len(timeline.tracks.rows()) == 2
    view_state.select(frozenset({other.id}))
    assert [layer.id for layer in timeline.tracks.rows()] == [layer_id]


def test_a_track_of_an_older_project_tells_no_confidence(timeline: Timeline, document: Document, tracked: str) -> None:
    def aged(layer: Layer) -> Layer:
        assert layer.transform is not None
        return replace(layer, transform=replace(layer.transform, confidence=(), adjusted=()))

    document.apply("Age", document.project.map_item(tracked, aged))
    tip = timeline.tracks.tip_at(QPointF(x_of(timeline, DOUBTED), 8))
    assert tip.endswith("tracked before confidence was kept")


def test_an_adjust_key_of_a_locked_layer_stays(
    qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState, tracked: str
) -> None:
    document.apply("Lock", edit.set_properties(document.project, tracked, locked=True))
    before = document.project
    qtbot.mouseClick(timeline.tracks, RIGHT, pos=QPoint(x_of(timeline, ADJUSTED), ROW // 2))
    assert document.project is before
    assert view_state.message == "Planar 1 is locked; unlock it to remove its adjust keys."


def test_a_press_on_the_names_that_is_dragged_into_the_frames_does_not_scrub(
    qtbot: QtBot, timeline: Timeline, view_state: ViewState, tracked: str
) -> None:
    view_state.set_frame(FIRST)
    for start, reached in ((30, FIRST), (x_of(timeline, DOUBTED), 1020)):
        qtbot.mousePress(timeline.tracks, LEFT, pos=QPoint(start, 8))
        qtbot.mouseMove(timeline.tracks, QPoint(x_of(timeline, 1020), 8))
        qtbot.mouseRelease(timeline.tracks, LEFT, pos=QPoint(x_of(timeline, 1020), 8))
        assert view_state.frame == reached
