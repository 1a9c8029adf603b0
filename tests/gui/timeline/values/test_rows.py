"""The rows of values: there while something varies; keys clicked, dragged, deleted, bent."""

from __future__ import annotations

from dataclasses import replace

import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent, QPainter
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.model.document import Document
from app.model.view_state import ViewState
from app.timeline.keys.row_painter import ROW
from app.timeline.timeline import Timeline
from app.timeline.values.rows import MOST
from roam_core.roto import Animated, Interpolation, Layer, RotoShape, ValueKey, edit
from tests.gui.timeline.places import SQUARE, place, x_of
from tests.gui.waiting import WAIT

LEFT = Qt.MouseButton.LeftButton
NONE, SHIFT = Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ShiftModifier
FADES = Animated((ValueKey(1005, 0.2), ValueKey(1015, 0.8), ValueKey(1025, 0.5, Interpolation.HOLD)))
SOFTENS = Animated((ValueKey(1002, 0.0), ValueKey(1040, 9.0)))


@pytest.fixture
def keyed(qtbot: QtBot, timeline: Timeline, document: Document) -> RotoShape:
    """The lower shape with an opacity and a feather that vary."""
    shape = replace(document.project.shape("shape-1"), opacity=FADES, feather=SOFTENS)
    document.apply("Fade", document.project.with_shape(shape))
    qtbot.waitUntil(timeline.value_rows.isVisible, timeout=WAIT)
    return shape


def value(document: Document, name: str = "opacity") -> Animated:
    found = getattr(document.project.shape("shape-1"), name)
    assert isinstance(found, Animated)
    return found


def send(timeline: Timeline, kind: QEvent.Type, at: QPoint, modifiers: Qt.KeyboardModifier = NONE) -> None:
    rows, moves = timeline.value_rows, kind == QEvent.Type.MouseMove
    held = Qt.MouseButton.NoButton if kind == QEvent.Type.MouseButtonRelease else LEFT
    where = QPointF(at), QPointF(rows.mapToGlobal(at))
    QApplication.sendEvent(rows, QMouseEvent(kind, *where, Qt.MouseButton.NoButton if moves else LEFT, held, modifiers))


def drag(timeline: Timeline, start: QPoint, end: QPoint) -> None:
    send(timeline, QEvent.Type.MouseButtonPress, start)
    for at in (start + (end - start) / 2, end):
        send(timeline, QEvent.Type.MouseMove, at)


def test_rows_come_and_go_with_what_varies(
    qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState, keyed: RotoShape
) -> None:
    assert [row.title for row in timeline.value_rows.rows()] == ["Shape 1: opacity", "Shape 1: feather"]
    assert timeline.value_rows.height() == 2 * ROW
    view_state.select(frozenset({"shape-2"}))
    assert not timeline.value_rows.isVisible()
    view_state.select(frozenset())
    qtbot.waitUntil(timeline.value_rows.isVisible, timeout=WAIT)
    document.undo_stack.undo()
    assert not timeline.value_rows.isVisible()


def test_a_layer_has_a_row_of_its_opacity(timeline: Timeline, document: Document, view_state: ViewState) -> None:
    root = document.project.root
    layer = Layer("layer-1", "Body", root.children[:1], opacity=FADES)
    document.apply("Layer", replace(document.project, root=replace(root, children=(layer, *root.children[1:]))))
    assert [row.title for row in timeline.value_rows.rows()] == ["Body: opacity"]
    send(timeline, QEvent.Type.MouseButtonPress, QPoint(30, 8))
    assert view_state.layers == {"layer-1"}
    assert view_state.selection.shapes == {"shape-1"}


