"""RowBand: rows of one height below the ruler, one a thing that goes with time; there while there are any."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Generic, TypeVar

from PySide6.QtCore import QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QWheelEvent
from PySide6.QtWidgets import QFrame, QScrollArea, QSizePolicy, QWidget

from .. import style
from ..model.document import Document
from ..widgets.tipped import TippedWidget
from .axis import TimeAxis, paint_focus, paint_playhead
from .keys.row_painter import ROW, frames_room, marks_room
from .scale import LABEL_WIDTH

Row = TypeVar("Row")


class RowBand(TippedWidget, Generic[Row]):
    """A class of its own says what is shown (`rows`), how a row is painted and what is told of a place (`tip_at`).

    It calls `pull` when it is made, and whenever it may have other rows.

    Signals
    -------
    pulled() : it may have another height, or have come or gone.
    """

    pulled = Signal()

    def __init__(self, document: Document, axis: TimeAxis, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document, self._axis = document, axis
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        for signal in (document.changed, document.replaced, axis.view_state.selection_changed):
            signal.connect(self.pull)
        for signal in (axis.changed, axis.view_state.frame_changed):
            signal.connect(self.update)

    def rows(self) -> Sequence[Row]:
        """What is shown, top row first."""
        raise NotImplementedError

    def paint_row(self, painter: QPainter, row: Row) -> None:
        """Paint a row, its top-left corner at the origin. Its name is there; what lies over it is cut off."""
        raise NotImplementedError

    def paint_keys(self, painter: QPainter, row: Row) -> None:
        """Paint the keys over a row, likewise. That of the first frame is whole, where a frame is less wide, too."""

    def paint_over(self, painter: QPainter) -> None:
        """Paint what lies over the rows; nothing unless a class of its own says so."""

    def name_of(self, row: Row) -> str:
        """What stands in front of a row, shortened where it lacks room."""
        raise NotImplementedError

    def ending_of(self, row: Row) -> str:
        """What follows the name and is never shortened; nothing unless a class of its own says so."""
        return ""

    def row_at(self, y: float) -> Row | None:
        """What has its row at `y` pixels."""
        rows, index = self.rows(), int(y) // ROW
        return rows[index] if 0 <= index < len(rows) else None

    def sizeHint(self) -> QSize:
        return QSize(600, ROW)

    def pull(self, _ids: object = None) -> None:
        """Be as high as there are rows; away where there are none."""
        count = len(self.rows())
        self.setVisible(count > 0)
        self.setFixedHeight(max(count, 1) * ROW)
        self.update()
        self.pulled.emit()

    def wheelEvent(self, event: QWheelEvent) -> None:
        if event.position().x() < LABEL_WIDTH:
            event.ignore()  # over the names it scrolls
        else:
            self._axis.wheel(event, event.position().x())

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(style.PANEL))
        for index, row in enumerate(self.rows()):
            if not event.region().intersects(QRect(0, index * ROW, self.width(), ROW)):
                continue  # it is scrolled out of sight
            painter.save()
            painter.translate(0.0, index * ROW)
            painter.fillRect(QRectF(0, ROW - 1, self.width(), 1), QColor(style.WINDOW))
            painter.setPen(QColor(style.TEXT))
            metrics, ending = painter.fontMetrics(), self.ending_of(row)
            room = LABEL_WIDTH - 34 - metrics.horizontalAdvance(ending)
            name = metrics.elidedText(self.name_of(row), Qt.TextElideMode.ElideMiddle, room) + ending
            painter.drawText(QRectF(22, 0, LABEL_WIDTH - 30, ROW - 1), Qt.AlignmentFlag.AlignVCenter, name)
            painter.setClipRect(frames_room(self._axis.scale, self.width()))
            self.paint_row(painter, row)
            painter.setClipRect(marks_room(self._axis.scale, self.width()))
            self.paint_keys(painter, row)
            painter.restore()
        painter.setClipRect(QRectF(LABEL_WIDTH, 0, self.width() - LABEL_WIDTH, self.height()))
        self.paint_over(painter)
        painter.setClipping(False)
        paint_playhead(painter, self._axis, self)
        paint_focus(painter, self)
        painter.end()


class BandRoom(QScrollArea):
    """The place of a band: as high as the band where there is room, and scrolled where there is not; away with it.

    It takes room for `most` rows at most: what is keyed comes first.
    """

    def __init__(self, band: RowBand[Any], most: int, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._band, self._most = band, most
        self._limit = most
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Maximum)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setWidgetResizable(True)
        self.setWidget(band)
        self.verticalScrollBar().setSingleStep(ROW)
        band.pulled.connect(self._follow)
        band.pull()

    def sizeHint(self) -> QSize:
        return QSize(self._band.sizeHint().width(), self._height)

    def minimumSizeHint(self) -> QSize:
        return QSize(0, 0)

    @property
    def _height(self) -> int:
        return min(self._band.maximumHeight(), min(self._most, self._limit) * ROW)

    @property
    def wanted_rows(self) -> int:
        """The rows for which it would take room."""
        return min(len(self._band.rows()), self._most)

    def limit(self, rows: int) -> int:
        """Take room for so many rows at most, and no more than `most`; gives how many it takes."""
        if rows != self._limit:
            self._limit = rows
            self._follow()
        return 0 if self.isHidden() else self._height // ROW

    def _follow(self) -> None:
        self.setMaximumHeight(self._height)
        self.updateGeometry()
        self.setVisible(not self._band.isHidden())
