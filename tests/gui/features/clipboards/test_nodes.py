"""Copy for Nuke and Fusion, and paste of text of other programs, by keys and menus of the whole window."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QGuiApplication
from PySide6.QtWidgets import QMenu
from pytestqt.qtbot import QtBot

from app.shell.main_window import MainWindow
from roam_core.geometry.bezier import polygon_points
from roam_core.interchange.clipboard import format_of, node_text, read_text
from roam_core.roto import Layer, Project, edit
from tests.gui.waiting import WAIT
from tests.gui.windows import opened_window, write_clip

CTRL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
SQUARE = polygon_points([(10, 10), (60, 10), (60, 50), (10, 50)])


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    """A window on a clip with two shapes, one of which lies in a layer; the clipboard is empty before and after."""
    QGuiApplication.clipboard().clear()
    with opened_window(qtbot, write_clip(tmp_path / "plate", 3), tmp_path / "journal") as window:
        project, layer = edit.add_layer(window.document.project, name="Body")
        project, _ = edit.new_shape(project, SQUARE, 1001, name="Arm", layer_id=layer.id)
        project, _ = edit.new_shape(project, SQUARE + 20.0, 1001, name="Leg")
        window.document.apply("Draw", project)
        yield window
    QGuiApplication.clipboard().clear()


def copied(qtbot: QtBot, window: MainWindow, title: str) -> str:
    """Choose an entry of the Edit menu, wait for the end; gives what is on the clipboard."""
    with qtbot.waitSignal(window.copying.finished, timeout=WAIT):
        entry(window, title).trigger()
    return QGuiApplication.clipboard().text()


def entry(window: MainWindow, title: str) -> QAction:
    (menu,) = (menu for menu in window.findChildren(QMenu) if menu.title() == "Edit")
    (action,) = (action for action in menu.actions() if action.text() == title)
    return action


def pasted(qtbot: QtBot, window: MainWindow, text: str) -> None:
    """Put a text on the clipboard and press Ctrl+V in the viewer."""
    QGuiApplication.clipboard().setText(text)
    with qtbot.waitSignal(window.importing.finished, timeout=WAIT):
        qtbot.keyClick(window.canvas, Qt.Key.Key_V, CTRL)


def names(project: Project) -> list[str]:
    return [shape.name for shape in project.shapes]


@pytest.mark.parametrize(("title", "word"), [("Copy for Nuke", "Roto {"), ("Copy for Fusion", "= PolylineMask {")])
def test_all_shapes_or_the_selected_ones_are_copied_for_another_program(
    qtbot: QtBot, window: MainWindow, title: str, word: str
) -> None:
    text = copied(qtbot, window, title)
    assert word in text
    assert "Arm" in text
    assert "Leg" in text
    assert window.status.sentence.text().startswith(f"Copied 2 shapes for {title.split()[-1]}; paste there.")
    window.view_state.select(frozenset({window.document.project.shapes[0].id}))
    text = copied(qtbot, window, title)
    assert "Arm" in text
    assert "Leg" not in text
    assert window.status.sentence.text().startswith(f"Copied 1 shape for {title.split()[-1]}; paste there.")


def test_a_key_copies_for_nuke_and_what_is_left_out_is_told(qtbot: QtBot, window: MainWindow) -> None:
    with qtbot.waitSignal(window.copying.finished, timeout=WAIT):
        qtbot.keyClick(window.canvas, Qt.Key.Key_C, CTRL | SHIFT)
    importer = format_of(QGuiApplication.clipboard().text())
    assert importer is not None
    assert importer.name == "nuke"
    shape = window.document.project.shapes[1]
    window.document.apply("Soften", window.document.project.with_shape(replace(shape, feather=4.0)))
    copied(qtbot, window, "Copy for Fusion")
    assert "Fusion softens on both sides of an outline: 'Leg' may look a little different." in (
        window.status.sentence.text()
    )


def test_with_nothing_to_copy_the_clipboard_stays(qtbot: QtBot, window: MainWindow) -> None:
    project = window.document.project
    window.document.apply("Delete", edit.remove_items(project, [child.id for child in project.root.children]))
    QGuiApplication.clipboard().setText("kept")
    entry(window, "Copy for Nuke").trigger()
    assert window.status.sentence.text() == "There is no shape to copy for Nuke; draw one first."
    assert QGuiApplication.clipboard().text() == "kept"


@pytest.mark.parametrize("name", ["nuke", "fusion", "svg", "json", "silhouette"])
def test_text_of_another_program_is_pasted_selected_and_undone_as_one(
    qtbot: QtBot, window: MainWindow, name: str
) -> None:
    before = window.document.project
    pasted(qtbot, window, node_text(name, before)[0])
    after = window.document.project
    assert names(after) == ["Arm", "Leg", "Arm", "Leg"]
    assert len({shape.id for shape in after.shapes}) == 4
    np.testing.assert_allclose(after.shapes[2].at(1001).points, SQUARE, atol=1e-3)
    assert window.view_state.selection.shapes == {shape.id for shape in after.shapes[2:]}
    pasted_layers = {child.id for child in after.root.children[2:] if isinstance(child, Layer)}
    assert window.view_state.layers == pasted_layers
    assert bool(pasted_layers) is (name != "fusion")  # whose masks know no layers
    assert window.status.sentence.text().startswith("Read 2 shapes from the clipboard.")
    assert entry(window, "Undo Paste").isEnabled()
    window.document.undo_stack.undo()
    assert window.document.project is before


def test_what_was_copied_for_nuke_comes_back(qtbot: QtBot, window: MainWindow) -> None:
    text = copied(qtbot, window, "Copy for Nuke")
    clip = window.document.project.require_clip()
    assert [shape.name for shape in read_text(text, clip).layer.shapes()] == ["Arm", "Leg"]
    pasted(qtbot, window, text)
    assert names(window.document.project) == ["Arm", "Leg"] * 2


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("milk, bread", "There is no shape to paste; copy one first, here or in another program."),
        ("", "There is no shape to paste; copy one first, here or in another program."),
        ("set cut_paste_input [stack 0]\nBlur {\n}\n", "The clipboard holds no Roto or RotoPaint node."),
        ('{"format": "roam-shapes", "version": 9}', "The clipboard"),
    ],
)
def test_text_without_shapes_changes_nothing_and_is_told_in_one_sentence(
    qtbot: QtBot, window: MainWindow, text: str, sentence: str
) -> None:
    before = window.document.project
    if sentence.startswith("There"):
        QGuiApplication.clipboard().setText(text)
        qtbot.keyClick(window.canvas, Qt.Key.Key_V, CTRL)
    else:
        pasted(qtbot, window, text)
    assert window.document.project is before
    assert QGuiApplication.clipboard().text() == text
    assert window.status.sentence.text().startswith(sentence)
    assert window.status.sentence.text().count(". ") == 0
