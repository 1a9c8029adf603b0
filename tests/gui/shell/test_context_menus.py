"""Right clicks in the viewer and in the list: what lies there is selected, and what can be done there is offered."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtWidgets import QApplication, QMenu, QWidget
from pytestqt.qtbot import QtBot

from app.actions.context import CONTEXT, Place
from app.actions.menus import SEPARATOR
from app.actions.specs import SPECS
from app.model.view_state import Selection
from app.shell.main_window import MainWindow
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import edit
from tests.gui.windows import FIRST, click, opened_window, widget_point, write_clip

pytestmark = pytest.mark.qt_log_ignore("This plugin does not support (raise|grabbing|propagate)", extend=True)

SQUARE = polygon_points([(40, 30), (80, 30), (80, 70), (40, 70)])
TRIANGLE = polygon_points([(100, 30), (140, 30), (140, 70)])


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    """With a square below and a triangle; nothing is selected."""
    with opened_window(qtbot, write_clip(tmp_path / "plate"), tmp_path / "journal") as window:
        project, _ = edit.new_shape(window.document.project, SQUARE, FIRST)
        project, _ = edit.new_shape(project, TRIANGLE, FIRST)
        window.document.apply("Draw", project)
        yield window


def right_click(widget: QWidget, at: QPoint) -> list[str]:
    """The window system's question for a menu; gives the ids of the actions that it offers, and puts it away."""
    event = QContextMenuEvent(QContextMenuEvent.Reason.Mouse, at, widget.mapToGlobal(at))
    QApplication.sendEvent(widget, event)
    menu = QApplication.activePopupWidget()
    if menu is None:
        return []
    assert isinstance(menu, QMenu)
    offered = [action.objectName() for action in menu.actions() if not action.isSeparator()]
    menu.close()
    return offered


def in_viewer(window: MainWindow, position: tuple[float, float]) -> list[str]:
    return right_click(window.canvas, widget_point(window, position))


def on_row(window: MainWindow, item_id: str) -> list[str]:
    """A right click on a row, with the press that comes before it."""
    tree = window.shapes.tree
    at = tree.visualItemRect(tree.item(item_id)).center()
    tree.setCurrentItem(tree.item(item_id))
    return right_click(tree.viewport(), at)


def test_on_an_outline_its_shape_is_selected_and_offered(window: MainWindow) -> None:
    offered = in_viewer(window, (60.0, 30.0))
    assert window.view_state.selection == Selection(frozenset({"shape-1"}))
    assert {"key.set", "track.forward", "shape.duplicate", "shape.hide", "file.export_selected"} <= set(offered)
    undone = {"key.delete", "track.fill", "track.delete_engine_keys", "shape.to_bezier", "object.one", "shape.show_all"}
    assert not undone & set(offered)


def test_inside_of_a_selected_shape_it_is_meant(window: MainWindow) -> None:
    assert "shape.duplicate" not in in_viewer(window, (60.0, 50.0))
    window.view_state.select(frozenset({"shape-1", "shape-2"}))
    offered = in_viewer(window, (60.0, 50.0))
    assert window.view_state.selection.shapes == {"shape-1", "shape-2"}
    assert {"shape.duplicate", "object.one"} <= set(offered)


def test_on_a_point_of_a_selected_shape_the_point_is_selected(window: MainWindow) -> None:
    window.view_state.select(frozenset({"shape-1"}))
    offered = in_viewer(window, (80.0, 30.0))
    assert window.view_state.selection.points == {("shape-1", 1)}
    assert offered[:4] == ["points.smooth", "points.cusp", "points.first", "points.delete"]
    assert "feather.reset" not in offered


def test_several_selected_points_stay_so(window: MainWindow) -> None:
    points = frozenset({("shape-1", 0), ("shape-1", 1)})
    window.view_state.select(frozenset(), points)
    in_viewer(window, (80.0, 30.0))
    assert window.view_state.selection.points == points


def test_on_empty_background_the_selection_stays(window: MainWindow) -> None:
    window.view_state.select(frozenset({"shape-1"}))
    offered = in_viewer(window, (150.0, 110.0))
    assert window.view_state.selection.shapes == {"shape-1"}
    assert {"edit.paste", "shape.select_all", "tool.bezier", "view.fit"} <= set(offered)


def test_what_is_chosen_is_done_and_the_keys_are_told(window: MainWindow) -> None:
    in_viewer(window, (60.0, 30.0))
    menu = window.context_menus.menu(Place.SHAPE)
    duplicate = next(action for action in menu.actions() if action.text() == "Duplicate")
    assert duplicate.isShortcutVisibleInContextMenu()
    assert duplicate.shortcut().toString() == "Ctrl+D"
    duplicate.trigger()
    assert len(window.document.project.shapes) == 3
    menu.deleteLater()


def test_while_a_shape_is_drawn_there_is_no_menu(qtbot: QtBot, window: MainWindow) -> None:
    window.view_state.set_tool("polygon")
    assert in_viewer(window, (150.0, 110.0))
    click(qtbot, window, (20.0, 20.0))
    click(qtbot, window, (30.0, 20.0))
    assert in_viewer(window, (150.0, 110.0)) == []
    window.view_state.set_tool("select")


def test_hidden_shapes_are_not_meant(window: MainWindow) -> None:
    window.canvas.viewing.hide_shapes(True)
    assert "view.hide_overlays" in in_viewer(window, (60.0, 30.0))
    assert window.view_state.selection == Selection()


def test_rows_of_the_list_offer_what_becomes_them(window: MainWindow) -> None:
    project, layer = edit.add_layer(window.document.project)
    window.document.apply("Layer", project)
    offered = on_row(window, "shape-2")
    assert window.view_state.selection.shapes == {"shape-2"}
    assert {"shape.delete", "shape.lock", "file.export_selected"} <= set(offered)
    assert "points.select_all" not in offered
    assert "layer.ungroup" in on_row(window, layer.id)
    tree = window.shapes.tree
    assert right_click(tree.viewport(), QPoint(20, tree.viewport().height() - 2))[:2] == ["edit.paste", "layer.add"]


def test_selected_shapes_alone_are_exported(qtbot: QtBot, window: MainWindow) -> None:
    window.view_state.select(frozenset({"shape-2"}))
    window.actions_by_id["file.export_selected"].trigger()
    dialog = window.file_actions._export_dialog
    assert dialog is not None
    assert dialog.shapes == {"shape-2"}
    dialog.close()
    window.actions_by_id["file.export"].trigger()  # all of the project again
    assert dialog.isVisible()
    assert dialog.shapes is None
    dialog.close()


def test_every_entry_is_an_action() -> None:
    named = {entry for entries in CONTEXT.values() for entry in entries if entry != SEPARATOR}
    assert named <= {spec.id for spec in SPECS}


def test_a_right_press_drags_nothing(qtbot: QtBot, window: MainWindow) -> None:
    window.view_state.select(frozenset({"shape-1"}))
    before, at, button = window.document.project, widget_point(window, (60.0, 30.0)), Qt.MouseButton.RightButton
    qtbot.mousePress(window.canvas, button, pos=at)
    qtbot.mouseMove(window.canvas, at + QPoint(40, 40))
    qtbot.mouseRelease(window.canvas, button, pos=at + QPoint(40, 40))
    assert window.document.project is before
