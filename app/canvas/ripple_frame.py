"""RippleFrame: the red frame around the viewer while an edit reaches more keys than the one in sight."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QRect, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QRegion
from PySide6.QtWidgets import QWidget

from ..model.view_state import ViewState
from ..translation import tr

RED = QColor("#d83a34")
WIDTH, TAB_HEIGHT = 3, 20


class RippleFrame(QWidget):
    """Lies over `viewer`, follows its size and lets every event through. It says how far the ripple reaches."""

    def __init__(self, view_state: ViewState, viewer: QWidget) -> None:
        super().__init__(viewer)
        self._view, self._viewer = view_state, viewer
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        viewer.installEventFilter(self)
        view_state.editing.changed.connect(self._pull)
        view_state.range_changed.connect(self._pull)
        self._pull()

    @property
    def words(self) -> str:
        first, stop = self._view.play_range
        return tr("Ripple: edits change all keys {first}–{last}", first=first, last=stop - 1)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() is QEvent.Type.Resize:
            self._lay_out()
        return False

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), RED)
        painter.setPen(QColor("#ffffff"))
        painter.drawText(self._tab(), Qt.AlignmentFlag.AlignCenter, self.words)
        painter.end()

    def _pull(self) -> None:
        self.setVisible(self._view.editing.modes.ripple)
        self._lay_out()
        self.update()

    def _lay_out(self) -> None:
        """Only the frame and its tab are painted: the picture under the rest is not covered."""
        self.setGeometry(self._viewer.rect())
        inside = self.rect().adjusted(WIDTH, WIDTH, -WIDTH, -WIDTH)
        self.setMask(QRegion(self.rect()).subtracted(QRegion(inside)).united(QRegion(self._tab())))

    def _tab(self) -> QRect:
        """Where the words stand: in the frame's lower left corner, which the viewer leaves free."""
        width = self.fontMetrics().horizontalAdvance(self.words) + 20
        return QRect(0, self.height() - TAB_HEIGHT - WIDTH, width, TAB_HEIGHT + WIDTH)
