"""The shapes panel: stacking, names, eye and lock, selection both ways, deleting, restacking."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QTreeWidgetItem
from pytestqt.qtbot import QtBot

from app.document import Document
from app.panels.shapes import EYE, LOCK, NAME, ShapesPanel
from app.view_state import ViewState
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Keyframe, Layer, Origin, Project, edit

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])


@pytest.fixture
def panel(qtbot: QtBot, document: Document, view_state: ViewState) -> ShapesPanel:
    """Shape 1 below Shape 2 below a layer with Shape 3."""
    panel = ShapesPanel(document, view_state)
    qtbot.addWidget(panel)
    panel.resize(260, 300)
    with qtbot.waitExposed(panel):
        panel.show()
    project, _ = edit.new_shape(Project(), SQUARE, 1)
    project, _ = edit.new_shape(project, SQUARE, 1)
    project, layer = edit.add_layer(project, "hero")
    project, _ = edit.new_shape(project, SQUARE, 1, layer_id=layer.id)
    document.open(project, None)
    return panel


def names(panel: ShapesPanel) -> list[str]:
    tree = panel.tree
    return [tree.topLevelItem(row).text(NAME) for row in range(tree.topLevelItemCount())]


def click(qtbot: QtBot, panel: ShapesPanel, row: QTreeWidgetItem, column: int) -> None:
    tree = panel.tree
    place = tree.visualRect(tree.indexFromItem(row, column)).center()
    qtbot.mouseClick(tree.viewport(), Qt.MouseButton.LeftButton, pos=place)


def test_an_empty_project_says_what_to_do(qtbot: QtBot, document: Document, view_state: ViewState) -> None:
    panel = ShapesPanel(document, view_state)
    qtbot.addWidget(panel)
    assert panel.tree.isHidden()
    document.apply("Draw", edit.new_shape(document.project, SQUARE, 1)[0])
    assert not panel.tree.isHidden()


def test_the_top_most_stands_on_top(panel: ShapesPanel) -> None:
    assert names(panel) == ["hero", "Shape 2", "Shape 1"]
    assert panel.tree.item("layer-1").child(0).text(NAME) == "Shape 3"


def test_selection_goes_both_ways(qtbot: QtBot, panel: ShapesPanel, view_state: ViewState) -> None:
    click(qtbot, panel, panel.tree.item("shape-1"), NAME)
    assert view_state.selection.shapes == {"shape-1"}
    click(qtbot, panel, panel.tree.item("layer-1"), NAME)
    assert view_state.selection.shapes == {"shape-3"}
    view_state.select(frozenset({"shape-2"}))
    assert panel.tree.selected_ids() == ["shape-2"]


@pytest.mark.parametrize(("column", "switch", "before"), [(EYE, "visible", True), (LOCK, "locked", False)])
def test_eye_and_lock_are_one_step_each(
    qtbot: QtBot, panel: ShapesPanel, document: Document, column: int, switch: str, before: bool
) -> None:
    click(qtbot, panel, panel.tree.item("shape-2"), column)
    assert getattr(document.project.shape("shape-2"), switch) is not before
    document.undo_stack.undo()
    assert getattr(document.project.shape("shape-2"), switch) is before
    assert document.undo_stack.count() == 1


def test_a_name_can_be_edited_in_place(qtbot: QtBot, panel: ShapesPanel, document: Document) -> None:
    panel.tree.item("shape-1").setText(NAME, "body")
    assert document.project.shape("shape-1").name == "body"
    panel.tree.item("shape-1").setText(NAME, "  ")
    assert document.project.shape("shape-1").name == "body"
    assert names(panel)[-1] == "body"


def test_delete_removes_the_selected_rows_with_what_is_in_them(
    qtbot: QtBot, panel: ShapesPanel, document: Document
) -> None:
    click(qtbot, panel, panel.tree.item("layer-1"), NAME)
    qtbot.keyClick(panel.tree, Qt.Key.Key_Delete)
    assert [item.id for item in document.project.root.items()] == ["shape-1", "shape-2"]
    document.undo_stack.undo()
    assert document.project.has("shape-3")


def test_a_tracked_frame_rebuilds_no_row(panel: ShapesPanel, document: Document) -> None:
    row = panel.tree.item("shape-1")
    key = Keyframe(2, SQUARE, origin=Origin.ENGINE)
    document.apply("Track", document.project.with_shape(edit.set_engine_keys(document.project.shape("shape-1"), [key])))
    assert panel.tree.item("shape-1") is row


def test_rows_are_restacked_by_where_they_are_dropped(panel: ShapesPanel, document: Document) -> None:
    tree = panel.tree
    layer_id, index = tree._place(None, "shape-2")
    document.apply("Restack", edit.move_item(document.project, "shape-2", layer_id, index))
    assert names(panel) == ["hero", "Shape 1", "Shape 2"]
    layer_id, index = tree._place(tree.item("shape-3"), "shape-2")
    document.apply("Restack", edit.move_item(document.project, "shape-2", layer_id, index))
    layer = document.project.find("layer-1")
    assert isinstance(layer, Layer)
    assert [child.id for child in layer.children] == ["shape-3", "shape-2"]


def test_a_folded_layer_stays_folded(qtbot: QtBot, panel: ShapesPanel, document: Document) -> None:
    panel.tree.item("layer-1").setExpanded(False)
    document.apply("Rename", edit.set_properties(document.project, "shape-1", name="body"))
    assert not panel.tree.item("layer-1").isExpanded()
    assert panel.tree.itemAt(QPoint(60, 5)) is panel.tree.item("layer-1")
