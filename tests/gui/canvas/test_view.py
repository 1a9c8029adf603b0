"""The canvas as a whole: what is shown, pan and zoom, modes, keys, empty states, and that it only pulls."""

from __future__ import annotations

import threading
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QColor, QCursor, QImage, QKeyEvent
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import Selection, ViewState
from app.model.viewing import ViewMode
from app.paint import marks
from roam_core.arrays import Float32
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Clip, Keyframe, Project, edit
from tests.gui.hand import ALT, CTRL, MIDDLE, SHIFT, Hand
from tests.gui.waiting import WAIT

SQUARE = [(40.0, 40.0), (120.0, 40.0), (120.0, 100.0), (40.0, 100.0)]
MOVED_SQUARE = polygon_points([(x + 20.0, y) for x, y in SQUARE])
PLATE = QColor(100, 100, 100)


def add_square(document: Document) -> str:
    project, shape = edit.new_shape(document.project, polygon_points(SQUARE), 1)
    document.apply("Draw shape", project)
    return shape.id


def looks(canvas: CanvasView) -> QImage:
    return canvas.grab().toImage()


def colour_at(canvas: CanvasView, x: float, y: float) -> QColor:
    return looks(canvas).pixelColor(canvas.image_to_widget(x, y).toPoint())


def is_drawn(canvas: CanvasView, x: float, y: float) -> bool:
    """True when something lies over the grey plate within a pixel of the image position."""
    spot, picture = canvas.image_to_widget(x, y).toPoint(), looks(canvas)
    around = ((dx, dy) for dx in (-1, 0, 1) for dy in (-1, 0, 1))
    return any(picture.pixelColor(spot.x() + dx, spot.y() + dy) != PLATE for dx, dy in around)


# ---- pan and zoom


def test_plate_is_fitted_at_first(canvas: CanvasView) -> None:
    assert canvas.zoom == 2.0
    assert canvas.image_to_widget(0.0, 0.0) == QPointF(24.0, 24.0)
    assert canvas.widget_to_image(QPointF(424.0, 324.0)) == (200.0, 150.0)


def test_surround_and_plate_are_neutral(canvas: CanvasView) -> None:
    assert colour_at(canvas, 100.0, 75.0) == PLATE
    assert looks(canvas).pixelColor(4, 4) == QColor("#262626")


def test_fitted_plate_follows_the_widgets_size(canvas: CanvasView) -> None:
    canvas.resize(248, 198)
    assert canvas.zoom == 1.0
    assert canvas.image_to_widget(100.0, 75.0) == QPointF(124.0, 99.0)


def test_zoomed_view_keeps_its_middle_when_resized(canvas: CanvasView, hand: Hand) -> None:
    hand.wheel((60.0, 60.0), 360)
    zoom, middle = canvas.zoom, canvas.widget_to_image(QPointF(224.0, 174.0))
    canvas.resize(600, 400)
    assert canvas.zoom == zoom
    assert canvas.widget_to_image(QPointF(300.0, 200.0)) == pytest.approx(middle)


@pytest.mark.parametrize("angle", [120, -120, 30])
def test_wheel_zooms_at_the_pointer(canvas: CanvasView, hand: Hand, angle: int) -> None:
    before = canvas.image_to_widget(50.0, 60.0)
    hand.wheel((50.0, 60.0), angle)
    after = canvas.image_to_widget(50.0, 60.0)
    assert canvas.zoom == pytest.approx(2.0 * 1.2 ** (angle / 120))
    assert (after.x(), after.y()) == pytest.approx((before.x(), before.y()))


@pytest.mark.parametrize(("key", "factor"), [("+", 1.44), ("=", 1.44), ("-", 1 / 1.44)])
def test_keys_zoom_at_the_pointer_and_beside_the_viewer_at_its_middle(
    canvas: CanvasView, hand: Hand, monkeypatch: pytest.MonkeyPatch, key: str, factor: float
) -> None:
    for is_over, spot in ((False, QPointF(canvas.rect().center())), (True, QPointF(90.0, 70.0))):
        monkeypatch.setattr(CanvasView, "underMouse", lambda _, is_over=is_over: is_over)
        monkeypatch.setattr(QCursor, "pos", lambda spot=spot: canvas.mapToGlobal(spot.toPoint()))
        before, zoom = canvas.widget_to_image(spot), canvas.zoom
        hand.key(key)
        assert canvas.zoom == pytest.approx(zoom * factor)
        assert canvas.widget_to_image(spot) == pytest.approx(before, abs=1.0)


