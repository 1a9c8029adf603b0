"""TimeAxis: the one time scale that ruler, rows and plot share, and the hand gestures that change it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pyqtgraph as pg
from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPen, QWheelEvent
from PySide6.QtWidgets import QAbstractScrollArea, QWidget

from .. import style
from ..model.view_state import ViewState
from .scale import RIGHT_MARGIN, TimeScale

FARTHEST = 3.0
"""Frames that time is panned by while a drag is held beyond an end of the strip, a move of the pointer."""

ZOOM, PAN = 1.25, 0.1
"""A notch of the wheel: the factor of zoom, the share of the strip."""


class TimeAxis(QObject):
    """Holds the scale, and follows the playhead when it leaves the strip.

    Signals
    -------
    changed() : other frames are in sight. fitted() : all of the clip was asked for.
    """

    changed = Signal()
    fitted = Signal()

    def __init__(self, view_state: ViewState, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.view_state = view_state
        self._scale = TimeScale()
        self._has_clip = False
        view_state.frame_changed.connect(self._follow)

    @property
    def scale(self) -> TimeScale:
        return self._scale

    def set_scale(self, scale: TimeScale) -> None:
        if scale != self._scale:
            self._scale = scale
            self.changed.emit()

    @property
    def has_clip(self) -> bool:
        """False while there is no time to show."""
        return self._has_clip

    def set_clip(self, clip: tuple[int, int] | None) -> None:
        """The frames that exist, half open, or None; all of them are shown."""
        self._has_clip = clip is not None
        self._scale = replace(self._scale, clip=clip or (1, 2)).fitted()
        self.changed.emit()

    def set_width(self, width: int) -> None:
        self.set_scale(self._scale.resized(width - RIGHT_MARGIN))

    def fit(self) -> None:
        """Show all frames; what shows values over them shows all of these, too."""
        self.set_scale(self._scale.fitted())
        self.fitted.emit()

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "view.fit_time": self.fit,
            "view.zoom_in_time": lambda: self._zoom_at_playhead(ZOOM),
            "view.zoom_out_time": lambda: self._zoom_at_playhead(1 / ZOOM),
        }

    def _zoom_at_playhead(self, factor: float) -> None:
        """Zoom with the playhead held in place; one that is out of sight comes in."""
        scale, frame = self._scale.showing(self.view_state.frame), self.view_state.frame
        self.set_scale(scale.zoomed(factor, scale.x(frame)).showing(frame))

    # ---- gestures, the same in ruler and rows

    def wheel(self, event: QWheelEvent, x: float) -> None:
        """Zoom at the pixel `x`; with Shift, or where it turns sideways more than up or down, pan."""
        turn, scale = event.angleDelta(), self._scale
        if abs(turn.x()) > abs(turn.y()) or event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            notches = (turn.x() or turn.y()) / 120
            self.set_scale(scale.panned(-notches * PAN * scale.width / scale.pixels))
        else:
            self.set_scale(scale.zoomed(ZOOM ** (turn.y() / 120), x))
        event.accept()

    def bring_in(self, x: float) -> None:
        """Pan by what the pointer is beyond an end of the strip, a few frames at most: a drag goes on out of sight."""
        scale = self._scale
        beyond = max(x - scale.right, 0.0) + min(x - scale.left, 0.0)
        if beyond:
            self.set_scale(scale.panned(max(min(beyond / scale.pixels, FARTHEST), -FARTHEST)))

    def scrub(self, x: float) -> None:
        """Put the playhead on the frame under the pixel `x`."""
        self.view_state.set_frame(self._scale.frame(x))

    def _follow(self) -> None:
        self.set_scale(self._scale.showing(self.view_state.frame))


def place_playhead(line: pg.InfiniteLine, axis: TimeAxis) -> None:
    """The playhead's line of a plot, which is on a frame's middle and away while there is no clip."""
    line.setVisible(axis.has_clip)
    line.setPos(axis.view_state.frame + 0.5)


def show_frames(box: pg.ViewBox, axis: TimeAxis, width: float) -> None:
    """The frames of a plot so many pixels wide: those of the ruler above it."""
    scale = axis.scale
    box.setXRange(scale.first, scale.first + max(width, 1) / scale.pixels, padding=0)


def paint_playhead(painter: QPainter, axis: TimeAxis, widget: QWidget) -> None:
    """The playhead's line over the full height of a row of the timeline."""
    x = axis.scale.x(axis.view_state.frame)
    if axis.has_clip and axis.scale.left <= x <= axis.scale.right + RIGHT_MARGIN:
        painter.setPen(QPen(QColor(style.ACCENT), 1))
        painter.drawLine(QPointF(x, 0), QPointF(x, widget.height()))


def paint_focus(painter: QPainter, widget: QWidget, view: QWidget | None = None) -> None:
    """A light frame around a part of the timeline that has the keyboard; `view` is what of it is painted on."""
    if widget.hasFocus():
        painter.setPen(QPen(QColor(style.TEXT), 1))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect((widget if view is None else view).rect().adjusted(0, 0, -1, -1))


class FocusRepaint(QObject):
    """Has a scrolled part of the timeline painted anew as the keyboard comes to it or goes, for `paint_focus`."""

    def __init__(self, area: QAbstractScrollArea) -> None:
        super().__init__(area)
        self._area = area
        area.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if watched is self._area and event.type() in (QEvent.Type.FocusIn, QEvent.Type.FocusOut):
            self._area.viewport().update()
        return False
