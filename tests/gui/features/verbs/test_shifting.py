"""Shift in time: one undo step, of everything or of what is selected, and what becomes of tracked frames is said."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from app.features.verbs.shift_dialog import SELECTED, ShiftDialog
from app.features.verbs.shifting import Shifting
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.geometry.bezier import polygon_points
from roam_core.params import CONFIGS, DEFAULT_CONFIG
from roam_core.propagate.shapes.provenance import Stamps, clip_stamp, stamp
from roam_core.roto import Clip, Keyframe, Origin, Project, RotoShape, edit, timing

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])
CLIP = Clip(Path("plate"), 1, 20, (120, 80))


@pytest.fixture
def verb(document: Document, view_state: ViewState, qtbot: QtBot) -> Shifting:
    """A shape that was tracked from frame 3, another one with a key on 5, a note on 4; the second one is selected."""
    drawn = RotoShape("shape-1", "Car", (Keyframe(3, SQUARE),))
    inputs = stamp([drawn], 4, 3, CONFIGS[DEFAULT_CONFIG], clip_stamp(CLIP), forward=True)
    tracked = drawn.with_key(Keyframe(4, SQUARE, origin=Origin.ENGINE, inputs=inputs))
    far = RotoShape("shape-2", "Far", (Keyframe(5, SQUARE + 60),))
    project, _ = edit.add_items(Project(CLIP), [tracked, far])
    document.open(timing.set_mark(project, 4), None)
    view_state.select(frozenset({"shape-2"}))
    window = QWidget()
    qtbot.addWidget(window)
    window.show()
    return Shifting(window, document, view_state)


def asked(verb: Shifting) -> ShiftDialog:
    verb.handlers()["key.shift"]()
    dialog = verb._window.findChild(ShiftDialog)
    assert dialog is not None
    return dialog


def stale(project: Project) -> int:
    stamps = Stamps.of(project.shapes, project.clip)
    return sum(stamps.is_stale(shape, key) for shape in project.shapes for key in shape.keys)


def test_everything_is_shifted_in_one_step(verb: Shifting, document: Document, view_state: ViewState) -> None:
    before = document.project
    dialog = asked(verb)
    assert not dialog.ok.isEnabled()
    dialog.by.setValue(6)
    assert (dialog.now.text(), dialog.then.text()) == ("frames 3 to 5", "frames 9 to 11")
    dialog.accept()
    assert [shape.frames for shape in document.project.shapes] == [(9, 10), (11,)]
    assert [mark.frame for mark in document.project.marks] == [10]
    assert view_state.message.startswith("Shifted 6 frames later. Tracked frames are out of date")
    assert stale(document.project) == 1
    assert document.undo_stack.count() == 1
    verb.shift(-6)
    assert view_state.message == "Shifted 6 frames earlier."
    assert document.project == before


def test_what_is_selected_is_shifted_alone(verb: Shifting, document: Document, view_state: ViewState) -> None:
    dialog = asked(verb)
    dialog.what.setCurrentIndex(dialog.what.findData(SELECTED))
    dialog.by.setValue(1)
    assert dialog.then.text() == "frames 6 to 6"
    dialog.accept()
    assert [shape.frames for shape in document.project.shapes] == [(3, 4), (6,)]
    assert view_state.message == "Shifted 1 frame later."


def test_what_is_locked_is_shifted_with_everything_and_not_by_itself(
    verb: Shifting, document: Document, view_state: ViewState
) -> None:
    document.apply("Lock", edit.set_properties(document.project, "shape-2", locked=True))
    before = document.project
    verb.shift(2, ["shape-2"])
    assert document.project is before
    assert "locked" in view_state.message
    verb.shift(2)
    assert document.project.shape("shape-2").frames == (7,)


def test_what_is_locked_among_what_is_shifted_is_told(
    verb: Shifting, document: Document, view_state: ViewState
) -> None:
    document.apply("Lock", edit.set_properties(document.project, "shape-1", locked=True))
    verb.shift(2, ["shape-1", "shape-2"])
    assert [shape.frames for shape in document.project.shapes] == [(3, 4), (7,)]
    assert view_state.message.startswith("Shifted 2 frames later. What is locked stays")
    verb.shift(2, ["shape-2"])
    assert view_state.message == "Shifted 2 frames later."


def test_keys_beside_the_clip_are_offered_its_first_frame(verb: Shifting, document: Document) -> None:
    document.relink(Clip(Path("plate"), 1001, 1020, (120, 80)))
    assert asked(verb).offset == 998


def test_where_there_is_nothing_to_shift_that_is_said(
    verb: Shifting, document: Document, view_state: ViewState
) -> None:
    document.open(Project(CLIP), None)
    verb.ask()
    assert view_state.message.startswith("There is nothing to shift")
    assert verb._window.findChild(ShiftDialog) is None


def test_frames_that_no_project_can_number_are_refused(
    verb: Shifting, document: Document, view_state: ViewState
) -> None:
    before = document.project
    verb.shift(1_000_000_000)
    assert document.project is before
    assert "beyond frame" in view_state.message


def test_a_project_that_opens_meanwhile_takes_the_question_away(verb: Shifting, document: Document) -> None:
    """Its keys were not meant."""
    dialog = asked(verb)
    dialog.by.setValue(6)
    other, _ = edit.new_shape(Project(CLIP), SQUARE, 2)
    document.open(other, None)
    assert dialog.isHidden()
    assert document.project is other
