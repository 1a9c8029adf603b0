"""ZoomableWidget: a widget that looks at a plate through a viewport: fit, zoom at the pointer, pan."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QPointF, QRectF, QSizeF, Qt, Signal
from PySide6.QtGui import QCursor, QMouseEvent, QNativeGestureEvent, QResizeEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from ..paint.viewport import Viewport

ZOOM_PER_NOTCH = 1.2
"""Scaling by one notch of a mouse wheel (120 eighths of a degree); trackpads send fractions of it."""

NOTCHES_PER_PRESS = 2
"""What a press of a key zooms by."""

DETAIL_MARGIN = 96.0
"""Space around a framed detail, in widget units: a shape is judged with what lies about it."""

LEAST_DETAIL = 16.0
"""The smallest side of a framed detail, in image pixels: a single point is not framed at infinity."""


class ZoomableWidget(QWidget):
    """Keeps the viewport. Whoever derives from it says how large the plate is and paints.

    Signals
    -------
    view_changed() : something that decides what is in sight changed: zoom, pan, mode.
    """

    view_changed = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._viewport = Viewport()
        self._is_fitted = True
        self._gone = 0.0, 0.0
        """How far aside a fitted view went, image pixels."""
        self._framed: tuple[QSizeF, float] = (QSizeF(), 1.0)
        self._pan_from: QPointF | None = None

    def plate_size(self) -> QSizeF:
        """The plate's size in full-resolution pixels."""
        return QSizeF(self.size())

    @property
    def zoom(self) -> float:
        """Device pixels for an image pixel: 1 is 100 %."""
        return self._viewport.scale * self.devicePixelRatioF()

    @property
    def is_panning(self) -> bool:
        return self._pan_from is not None

    def image_to_widget(self, x: float, y: float) -> QPointF:
        """The widget position of an image position."""
        return self._viewport.to_widget(x, y)

    def widget_to_image(self, position: QPointF) -> tuple[float, float]:
        """The image position under a widget position."""
        return self._viewport.to_image(position)

    def fit(self) -> None:
        """Show the whole plate, and go on doing so when the widget's size changes."""
        self.set_viewport(self._viewport.fitted(QRectF(QPointF(), self.plate_size()), QSizeF(self.size())))
        self._is_fitted, self._gone = True, (0.0, 0.0)

    def frame_plate(self, size: QSizeF, pixel_aspect: float) -> None:
        """Show the plate whole, if it is another than the one that was framed last."""
        if (size, pixel_aspect) != self._framed:
            self._framed = size, pixel_aspect
            self._viewport = Viewport(pixel_aspect=pixel_aspect)
            self.fit()

    def show_area(self, area: QRectF) -> None:
        """Show a part of the plate as large as can be, with some of what lies about it."""
        grown = QRectF(0.0, 0.0, max(area.width(), LEAST_DETAIL), max(area.height(), LEAST_DETAIL))
        grown.moveCenter(area.center())
        margin = min(DETAIL_MARGIN, self.width() / 4, self.height() / 4)
        self.set_viewport(self._viewport.fitted(grown, QSizeF(self.size()), margin))

    def actual_size(self) -> None:
        """One device pixel for each image pixel, about the widget's middle."""
        whole = self._viewport.zoomed(1.0 / self.zoom, QRectF(self.rect()).center())
        self.set_viewport(whole.on_whole_pixels(self.devicePixelRatioF()))

    def zoom_in(self, presses: int = 1) -> None:
        """Zoom at the pointer, where it is over this, else at the middle; out for less than no presses."""
        at = QPointF(self.mapFromGlobal(QCursor.pos())) if self.underMouse() else QRectF(self.rect()).center()
        self.set_viewport(self._viewport.zoomed(ZOOM_PER_NOTCH ** (NOTCHES_PER_PRESS * presses), at))

    def zoom_out(self) -> None:
        self.zoom_in(-1)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "view.fit": self.fit,
            "view.actual_size": self.actual_size,
            "view.zoom_in": self.zoom_in,
            "view.zoom_out": self.zoom_out,
        }

    def set_viewport(self, viewport: Viewport) -> None:
        """Look through another viewport, no further aside than leaves a rim of the plate in sight."""
        self._viewport = viewport.kept_in_sight(self.plate_size(), QSizeF(self.size()))
        self._is_fitted = False
        self.view_changed.emit()
        self.update()

    def go_along(self, shift: tuple[float, float]) -> tuple[float, float]:
        """Show what lies so many image pixels aside in its place; gives how far that was possible.

        A plate that was fitted goes on being as large as can be.
        """
        before, (across, down), is_fitted = self._viewport, self._viewport.pixel, self._is_fitted
        self.set_viewport(before.with_picture_moved((-shift[0], -shift[1])))
        went = (before.x - self._viewport.x) * across, (before.y - self._viewport.y) * down
        self._is_fitted, self._gone = is_fitted, (self._gone[0] + went[0], self._gone[1] + went[1])
        return went

    def resizeEvent(self, event: QResizeEvent) -> None:
        if self._is_fitted:
            gone = self._gone
            self.fit()
            if any(gone):
                self.go_along(gone)
            return
        # What was in the middle stays in the middle.
        grown = event.size() - event.oldSize()
        self.set_viewport(self._viewport.panned(grown.width() / 2, grown.height() / 2))

    def wheelEvent(self, event: QWheelEvent) -> None:
        factor = ZOOM_PER_NOTCH ** (event.angleDelta().y() / 120.0)
        self.set_viewport(self._viewport.zoomed(factor, event.position()))
        event.accept()

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QNativeGestureEvent) and event.gestureType() is Qt.NativeGestureType.ZoomNativeGesture:
            self.set_viewport(self._viewport.zoomed(1.0 + event.value(), event.position()))
            return True
        return super().event(event)

    def begin_pan(self, event: QMouseEvent) -> bool:
        """Begin a pan if this press means one: the middle button, or the left one with Alt alone."""
        alone = event.modifiers() == Qt.KeyboardModifier.AltModifier
        left = event.button() is Qt.MouseButton.LeftButton
        if event.button() is not Qt.MouseButton.MiddleButton and not (left and alone):
            return False
        self._pan_from = event.position()
        self.setCursor(Qt.CursorShape.ClosedHandCursor)
        return True

    def pan(self, event: QMouseEvent) -> None:
        """Let the plate follow the pointer."""
        if self._pan_from is not None:
            step = event.position() - self._pan_from
            self._pan_from = event.position()
            self.set_viewport(self._viewport.panned(step.x(), step.y()))

    def end_pan(self) -> None:
        self._pan_from = None
