"""Marks on frames: set by a key, named in place, dragged, removed; kept in the project and undone."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import QPoint, QPointF, Qt
from pytestqt.qtbot import QtBot

from app.model.document import Document
from app.model.view_state import ViewState
from app.timeline.mark_verbs import NO_CLIP
from app.timeline.scale import LABEL_WIDTH
from app.timeline.timeline import Timeline
from roam_core.roto import Mark, Project, timing
from tests.gui.timeline.places import x_of
from tests.gui.waiting import WAIT

LEFT = Qt.MouseButton.LeftButton


def handler(timeline: Timeline, name: str) -> Callable[[], object]:
    return timeline.handlers()[name]


def marked(qtbot: QtBot, timeline: Timeline, document: Document, *marks: Mark) -> None:
    project = document.project
    for mark in marks:
        project = timing.set_mark(project, mark.frame, mark.text)
    document.apply("Mark", project)
    qtbot.waitUntil(timeline.marks.isVisible, timeout=WAIT)


def test_m_marks_the_frame_and_takes_the_mark_away(
    qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    toggle = handler(timeline, "mark.toggle")
    assert not timeline.marks.isVisible()
    view_state.set_frame(1012)
    toggle()
    assert document.project.marks == (Mark(1012),)
    assert timeline.marks.isVisible()
    toggle()
    assert document.project.marks == ()
    assert not timeline.marks.isVisible()
    document.undo_stack.undo()
    assert document.project.marks == (Mark(1012),)


def test_m_says_so_where_a_note_goes_with_its_mark(
    timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    document.apply("Note", timing.set_mark(document.project, 1012, "the elbow slips"))
    view_state.set_frame(1012)
    handler(timeline, "mark.toggle")()
    assert document.project.marks == ()
    assert document.undo_stack.undoText() == "Remove note"
    assert view_state.message == "The note of frame 1012 went with its mark; Ctrl+Z brings it back."


def test_a_mark_is_named_in_place(qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState) -> None:
    view_state.set_frame(1012)
    handler(timeline, "mark.name")()
    field = timeline.marks.field
    timeline.activateWindow()
    qtbot.waitUntil(field.hasFocus, timeout=WAIT)
    qtbot.keyClicks(field, "turn")
    qtbot.keyClick(field, Qt.Key.Key_Return)
    assert document.project.marks == (Mark(1012, "turn"),)
    assert not field.isVisible()
    assert document.undo_stack.undoText() == "Write note"


def test_esc_leaves_the_word_as_it_was(qtbot: QtBot, timeline: Timeline, document: Document) -> None:
    marked(qtbot, timeline, document, Mark(1012, "turn"))
    qtbot.mouseDClick(timeline.marks, LEFT, pos=QPoint(x_of(timeline, 1012), 8))
    field = timeline.marks.field
    assert field.text() == "turn"
    qtbot.keyClicks(field, "away")
    qtbot.keyClick(field, Qt.Key.Key_Escape)
    assert not field.isVisible()
    assert document.project.marks == (Mark(1012, "turn"),)


def test_a_click_goes_to_a_mark_and_a_drag_moves_it(
    qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    marked(qtbot, timeline, document, Mark(1012, "turn"), Mark(1020))
    band = timeline.marks
    qtbot.mouseClick(band, LEFT, pos=QPoint(x_of(timeline, 1012) + 5, 8))
    assert view_state.frame == 1012
    steps = document.undo_stack.count()
    qtbot.mousePress(band, LEFT, pos=QPoint(x_of(timeline, 1012), 8))
    for frame in (1013, 1030):
        qtbot.mouseMove(band, QPoint(x_of(timeline, frame), 8))
    assert document.project.marks == (Mark(1012, "turn"), Mark(1020))
    qtbot.mouseRelease(band, LEFT, pos=QPoint(x_of(timeline, 1030), 8))
    assert document.project.marks == (Mark(1020), Mark(1030, "turn"))
    assert document.undo_stack.count() == steps + 1


def test_a_right_click_removes_a_mark(qtbot: QtBot, timeline: Timeline, document: Document) -> None:
    marked(qtbot, timeline, document, Mark(1012), Mark(1020))
    qtbot.mouseClick(timeline.marks, Qt.MouseButton.RightButton, pos=QPoint(x_of(timeline, 1012), 8))
    assert document.project.marks == (Mark(1020),)


def test_a_right_click_on_a_note_says_that_it_goes_with_its_mark(
    qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    marked(qtbot, timeline, document, Mark(1012, "the elbow slips"))
    qtbot.mouseClick(timeline.marks, Qt.MouseButton.RightButton, pos=QPoint(x_of(timeline, 1012), 8))
    assert document.project.marks == ()
    assert view_state.message == "The note of frame 1012 went with its mark; Ctrl+Z brings it back."


def test_keys_go_from_mark_to_mark(qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState) -> None:
    marked(qtbot, timeline, document, Mark(1012), Mark(1020))
    visited, told = [], []
    for step in ("time.next_mark", "time.next_mark", "time.next_mark", "time.previous_mark"):
        handler(timeline, step)()
        visited.append(view_state.frame)
        told.append(view_state.message)
    assert visited == [1012, 1020, 1020, 1012]
    assert told == ["", "", "There is no mark after this frame.", ""]  # it is untrue on the frame before


def test_a_mark_and_its_word_are_seen(qtbot: QtBot, timeline: Timeline, document: Document) -> None:
    marked(qtbot, timeline, document, Mark(1012))
    bare = timeline.marks.grab().toImage()
    marked(qtbot, timeline, document, Mark(1012, "turn"))
    named = timeline.marks.grab().toImage()
    x = x_of(timeline, 1012)
    assert bare.pixelColor(x, 7) == named.pixelColor(x, 7) != named.pixelColor(x - 20, 7)
    assert any(bare.pixelColor(x + dx, 9) != named.pixelColor(x + dx, 9) for dx in range(8, 30))
    assert timeline.marks.tip_at(QPointF(x, 1.0)).startswith("Frame 1012: turn\n")


def test_without_a_clip_there_is_nothing_to_mark(timeline: Timeline, document: Document, view_state: ViewState) -> None:
    document.open(Project(), None)
    for name in ("mark.toggle", "mark.name"):
        handler(timeline, name)()
    assert document.project.marks == ()
    assert view_state.message == NO_CLIP


def test_a_note_half_typed_is_kept_when_another_one_is_written(
    qtbot: QtBot, timeline: Timeline, document: Document
) -> None:
    """It was gone without a word."""
    marked(qtbot, timeline, document, Mark(1012), Mark(1030, "turn"))
    field = timeline.marks.field
    timeline.marks.edit(1012)
    field.setText("the elbow slips")
    qtbot.mouseDClick(timeline.marks, LEFT, pos=QPoint(x_of(timeline, 1030), 8))
    assert document.project.marks == (Mark(1012, "the elbow slips"), Mark(1030, "turn"))
    assert (field.isVisible(), field.text()) == (True, "turn")


def test_a_note_that_is_emptied_goes_with_its_mark(qtbot: QtBot, timeline: Timeline, document: Document) -> None:
    marked(qtbot, timeline, document, Mark(1012, "turn"), Mark(1020))
    for frame in (1012, 1020):  # a mark that never had a note stays
        timeline.marks.edit(frame)
        timeline.marks.field.clear()
        qtbot.keyClick(timeline.marks.field, Qt.Key.Key_Return)
    assert document.project.marks == (Mark(1020),)
    assert document.undo_stack.undoText() == "Remove note"
    document.undo_stack.undo()
    assert document.project.marks == (Mark(1012, "turn"), Mark(1020))


def test_a_flag_under_the_names_is_out_of_reach(
    qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    marked(qtbot, timeline, document, Mark(1012, "turn"))
    view_state.set_frame(1020)
    timeline.axis.set_scale(replace(timeline.axis.scale, pixels=20.0, first=1012.7))
    x = x_of(timeline, 1012)
    assert 0 < x < LABEL_WIDTH
    for button in (LEFT, Qt.MouseButton.RightButton):
        qtbot.mouseClick(timeline.marks, button, pos=QPoint(x, 8))
    assert document.project.marks == (Mark(1012, "turn"),)
    assert view_state.frame == 1020
    assert timeline.marks.tip_at(QPointF(x, 8.0)) == ""
