"""Panning the timeline: the middle button drags it, a thin bar shows and moves the piece of time in sight."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QPointF, QSignalBlocker, Qt, Signal
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QHBoxLayout, QScrollBar, QWidget

from .axis import TimeAxis
from .scale import LABEL_WIDTH, RIGHT_MARGIN

FINENESS = 100
"""Steps of the bar in a frame, from the clip's first one: a bar counts in whole numbers of 32 bits."""

MOST = 2**31 - 1
HEIGHT = 10


class PanHand(QObject):
    """Drags the time under the pointer along with it, while the middle button is down over one of `widgets`.

    Signals
    -------
    dragged(widget, down) : over one of the widgets the pointer went down by so many pixels.
    """

    dragged = Signal(QObject, float)

    def __init__(self, axis: TimeAxis, *widgets: QWidget) -> None:
        super().__init__(axis)
        self._axis = axis
        self._last: QPointF | None = None
        for widget in widgets:
            widget.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if not isinstance(event, QMouseEvent):
            return False
        if event.type() == QEvent.Type.MouseMove and self._last is not None:
            moved, self._last = event.position() - self._last, event.position()
            self._axis.set_scale(self._axis.scale.panned(-moved.x() / self._axis.scale.pixels))
            self.dragged.emit(watched, moved.y())
            return True
        if event.button() != Qt.MouseButton.MiddleButton:
            return False
        self._last = event.position() if event.type() == QEvent.Type.MouseButtonPress else None
        return True


class TimeBar(QWidget):
    """A scroll bar under the frames; there only while a part of the clip is out of sight."""

    def __init__(self, axis: TimeAxis, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._axis = axis
        self.bar = QScrollBar(Qt.Orientation.Horizontal)
        self.bar.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        row = QHBoxLayout(self)
        row.setContentsMargins(LABEL_WIDTH, 0, RIGHT_MARGIN, 0)
        row.addWidget(self.bar)
        self.setFixedHeight(HEIGHT)
        self.bar.valueChanged.connect(self._push)
        axis.changed.connect(self._pull)
        self._pull()

    @property
    def _fineness(self) -> int:
        """Less fine where a few files are numbered hundreds of millions apart."""
        first, stop = self._axis.scale.clip
        return max(1, min(FINENESS, MOST // max(stop - first, 1)))

    def _push(self, value: int) -> None:
        scale = self._axis.scale
        self._axis.set_scale(scale.panned(scale.clip[0] + value / self._fineness - scale.first))

    def _pull(self) -> None:
        scale = self._axis.scale
        first, stop = scale.clip
        seen = scale.width / scale.pixels
        with QSignalBlocker(self.bar):
            self.bar.setRange(0, round(max(stop - first - seen, 0.0) * self._fineness))
            self.bar.setPageStep(round(seen * self._fineness))
            self.bar.setSingleStep(self._fineness)
            self.bar.setValue(round((scale.first - first) * self._fineness))
        self.setVisible(self._axis.has_clip and seen < stop - first - 1e-6)
