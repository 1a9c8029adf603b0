"""The band of marks under the ruler: flags on frames with the note on each; there only while there are marks."""

from __future__ import annotations

from itertools import pairwise

from PySide6.QtCore import QEvent, QObject, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPolygonF, QWheelEvent
from PySide6.QtWidgets import QApplication, QLineEdit, QSizePolicy, QWidget

from roam_core.roto import Mark, Project, timing

from .. import style
from ..model.document import Document
from ..translation import tr
from ..widgets.focus import KEEPS_KEYBOARD, takes_key
from ..widgets.tipped import TippedWidget
from .axis import TimeAxis, paint_playhead
from .mark_verbs import remove
from .scale import LABEL_WIDTH

HEIGHT = 18
FLAG = 4.0
"""Half the width of a flag."""
GRAB, STILL = 7, 3
"""Pixels around a mark in which a press means it; that the pointer may move within a click."""
FIELD_WIDTH = 160
COLOUR = "#9ec5f0"
"""Of no shape and of no state."""


class MarkBand(TippedWidget):
    """Click a mark to go there, drag it along the frames, double-click to write its note, right-click to remove it."""

    def __init__(self, document: Document, axis: TimeAxis, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document, self._axis = document, axis
        self._held: Mark | None = None
        self._pressed, self._pressed_time, self._scrubs = QPointF(), 0.0, False
        self._target: int | None = None
        """The frame on which the held mark would come to lie; None before it is dragged."""
        self.setFixedHeight(HEIGHT)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.field = MarkField(self)
        self.setMouseTracking(True)
        document.changed.connect(self._pull)
        document.replaced.connect(self._pull)
        document.replaced.connect(self.field.leave)
        document.replaced.connect(self._let_go)
        for signal in (axis.changed, axis.view_state.frame_changed):
            signal.connect(self.update)
        self._pull()

    def sizeHint(self) -> QSize:
        return QSize(600, HEIGHT)

    def edit(self, frame: int) -> None:
        """Show the field in which the mark of a frame is named, beside its flag."""
        self.field.keep()  # the note of another frame may be half typed
        mark = timing.mark_at(self._document.project, frame)
        if mark is not None:
            left = min(self._axis.scale.x(frame) + FLAG + 2, self.width() - FIELD_WIDTH - 2)
            self.field.begin(mark, max(left, LABEL_WIDTH))

    def rename(self, frame: int, text: str) -> None:
        """Put another word on the mark of a frame."""
        mark = timing.mark_at(self._document.project, frame)
        if mark is not None and mark.text and not text:
            self._document.apply(tr("Remove note"), timing.remove_mark(self._document.project, frame))
        elif mark is not None and mark.text != text:
            self._document.apply(tr("Write note"), timing.set_mark(self._document.project, frame, text))

    def mark_at(self, x: float) -> Mark | None:
        """The mark near a pixel, or None."""
        marks = self._document.project.marks
        distance, frame = self._axis.scale.nearest([mark.frame for mark in marks], x)
        return next((mark for mark in marks if mark.frame == frame), None) if distance <= GRAB else None

    # ---- events

    def mousePressEvent(self, event: QMouseEvent) -> None:
        mark = self.mark_at(event.position().x())
        if self._held is not None:
            return  # another button, as that of a pen, while one is dragged
        if event.button() == Qt.MouseButton.RightButton and mark is not None:
            remove(self._document, self._axis.view_state, mark)
        elif event.button() == Qt.MouseButton.LeftButton:
            self._held, self._target, self._pressed = mark, None, event.position()
            self._pressed_time = self._axis.scale.time(self._pressed.x())
            self._scrubs = mark is None and self._pressed.x() >= LABEL_WIDTH
            if mark is not None:
                self._axis.view_state.set_frame(mark.frame)
            elif self._scrubs:
                self._axis.scrub(self._pressed.x())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        x = event.position().x()
        if not event.buttons() & Qt.MouseButton.LeftButton:
            over = self.mark_at(x) is not None
            self.setCursor(Qt.CursorShape.SizeHorCursor if over else Qt.CursorShape.ArrowCursor)
        elif self._held is not None:
            if self._target is not None or (event.position() - self._pressed).manhattanLength() > STILL:
                self._drag(self._held, x)
        elif self._scrubs:
            self._axis.scrub(x)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """What was dragged is one undo step."""
        if event.button() != Qt.MouseButton.LeftButton:
            return
        moved = self._moved()
        self._let_go()
        self._document.apply(tr("Move mark"), moved)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if (mark := self.mark_at(event.position().x())) is not None:
            self.edit(mark.frame)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Esc drops the drag of a mark: the keyboard stays where it is, and there Esc would stop a run."""
        kinds = QEvent.Type.ShortcutOverride, QEvent.Type.KeyPress
        if event.type() not in kinds or not isinstance(event, QKeyEvent) or event.key() != Qt.Key.Key_Escape:
            return False
        event.accept()
        if event.type() == QEvent.Type.KeyPress and self._held is not None:
            self._axis.view_state.set_frame(self._held.frame)
            self._let_go()
        return True

    def wheelEvent(self, event: QWheelEvent) -> None:
        self._axis.wheel(event, event.position().x())

    def tip_at(self, at: QPointF) -> str:
        """What is said of the mark under the pointer."""
        mark = self.mark_at(at.x())
        if mark is None:
            return ""
        title = (
            tr("Frame {frame}: {text}", frame=mark.frame, text=mark.text)
            if mark.text
            else tr("Frame {frame}", frame=mark.frame)
        )
        return tr("{title}\nDrag to move, double-click to write, right-click to remove", title=title)

    # ---- the rest is private

    def _drag(self, mark: Mark, x: float) -> None:
        """The mark goes by as many frames as the pointer, not out of the clip, and the playhead with it."""
        if self._target is None and (application := QApplication.instance()) is not None:
            application.installEventFilter(self)
        scale = self._axis.scale
        self._target = scale.held(mark.frame + round(scale.time(x) - self._pressed_time))
        self._axis.view_state.set_frame(self._target)
        self.update()

    def _moved(self) -> Project:
        """The project as the drag would leave it: as it is now, for frames may be tracked meanwhile."""
        project, held, target = self._document.project, self._held, self._target
        return project if held is None or target is None else timing.move_mark(project, held.frame, target)

    def _let_go(self) -> None:
        if self._target is not None and (application := QApplication.instance()) is not None:
            application.removeEventFilter(self)
        self._held = self._target = None
        self.update()

    def _pull(self, _ids: object = None) -> None:
        self.setVisible(bool(self._document.project.marks))
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(style.WINDOW))
        painter.setFont(style.small(self.font()))
        painter.setPen(QColor(style.WEAK))
        painter.drawText(QRectF(style.MARGIN, 0, LABEL_WIDTH, HEIGHT), Qt.AlignmentFlag.AlignVCenter, tr("marks"))
        left = LABEL_WIDTH - FLAG  # the flag of the first frame is whole
        painter.setClipRect(QRectF(left, 0, self.width() - left, HEIGHT))
        marks = self._moved().marks
        for mark, following in pairwise([*marks, None]):
            assert mark is not None
            self._paint_mark(painter, mark, self.width() if following is None else self._axis.scale.x(following.frame))
        painter.setClipping(False)
        paint_playhead(painter, self._axis, self)
        painter.end()

    def _paint_mark(self, painter: QPainter, mark: Mark, room: float) -> None:
        """A flag, and as much of its word as fits before the next one."""
        x = self._axis.scale.x(mark.frame)
        if not self._axis.scale.has_left_of(mark.frame):
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor(COLOUR))
            corners = ((-FLAG, 4), (FLAG, 4), (FLAG, 10), (0, 15), (-FLAG, 10))
            painter.drawPolygon(QPolygonF([QPointF(x + dx, y) for dx, y in corners]))
            painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
        width = room - x - 3 * FLAG
        if mark.text and width > 12:
            text = painter.fontMetrics().elidedText(
                " ".join(mark.text.split()), Qt.TextElideMode.ElideRight, int(width)
            )
            painter.setPen(QColor(style.TEXT))
            painter.drawText(QRectF(x + 2 * FLAG, 0, width, HEIGHT), Qt.AlignmentFlag.AlignVCenter, text)


class MarkField(QLineEdit):
    """The word of a mark while it is typed: Return keeps it, leaving the field too, Esc leaves what was there."""

    def __init__(self, band: MarkBand) -> None:
        super().__init__(band)
        self._band, self._frame, self._is_asking = band, 0, False
        self.setObjectName("markField")
        self.setProperty(KEEPS_KEYBOARD, True)
        self.setPlaceholderText(tr("a note on this frame"))
        self.setAccessibleName(self.placeholderText())
        self.setVisible(False)
        self.editingFinished.connect(self.keep)

    def begin(self, mark: Mark, left: float) -> None:
        """Ask for the word of a mark, `left` pixels from the band's edge."""
        self._frame, self._is_asking = mark.frame, True
        self.setText(mark.text)
        self.setGeometry(round(left), 1, FIELD_WIDTH, HEIGHT - 2)
        self.setVisible(True)
        self.selectAll()
        self.setFocus()

    def event(self, event: QEvent) -> bool:
        return takes_key(event) or super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.leave()
        else:
            super().keyPressEvent(event)

    def leave(self) -> None:
        """Leave what was there: by hand, or because another project is shown."""
        self._is_asking = False
        self.setVisible(False)

    def keep(self) -> None:
        """Take what is typed, if anything is, and be done."""
        # Hiding the field takes its focus away, and so ends the typing once more.
        if self._is_asking:
            self._is_asking = False
            self.setVisible(False)
            self._band.rename(self._frame, self.text().strip())
