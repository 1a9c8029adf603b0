"""The status bar: what is going on, how far, how to stop it; otherwise what to do next, or what went wrong."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QProgressBar, QWidget

from ... import style
from ...jobs.runner import Ending
from ...jobs.under_way import UnderWay
from ...model.document import Document
from ...model.view_state import ViewState
from ...translation import N_, tr
from ...widgets.controls import icon_button
from ...widgets.more import least_width
from .readout import Readout

LEAST_SENTENCE, BAR_WIDTH, GAP = 100, 120, 12
"""Widths of the sentence, however narrow the window, and of the bar; between the parts: in widget units."""
READING = 4000
"""Milliseconds for which what is said stands where something else would take its place."""
MEMORY = N_("memory {used} of {limit}")


class Sentence(QLabel):
    """A line of text, an ellipsis in its middle where it lacks room: its end tells what is wrong with a path.

    What it says is in its tip as a whole.
    """

    def minimumSizeHint(self) -> QSize:
        return QSize(LEAST_SENTENCE, super().minimumSizeHint().height())

    @property
    def whole(self) -> int:
        """The width in which all of it is read."""
        return max(LEAST_SENTENCE, self.fontMetrics().horizontalAdvance(self.text()))

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter, place = QPainter(self), self.contentsRect()
        text = self.fontMetrics().elidedText(self.text(), Qt.TextElideMode.ElideMiddle, place.width())
        self.style().drawItemText(
            painter, place, self.alignment().value, self.palette(), self.isEnabled(), text, self.foregroundRole()
        )
        painter.end()


class StatusBar(QWidget):
    """One sentence; while work is under way a bar, a button that stops it and how many more go on; frames' memory.

    The sentence comes first: what is under way is read as a whole, and what else does not fit beside it is away. The
    button that stops it is always there, and nothing here makes the window wider. What is said meanwhile stands long
    enough to be read, while the bar goes on, and before the sentence with which the work ends.
    """

    said = Signal(str)
    """The sentence is another one."""

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
        self._readout: Readout | None = None
        self._modes: QWidget | None = None
        self._longest = LEAST_SENTENCE
        """The room that the sentences of this work took so far: nothing comes and goes with the length of each."""
        self._work = ""
        """What was told last of the work under way; empty where that ended."""
        self.reading = QTimer(self, singleShot=True, interval=READING)
        self.reading.timeout.connect(self._tell_on)
        self._build()
        view_state.message_changed.connect(lambda: self._show_message(view_state.message))
        under_way.progress.connect(self._show_progress)
        under_way.ended.connect(self._show_end)
        under_way.changed.connect(self._pull)

    def _build(self) -> None:
        self.sentence.setObjectName("sentence")
        self.sentence.setTextFormat(Qt.TextFormat.PlainText)
        self.bar.setRange(0, 1000)
        self.bar.setTextVisible(False)
        self.bar.setFixedWidth(BAR_WIDTH)
        row = QHBoxLayout(self)
        row.setContentsMargins(style.MARGIN, 0, style.MARGIN, 0)
        row.setSpacing(GAP)
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
        self._work = text
        if not self.reading.isActive():
            self._say(text)

    def _show_message(self, text: str) -> None:
        if self.reading.isActive() and self._view.can_wait:
            return  # a run of one frame is over before that is read which it left out
        self.reading.stop()
        if not self._under_way.is_any:
            self._say(text)
        elif text and not self._view.is_left:
            self._say(text)
            self.reading.start()
        else:
            self._tell_on()

    def _tell_on(self) -> None:
        """Tell what goes on; where nothing does, what was said last."""
        if not self._under_way.is_any:
            self._say(self._view.message)
        elif self._work:
            self._say(self._work)

    def _show_end(self, ending: Ending, sentence: str) -> None:
        self._work = ""
        if sentence or ending is not Ending.DONE:
            self.tell_end(ending, sentence)
        elif not self._under_way.is_any:
            self._say(self._view.message)  # that something is being looked at is over

    def tell_end(self, ending: Ending, sentence: str) -> None:
        """Tell how work ended; what is being read stands first, unless it was stopped or failed."""
        self._view.say(sentence, can_wait=ending is Ending.DONE)

    def add(self, readout: Readout, modes: QWidget) -> None:
        """Give them places of their own: the read-out right of the sentence, the modes at the right end.

        So the modes stay where they are, whatever the read-out tells and whether work is under way or not.
        """
        row = self.layout()
        assert isinstance(row, QHBoxLayout)
        row.insertWidget(1, readout)
        row.addWidget(modes)
        self._readout, self._modes = readout, modes
        modes.installEventFilter(self)
        self._fit()

    def follow(self, document: Document) -> None:
        """Let what was said of something before go with the artist's next edit; frames of a run are none."""
        document.changed.connect(self._go_on)

    def _go_on(self, _ids: object) -> None:
        if not self._under_way.is_any:
            self._view.go_on()

    def show_memory(self, used: int, limit: int) -> None:
        """Tell how much of the frame cache is used, in bytes."""
        self._memory.setText(tr(MEMORY, used=_size(used), limit=_size(limit)) if limit else "")

    def show_stop_keys(self, keys: str) -> None:
        """Tell which keys stop what is under way."""
        self._stop_keys = keys
        self._pull()

    def _pull(self) -> None:
        more = self._under_way.count - 1
        keys = self._stop_keys if self._under_way.is_stopped_by_key else ""
        stops = tr("{keys} stops", keys=keys) if keys else ""
        self.stop.setToolTip(
            tr("Stop; what is finished stays  ({keys})", keys=keys) if keys else tr("Stop; what is finished stays")
        )
        self.stop.setAccessibleName(self.stop.toolTip())
        self._hint.setText("  ·  ".join(filter(None, [stops, tr("{count} more", count=more) if more > 0 else ""])))
        self._fit()

    def _say(self, text: str) -> None:
        self.sentence.setText(text)
        self.sentence.setToolTip(text)
        self._fit()
        self.said.emit(text)

    # ---- what has room

    def minimumSizeHint(self) -> QSize:
        """As wide as what never gives way, with work under way or without."""
        parts = [least_width(part) for part in (self.stop, self._modes) if part is not None]
        width = 2 * style.MARGIN + LEAST_SENTENCE + sum(GAP + part for part in parts)
        return QSize(width, self.minimumHeight())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.LayoutRequest:  # the modes have another field, or less
            self._fit()
        return False

    def _fit(self) -> None:
        """Show what has room beside the sentence, what matters more before what matters less."""
        is_any = self._under_way.is_any
        if not is_any:
            self._longest = LEAST_SENTENCE
        elif self._work:  # until it tells something, what was said before it stands there
            self._longest = max(self._longest, self.sentence.whole)
        room = self.width() - self.minimumSizeHint().width() - (self._longest - LEAST_SENTENCE)
        widths: dict[QWidget, int] = {self.bar: BAR_WIDTH} if is_any else {}
        if self._readout is not None:
            widths[self._readout] = self._readout.widest
        widths |= {label: least_width(label) for label in ((self._memory, self._hint) if is_any else (self._memory,))}
        shown: set[QWidget | None] = {self.stop} if is_any else set()
        for part, width in widths.items():
            # At rest the frames' memory is worth less than the end of the sentence.
            kept = 0 if is_any or part is not self._memory else self.sentence.whole - LEAST_SENTENCE
            if GAP + width <= room - kept:
                room -= GAP + width
                shown.add(part)
        for each in (self.stop, self.bar, self._hint, self._memory, self._readout):
            if each is not None:
                each.setVisible(each in shown)


def _size(count: int) -> str:
    """Bytes in the unit that shows a single frame of a small plate as well as a full cache."""
    if count >= 2**30:
        return tr("{size:.1f} GB", size=count / 2**30)
    megabytes = count / 2**20
    return tr("{size:.1f} MB", size=megabytes) if 0.0 < megabytes < 9.95 else tr("{size:.0f} MB", size=megabytes)
