"""The review panel: notes are written, kept, undone; notes, doubts and boil are listed and a click goes there."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QLineEdit, QWidget
from pytestqt.qtbot import QtBot

from app.actions.actions import Actions
from app.actions.keymaps import load_keymap
from app.model.document import Document
from app.model.view_state import ViewState
from app.panels.review import NOTHING, Entry, Listed, ReviewPanel
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Clip, Keyframe, Mark, Origin, Project, edit, timing
from tests.gui.waiting import WAIT

CLIP = Clip(Path("/plates/shot"), 1001, 1020, (64, 48))
SQUARE = polygon_points([(10, 10), (30, 10), (30, 30), (10, 30)])
BENT, DOUBTED = 1010, 1014


def tracked_project() -> Project:
    """A square, out of shape on one frame and doubted on another."""
    project, shape = edit.new_shape(Project(CLIP), SQUARE, 1001, name="Arm")
    keys = []
    for frame in range(1002, 1021):
        points = SQUARE.copy()
        points[0] += 12.0 * (frame == BENT)
        keys.append(Keyframe(frame, points, origin=Origin.ENGINE, confidence=0.3 if frame == DOUBTED else 0.9))
    return project.with_shape(edit.set_engine_keys(shape, keys))


@pytest.fixture
def panel(qtbot: QtBot, document: Document, view_state: ViewState) -> Iterator[ReviewPanel]:
    """The panel beside a field that can have the keyboard."""
    window = QWidget()
    qtbot.addWidget(window)
    actions = Actions(window, window, load_keymap())
    panel = ReviewPanel(document, view_state, actions)
    for part in (panel, *panel.tools):
        part.setParent(window)
    QLineEdit(window).setObjectName("other")
    window.resize(400, 400)
    panel.resize(300, 380)
    with qtbot.waitExposed(window, timeout=WAIT):
        window.show()
    window.activateWindow()
    document.open(tracked_project(), None)
    view_state.set_frame(1005)
    qtbot.waitUntil(lambda: bool(panel.entries), timeout=WAIT)
    yield panel
    window.close()


def leave(qtbot: QtBot, panel: ReviewPanel) -> None:
    other = panel.window().findChild(QLineEdit, "other")
    other.setFocus()
    qtbot.waitUntil(lambda: not panel.note.hasFocus(), timeout=WAIT)


def typed(qtbot: QtBot, panel: ReviewPanel, text: str) -> None:
    panel.note.setFocus()
    qtbot.waitUntil(panel.note.hasFocus, timeout=WAIT)
    qtbot.keyClicks(panel.note, text)


def test_a_note_is_kept_when_the_field_is_left_and_undone_in_one_step(
    qtbot: QtBot, panel: ReviewPanel, document: Document
) -> None:
    typed(qtbot, panel, "the elbow slips")
    assert document.project.marks == ()
    leave(qtbot, panel)
    assert document.project.marks == (Mark(1005, "the elbow slips"),)
    assert document.undo_stack.undoText() == "Write note"
    document.undo_stack.undo()
    assert document.project.marks == ()
    assert panel.note.toPlainText() == ""


def test_ctrl_return_keeps_lines_and_esc_leaves_what_was_there(
    qtbot: QtBot, panel: ReviewPanel, document: Document
) -> None:
    typed(qtbot, panel, "elbow")
    qtbot.keyClick(panel.note, Qt.Key.Key_Return)
    qtbot.keyClicks(panel.note, "wrist")
    qtbot.keyClick(panel.note, Qt.Key.Key_Return, Qt.KeyboardModifier.ControlModifier)
    assert document.project.marks == (Mark(1005, "elbow\nwrist"),)
    typed(qtbot, panel, "never mind")
    qtbot.keyClick(panel.note, Qt.Key.Key_Escape)
    assert panel.note.toPlainText() == "elbow\nwrist"
    assert document.project.marks == (Mark(1005, "elbow\nwrist"),)
    assert document.undo_stack.count() == 1


def test_another_frame_shows_its_own_note_and_keeps_what_was_being_typed(
    qtbot: QtBot, panel: ReviewPanel, document: Document, view_state: ViewState
) -> None:
    document.apply("Mark", timing.set_mark(document.project, 1008, "hand"))
    typed(qtbot, panel, "elbow")
    view_state.set_frame(1008)
    assert panel.note.toPlainText() == "hand"
    assert document.project.marks == (Mark(1005, "elbow"), Mark(1008, "hand"))
    view_state.set_frame(1006)
    assert panel.note.toPlainText() == ""


def test_a_note_that_is_only_looked_at_is_no_edit(
    qtbot: QtBot, panel: ReviewPanel, document: Document, view_state: ViewState
) -> None:
    """Files of other programs may have notes that end in spaces."""
    marked = timing.set_mark(document.project, 1008, " the elbow slips \n")
    document.apply("Mark", marked)
    for frame in (1008, 1009):
        view_state.set_frame(frame)
    assert document.project is marked
    assert document.undo_stack.count() == 1


def test_an_emptied_note_goes_away_with_its_mark(qtbot: QtBot, panel: ReviewPanel, document: Document) -> None:
    document.apply("Mark", timing.set_mark(document.project, 1005, "elbow"))
    panel.note.setFocus()
    panel.note.selectAll()
    qtbot.keyClick(panel.note, Qt.Key.Key_Delete)
    leave(qtbot, panel)
    assert document.project.marks == ()
    assert document.undo_stack.undoText() == "Remove note"


def test_the_list_has_notes_doubts_and_boil_in_the_order_of_time(
    qtbot: QtBot, panel: ReviewPanel, document: Document
) -> None:
    document.apply("Mark", timing.set_mark(document.project, 1012, "the\nelbow"))
    qtbot.waitUntil(lambda: Listed.NOTE in [entry.kind for entry in panel.entries], timeout=WAIT)
    kinds = {entry.kind: entry for entry in panel.entries}
    assert kinds[Listed.NOTE] == Entry(1012, Listed.NOTE, "the elbow")
    assert kinds[Listed.DOUBT] == Entry(DOUBTED, Listed.DOUBT, "Arm", "0.30", "shape-1")
    assert BENT in [entry.frame for entry in panel.entries if entry.kind is Listed.BOIL]
    assert [entry.frame for entry in panel.entries] == sorted(entry.frame for entry in panel.entries)
    assert panel.count.text().startswith("1 note, 1 doubtful frame, ")
    texts = [panel.list.topLevelItem(row).text(1) for row in range(panel.list.topLevelItemCount())]
    assert "Arm boils" in texts


@pytest.mark.parametrize(("name", "kind"), [("notes", Listed.NOTE), ("doubts", Listed.DOUBT), ("boil", Listed.BOIL)])
def test_a_kind_can_be_listed_alone(panel: ReviewPanel, document: Document, name: str, kind: Listed) -> None:
    document.apply("Mark", timing.set_mark(document.project, 1012, "elbow"))
    panel.kinds.setCurrentIndex(panel.kinds.findData(name))
    assert {entry.kind for entry in panel.entries} == {kind}


def test_a_click_on_a_row_goes_to_its_frame_and_says_what_is_there(
    qtbot: QtBot, panel: ReviewPanel, view_state: ViewState
) -> None:
    row = [entry.frame for entry in panel.entries].index(DOUBTED)
    place = panel.list.visualItemRect(panel.list.topLevelItem(row)).center()
    qtbot.mouseClick(panel.list.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(place))
    assert view_state.frame == DOUBTED
    assert view_state.message == f"Frame {DOUBTED}: Arm, 0.30."
    assert panel.list.topLevelItem(row).isSelected()
    view_state.set_frame(1003)
    assert not panel.list.selectedItems()


def test_arrow_keys_go_from_row_to_row_and_to_their_frames(
    qtbot: QtBot, panel: ReviewPanel, view_state: ViewState
) -> None:
    """They marked rows, and the playhead stayed."""
    frames = [entry.frame for entry in panel.entries]
    view_state.set_frame(frames[0])
    panel.list.setFocus()
    for frame in frames[1:]:
        qtbot.keyClick(panel.list, Qt.Key.Key_Down)
        assert view_state.frame == frame
    qtbot.keyClick(panel.list, Qt.Key.Key_Up)
    assert view_state.frame == frames[-2]


def test_only_the_shapes_in_hand_are_listed_and_an_empty_list_says_so(
    qtbot: QtBot, panel: ReviewPanel, document: Document, view_state: ViewState
) -> None:
    project, calm = edit.new_shape(document.project, SQUARE, 1001, name="Calm")
    document.apply("Draw", project)
    view_state.select(frozenset([calm.id]))
    qtbot.waitUntil(lambda: panel.entries == [], timeout=WAIT)
    assert panel.count.text() == NOTHING


def test_a_hidden_panel_is_up_to_date_when_it_is_shown(qtbot: QtBot, panel: ReviewPanel, document: Document) -> None:
    panel.hide()
    shape = document.project.shape("shape-1")
    calm = replace(shape, keys=tuple(replace(key, confidence=None, points=SQUARE) for key in shape.keys))
    document.apply("Calm", document.project.with_shape(calm))
    assert panel.entries
    panel.show()
    assert panel.entries == []


def test_without_a_clip_a_note_has_no_frame(
    qtbot: QtBot, panel: ReviewPanel, document: Document, view_state: ViewState
) -> None:
    document.open(Project(), None)
    typed(qtbot, panel, "elbow")
    leave(qtbot, panel)
    assert document.project.marks == ()
    assert view_state.message == "Open a clip first: notes lie on its frames."


def test_a_frame_that_two_shapes_are_doubted_on_counts_once(
    qtbot: QtBot, panel: ReviewPanel, document: Document
) -> None:
    arm = document.project.shapes[0]
    document.apply("Duplicate", edit.add_shape(document.project, replace(arm, id="hand", name="Hand")))
    qtbot.waitUntil(lambda: sum(entry.frame == DOUBTED for entry in panel.entries) == 2, timeout=WAIT)
    assert panel.count.text().startswith("1 doubtful frame, ")
