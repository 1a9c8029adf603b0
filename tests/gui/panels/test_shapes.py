"""The shapes panel: stacking, names, eye and lock, selection both ways, deleting, restacking."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QEvent, QMimeData, QPoint, QPointF, Qt
from PySide6.QtGui import QDropEvent, QMouseEvent
from PySide6.QtWidgets import QAbstractItemView, QApplication, QLineEdit, QTreeWidgetItem
from pytestqt.qtbot import QtBot

from app import style
from app.features.verbs.layers import LayerVerbs
from app.model.document import Document
from app.model.view_state import ViewState
from app.panels.shapes import EYE, LOCK, NAME, SOLO, ShapesPanel, ShapeTree
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Keyframe, Layer, Origin, Project, edit
from roam_core.roto.layers import grouped, moved
from tests.gui.waiting import WAIT

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])


@pytest.fixture
def panel(qtbot: QtBot, document: Document, view_state: ViewState) -> ShapesPanel:
    """Shape 1 below Shape 2 below a layer with Shape 3."""
    panel = ShapesPanel(document, view_state)
    qtbot.addWidget(panel)
    panel.resize(260, 300)
    with qtbot.waitExposed(panel, timeout=WAIT):
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


def test_the_list_asks_for_the_height_of_its_rows_within_bounds(panel: ShapesPanel, document: Document) -> None:
    heights = [panel.tree.sizeHint().height()]
    for _ in range(8):
        document.apply("Draw", edit.new_shape(document.project, SQUARE, 1)[0])
        heights.append(panel.tree.sizeHint().height())
    assert heights == [max(4, min(rows, 9)) * style.ROW_HEIGHT for rows in range(4, 13)]


def test_the_top_most_stands_on_top(panel: ShapesPanel) -> None:
    assert names(panel) == ["hero", "Shape 2", "Shape 1"]
    assert panel.tree.item("layer-1").child(0).text(NAME) == "Shape 3"


def test_a_name_is_typed_and_taken_over_once(qtbot: QtBot, panel: ShapesPanel, document: Document) -> None:
    """A warning of Qt's, as of a field that was taken away while it was read, fails a test."""
    tree = panel.tree
    tree.editItem(tree.item("shape-1"), NAME)
    field = tree.viewport().findChild(QLineEdit)
    qtbot.keyClicks(field, "body")
    document.apply("Draw", edit.new_shape(document.project, SQUARE, 1)[0])  # the field stays while others come
    assert field.isVisible()
    qtbot.keyClick(field, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: names(panel) == ["Shape 4", "hero", "Shape 2", "body"], timeout=WAIT)
    assert document.project.shape("shape-1").name == "body"
    tree.editItem(tree.item("shape-1"), NAME)
    qtbot.keyClick(tree.viewport().findChild(QLineEdit), Qt.Key.Key_Escape)
    assert names(panel) == ["Shape 4", "hero", "Shape 2", "body"]


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


def test_an_eye_switches_all_that_is_selected_with_it(
    qtbot: QtBot, panel: ShapesPanel, document: Document, view_state: ViewState
) -> None:
    view_state.select(frozenset({"shape-1", "shape-2"}))
    click(qtbot, panel, panel.tree.item("shape-2"), EYE)
    assert [each.visible for each in document.project.shapes] == [False, False, True]
    assert view_state.selection.shapes == {"shape-1", "shape-2"}
    click(qtbot, panel, panel.tree.item("shape-3"), EYE)  # not one of them: it alone
    assert [each.visible for each in document.project.shapes] == [False, False, False]
    assert document.undo_stack.count() == 2


def test_another_project_begins_with_no_layer_selected(
    qtbot: QtBot, panel: ShapesPanel, document: Document, view_state: ViewState
) -> None:
    click(qtbot, panel, panel.tree.item("layer-1"), NAME)
    document.open(edit.add_layer(Project())[0], None)
    assert view_state.layers == frozenset()


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


def drop(panel: ShapesPanel, target: str | None, where: QAbstractItemView.DropIndicatorPosition) -> None:
    """Let the selected rows go over a row, or over the empty background below all rows."""
    tree = panel.tree
    middle = tree.visualItemRect(tree.item(target)).center() if target else QPoint(40, tree.viewport().height() - 4)
    tree.dropIndicatorPosition = lambda: where
    action, button, none = Qt.DropAction.MoveAction, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    tree.dropEvent(QDropEvent(QPointF(middle), action, QMimeData(), button, none))


ON, ABOVE, BELOW = (
    QAbstractItemView.DropIndicatorPosition.OnItem,
    QAbstractItemView.DropIndicatorPosition.AboveItem,
    QAbstractItemView.DropIndicatorPosition.BelowItem,
)
BEFORE = "hero(Shape 3) Shape 2 Shape 1"


