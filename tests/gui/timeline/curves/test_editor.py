"""The curve editor: what it shows, keys and tangents under the hand, each gesture one undo step."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.model.document import Document
from app.model.view_state import ViewState
from app.timeline.curves.lines import MOST, ticks
from app.timeline.curves.plot import CurvePlot
from app.timeline.timeline import Timeline
from app.timeline.values.shown import Kind
from roam_core.geometry.bezier import ANCHOR
from roam_core.roto import Animated, Interpolation, RotoShape, ValueKey, edit
from roam_core.roto.animated import has_tangents
from tests.gui.timeline.places import SQUARE
from tests.gui.waiting import WAIT

LEFT = Qt.MouseButton.LeftButton
NONE, SHIFT, CTRL, ALT = (
    Qt.KeyboardModifier.NoModifier,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.AltModifier,
)
FADES = Animated((ValueKey(1005, 0.2), ValueKey(1020, 0.8, slopes=(0.0, 0.0)), ValueKey(1035, 0.5)))
OPACITY = ("shape-1", "opacity")


@pytest.fixture
def plot(qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState) -> CurvePlot:
    """The editor over a shape whose opacity has a tangent on its middle key."""
    shape = replace(document.project.shape("shape-1"), opacity=FADES)
    document.apply("Fade", document.project.with_shape(shape))
    view_state.select(frozenset({"shape-1"}))
    timeline.resize(1100, 420)
    timeline.activateWindow()
    timeline.confidence.hide()
    timeline.curve_panel.show()
    timeline.curves.plot.setFocus()
    qtbot.waitUntil(timeline.curves.plot.hasFocus, timeout=WAIT)
    plot: CurvePlot = timeline.curves.plot
    return plot


def value(document: Document, name: str = "opacity") -> Animated:
    found = getattr(document.project.shape("shape-1"), name)
    assert isinstance(found, Animated)
    return found


def send(plot: CurvePlot, kind: QEvent.Type, at: QPointF, modifiers: Qt.KeyboardModifier = NONE) -> None:
    port, moves = plot.viewport(), kind == QEvent.Type.MouseMove
    held = Qt.MouseButton.NoButton if kind == QEvent.Type.MouseButtonRelease else LEFT
    button = Qt.MouseButton.NoButton if moves else LEFT
    where = at, QPointF(port.mapToGlobal(at))
    QApplication.sendEvent(port, QMouseEvent(kind, *where, button, held, modifiers))


def grab(plot: CurvePlot, start: QPointF, end: QPointF, modifiers: Qt.KeyboardModifier = NONE) -> None:
    send(plot, QEvent.Type.MouseButtonPress, start)
    for at in (start + (end - start) / 2, end):
        send(plot, QEvent.Type.MouseMove, at, modifiers)


def drag(plot: CurvePlot, start: QPointF, end: QPointF, modifiers: Qt.KeyboardModifier = NONE) -> None:
    grab(plot, start, end, modifiers)
    send(plot, QEvent.Type.MouseButtonRelease, end, modifiers)


def turn_wheel(plot: CurvePlot, at: QPointF, turn: int) -> None:
    where, none = (at, QPointF(plot.mapToGlobal(at))), Qt.MouseButton.NoButton
    event = QWheelEvent(*where, QPoint(), QPoint(0, turn), none, CTRL, Qt.ScrollPhase.NoScrollPhase, False)
    QApplication.sendEvent(plot.viewport(), event)


def click(plot: CurvePlot, at: QPointF, modifiers: Qt.KeyboardModifier = NONE) -> None:
    send(plot, QEvent.Type.MouseButtonPress, at, modifiers)
    send(plot, QEvent.Type.MouseButtonRelease, at, modifiers)


# ---- what is shown ---------------------------------------------------------------------------------------------------


def test_the_curve_is_the_value_in_percent(plot: CurvePlot) -> None:
    (line,) = plot.lines
    assert line.title == "Shape 1"
    for frame, seen in zip(line.frames, line.values, strict=True):
        assert seen == pytest.approx(100.0 * FADES.at(frame))
    assert [(key.frame, round(key.value), key.form) for key in line.keys] == [
        (1005, 20, "linear"), (1020, 80, "tangents"), (1035, 50, "linear"),
    ]  # fmt: skip


def test_positions_are_those_of_the_selected_points_or_of_all(
    timeline: Timeline, plot: CurvePlot, document: Document, view_state: ViewState
) -> None:
    timeline.curves.show_kind(Kind.X)
    anchors = document.project.shape("shape-1").at(1010).points[:, ANCHOR]
    at = int(np.flatnonzero(plot.lines[0].frames == 1010)[0])
    assert plot.lines[0].values[at] == pytest.approx(anchors[:, 0].mean())
    view_state.select(frozenset({"shape-1"}), frozenset({("shape-1", 1)}))
    assert plot.lines[0].values[at] == pytest.approx(anchors[1, 0])
    timeline.curves.show_kind(Kind.Y)
    assert plot.lines[0].values[at] == pytest.approx(anchors[1, 1])
    assert [key.frame for key in plot.lines[0].keys] == [1001, 1030]


def test_lines_of_the_grid_are_round_and_not_too_many() -> None:
    assert ticks(-12.0, 112.0, 7) == [0.0, 20.0, 40.0, 60.0, 80.0, 100.0]
    for low, high in ((-12.0, 112.0), (0.1, 0.13), (900.0, 1411.5)):
        found = ticks(low, high, 6)
        assert 2 <= len(found) <= 7
        assert low <= min(found) <= max(found) <= high


# ---- keys under the hand ---------------------------------------------------------------------------------------------


def test_a_key_is_dragged_in_frame_and_value_as_one_undo_step(
    plot: CurvePlot, document: Document, view_state: ViewState
) -> None:
    before, steps = document.project, document.undo_stack.count()
    end = plot.key_point(1012, 60.0)
    grab(plot, plot.key_point(1005, 20.0), end)
    assert document.project is before
    assert view_state.preview is not None
    send(plot, QEvent.Type.MouseButtonRelease, end)
    key = value(document).keys[0]
    assert (key.frame, round(key.value, 2)) == (1012, 0.6)
    assert value(document).keys[1:] == FADES.keys[1:]
    assert document.undo_stack.count() == steps + 1
    document.undo_stack.undo()
    assert document.project is before


@pytest.mark.parametrize(("away", "expected"), [((60.0, 20.0), (True, False)), ((8.0, 40.0), (False, True))])
def test_shift_moves_a_key_along_one_axis(
    plot: CurvePlot, document: Document, away: tuple[float, float], expected: tuple[bool, bool]
) -> None:
    start = plot.key_point(1005, 20.0)
    drag(plot, start, start + QPointF(away[0], -away[1]), SHIFT)
    key = value(document).keys[0]
    assert (key.frame != 1005, key.value != 0.2) == expected


def test_an_opacity_stays_between_none_and_full(plot: CurvePlot, document: Document) -> None:
    drag(plot, plot.key_point(1020, 80.0), plot.key_point(1020, 80.0) - QPointF(0, 500))
    assert value(document).keys[1].value == 1.0
    assert max(value(document).at(1005 + k / 4) for k in range(121)) <= 1.0


def test_a_box_chooses_keys_and_they_move_together(plot: CurvePlot, document: Document) -> None:
    drag(plot, plot.key_point(1002, 110.0), plot.key_point(1024, -10.0))
    assert {frame for _, _, frame in plot._chosen.places} == {1005, 1020}
    drag(plot, plot.key_point(1005, 20.0), plot.key_point(1008, 20.0))
    assert value(document).frames == (1008, 1023, 1035)


def test_esc_leaves_all_as_it_was(qtbot: QtBot, plot: CurvePlot, document: Document, view_state: ViewState) -> None:
    before = document.project
    grab(plot, plot.key_point(1005, 20.0), plot.key_point(1012, 60.0))
    qtbot.keyClick(plot, Qt.Key.Key_Escape)
    assert view_state.preview is None
    send(plot, QEvent.Type.MouseButtonRelease, plot.key_point(1012, 60.0))
    assert document.project is before


def test_ctrl_and_alt_set_a_key_on_the_curve_that_bends_nothing(plot: CurvePlot, document: Document) -> None:
    at = plot.key_point(1012, 100.0 * FADES.at(1012))
    click(plot, at, CTRL | ALT)
    assert value(document).frames == (1005, 1012, 1020, 1035)
    for frame in (1008, 1012, 1015.5):
        assert value(document).at(frame) == pytest.approx(FADES.at(frame))


def test_an_outline_is_moved_by_its_curve(timeline: Timeline, plot: CurvePlot, document: Document) -> None:
    timeline.curves.show_kind(Kind.X)
    before = document.project.shape("shape-1")
    key = next(key for key in plot.lines[0].keys if key.frame == 1030)
    start = plot.key_point(1030, key.value)
    drag(plot, start, start + QPointF(0, -40.0))
    after = document.project.shape("shape-1")
    moved = after.at(1030).points - before.at(1030).points
    assert (moved[..., 0] > 0.0).all()
    assert not moved[..., 1].any()
    np.testing.assert_array_equal(after.at(1001).points, before.at(1001).points)
    drag(plot, plot.key_point(1030, key.value + moved[0, 0, 0]), plot.key_point(1033, key.value + moved[0, 0, 0]))
    assert document.project.shape("shape-1").artist_frames == (1001, 1033)


# ---- tangents --------------------------------------------------------------------------------------------------------


def handle(plot: CurvePlot, frame: int, is_leaving: bool) -> QPointF:
    key = next(key for key in plot.lines[0].keys if key.frame == frame)
    end = key.leaving if is_leaving else key.arriving
    assert end is not None
    return plot.key_point(*end)


def test_a_tangent_turns_both_sides_and_alone_with_ctrl(plot: CurvePlot, document: Document) -> None:
    click(plot, plot.key_point(1020, 80.0))
    steps = document.undo_stack.count()
    drag(plot, handle(plot, 1020, True), plot.key_point(1025, 90.0))
    slopes = value(document).keys[1].slopes
    assert slopes is not None
    assert slopes[0] == slopes[1] == pytest.approx(0.1 / 5.0, rel=1e-3)
    assert document.undo_stack.count() == steps + 1
    drag(plot, handle(plot, 1020, False), plot.key_point(1015, 80.0), CTRL)
    slopes = value(document).keys[1].slopes
    assert slopes is not None
    assert slopes == pytest.approx((0.0, 0.1 / 5.0), abs=1e-3)
    drag(plot, handle(plot, 1020, True), plot.key_point(1025, 70.0), SHIFT)
    slopes = value(document).keys[1].slopes
    assert slopes is not None
    assert slopes[0] == slopes[1] == pytest.approx(-0.1 / 5.0, rel=1e-3)


def test_actions_bend_and_straighten_the_chosen_keys(timeline: Timeline, plot: CurvePlot, document: Document) -> None:
    actions = {action.objectName(): action for action in plot.menu.actions()}
    timeline.values.select(frozenset((*OPACITY, frame) for frame in FADES.frames))
    actions["key.tangents"].trigger()
    assert all(key.slopes is not None for key in value(document).keys)
    actions["key.hold"].trigger()
    assert not has_tangents(value(document))
    assert {key.interpolation for key in value(document).keys} == {Interpolation.HOLD}


# ---- keys of the keyboard --------------------------------------------------------------------------------------------


def test_keys_of_the_keyboard_go_from_key_to_key_move_and_delete(
    qtbot: QtBot, plot: CurvePlot, timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    qtbot.keyClick(plot, Qt.Key.Key_Tab)
    qtbot.keyClick(plot, Qt.Key.Key_Tab)
    assert timeline.values.places == {(*OPACITY, 1020)}
    assert view_state.frame == 1020
    qtbot.keyClick(plot, Qt.Key.Key_Backtab, SHIFT)
    assert timeline.values.places == {(*OPACITY, 1005)}
    qtbot.keyClick(plot, Qt.Key.Key_Right, ALT)
    qtbot.keyClick(plot, Qt.Key.Key_Up, ALT | SHIFT)
    key = value(document).keys[0]
    assert (key.frame, round(key.value, 6)) == (1006, 0.3)
    qtbot.keyClick(plot, Qt.Key.Key_Delete)
    assert value(document).frames == (1020, 1035)


def test_all_keys_are_those_of_the_curves_that_are_shown(
    timeline: Timeline, plot: CurvePlot, document: Document
) -> None:
    plot.verbs.select_all()
    assert timeline.values.places == {(*OPACITY, frame) for frame in (1005, 1020, 1035)}
    timeline.curves.show_kind(Kind.X)
    assert timeline.values.places == frozenset()  # what is out of sight is not deleted unseen
    plot.verbs.select_all()
    assert timeline.values.places == {("shape-1", "x", 1001), ("shape-1", "x", 1030)}


def test_ctrl_with_the_wheel_zooms_values_about_the_pointer_until_something_else_is_shown(
    timeline: Timeline, plot: CurvePlot
) -> None:
    at, whole = plot.key_point(1020, 80.0), plot.values_in_sight
    turn_wheel(plot, at, 240)
    assert plot.values_in_sight[1] - plot.values_in_sight[0] < 0.8 * (whole[1] - whole[0])
    assert plot.value_at(at.y()) == pytest.approx(80.0)
    timeline.curves.show_kind(Kind.OPACITY)
    assert plot.values_in_sight == whole


def test_the_middle_button_pans_values_that_are_zoomed(qtbot: QtBot, plot: CurvePlot) -> None:
    """Only time went along: what lay above the values in sight was reached by zooming out and in again."""
    middle, port, whole = Qt.MouseButton.MiddleButton, plot.viewport(), plot.values_in_sight
    for zooms in (False, True):
        if zooms:
            turn_wheel(plot, plot.key_point(1020, 50.0), 480)
        before, at = plot.values_in_sight, QPoint(300, 40)
        held = plot.value_at(at.y())
        qtbot.mousePress(port, middle, pos=at)
        qtbot.mouseMove(port, at + QPoint(0, 30))
        qtbot.mouseRelease(port, middle, pos=at + QPoint(0, 30))
        if not zooms:
            assert plot.values_in_sight == whole
        else:
            assert plot.value_at(at.y() + 30) == pytest.approx(held)
            assert np.ptp(plot.values_in_sight) == pytest.approx(np.ptp(before))


def test_what_shows_the_whole_clip_shows_all_values_too(timeline: Timeline, plot: CurvePlot) -> None:
    """After a zoom of the values, nothing that an artist looks for brought all of them back."""
    whole = plot.values_in_sight
    turn_wheel(plot, plot.key_point(1020, 50.0), 480)
    timeline.handlers()["view.fit_time"]()
    assert plot.values_in_sight == whole


def test_values_are_zoomed_no_farther_than_they_can_be_told_apart(plot: CurvePlot) -> None:
    """The bottom and the top fell together, and the plot ended in an error."""
    at = plot.key_point(1020, 80.0)
    for turn in (120, -120):
        for _ in range(400):
            turn_wheel(plot, at, turn)
        low, high = plot.values_in_sight
        assert 1e-3 <= high - low <= 1e7


def test_with_alt_a_drag_leaves_the_key_and_takes_a_copy_to_another_frame_and_value(
    plot: CurvePlot, document: Document
) -> None:
    """As in the rows; the key itself went along."""
    steps = document.undo_stack.count()
    drag(plot, plot.key_point(1005, 20.0), plot.key_point(1012, 60.0), ALT)
    assert [(key.frame, round(key.value, 2)) for key in value(document).keys] == [
        (1005, 0.2), (1012, 0.6), (1020, 0.8), (1035, 0.5),
    ]  # fmt: skip
    assert document.undo_stack.undoText() == "Copy keys"
    assert document.undo_stack.count() == steps + 1


def test_a_locked_shape_says_so(plot: CurvePlot, document: Document, view_state: ViewState) -> None:
    shape = document.project.shape("shape-1")
    assert isinstance(shape, RotoShape)
    document.apply("Lock", document.project.with_shape(replace(shape, locked=True)))
    before = document.project
    drag(plot, plot.key_point(1005, 20.0), plot.key_point(1012, 60.0))
    assert document.project is before
    assert view_state.message == "It is locked; unlock it to change its keys."


def test_of_many_shapes_those_that_vary_have_their_curves(
    timeline: Timeline, plot: CurvePlot, document: Document, view_state: ViewState
) -> None:
    project = document.project
    for _ in range(MOST):
        project, _shape = edit.new_shape(project, SQUARE, 1001)
    document.apply("Draw", project)
    view_state.select(frozenset())
    assert len(plot.lines) == MOST
    assert plot.lines[0].item_id == "shape-1"  # the lowest of all
    assert [key.frame for key in plot.lines[0].keys] == [1005, 1020, 1035]
