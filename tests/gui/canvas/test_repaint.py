"""A drag paints little, and what it leaves on the screen is what a whole repaint gives."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QObject, QPointF, QRectF
from PySide6.QtGui import QImage, QPaintEvent
from PySide6.QtWidgets import QApplication

from app.canvas.repaint import changed_area
from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import ViewState
from app.paint.clipping import clipped_path
from app.paint.outline_paths import outline_path
from app.paint.viewport import Viewport
from roam_core.geometry import bezier
from roam_core.roto import Keyframe, Origin, Project, RotoShape, Spline, edit
from tests.gui.hand import CTRL, SHIFT, Hand
from tests.gui.waiting import WAIT


def ring(count: int = 24) -> np.ndarray:
    """A smooth ring about (100, 75)."""
    angle = np.arange(count) * 2.0 * np.pi / count
    outward = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    along = np.stack([-outward[:, 1], outward[:, 0]], axis=1) * (2.0 / count)
    return np.array([100.0, 75.0]) + 60.0 * np.stack([outward, outward - along, outward + along], axis=1)


class Painted(QObject):
    """Sums the areas that the canvas painted."""

    def __init__(self, canvas: CanvasView) -> None:
        super().__init__(canvas)
        self.area = 0
        canvas.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QPaintEvent):
            self.area += event.rect().width() * event.rect().height()
        return False


def on_screen(canvas: CanvasView) -> QImage:
    """What stands on the screen now, by all the small repaints until here."""
    QApplication.processEvents()
    picture = canvas.screen().grabWindow(canvas.winId()).toImage()
    return picture.convertToFormat(QImage.Format.Format_RGB32)


def whole(canvas: CanvasView) -> QImage:
    return canvas.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)


def difference(a: QImage, b: QImage) -> int:
    """The largest difference of a channel of two pictures."""
    first, second = (
        np.frombuffer(image.constBits(), dtype=np.uint8).reshape(image.height(), image.width(), 4)[..., :3]
        for image in (a, b)
    )
    return int(np.abs(first.astype(int) - second.astype(int)).max())


@pytest.fixture
def shape(canvas: CanvasView, document: Document, view_state: ViewState) -> RotoShape:
    project, shape = edit.new_shape(document.project, ring(), 1)
    document.apply("Draw", project)
    view_state.select(frozenset([shape.id]))
    QApplication.processEvents()
    return shape


def test_the_screen_can_be_read(canvas: CanvasView, shape: RotoShape) -> None:
    assert difference(on_screen(canvas), whole(canvas)) == 0


def move_a_point(hand: Hand) -> None:
    hand.press((160.0, 75.0))
    for x, y in ((163.0, 78.0), (170.0, 90.0), (150.0, 70.0)):
        hand.move((x, y))
        QApplication.processEvents()


def move_and_let_go(hand: Hand) -> None:
    move_a_point(hand)
    hand.release((150.0, 70.0))


def turn_a_handle(hand: Hand) -> None:
    hand.click((160.0, 75.0))
    hand.press((160.0, 80.0))
    for at in ((163.0, 85.0), (170.0, 100.0)):
        hand.move(at, CTRL)
        QApplication.processEvents()


def hover_points(hand: Hand) -> None:
    for at in ((150.0, 75.0), (159.0, 75.0), (160.0, 75.0), (157.96, 90.5), (100.0, 75.0)):
        hand.move(at)
        QApplication.processEvents()


def span_a_marquee(hand: Hand) -> None:
    hand.press((5.0, 5.0))
    for at in ((30.0, 40.0), (150.0, 140.0), (60.0, 20.0)):
        hand.move(at)
        QApplication.processEvents()


def move_the_shape(hand: Hand) -> None:
    hand.press((100.0, 15.0), SHIFT)
    hand.release((100.0, 15.0), SHIFT)
    hand.press((157.96, 90.5))
    for at in ((150.0, 80.0), (120.0, 95.0)):
        hand.move(at)
        QApplication.processEvents()


def draw_a_polygon(hand: Hand) -> None:
    hand.canvas._view_state.set_tool("polygon")
    for at in ((20.0, 20.0), (90.0, 30.0), (60.0, 120.0)):
        hand.move(at)
        hand.click(at)
        QApplication.processEvents()
    hand.move((30.0, 90.0))


GESTURES = (
    move_a_point, move_and_let_go, turn_a_handle, hover_points, span_a_marquee, move_the_shape, draw_a_polygon,
)  # fmt: skip


@pytest.mark.parametrize("gesture", GESTURES)
def test_small_repaints_leave_what_a_whole_one_gives(
    canvas: CanvasView, hand: Hand, shape: RotoShape, gesture: Callable[[Hand], None]
) -> None:
    gesture(hand)
    assert difference(on_screen(canvas), whole(canvas)) <= 2  # a cut path is rounded a little differently


@pytest.mark.parametrize("gesture", [move_a_point, span_a_marquee])
def test_b_splines_and_doubtful_keys_too(
    canvas: CanvasView, hand: Hand, document: Document, shape: RotoShape, gesture: Callable[[Hand], None]
) -> None:
    doubts = np.linspace(0.0, 1.0, len(shape.keys[0].points))
    key = Keyframe(1, shape.keys[0].points, origin=Origin.ENGINE, vertex_confidence=doubts)
    document.apply("Track", document.project.with_shape(replace(shape, keys=(key,))))
    QApplication.processEvents()
    gesture(hand)
    assert difference(on_screen(canvas), whole(canvas)) <= 2


def test_a_point_of_a_large_shape_is_dragged_in_a_small_area(canvas: CanvasView, hand: Hand, shape: RotoShape) -> None:
    hand.press((160.0, 75.0))
    hand.move((165.0, 75.0))
    QApplication.processEvents()
    painted = Painted(canvas)
    hand.move((166.0, 76.0))
    QApplication.processEvents()
    assert 0 < painted.area < 0.25 * canvas.width() * canvas.height()


def test_the_first_move_after_an_undo_takes_the_outline_along(
    canvas: CanvasView, hand: Hand, document: Document, view_state: ViewState, shape: RotoShape
) -> None:
    """What it had been compared with was the shape where the drag before had left it: the outline stayed on screen."""
    view_state.select(frozenset([shape.id]), frozenset((shape.id, index) for index in range(24)))
    hand.move((160.0, 75.0))
    for is_undone in (True, False):
        QApplication.processEvents()
        hand.press((160.0, 75.0))
        hand.move((230.0, 75.0))
        QApplication.processEvents()
        if is_undone:
            hand.release((230.0, 75.0))
            document.undo_stack.undo()
    assert difference(on_screen(canvas), whole(canvas)) <= 2


def test_in_the_matte_view_everything_follows_a_drag(canvas: CanvasView, hand: Hand, shape: RotoShape, qtbot) -> None:
    hand.key("3")
    with qtbot.waitSignal(canvas.matte_ready, timeout=WAIT):
        canvas.repaint()
    hand.press((160.0, 75.0))
    hand.move((165.0, 75.0))
    painted = Painted(canvas)
    with qtbot.waitSignal(canvas.matte_ready, timeout=WAIT):
        hand.move((190.0, 76.0))
    QApplication.processEvents()
    assert painted.area >= canvas.width() * canvas.height()
    assert difference(on_screen(canvas), whole(canvas)) <= 2


# ---- what changed


def test_nothing_changed_is_no_area(shape: RotoShape, document: Document) -> None:
    project = document.project
    assert changed_area(project, project, 1, Viewport()).isEmpty()
    assert changed_area(project, project.with_shape(replace(shape, name="Other")), 1, Viewport()).isEmpty()


def test_what_is_not_a_matter_of_points_may_be_anywhere(shape: RotoShape, document: Document) -> None:
    project = document.project
    for other in (
        replace(shape, colour=(0.1, 0.2, 0.3)),
        replace(shape, closed=False),
        replace(shape, locked=True),
        replace(shape, visible=False),
        replace(shape, spline=Spline.BSPLINE),
    ):
        assert changed_area(project, project.with_shape(other), 1, Viewport()) is None
    assert changed_area(project, edit.remove_items(project, [shape.id]), 1, Viewport()) is None


def test_the_area_holds_the_segments_beside_a_moved_point(shape: RotoShape, document: Document) -> None:
    points = ring()
    points[0] += (30.0, 0.0)
    after = document.project.with_shape(edit.set_key(shape, 1, points))
    area = changed_area(document.project, after, 1, Viewport(2.0, 5.0, 7.0))
    assert area.contains(QRectF(QPointF(325.0, 150.0), QPointF(385.0, 164.0)))
    assert area.width() < 200.0


def test_the_area_holds_the_frames_of_points_that_are_the_artists_no_more_by_themselves(
    shape: RotoShape, document: Document
) -> None:
    """The last point of a key is dragged: all are the artist's then, and none has a frame about it."""
    key = shape.keys[0]
    *others, last = range(shape.point_count)
    before = document.project.with_shape(replace(shape, keys=(replace(key, set_points=tuple(others)),)))
    points = key.points.copy()
    points[last] += 2.0
    after = before.with_shape(replace(shape, keys=(replace(key, points=points, set_points=()),)))
    area = changed_area(before, after, 1, Viewport())
    assert all(area.contains(QPointF(*anchor)) for anchor in key.points[:, bezier.ANCHOR].tolist())


# ---- pieces of outlines


@pytest.mark.parametrize("closed", [True, False])
def test_a_piece_is_painted_just_as_the_whole_where_it_is_wanted(closed: bool) -> None:
    control = bezier.segments(ring(), closed)
    rng = np.random.default_rng(2)
    for _ in range(20):
        wanted = rng.random(len(control)) < 0.3
        path = clipped_path(control, wanted, closed)
        ends = {path.elementAt(k).x for k in range(path.elementCount())}
        for index in np.flatnonzero(wanted):
            assert set(control[index, :, 0]) <= ends


def test_all_pieces_are_the_whole() -> None:
    for closed in (True, False):
        control = bezier.segments(ring(), closed)
        assert clipped_path(control, np.ones(len(control), dtype=bool), closed) == outline_path(ring(), closed)


def test_no_piece_is_an_empty_path() -> None:
    control = bezier.segments(ring(), True)
    assert clipped_path(control, np.zeros(len(control), dtype=bool), True).isEmpty()


def test_a_document_without_shapes_has_no_area() -> None:
    assert changed_area(Project(), Project(), 1, Viewport()).isEmpty()
