"""Brackets beside several chosen keys stretch them in time: evenly, in order, as one undo step."""

from __future__ import annotations

from dataclasses import replace

import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from app.model.document import Document
from app.model.view_state import ViewState
from app.timeline.keys.stretch import BESIDE, TIP
from app.timeline.timeline import Timeline
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.roto import Animated, ValueKey, edit
from tests.gui.timeline.places import CLIP, place
from tests.gui.waiting import WAIT

LEFT, NO_BUTTON = Qt.MouseButton.LeftButton, Qt.MouseButton.NoButton
ASIDE = QPoint(round(BESIDE), 0)
FADES = Animated((ValueKey(1005, 0.2), ValueKey(1015, 0.8, slopes=(0.02, 0.02)), ValueKey(1025, 0.5)))
CHOSEN = frozenset({("shape-1", 1001), ("shape-1", 1030), ("shape-2", 1010), ("shape-2", 1030)})


@pytest.fixture
def chosen(timeline: Timeline) -> Timeline:
    """The keys of two shapes are chosen: 1001, 1010 and 1030."""
    timeline.keys.select(CHOSEN)
    return timeline


def send(widget: QWidget, kind: QEvent.Type, at: QPoint) -> None:
    button = NO_BUTTON if kind == QEvent.Type.MouseMove else LEFT
    held = NO_BUTTON if kind == QEvent.Type.MouseButtonRelease else LEFT
    where = QPointF(at), QPointF(widget.mapToGlobal(at))
    QApplication.sendEvent(widget, QMouseEvent(kind, *where, button, held, Qt.KeyboardModifier.NoModifier))


def grab(widget: QWidget, start: QPoint, end: QPoint) -> None:
    send(widget, QEvent.Type.MouseButtonPress, start)
    for at in (start + (end - start) / 2, end):
        send(widget, QEvent.Type.MouseMove, at)


def drag(widget: QWidget, start: QPoint, end: QPoint) -> None:
    grab(widget, start, end)
    send(widget, QEvent.Type.MouseButtonRelease, end)


def artist(document: Document, name: str) -> tuple[int, ...]:
    return document.project.shape(name).artist_frames


def test_the_last_bracket_stretches_and_the_first_key_stays(
    chosen: Timeline, document: Document, view_state: ViewState
) -> None:
    before, frame, port = document.project, view_state.frame, chosen.rows.viewport()
    start, end = (place(chosen, each, 0) + ASIDE for each in (1030, 1046))
    grab(port, start, end)
    assert document.project is before
    assert view_state.preview is not None
    assert view_state.message == "Stretch 4 keys: they go from frame 1001 to 1046."
    send(port, QEvent.Type.MouseButtonRelease, end)
    assert (artist(document, "shape-1"), artist(document, "shape-2")) == ((1001, 1046), (1015, 1046))
    assert chosen.keys.places == {("shape-1", 1001), ("shape-1", 1046), ("shape-2", 1015), ("shape-2", 1046)}
    assert (view_state.preview, view_state.frame) == (None, frame)
    assert (document.undo_stack.count(), document.undo_stack.undoText()) == (1, "Stretch keys")
    stamps = Stamps.of(document.project.shapes, CLIP)
    shape = document.project.shape("shape-2")
    assert all(stamps.is_stale(shape, key) for key in shape.keys if 1015 < key.frame < 1020)
    document.undo_stack.undo()
    assert document.project is before


def test_the_first_bracket_stretches_and_the_last_key_stays(chosen: Timeline, document: Document) -> None:
    chosen.keys.select(frozenset(each for each in CHOSEN if each[0] == "shape-2"))
    drag(chosen.rows.viewport(), place(chosen, 1010, 0) - ASIDE, place(chosen, 1020, 0) - ASIDE)
    assert (artist(document, "shape-1"), artist(document, "shape-2")) == ((1001, 1030), (1020, 1030))


