"""The key rows: one line a shape, its keys as marks. Paints what it pulls; only what is visible."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPaintEvent, QResizeEvent, QWheelEvent
from PySide6.QtWidgets import QAbstractScrollArea, QFrame, QWidget

from app import style
from app.document import Document
from app.timeline.axis import TimeAxis, paint_playhead
from app.timeline.marks import MarksOf
from app.timeline.row_painter import ROW, RowPainter
from app.timeline.scale import LABEL_WIDTH
from roam_core.roto import RotoShape

GRAB = 6
"""Pixels around a key's middle in which a click means the key."""


class KeyRows(QAbstractScrollArea):
    """Click a key to go there, a name to select its shape, anything else to scrub; wheel zooms."""

    def __init__(self, document: Document, axis: TimeAxis, marks: MarksOf, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document, self._axis, self._marks = document, axis, marks
        self._painter = RowPainter(marks)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._pull_height()
        document.changed.connect(self._pull)
        document.replaced.connect(self._pull)
        axis.changed.connect(self.viewport().update)
        axis.view_state.frame_changed.connect(self.viewport().update)
        axis.view_state.selection_changed.connect(self._show_selected)

    def sizeHint(self) -> QSize:
        return QSize(600, 3 * ROW)

    def rows(self) -> list[RotoShape]:
        """The shapes from the top row down: the top-most first."""
        return list(reversed(self._document.project.shapes))

    def shape_at(self, y: float) -> RotoShape | None:
        """The shape whose row lies at `y` pixels of the viewport, or None."""
        index, rows = int(y + self._offset) // ROW, self.rows()
        return rows[index] if 0 <= index < len(rows) else None

    # ---- events

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._pull()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton:
            return
        position, shape = event.position(), self.shape_at(event.position().y())
        if shape is not None and position.x() < LABEL_WIDTH:
            self._select(shape, event.modifiers())
        elif shape is not None and (frame := self._key_near(shape, position.x())) is not None:
            self._select(shape, event.modifiers())
            self._axis.view_state.set_frame(frame)
        elif position.x() >= LABEL_WIDTH:
            self._axis.scrub(event.position().x())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton and event.position().x() >= LABEL_WIDTH:
            self._axis.scrub(event.position().x())

    def wheelEvent(self, event: QWheelEvent) -> None:
        if event.position().x() < LABEL_WIDTH:
            super().wheelEvent(event)
        else:
            self._axis.wheel(event, event.position().x())

    # ---- the rest is private

    @property
    def _offset(self) -> int:
        return self.verticalScrollBar().value()

    def _pull_height(self) -> None:
        """No taller than the rows: what is left belongs to the plot below. At least two rows stay in sight."""
        rows = max(len(self._document.project.shapes), 1)
        self.setMinimumHeight(min(rows, 2) * ROW)
        self.setMaximumHeight(rows * ROW)

    def _pull(self) -> None:
        self._pull_height()
        bar, height = self.verticalScrollBar(), self.viewport().height()
        bar.setPageStep(height)
        bar.setSingleStep(ROW)
        bar.setRange(0, max(len(self._document.project.shapes) * ROW - height, 0))
        self.viewport().update()

    def _show_selected(self) -> None:
        """Scroll by as little as brings a selected row into sight, if none is."""
        chosen, height = self._axis.view_state.selection.shapes, self.viewport().height()
        tops = [index * ROW - self._offset for index, shape in enumerate(self.rows()) if shape.id in chosen]
        if tops and not any(0 <= top <= height - ROW for top in tops):
            self.verticalScrollBar().setValue(self._offset + (tops[0] if tops[0] < 0 else tops[0] + ROW - height))
        self.viewport().update()

    def _select(self, shape: RotoShape, modifiers: Qt.KeyboardModifier) -> None:
        view = self._axis.view_state
        adds = modifiers & (Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.ControlModifier)
        view.select(view.selection.shapes ^ {shape.id} if adds else frozenset({shape.id}))

    def _key_near(self, shape: RotoShape, x: float) -> int | None:
        """The artist key under a pixel, so that a click need not be exact."""
        scale, artist = self._axis.scale, self._marks(shape).artist
        if not len(artist):
            return None
        distances = np.abs(scale.left + (artist - scale.first + 0.5) * scale.pixels - x)
        nearest = int(distances.argmin())
        return int(artist[nearest]) if distances[nearest] <= GRAB else None

    # ---- painting

    def paintEvent(self, event: QPaintEvent) -> None:
        viewport, selected = self.viewport(), self._axis.view_state.selection.shapes
        painter = QPainter(viewport)
        painter.fillRect(viewport.rect(), QColor(style.PANEL))
        rows = self.rows()
        first = self._offset // ROW
        last = min((self._offset + viewport.height()) // ROW + 1, len(rows))
        size = QSize(viewport.width(), ROW)
        for index in range(first, last):
            row = self._painter.row(rows[index], self._axis.scale, size, rows[index].id in selected, viewport)
            painter.drawPixmap(0, index * ROW - self._offset, row)
        if not rows:
            self._paint_hint(painter)
        paint_playhead(painter, self._axis, viewport)
        painter.end()

    def _paint_hint(self, painter: QPainter) -> None:
        painter.setPen(QColor(style.WEAK))
        box = QRectF(LABEL_WIDTH + style.MARGIN, 0, self.viewport().width() - LABEL_WIDTH, ROW)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, "The keys of your shapes appear here.")
