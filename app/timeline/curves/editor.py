"""The curve editor: what is shown on the left with its scale, and right of it the curves, under the ruler's frames."""

from __future__ import annotations

from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QShowEvent
from PySide6.QtWidgets import QButtonGroup, QHBoxLayout, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from ... import style
from ...model.document import Document
from ...translation import N_, number, tr
from ..axis import TimeAxis
from ..scale import LABEL_WIDTH
from ..values.selection import ValueSelection
from ..values.shown import SHOWN_AS, Kind
from .plot import CurvePlot

LEAST_HEIGHT = 150
CHOICES_WIDTH = 84
TITLES = {Kind.OPACITY: N_("Opacity"), Kind.FEATHER: N_("Feather"), Kind.X: N_("Position x"), Kind.Y: N_("Position y")}
TIPS = {
    Kind.OPACITY: N_("Opacity of the selected shapes and layers, in percent"),
    Kind.FEATHER: N_("Feather of the selected shapes, in pixels"),
    Kind.X: N_("Where the selected points are, or the whole shape, from the left edge, in pixels"),
    Kind.Y: N_("Where the selected points are, or the whole shape, from the top edge, in pixels"),
}


class CurveEditor(QWidget):
    """One kind of curve at a time, of the shapes and layers in hand."""

    def __init__(
        self, document: Document, axis: TimeAxis, chosen: ValueSelection, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.plot = CurvePlot(document, axis, chosen)
        self.plot.setMinimumHeight(LEAST_HEIGHT)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.choices = QButtonGroup(self)
        column = QVBoxLayout()
        column.setContentsMargins(4, 4, 0, 4)
        column.setSpacing(1)
        for index, kind in enumerate(Kind):
            button = QToolButton()
            button.setText(tr(TITLES[kind]))
            button.setToolTip(tr(TIPS[kind]))
            button.setObjectName("flat")
            button.setCheckable(True)
            button.setChecked(kind is Kind.OPACITY)
            button.setFixedSize(CHOICES_WIDTH, 22)
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
            self.choices.addButton(button, index)
            column.addWidget(button)
        column.addStretch(1)
        self.choices.idClicked.connect(lambda index: self.show_kind(list(Kind)[index]))
        side = QWidget()
        side.setFixedWidth(CHOICES_WIDTH + 6)
        side.setLayout(column)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(0)
        row.addWidget(side)
        row.addSpacing(LABEL_WIDTH - CHOICES_WIDTH - 6)
        row.addWidget(self.plot, 1)
        self.plot.range_changed.connect(self.update)

    def sizeHint(self) -> QSize:
        return QSize(600, 2 * LEAST_HEIGHT)

    def give(self, pixels: int) -> None:
        """Let others have so much of the least height."""
        self.plot.setMinimumHeight(LEAST_HEIGHT - pixels)

    def show_kind(self, kind: Kind) -> None:
        """Show another kind of curves."""
        self.choices.button(list(Kind).index(kind)).setChecked(True)
        self.plot.show_kind(kind)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.plot.fit()

    def paintEvent(self, event: QPaintEvent) -> None:
        """The values of the grid's lines, right beside the plot."""
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(style.PANEL))
        painter.setFont(style.small(self.font()))
        painter.setPen(QColor(style.WEAK))
        flags = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignRight
        unit = SHOWN_AS[self.plot.kind][1]
        for value in self.plot.grid():
            y = self.plot.key_point(0, value).y()
            painter.drawText(
                QRectF(CHOICES_WIDTH, y - 8, LABEL_WIDTH - CHOICES_WIDTH - 6, 16), flags, f"{number(value)} {unit}"
            )
        painter.end()
