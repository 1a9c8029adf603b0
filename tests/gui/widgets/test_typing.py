"""What is being typed stays while the project and the frame change under it, and means the project it was begun in."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractItemView, QAbstractSpinBox, QLineEdit, QWidget
from pytestqt.qtbot import QtBot

from app.shell.main_window import MainWindow
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Mark, Project, edit, file
from tests.gui.waiting import WAIT
from tests.gui.windows import FIRST, opened_window, write_clip

SQUARE = polygon_points([(40, 30), (80, 30), (80, 70), (40, 70)])
FIELDS = ("name", "feather", "opacity", "in", "out", "frame")


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    """Two shapes; the first of them is selected."""
    with opened_window(qtbot, write_clip(tmp_path / "plate"), tmp_path / "journal") as window:
        window.document.open(two_shapes(window.document.project), None)
        window.view_state.select(frozenset({"shape-1"}))
        window.activateWindow()
        qtbot.waitUntil(window.isActiveWindow, timeout=WAIT)
        yield window


def two_shapes(project: Project) -> Project:
    for _ in range(2):
        project, _shape = edit.new_shape(project, SQUARE, FIRST)
    return project


def field_of(window: MainWindow, name: str) -> QLineEdit | QAbstractSpinBox:
    panel, transport = window.properties, window.transport
    fields: dict[str, QLineEdit | QAbstractSpinBox] = {
        "name": panel.name,
        "feather": panel.feather,
        "opacity": panel.opacity,
        "in": transport._in,
        "out": transport._out,
        "frame": transport._frame,
    }
    return fields[name]


def begin(field: QWidget, text: str) -> None:
    assert isinstance(field, QLineEdit | QAbstractSpinBox)
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, text)


def track_a_frame(window: MainWindow) -> None:
    """What a run does: a key of a shape, and the next frame."""
    document, view = window.document, window.view_state
    shape = document.project.shape("shape-2")
    moved = edit.set_key(shape, view.frame + 1, shape.at(view.frame).points + 1.0)
    document.apply("Track", document.project.with_shape(moved), "track-1")
    view.set_frame(view.frame + 1)


@pytest.mark.parametrize(
    ("name", "text", "found"),
    [
        ("name", "Head", lambda window: window.document.project.shape("shape-1").name == "Head"),
        ("feather", "12", lambda window: window.document.project.shape("shape-1").feather == 12.0),
        ("opacity", "50", lambda window: window.document.project.shape("shape-1").opacity == 0.5),
        ("in", "1002", lambda window: window.view_state.play_range[0] == 1002),
        ("out", "1005", lambda window: window.view_state.play_range[1] == 1006),
        ("frame", "1001", lambda window: window.view_state.frame == 1001),
    ],
)
def test_it_is_typed_to_its_end_while_frames_are_tracked(window: MainWindow, name: str, text: str, found) -> None:  # type: ignore[no-untyped-def]
    field = field_of(window, name)
    begin(field, text[:-1])
    track_a_frame(window)
    QTest.keyClicks(field, text[-1])
    track_a_frame(window)
    QTest.keyClick(field, Qt.Key.Key_Return)
    assert found(window)


@pytest.mark.parametrize("name", FIELDS)
def test_esc_shows_what_holds_now(window: MainWindow, name: str) -> None:
    field, before = field_of(window, name), window.document.project
    begin(field, "10")
    window.view_state.set_frame(FIRST + 3)
    window.document.apply("Rename", edit.set_properties(before, "shape-1", name="Arm", feather=3.0, opacity=0.25))
    held = window.document.project
    QTest.keyClick(field, Qt.Key.Key_Escape)
    window.canvas.setFocus()
    shown = field.text()
    assert {"name": "Arm", "feather": "3.0 px", "opacity": "25 %", "frame": str(FIRST + 3)}.get(name, shown) == shown
    assert window.view_state.frame == FIRST + 3
    assert window.view_state.play_range == (FIRST, FIRST + 8)
    assert window.document.project is held


@pytest.mark.parametrize("name", ["name", "feather"])
def test_another_selection_gets_nothing_of_it(window: MainWindow, name: str) -> None:
    field, before = field_of(window, name), window.document.project
    begin(field, "7")
    window.view_state.select(frozenset({"shape-2"}))
    QTest.keyClick(field, Qt.Key.Key_Return)
    assert window.document.project is before


def test_another_project_gets_nothing_of_it(window: MainWindow) -> None:
    tree, note = window.shapes.tree, window.review.note
    window.actions_by_id["review.panel"].trigger()
    other = two_shapes(Project(window.document.project.clip))
    for kind in ("row", "note", "name"):
        window.view_state.set_frame(FIRST + 2)
        window.view_state.select(frozenset({"shape-1"}))
        if kind == "row":
            tree.editItem(tree.item("shape-1"), 0)
            field: QWidget = tree.viewport().findChild(QLineEdit)
        else:
            field = note if kind == "note" else window.properties.name
            field.setFocus()
        QTest.keyClicks(field, "mine")
        window.document.open(other, None)
        window.view_state.select(frozenset({"shape-1"}))
        window.canvas.setFocus()
        assert window.document.project is other
        other = edit.set_properties(other, "shape-2", name=f"after {kind}")


def test_a_mark_of_another_project_gets_nothing_of_it(window: MainWindow) -> None:
    window.actions_by_id["mark.name"].trigger()
    other = window.document.project
    QTest.keyClicks(window.timeline.marks.field, "mine")
    window.document.open(other, None)
    window.canvas.setFocus()
    assert window.document.project is other


def begin_a_name(qtbot: QtBot, window: MainWindow) -> QLineEdit:
    """The name of the first shape, typed over in its row."""
    tree = window.shapes.tree
    tree.setFocus()
    tree.editItem(tree.item("shape-1"), 0)
    field = tree.viewport().findChild(QLineEdit)
    assert field is not None
    qtbot.waitUntil(field.hasFocus, timeout=WAIT)
    begin(field, "Arm")
    return field


@pytest.mark.parametrize(("key", "name"), [(Qt.Key.Key_Return, "Arm"), (Qt.Key.Key_Escape, "Shape 1")])
def test_a_name_in_the_list_is_done_with_once_and_the_viewer_has_the_keyboard(
    qtbot: QtBot, window: MainWindow, key: Qt.Key, name: str
) -> None:
    """A warning of Qt's, of a field that was closed before it was asked to, fails the test."""
    field = begin_a_name(qtbot, window)
    QTest.keyClick(field, key)
    qtbot.waitUntil(window.canvas.hasFocus, timeout=WAIT)
    assert window.shapes.tree.state() is QAbstractItemView.State.NoState
    assert window.document.project.shape("shape-1").name == name
    assert window.document.undo_stack.count() == (name == "Arm")