def test_a_click_chooses_a_key_and_goes_there_and_one_beside_goes_to_the_frame(
    timeline: Timeline, view_state: ViewState, keyed: RotoShape
) -> None:
    for kind in (QEvent.Type.MouseButtonPress, QEvent.Type.MouseButtonRelease):
        send(timeline, kind, place(timeline, 1015, 0) + QPoint(3, 2))
    assert timeline.values.places == {("shape-1", "opacity", 1015)}
    assert view_state.frame == 1015
    for kind in (QEvent.Type.MouseButtonPress, QEvent.Type.MouseButtonRelease):
        send(timeline, kind, place(timeline, 1040, 1), SHIFT)
    assert timeline.values.places == {("shape-1", "opacity", 1015), ("shape-1", "feather", 1040)}
    send(timeline, QEvent.Type.MouseButtonPress, place(timeline, 1032, 1))
    assert view_state.frame == 1032
    assert not timeline.values.places


def test_a_dragged_key_is_previewed_and_one_undo_step(
    timeline: Timeline, document: Document, view_state: ViewState, keyed: RotoShape
) -> None:
    before, steps = document.project, document.undo_stack.count()
    drag(timeline, place(timeline, 1015, 0), place(timeline, 1019, 0))
    assert document.project is before
    assert timeline.value_rows.rows()[0].value.frames == (1005, 1019, 1025)
    send(timeline, QEvent.Type.MouseButtonRelease, place(timeline, 1019, 0))
    assert value(document).frames == (1005, 1019, 1025)
    assert value(document, "feather") == SOFTENS
    assert timeline.values.places == {("shape-1", "opacity", 1019)}
    assert document.undo_stack.count() == steps + 1
    assert view_state.preview is None


def test_no_key_is_dragged_out_of_the_clip_and_esc_leaves_all_as_it_was(
    qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState, keyed: RotoShape
) -> None:
    before = document.project
    drag(timeline, place(timeline, 1005, 0), QPoint(x_of(timeline, 1001) - 40, 8))
    assert timeline.value_rows.rows()[0].value.frames[0] == 1001
    qtbot.keyClick(timeline.value_rows, Qt.Key.Key_Escape)
    assert view_state.preview is None
    send(timeline, QEvent.Type.MouseButtonRelease, QPoint(x_of(timeline, 1001), 8))
    assert document.project is before


def test_keys_are_deleted_nudged_and_bent_by_keys_and_actions(
    qtbot: QtBot, timeline: Timeline, document: Document, keyed: RotoShape
) -> None:
    timeline.activateWindow()
    timeline.value_rows.setFocus()
    qtbot.waitUntil(timeline.value_rows.hasFocus, timeout=WAIT)
    timeline.values.select(frozenset({("shape-1", "opacity", 1015)}))
    qtbot.keyClick(timeline.value_rows, Qt.Key.Key_Right, Qt.KeyboardModifier.AltModifier)
    assert value(document).frames == (1005, 1016, 1025)
    actions = {action.objectName(): action for action in timeline.value_rows.menu.actions()}
    actions["key.tangents"].trigger()
    assert value(document).keys[1] == ValueKey(1016, 0.8, slopes=(0.0, 0.0))
    actions["key.smooth"].trigger()
    assert value(document).keys[1] == ValueKey(1016, 0.8, Interpolation.SMOOTH)
    qtbot.keyClick(timeline.value_rows, Qt.Key.Key_Delete)
    assert value(document).frames == (1005, 1025)
    assert not timeline.values.places


def test_choosing_keys_of_shapes_lets_go_of_keys_of_values(timeline: Timeline, keyed: RotoShape) -> None:
    timeline.values.select(frozenset({("shape-1", "opacity", 1015)}))
    timeline.keys.select(frozenset({("shape-1", 1001)}))
    assert not timeline.values.places
    timeline.values.select(frozenset({("shape-1", "opacity", 1015)}))
    assert not timeline.keys.places


def test_keys_of_what_is_locked_stay(
    timeline: Timeline, document: Document, view_state: ViewState, keyed: RotoShape
) -> None:
    document.apply("Lock", document.project.with_shape(replace(keyed, locked=True)))
    before = document.project
    drag(timeline, place(timeline, 1015, 0), place(timeline, 1019, 0))
    send(timeline, QEvent.Type.MouseButtonRelease, place(timeline, 1019, 0))
    assert document.project is before
    assert view_state.message == "It is locked; unlock it to change its keys."


