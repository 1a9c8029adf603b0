"""The rows of the shape panel about objects: they tell what the selected shapes are, and edit them."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox
from pytestqt.qtbot import QtBot

from app import style
from app.features.belonging import places
from app.model.document import Document
from app.model.view_state import ViewState
from app.panels.object_form import ObjectForm
from app.panels.properties import PropertiesPanel
from app.widgets.more import least_width
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Clip, Project, edit
from roam_core.roto.linking import linked, set_depth
from tests.gui.waiting import WAIT

A, B, C = "shape-1", "shape-2", "shape-3"


@pytest.fixture
def form(qtbot: QtBot, document: Document, view_state: ViewState) -> ObjectForm:
    """Three squares, each overlapping the next, the lowest in hand."""
    project = Project(clip=Clip(Path("plate"), 1, 20, (200, 150)))
    for left in (10, 50, 90):
        corners = [(left, 20), (left + 50, 20), (left + 50, 70), (left, 70)]
        project, _ = edit.new_shape(project, polygon_points(corners), 1)
    places(project)  # kernels are compiled, as the window has it done beside its thread
    document.open(project, None)
    panel = PropertiesPanel(document, view_state)
    qtbot.addWidget(panel)
    with qtbot.waitExposed(panel, timeout=WAIT):
        panel.show()
    view_state.select(frozenset({A}))
    return panel.object_form


def test_every_word_of_depth_has_room_in_the_narrowest_panel(form: ObjectForm) -> None:
    form.setStyleSheet(style.style_sheet())
    assert least_width(form.level) >= form.level.sizeHint().width()


def choose(box: QComboBox, word: str) -> None:
    """Choose an entry as a click in the list does."""
    index = box.findText(word)
    assert index >= 0, [box.itemText(k) for k in range(box.count())]
    box.setCurrentIndex(index)
    box.activated.emit(index)


def words(box: QComboBox) -> list[str]:
    return [box.itemText(k) for k in range(box.count())]


def told(form: ObjectForm) -> tuple[str, str, str]:
    return form.solve.currentText(), form.place.text(), form.level.currentText()


def test_it_tells_what_a_shape_is(form: ObjectForm, document: Document, view_state: ViewState) -> None:
    assert told(form) == ("By outlines", "Part of 3", "As stacked")
    assert form.attached.isChecked()
    document.apply("Link", linked(document.project, [A, B]))
    assert told(form) == ("As one: object-1", "Whole of 2 shapes (object-1)", "As stacked")
    view_state.select(frozenset({A, C}))
    assert form.solve.currentIndex() == -1
    assert form.place.text() == "mixed"


def test_how_it_is_solved_is_chosen(form: ObjectForm, document: Document, view_state: ViewState) -> None:
    assert words(form.solve) == ["By outlines", "By itself"]
    choose(form.solve, "By itself")
    assert told(form)[:2] == ("By itself", "By itself")
    view_state.select(frozenset({B, C}))
    choose(form.solve, "As one new object")
    assert [shape.link for shape in document.project.shapes] == ["object-1", "object-2", "object-2"]
    view_state.select(frozenset({A}))
    choose(form.solve, "As one: object-2")
    assert told(form)[:2] == ("As one: object-2", "Whole of 3 shapes (object-2)")
    choose(form.solve, "By outlines")
    assert document.project.shape(A).link == ""
    assert document.undo_stack.count() == 4


def test_depth_is_that_of_the_frame_and_set_from_there_on(
    form: ObjectForm, document: Document, view_state: ViewState
) -> None:
    view_state.set_frame(5)
    choose(form.level, "In front")
    view_state.set_frame(9)
    choose(form.level, "Behind")
    assert document.project.shape(A).depth == ((5, 1), (9, -1))
    shown = []
    for frame in (4, 5, 9):
        view_state.set_frame(frame)
        shown.append(form.level.currentText())
    assert shown == ["As stacked", "In front", "Behind"]
    assert "from 5 in front, from 9 behind" in form.level.toolTip()
    assert document.undo_stack.count() == 2


def test_what_differs_is_shown_as_mixed(form: ObjectForm, document: Document, view_state: ViewState) -> None:
    document.open(edit.set_properties(set_depth(document.project, [A], 1, 1), B, attached=False), None)
    view_state.select(frozenset({A, B}))
    assert form.level.currentIndex() == -1
    assert form.attached.checkState() is Qt.CheckState.PartiallyChecked


def test_a_part_is_detached_in_one_step(form: ObjectForm, document: Document) -> None:
    form.attached.click()
    assert not document.project.shape(A).attached
    assert document.undo_stack.count() == 1
    document.undo_stack.undo()
    assert form.attached.isChecked()


def test_a_locked_shape_cannot_be_edited(form: ObjectForm, document: Document) -> None:
    document.apply("Lock", edit.set_properties(document.project, A, locked=True))
    assert not any(control.isEnabled() for control in (form.solve, form.level, form.attached))
    assert form.place.isEnabled()


def test_showing_is_no_edit(form: ObjectForm, document: Document, view_state: ViewState) -> None:
    for chosen in ({A}, {A, B, C}, set()):
        view_state.select(frozenset(chosen))
        view_state.set_frame(view_state.frame + 1)
    assert document.undo_stack.count() == 0


def test_the_open_list_stays_as_it_is_while_frames_of_a_run_come(form: ObjectForm, document: Document) -> None:
    renewed: list[object] = []
    form.solve.model().rowsRemoved.connect(lambda *_: renewed.append("removed"))
    form.solve.model().modelReset.connect(lambda: renewed.append("reset"))
    document.apply("Move", document.project.with_shape(edit.key_here(document.project.shape(B), 4)))
    assert not renewed
    document.apply("Link", linked(document.project, [A, B]))
    assert renewed


def test_a_level_of_a_file_that_is_none_of_the_choices_is_told(
    form: ObjectForm, document: Document, view_state: ViewState
) -> None:
    """It was shown as mixed."""
    document.open(edit.set_properties(document.project, A, depth=((1, 3),)), None)
    view_state.select(frozenset({A}))
    assert (form.level.currentIndex(), form.level.placeholderText()) == (-1, "3")
    view_state.select(frozenset({A, B}))
    assert (form.level.currentIndex(), form.level.placeholderText()) == (-1, "mixed")
    view_state.select(frozenset({B}))
    assert form.level.currentText() == "As stacked"
