"""A name is typed where the hand is: the key that renames works over the viewer, not in the list of shapes alone."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractItemView, QLineEdit
from pytestqt.qtbot import QtBot

from app.features.verbs.shapes import NOTHING_SELECTED
from app.shell.main_window import MainWindow
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import edit
from tests.gui.waiting import WAIT
from tests.gui.windows import FIRST, opened_window, write_clip

SQUARE = polygon_points([(40, 30), (80, 30), (80, 70), (40, 70)])
TYPING = QAbstractItemView.State.EditingState


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    """Two shapes, of which the lower one lies in a layer; the viewer has the keyboard."""
    with opened_window(qtbot, write_clip(tmp_path / "plate"), tmp_path / "journal") as window:
        project, layer = edit.add_layer(window.document.project, name="Arm")
        project = edit.new_shape(project, SQUARE, FIRST, name="Lower", layer_id=layer.id)[0]
        project = edit.new_shape(project, SQUARE + 30, FIRST, name="Upper")[0]
        window.document.apply("Draw", project)
        window.canvas.setFocus()
        yield window


def select(window: MainWindow, name: str) -> None:
    found = [shape.id for shape in window.document.project.shapes if shape.name == name]
    window.view_state.select(frozenset(found))


def names(window: MainWindow) -> list[str]:
    return [shape.name for shape in window.document.project.shapes]


def field(window: MainWindow) -> QLineEdit:
    (found,) = window.shapes.tree.viewport().findChildren(QLineEdit)
    return found


def press(window: MainWindow) -> None:
    QTest.keyClick(window.canvas, Qt.Key.Key_F2)


def test_a_shape_that_was_just_drawn_is_named_from_the_viewer(qtbot: QtBot, window: MainWindow) -> None:
    """F2 did nothing there, and what was typed then took other tools and moved the playhead."""
    window.view_state.set_tool("bezier")
    select(window, "Upper")
    press(window)
    assert field(window).text() == "Upper"
    QTest.keyClicks(field(window), "near arm")
    QTest.keyClick(field(window), Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: names(window) == ["Lower", "near arm"], timeout=WAIT)
    assert window.document.undo_stack.undoText() == "Rename"
    qtbot.waitUntil(window.canvas.hasFocus, timeout=WAIT)
    assert window.view_state.tool == "bezier"
    assert [
        shape.name for shape in window.document.project.shapes if shape.id in window.view_state.selection.shapes
    ] == ["near arm"]


def test_its_row_comes_into_sight_wherever_it_was(window: MainWindow) -> None:
    """In a folded layer, left out by a search, in a panel that is folded in a column that is hidden."""
    tree, search = window.shapes.tree, window.shapes.search
    window.panels.shapes.fold(True)
    window.actions_by_id["view.panels"].setChecked(False)
    tree.collapseAll()
    search.setText("upper")
    select(window, "Lower")
    press(window)
    assert (search.text(), field(window).text()) == ("", "Lower")
    assert tree.isVisible()
    assert tree.viewport().rect().contains(tree.visualItemRect(tree.currentItem()).center())
    QTest.keyClicks(field(window), "far arm")
    QTest.keyClick(field(window), Qt.Key.Key_Escape)
    assert names(window) == ["Lower", "Upper"]


def test_a_layer_is_named_alike(qtbot: QtBot, window: MainWindow) -> None:
    (layer,) = window.document.project.root.children[:1]
    window.view_state.select(frozenset(), layers=frozenset({layer.id}))
    press(window)
    QTest.keyClicks(field(window), "Leg")
    QTest.keyClick(field(window), Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: window.document.project.find(layer.id).name == "Leg", timeout=WAIT)


def test_what_cannot_be_named_is_told(window: MainWindow) -> None:
    press(window)
    assert window.status.sentence.text() == NOTHING_SELECTED
    select(window, "Upper")
    (upper,) = window.view_state.selection.shapes
    window.document.apply("Lock", edit.set_properties(window.document.project, upper, locked=True))
    press(window)
    assert window.shapes.tree.state() is not TYPING
    assert window.status.sentence.text().startswith("What is selected is locked; unlock it first")
