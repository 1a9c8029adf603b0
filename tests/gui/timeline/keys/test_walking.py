"""Keys are chosen one after the other by the keyboard, in the rows of shapes, in those of values, and as curves."""

from __future__ import annotations

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.model.document import Document
from app.model.view_state import ViewState
from app.timeline.timeline import Timeline
from app.timeline.values.shown import Kind
from roam_core.roto import Animated, ValueKey, edit
from tests.gui.timeline.places import SQUARE
from tests.gui.waiting import WAIT

TAB, BACK, LEFT, RIGHT = Qt.Key.Key_Tab, Qt.Key.Key_Backtab, Qt.Key.Key_Left, Qt.Key.Key_Right
SHIFT = Qt.KeyboardModifier.ShiftModifier
NONE = Qt.KeyboardModifier.NoModifier
EXTENDS = Qt.KeyboardModifier.ControlModifier | SHIFT
FADES = Animated((ValueKey(1005, 0.2), ValueKey(1020, 0.8), ValueKey(1035, 0.5)))


@pytest.fixture
def rows(timeline: Timeline, document: Document) -> Timeline:
    """The timeline, whose shapes have keys on 1001 and 1030, and on 1010, 1030 and 1040."""
    shape = edit.set_key(document.project.shape("shape-2"), 1040, SQUARE)
    document.apply("Key", document.project.with_shape(shape))
    return timeline


def chosen(timeline: Timeline) -> list[tuple[int, str]]:
    return sorted((frame, shape_id[-1]) for shape_id, frame in timeline.keys.places)


def test_tab_goes_from_key_to_key_with_the_playhead(qtbot: QtBot, rows: Timeline, view_state: ViewState) -> None:
    seen = []
    for _ in range(5):
        qtbot.keyClick(rows.rows, TAB)
        seen += chosen(rows)
        assert view_state.frame == seen[-1][0]
    assert seen == [(1001, "1"), (1010, "2"), (1030, "2"), (1030, "1"), (1040, "2")]
    qtbot.keyClick(rows.rows, BACK, SHIFT)
    assert chosen(rows) == [(1030, "1")]


def test_it_stays_in_the_rows_of_what_is_selected(qtbot: QtBot, rows: Timeline, view_state: ViewState) -> None:
    view_state.select(frozenset({"shape-2"}))
    qtbot.keyClick(rows.rows, BACK, SHIFT)
    assert chosen(rows) == [(1040, "2")]
    qtbot.keyClick(rows.rows, BACK, SHIFT)
    qtbot.keyClick(rows.rows, BACK, SHIFT)
    assert chosen(rows) == [(1010, "2")]


def test_an_arrow_takes_the_next_key_to_them_and_back_again(
    qtbot: QtBot, rows: Timeline, view_state: ViewState, document: Document
) -> None:
    view_state.select(frozenset({"shape-2"}))
    rows.keys.select(frozenset({("shape-2", 1030)}))
    qtbot.keyClick(rows.rows, RIGHT, EXTENDS)
    assert chosen(rows) == [(1030, "2"), (1040, "2")]
    assert view_state.frame == 1040
    qtbot.keyClick(rows.rows, LEFT, EXTENDS)
    assert chosen(rows) == [(1030, "2")]
    qtbot.keyClick(rows.rows, LEFT, EXTENDS)
    assert chosen(rows) == [(1010, "2"), (1030, "2")]
    qtbot.keyClick(rows.rows, RIGHT, Qt.KeyboardModifier.AltModifier)
    assert document.project.shape("shape-2").artist_frames == (1011, 1031, 1040)


def test_those_that_were_chosen_by_the_mouse_stay(qtbot: QtBot, rows: Timeline) -> None:
    rows.keys.select(frozenset({("shape-1", 1001), ("shape-2", 1030)}))
    qtbot.keyClick(rows.rows, RIGHT, EXTENDS)
    qtbot.keyClick(rows.rows, RIGHT, EXTENDS)
    assert chosen(rows) == [(1001, "1"), (1030, "1"), (1030, "2"), (1040, "2")]
    qtbot.keyClick(rows.rows, LEFT, EXTENDS)
    assert chosen(rows) == [(1001, "1"), (1030, "1"), (1030, "2")]


def test_behind_the_last_key_tab_goes_to_the_next_control(
    qtbot: QtBot, rows: Timeline, document: Document, view_state: ViewState
) -> None:
    document.apply("Fade", edit.set_properties(document.project, "shape-2", opacity=FADES))
    view_state.select(frozenset({"shape-2"}))
    rows.activateWindow()
    rows.rows.setFocus()
    qtbot.waitUntil(rows.rows.hasFocus, timeout=WAIT)
    for _ in range(4):
        qtbot.keyClick(rows.rows, TAB)
    qtbot.waitUntil(rows.value_rows.hasFocus, timeout=WAIT)
    assert chosen(rows) == [(1040, "2")]
    qtbot.keyClick(rows.value_rows, TAB)
    qtbot.keyClick(rows.value_rows, RIGHT, EXTENDS)
    assert rows.values.places == {("shape-2", "opacity", frame) for frame in (1005, 1020)}
    assert chosen(rows) == []
    qtbot.keyClick(rows.value_rows, BACK, SHIFT)
    assert rows.values.places == {("shape-2", "opacity", 1005)}
    qtbot.keyClick(rows.value_rows, BACK, SHIFT)
    assert not rows.value_rows.hasFocus()


def test_it_goes_along_curves_in_the_same_way(
    qtbot: QtBot, rows: Timeline, document: Document, view_state: ViewState
) -> None:
    document.apply("Fade", edit.set_properties(document.project, "shape-2", opacity=FADES))
    view_state.select(frozenset({"shape-2"}))
    rows.curve_panel.show()
    rows.curves.show_kind(Kind.OPACITY)
    for key, modifiers in ((TAB, NONE), (TAB, NONE), (RIGHT, EXTENDS)):
        qtbot.keyClick(rows.curves.plot, key, modifiers)
    assert rows.values.places == {("shape-2", "opacity", frame) for frame in (1020, 1035)}


def test_the_row_of_the_key_comes_into_sight(qtbot: QtBot, rows: Timeline, document: Document) -> None:
    project = document.project
    for _ in range(30):
        project, _ = edit.new_shape(project, SQUARE, 1001)
    document.apply("Many", project)
    bar = rows.rows.verticalScrollBar()
    bar.setValue(0)
    rows.keys.select(frozenset({("shape-2", 1010)}))
    qtbot.keyClick(rows.rows, BACK, SHIFT)  # shape-1, the last row
    assert chosen(rows) == [(1001, "1")]
    assert bar.value() == bar.maximum()
