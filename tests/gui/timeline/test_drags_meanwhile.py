"""What comes into the project during a drag in the timeline stays: frames of a run, undo, another project."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial

import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QContextMenuEvent, QMouseEvent
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from app.model.document import Document
from app.model.view_state import ViewState
from app.timeline.timeline import Timeline
from roam_core.roto import Animated, Keyframe, Mark, Origin, Project, ValueKey, edit, timing
from tests.gui.timeline.places import SQUARE, place, x_of
from tests.gui.waiting import WAIT

LEFT, RIGHT, NO_BUTTON = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton, Qt.MouseButton.NoButton
FADES = Animated((ValueKey(1005, 0.2), ValueKey(1020, 0.8, slopes=(0.0, 0.0)), ValueKey(1035, 0.5)))
Drag = tuple[QWidget, QPointF, QPointF]
"""Where a drag happens, where it begins and where it ends."""


@pytest.fixture
def busy(qtbot: QtBot, timeline: Timeline, document: Document, view_state: ViewState) -> Timeline:
    """A timeline with a mark, an opacity that varies, and its curve."""
    shape = replace(document.project.shape("shape-1"), opacity=FADES)
    document.apply("Fade", timing.set_mark(document.project.with_shape(shape), 1012, "turn"))
    timeline.resize(1100, 560)
    timeline.confidence.hide()
    timeline.curve_panel.show()
    view_state.select(frozenset({"shape-1"}))
    qtbot.waitUntil(timeline.value_rows.isVisible, timeout=WAIT)
    timeline.values.select(frozenset({("shape-1", "opacity", 1020)}))
    qtbot.waitUntil(lambda: bool(timeline.curves.plot.lines), timeout=WAIT)
    return timeline


def a_mark(timeline: Timeline) -> Drag:
    return timeline.marks, QPointF(x_of(timeline, 1012), 8), QPointF(x_of(timeline, 1016), 8)


def a_key_of_opacity(timeline: Timeline) -> Drag:
    return timeline.value_rows, QPointF(place(timeline, 1020, 0)), QPointF(place(timeline, 1024, 0))


def a_key_of_a_curve(timeline: Timeline) -> Drag:
    plot = timeline.curves.plot
    return plot.viewport(), plot.key_point(1020, 80.0), plot.key_point(1024, 70.0)


def a_tangent(timeline: Timeline) -> Drag:
    plot = timeline.curves.plot
    (key,) = [key for key in plot.lines[0].keys if key.frame == 1020]
    assert key.leaving is not None
    end = plot.key_point(*key.leaving)
    return plot.viewport(), end, end + QPointF(0.0, -20.0)


DRAGS = [a_mark, a_key_of_opacity, a_key_of_a_curve, a_tangent]


def send(widget: QWidget, kind: QEvent.Type, at: QPointF) -> None:
    button = NO_BUTTON if kind == QEvent.Type.MouseMove else LEFT
    held = NO_BUTTON if kind == QEvent.Type.MouseButtonRelease else LEFT
    event = QMouseEvent(kind, at, QPointF(widget.mapToGlobal(at)), button, held, Qt.KeyboardModifier.NoModifier)
    QApplication.sendEvent(widget, event)


def pull(gesture: Drag, meanwhile: Callable[[], object]) -> None:
    """Drag and hold, with the pointer at rest at the end while something else happens."""
    widget, start, end = gesture
    send(widget, QEvent.Type.MouseButtonPress, start)
    for at in ((start + end) / 2.0, end):
        send(widget, QEvent.Type.MouseMove, at)
    meanwhile()


def drag(gesture: Drag, meanwhile: Callable[[], object]) -> None:
    """Let go after that."""
    pull(gesture, meanwhile)
    send(gesture[0], QEvent.Type.MouseButtonRelease, gesture[2])


@pytest.mark.parametrize("gesture", DRAGS)
def test_frames_that_are_tracked_during_a_drag_stay(
    busy: Timeline, document: Document, gesture: Callable[[Timeline], Drag]
) -> None:
    def tracked() -> None:
        key = Keyframe(1021, SQUARE, origin=Origin.ENGINE, confidence=0.9)
        change = edit.set_engine_keys(document.project.shape("shape-2"), [key])
        document.amend("Track", lambda project: project.with_shape(change), "track-1")

    before = document.project
    drag(gesture(busy), tracked)
    assert document.project.shape("shape-2").key_at(1021) is not None
    assert (document.project.marks, document.project.shape("shape-1")) != (before.marks, before.shape("shape-1"))


@pytest.mark.parametrize("gesture", DRAGS)
def test_another_project_that_is_opened_during_a_drag_stays_as_it_is(
    busy: Timeline, document: Document, view_state: ViewState, gesture: Callable[[Timeline], Drag]
) -> None:
    other = replace(Project(document.project.clip), marks=(Mark(1030),))
    drag(gesture(busy), lambda: document.open(other, None))
    assert document.project is other
    assert view_state.preview is None


@pytest.mark.parametrize("gesture", DRAGS)
def test_undo_during_a_drag_takes_away_what_is_dragged(
    busy: Timeline, document: Document, view_state: ViewState, gesture: Callable[[Timeline], Drag]
) -> None:
    drag(gesture(busy), document.undo_stack.undo)
    assert document.project.marks == ()
    assert document.project.shape("shape-1").opacity == 1.0
    assert view_state.preview is None


def test_a_click_on_a_mark_with_an_unsteady_hand_leaves_it_where_it_is(busy: Timeline, document: Document) -> None:
    """A frame is as wide as what counts as a click: the pointer is over the next one already."""
    busy.axis.set_scale(replace(busy.axis.scale, pixels=6.0))
    at = QPointF(x_of(busy, 1012) + 3, 8)
    drag((busy.marks, at, at + QPointF(1.0, 1.0)), lambda: None)
    assert document.project.marks == (Mark(1012, "turn"),)


def test_a_mark_goes_by_as_much_as_the_pointer_does(busy: Timeline, document: Document) -> None:
    busy.axis.set_scale(replace(busy.axis.scale, pixels=6.0))
    at = QPointF(x_of(busy, 1012) + 5, 8)
    drag((busy.marks, at, at + QPointF(4 * 6.0, 0.0)), lambda: None)
    assert document.project.marks == (Mark(1016, "turn"),)


def test_esc_leaves_a_dragged_mark_where_it_was_wherever_the_keyboard_is(
    qtbot: QtBot, busy: Timeline, document: Document, view_state: ViewState
) -> None:
    drag(a_mark(busy), lambda: qtbot.keyClick(busy.rows, Qt.Key.Key_Escape))
    assert document.project.marks == (Mark(1012, "turn"),)
    assert view_state.frame == 1012


@pytest.mark.parametrize("gesture", [a_key_of_opacity, a_key_of_a_curve])
def test_a_key_that_is_dragged_out_of_sight_stays_under_the_pointer(
    busy: Timeline, document: Document, gesture: Callable[[Timeline], Drag]
) -> None:
    busy.axis.set_scale(replace(busy.axis.scale, first=1001.0, pixels=30.0))
    widget, start, _ = gesture(busy)
    beyond = QPointF(widget.width() + 30.0, start.y())
    send(widget, QEvent.Type.MouseButtonPress, start)
    for _ in range(40):
        send(widget, QEvent.Type.MouseMove, beyond)
    send(widget, QEvent.Type.MouseButtonRelease, beyond)
    opacity = document.project.shape("shape-1").opacity
    assert isinstance(opacity, Animated)
    assert 1048 in opacity.frames


def a_key_of_a_shape(timeline: Timeline) -> Drag:
    row = next(index for index, shape in enumerate(timeline.rows.rows()) if shape.id == "shape-1")
    return timeline.rows.viewport(), QPointF(place(timeline, 1030, row)), QPointF(place(timeline, 1034, row))


@pytest.mark.parametrize("gesture", [*DRAGS, a_key_of_a_shape])
def test_the_other_button_of_a_pen_means_nothing_during_a_drag(
    busy: Timeline, document: Document, view_state: ViewState, gesture: Callable[[Timeline], Drag]
) -> None:
    """A menu took the release away, or the drag was let go of: what it showed stayed in the viewer."""
    held = gesture(busy)
    widget, end, before = held[0], held[2], document.project

    def press_the_other() -> None:
        for kind in (QEvent.Type.MouseButtonPress, QEvent.Type.MouseButtonRelease):
            spots = end, QPointF(widget.mapToGlobal(end))
            QApplication.sendEvent(widget, QMouseEvent(kind, *spots, RIGHT, LEFT, Qt.KeyboardModifier.NoModifier))
        menu = QContextMenuEvent(QContextMenuEvent.Reason.Mouse, end.toPoint(), widget.mapToGlobal(end).toPoint())
        QApplication.sendEvent(widget, menu)

    drag(held, press_the_other)
    menus = busy.rows.menu, busy.value_rows.menu, busy.curves.plot.menu
    assert not any(menu.isVisible() for menu in menus)
    assert view_state.preview is None
    assert document.project != before
    assert len(document.project.marks) == 1


def test_esc_after_an_undo_during_a_drag_chooses_no_key_that_is_gone(busy: Timeline, document: Document) -> None:
    """What had been chosen before the press was chosen again, and pasting it ended in an error."""
    keyed = edit.key_here(document.project.shape("shape-1"), 1040)
    document.apply("Key", document.project.with_shape(keyed))
    row = next(index for index, shape in enumerate(busy.rows.rows()) if shape.id == "shape-1")
    at, beside = (QPointF(place(busy, frame, row)) for frame in (1040, 1044))
    busy.keys.select(frozenset({("shape-1", 1030), ("shape-1", 1040)}))
    pull((busy.rows.viewport(), at, beside), document.undo_stack.undo)
    busy.rows.hand.cancel()
    assert busy.keys.places == {("shape-1", 1030)}
    for does in (busy.verbs.copy, busy.verbs.paste):
        does()


def test_esc_after_an_undo_during_the_drag_of_a_curve_chooses_no_key_that_is_gone(
    qtbot: QtBot, busy: Timeline, document: Document
) -> None:
    plot, elsewhere = busy.curves.plot, []
    act = busy.taking_over({name: partial(elsewhere.append, name) for name in ("edit.copy", "edit.paste")})
    busy.activateWindow()
    plot.setFocus()
    qtbot.waitUntil(plot.hasFocus, timeout=WAIT)
    pull(a_key_of_a_curve(busy), document.undo_stack.undo)
    plot.hand.cancel()
    assert busy.values.places == frozenset()
    for name in ("edit.copy", "edit.paste"):
        act[name]()
    assert elsewhere == ["edit.copy", "edit.paste"]