@pytest.mark.parametrize(
    ("chosen", "target", "where", "after"),
    [
        ({"shape-2"}, None, ON, "hero(Shape 3) Shape 1 Shape 2"),
        ({"shape-2"}, "shape-1", BELOW, "hero(Shape 3) Shape 1 Shape 2"),
        ({"shape-1"}, "layer-1", ABOVE, "Shape 1 hero(Shape 3) Shape 2"),
        ({"shape-1", "shape-2"}, "layer-1", ON, "hero(Shape 2 Shape 1 Shape 3)"),
        ({"shape-1", "shape-2"}, "shape-3", BELOW, "hero(Shape 3 Shape 2 Shape 1)"),
        ({"shape-1"}, "layer-1", BELOW, "hero(Shape 1 Shape 3) Shape 2"),
        ({"shape-3"}, "shape-1", ABOVE, "hero() Shape 2 Shape 3 Shape 1"),
        ({"shape-2"}, "shape-2", ABOVE, BEFORE),
    ],
)
def test_rows_are_restacked_by_where_they_are_dropped(
    panel: ShapesPanel,
    document: Document,
    view_state: ViewState,
    chosen: set[str],
    target: str | None,
    where: QAbstractItemView.DropIndicatorPosition,
    after: str,
) -> None:
    view_state.select(frozenset(chosen))
    drop(panel, target, where)
    assert told(document.project.root) == after
    assert document.undo_stack.count() == (after != BEFORE)


def told(layer: Layer) -> str:
    """Names, the top-most first, layers with their content."""
    children = reversed(layer.children)
    return " ".join(f"{c.name}({told(c)})" if isinstance(c, Layer) else c.name for c in children)


def test_a_layer_cannot_be_dropped_into_itself(panel: ShapesPanel, document: Document, view_state: ViewState) -> None:
    document.open(grouped(document.project, {"layer-1"}, "outer")[0], None)
    view_state.select(frozenset(), layers=frozenset({"layer-2"}))
    drop(panel, "layer-1", ON)
    assert document.undo_stack.count() == 0
    assert "cannot be moved into itself" in view_state.message


def test_a_layer_is_selected_as_such(qtbot: QtBot, panel: ShapesPanel, view_state: ViewState) -> None:
    click(qtbot, panel, panel.tree.item("layer-1"), NAME)
    assert view_state.layers == {"layer-1"}
    view_state.select(frozenset({"shape-3"}))  # the same shapes, as when the viewer drops what is gone: the layer stays
    assert view_state.layers == {"layer-1"}
    view_state.select(frozenset(), frozenset({("shape-3", 0)}))
    assert view_state.layers == frozenset()
    assert panel.tree.selected_ids() == ["shape-3"]


def test_a_folded_layer_stays_folded(qtbot: QtBot, panel: ShapesPanel, document: Document) -> None:
    panel.tree.item("layer-1").setExpanded(False)
    document.apply("Rename", edit.set_properties(document.project, "shape-1", name="body"))
    assert not panel.tree.item("layer-1").isExpanded()
    assert panel.tree.itemAt(QPoint(60, 5)) is panel.tree.item("layer-1")


def test_a_name_of_what_a_run_took_away_while_it_was_typed_goes_nowhere(
    qtbot: QtBot, panel: ShapesPanel, document: Document
) -> None:
    """A part that Always drops is gone as its frame comes; what was typed ended in an error."""
    tree = panel.tree
    tree.editItem(tree.item("shape-2"), NAME)
    editor = tree.findChild(QLineEdit)
    assert isinstance(editor, QLineEdit)
    editor.setText("arm")
    document.apply("Drop part", edit.remove_items(document.project, ["shape-2"]))
    after = document.project
    qtbot.keyClick(editor, Qt.Key.Key_Return)
    assert document.project is after
    qtbot.waitUntil(lambda: names(panel) == ["hero", "Shape 1"], timeout=WAIT)


def crowd(panel: ShapesPanel, document: Document) -> list[str]:
    """Forty shapes more, of which the list shows some; their ids, bottom first."""
    project, ids = document.project, []
    for _ in range(40):
        project, shape = edit.new_shape(project, SQUARE, 1)
        ids.append(shape.id)
    document.apply("Draw", project)
    return ids


def is_in_sight(panel: ShapesPanel, item_id: str) -> bool:
    tree = panel.tree
    return tree.viewport().rect().contains(tree.visualItemRect(tree.item(item_id)).center())


def test_what_is_selected_elsewhere_comes_into_sight_and_is_what_f2_means(
    qtbot: QtBot, panel: ShapesPanel, document: Document, view_state: ViewState
) -> None:
    """The list stayed where it was, and F2 named the shape that had been clicked in it before."""
    ids = crowd(panel, document)
    click(qtbot, panel, panel.tree.item(ids[-1]), NAME)
    view_state.select(frozenset({ids[3]}))
    assert is_in_sight(panel, ids[3])
    panel.tree.setFocus()
    qtbot.keyClick(panel.tree, Qt.Key.Key_F2)
    field = panel.tree.viewport().findChild(QLineEdit)
    assert field.text() == document.project.shape(ids[3]).name
    assert view_state.selection.shapes == {ids[3]}


