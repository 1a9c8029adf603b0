"""PointsTool: puts up to four points on the picture, which a track then follows; the shapes in hand go with them."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPen

from ...features.planar_tracking import points_at
from ...model.document import Document
from ...model.track_points import MOST, TrackPoints
from ...model.view_state import ViewState, shapes_in_hand
from ...paint import marks
from ...paint.viewport import Viewport
from ...translation import N_, tr
from ..gesture_tool import GROWTH, GestureTool
from ..gestures import Gesture
from ..reshape import Vector
from ..tool import Pointer

REACH = 9.0
"""Screen pixels around a point in which a press takes it."""
CROSS = 6.0
TAKE_BACK, CLEAR = frozenset({"Backspace", "Del"}), "Esc"


class PointsTool(GestureTool):
    """A click puts a point, a drag moves one; Ctrl and the wheel size the areas, Backspace and Del take the last back.

    One point tells position, two turn and size as well, four perspective.
    """

    name = "points"
    title = N_("Track points")
    hint = N_("Click one, two or four marks, then <planar.forward>; Ctrl and the wheel size their areas.")

    @property
    def cursor(self) -> Qt.CursorShape:
        return Qt.CursorShape.CrossCursor

    @property
    def claimed_keys(self) -> frozenset[str]:
        if held := super().claimed_keys:
            return held
        clearing = frozenset() if self.view_state.follows_points else frozenset({CLEAR})  # the track is stopped first
        return TAKE_BACK | clearing if self.here().places else frozenset()

    def here(self) -> TrackPoints:
        """The points on the present frame: where they were put, carried as the shapes in hand were tracked."""
        ids = [shape.id for shape in shapes_in_hand(self.document.project, self.view_state.selection)]
        return points_at(self.document.project, self.view_state, ids)

    def press(self, pointer: Pointer) -> None:
        points = self.here()
        near = [(pointer.screen_distance(place), index) for index, place in enumerate(points.places)]
        distance, index = min(near, default=(REACH + 1.0, -1))
        if distance > REACH and len(points.places) == MOST:
            self.view_state.say(tr("Four points are enough: drag one of them, or take one back with Backspace."))
            return
        if distance > REACH:
            points, index = points.with_place(pointer.position), len(points.places)
        points = TrackPoints(self.view_state.frame, points.places, points.pattern, points.search)
        self._gesture = PlaceDrag(self.document, self.view_state, pointer, points, index)

    def wheel(self, pointer: Pointer, notches: float) -> bool:
        self.view_state.track_points = points = self.here().grown(GROWTH**notches)
        self.view_state.say(
            tr(
                "Pattern {pattern:.0f} px, search {search:.0f} px.",
                pattern=2 * points.pattern,
                search=2 * points.search,
            ),
            is_reading=True,
        )
        return True

    def key(self, name: str) -> None:
        points = self.here()
        if self._gesture:
            self.drop()
        elif name in TAKE_BACK:
            self.view_state.track_points = points.without(len(points.places) - 1)
        else:
            self.view_state.track_points = TrackPoints(points.frame, (), points.pattern, points.search)

    def paint(self, painter: QPainter, viewport: Viewport) -> None:
        points = self.here()
        for x, y in points.places:
            _paint_point(painter, viewport, (x, y), points)


class PlaceDrag(Gesture):
    """Puts a point where it is pressed and takes it along until the release; Esc leaves all as it was."""

    def __init__(
        self, document: Document, view_state: ViewState, pressed: Pointer, points: TrackPoints, index: int
    ) -> None:
        super().__init__(document, view_state, pressed)
        self._before, self._points, self._index = view_state.track_points, points, index
        self._place = points.places[index]
        view_state.track_points = points

    @property
    def is_valid(self) -> bool:
        return self.view_state.frame == self._points.frame

    @property
    def held_place(self) -> Vector | None:
        points = self.view_state.track_points
        return points.places[self._index] if points is not None and self._index < len(points.places) else None

    def drag(self, pointer: Pointer) -> None:
        (x, y), (dx, dy) = self._place, self.delta
        self.view_state.track_points = self._points.moved(self._index, (x + dx, y + dy))

    def finish(self, pointer: Pointer) -> None:
        self.drag(pointer)

    def drop(self) -> None:
        self.view_state.track_points = self._before


def _paint_point(painter: QPainter, viewport: Viewport, place: tuple[float, float], points: TrackPoints) -> None:
    """A cross in its pattern area, within its search area."""
    painter.setBrush(Qt.BrushStyle.NoBrush)
    at = viewport.to_widget(*place)
    for reach, style in ((points.pattern, Qt.PenStyle.SolidLine), (points.search, Qt.PenStyle.DashLine)):
        box = QRectF(
            viewport.to_widget(place[0] - reach, place[1] - reach),
            viewport.to_widget(place[0] + reach, place[1] + reach),
        )
        for ink, width in ((marks.EDGE, 2.5), (marks.ACCENT, 1.0)):
            painter.setPen(QPen(ink, width, style))
            painter.drawRect(box)
    for ink, width in ((marks.EDGE, 3.0), (marks.BRIGHT, 1.0)):
        painter.setPen(QPen(ink, width))
        painter.drawLine(at - QPointF(CROSS, 0), at + QPointF(CROSS, 0))
        painter.drawLine(at - QPointF(0, CROSS), at + QPointF(0, CROSS))
