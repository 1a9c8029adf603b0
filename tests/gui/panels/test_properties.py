"""The shape panel: every control shows the document and edits it, one undo step a change."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.document import Document
from app.panels.properties import PropertiesPanel
from app.view_state import ViewState
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import BlendMode, Project, RotoShape, edit
from roam_core.roto.project import PALETTE

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])


@pytest.fixture
def panel(qtbot: QtBot, document: Document, view_state: ViewState) -> PropertiesPanel:
    panel = PropertiesPanel(document, view_state)
    qtbot.addWidget(panel)
    with qtbot.waitExposed(panel):
        panel.show()
    project = Project()
    for _ in range(2):
        project, _shape = edit.new_shape(project, SQUARE, 1)
    document.open(project, None)
    view_state.select(frozenset({"shape-1"}))
    return panel


def shape(document: Document, number: int = 1) -> RotoShape:
    return document.project.shape(f"shape-{number}")


def type_in(qtbot: QtBot, field: object, text: str) -> None:
    field.selectAll()
    qtbot.keyClicks(field, text)
    qtbot.keyClick(field, Qt.Key.Key_Return)


Act = Callable[[QtBot, PropertiesPanel], object]
ACTS: dict[str, tuple[Act, object]] = {
    "name": (lambda qtbot, panel: type_in(qtbot, panel.name, "body"), "body"),
    "opacity": (lambda qtbot, panel: type_in(qtbot, panel.opacity, "40"), 0.4),
    "feather": (lambda qtbot, panel: type_in(qtbot, panel.feather, "3.5"), 3.5),
    "blend": (lambda qtbot, panel: panel.blend.setCurrentText("Subtract"), BlendMode.SUBTRACT),
    "invert": (lambda qtbot, panel: panel.invert.click(), True),
    "closed": (lambda qtbot, panel: panel.closed.click(), False),
    "colour": (lambda qtbot, panel: panel.colours.group.button(4).click(), PALETTE[4]),
}


@pytest.mark.parametrize("name", ACTS)
def test_a_control_edits_its_field_in_one_step_and_follows_undo(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, name: str
) -> None:
    act, value = ACTS[name]
    before = document.project
    act(qtbot, panel)
    assert getattr(shape(document), name) == value
    assert document.undo_stack.count() == 1
    document.undo_stack.undo()
    assert document.project is before
    shown = {
        "name": panel.name.text() == shape(document).name,
        "opacity": panel.opacity.value() == 100,
        "feather": panel.feather.value() == 0,
        "blend": panel.blend.currentText() == "Add",
        "invert": not panel.invert.isChecked(),
        "closed": panel.closed.isChecked(),
        "colour": panel.colours.group.checkedId() == 0,
    }
    assert shown[name]
    assert document.undo_stack.count() == 1  # showing a value is no edit


def test_all_selected_shapes_are_edited_together(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, view_state: ViewState
) -> None:
    view_state.select(frozenset({"shape-1", "shape-2"}))
    type_in(qtbot, panel.feather, "2")
    assert [each.feather for each in document.project.shapes] == [2, 2]
    assert document.undo_stack.count() == 1


def test_a_name_belongs_to_one_shape(panel: PropertiesPanel, view_state: ViewState) -> None:
    view_state.select(frozenset({"shape-1", "shape-2"}))
    assert not panel.name.isEnabled()
    assert (panel.name.text(), panel.name.placeholderText()) == ("", "2 shapes")
    view_state.select(frozenset({"shape-2"}))
    assert panel.name.isEnabled()
    assert panel.name.text() == "Shape 2"


def test_a_locked_shape_cannot_be_edited(panel: PropertiesPanel, document: Document) -> None:
    document.apply("Lock", edit.set_properties(document.project, "shape-1", locked=True))
    assert not panel.opacity.isEnabled()
    assert not panel.closed.isEnabled()


def test_two_points_cannot_be_closed(panel: PropertiesPanel, document: Document, view_state: ViewState) -> None:
    project, line = edit.new_shape(document.project, SQUARE[:2], 1, closed=False)
    document.apply("Draw", project)
    view_state.select(frozenset({line.id}))
    assert not panel.closed.isEnabled()


def test_an_empty_name_is_put_back(qtbot: QtBot, panel: PropertiesPanel, document: Document) -> None:
    type_in(qtbot, panel.name, " ")
    assert panel.name.text() == shape(document).name == "Shape 1"


def test_without_a_selection_it_says_what_to_do(panel: PropertiesPanel, view_state: ViewState) -> None:
    view_state.select(frozenset())
    assert panel._pages.currentWidget() is panel._hint