@pytest.mark.parametrize(
    ("button", "modifiers"), [(MIDDLE, Qt.KeyboardModifier.NoModifier), (Qt.MouseButton.LeftButton, ALT)]
)
def test_middle_button_and_alt_left_pan(
    canvas: CanvasView, hand: Hand, document: Document, button: Qt.MouseButton, modifiers: Qt.KeyboardModifier
) -> None:
    add_square(document)
    start, end = canvas.image_to_widget(40.0, 40.0), canvas.image_to_widget(60.0, 50.0)
    hand.press((40.0, 40.0), modifiers, button)
    assert canvas.cursor().shape() is Qt.CursorShape.ClosedHandCursor
    hand.move((60.0, 50.0), modifiers)
    hand.release((40.0, 40.0), modifiers)
    assert canvas.image_to_widget(0.0, 0.0) == QPointF(24.0, 24.0) + end - start
    assert canvas.cursor().shape() is not Qt.CursorShape.ClosedHandCursor
    assert document.undo_stack.count() == 1


def test_pan_never_selects(hand: Hand, document: Document, view_state: ViewState) -> None:
    shape_id = add_square(document)
    view_state.select(frozenset({shape_id}))
    hand.press((180.0, 130.0), button=MIDDLE)
    hand.release((180.0, 130.0))
    assert view_state.selection.shapes == {shape_id}


def test_f_fits_slash_shows_100_percent(canvas: CanvasView, hand: Hand) -> None:
    hand.wheel((60.0, 60.0), 600)
    hand.key("/")
    assert canvas.zoom == pytest.approx(1.0)
    corner = canvas.image_to_widget(0.0, 0.0)
    assert (corner.x() % 1.0, corner.y() % 1.0) == (0.0, 0.0)
    hand.key("f")
    assert canvas.zoom == 2.0


def test_shift_f_frames_the_selection(
    canvas: CanvasView, hand: Hand, document: Document, view_state: ViewState
) -> None:
    shape_id = add_square(document)
    view_state.select(frozenset({shape_id}))
    hand.key("F", SHIFT)
    middle = canvas.image_to_widget(80.0, 70.0)
    assert (middle.x(), middle.y()) == pytest.approx((224.0, 174.0))
    assert canvas.zoom > 2.0
    view_state.select(frozenset({shape_id}), frozenset({(shape_id, 2)}))
    hand.key("F", SHIFT)
    point = canvas.image_to_widget(120.0, 100.0)
    assert (point.x(), point.y()) == pytest.approx((224.0, 174.0))
    view_state.select(frozenset())
    hand.key("F", SHIFT)
    assert canvas.zoom == 2.0


def test_plate_cannot_be_lost_from_sight(canvas: CanvasView, hand: Hand) -> None:
    hand.press((100.0, 75.0), button=MIDDLE)
    hand.move((100.0 + 5000.0, 75.0 + 5000.0))
    hand.release((100.0, 75.0))
    corner = canvas.image_to_widget(0.0, 0.0)
    assert corner.x() <= canvas.width()
    assert corner.y() <= canvas.height()


def test_another_clip_is_shown_whole(canvas: CanvasView, hand: Hand, document: Document) -> None:
    hand.wheel((60.0, 60.0), 600)
    document.apply("Open clip", replace(document.project, clip=Clip(Path("wide"), 1, 9, (400, 75))))
    assert canvas.zoom == 1.0


def test_anamorphic_plate_is_shown_unsqueezed(canvas: CanvasView, document: Document) -> None:
    document.open(Project(clip=Clip(Path("scope"), 1, 9, (100, 150), pixel_aspect=2.0)), None)
    corner = canvas.image_to_widget(100.0, 150.0)
    assert corner == QPointF(424.0, 324.0)


# ---- pictures


def test_next_frame_of_the_same_plate_keeps_the_zoom(canvas: CanvasView, hand: Hand) -> None:
    hand.wheel((60.0, 60.0), 600)
    zoom = canvas.zoom
    canvas.set_image(2, np.full((150, 200, 3), 30, dtype=np.uint8))
    assert canvas.zoom == zoom
    assert colour_at(canvas, 60.0, 60.0) == QColor(30, 30, 30)


