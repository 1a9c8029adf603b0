"""The search in the list of shapes: what it finds, what it leaves selected, and that it leaves out is left alone."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt
from PySide6.QtGui import QDropEvent
from PySide6.QtWidgets import QTreeWidgetItem
from pytestqt.qtbot import QtBot

from app.model.document import Document
from app.model.view_state import ViewState
from app.panels.shape_search import found_in
from app.panels.shapes import EYE, NAME, ShapesPanel
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Project, edit
from tests.gui.waiting import WAIT

NO_KEY = Qt.KeyboardModifier.NoModifier
SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])


def people() -> Project:
    """From below: a sky, and two people in layers, each with an arm and a leg."""
    project, _ = edit.new_shape(Project(), SQUARE, 1, name="Sky")
    for person in ("Left Müller", "Right"):
        project, layer = edit.add_layer(project, person)
        for part in ("Arm", "Leg"):
            project, _ = edit.new_shape(project, SQUARE, 1, name=part, layer_id=layer.id)
    return project


def names_found(text: str) -> list[str]:
    project = people()
    return sorted(item.name for item in project.root.items() if item.id in found_in(project.root, text).items)


@pytest.fixture
def panel(qtbot: QtBot, document: Document, view_state: ViewState) -> ShapesPanel:
    panel = ShapesPanel(document, view_state)
    qtbot.addWidget(panel)
    panel.resize(260, 400)
    with qtbot.waitExposed(panel, timeout=WAIT):
        panel.show()
    document.open(people(), None)
    return panel


def rows(panel: ShapesPanel) -> list[str]:
    """The names in the list, from above, those in layers indented."""
    found = []

    def look(row: QTreeWidgetItem, depth: int) -> None:
        found.append("  " * depth + row.text(NAME))
        for index in range(row.childCount() if row.isExpanded() else 0):
            look(row.child(index), depth + 1)

    for index in range(panel.tree.topLevelItemCount()):
        look(panel.tree.topLevelItem(index), 0)
    return found


def click(
    qtbot: QtBot, panel: ShapesPanel, item_id: str, column: int = NAME, keys: Qt.KeyboardModifier = NO_KEY
) -> None:
    tree = panel.tree
    place = tree.visualRect(tree.indexFromItem(tree.item(item_id), column)).center()
    qtbot.mouseClick(tree.viewport(), Qt.MouseButton.LeftButton, keys, place)


def test_each_word_is_part_of_the_name_or_of_a_layer_around() -> None:
    assert names_found("") == ["Arm", "Arm", "Left Müller", "Leg", "Leg", "Right", "Sky"]
    assert names_found("aRm") == ["Arm", "Arm"]
    assert names_found("right leg") == names_found("leg  right") == ["Leg"]
    assert names_found("right") == ["Arm", "Leg", "Right"]
    assert names_found("mu\u0308ll") == names_found("MÜLL") == ["Arm", "Left Müller", "Leg"]
    assert names_found("wing") == []


def test_layers_that_only_hold_what_is_found_stand_around_it(panel: ShapesPanel) -> None:
    panel.search.setText("leg")
    assert rows(panel) == ["Right", "  Leg", "Left Müller", "  Leg"]
    panel.search.setText("")
    assert len(rows(panel)) == 7


def test_folded_layers_open_for_a_search_and_fold_again(panel: ShapesPanel) -> None:
    panel.tree.item("layer-1").setExpanded(False)
    panel.search.setText("l")
    panel.search.setText("le")
    assert "  Leg" in rows(panel)
    panel.search.clear()
    assert rows(panel) == ["Right", "  Leg", "  Arm", "Left Müller", "Sky"]


def test_what_is_selected_stays_so_and_what_is_not_listed_is_told(
    panel: ShapesPanel, document: Document, view_state: ViewState
) -> None:
    sky = document.project.shapes[0].id
    arm = document.project.shapes[1].id
    view_state.select(frozenset({sky, arm}))
    panel.search.setText("arm")
    assert view_state.selection.shapes == {sky, arm}
    assert [label.text() for label in (panel.beside,) if label.isVisible()] == ["1 selected row is not in this list."]
    panel.search.setText("wing")
    assert panel.beside.text() == "No shape or layer is called that."
    panel.search.clear()
    assert view_state.selection.shapes == {sky, arm}
    assert not panel.beside.isVisible()
    assert panel.tree.selected_ids() == [sky, arm]


def test_all_means_the_rows_that_are_listed(qtbot: QtBot, panel: ShapesPanel, document: Document) -> None:
    panel.search.setText("leg")
    panel.tree.setFocus()
    qtbot.keyClick(panel.tree, Qt.Key.Key_A, Qt.KeyboardModifier.ControlModifier)
    qtbot.keyClick(panel.tree, Qt.Key.Key_Delete)
    left = [item.name for item in document.project.root.items()]
    assert sorted(left) == ["Arm", "Arm", "Left Müller", "Right", "Sky"]


def test_a_layer_that_only_holds_what_is_found_is_not_selected(
    qtbot: QtBot, panel: ShapesPanel, view_state: ViewState
) -> None:
    panel.search.setText("leg")
    click(qtbot, panel, "layer-1")
    assert not view_state.layers
    assert not view_state.selection.shapes
    panel.search.setText("right")
    click(qtbot, panel, "layer-2")
    assert view_state.layers == {"layer-2"}
    assert len(view_state.selection.shapes) == 2


def test_what_is_not_listed_is_no_part_of_what_is_done_in_the_list(
    qtbot: QtBot, panel: ShapesPanel, document: Document, view_state: ViewState
) -> None:
    sky, arm, leg = (shape.id for shape in document.project.shapes[:3])
    view_state.select(frozenset({sky, arm}))
    panel.search.setText("left")
    click(qtbot, panel, arm, EYE)
    assert [s.name for s in document.project.shapes if not s.visible] == ["Arm"]
    assert view_state.selection.shapes == {sky, arm}, "an eye selects nothing"
    click(qtbot, panel, leg, NAME, Qt.KeyboardModifier.ControlModifier)
    assert view_state.selection.shapes == {arm, leg}
    view_state.select(frozenset({sky, arm}))
    at = panel.tree.visualItemRect(panel.tree.item(arm)).center()
    qtbot.mousePress(panel.tree.viewport(), Qt.MouseButton.RightButton, pos=at)
    assert view_state.selection.shapes == {arm}, "the menu of a row means rows"


def test_return_goes_into_the_list_and_lets_go_of_what_it_does_not_show(
    qtbot: QtBot, panel: ShapesPanel, document: Document, view_state: ViewState
) -> None:
    sky, arm = (shape.id for shape in document.project.shapes[:2])
    view_state.select(frozenset({sky}))
    panel.search.open()
    qtbot.keyClicks(panel.search, "arm")
    qtbot.keyClick(panel.search, Qt.Key.Key_Return)
    assert panel.tree.hasFocus()
    assert [document.project.shape(i).name for i in view_state.selection.shapes] == ["Arm"]
    view_state.select(frozenset({sky, arm}))
    panel.search.open()
    qtbot.keyClick(panel.search, Qt.Key.Key_Down)
    assert view_state.selection.shapes == {arm}


def test_return_stays_where_nothing_is_found(qtbot: QtBot, panel: ShapesPanel) -> None:
    panel.search.open()
    qtbot.keyClicks(panel.search, "wing")
    qtbot.keyClick(panel.search, Qt.Key.Key_Return)
    assert panel.search.hasFocus()


def test_esc_empties_the_field_and_gives_the_keyboard_back(
    qtbot: QtBot, panel: ShapesPanel, document: Document, view_state: ViewState
) -> None:
    sky = document.project.shapes[0].id
    panel.tree.setFocus()
    view_state.select(frozenset({sky}))
    panel.search.open()
    qtbot.keyClicks(panel.search, "arm")
    qtbot.keyClick(panel.search, Qt.Key.Key_Escape)
    assert panel.search.text() == ""
    assert panel.tree.hasFocus()
    assert view_state.selection.shapes == {sky}
    assert len(rows(panel)) == 7


def test_another_project_is_listed_whole(panel: ShapesPanel, document: Document) -> None:
    panel.search.setText("leg")
    document.open(people(), None)
    assert panel.search.text() == ""
    assert len(rows(panel)) == 7


def test_a_new_name_is_searched_too(panel: ShapesPanel, document: Document) -> None:
    panel.search.setText("leg")
    document.apply("Rename", edit.set_properties(document.project, document.project.shapes[0].id, name="Peg leg"))
    assert "Peg leg" in rows(panel)
    assert panel.tree.itemAt(QPoint(60, 5)).text(NAME) == "Right"


def test_a_drop_between_listed_rows_goes_beside_the_row_that_is_seen(
    panel: ShapesPanel, document: Document, view_state: ViewState
) -> None:
    from PySide6.QtWidgets import QAbstractItemView

    from tests.gui.panels.test_shapes import drop

    sky, arm = (shape.id for shape in document.project.shapes[:2])
    panel.search.setText("y")
    view_state.select(frozenset({sky}))
    panel.search.setText("")
    panel.search.setText("left")
    drop(panel, arm, QAbstractItemView.DropIndicatorPosition.AboveItem)
    assert document.project.shapes[0].name == "Sky", "what is not listed is not dragged"


def test_a_drop_below_a_searched_list_is_the_bottom_of_what_is_listed(
    panel: ShapesPanel, document: Document, view_state: ViewState
) -> None:
    project, _ = edit.new_shape(document.project, SQUARE, 1, name="Leg of the table")
    document.apply("Draw", project)
    lowest = document.project.root.children[0].name
    panel.search.setText("leg")
    assert [row.strip() for row in rows(panel)] == ["Leg of the table", "Right", "Leg", "Left Müller", "Leg"]
    (table,) = [shape.id for shape in document.project.shapes if shape.name == "Leg of the table"]
    view_state.select(frozenset({table}))
    drop_below(panel)
    assert [item.name for item in document.project.root.children] == [
        lowest,
        "Leg of the table",
        "Left Müller",
        "Right",
    ]
    assert [row.strip() for row in rows(panel)][-1] == "Leg of the table"
    before = document.project.root
    drop_below(panel)
    assert document.project.root == before
    panel.search.clear()
    drop_below(panel)
    assert document.project.root.children[0].name == "Leg of the table"


def drop_below(panel: ShapesPanel) -> None:
    """Let the selected rows go over the empty background below all rows."""
    tree = panel.tree
    place, action = QPointF(40.0, tree.viewport().height() - 4.0), Qt.DropAction.MoveAction
    tree.dropEvent(QDropEvent(place, action, QMimeData(), Qt.MouseButton.LeftButton, NO_KEY))