def test_a_layer_that_was_just_made_of_rows_comes_into_sight_and_is_what_f2_means(
    qtbot: QtBot, panel: ShapesPanel, document: Document, view_state: ViewState
) -> None:
    """F2 named the shape that had been clicked last, and the list did not show the layer."""
    ids = crowd(panel, document)
    view_state.select(frozenset(ids[:30]))
    click(qtbot, panel, panel.tree.item(ids[3]), NAME)
    view_state.select(frozenset(ids[:30]))
    LayerVerbs(document, view_state).group()
    (layer,) = view_state.layers
    assert is_in_sight(panel, layer)
    panel.tree.setFocus()
    qtbot.keyClick(panel.tree, Qt.Key.Key_F2)
    field = panel.tree.viewport().findChild(QLineEdit)
    assert field.text() == document.project.find(layer).name
    assert view_state.selection.shapes == set(ids[:30])


def test_keys_go_on_from_the_row_whose_lock_was_switched(
    qtbot: QtBot, panel: ShapesPanel, document: Document, view_state: ViewState
) -> None:
    """The rows were built anew, and Down began at the top; nor does the list go back to where that row is."""
    ids = crowd(panel, document)
    click(qtbot, panel, panel.tree.item(ids[-2]), NAME)
    document.apply("Lock", edit.set_properties(document.project, ids[-2], locked=True))
    bar = panel.tree.verticalScrollBar()
    bar.setValue(bar.maximum())
    document.apply("Lock", edit.set_properties(document.project, ids[2], locked=True))
    assert not is_in_sight(panel, ids[-2])
    panel.tree.setFocus()
    qtbot.keyClick(panel.tree, Qt.Key.Key_Down)
    assert view_state.selection.shapes == {ids[-3]}


def test_a_shape_in_a_folded_layer_brings_the_layers_row_into_sight(
    panel: ShapesPanel, document: Document, view_state: ViewState
) -> None:
    document.apply("Down", moved(document.project, ["layer-1"], document.project.root.id, 0))
    crowd(panel, document)
    panel.tree.item("layer-1").setExpanded(False)
    assert not is_in_sight(panel, "layer-1")
    view_state.select(frozenset({"shape-3"}))
    assert is_in_sight(panel, "layer-1")
    assert not panel.tree.item("layer-1").isExpanded()


@pytest.mark.parametrize("column", [SOLO, EYE, LOCK], ids=["solo", "eye", "lock"])
def test_a_press_on_a_switch_that_slips_drags_and_selects_nothing(
    qtbot: QtBot, panel: ShapesPanel, view_state: ViewState, monkeypatch: pytest.MonkeyPatch, column: int
) -> None:
    dragged: list[list[str]] = []

    def drag(tree: ShapeTree, _actions: object) -> None:
        dragged.append([row.text(NAME) for row in tree.selectedItems()])

    monkeypatch.setattr(ShapeTree, "startDrag", drag)
    tree, left = panel.tree, Qt.MouseButton.LeftButton
    click(qtbot, panel, tree.item("shape-2"), NAME)

    def slip(column: int) -> None:
        start = tree.visualRect(tree.indexFromItem(tree.item("shape-1"), column)).center()
        qtbot.mousePress(tree.viewport(), left, pos=start)
        for far in (QPoint(1, -1), QPoint(2, -8), QPoint(2, -28)):  # up to the row that is selected
            where = QPointF(start + far)
            none, over = Qt.KeyboardModifier.NoModifier, QPointF(tree.viewport().mapToGlobal(start + far))
            move = QMouseEvent(QEvent.Type.MouseMove, where, over, Qt.MouseButton.NoButton, left, none)
            QApplication.sendEvent(tree.viewport(), move)
        qtbot.mouseRelease(tree.viewport(), left, pos=start + QPoint(2, -28))

    slip(column)
    assert (dragged, view_state.selection.shapes) == ([], {"shape-2"})
    slip(NAME)  # as before: a press on the name drags its row
    assert (dragged[:1], view_state.selection.shapes) == ([["Shape 1"]], {"shape-1"})


@pytest.mark.parametrize("shape_id", ["shape-1", "shape-3"], ids=["locked", "in a locked layer"])
def test_what_is_locked_keeps_its_name_in_the_list(
    qtbot: QtBot, panel: ShapesPanel, document: Document, shape_id: str
) -> None:
    def is_renamed_by_f2() -> bool:
        click(qtbot, panel, panel.tree.item(shape_id), NAME)
        qtbot.keyClick(panel.tree, Qt.Key.Key_F2)
        is_open = panel.tree.state() is QAbstractItemView.State.EditingState
        if is_open:
            qtbot.keyClick(panel.tree.viewport().findChild(QLineEdit), Qt.Key.Key_Escape)
        return is_open

    for item_id in ("shape-1", "layer-1"):
        document.apply("Lock", edit.set_properties(document.project, item_id, locked=True))
    assert not is_renamed_by_f2()
    for item_id in ("shape-1", "layer-1"):
        document.apply("Unlock", edit.set_properties(document.project, item_id, locked=False))
    assert is_renamed_by_f2()
