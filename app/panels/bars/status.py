"""The status bar: what is going on, how far, how to stop it; otherwise what to do next, or what went wrong."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QProgressBar, QWidget

from ... import style
from ...jobs.runner import Ending
from ...jobs.under_way import UnderWay
from ...model.view_state import ViewState
from ...translation import N_, tr
from ...widgets.controls import icon_button

MEMORY = N_("memory {used} of {limit}")


class Sentence(QLabel):
    """A line of text that ends in an ellipsis where it lacks room; what it says is in its tip as a whole."""

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter, place = QPainter(self), self.contentsRect()
        text = self.fontMetrics().elidedText(self.text(), Qt.TextElideMode.ElideRight, place.width())
        self.style().drawItemText(
            painter, place, self.alignment().value, self.palette(), self.isEnabled(), text, self.foregroundRole()
        )
        painter.end()


class StatusBar(QWidget):
    """One sentence; while work is under way a bar, a button that stops it and how many more go on; frames' memory."""

    def __init__(self, view_state: ViewState, under_way: UnderWay, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._view, self._under_way = view_state, under_way
        self.setObjectName("statusBar")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setFixedHeight(26)
        self.sentence, self._hint, self._memory = Sentence(), QLabel(), QLabel()
        self.bar = QProgressBar()
        self.stop = icon_button("track-stop", "", size=20)
        self.stop.clicked.connect(under_way.stop)
        self._stop_keys = ""
        self._build()
        view_state.message_changed.connect(lambda: self._say(view_state.message))
        under_way.progress.connect(self._show_progress)
        under_way.ended.connect(self._show_end)
        under_way.changed.connect(self._pull)

    def _build(self) -> None:
        self.sentence.setObjectName("sentence")
        self.sentence.setTextFormat(Qt.TextFormat.PlainText)
        self.sentence.setMinimumWidth(100)
        self.bar.setRange(0, 1000)
        self.bar.setTextVisible(False)
        self.bar.setFixedWidth(120)
        row = QHBoxLayout(self)
        row.setContentsMargins(style.MARGIN, 0, style.MARGIN, 0)
        row.setSpacing(12)
        row.addWidget(self.sentence, 1)
        for label in (self._hint, self._memory):
            label.setObjectName("weak")
        for widget in (self.bar, self.stop, self._hint, self._memory):
            row.addWidget(widget)
        # As wide as it ever gets: what stands beside it does not move while frames come in.
        self._memory.setMinimumWidth(
            self._memory.fontMetrics().horizontalAdvance(tr(MEMORY, used="888.8 MB", limit="88.8 GB"))
        )
        self._memory.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self._pull()

    def _show_progress(self, fraction: float, text: str) -> None:
        self.bar.setValue(round(1000 * fraction))
        self._say(text)

    def _show_end(self, ending: Ending, sentence: str) -> None:
        if sentence or ending is not Ending.DONE:
            self._view.say(sentence)

    def add(self, widget: QWidget) -> None:
        """Give a widget a place of its own, right of the sentence."""
        row = self.layout()
        assert isinstance(row, QHBoxLayout)
        row.insertWidget(1, widget)

    def show_memory(self, used: int, limit: int) -> None:
        """Tell how much of the frame cache is used, in bytes."""
        self._memory.setText(tr(MEMORY, used=_size(used), limit=_size(limit)) if limit else "")

    def show_stop_keys(self, keys: str) -> None:
        """Tell which keys stop what is under way."""
        self._stop_keys = keys
        self.stop.setToolTip(
            tr("Stop; what is finished stays  ({keys})", keys=keys) if keys else tr("Stop; what is finished stays")
        )
        self.stop.setAccessibleName(self.stop.toolTip())
        self._pull()

    def _pull(self) -> None:
        more = self._under_way.count - 1
        stops = tr("{keys} stops", keys=self._stop_keys) if self._stop_keys else ""
        self._hint.setText("  ·  ".join(filter(None, [stops, tr("{count} more", count=more) if more > 0 else ""])))
        for widget in (self.bar, self.stop, self._hint):
            widget.setVisible(self._under_way.is_any)

    def _say(self, text: str) -> None:
        self.sentence.setText(text)
        self.sentence.setToolTip(text)


def _size(count: int) -> str:
    """Bytes in the unit that shows a single frame of a small plate as well as a full cache."""
    if count >= 2**30:
        return tr("{size:.1f} GB", size=count / 2**30)
    megabytes = count / 2**20
    return tr("{size:.1f} MB", size=megabytes) if 0.0 < megabytes < 9.95 else tr("{size:.0f} MB", size=megabytes)
