"""Stretch keys: between two frames that are typed, by keys alone; one undo step, and what has no use is told."""

from __future__ import annotations

from pytestqt.qtbot import QtBot

from app.model.document import Document
from app.model.view_state import ViewState
from app.timeline.timeline import Timeline
from app.timeline.values.stretching import StretchDialog
from roam_core.roto import Animated, ValueKey, edit, timing


def asked(timeline: Timeline) -> StretchDialog | None:
    timeline.handlers()["key.stretch"]()
    return timeline.findChild(StretchDialog)


def keys_of(document: Document, shape_id: str = "shape-1") -> tuple[int, ...]:
    return document.project.shape(shape_id).artist_frames


def test_chosen_keys_lie_between_the_frames_that_are_typed(
    qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    timeline.keys.select(timing.artist_places(document.project))
    before, count = document.project, document.undo_stack.count()
    dialog = asked(timeline)
    assert dialog is not None
    assert not dialog.ok.isEnabled()
    dialog.last.setValue(1040)
    dialog.accept()
    assert (keys_of(document), keys_of(document, "shape-2")) == ((1001, 1040), (1013, 1040))
    assert timeline.keys.places == timing.artist_places(document.project)
    assert view_state.message == "Stretch 4 keys: they go from frame 1001 to 1040."
    assert document.undo_stack.count() == count + 1
    document.undo_stack.undo()
    assert document.project == before


def test_keys_of_values_are_stretched_too(qtbot: QtBot, timeline: Timeline, document: Document) -> None:
    fade = Animated(tuple(ValueKey(frame, 0.5) for frame in (1001, 1005, 1009)))
    document.apply("Fade", edit.set_properties(document.project, "shape-1", opacity=fade))
    timeline.value_rows.verbs.select_all()
    dialog = asked(timeline)
    assert dialog is not None
    dialog.first.setValue(1003)
    dialog.last.setValue(1005)
    dialog.accept()
    opacity = document.project.shape("shape-1").opacity
    assert isinstance(opacity, Animated)
    assert opacity.frames == (1003, 1004, 1005)
    assert keys_of(document) == (1001, 1030)


def test_no_more_keys_than_frames(qtbot: QtBot, timeline: Timeline, document: Document) -> None:
    timeline.keys.select(timing.artist_places(document.project))
    dialog = asked(timeline)
    assert dialog is not None
    dialog.last.setValue(1002)
    assert not dialog.ok.isEnabled()
    assert dialog.room.text() == "Each key has a frame of its own: 3 frames at least."
    dialog.reject()


def test_where_there_is_nothing_to_stretch_it_is_said(
    timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    timeline.keys.select(frozenset({("shape-1", 1001)}))
    assert asked(timeline) is None
    assert view_state.message == "Choose keys on two frames at least, in the timeline or the curve editor."
    document.apply("Lock", edit.set_properties(document.project, "shape-1", locked=True))
    assert asked(timeline) is None
    assert view_state.message == "What the chosen keys belong to is locked; unlock it to stretch them."


def test_undo_and_redo_choose_the_keys_where_they_lie_then(timeline: Timeline, document: Document) -> None:
    before = timing.artist_places(document.project)
    timeline.keys.select(before)
    dialog = asked(timeline)
    assert dialog is not None
    dialog.last.setValue(1040)
    dialog.accept()
    after = timing.artist_places(document.project)
    document.undo_stack.undo()
    assert timeline.keys.places == before
    document.undo_stack.redo()
    assert timeline.keys.places == after
    document.undo_stack.undo()
    timeline.keys.select(frozenset({("shape-1", 1001)}))
    document.undo_stack.redo()
    assert timeline.keys.places == {("shape-1", 1001)}, "chosen since, and still there"
