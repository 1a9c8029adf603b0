"""The form of layers, and the verbs on layers: grouping, dissolving, adding."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.features.verbs.layers import NO_LAYER, LayerVerbs
from app.features.verbs.shapes import NOTHING_SELECTED
from app.model.document import Document
from app.model.view_state import ViewState
from app.panels.properties import PropertiesPanel
from roam_core.roto import Layer, LayerTransform, Project, edit
from roam_core.roto.layers import grouped
from tests.gui.panels.test_properties import SQUARE, type_in
from tests.gui.waiting import WAIT


@pytest.fixture
def panel(qtbot: QtBot, document: Document, view_state: ViewState) -> PropertiesPanel:
    """Two layers with a shape each, the first of them moving and selected; a shape beside them."""
    panel = PropertiesPanel(document, view_state)
    qtbot.addWidget(panel)
    with qtbot.waitExposed(panel, timeout=WAIT):
        panel.show()
    project = Project()
    for _ in range(2):
        project, layer = edit.add_layer(project)
        project, _shape = edit.new_shape(project, SQUARE, 1, layer_id=layer.id)
    project, _shape = edit.new_shape(project, SQUARE, 1)
    push = np.array([[1.0, 0.0, 5.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    motion = LayerTransform.of({1: np.eye(3), 3: push})
    document.open(edit.set_properties(project, "layer-1", transform=motion), None)
    view_state.select(frozenset({"shape-1"}), layers=frozenset({"layer-1"}))
    return panel


def layer(document: Document, number: int = 1) -> Layer:
    item = document.project.find(f"layer-{number}")
    assert isinstance(item, Layer)
    return item


ACTS = {
    "name": (lambda qtbot, form: type_in(qtbot, form.name, "hero"), "hero"),
    "opacity": (lambda qtbot, form: type_in(qtbot, form.opacity, "40"), 0.4),
    "visible": (lambda qtbot, form: form.visible.click(), False),
    "locked": (lambda qtbot, form: form.locked.click(), True),
    "invert": (lambda qtbot, form: form.invert.click(), True),
    "transform": (lambda qtbot, form: form.clear_motion.click(), None),
}


@pytest.mark.parametrize("name", ACTS)
def test_a_control_edits_its_field_in_one_step(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, name: str
) -> None:
    act, value = ACTS[name]
    before = layer(document)
    act(qtbot, panel.layer_form)
    assert getattr(layer(document), name) == value
    assert document.undo_stack.count() == 1
    document.undo_stack.undo()
    assert layer(document) == before
    assert panel.layer_form.name.text() == before.name


def test_the_form_follows_what_is_selected(panel: PropertiesPanel, view_state: ViewState) -> None:
    assert panel.layer_form.isVisible()
    assert panel.layer_form.clear_motion.isEnabled()
    view_state.select(frozenset({"shape-3"}))
    assert not panel.layer_form.isVisible()
    assert panel.name.isVisible()


def test_several_layers_are_edited_together(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, view_state: ViewState
) -> None:
    document.open(edit.set_properties(document.project, "layer-2", opacity=0.5, locked=True), None)
    view_state.select(frozenset({"shape-1", "shape-2"}), layers=frozenset({"layer-1", "layer-2"}))
    form = panel.layer_form
    assert form.opacity.is_mixed
    assert form.locked.checkState() is Qt.CheckState.PartiallyChecked
    type_in(qtbot, form.opacity, "20")
    assert (layer(document).opacity, layer(document, 2).opacity) == (0.2, 0.5)  # a locked one is left alone
    form.locked.click()
    assert layer(document).locked


def test_a_layer_in_a_locked_one_is_locked(panel: PropertiesPanel, document: Document, view_state: ViewState) -> None:
    project, outer = grouped(document.project, ["layer-1"])
    document.open(edit.set_properties(project, outer.id, locked=True), None)
    view_state.select(frozenset(), layers=frozenset({"layer-1"}))
    form, before = panel.layer_form, document.project
    assert not any(control.isEnabled() for control in (form.name, form.opacity, form.blend, form.invert))
    form.push("Layer opacity", opacity=0.2)
    form.clear_motion.clicked.emit()
    assert document.project == before
    form.visible.click()
    assert not layer(document).visible


def test_grouping_and_dissolving(panel: PropertiesPanel, document: Document, view_state: ViewState) -> None:
    verbs = LayerVerbs(document, view_state).handlers()
    before = document.project
    view_state.select(frozenset({"shape-2", "shape-3"}), layers=frozenset({"layer-2"}))
    verbs["shape.group"]()
    assert [child.id for child in layer(document, 3).children] == ["layer-2", "shape-3"]
    assert view_state.layers == {"layer-3"}
    verbs["layer.ungroup"]()
    assert document.project == before
    view_state.select(frozenset({"shape-1"}))  # the layer that holds it
    seen = [document.project.shape("shape-1").at(frame).points for frame in range(5)]
    verbs["layer.ungroup"]()
    assert [child.id for child in document.project.root.children] == ["shape-1", "layer-2", "shape-3"]
    np.testing.assert_allclose([document.project.shape("shape-1").at(frame).points for frame in range(5)], seen)
    assert document.undo_stack.count() == 3


def test_raising_and_lowering(panel: PropertiesPanel, document: Document, view_state: ViewState) -> None:
    verbs, order = LayerVerbs(document, view_state).handlers(), ["layer-1", "layer-2", "shape-3"]
    verbs["shape.raise"]()
    assert [child.id for child in document.project.root.children] == ["layer-2", "layer-1", "shape-3"]
    assert view_state.layers == {"layer-1"}
    verbs["shape.lower"]()
    verbs["shape.lower"]()
    assert view_state.message == "It lies at the bottom already."
    assert [child.id for child in document.project.root.children] == order
    assert document.undo_stack.count() == 2
    view_state.select(frozenset({"shape-3"}))
    verbs["shape.raise"]()
    assert view_state.message == "It lies on top already."
    view_state.select(frozenset())
    verbs["shape.raise"]()
    assert view_state.message == NOTHING_SELECTED
    assert [child.id for child in document.project.root.children] == order


def test_what_is_lost_with_a_layer_is_said(document: Document, view_state: ViewState) -> None:
    project, _ = edit.add_layer(Project())
    project, _ = edit.new_shape(project, SQUARE, 1, layer_id="layer-1")
    verbs = LayerVerbs(document, view_state).handlers()
    for look, said in (
        ({}, ""),
        ({"opacity": 0.5, "invert": True}, "Gone with what was dissolved: Legs (Opacity, Invert)."),
    ):
        document.open(edit.set_properties(project, "layer-1", name="Legs", **look), None)
        view_state.select(frozenset({"shape-1"}))
        verbs["layer.ungroup"]()
        assert view_state.message == said


def test_an_empty_layer_is_added_inside_the_selected_one(document: Document, view_state: ViewState) -> None:
    verbs = LayerVerbs(document, view_state).handlers()
    verbs["layer.add"]()
    assert view_state.layers == {"layer-1"}
    verbs["layer.add"]()
    assert [above.id for above in document.project.layers_above("layer-2")] == ["root", "layer-1"]


def test_without_a_selection_the_verbs_say_so(document: Document, view_state: ViewState) -> None:
    verbs = LayerVerbs(document, view_state).handlers()
    verbs["shape.group"]()
    assert view_state.message == NOTHING_SELECTED
    verbs["layer.ungroup"]()
    assert view_state.message == NO_LAYER


def test_of_several_layers_the_locked_one_keeps_its_values_and_that_is_said(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, view_state: ViewState
) -> None:
    document.open(edit.set_properties(document.project, "layer-2", locked=True), None)
    view_state.select(frozenset({"shape-1", "shape-2"}), layers=frozenset({"layer-1", "layer-2"}))
    type_in(qtbot, panel.layer_form.opacity, "20")
    assert (layer(document).opacity, layer(document, 2).opacity) == (0.2, 1.0)
    assert view_state.message == "What is locked stays; unlock it first (Ctrl+L)."
    view_state.say("")
    panel.layer_form.visible.click()  # works on what is locked, too
    assert view_state.message == ""
