"""Keys under the hand: dragged, copied, boxed, deleted, interpolated; each gesture one undo step."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QContextMenuEvent, QHelpEvent, QMouseEvent
from PySide6.QtWidgets import QApplication, QMenu, QToolTip
from pytestqt.qtbot import QtBot

from app import style
from app.model.document import Document
from app.model.view_state import ViewState
from app.timeline.timeline import Timeline
from roam_core.params import CONFIGS, DEFAULT_CONFIG
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.roto import Interpolation, Keyframe, Origin, edit
from tests.gui.timeline.places import CLIP, SQUARE, place, row_middle, x_of
from tests.gui.waiting import WAIT

LEFT = Qt.MouseButton.LeftButton
NONE, SHIFT, CTRL, ALT = (
    Qt.KeyboardModifier.NoModifier,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.AltModifier,
)


def send(timeline: Timeline, kind: QEvent.Type, at: QPoint, modifiers: Qt.KeyboardModifier = NONE) -> None:
    port, moves = timeline.rows.viewport(), kind == QEvent.Type.MouseMove
    held = Qt.MouseButton.NoButton if kind == QEvent.Type.MouseButtonRelease else LEFT
    button = Qt.MouseButton.NoButton if moves else LEFT
    where = QPointF(at), QPointF(port.mapToGlobal(at))
    QApplication.sendEvent(port, QMouseEvent(kind, *where, button, held, modifiers))


def grab(timeline: Timeline, start: QPoint, end: QPoint, modifiers: Qt.KeyboardModifier = NONE) -> None:
    """Press and move, in two steps; the button stays down."""
    send(timeline, QEvent.Type.MouseButtonPress, start, modifiers & ~ALT)
    for at in (start + (end - start) / 2, end):
        send(timeline, QEvent.Type.MouseMove, at, modifiers)


def drag(timeline: Timeline, start: QPoint, end: QPoint, modifiers: Qt.KeyboardModifier = NONE) -> None:
    grab(timeline, start, end, modifiers)
    send(timeline, QEvent.Type.MouseButtonRelease, end, modifiers)


def take_keyboard(qtbot: QtBot, timeline: Timeline) -> None:
    timeline.activateWindow()
    timeline.rows.setFocus()
    qtbot.waitUntil(timeline.rows.hasFocus, timeout=WAIT)


def artist(document: Document, name: str) -> tuple[int, ...]:
    return document.project.shape(name).artist_frames


def ink(timeline: Timeline, frame: int, row: int) -> bool:
    """Whether a row shows an artist's key on a frame: something that stands out around its middle."""
    at, picture = place(timeline, frame, row), timeline.rows.viewport().grab().toImage()
    reach = range(-3, 4)
    return sum(picture.pixelColor(at + QPoint(x, y)).lightness() > 120 for x in reach for y in reach) > 20


def test_a_dragged_key_is_shown_where_it_is(timeline: Timeline, document: Document) -> None:
    def shown() -> list[bool]:
        return [ink(timeline, frame, 1) for frame in (1030, 1035)]

    assert shown() == [True, False]
    grab(timeline, place(timeline, 1030, 1), place(timeline, 1035, 1))
    assert shown() == [False, True]
    send(timeline, QEvent.Type.MouseButtonRelease, place(timeline, 1035, 1))
    assert shown() == [False, True]
    document.undo_stack.undo()
    assert shown() == [True, False]
    grab(timeline, place(timeline, 1030, 1), place(timeline, 1035, 1))
    timeline.rows.hand.cancel()
    assert shown() == [True, False]