def test_proxy_is_stretched_over_the_plate(canvas: CanvasView) -> None:
    proxy = np.zeros((75, 100, 3), dtype=np.uint8)
    proxy[:, 50:] = 200
    canvas.set_image(1, proxy)
    assert canvas.zoom == 2.0
    assert colour_at(canvas, 90.0, 75.0) == QColor(0, 0, 0)
    assert colour_at(canvas, 110.0, 75.0) == QColor(200, 200, 200)


def test_missing_frame_is_grey_and_says_so(canvas: CanvasView) -> None:
    canvas.set_image(7, None)
    assert colour_at(canvas, 10.0, 10.0) == marks.EMPTY_PLATE
    words = looks(canvas).copy(124, 154, 200, 40)
    assert any(words.pixelColor(x, y) != marks.EMPTY_PLATE for x in range(200) for y in range(40))


def test_without_a_clip_it_says_what_to_do(document: Document, view_state: ViewState, qtbot: QtBot) -> None:
    canvas = CanvasView(document, view_state)
    qtbot.addWidget(canvas)
    canvas.resize(448, 348)
    middle = canvas.grab().toImage().copy(60, 154, 328, 40)
    assert any(middle.pixelColor(x, y) != marks.SURROUND for x in range(328) for y in range(40))


@pytest.mark.parametrize("mode", [ViewMode.OVERLAY, ViewMode.MATTE])
def test_hint_to_draw_is_shown_while_there_is_no_shape(
    canvas: CanvasView, document: Document, view_state: ViewState, qtbot: QtBot, mode: ViewMode
) -> None:
    """The matte of no shape is black: nothing else says what to do there."""
    canvas.viewing.set_mode(mode)
    qtbot.waitUntil(lambda: not canvas.stage.emptiness(), timeout=WAIT)
    bottom = (150, 300, 148, 48)
    with_hint = looks(canvas).copy(*bottom)
    add_square(document)
    without = looks(canvas).copy(*bottom)
    assert with_hint != without
    document.undo_stack.undo()
    assert looks(canvas).copy(*bottom) == with_hint
    view_state.set_tool("bezier")
    assert looks(canvas).copy(*bottom) == without


# ---- it pulls


def test_shape_is_painted_where_it_is_on_the_frame(
    canvas: CanvasView, document: Document, view_state: ViewState
) -> None:
    shape_id = add_square(document)
    shape = document.project.shape(shape_id).with_key(Keyframe(3, MOVED_SQUARE))
    document.apply("Move", document.project.with_shape(shape))
    assert is_drawn(canvas, 40.0, 70.0)
    view_state.set_frame(3)
    assert not is_drawn(canvas, 40.0, 70.0)
    assert is_drawn(canvas, 60.0, 70.0)
    document.undo_stack.undo()
    assert is_drawn(canvas, 40.0, 70.0)


def test_preview_is_painted_in_place_of_the_document(
    canvas: CanvasView, document: Document, view_state: ViewState
) -> None:
    shape_id = add_square(document)
    moved = edit.set_key(document.project.shape(shape_id), 1, MOVED_SQUARE)
    view_state.set_preview(document.project.with_shape(moved))
    assert is_drawn(canvas, 60.0, 70.0)
    assert not is_drawn(canvas, 40.0, 70.0)
    view_state.set_preview(None)
    assert is_drawn(canvas, 40.0, 70.0)


def test_opening_a_project_clears_picture_and_selection(canvas: CanvasView, document: Document, view_state: ViewState):
    view_state.select(frozenset({add_square(document)}))
    document.open(Project(clip=Clip(Path("other"), 1, 9, (200, 150))), None)
    assert view_state.selection == Selection()
    assert colour_at(canvas, 100.0, 75.0) == marks.EMPTY_PLATE


def test_pointer_position_is_told(canvas: CanvasView, hand: Hand, qtbot: QtBot) -> None:
    seen: list[object] = []
    canvas.pointer_moved.connect(seen.append)
    hand.move((33.0, 44.0))
    QApplication.sendEvent(canvas, QEvent(QEvent.Type.Leave))
    assert seen == [(33.0, 44.0), None]


# ---- modes


def test_source_shows_no_shapes_and_edits_none(
    canvas: CanvasView, hand: Hand, document: Document, view_state: ViewState
) -> None:
    add_square(document)
    hand.key("1")
    assert canvas.mode is ViewMode.SOURCE
    assert not is_drawn(canvas, 80.0, 40.0)
    hand.click((80.0, 40.0))
    assert view_state.selection == Selection()
    assert "hidden" in view_state.message
    hand.key("2")
    assert is_drawn(canvas, 80.0, 40.0)