@pytest.mark.parametrize("kind", ["name", "feather", "row", "note", "mark"])
def test_what_is_saved_by_its_keys_holds_what_is_being_typed(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, kind: str
) -> None:
    path = tmp_path / "a.roam"
    with qtbot.waitSignal(window.files.saved, timeout=WAIT):
        window.files.save(path)
    qtbot.waitUntil(lambda: not window.files.is_saving, timeout=WAIT)
    if kind == "row":
        field: QWidget = begin_a_name(qtbot, window)
    elif kind == "note":
        window.actions_by_id["review.panel"].trigger()
        field = window.review.note
        field.setFocus()
        QTest.keyClicks(field, "look here")
    elif kind == "mark":
        window.actions_by_id["mark.name"].trigger()
        field = window.timeline.marks.field
        QTest.keyClicks(field, "look here")
    else:
        field = field_of(window, kind)
        begin(field, "12")
    assert all(mark.text == "" for mark in window.document.project.marks)  # nothing of it is taken yet
    assert window.document.project.shapes == file.load(path).shapes
    with qtbot.waitSignal(window.files.saved, timeout=WAIT):
        QTest.keyClick(field, Qt.Key.Key_S, Qt.KeyboardModifier.ControlModifier)
    saved, shape = file.load(path), file.load(path).shape("shape-1")
    wanted = {
        "name": ("12", 0.0, ()),
        "feather": ("Shape 1", 12.0, ()),
        "row": ("Arm", 0.0, ()),
    }
    words = ("Shape 1", 0.0, (Mark(FIRST, "look here"),))
    assert (shape.name, shape.feather, saved.marks) == wanted.get(kind, words)
    assert not window.document.is_modified
