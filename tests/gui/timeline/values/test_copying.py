"""Keys of opacity, feather and position are copied: dragged with Alt, and by copy, cut and paste in their rows."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.model.document import Document
from app.model.view_state import ViewState
from app.timeline.timeline import Timeline
from app.timeline.values.verbs import FITS_NOTHING
from roam_core.roto import Animated, Interpolation, Project, ValueKey, edit
from roam_core.roto.layers import grouped
from tests.gui.timeline.places import CLIP, place
from tests.gui.waiting import WAIT

LEFT = Qt.MouseButton.LeftButton
ALT = Qt.KeyboardModifier.AltModifier
FADES = Animated((ValueKey(1005, 0.2), ValueKey(1015, 0.8, Interpolation.HOLD)))
COPY, CUT, PASTE = "edit.copy", "edit.cut", "edit.paste"


class Elsewhere:
    """What the actions mean outside the timeline: counted."""

    def __init__(self) -> None:
        self.called: list[str] = []

    def handlers(self) -> dict[str, Callable[[], object]]:
        return {name: lambda name=name: self.called.append(name) for name in (COPY, CUT, PASTE, "key.copy")}


@pytest.fixture
def elsewhere() -> Elsewhere:
    return Elsewhere()


@pytest.fixture
def keyed(qtbot: QtBot, timeline: Timeline, document: Document) -> None:
    """The lower shape fades; the rows of values have the keyboard."""
    shape = replace(document.project.shape("shape-1"), opacity=FADES)
    document.apply("Fade", document.project.with_shape(shape))
    qtbot.waitUntil(timeline.value_rows.isVisible, timeout=WAIT)
    timeline.activateWindow()
    timeline.value_rows.setFocus()
    qtbot.waitUntil(timeline.value_rows.hasFocus, timeout=WAIT)


@pytest.fixture
def act(timeline: Timeline, keyed: None, elsewhere: Elsewhere) -> dict[str, Callable[[], object]]:
    return timeline.taking_over(elsewhere.handlers())


def fades(project: Project, name: str = "shape-1") -> dict[int, float]:
    found = project.shape(name).opacity
    assert isinstance(found, Animated)
    return {key.frame: key.value for key in found.keys}


def test_with_alt_a_drag_leaves_the_key_and_takes_a_copy(
    timeline: Timeline, document: Document, view_state: ViewState, keyed: None
) -> None:
    rows, steps = timeline.value_rows, document.undo_stack.count()
    start, end = place(timeline, 1005, 0), place(timeline, 1009, 0)

    def send(kind: QEvent.Type, at: QPointF, held: Qt.MouseButton, modifiers: Qt.KeyboardModifier) -> None:
        button = Qt.MouseButton.NoButton if kind == QEvent.Type.MouseMove else LEFT
        QApplication.sendEvent(rows, QMouseEvent(kind, at, QPointF(rows.mapToGlobal(at)), button, held, modifiers))

    send(QEvent.Type.MouseButtonPress, QPointF(start), LEFT, Qt.KeyboardModifier.NoModifier)
    send(QEvent.Type.MouseMove, QPointF(end), LEFT, Qt.KeyboardModifier.NoModifier)
    assert view_state.preview is not None
    assert fades(view_state.preview) == {1009: 0.2, 1015: 0.8}
    send(QEvent.Type.MouseMove, QPointF(end), LEFT, ALT)  # pressed on the way it counts at once
    assert view_state.preview is not None
    assert fades(view_state.preview) == {1005: 0.2, 1009: 0.2, 1015: 0.8}
    send(QEvent.Type.MouseButtonRelease, QPointF(end), Qt.MouseButton.NoButton, ALT)
    assert fades(document.project) == {1005: 0.2, 1009: 0.2, 1015: 0.8}
    assert document.undo_stack.count() == steps + 1
    assert document.undo_stack.undoText() == "Copy keys"
    assert timeline.values.places == {("shape-1", "opacity", 1009)}


def test_copied_keys_are_pasted_with_the_first_one_on_the_playhead(
    qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState, act: dict[str, Callable[[], object]]
) -> None:
    timeline.value_rows.verbs.select_all()
    act[COPY]()
    assert "Copied 2 keys" in view_state.message
    view_state.set_frame(CLIP.last - 5)
    act[PASTE]()
    assert fades(document.project) == {1005: 0.2, 1015: 0.8, CLIP.last - 5: 0.2}  # the other one lies beyond the clip
    assert timeline.values.places == {("shape-1", "opacity", CLIP.last - 5)}
    softens = Animated((ValueKey(1002, 0.0), ValueKey(1040, 9.0)))
    document.apply("Soften", edit.set_properties(document.project, "shape-2", feather=softens))
    view_state.select(frozenset({"shape-2"}))
    view_state.set_frame(1001)
    timeline.value_rows.setFocus()
    qtbot.waitUntil(timeline.value_rows.hasFocus, timeout=WAIT)
    act[PASTE]()  # into the one that is selected, whose opacity never varied
    assert fades(document.project, "shape-2") == {1001: 0.2, 1011: 0.8}
    assert document.undo_stack.undoText() == "Paste keys"


def test_copied_keys_are_pasted_into_a_shape_that_never_varied(
    qtbot: QtBot,
    timeline: Timeline,
    document: Document,
    view_state: ViewState,
    act: dict[str, Callable[[], object]],
    elsewhere: Elsewhere,
) -> None:
    """It has no row that could have the keyboard: a click on its name gives it to the rows of outlines."""
    timeline.value_rows.verbs.select_all()
    act[COPY]()
    timeline.rows.setFocus()
    qtbot.waitUntil(timeline.rows.hasFocus, timeout=WAIT)
    view_state.select(frozenset({"shape-2"}))
    view_state.set_frame(1001)
    act[PASTE]()
    assert fades(document.project, "shape-2") == {1001: 0.2, 1011: 0.8}
    timeline.keys.select(frozenset({("shape-2", 1010)}))
    act[COPY]()  # what was copied last is pasted
    view_state.set_frame(1020)
    act[PASTE]()
    assert document.project.shape("shape-2").artist_frames == (1010, 1020, 1030)
    assert fades(document.project, "shape-2") == {1001: 0.2, 1011: 0.8}
    act["key.copy"]()
    act[PASTE]()
    assert elsewhere.called == ["key.copy", PASTE]


def test_cut_takes_keys_and_never_the_shape(
    timeline: Timeline,
    document: Document,
    view_state: ViewState,
    act: dict[str, Callable[[], object]],
    elsewhere: Elsewhere,
) -> None:
    view_state.select(frozenset({"shape-1"}))
    timeline.values.select(frozenset({("shape-1", "opacity", 1015)}))
    act[CUT]()
    assert elsewhere.called == []
    assert fades(document.project) == {1005: 0.2}
    assert document.undo_stack.undoText() == "Cut keys"
    view_state.set_frame(1020)
    act[PASTE]()
    found = document.project.shape("shape-1").opacity
    assert isinstance(found, Animated)
    assert found.key_at(1020) == ValueKey(1020, 0.8, Interpolation.HOLD)
    document.open(edit.set_properties(document.project, "shape-1", locked=True), None)
    timeline.value_rows.setFocus()
    act[PASTE]()  # what was copied went with its project
    assert elsewhere.called == [PASTE]


def test_where_no_key_is_chosen_copy_means_what_it_means_elsewhere(
    timeline: Timeline, act: dict[str, Callable[[], object]], elsewhere: Elsewhere
) -> None:
    timeline.values.select(frozenset({("shape-1", "opacity", 1005)}))
    act[COPY]()
    timeline.values.clear()
    act[COPY]()
    act[PASTE]()
    assert elsewhere.called == [COPY, PASTE]


def test_keys_of_a_locked_shape_take_none(
    timeline: Timeline, document: Document, view_state: ViewState, act: dict[str, Callable[[], object]]
) -> None:
    timeline.values.select(frozenset({("shape-1", "opacity", 1005)}))
    act[COPY]()
    document.apply("Lock", edit.set_properties(document.project, "shape-1", locked=True))
    before = document.project
    act[PASTE]()
    assert document.project is before
    assert "fit nothing here" in view_state.message


def test_keys_of_an_outline_are_copied_by_its_curve(
    timeline: Timeline, document: Document, view_state: ViewState, keyed: None
) -> None:
    verbs = timeline.curves.plot.verbs
    timeline.values.select(frozenset({("shape-1", "x", 1001)}))
    verbs.copy()
    view_state.set_frame(1025)
    verbs.paste()
    assert document.project.shape("shape-1").artist_frames == (1001, 1025, 1030)
    assert timeline.values.places == {("shape-1", "x", 1025)}  # chosen, to be moved on


def test_keys_of_position_are_not_pasted_into_a_layer(
    timeline: Timeline, document: Document, view_state: ViewState, keyed: None
) -> None:
    project, layer = edit.add_layer(document.project)
    document.apply("Layer", project)
    frame = document.project.shape("shape-1").artist_frames[0]
    timeline.values.select(frozenset({("shape-1", "x", frame)}))
    timeline.value_rows.verbs.copy()
    view_state.select(frozenset(), layers=frozenset({layer.id}))
    before = document.project
    timeline.value_rows.verbs.paste()
    assert document.project is before
    assert view_state.message == FITS_NOTHING


def test_values_of_one_shape_are_pasted_into_all_that_are_selected(
    timeline: Timeline, document: Document, view_state: ViewState, keyed: None
) -> None:
    project, third = edit.new_shape(document.project, document.project.shape("shape-1").at(1001).points, 1001)
    document.apply("Third", project)
    timeline.value_rows.verbs.select_all()
    timeline.value_rows.verbs.copy()
    view_state.select(frozenset({"shape-2", third.id}))
    view_state.set_frame(1001)
    timeline.value_rows.verbs.paste()
    assert fades(document.project) == {1005: 0.2, 1015: 0.8}
    for shape_id in ("shape-2", third.id):
        assert fades(document.project, shape_id) == {1001: 0.2, 1011: 0.8}


def test_values_are_pasted_into_their_own_shape_and_those_that_are_selected_with_it(
    timeline: Timeline, document: Document, view_state: ViewState, keyed: None
) -> None:
    """They went into their own alone, without a word."""
    timeline.value_rows.verbs.select_all()
    timeline.value_rows.verbs.copy()
    view_state.select(frozenset({"shape-1", "shape-2"}))
    view_state.set_frame(1025)
    timeline.value_rows.verbs.paste()
    assert fades(document.project) == {1005: 0.2, 1015: 0.8, 1025: 0.2, 1035: 0.8}
    assert fades(document.project, "shape-2") == {1025: 0.2, 1035: 0.8}


def test_values_of_a_shape_stay_its_own_where_its_layer_is_selected(
    timeline: Timeline, document: Document, view_state: ViewState, keyed: None
) -> None:
    """A click on the layer shows the rows of its shapes: what was copied from one of them made the whole layer fade."""
    project, layer = grouped(document.project, {"shape-1"})
    document.apply("Group", project)
    timeline.value_rows.verbs.select_all()
    timeline.value_rows.verbs.copy()
    view_state.select(frozenset({"shape-1"}), layers=frozenset({layer.id}))
    view_state.set_frame(1025)
    timeline.value_rows.verbs.paste()
    assert document.project.find(layer.id).opacity == 1.0
    assert fades(document.project) == {1005: 0.2, 1015: 0.8, 1025: 0.2, 1035: 0.8}


def test_of_several_shapes_that_take_values_the_locked_one_is_told(
    timeline: Timeline, document: Document, view_state: ViewState, keyed: None
) -> None:
    """It was passed over in silence."""
    timeline.value_rows.verbs.select_all()
    timeline.value_rows.verbs.copy()
    project, third = edit.new_shape(document.project, document.project.shape("shape-1").at(1001).points, 1001)
    document.apply("Third", edit.set_properties(project, third.id, locked=True))
    view_state.select(frozenset({"shape-2", third.id}))
    view_state.set_frame(1001)
    timeline.value_rows.verbs.paste()
    assert fades(document.project, "shape-2") == {1001: 0.2, 1011: 0.8}
    assert document.project.shape(third.id).opacity == 1.0
    assert view_state.message.startswith(f"The copied keys do not fit {third.name}: locked")