def test_no_key_comes_over_another_nor_leaves_the_clip(chosen: Timeline, document: Document) -> None:
    port, bracket = chosen.rows.viewport(), place(chosen, 1030, 0) + ASIDE
    drag(port, bracket, place(chosen, 1001, 0))
    assert (artist(document, "shape-1"), artist(document, "shape-2")) == ((1001, 1003), (1002, 1003))
    document.undo_stack.undo()
    chosen.keys.select(CHOSEN)
    drag(port, bracket, QPoint(3000, bracket.y()))
    assert artist(document, "shape-1") == (1001, 1048)


def test_a_click_on_a_bracket_and_a_drag_that_esc_drops_change_nothing(
    qtbot: QtBot, chosen: Timeline, document: Document, view_state: ViewState
) -> None:
    before, frame, port = document.project, view_state.frame, chosen.rows.viewport()
    bracket = place(chosen, 1030, 0) + ASIDE
    drag(port, bracket, bracket)
    grab(port, bracket, bracket + QPoint(80, 0))
    qtbot.keyClick(chosen.rows, Qt.Key.Key_Escape)
    send(port, QEvent.Type.MouseButtonRelease, bracket)
    assert (document.project, view_state.preview, view_state.frame) == (before, None, frame)
    assert chosen.keys.places == CHOSEN


def test_keys_of_a_locked_shape_stay(chosen: Timeline, document: Document) -> None:
    document.apply("Lock", edit.set_properties(document.project, "shape-1", locked=True))
    drag(chosen.rows.viewport(), place(chosen, 1030, 0) + ASIDE, place(chosen, 1040, 0) + ASIDE)
    assert (artist(document, "shape-1"), artist(document, "shape-2")) == ((1001, 1030), (1010, 1040))


def test_one_key_has_no_brackets_and_a_key_beside_one_comes_first(chosen: Timeline, document: Document) -> None:
    rows, bracket = chosen.rows, place(chosen, 1030, 0) + ASIDE
    assert rows.tip_at(QPointF(bracket)) == TIP
    assert rows.tip_at(QPointF(place(chosen, 1030, 0))) != TIP
    chosen.keys.select(frozenset({("shape-1", 1030), ("shape-2", 1030)}))
    assert rows.tip_at(QPointF(bracket)) != TIP
    chosen.keys.select(frozenset({("shape-1", 1001), ("shape-1", 1030)}))
    beside = chosen.axis.scale.frame(bracket.x())
    document.apply("Key", document.project.with_shape(edit.key_here(document.project.shape("shape-1"), beside)))
    assert rows.key_at(QPointF(place(chosen, beside, 1))) == ("shape-1", beside)
    assert rows.tip_at(QPointF(place(chosen, beside, 1))) != TIP


def test_keys_of_values_are_stretched_with_their_tangents(
    qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    shape = replace(document.project.shape("shape-1"), opacity=FADES)
    document.apply("Fade", document.project.with_shape(shape))
    qtbot.waitUntil(timeline.value_rows.isVisible, timeout=WAIT)
    timeline.values.select(frozenset(("shape-1", "opacity", frame) for frame in FADES.frames))
    rows = timeline.value_rows
    assert rows.tip_at(QPointF(place(timeline, 1025, 0) + ASIDE)) == TIP
    drag(rows, place(timeline, 1025, 0) + ASIDE, place(timeline, 1045, 0) + ASIDE)
    opacity = document.project.shape("shape-1").opacity
    assert isinstance(opacity, Animated)
    assert opacity.frames == (1005, 1025, 1045)
    assert opacity.keys[1].slopes == (0.01, 0.01)
    for before, after in ((1005, 1005), (1010, 1015), (1020, 1035)):
        assert opacity.at(after) == pytest.approx(FADES.at(before))
    assert {frame for _, _, frame in timeline.values.places} == {1005, 1025, 1045}
    assert view_state.message == "Stretch 3 keys: they go from frame 1005 to 1045."
    assert document.undo_stack.undoText() == "Stretch keys"
