"""The full-screen viewer: the picture alone on the whole screen; every tool and key goes on working."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from PySide6.QtCore import QEvent, QObject, Qt, QTimer
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QLabel, QWidget

from .. import style
from ..panels.bars.status import READING, StatusBar


class Told(QLabel):
    """What the status bar says, over the lower edge of the viewer while `action` shows that alone: until it is read."""

    def __init__(self, status: StatusBar, action: QAction, viewer: QWidget) -> None:
        super().__init__(viewer)
        self._action, self._viewer = action, viewer
        self.setObjectName("told")
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setWordWrap(True)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.hide()
        self.reading = QTimer(self, singleShot=True, interval=READING)
        self.reading.timeout.connect(self.hide)
        status.said.connect(self._tell)
        action.toggled.connect(self.hide)
        viewer.installEventFilter(self)

    def _tell(self, text: str) -> None:
        if not text or not self._action.isChecked():
            self.hide()
            return
        self.setText(text)
        self._place()
        self.show()
        self.raise_()
        self.reading.start()

    def _place(self) -> None:
        margin, room = 2 * style.MARGIN, self._viewer.width() - 4 * style.MARGIN
        width = min(self.fontMetrics().horizontalAdvance(self.text()) + margin, room)
        height = self.heightForWidth(width)
        self.setGeometry((self._viewer.width() - width) // 2, self._viewer.height() - height - margin, width, height)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        if event.type() is QEvent.Type.Resize and self.isVisible():
            self._place()
        return False


class FullScreen(QObject):
    """Hides what lies about the viewer of `window` while `action` is on.

    `around` are hidden for as long as it lasts. What `switches` gives is switched off as it begins and put back at its
    end: what they show may be called in meanwhile.
    """

    def __init__(
        self,
        window: QWidget,
        action: QAction,
        around: Iterable[QWidget | None],
        switches: Callable[[], Iterable[QAction]],
    ) -> None:
        super().__init__(window)
        self._window, self._action, self._switches = window, action, switches
        self._around = [part for part in around if part is not None]
        self._before: dict[QAction, bool] = {}
        action.toggled.connect(self._pull)

    @property
    def is_on(self) -> bool:
        return self._action.isChecked()

    def leave(self) -> None:
        """Show the window as it was; nothing where it is shown so."""
        self._action.setChecked(False)

    def _pull(self, on: bool) -> None:
        if on:
            self._before = {switch: switch.isChecked() for switch in self._switches()}
        for part in self._around:
            part.setVisible(not on)
        for switch, was_on in self._before.items():
            switch.setChecked(was_on and not on)
        whole = Qt.WindowState.WindowFullScreen
        state = self._window.windowState()
        self._window.setWindowState(state | whole if on else state & ~whole)
