"""The shape panel: every control shows the document and edits it, one undo step a change."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QLocale, QPoint, QPointF, Qt
from PySide6.QtGui import QColor, QPalette, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QColorDialog, QVBoxLayout, QWidget
from pytestqt.qtbot import QtBot

from app import style
from app.model.document import Document
from app.model.view_state import ViewState
from app.panels.colour_row import OTHER
from app.panels.properties import PropertiesPanel
from app.widgets.controls import ChoiceBox, align_labels, dense_form, form_label
from app.widgets.fields import NumberField, ScrubLabel
from roam_core.geometry.bezier import ANCHOR, polygon_points
from roam_core.roto import BlendMode, Clip, MotionBlur, Project, RotoShape, Spline, edit
from roam_core.roto.project import PALETTE
from tests.gui.waiting import WAIT

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])


@pytest.fixture
def panel(qtbot: QtBot, document: Document, view_state: ViewState) -> PropertiesPanel:
    panel = PropertiesPanel(document, view_state)
    qtbot.addWidget(panel)
    with qtbot.waitExposed(panel, timeout=WAIT):
        panel.show()
    project = Project(clip=Clip(Path("plate"), 1, 20, (200, 150)))
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
    "visible": (lambda qtbot, panel: panel.visible.click(), False),
    "locked": (lambda qtbot, panel: panel.locked.click(), True),
    "motion_blur": (lambda qtbot, panel: panel.blur.click(), MotionBlur()),
    "lifetime": (lambda qtbot, panel: panel.limited.click(), (1, 21)),
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
        "visible": panel.visible.isChecked(),
        "locked": not panel.locked.isChecked(),
        "motion_blur": not panel.blur.isChecked(),
        "lifetime": not panel.limited.isChecked(),
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
    panel.setStyleSheet(style.style_sheet())
    placeholder = panel.name.palette().color(QPalette.ColorGroup.Disabled, QPalette.ColorRole.PlaceholderText)
    assert placeholder.name() == style.WEAK  # read as well as what differs in the fields below
    assert placeholder.alpha() == 255
    view_state.select(frozenset({"shape-2"}))
    assert panel.name.isEnabled()
    assert panel.name.text() == "Shape 2"


def test_a_locked_shape_cannot_be_edited(panel: PropertiesPanel, document: Document) -> None:
    document.apply("Lock", edit.set_properties(document.project, "shape-1", locked=True))
    assert not panel.opacity.isEnabled()
    assert not panel.closed.isEnabled()


def test_a_b_spline_that_is_opened_or_closed_stays_one(
    panel: PropertiesPanel, document: Document, view_state: ViewState
) -> None:
    project, shape = edit.new_shape(document.project, SQUARE, 1, spline=Spline.BSPLINE)
    document.open(project, None)
    view_state.select(frozenset({shape.id}))
    panel.closed.click()
    opened = document.project.shape(shape.id)
    assert opened == edit.toggle_closed(shape)
    np.testing.assert_allclose(opened.at(1).control_points[:, ANCHOR], SQUARE[:, ANCHOR], atol=1e-9)
    panel.closed.click()
    np.testing.assert_allclose(document.project.shape(shape.id).at(1).points, shape.at(1).points, atol=1e-9)


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


def both(document: Document, view_state: ViewState, **values: object) -> None:
    """Select both shapes, with some fields of the first set; that is no step."""
    document.open(edit.set_properties(document.project, "shape-1", **values), None)
    view_state.select(frozenset({"shape-1", "shape-2"}))


def test_what_differs_is_shown_as_mixed(panel: PropertiesPanel, document: Document, view_state: ViewState) -> None:
    both(document, view_state, opacity=0.5, invert=True, blend=BlendMode.MAX, colour=PALETTE[3], lifetime=(2, 5))
    assert panel.opacity.is_mixed
    assert panel.opacity.text() == ""
    assert panel.invert.checkState() is Qt.CheckState.PartiallyChecked
    assert panel.blend.currentIndex() == -1
    assert panel.colours.group.checkedId() == -1
    assert panel.limited.checkState() is Qt.CheckState.PartiallyChecked
    assert panel.feather.text() == "0.0 px"


def test_mixed_values_become_one_by_one_edit(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, view_state: ViewState
) -> None:
    both(document, view_state, opacity=0.5, invert=True, blend=BlendMode.MAX)
    type_in(qtbot, panel.opacity, "100")  # what the field held unseen counts when it is typed
    panel.invert.click()
    panel.blend.setCurrentIndex(panel.blend.findData(BlendMode.ADD))
    assert {(each.opacity, each.invert, each.blend) for each in document.project.shapes} == {(1.0, True, BlendMode.ADD)}
    assert document.undo_stack.count() == 3


def test_leaving_a_mixed_field_changes_nothing(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, view_state: ViewState
) -> None:
    both(document, view_state, opacity=0.5)
    panel.opacity.setFocus()
    qtbot.keyClick(panel.opacity, Qt.Key.Key_Return)
    assert document.undo_stack.count() == 0
    assert panel.opacity.is_mixed


def test_a_turn_of_the_wheel_is_one_step(panel: PropertiesPanel, document: Document) -> None:
    def turn() -> None:
        middle = QPointF(panel.opacity.rect().center())
        none, where = Qt.KeyboardModifier.NoModifier, QPointF(panel.opacity.mapToGlobal(middle))
        scroll = Qt.ScrollPhase.NoScrollPhase
        event = QWheelEvent(middle, where, QPoint(), QPoint(0, -120), Qt.MouseButton.NoButton, none, scroll, False)
        QApplication.sendEvent(panel.opacity, event)

    turn()
    assert shape(document).opacity == 1.0  # a field that was not chosen lets the panel scroll
    panel.opacity.setFocus()
    for _ in range(3):
        turn()
    assert shape(document).opacity == pytest.approx(0.97)
    assert document.undo_stack.count() == 1


def label_of(panel: PropertiesPanel, field: NumberField) -> ScrubLabel:
    (label,) = (label for label in panel.findChildren(ScrubLabel) if label._field is field)
    return label


def test_dragging_a_label_is_one_step_and_two_drags_are_two(panel: PropertiesPanel, document: Document) -> None:
    label = label_of(panel, panel.feather)
    for start, far in ((10, 50), (10, 26)):
        QTest.mousePress(label, Qt.MouseButton.LeftButton, pos=QPoint(start, 8))
        for x in (start + 4, far):
            QTest.mouseMove(label, QPoint(x, 8))
        QTest.mouseRelease(label, Qt.MouseButton.LeftButton, pos=QPoint(far, 8))
    assert shape(document).feather == pytest.approx(7.0)  # 56 px of 4 px a step of .5
    assert document.undo_stack.count() == 2
    document.undo_stack.undo()
    assert shape(document).feather == pytest.approx(5.0)


def test_motion_blur_has_its_numbers(qtbot: QtBot, panel: PropertiesPanel, document: Document) -> None:
    assert not panel.shutter.isEnabled()
    panel.blur.click()
    assert panel.shutter.isEnabled()
    type_in(qtbot, panel.shutter, "1")
    type_in(qtbot, panel.phase, "-0.5")
    type_in(qtbot, panel.samples, "9")
    assert shape(document).motion_blur == MotionBlur(1.0, -0.5, 9)
    assert isinstance(shape(document).motion_blur.samples, int)
    panel.blur.click()
    assert shape(document).motion_blur is None
    assert document.undo_stack.count() == 5


def test_a_lifetime_is_typed_or_taken_from_the_playhead(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, view_state: ViewState
) -> None:
    assert not panel.first.isEnabled()
    assert (panel.first.text(), panel.last.text()) == ("1", "20")
    panel.limited.click()
    type_in(qtbot, panel.first, "4")
    type_in(qtbot, panel.last, "9")
    assert shape(document).lifetime == (4, 10)  # the last frame is in it
    view_state.set_frame(6)
    panel.to_here.click()
    assert shape(document).lifetime == (4, 7)
    view_state.set_frame(12)
    panel.from_here.click()
    assert shape(document).lifetime == (12, 13)
    assert (panel.first.value(), panel.last.value()) == (12, 12)


def test_an_end_of_a_lifetime_that_is_dragged_past_the_other_leaves_it_where_it_is(
    panel: PropertiesPanel, document: Document
) -> None:
    """Dragged back it would have stayed where it was pushed to."""
    document.apply("Lifetime", edit.set_properties(document.project, "shape-1", lifetime=(4, 10)))
    for field, ways, lifetime in ((panel.first, (7, 15, 6), (6, 10)), (panel.last, (7, 2, 8), (6, 9))):
        field.begin_gesture()
        for frame in ways:
            field.drag_to(frame)
        assert shape(document).lifetime == lifetime
    panel.first.drag_to(15)
    assert (shape(document).lifetime, panel.first.value()) == ((8, 9), 8)


def test_any_colour_can_be_picked(panel: PropertiesPanel, document: Document) -> None:
    panel.colours.group.button(OTHER).click()
    dialog = panel.colours.findChild(QColorDialog)
    dialog.setCurrentColor(QColor.fromRgbF(0.2, 0.4, 0.6))
    dialog.accept()
    assert shape(document).colour == pytest.approx((0.2, 0.4, 0.6), abs=0.002)
    assert panel.colours.group.checkedId() == OTHER


def test_a_locked_shape_can_be_unlocked_and_hidden(panel: PropertiesPanel, document: Document) -> None:
    panel.locked.click()
    panel.visible.click()
    assert (shape(document).locked, shape(document).visible) == (True, False)
    panel.locked.click()
    assert not shape(document).locked


def test_neither_the_wheel_nor_the_keyboard_changes_a_choice_by_the_way(
    qtbot: QtBot, panel: PropertiesPanel, document: Document
) -> None:
    for box in panel.findChildren(ChoiceBox):
        before = box.currentIndex()
        place = QPointF(box.rect().center())
        for turn in (-120, 120):
            event = QWheelEvent(
                place,
                QPointF(box.mapToGlobal(place)),
                QPoint(),
                QPoint(0, turn),
                Qt.MouseButton.NoButton,
                Qt.KeyboardModifier.NoModifier,
                Qt.ScrollPhase.NoScrollPhase,
                False,
            )
            QApplication.sendEvent(box, event)
            assert not event.isAccepted()  # the panel scrolls
        assert box.currentIndex() == before
        assert box.focusPolicy() is Qt.FocusPolicy.TabFocus
    assert panel.blend in panel.findChildren(ChoiceBox)
    assert document.undo_stack.count() == 0


def test_of_several_shapes_the_locked_one_keeps_its_values_and_that_is_said(
    panel: PropertiesPanel, document: Document, view_state: ViewState
) -> None:
    """The field went back to mixed, without a word."""
    document.apply("Lock", edit.set_properties(document.project, "shape-2", locked=True))
    view_state.select(frozenset({"shape-1", "shape-2"}))
    panel.push("Blend", blend=BlendMode.MAX)
    assert [shape(document, number).blend for number in (1, 2)] == [BlendMode.MAX, BlendMode.ADD]
    assert view_state.message == "What is locked stays; unlock it first (Ctrl+L)."
    view_state.say("")
    panel.push("Show", visible=False)
    assert view_state.message == ""


FEATHERS = (2.0, 4.0, 80.0)


def three(document: Document, view_state: ViewState) -> None:
    """Three shapes that differ in their numbers: the third was shown, now the first two are selected."""
    project, _shape = edit.new_shape(document.project, SQUARE, 1)
    for number, (feather, samples) in enumerate(zip(FEATHERS, (4, 8, 64), strict=True), start=1):
        blur = MotionBlur(samples=samples)
        values = {"feather": feather, "opacity": 1.0 / number, "motion_blur": blur}
        project = edit.set_properties(project, f"shape-{number}", **values)
    document.open(project, None)
    view_state.select(frozenset({"shape-3"}))
    view_state.select(frozenset({"shape-1", "shape-2"}))


@pytest.mark.parametrize("is_dragged", [False, True], ids=["step", "drag"])
def test_what_differs_is_changed_from_the_first_shapes_value_on(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, view_state: ViewState, is_dragged: bool
) -> None:
    """It began at the value of a shape that was shown before."""
    three(document, view_state)
    assert panel.feather.is_mixed
    if is_dragged:
        label = label_of(panel, panel.feather)
        QTest.mousePress(label, Qt.MouseButton.LeftButton, pos=QPoint(10, 8))
        QTest.mouseMove(label, QPoint(14, 8))
        QTest.mouseRelease(label, Qt.MouseButton.LeftButton, pos=QPoint(14, 8))
    else:
        qtbot.keyClick(panel.feather, Qt.Key.Key_Up)
    assert [shape(document, number).feather for number in (1, 2, 3)] == [2.5, 2.5, 80.0]
    both(document, view_state, lifetime=(5, 10))
    view_state.select(frozenset({"shape-2"}))
    view_state.select(frozenset({"shape-1", "shape-2"}))
    qtbot.keyClick(panel.first, Qt.Key.Key_Up)
    assert [shape(document, number).lifetime for number in (1, 2)] == [(6, 10), (6, 21)]


@pytest.mark.parametrize(("name", "text"), [("feather", "-"), ("opacity", "-"), ("samples", "-")])
def test_what_is_no_number_of_a_mixed_field_gives_nothing(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, view_state: ViewState, name: str, text: str
) -> None:
    three(document, view_state)
    type_in(qtbot, getattr(panel, name), text)
    panel.clearFocus()
    assert document.undo_stack.count() == 0
    assert (getattr(panel, name).is_mixed, getattr(panel, name).text()) == (True, "")


@pytest.mark.parametrize("language", ["de_DE", "en_US"])
def test_point_and_comma_part_the_decimals_in_every_language(qtbot: QtBot, language: str) -> None:
    """Of the other one of them the language makes groups: 2.5 was 25 in German."""
    before, given = QLocale(), []
    QLocale.setDefault(QLocale(language))
    try:
        for decimals, suffix, texts in ((1, " px", ("2.5", "2,5")), (2, "", ("-2.5", "-2,5")), (0, " f", ("1001",))):
            for text in texts:
                field = NumberField(-5000.0, 5000.0, suffix=suffix, decimals=decimals)
                qtbot.addWidget(field)
                field.edited.connect(lambda value, _key: given.append(value))
                field.show_value(0.0)
                type_in(qtbot, field, text)
    finally:
        QLocale.setDefault(before)
    assert given == [2.5, 2.5, -2.5, -2.5, 1001.0]


def test_a_number_beyond_the_fields_range_is_shown_as_the_file_holds_it(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, view_state: ViewState
) -> None:
    both(document, view_state, feather=800.0)
    view_state.select(frozenset({"shape-1"}))
    assert panel.feather.text() == "800.0 px"
    panel.name.setFocus()
    qtbot.keyClick(panel.feather, Qt.Key.Key_Return)
    assert shape(document).feather == 800.0  # a visit changes nothing
    document.apply("Feather", edit.set_properties(document.project, "shape-2", feather=4.0))
    view_state.select(frozenset({"shape-2"}))
    assert panel.feather.text() == "4.0 px"
    assert (panel.feather.minimum(), panel.feather.maximum()) == (-500.0, 500.0)


def test_a_visit_to_a_name_with_spaces_around_it_is_no_step(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, view_state: ViewState
) -> None:
    view_state.select(frozenset())
    document.open(edit.set_properties(document.project, "shape-1", name=" arm "), None)
    view_state.select(frozenset({"shape-1"}))
    panel.activateWindow()
    panel.name.setFocus()
    qtbot.waitUntil(panel.name.hasFocus, timeout=WAIT)
    panel.opacity.setFocus()
    qtbot.keyClick(panel.name, Qt.Key.Key_Return)
    assert document.undo_stack.count() == 0
    assert shape(document).name == " arm "
    type_in(qtbot, panel.name, " leg ")
    assert shape(document).name == "leg"


def test_of_colours_that_differ_none_is_framed_after_another_was_asked_for_in_vain(
    panel: PropertiesPanel, document: Document, view_state: ViewState
) -> None:
    both(document, view_state, colour=PALETTE[3])
    panel.colours.group.button(OTHER).click()
    panel.colours.findChild(QColorDialog).reject()
    assert panel.colours.group.checkedId() == -1
    assert document.undo_stack.count() == 0


def test_numbers_of_motion_blur_are_those_of_the_shapes_that_have_it(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, view_state: ViewState
) -> None:
    """A number that changes one of two shapes was told to differ for ever."""
    both(document, view_state, motion_blur=MotionBlur(shutter=0.75))
    assert (panel.shutter.text(), panel.shutter.is_mixed) == ("0.75 frames", False)
    type_in(qtbot, panel.shutter, "0.3")
    assert (panel.shutter.text(), panel.shutter.is_mixed) == ("0.30 frames", False)
    assert [shape(document, number).motion_blur for number in (1, 2)] == [MotionBlur(shutter=0.3), None]


@pytest.mark.parametrize("blur", [MotionBlur(samples=1), MotionBlur(shutter=-0.5)])
def test_motion_blur_of_a_file_that_is_seen_nowhere_is_shown(
    qtbot: QtBot, panel: PropertiesPanel, document: Document, blur: MotionBlur
) -> None:
    document.apply("Blur", edit.set_properties(document.project, "shape-1", motion_blur=blur))
    assert (panel.shutter.value(), panel.samples.value()) == (blur.shutter, blur.samples)
    type_in(qtbot, panel.opacity, "40")
    assert shape(document).opacity == 0.4


def test_fields_of_forms_below_each_other_begin_at_one_place(qtbot: QtBot) -> None:
    """Also where a word of one of them is long, as in other languages."""
    page, fields = QWidget(), [NumberField(0.0, 1.0), NumberField(0.0, 1.0)]
    qtbot.addWidget(page)
    forms = [dense_form() for _ in fields]
    column = QVBoxLayout(page)
    for form, word, field in zip(forms, ("Short", "A label of quite some length"), fields, strict=True):
        form.addRow(form_label(word), field)
        column.addLayout(form)
    align_labels(*forms)
    page.grab()
    assert len({field.mapTo(page, QPoint()).x() for field in fields}) == 1


def test_tab_goes_from_number_to_number_and_past_no_button(
    qtbot: QtBot, panel: PropertiesPanel, document: Document
) -> None:
    """Return pressed the diamond between them, which keyed the opacity."""
    edited = edit.set_properties(document.project, "shape-1", lifetime=(1, 21))
    document.open(edited, None)
    for first, second, texts in ((panel.opacity, panel.feather, "40 2.5"), (panel.first, panel.last, "3 9")):
        first.setFocus()
        first.selectAll()
        for text in texts.split():
            QTest.keyClicks(QApplication.focusWidget(), text)
            QTest.keyClick(QApplication.focusWidget(), Qt.Key.Key_Tab)
        assert QApplication.focusWidget() is (panel.opacity_key if second is panel.feather else panel.from_here)
    assert (shape(document).opacity, shape(document).feather, shape(document).lifetime) == (0.4, 2.5, (3, 10))
    panel.opacity_key.setFocus()
    qtbot.keyClick(panel.opacity_key, Qt.Key.Key_Tab)
    assert QApplication.focusWidget() is panel.feather_key