def test_backquote_hides_the_shapes_for_a_while(canvas: CanvasView, hand: Hand, document: Document) -> None:
    add_square(document)
    hand.key("`")
    assert canvas.viewing.are_shapes_hidden
    assert not is_drawn(canvas, 80.0, 40.0)
    hand.key("`")
    assert is_drawn(canvas, 80.0, 40.0)


def test_matte_shows_white_inside_and_black_outside(canvas: CanvasView, hand: Hand, document: Document, qtbot: QtBot):
    add_square(document)
    hand.key("3")
    with qtbot.waitSignal(canvas.matte_ready, timeout=WAIT):
        canvas.repaint()
    assert colour_at(canvas, 80.0, 70.0) == QColor(255, 255, 255)
    assert colour_at(canvas, 10.0, 130.0) == QColor(0, 0, 0)


def test_until_the_first_matte_is_rendered_the_plate_is_black_and_says_so(
    canvas: CanvasView, hand: Hand, document: Document, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    gate = threading.Event()

    def late(project: Project, frame: int, size: tuple[int, int]) -> Float32:
        gate.wait(60)
        return np.ones(size, dtype=np.float32)

    monkeypatch.setattr(canvas.stage.matte, "_render", late)
    add_square(document)
    hand.key("3")
    with qtbot.waitSignal(canvas.matte_ready, timeout=WAIT):
        before = colour_at(canvas, 10.0, 130.0), canvas.stage.emptiness()
        gate.set()
    assert before == (QColor(0, 0, 0), "Rendering the matte …")
    assert colour_at(canvas, 10.0, 130.0) == QColor(255, 255, 255)
    assert canvas.stage.emptiness() == ""


def test_matte_follows_an_edit(canvas: CanvasView, hand: Hand, document: Document, qtbot: QtBot) -> None:
    shape_id = add_square(document)
    hand.key("3")
    with qtbot.waitSignal(canvas.matte_ready, timeout=WAIT):
        canvas.repaint()
    with qtbot.waitSignal(canvas.matte_ready, timeout=WAIT):
        document.apply("Delete", edit.remove_items(document.project, [shape_id]))
        canvas.repaint()
    assert colour_at(canvas, 80.0, 70.0) == QColor(0, 0, 0)


def test_changes_of_the_view_are_told(canvas: CanvasView, hand: Hand, qtbot: QtBot) -> None:
    for act in (lambda: hand.key("1"), lambda: hand.key("`"), lambda: hand.wheel((9.0, 9.0), 120), canvas.fit):
        with qtbot.waitSignal(canvas.view_changed, timeout=WAIT):
            act()


# ---- keys


def test_unknown_keys_go_on_to_the_window(canvas: CanvasView) -> None:
    event = QKeyEvent(QEvent.Type.KeyPress, Qt.Key.Key_F9.value, Qt.KeyboardModifier.NoModifier)
    QApplication.sendEvent(canvas, event)
    assert not event.isAccepted()


def test_escape_belongs_to_the_canvas_only_during_a_drag(canvas: CanvasView, hand: Hand, document: Document) -> None:
    def is_claimed() -> bool:
        event = QKeyEvent(QEvent.Type.ShortcutOverride, Qt.Key.Key_Escape.value, Qt.KeyboardModifier.NoModifier)
        event.ignore()
        QApplication.sendEvent(canvas, event)
        return event.isAccepted()

    add_square(document)
    assert not is_claimed()
    hand.press((180.0, 130.0))
    assert is_claimed()
    hand.release((180.0, 130.0))
    assert not is_claimed()


def test_modifier_alone_changes_the_pointer(
    canvas: CanvasView, hand: Hand, document: Document, view_state: ViewState
) -> None:
    view_state.select(frozenset({add_square(document)}))
    hand.move((80.0, 40.0))
    assert canvas.cursor().shape() is Qt.CursorShape.SizeAllCursor
    # A key event holds the modifiers as they were before it.
    QApplication.sendEvent(canvas, QKeyEvent(QEvent.Type.KeyPress, Qt.Key.Key_Alt.value, CTRL))
    assert canvas.cursor().shape() is Qt.CursorShape.CrossCursor
    QApplication.sendEvent(canvas, QKeyEvent(QEvent.Type.KeyRelease, Qt.Key.Key_Alt.value, CTRL | ALT))
    assert canvas.cursor().shape() is Qt.CursorShape.SizeAllCursor