def test_a_dragged_key_snaps_to_frames_and_is_one_undo_step(
    timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    before, frame = document.project, view_state.frame
    third = QPoint(round(timeline.axis.scale.pixels / 3), 0)
    grab(timeline, place(timeline, 1030, 1), place(timeline, 1035, 1) + third)
    assert document.project is before
    assert view_state.preview is not None
    assert view_state.preview.shape("shape-1").artist_frames == (1001, 1035)
    assert view_state.message == "Move 1 key 5 frames on: 1030 to 1035."
    send(timeline, QEvent.Type.MouseButtonRelease, place(timeline, 1035, 1) + third)
    assert artist(document, "shape-1") == (1001, 1035)
    assert artist(document, "shape-2") == (1010, 1030)
    assert view_state.preview is None
    assert view_state.frame == frame
    assert timeline.keys.places == {("shape-1", 1035)}
    assert document.undo_stack.count() == 1
    document.undo_stack.undo()
    assert document.project is before


def test_what_was_tracked_from_a_key_that_moved_is_stale(timeline: Timeline, document: Document) -> None:
    drag(timeline, place(timeline, 1010, 0), place(timeline, 1008, 0))
    shape = document.project.shape("shape-2")
    assert shape.artist_frames == (1008, 1030)
    stamps = Stamps.of(document.project.shapes, CLIP)
    assert all(stamps.is_stale(shape, key) for key in shape.keys if key.origin is Origin.ENGINE)


def test_a_key_that_is_clicked_and_dragged_at_once_moves(timeline: Timeline, document: Document) -> None:
    start, end = place(timeline, 1030, 1), place(timeline, 1035, 1)
    drag(timeline, start, start)
    send(timeline, QEvent.Type.MouseButtonDblClick, start)
    send(timeline, QEvent.Type.MouseMove, end)
    send(timeline, QEvent.Type.MouseButtonRelease, end)
    assert artist(document, "shape-1") == (1001, 1035)


def test_no_key_is_dragged_out_of_the_clip(timeline: Timeline, document: Document) -> None:
    drag(timeline, place(timeline, 1030, 1), QPoint(5000, row_middle(1)))
    assert artist(document, "shape-1") == (1001, 1048)


def test_a_drag_goes_on_out_of_sight(timeline: Timeline, document: Document) -> None:
    timeline.axis.set_scale(timeline.axis.scale.zoomed(4.0, x_of(timeline, 1001)))
    last = timeline.axis.scale.last
    assert last < 1025
    drag(timeline, place(timeline, 1001, 1), place(timeline, 1005, 1), ALT)  # a key in sight
    grab(timeline, place(timeline, 1005, 1), place(timeline, 1010, 1))
    outside = QPoint(round(timeline.axis.scale.right) + 60, row_middle(1))
    for _ in range(4):
        send(timeline, QEvent.Type.MouseMove, outside)
    send(timeline, QEvent.Type.MouseButtonRelease, outside)
    moved = artist(document, "shape-1")[1]
    assert moved > last
    assert moved == timeline.axis.scale.frame(outside.x())


def test_esc_leaves_keys_where_they_were(qtbot: QtBot, timeline: Timeline, document: Document) -> None:
    before = document.project
    take_keyboard(qtbot, timeline)
    grab(timeline, place(timeline, 1030, 1), place(timeline, 1040, 1))
    qtbot.keyClick(timeline.rows, Qt.Key.Key_Escape)
    send(timeline, QEvent.Type.MouseButtonRelease, place(timeline, 1040, 1))
    assert document.project is before
    assert timeline.axis.view_state.preview is None
    assert timeline.keys.places == frozenset()


def test_alt_drag_copies(timeline: Timeline, document: Document) -> None:
    drag(timeline, place(timeline, 1030, 1), place(timeline, 1040, 1), ALT)
    assert artist(document, "shape-1") == (1001, 1030, 1040)
    assert document.undo_stack.undoText() == "Copy keys"


def test_a_box_chooses_keys_of_several_rows_and_they_move_together(timeline: Timeline, document: Document) -> None:
    drag(timeline, place(timeline, 1025, 0) - QPoint(0, 8), place(timeline, 1032, 1))
    assert timeline.keys.places == {("shape-1", 1030), ("shape-2", 1030)}
    drag(timeline, place(timeline, 1030, 0), place(timeline, 1028, 0))
    assert artist(document, "shape-1") == (1001, 1028)
    assert artist(document, "shape-2") == (1010, 1028)
    assert document.undo_stack.count() == 1


def test_shift_adds_to_what_is_chosen_and_ctrl_takes_away(timeline: Timeline) -> None:
    drag(timeline, place(timeline, 1025, 0) - QPoint(0, 8), place(timeline, 1032, 1))
    drag(timeline, place(timeline, 1003, 1), place(timeline, 1000, 1), SHIFT)
    assert timeline.keys.places == {("shape-1", 1001), ("shape-1", 1030), ("shape-2", 1030)}
    drag(timeline, place(timeline, 1025, 1), place(timeline, 1032, 1), CTRL)
    assert timeline.keys.places == {("shape-1", 1001), ("shape-2", 1030)}
    drag(timeline, place(timeline, 1030, 0), place(timeline, 1030, 0), CTRL)
    assert timeline.keys.places == {("shape-1", 1001)}


def test_a_drag_beside_the_keys_does_not_scrub(timeline: Timeline, view_state: ViewState) -> None:
    frame = view_state.frame
    drag(timeline, place(timeline, 1033, 0), place(timeline, 1045, 0))
    assert view_state.frame == frame


def test_keys_of_a_locked_shape_stay(timeline: Timeline, document: Document, view_state: ViewState) -> None:
    document.apply("Lock", edit.set_properties(document.project, "shape-1", locked=True))
    drag(timeline, place(timeline, 1030, 1), place(timeline, 1040, 1))
    assert artist(document, "shape-1") == (1001, 1030)
    assert view_state.message == "The shape is locked; unlock it to move its keys."


def test_nothing_is_pasted_into_a_locked_shape(timeline: Timeline, document: Document, view_state: ViewState) -> None:
    timeline.keys.select(frozenset({("shape-1", 1030)}))
    timeline.verbs.copy()
    document.apply("Lock", edit.set_properties(document.project, "shape-1", locked=True))
    locked = document.project
    view_state.set_frame(1015)
    timeline.verbs.paste()
    assert document.project is locked
    assert "shapes may be locked" in view_state.message


def test_copy_and_paste_put_keys_on_the_playheads_frame(
    qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    moved = edit.set_key(document.project.shape("shape-1"), 1030, SQUARE + 4)
    document.apply("Move", document.project.with_shape(moved))
    take_keyboard(qtbot, timeline)
    drag(timeline, place(timeline, 1035, 1), place(timeline, 1000, 1))
    qtbot.keyClick(timeline.rows, Qt.Key.Key_C, CTRL)
    view_state.set_frame(1015)
    qtbot.keyClick(timeline.rows, Qt.Key.Key_V, CTRL)
    assert artist(document, "shape-1") == (1001, 1015, 1030, 1044)
    assert np.array_equal(document.project.shape("shape-1").at(1044).points, SQUARE + 4)
    assert timeline.keys.places == {("shape-1", 1015), ("shape-1", 1044)}
    assert document.undo_stack.undoText() == "Paste keys"


def test_keys_of_one_shape_are_pasted_into_the_selected_one(
    qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    take_keyboard(qtbot, timeline)
    drag(timeline, place(timeline, 1003, 1), place(timeline, 1000, 1))
    qtbot.keyClick(timeline.rows, Qt.Key.Key_C, CTRL)
    view_state.select(frozenset({"shape-2"}))
    view_state.set_frame(1040)
    qtbot.keyClick(timeline.rows, Qt.Key.Key_V, CTRL)
    assert artist(document, "shape-1") == (1001, 1030)
    assert artist(document, "shape-2") == (1010, 1030, 1040)


def test_keys_of_one_shape_are_pasted_into_all_that_are_selected(
    timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    """They went back to their own shape, which was not selected."""
    project, third = edit.new_shape(document.project, document.project.shape("shape-1").at(1001).points, 1001)
    document.apply("Third", project)
    timeline.keys.select(frozenset({("shape-1", 1001)}))
    timeline.verbs.copy()
    view_state.select(frozenset({"shape-2", third.id}))
    view_state.set_frame(1040)
    timeline.verbs.paste()
    assert artist(document, "shape-1") == (1001, 1030)
    assert artist(document, "shape-2") == (1010, 1030, 1040)
    assert artist(document, third.id) == (1001, 1040)


def test_keys_are_pasted_into_their_own_shape_and_those_that_are_selected_with_it(
    timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    """They went into their own alone, without a word."""
    timeline.keys.select(frozenset({("shape-1", 1001)}))
    timeline.verbs.copy()
    view_state.select(frozenset({"shape-1", "shape-2"}))
    view_state.set_frame(1040)
    timeline.verbs.paste()
    assert artist(document, "shape-1") == (1001, 1030, 1040)
    assert artist(document, "shape-2") == (1010, 1030, 1040)
    assert timeline.keys.places == {("shape-1", 1040), ("shape-2", 1040)}


def test_keys_of_several_shapes_are_pasted_into_as_many_others_in_their_order(
    timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    """They went back to their own shapes, which were not selected."""
    project, ids = document.project, []
    for name in ("Third", "Fourth"):
        points = project.shape("shape-1").at(1001).points
        project, made = edit.new_shape(project, points, 1001, name=name)
        ids.append(made.id)
    document.apply("More", project)
    first, second = project.shape("shape-1").at(1030).points, project.shape("shape-2").at(1010).points
    timeline.keys.select(frozenset({("shape-2", 1010), ("shape-1", 1030)}))
    timeline.verbs.copy()
    view_state.select(frozenset(ids))
    view_state.set_frame(1020)
    timeline.verbs.paste()
    assert (artist(document, "shape-1"), artist(document, "shape-2")) == ((1001, 1030), (1010, 1030))
    assert (artist(document, ids[0]), artist(document, ids[1])) == ((1001, 1040), (1001, 1020))
    np.testing.assert_array_equal(document.project.shape(ids[0]).at(1040).points, first)
    np.testing.assert_array_equal(document.project.shape(ids[1]).at(1020).points, second)
    assert view_state.message == "Pasted into the selected shapes, in their order: Third, Fourth."
    view_state.select(frozenset({ids[0]}))  # one for two: they go back to their own
    view_state.set_frame(1012)
    timeline.verbs.paste()
    assert (artist(document, "shape-1"), artist(document, "shape-2")) == ((1001, 1030, 1032), (1010, 1012, 1030))


@pytest.mark.parametrize("verb", ["delete", "nudge", "hold"])
def test_of_chosen_keys_those_of_a_locked_shape_stay_and_that_is_said(
    timeline: Timeline, document: Document, view_state: ViewState, verb: str
) -> None:
    document.apply("Lock", edit.set_properties(document.project, "shape-1", locked=True))
    timeline.keys.select(frozenset({("shape-1", 1030), ("shape-2", 1030)}))
    before = document.project.shape("shape-1")
    verbs = timeline.verbs
    {"delete": verbs.delete, "nudge": lambda: verbs.nudge(2), "hold": verbs.handlers()["key.hold"]}[verb]()
    assert document.project.shape("shape-1") == before
    assert document.undo_stack.undoText() in ("Delete keys", "Move keys", "Hold")
    assert view_state.message == "What is locked stays; unlock it first (Ctrl+L)."


def test_what_the_pasted_keys_do_not_fit_is_named(
    timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    project, third = edit.new_shape(document.project, document.project.shape("shape-1").at(1001).points[:3], 1001)
    document.apply("Third", project)
    timeline.keys.select(frozenset({("shape-1", 1001)}))
    timeline.verbs.copy()
    view_state.select(frozenset({"shape-2", third.id}))
    view_state.set_frame(1040)
    timeline.verbs.paste()
    assert artist(document, "shape-2") == (1010, 1030, 1040)
    assert view_state.message.startswith("The copied keys do not fit Shape 3: ")


def test_del_and_ctrl_x_delete_the_chosen_keys_but_not_the_last_one(
    qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    take_keyboard(qtbot, timeline)
    drag(timeline, place(timeline, 1025, 0) - QPoint(0, 8), place(timeline, 1032, 1))
    qtbot.keyClick(timeline.rows, Qt.Key.Key_Delete)
    assert artist(document, "shape-1") == (1001,)
    assert artist(document, "shape-2") == (1010,)
    assert document.undo_stack.count() == 1
    for shape in document.project.shapes:
        document.apply("Clear", document.project.with_shape(edit.delete_engine_keys(shape)))
    steps = document.undo_stack.count()
    drag(timeline, place(timeline, 1003, 1), place(timeline, 1000, 1))
    qtbot.keyClick(timeline.rows, Qt.Key.Key_X, CTRL)
    assert artist(document, "shape-1") == (1001,)
    assert document.undo_stack.count() == steps
    assert "at least one key" in view_state.message


def test_a_shape_that_would_have_no_key_left_keeps_no_other_from_losing_theirs(
    timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    for shape in document.project.shapes:
        document.apply("Clear", document.project.with_shape(edit.delete_engine_keys(shape)))
    kept = artist(document, "shape-1")
    timeline.keys.select(frozenset({("shape-2", 1030), *(("shape-1", frame) for frame in kept)}))
    timeline.verbs.delete()
    assert (artist(document, "shape-1"), artist(document, "shape-2")) == (kept, (1010,))
    assert "at least one key" in view_state.message


def test_alt_with_arrows_moves_the_chosen_keys_inside_the_clip(
    qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    take_keyboard(qtbot, timeline)
    drag(timeline, place(timeline, 1025, 1), place(timeline, 1032, 1))
    for key, modifiers in ((Qt.Key.Key_Left, ALT), (Qt.Key.Key_Right, ALT | SHIFT), (Qt.Key.Key_Right, ALT | SHIFT)):
        qtbot.keyClick(timeline.rows, key, modifiers)
    assert artist(document, "shape-1") == (1001, 1048)
    assert timeline.keys.places == {("shape-1", 1048)}
    assert document.undo_stack.count() == 3
    timeline.keys.clear()
    qtbot.keyClick(timeline.rows, Qt.Key.Key_Left, ALT)
    assert view_state.message.startswith("Choose keys in the timeline first")


def test_ctrl_a_chooses_the_keys_of_the_selected_shapes(
    qtbot: QtBot, timeline: Timeline, view_state: ViewState
) -> None:
    take_keyboard(qtbot, timeline)
    view_state.select(frozenset({"shape-2"}))
    qtbot.keyClick(timeline.rows, Qt.Key.Key_A, CTRL)
    assert timeline.keys.places == {("shape-2", 1010), ("shape-2", 1030)}


def test_copying_means_what_it_meant_elsewhere_without_the_keyboard_or_without_keys(
    qtbot: QtBot, timeline: Timeline, document: Document
) -> None:
    asked: list[str] = []
    names = ("edit.copy", "edit.paste", "points.delete")
    handlers = timeline.verbs.taking_over({name: lambda name=name: asked.append(name) for name in names})
    take_keyboard(qtbot, timeline)
    for name in names:
        handlers[name]()
    assert asked == ["edit.copy", "edit.paste"]  # a shape is not deleted by the way
    drag(timeline, place(timeline, 1025, 0) - QPoint(0, 8), place(timeline, 1032, 1))
    handlers["edit.copy"]()
    handlers["edit.paste"]()
    assert asked == ["edit.copy", "edit.paste"]
    timeline.rows.clearFocus()
    for name in names:
        handlers[name]()
    assert asked[2:] == list(names)
    take_keyboard(qtbot, timeline)
    handlers["edit.paste"]()
    assert asked[5:] == ["edit.paste"]  # the shapes were copied last


def test_the_key_of_a_frame_that_was_copied_last_is_what_is_pasted(qtbot: QtBot, timeline: Timeline) -> None:
    asked: list[str] = []
    names = ("edit.copy", "edit.paste", "key.copy")
    handlers = timeline.verbs.taking_over({name: lambda name=name: asked.append(name) for name in names})
    take_keyboard(qtbot, timeline)
    drag(timeline, place(timeline, 1025, 0) - QPoint(0, 8), place(timeline, 1032, 1))
    for name in ("edit.copy", "key.copy", "edit.paste"):
        handlers[name]()
    assert asked == ["key.copy", "edit.paste"]


def test_keys_that_were_copied_are_forgotten_with_their_project(
    qtbot: QtBot, timeline: Timeline, document: Document
) -> None:
    """Another project has shapes of its own, of the same ids."""
    asked: list[str] = []
    handlers = timeline.verbs.taking_over({name: lambda name=name: asked.append(name) for name in ("edit.paste",)})
    take_keyboard(qtbot, timeline)
    drag(timeline, place(timeline, 1025, 0) - QPoint(0, 8), place(timeline, 1032, 1))
    handlers["edit.copy"]()
    document.open(document.project, None)
    before = document.project
    handlers["edit.paste"]()
    assert (asked, document.project) == (["edit.paste"], before)


def test_the_menu_sets_how_the_shape_moves_on_and_the_mark_tells(
    timeline: Timeline, document: Document, monkeypatch: pytest.MonkeyPatch
) -> None:
    port, at = timeline.rows.viewport(), place(timeline, 1001, 1)
    event = QContextMenuEvent(QContextMenuEvent.Reason.Mouse, at, port.mapToGlobal(at))
    shown: list[QPoint] = []
    monkeypatch.setattr(QMenu, "popup", lambda _menu, where: shown.append(where))
    QApplication.sendEvent(port, event)
    assert shown == [port.mapToGlobal(at)]
    assert timeline.keys.places == {("shape-1", 1001)}
    pictures = set()
    for title, mode in (
        ("Smooth", Interpolation.SMOOTH),
        ("Hold", Interpolation.HOLD),
        ("Linear", Interpolation.LINEAR),
    ):
        next(action for action in timeline.rows.menu.actions() if action.text() == title).trigger()
        key = document.project.shape("shape-1").key_at(1001)
        assert key is not None
        assert key.interpolation is mode
        picture = port.grab().toImage().copy(at.x() - 7, at.y() - 8, 15, 16)
        pictures.add(bytes(picture.constBits()))
    assert len(pictures) == 3


def test_without_chosen_keys_the_one_before_the_playhead_is_meant(
    timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    view_state.select(frozenset({"shape-2"}))
    view_state.set_frame(1025)
    timeline.verbs.interpolate(Interpolation.HOLD)
    held = [key.frame for key in document.project.shape("shape-2").keys if key.interpolation is Interpolation.HOLD]
    assert held == [1010]


def test_before_the_first_key_of_a_selected_shape_that_is_said(
    timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    """And not that a shape has to be selected."""
    view_state.select(frozenset({"shape-2"}))
    view_state.set_frame(1009)
    timeline.verbs.interpolate(Interpolation.HOLD)
    assert view_state.message == "There is no key before this frame."


def test_what_is_selected_in_the_viewer_is_meant_and_not_a_key_of_another_shape(
    timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    timeline.rows.clearFocus()
    timeline.keys.select(frozenset({("shape-1", 1001)}))
    view_state.select(frozenset({"shape-2"}))
    view_state.set_frame(1030)
    timeline.verbs.interpolate(Interpolation.HOLD)
    assert all(key.interpolation is Interpolation.LINEAR for key in document.project.shape("shape-1").keys)
    assert document.project.shape("shape-2").artist_keys[-1].interpolation is Interpolation.HOLD


@pytest.mark.parametrize(
    ("frame", "tip"),
    [
        (1001, "Shape 1, frame 1001\nKey by hand; the shape moves on evenly"),
        (1005, f"Shape 1, frame 1005\nTracked forward ({DEFAULT_CONFIG}); confidence 0.20: worth a look"),
        (1012, f"Shape 1, frame 1012\nTracked forward ({DEFAULT_CONFIG}); confidence 0.00: out of sight"),
        (1022, "Shape 1, frame 1022\nNo key: the shape is between frames 1019 and 1030"),
        (1024, "Shape 1, frame 1024\nFilled between two keys (best); confidence 0.90"),
        (1040, "Shape 1, frame 1040\nNo key: the shape stands as on frame 1030"),
    ],
)
def test_a_tip_tells_frame_maker_and_confidence(
    timeline: Timeline, document: Document, monkeypatch: pytest.MonkeyPatch, frame: int, tip: str
) -> None:
    if frame == 1024:
        shape = document.project.shape("shape-1")
        shapes = document.project.shapes
        inputs = Stamps.of(shapes, CLIP).filled(shapes.index(shape), (1001, 1030), CONFIGS["best"])
        filled = Keyframe(1024, SQUARE, origin=Origin.ENGINE, confidence=0.9, inputs=inputs)
        document.apply("Fill", document.project.with_shape(edit.set_engine_keys(shape, [filled])))
    if frame == 1012:
        shape = document.project.shape("shape-1")
        tracked = shape.key_at(frame)
        assert tracked is not None
        shut = replace(tracked, points=1e-4 * SQUARE, confidence=0.0)
        document.apply("Track", document.project.with_shape(edit.set_engine_keys(shape, [shut])))
    told: list[str] = []
    monkeypatch.setattr(QToolTip, "showText", lambda _at, text, _widget: told.append(text))
    port, at = timeline.rows.viewport(), place(timeline, frame, 1)
    QApplication.sendEvent(port, QHelpEvent(QEvent.Type.ToolTip, at, port.mapToGlobal(at)))
    assert told == [tip]


def test_stale_frames_and_gaps_look_like_neither_tracked_nor_doubtful_ones(
    timeline: Timeline, document: Document
) -> None:
    """By form: a gap is dotted, a stale frame is hollow, a doubtful one has a notch under it."""
    port, middle = timeline.rows.viewport(), row_middle(1)

    def column(frame: int) -> list[str]:
        picture = port.grab().toImage()
        return [picture.pixelColor(x_of(timeline, frame), middle + dy).name() for dy in range(-5, 10)]

    doubtful, gap = column(1005), column(1025)
    document.apply(
        "Move", document.project.with_shape(edit.set_key(document.project.shape("shape-1"), 1001, SQUARE + 1))
    )
    stale = column(1005)
    assert doubtful != stale
    assert stale[5] == style.PANEL  # hollow
    assert doubtful[5] != style.PANEL
    assert doubtful[-2] != stale[-2]  # the notch
    assert gap[:4] == gap[-5:-1] == [gap[0]] * 4  # nothing but dots in the middle


def test_the_pointer_tells_what_a_press_would_do(timeline: Timeline) -> None:
    port = timeline.rows.viewport()
    for frame, shape in ((1030, Qt.CursorShape.SizeHorCursor), (1040, Qt.CursorShape.ArrowCursor)):
        at = QPointF(place(timeline, frame, 1))
        moved = QMouseEvent(QEvent.Type.MouseMove, at, at, Qt.MouseButton.NoButton, Qt.MouseButton.NoButton, NONE)
        QApplication.sendEvent(port, moved)
        assert port.cursor().shape() is shape


def test_a_key_of_some_points_is_hollow_and_says_so(timeline: Timeline, document: Document) -> None:
    def ink() -> str:
        image = timeline.rows.viewport().grab().toImage()
        spot, ratio = place(timeline, 1025, 1), image.devicePixelRatio()
        return str(image.pixelColor(round(spot.x() * ratio), round(spot.y() * ratio)).name())

    shape = document.project.shape("shape-1")
    document.apply("Key", document.project.with_shape(edit.key_here(shape, 1025)))
    whole = ink()
    document.apply("Points", document.project.with_shape(edit.key_points(shape, 1025, [0, 2])))
    assert ink() != whole
    assert "Key by hand of 2 of 4 points" in timeline.rows.tip_at(QPointF(place(timeline, 1025, 1)))


def test_a_box_goes_on_over_the_rows_out_of_sight(qtbot: QtBot, timeline: Timeline, document: Document) -> None:
    """It ended with those in sight."""
    project = document.project
    for _ in range(60):
        project, _ = edit.new_shape(project, SQUARE, 1001)
    document.apply("Draw", project)
    timeline.resize(timeline.width(), 260)
    QApplication.processEvents()
    rows, top = timeline.rows, timeline.rows.rows()
    assert rows.verticalScrollBar().maximum() > rows.viewport().height()
    below = QPoint(x_of(timeline, 1005), rows.viewport().height() + 30)
    send(timeline, QEvent.Type.MouseButtonPress, QPoint(x_of(timeline, 1005), row_middle(0)))
    send(timeline, QEvent.Type.MouseMove, below - QPoint(20, 0))
    send(timeline, QEvent.Type.MouseMove, QPoint(x_of(timeline, 1000), below.y()))
    qtbot.waitUntil(lambda: rows.verticalScrollBar().value() == rows.verticalScrollBar().maximum(), timeout=WAIT)
    send(timeline, QEvent.Type.MouseButtonRelease, QPoint(x_of(timeline, 1000), below.y()))
    assert timeline.keys.places == {(shape.id, 1001) for shape in top if 1001 in shape.artist_frames}
    assert len(timeline.keys.places) > 60
