"""The wipe: a pinned state of the viewer left of a line, the present one right of it; the line is dragged."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, QPointF, QRectF, QSizeF, Signal
from PySide6.QtGui import QFontMetricsF, QPainter, QPen, QPolygonF

from ..model.viewing import title_of
from ..paint import marks
from ..translation import N_, tr
from .view_snapshot import ViewSnapshot

REACH = 5.0
"""Half the width of the line's hit area, in widget units."""
EDGE = 12.0
"""The line stays so far inside of the widget that it can be grabbed again."""
HANDLE = QSizeF(11.0, 7.0)
"""Half the size of the mark that says that the line can be dragged."""


NOTHING = N_("There is nothing to compare yet; open a clip first.")
NOT_YET = N_("The picture of this frame is still being made; pin it once it is there.")


class Wipe(QObject):
    """Holds the pinned state A and where the line is, as a share of the widget's width.

    `present` gives what is shown now, `say` tells the artist a sentence.

    Signals
    -------
    changed() : it began, ended, or the line moved.
    """

    changed = Signal()

    def __init__(
        self, present: Callable[[], ViewSnapshot], say: Callable[[str], object], parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._present, self._say = present, say
        self.pinned: ViewSnapshot | None = None
        """What is shown left of the line; None where nothing is compared."""
        self.position = 0.5
        self.is_held = False

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"view.wipe": self.toggle, "view.pin": self.pin}

    def toggle(self) -> None:
        """Compare what is shown now with what will be; or end the comparison."""
        self.pin() if self.pinned is None else self.end()

    def pin(self) -> None:
        """Keep what is shown now as A, left of the line."""
        snapshot = self._present()
        if snapshot.image is None:
            self._say(tr(NOTHING))
        elif not snapshot.is_whole:
            self._say(tr(NOT_YET))
        else:
            self.pinned = snapshot
        self.changed.emit()

    def end(self) -> None:
        """Show the present state alone."""
        self.pinned, self.is_held = None, False
        self.changed.emit()

    def line(self, widget: QSizeF) -> float:
        """Where the line stands, in widget units from the left."""
        return min(max(self.position * widget.width(), EDGE), max(widget.width() - EDGE, EDGE))

    def is_under(self, position: QPointF, widget: QSizeF) -> bool:
        """True where a press grabs the line."""
        return self.pinned is not None and abs(position.x() - self.line(widget)) <= REACH

    def move(self, position: QPointF, widget: QSizeF) -> None:
        """Put the line under the pointer."""
        self.position = min(max(position.x() / max(widget.width(), 1.0), 0.0), 1.0)
        self.changed.emit()

    def left(self, widget: QSizeF) -> QRectF:
        """The part of the widget that shows A."""
        return QRectF(0.0, 0.0, round(self.line(widget)), widget.height())

    def paint(self, painter: QPainter, widget: QSizeF, present: ViewSnapshot) -> None:
        """Paint the line with its handle, and what stands on either side of it."""
        if self.pinned is None:
            return
        x = float(round(self.line(widget)))
        for colour, thickness in ((marks.EDGE, 3.0), (marks.TEXT, 1.0)):
            pen = QPen(colour, thickness)
            painter.setPen(pen)
            painter.drawLine(QPointF(x, 0.0), QPointF(x, widget.height()))
        self._paint_handle(painter, QPointF(x, widget.height() / 2))
        metrics = QFontMetricsF(painter.font())
        for letter, snapshot, is_left in (("A", self.pinned, True), ("B", present, False)):
            text = f"{letter}   {snapshot.frame}   {title_of(snapshot.mode)}"
            box = QRectF(0.0, 8.0, metrics.horizontalAdvance(text) + 12.0, metrics.height() + 6.0)
            box.moveLeft(x - 6.0 - box.width() if is_left else x + 6.0)
            marks.label(painter, box, text)

    def _paint_handle(self, painter: QPainter, at: QPointF) -> None:
        """Two triangles that point aside."""
        painter.setPen(QPen(marks.EDGE, 1.0))
        painter.setBrush(marks.ACCENT if self.is_held else marks.TEXT)
        for side in (-1.0, 1.0):
            tip = at + QPointF(side * HANDLE.width(), 0.0)
            foot = at.x() + side * 3.0
            ends = QPointF(foot, at.y() - HANDLE.height()), QPointF(foot, at.y() + HANDLE.height())
            painter.drawPolygon(QPolygonF([tip, *ends]))
