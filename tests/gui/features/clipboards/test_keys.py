"""Copying the key of one frame by keys of the keyboard, pasting it elsewhere and through a range."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialogButtonBox
from pytestqt.qtbot import QtBot

from app.actions.actions import Actions
from app.actions.keymaps import load_keymap
from app.canvas.view import CanvasView
from app.features.clipboards.paste_range import PasteRangeDialog
from app.features.clipboards.shapes import ShapeClipboard
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import edit, file
from tests.gui.hand import ALT, CTRL, SHIFT, Hand
from tests.gui.tools.conftest import SQUARE, OnlyShape, only, square

__all__ = ["only", "square"]


@pytest.fixture
def keys(canvas: CanvasView, document: Document, view_state: ViewState, square: str) -> Iterator[None]:
    """The clipboard's keys work in the viewer, and nothing has been copied."""
    handlers = ShapeClipboard(document, view_state, canvas).handlers()
    for child in canvas.findChildren(Actions):
        for name in handlers:
            child[name].setShortcuts([])
    Actions(canvas, canvas, {name: load_keymap().get(name, ()) for name in handlers}).connect_all(handlers)
    QGuiApplication.clipboard().clear()
    yield
    QGuiApplication.clipboard().clear()


def copy_key(hand: Hand) -> None:
    hand.key(Qt.Key.Key_C, CTRL | ALT)


def paste_key(hand: Hand) -> None:
    hand.key(Qt.Key.Key_V, CTRL | ALT)


def move_on_frame(hand: Hand, view_state: ViewState, frame: int) -> None:
    """Move the whole square by (5, 10) on a frame, which gives it a key there."""
    view_state.set_frame(frame)
    hand.drag((80.0, 40.0), (85.0, 50.0))


MOVED = [(x + 5.0, y + 10.0) for x, y in SQUARE]


def test_a_key_is_copied_to_another_frame(
    hand: Hand, document: Document, view_state: ViewState, keys: None, only: OnlyShape
) -> None:
    copy_key(hand)
    move_on_frame(hand, view_state, 7)
    view_state.set_frame(12)
    paste_key(hand)
    assert only().artist_frames == (1, 7, 12)
    assert (only.anchors(7), only.anchors(12)) == (MOVED, SQUARE)
    assert document.undo_stack.undoText() == "Paste key"
    document.undo_stack.undo()
    assert only().artist_frames == (1, 7)


def test_paste_means_what_was_copied(
    hand: Hand, document: Document, view_state: ViewState, keys: None, only: OnlyShape
) -> None:
    copy_key(hand)
    view_state.set_frame(9)
    hand.key(Qt.Key.Key_V, CTRL)
    assert only().artist_frames == (1, 9)
    hand.key(Qt.Key.Key_C, CTRL)
    hand.key(Qt.Key.Key_V, CTRL)
    assert len(document.project.shapes) == 2
    paste_key(hand)
    assert "no key to paste" in view_state.message


def test_a_key_of_a_shape_with_other_points_is_refused_in_a_sentence(
    hand: Hand, document: Document, view_state: ViewState, keys: None
) -> None:
    project, triangle = edit.new_shape(document.project, polygon_points(SQUARE[:3]), 1)
    document.open(project, None)
    view_state.select(frozenset({project.shapes[0].id}))
    copy_key(hand)
    view_state.select(frozenset({triangle.id}))
    paste_key(hand)
    assert "has 3 points and the copied key 4" in view_state.message
    assert document.undo_stack.count() == 0


def test_a_key_goes_to_those_of_several_shapes_that_it_fits(
    hand: Hand, document: Document, view_state: ViewState, keys: None
) -> None:
    project, triangle = edit.new_shape(document.project, polygon_points(SQUARE[:3]), 1)
    project, other = edit.new_shape(project, polygon_points(SQUARE), 1)
    document.open(project, None)
    view_state.select(frozenset({project.shapes[0].id}))
    copy_key(hand)
    view_state.select(frozenset({triangle.id, other.id}))
    view_state.set_frame(5)
    paste_key(hand)
    assert document.project.shape(other.id).artist_frames == (1, 5)
    assert document.project.shape(triangle.id).artist_frames == (1,)
    assert "has 3 points and the copied key 4" in view_state.message


def test_a_locked_shape_takes_no_key(
    hand: Hand, document: Document, view_state: ViewState, keys: None, square: str, only: OnlyShape
) -> None:
    copy_key(hand)
    document.open(edit.set_properties(document.project, square, locked=True), None)
    view_state.select(frozenset({square}))
    view_state.set_frame(9)
    paste_key(hand)
    assert only().frames == (1,)
    assert "locked" in view_state.message


def ask(hand: Hand) -> PasteRangeDialog:
    """The dialog that Ctrl+Shift+V opens."""
    hand.key(Qt.Key.Key_V, CTRL | SHIFT)
    (dialog,) = (each for each in QApplication.topLevelWidgets() if isinstance(each, PasteRangeDialog))
    return dialog


