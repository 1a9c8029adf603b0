"""Mirroring and transforming by numbers, from keys of the keyboard."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialogButtonBox, QDoubleSpinBox
from pytestqt.qtbot import QtBot

from app.actions.actions import Actions
from app.actions.keymaps import load_keymap
from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import ViewState
from app.tools.edit.numbers import Numbers, NumbersDialog, matrix_of
from app.tools.edit.transform_actions import TransformActions
from roam_core.geometry import affine
from tests.gui.hand import CTRL, SHIFT, Hand
from tests.gui.tools.conftest import SQUARE, OnlyShape


@pytest.fixture(autouse=True)
def keys(canvas: CanvasView, document: Document, view_state: ViewState) -> None:
    """The actions' keys work in the viewer."""
    handlers = TransformActions(document, view_state, canvas).handlers()
    for child in canvas.findChildren(Actions):
        for name in handlers:
            child[name].setShortcuts([])
    Actions(canvas, canvas, {name: load_keymap()[name] for name in handlers}).connect_all(handlers)


def ask(hand: Hand) -> NumbersDialog:
    hand.key(Qt.Key.Key_M, CTRL)
    (dialog,) = (each for each in QApplication.topLevelWidgets() if isinstance(each, NumbersDialog))
    return dialog


def type_into(field: QDoubleSpinBox, text: str) -> None:
    field.selectAll()
    QTest.keyClicks(field, text)


def press(dialog: NumbersDialog, button: QDialogButtonBox.StandardButton, qtbot: QtBot) -> None:
    box = dialog.findChild(QDialogButtonBox)
    assert isinstance(box, QDialogButtonBox)
    qtbot.mouseClick(box.button(button), Qt.MouseButton.LeftButton)


def test_a_shape_is_mirrored_in_place(
    hand: Hand, document: Document, view_state: ViewState, smooth: str, only: OnlyShape
) -> None:
    view_state.select(frozenset({smooth}))
    left = only().at(1).flatten(0.5)[:, 0].min()
    right = only().at(1).flatten(0.5)[:, 0].max()
    hand.key(Qt.Key.Key_H, SHIFT)
    assert only.anchors()[0][0] == pytest.approx(left + right - SQUARE[0][0])
    np.testing.assert_allclose(only().at(1).points[0, :, 1], (40.0, 40.0, 40.0))
    assert document.undo_stack.undoText() == "Mirror horizontally"
    hand.key(Qt.Key.Key_H, SHIFT)
    np.testing.assert_allclose(only.anchors(), SQUARE, atol=1e-9)


def test_points_are_mirrored_about_their_own_middle(hand: Hand, view_state: ViewState, square: str, only: OnlyShape):
    view_state.select(frozenset(), frozenset({(square, 1), (square, 2)}))
    hand.key(Qt.Key.Key_V, SHIFT)
    assert only.anchors() == [SQUARE[0], SQUARE[2], SQUARE[1], SQUARE[3]]


def test_without_a_selection_it_says_what_to_do(hand: Hand, document: Document, view_state: ViewState, square: str):
    view_state.select(frozenset())
    hand.key(Qt.Key.Key_H, SHIFT)
    assert "Select a shape" in view_state.message
    assert document.undo_stack.count() == 0


def test_numbers_transform_exactly_and_are_previewed(
    hand: Hand, document: Document, view_state: ViewState, square: str, only: OnlyShape, qtbot: QtBot
) -> None:
    dialog = ask(hand)
    type_into(dialog.move_x, "12.5")
    assert view_state.preview is not None
    assert tuple(view_state.preview.shape(square).at(1).anchors[0]) == (52.5, 40.0)
    type_into(dialog.turn, "90")
    type_into(dialog.scale_x, "50")
    assert only.anchors() == SQUARE
    press(dialog, QDialogButtonBox.StandardButton.Ok, qtbot)
    # 80 wide, halved to 40 and turned: now 60 wide and 40 high about (80, 70), moved by 12.5.
    assert only.anchors() == [(122.5, 50.0), (122.5, 90.0), (62.5, 90.0), (62.5, 50.0)]
    assert view_state.preview is None
    assert document.undo_stack.count() == 1
    assert document.undo_stack.undoText() == "Transform"


def test_numbers_that_are_cancelled_change_nothing(
    hand: Hand, document: Document, view_state: ViewState, square: str, qtbot: QtBot
) -> None:
    dialog = ask(hand)
    type_into(dialog.shear_y, "30")
    press(dialog, QDialogButtonBox.StandardButton.Cancel, qtbot)
    assert view_state.preview is None
    assert document.undo_stack.count() == 0


def test_numbers_of_the_beginning_stand_for_nothing() -> None:
    places = np.array([(3.0, 4.0), (-1.0, 20.0)])
    np.testing.assert_array_equal(affine.apply(matrix_of(Numbers(), (7.0, 9.0)), places), places)


def test_shear_keeps_the_middle() -> None:
    matrix = matrix_of(Numbers(shear=(50.0, 0.0)), (10.0, 10.0))
    np.testing.assert_allclose(affine.apply(matrix, [(10.0, 10.0), (10.0, 20.0)]), [(10.0, 10.0), (15.0, 20.0)])


def test_a_turn_by_numbers_keeps_the_form_that_is_seen_of_pixels_that_are_not_square(
    document: Document, view_state: ViewState, square: str, only: OnlyShape
) -> None:
    clip = document.project.require_clip()
    document.apply("Clip", replace(document.project, clip=replace(clip, pixel_aspect=2.0)))
    view_state.select(frozenset({square}))
    seen = np.array(only.anchors()) * (2.0, 1.0)
    TransformActions(document, view_state).transform(Numbers(turn=90.0))
    (x, y), turned = seen.mean(axis=0), np.array(only.anchors()) * (2.0, 1.0)
    np.testing.assert_allclose(turned, np.column_stack([x - (seen[:, 1] - y), y + (seen[:, 0] - x)]))


def test_of_any_pixels_numbers_of_the_beginning_stand_for_nothing() -> None:
    places = np.array([(3.0, 4.0), (-1.0, 20.0)])
    np.testing.assert_array_equal(affine.apply(matrix_of(Numbers(), (7.0, 9.0), 1.33), places), places)
    matrix = matrix_of(Numbers(shear=(50.0, 0.0)), (10.0, 10.0), 2.0)
    np.testing.assert_allclose(affine.apply(matrix, [(10.0, 20.0)]), [(12.5, 20.0)])


def test_no_run_takes_the_playhead_away_while_numbers_are_asked_for(
    qtbot: QtBot, hand: Hand, document: Document, view_state: ViewState, square: str
) -> None:
    """It would be transformed where the run has come to."""
    view_state.select(frozenset({square}))
    dialog = ask(hand)
    assert view_state.keeps_frame
    press(dialog, QDialogButtonBox.StandardButton.Cancel, qtbot)
    assert not view_state.keeps_frame
    assert document.undo_stack.count() == 0
