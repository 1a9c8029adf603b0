"""Opacity and feather through time: the fields edit the value on this frame, the button beside them its keys."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QAction, QContextMenuEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu
from pytestqt.qtbot import QtBot

from app.model.document import Document
from app.model.view_state import ViewState
from app.panels.properties import PropertiesPanel
from app.panels.value_key import ValueKeyButton
from app.widgets.fields import NumberField
from roam_core.roto import Animated, Interpolation, ValueKey, edit
from roam_core.roto.value_keys import Keying
from tests.gui.panels.test_layer_form import layer
from tests.gui.panels.test_layer_form import panel as layers
from tests.gui.panels.test_properties import label_of, panel, shape, type_in
from tests.gui.waiting import WAIT

__all__ = ["layers", "panel"]
LEFT = Qt.MouseButton.LeftButton


def entry(button: ValueKeyButton, text: str) -> QAction:
    (action,) = (action for action in button.menu_of_keys.actions() if action.text() == text)
    return action


def looks(button: ValueKeyButton) -> tuple[Keying, str]:
    return button.state, button.toolTip().partition(".")[0]


def begin(qtbot: QtBot, field: NumberField, text: str) -> None:
    """Type, and leave it at that."""
    field.window().activateWindow()
    field.setFocus()
    qtbot.waitUntil(field.hasFocus, timeout=WAIT)
    field.selectAll()
    qtbot.keyClicks(field, text)


CONSTANT = Keying.CONSTANT, "It never varies"
KEY = Keying.KEY, "It has a key on this frame"
BETWEEN = Keying.BETWEEN, "It varies, without a key on this frame"


def test_a_click_sets_a_key_and_edits_then_set_keys_on_their_frames(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, view_state: ViewState
) -> None:
    type_in(qtbot, panel.opacity, "80")
    assert shape(document).opacity == 0.8
    assert looks(panel.opacity_key) == CONSTANT
    qtbot.mouseClick(panel.opacity_key, LEFT)
    frame = view_state.frame
    assert shape(document).opacity == Animated((ValueKey(frame, 0.8),))
    assert looks(panel.opacity_key) == KEY
    view_state.set_frame(frame + 10)
    assert looks(panel.opacity_key) == BETWEEN
    type_in(qtbot, panel.opacity, "20")
    assert shape(document).opacity == Animated((ValueKey(frame, 0.8), ValueKey(frame + 10, 0.2)))
    assert looks(panel.opacity_key) == KEY
    view_state.set_frame(frame + 5)
    assert panel.opacity.value() == 50
    assert looks(panel.opacity_key) == BETWEEN
    assert looks(panel.feather_key) == CONSTANT
    assert document.undo_stack.count() == 3


def test_the_last_key_to_go_leaves_a_constant_and_undo_brings_it_back(
    qtbot: QtBot, panel: PropertiesPanel, document: Document
) -> None:
    type_in(qtbot, panel.feather, "3.5")
    qtbot.mouseClick(panel.feather_key, LEFT)
    assert document.undo_stack.undoText() == "Feather: set key"
    qtbot.mouseClick(panel.feather_key, LEFT)
    assert document.undo_stack.undoText() == "Feather: delete key"
    assert shape(document).feather == 3.5
    assert looks(panel.feather_key) == CONSTANT
    document.undo_stack.undo()
    assert looks(panel.feather_key) == KEY


def test_a_gesture_on_a_key_is_one_step(qtbot: QtBot, panel: PropertiesPanel, document: Document) -> None:
    qtbot.mouseClick(panel.opacity_key, LEFT)
    before = document.undo_stack.count()
    panel.opacity.begin_gesture()
    for value in (90.0, 70.0, 60.0):
        panel.opacity.drag_to(value)
    assert shape(document).opacity == Animated((ValueKey(1, 0.6),))
    assert document.undo_stack.count() == before + 1


@pytest.mark.parametrize("kind", Interpolation)
def test_the_menu_says_how_a_value_goes_on_from_the_key_before(
    panel: PropertiesPanel, document: Document, view_state: ViewState, kind: Interpolation
) -> None:
    moving = Animated((ValueKey(1, 0.0), ValueKey(11, 1.0)))
    document.apply("Vary", edit.set_properties(document.project, "shape-1", opacity=moving))
    view_state.set_frame(4)
    entry(panel.opacity_key, kind.value.capitalize()).trigger()
    opacity = shape(document).opacity
    assert isinstance(opacity, Animated)
    assert [key.interpolation for key in opacity.keys] == [kind, Interpolation.LINEAR]
    assert panel.opacity.value() == pytest.approx(100 * opacity.at(4), abs=0.5)
    checked = [action.text() for action in panel.opacity_key.menu_of_keys.actions() if action.isChecked()]
    assert checked == [kind.value.capitalize()]


def test_the_menu_offers_what_there_is_to_do(panel: PropertiesPanel, document: Document, view_state: ViewState) -> None:
    def offered() -> set[str]:
        return {action.text() for action in panel.opacity_key.menu_of_keys.actions() if action.isEnabled()} - {""}

    ways = {"Linear", "Smooth", "Hold", "Tangents"}
    assert offered() == {"Set key"}
    entry(panel.opacity_key, "Set key").trigger()
    assert offered() == {"Delete key", "Delete all keys"} | ways
    view_state.set_frame(3)
    assert offered() == {"Set key", "Delete all keys"} | ways
    document.apply(
        "Vary", edit.set_properties(document.project, "shape-1", opacity=Animated((ValueKey(1, 0.0), ValueKey(5, 1.0))))
    )
    entry(panel.opacity_key, "Delete all keys").trigger()
    assert shape(document).opacity == 0.5


def test_a_right_click_on_field_or_button_opens_the_menu(
    panel: PropertiesPanel, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[QPoint] = []
    monkeypatch.setattr(QMenu, "popup", lambda menu, place: opened.append(place))
    for widget in (panel.opacity.lineEdit(), panel.opacity, panel.opacity_key):
        place = QPoint(3, 2)
        event = QContextMenuEvent(QContextMenuEvent.Reason.Mouse, place, widget.mapToGlobal(place))
        QApplication.sendEvent(widget, event)
        assert opened.pop() == widget.mapToGlobal(place)


def test_several_shapes_get_keys_together(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, view_state: ViewState
) -> None:
    view_state.select(frozenset({"shape-1"}))
    qtbot.mouseClick(panel.feather_key, LEFT)
    view_state.select(frozenset({"shape-1", "shape-2"}))
    assert panel.feather_key.state is Keying.BETWEEN
    qtbot.mouseClick(panel.feather_key, LEFT)
    assert looks(panel.feather_key) == KEY
    assert [each.feather for each in document.project.shapes] == [Animated((ValueKey(1, 0.0),))] * 2
    qtbot.mouseClick(panel.feather_key, LEFT)
    assert [each.feather for each in document.project.shapes] == [0.0, 0.0]


def test_a_locked_shape_keeps_its_keys(qtbot: QtBot, panel: PropertiesPanel, document: Document) -> None:
    document.apply("Lock", edit.set_properties(document.project, "shape-1", locked=True))
    assert not panel.opacity_key.isEnabled()
    assert not panel.opacity.isEnabled()


def test_a_layers_opacity_varies_too(
    qtbot: QtBot, layers: PropertiesPanel, document: Document, view_state: ViewState
) -> None:
    form = layers.layer_form
    qtbot.mouseClick(form.opacity_key, LEFT)
    view_state.set_frame(5)
    assert form.opacity_key.state is Keying.BETWEEN
    type_in(qtbot, form.opacity, "40")
    assert layer(document).opacity == Animated((ValueKey(1, 1.0), ValueKey(5, 0.4)))
    view_state.set_frame(3)
    assert form.opacity.value() == 70
    entry(form.opacity_key, "Delete all keys").trigger()
    assert layer(document).opacity == pytest.approx(0.7)
    assert document.undo_stack.undoText() == "Layer opacity: delete all keys"


def test_keys_go_to_the_frame_that_is_shown_even_of_what_never_varied(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, view_state: ViewState
) -> None:
    view_state.set_frame(9)
    qtbot.mouseClick(panel.opacity_key, LEFT)
    assert shape(document).opacity == Animated((ValueKey(9, 1.0),))


def test_shapes_that_differ_say_so(
    panel: PropertiesPanel, document: Document, view_state: ViewState, qtbot: QtBot
) -> None:
    qtbot.mouseClick(panel.opacity_key, LEFT)
    view_state.select(frozenset({"shape-1", "shape-2"}))
    assert looks(panel.opacity_key) == (Keying.BETWEEN, "Some have a key on this frame or vary, others do not")


def test_the_field_has_one_menu_for_keys_and_for_text(
    panel: PropertiesPanel, document: Document, monkeypatch: pytest.MonkeyPatch
) -> None:
    menus: list[QMenu] = []
    monkeypatch.setattr(QMenu, "popup", lambda menu, place: menus.append(menu))
    event = QContextMenuEvent(QContextMenuEvent.Reason.Mouse, QPoint(3, 2), panel.opacity.mapToGlobal(QPoint(3, 2)))
    QApplication.sendEvent(panel.opacity, event)
    (menu,) = menus
    words = [action.text().replace("&", "").partition("\t")[0] for action in menu.actions()]
    assert words[:3] == ["Set key", "Delete key", "Delete all keys"]
    assert {"Hold", "Copy", "Paste", "Select All"} <= set(words)
    menu.actions()[0].trigger()
    assert shape(document).opacity == Animated((ValueKey(1, 1.0),))


def test_a_click_takes_what_was_typed_and_does_not_delete_its_key(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, view_state: ViewState
) -> None:
    """The press takes the number out of the field, which sets a key; the click means that key."""
    qtbot.mouseClick(panel.opacity_key, LEFT)
    view_state.set_frame(9)
    begin(qtbot, panel.opacity, "33")
    before = document.undo_stack.count()
    qtbot.mouseClick(panel.opacity_key, LEFT)
    assert shape(document).opacity == Animated((ValueKey(1, 1.0), ValueKey(9, 0.33)))
    assert document.undo_stack.count() == before + 1
    QApplication.processEvents()
    qtbot.mouseClick(panel.opacity_key, LEFT)
    assert shape(document).opacity == Animated((ValueKey(1, 1.0),))


def test_the_menu_bends_a_value_and_says_that_it_is_bent(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, view_state: ViewState
) -> None:
    qtbot.mouseClick(panel.opacity_key, LEFT)
    entry(panel.opacity_key, "Tangents").trigger()
    frame = view_state.frame
    assert shape(document).opacity == Animated((ValueKey(frame, 1.0, slopes=(0.0, 0.0)),))
    checked = [action.text() for action in panel.opacity_key.menu_of_keys.actions() if action.isChecked()]
    assert checked == ["Tangents"]
    entry(panel.opacity_key, "Linear").trigger()
    assert shape(document).opacity == Animated((ValueKey(frame, 1.0),))


def test_the_first_key_of_a_value_has_the_number_that_is_being_typed(
    qtbot: QtBot, panel: PropertiesPanel, document: Document
) -> None:
    """The number came after the key, as a step of its own."""
    begin(qtbot, panel.feather, "5")
    qtbot.mouseClick(panel.feather_key, LEFT)
    assert shape(document).feather == Animated((ValueKey(1, 5.0),))
    panel.feather.clearFocus()
    assert shape(document).feather == Animated((ValueKey(1, 5.0),))
    assert not panel.feather.hasFocus()


FORMS = pytest.mark.parametrize("is_layer", [False, True], ids=["shape", "layer"])


def varying(document: Document, panel: PropertiesPanel, view_state: ViewState, is_layer: bool) -> NumberField:
    """The field of an opacity that has a key on frame 1, shown on frame 2."""
    if is_layer:
        project = edit.add_layer(document.project)[0]
        document.open(edit.set_properties(project, "layer-1", opacity=Animated((ValueKey(1, 1.0),))), None)
        view_state.select(frozenset(), layers=frozenset({"layer-1"}))
    else:
        document.open(edit.set_properties(document.project, "shape-1", opacity=Animated((ValueKey(1, 1.0),))), None)
        view_state.select(frozenset({"shape-1"}))
    view_state.set_frame(2)
    return panel.layer_form.opacity if is_layer else panel.opacity


def keys(document: Document, is_layer: bool) -> list[tuple[int, float]]:
    opacity = (layer(document) if is_layer else shape(document)).opacity
    assert isinstance(opacity, Animated)
    return [(key.frame, round(key.value, 3)) for key in opacity.keys]


@FORMS
def test_a_number_means_the_frame_on_which_it_was_begun(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, view_state: ViewState, is_layer: bool
) -> None:
    """A run, or a press on the ruler, goes on to other frames meanwhile."""
    field = varying(document, panel, view_state, is_layer)
    begin(qtbot, field, "4")
    view_state.set_frame(6)
    qtbot.keyClicks(field, "0")
    view_state.set_frame(8)
    qtbot.keyClick(field, Qt.Key.Key_Return)
    assert keys(document, is_layer) == [(1, 1.0), (2, 0.4)]
    begin(qtbot, field, "50")  # the next one means the frame that is shown by now
    qtbot.keyClick(field, Qt.Key.Key_Return)
    assert keys(document, is_layer) == [(1, 1.0), (2, 0.4), (8, 0.5)]


@FORMS
def test_a_drag_of_the_label_sets_one_key_while_frames_go_by(
    panel: PropertiesPanel, document: Document, view_state: ViewState, is_layer: bool
) -> None:
    label = label_of(panel, varying(document, panel, view_state, is_layer))
    QTest.mousePress(label, LEFT, pos=QPoint(60, 8))
    for steps in range(1, 6):
        QTest.mouseMove(label, QPoint(60 - 8 * steps, 8))
        view_state.set_frame(view_state.frame + 1)
    QTest.mouseRelease(label, LEFT, pos=QPoint(20, 8))
    assert [frame for frame, _ in keys(document, is_layer)] == [1, 2]
    assert document.undo_stack.count() == 1


@FORMS
def test_a_step_means_the_frame_that_is_shown(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, view_state: ViewState, is_layer: bool
) -> None:
    field = varying(document, panel, view_state, is_layer)
    begin(qtbot, field, "4")
    qtbot.keyClick(field, Qt.Key.Key_Return)
    view_state.set_frame(6)
    qtbot.keyClick(field, Qt.Key.Key_Up)
    assert keys(document, is_layer) == [(1, 1.0), (2, 0.04), (6, 0.05)]
