"""The lane of boil in the timeline: how much outlines jitter on each frame, and from where on that is seen."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPaintEvent, QPen, QWheelEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from roam_core.arrays import Array
from roam_core.review.boil import BOILING
from roam_core.roto import RotoShape

from .. import style
from ..features.boil import boil_of_document
from ..model.document import Document
from ..model.view_state import shapes_in_hand
from ..translation import tr
from ..widgets.tipped import TippedWidget
from .axis import TimeAxis, paint_playhead
from .keys.tips import frame_tip
from .marks import on_each_frame
from .scale import LABEL_WIDTH, TimeScale

HEIGHT = 30
TOP = 3.0 * BOILING
"""Pixels of boil that fill the lane; what is more is cut off."""
CALM = "#8a8a8a"
"""The colour of boil that is not seen; beyond the line it is that of doubt, and higher."""


class BoilBand(TippedWidget):
    """The most that any of the shapes in hand boils, as a bar on each frame. A frame is a click away.

    It keeps its place where nothing is tracked, so that nothing jumps.
    """

    def __init__(self, document: Document, axis: TimeAxis, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document, self._axis, self._boil = document, axis, boil_of_document(document)
        self._most = np.empty((0, 2))
        self._scrubs = False
        self.setFixedHeight(HEIGHT)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        for signal in (document.changed, document.replaced, axis.view_state.selection_changed, self._boil.changed):
            signal.connect(self._pull)
        for signal in (axis.changed, axis.view_state.frame_changed):
            signal.connect(self.update)
        self._pull()

    def sizeHint(self) -> QSize:
        return QSize(600, HEIGHT)

    @property
    def most(self) -> Array:
        """What is shown: pairs (frame, pixels) `(K, 2)`."""
        return self._most

    def tip_at(self, at: QPointF) -> str:
        """What is said of the frame under the pointer."""
        frame = self._axis.scale.frame(at.x())
        told = [(boil[boil[:, 0] == frame, 1].tolist(), shape.name) for shape, boil in self._boil.so_far(self._shown())]
        known = sorted(((value, name) for values, name in told for value in values), reverse=True)
        lines = [
            tr("{pixels:.1f} px  {name}, boils", pixels=value, name=name)
            if value >= BOILING
            else tr("{pixels:.1f} px  {name}", pixels=value, name=name)
            for value, name in known
        ]
        return frame_tip(frame, lines, tr("No boil is measured here"))

    # ---- events

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self._scrubs = event.position().x() >= LABEL_WIDTH
            if self._scrubs:
                self._axis.scrub(event.position().x())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton and self._scrubs:
            self._axis.scrub(event.position().x())

    def wheelEvent(self, event: QWheelEvent) -> None:
        self._axis.wheel(event, event.position().x())

    # ---- the rest is private

    def _shown(self) -> list[RotoShape]:
        return list(shapes_in_hand(self._document.project, self._axis.view_state.selection))

    def _bars(self, scale: TimeScale) -> Array:
        """Where bars stand, and their values `(K, 2)`: of the frames that share a pixel the one that boils most."""
        frames, values = self._most.T
        seen = (frames >= scale.first - 1) & (frames <= scale.last + 1)
        x = scale.left + (frames[seen] - scale.first + 0.5) * scale.pixels
        if scale.pixels < 1.0:
            x = np.floor(x) + 0.5
        return on_each_frame(np.maximum, [np.column_stack([x, values[seen]])])

    def _pull(self, _ids: object = None) -> None:
        self._most = on_each_frame(np.maximum, [boil for _, boil in self._boil.so_far(self._shown())])
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(style.PANEL))
        painter.fillRect(QRectF(0, 0, self.width(), 1), QColor(style.WINDOW))
        painter.setFont(style.small(self.font()))
        painter.setPen(QColor(style.WEAK))
        middle, right = Qt.AlignmentFlag.AlignVCenter, Qt.AlignmentFlag.AlignRight
        painter.drawText(QRectF(style.MARGIN, 0, LABEL_WIDTH, HEIGHT), middle, tr("boil"))
        line = _y(BOILING)
        painter.drawText(QRectF(0, line - 8, LABEL_WIDTH - 6, 16), middle | right, tr("{pixels:g} px", pixels=BOILING))
        scale = self._axis.scale
        painter.setClipRect(QRectF(scale.left, 0, self.width() - scale.left, HEIGHT))
        width, doubt, calm = max(scale.pixels - 1.0, 1.0), QColor(style.DOUBT), QColor(CALM)
        for x, value in self._bars(scale).tolist():
            top = _y(value)
            painter.fillRect(QRectF(x - width / 2, top, width, HEIGHT - top), doubt if value >= BOILING else calm)
        painter.setPen(QPen(QColor(style.DISABLED), 1, Qt.PenStyle.DashLine))
        painter.drawLine(QLineF(scale.left, line, self.width(), line))
        painter.setClipping(False)
        paint_playhead(painter, self._axis, self)
        painter.end()


def _y(pixels: float) -> float:
    """Where so many pixels of boil lie in the lane, from its top."""
    return HEIGHT * (1.0 - min(pixels / TOP, 1.0))