def test_tips_tell_the_value(timeline: Timeline, keyed: RotoShape) -> None:
    tip = timeline.value_rows.tip_at
    assert tip(QPointF(place(timeline, 1010, 0))) == "Shape 1: opacity, frame 1010: 50 %"
    assert tip(QPointF(place(timeline, 1040, 1))) == "Shape 1: feather, frame 1040: 9 px, a key"
    assert tip(QPointF(20, 8)) == "Shape 1: opacity. Click to select"


def test_keys_whose_row_goes_are_chosen_no_more(
    timeline: Timeline, document: Document, view_state: ViewState, keyed: RotoShape
) -> None:
    timeline.values.select(frozenset({("shape-1", "opacity", 1005)}))
    view_state.select(frozenset({"shape-1"}), frozenset({("shape-1", 0)}))
    assert timeline.values.places
    view_state.select(frozenset({"shape-2"}))
    assert not timeline.values.places
    view_state.set_frame(1010)
    timeline.taking_over({})["key.hold"]()  # it means the shape that is selected now
    assert value(document).keys == FADES.keys
    key = document.project.shape("shape-2").key_at(1010)
    assert key is not None
    assert key.interpolation is Interpolation.HOLD


def test_a_long_name_is_shortened_and_what_varies_is_not(
    timeline: Timeline, document: Document, monkeypatch: pytest.MonkeyPatch
) -> None:
    long = edit.set_properties(document.project, "shape-1", name="Upper arm of the man at the far left")
    document.apply("Fade", edit.set_properties(long, "shape-1", opacity=FADES))
    told: list[str] = []
    monkeypatch.setattr(QPainter, "drawText", lambda _painter, *given: told.append(str(given[-1])))
    timeline.value_rows.grab()
    assert len(told) == 1
    assert told[0].startswith("Up")
    assert told[0].endswith(": opacity")


def test_every_value_that_varies_has_a_row_and_what_has_no_room_scrolls(
    qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    project = document.project
    for _ in range(2 * MOST):
        project, shape = edit.new_shape(project, SQUARE, 1001)
        project = project.with_shape(replace(shape, opacity=FADES))
    view_state.select(frozenset())
    document.apply("Fade", project)
    band, room = timeline.value_rows, timeline.band_rooms[1]
    assert len(band.rows()) == 2 * MOST
    assert len(band.places()) == 3 * 2 * MOST
    assert band.height() == 2 * MOST * ROW
    assert 2 * ROW <= room.maximumHeight() <= timeline.rows.height()
    timeline.resize(1100, 700)
    assert room.maximumHeight() == MOST * ROW
    timeline.resize(1100, 220)
    room.verticalScrollBar().setValue(room.verticalScrollBar().maximum())
    last = QPoint(round(x_of(timeline, 1015)), band.height() - ROW // 2)
    qtbot.waitUntil(lambda: band.visibleRegion().contains(last), timeout=WAIT)
    send(timeline, QEvent.Type.MouseButtonPress, last)
    send(timeline, QEvent.Type.MouseButtonRelease, last)
    assert timeline.values.places == {(band.rows()[-1].item.id, "opacity", 1015)}


def test_a_line_is_reckoned_once_and_no_finer_than_pixels(
    timeline: Timeline, document: Document, view_state: ViewState, keyed: RotoShape, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is painted with every frame that plays; a long clip has many more frames than the row has pixels."""
    looked: list[float] = []
    at = Animated.at

    def counted(self: Animated, frame: float) -> float:
        looked.append(frame)
        return at(self, frame)

    timeline.axis.set_clip((1001, 9001))
    timeline.axis.fit()
    monkeypatch.setattr(Animated, "at", counted)
    timeline.value_rows.grab()
    assert 500 < len(looked) <= 2 * timeline.axis.scale.width + 2
    looked.clear()
    view_state.set_frame(1009)
    timeline.value_rows.grab()
    assert looked == []
    document.apply("Shift", document.project.with_shape(replace(keyed, opacity=SOFTENS)))
    timeline.value_rows.grab()
    assert looked