def test_a_key_is_held_through_a_range(
    hand: Hand, document: Document, view_state: ViewState, keys: None, only: OnlyShape, qtbot: QtBot
) -> None:
    copy_key(hand)
    move_on_frame(hand, view_state, 5)
    for frame in (7, 12):
        view_state.set_frame(frame)
        hand.key(Qt.Key.Key_Right, ALT)
    view_state.set_play_range(4, 9)
    dialog = ask(hand)
    assert (dialog.first.value(), dialog.last.value(), dialog.step.text()) == (4, 8, "at both ends")
    dialog.last.selectAll()
    QTest.keyClicks(dialog.last, "10")
    buttons = dialog.findChild(QDialogButtonBox)
    assert isinstance(buttons, QDialogButtonBox)
    qtbot.mouseClick(buttons.button(QDialogButtonBox.StandardButton.Ok), Qt.MouseButton.LeftButton)
    assert only().artist_frames == (1, 4, 10, 12)
    for frame in range(4, 11):
        np.testing.assert_allclose(only.anchors(frame), SQUARE)
    assert document.undo_stack.undoText() == "Paste key to range"


def test_a_range_that_is_cancelled_changes_nothing(hand: Hand, document: Document, keys: None, only: OnlyShape) -> None:
    copy_key(hand)
    dialog = ask(hand)
    QTest.keyClick(dialog, Qt.Key.Key_Escape)
    assert document.undo_stack.count() == 0


def test_a_range_cannot_end_before_it_begins(hand: Hand, keys: None) -> None:
    copy_key(hand)
    dialog = ask(hand)
    dialog.first.setValue(15)
    assert dialog.last.value() == 15
    dialog.last.setValue(999)
    assert dialog.last.value() == 20  # the clip's last frame
    dialog.reject()


def test_without_a_copied_key_no_range_is_asked_for(hand: Hand, view_state: ViewState, keys: None) -> None:
    hand.key(Qt.Key.Key_V, CTRL | SHIFT)
    assert "no key to paste" in view_state.message


def test_feather_is_pasted_with_the_key(
    hand: Hand, document: Document, view_state: ViewState, keys: None, only: OnlyShape
) -> None:
    feather = np.ones((4, 3, 2))
    document.open(document.project.with_shape(edit.set_key(only(), 1, only().keys[0].points, feather)), None)
    view_state.select(frozenset({only().id}))
    copy_key(hand)
    view_state.set_frame(9)
    paste_key(hand)
    np.testing.assert_array_equal(only().keys[-1].feather, feather)


def test_keys_of_several_shapes_say_that_they_belong_to_others(
    keys: None, hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    project = document.project
    for _ in range(2):
        project, _ = edit.new_shape(project, polygon_points(SQUARE), 1)
    document.apply("Others", project)
    ids = [shape.id for shape in project.shapes]
    view_state.select(frozenset(ids[:2]))
    copy_key(hand)
    view_state.select(frozenset(ids[2:]))
    paste_key(hand)
    assert document.project is project
    assert view_state.message == (
        "The copied keys are of other shapes: select those, or as many shapes as were copied."
    )


@pytest.mark.parametrize("how", ["locked", "hidden"])
@pytest.mark.parametrize("chosen", [True, False])
def test_of_several_shapes_the_one_that_takes_no_key_is_told(
    keys: None, hand: Hand, document: Document, view_state: ViewState, square: str, how: str, chosen: bool
) -> None:
    """It was passed over without a word."""
    project, other = edit.new_shape(document.project, polygon_points(SQUARE), 1)
    document.open(project, None)
    view_state.select(frozenset({square, other.id}))
    copy_key(hand)
    change = {"locked": True} if how == "locked" else {"visible": False}
    document.apply("Keep", edit.set_properties(project, square, **change))
    if not chosen:
        view_state.select(frozenset())
    view_state.set_frame(9)
    paste_key(hand)
    assert document.project.shape(other.id).artist_frames == (1, 9)
    assert document.project.shape(square).artist_frames == (1,)
    name = document.project.shape(square).name
    assert view_state.message == f"{name!r} is locked or hidden; unlock and show it to edit it."


def test_a_key_goes_back_to_its_own_shape_or_says_what_keeps_it(
    keys: None, hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    """To select a shape was asked for, of a key that goes back without."""
    copy_key(hand)
    document.apply("Lock", edit.set_properties(document.project, square, locked=True))
    view_state.select(frozenset())
    view_state.set_frame(9)
    paste_key(hand)
    assert "is locked or hidden" in view_state.message


@pytest.mark.parametrize(("range_", "is_there"), [(range(4, 9), True), (range(15, 18), False)])
def test_a_range_is_where_the_shape_has_to_exist_not_the_playhead(
    keys: None, hand: Hand, document: Document, view_state: ViewState, square: str, only: OnlyShape,
    range_: range, is_there: bool,
) -> None:  # fmt: skip
    clipboard = ShapeClipboard(document, view_state).keys
    copy_key(hand)
    document.apply("Lifetime", edit.set_properties(document.project, square, lifetime=(1, 10)))
    view_state.set_frame(12 if is_there else 5)
    clipboard.paste_through(range_, 0)
    assert only().artist_frames == ((1, range_[0], range_[-1]) if is_there else (1,))
    assert ("does not exist on frame" in view_state.message) is not is_there


def test_what_was_copied_is_read_once_as_it_is_pasted(
    keys: None, document: Document, view_state: ViewState, square: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    clipboard = ShapeClipboard(document, view_state)
    clipboard.copy()
    texts: list[str] = []
    monkeypatch.setattr(file, "loads", lambda text, *given, own=file.loads: texts.append(text) or own(text, *given))
    clipboard.paste()
    assert len(document.project.shapes) == 2
    assert len(texts) == 1
