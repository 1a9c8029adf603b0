"""The key rows: one line a shape, its keys as marks. Paints what it pulls; only what is visible."""

from __future__ import annotations

import math

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import (
    QColor,
    QContextMenuEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QAbstractScrollArea, QFrame, QMenu, QWidget

from roam_core.roto import RotoShape
from roam_core.roto.timing import Place

from ... import style
from ...actions.key_names import NUDGES, key_name
from ...model.document import Document
from ...model.view_state import shapes_in_hand
from ...translation import tr
from ...widgets.tipped import tells
from ..axis import FocusRepaint, TimeAxis, paint_focus, paint_playhead
from ..marks import KeyMarks, MarksOf
from ..scale import LABEL_WIDTH
from .depth_marks import change_at
from .hand import KeyHand
from .row_painter import ROW, RowPainter
from .selection import KeySelection
from .stretch import TIP, End, StretchEnds
from .tips import key_tip
from .walking import KeyWalk, is_key_press

GRAB = 6
"""Pixels around a key's middle in which a click means the key."""
SCROLL_PAUSE = 40
"""Milliseconds from one step to the next where a box scrolls the rows."""


class KeyRows(QAbstractScrollArea):
    """Click a key to go there, drag it along time, drag a box around several; click a name to select its shape.
    Brackets beside several chosen keys stretch them.

    The wheel zooms. A click takes the keyboard: then copy, paste and delete mean keys, Alt with arrows moves them, Tab
    goes from key to key, and Ctrl+Shift with an arrow takes the next one to them.

    Signals
    -------
    nudged(frames, merge_key) : the chosen keys are to move; one held key has one merge key.
    """

    nudged = Signal(int, str)

    def __init__(
        self,
        document: Document,
        axis: TimeAxis,
        marks: MarksOf,
        keys: KeySelection,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        FocusRepaint(self)
        self._document, self._axis, self._marks, self._keys = document, axis, marks, keys
        self._painter, self._presses = RowPainter(), 0
        self.menu = QMenu(self)
        """What a right click offers."""
        self.hand = KeyHand(document, axis, keys, self.key_at, self.keys_in, self._end_at, self.viewport().update)
        self._walk = KeyWalk(axis.view_state, keys, self._in_time)
        self._beyond, self._scrolled_to = 0.0, 0
        """By how many pixels the pointer is below the rows in sight (above: below zero); where the bar was last."""
        self._scrolling = QTimer(self, interval=SCROLL_PAUSE)
        self._scrolling.timeout.connect(self._scroll_on)
        self.verticalScrollBar().valueChanged.connect(self._tell_scrolled)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.viewport().setMouseTracking(True)
        self._pull_height()
        document.changed.connect(self._pull)
        document.replaced.connect(self._pull)
        for signal in (axis.changed, axis.view_state.frame_changed, keys.changed):
            signal.connect(self.viewport().update)
        axis.view_state.selection_changed.connect(self._show_selected)

    def sizeHint(self) -> QSize:
        return QSize(600, 3 * ROW)

    def rows(self) -> list[RotoShape]:
        """The shapes from the top row down, the top-most first; while keys are dragged as the drag would leave them."""
        return list(reversed((self.hand.preview or self._document.project).shapes))

    def shape_at(self, y: float) -> RotoShape | None:
        """The shape whose row lies at `y` pixels of the viewport, or None."""
        index, rows = int(y + self._offset) // ROW, self.rows()
        return rows[index] if 0 <= index < len(rows) else None

    def key_at(self, at: QPointF) -> Place | None:
        """The artist's key near a place of the viewport, so that a click need not be exact, or None."""
        distance, place = self._nearest_key(at)
        return place if distance <= GRAB else None

    def keys_in(self, box: QRectF) -> frozenset[Place]:
        """The artist's keys whose middles lie inside a box of the viewport."""
        scale, inside = self._axis.scale, []
        for index, shape in enumerate(self.rows()):
            middle = index * ROW + ROW / 2 - self._offset
            if box.top() - ROW / 2 <= middle <= box.bottom() + ROW / 2:
                artist = self._marks_of(shape).artist
                x = scale.left + (artist - scale.first + 0.5) * scale.pixels
                caught = artist[(x >= box.left()) & (x <= box.right())]
                inside += [(shape.id, frame) for frame in caught.tolist()]
        return frozenset(inside)

    # ---- events

    def resizeEvent(self, event: QResizeEvent) -> None:
        was_in_sight = self._is_selected_in_sight(event.oldSize().height())
        self._pull()
        if was_in_sight:
            self._show_selected()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton:
            return
        shape = self.shape_at(event.position().y())
        if self._is_name(event.position()):
            if shape is not None:
                self._select(shape, event.modifiers())
            return
        is_bracket = self._end_at(event.position()) is not None
        self.hand.press(event)
        if shape is not None and not is_bracket and self.key_at(event.position()) is not None:
            self._select(shape, event.modifiers(), keep_selected=True)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """A press like any other: whoever clicks a key and drags it at once presses twice."""
        self.mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton:
            self.hand.move(event)
            y = event.position().y()
            self._beyond = min(y, 0.0) + max(y - self.viewport().height(), 0.0)
            if self._beyond and self.hand.box is not None and not self._scrolling.isActive():
                self._scrolling.start()
        else:
            over_key = self.key_at(event.position()) is not None or self._end_at(event.position()) is not None
            self.viewport().setCursor(Qt.CursorShape.SizeHorCursor if over_key else Qt.CursorShape.ArrowCursor)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self.hand.release(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """A menu for the chosen keys; a key under the pointer that is not chosen is chosen first. None in a drag."""
        if self.hand.is_busy:
            return
        place = self.key_at(QPointF(event.pos()))
        if place is not None and place not in self._keys.places:
            self._keys.select(frozenset({place}))
        self.menu.popup(event.globalPos())

    def event(self, event: QEvent) -> bool:
        # Esc is the whole window's key for stopping; while keys are dragged it means this drag.
        if event.type() == QEvent.Type.ShortcutOverride and self.hand.is_busy and _is_escape(event):
            event.accept()
            return True
        # Behind the last key Tab goes to the next control.
        if is_key_press(event) and not self.hand.is_busy and self._walk.take(event):
            self._bring_into_sight(self._walk.at)
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Esc drops a drag; what nudges points in the viewer nudges keys here."""
        frames = NUDGES.get(key_name(event), (0.0, 0.0))[0]
        if event.key() == Qt.Key.Key_Escape:
            self.hand.cancel()
        elif frames:
            self._presses += not event.isAutoRepeat()
            self.nudged.emit(int(frames), f"nudge-keys-{self._presses}")
        else:
            event.ignore()

    def viewportEvent(self, event: QEvent) -> bool:
        return tells(event, self.viewport(), self.tip_at) or super().viewportEvent(event)

    def tip_at(self, at: QPointF) -> str:
        """What is said of the frame of a shape under the pointer; of the key near it, where there is one."""
        shape = self.shape_at(at.y())
        if shape is None:
            return ""
        near, change = self.key_at(at), change_at(shape, at.x(), self._axis.scale, GRAB)
        if self._is_name(at) and change is None:
            return tr("{name}: click to select, Shift adds", name=shape.name)
        if self._end_at(at) is not None:
            return tr(TIP)
        frame = near[1] if near is not None else self._axis.scale.frame(at.x()) if change is None else change
        return key_tip(shape, frame, self._marks_of(shape))

    def wheelEvent(self, event: QWheelEvent) -> None:
        if event.position().x() < LABEL_WIDTH:
            super().wheelEvent(event)
        else:
            self._axis.wheel(event, event.position().x())

    # ---- the rest is private

    def _nearest_key(self, at: QPointF) -> tuple[float, Place | None]:
        """The artist's key of a row that is nearest to a place, and how many pixels it lies away."""
        shape = self.shape_at(at.y())
        if shape is None:
            return math.inf, None
        distance, frame = self._axis.scale.nearest(self._marks_of(shape).artist, at.x())
        return distance, None if frame is None else (shape.id, frame)

    def _is_name(self, at: QPointF) -> bool:
        """Whether a place means a shape's name, and no key: that of the first frame reaches to the end of the names."""
        return at.x() < LABEL_WIDTH and self.key_at(at) is None

    def _ends(self) -> StretchEnds:
        """The brackets beside the chosen keys, over all rows from the first to the last that has some."""
        chosen = {shape_id for shape_id, _ in self._keys.places}
        rows = [index for index, shape in enumerate(self.rows()) if shape.id in chosen] if chosen else []
        top, bottom = (min(rows) * ROW, (max(rows) + 1) * ROW) if rows else (0, 0)
        return StretchEnds(self._axis, self.hand.movable(), top - self._offset, bottom - self._offset)

    def _end_at(self, at: QPointF) -> End | None:
        """The bracket under a place of the viewport, or None."""
        return self._ends().at(at, self._nearest_key(at)[0]) if at.x() >= LABEL_WIDTH else None

    def _marks_of(self, shape: RotoShape) -> KeyMarks:
        """The marks of one of the `rows`."""
        return self._marks(shape, self.hand.preview)

    @property
    def _offset(self) -> int:
        return self.verticalScrollBar().value()

    def _scroll_on(self) -> None:
        """A box that is drawn beyond the rows in sight goes on over the others, faster the farther away it is."""
        if self.hand.box is None or not self._beyond:
            self._scrolling.stop()
        else:
            bar, fastest = self.verticalScrollBar(), 2 * ROW
            bar.setValue(bar.value() + round(max(min(self._beyond, fastest), -fastest)))

    def _tell_scrolled(self, offset: int) -> None:
        by, self._scrolled_to = offset - self._scrolled_to, offset
        self.hand.scrolled(by)

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

    def _in_time(self) -> list[Place]:
        """Where the artist's keys of the shapes in hand lie, in the order of time; of one frame from the top down."""
        shapes = reversed(shapes_in_hand(self._document.project, self._axis.view_state.selection))
        places = [(shape.id, frame) for shape in shapes for frame in shape.artist_frames]
        return sorted(places, key=lambda place: place[1])

    def _bring_into_sight(self, place: Place | None) -> None:
        """Scroll by as little as shows the row of a key."""
        index = next(i for i, shape in enumerate(self.rows()) if place is not None and shape.id == place[0])
        low, high = (index + 1) * ROW - self.viewport().height(), index * ROW
        self.verticalScrollBar().setValue(max(min(self._offset, high), low))

    def _show_selected(self) -> None:
        """Scroll by as little as brings a selected row into sight, if none is."""
        height, tops = self.viewport().height(), self._selected_tops()
        if tops and not self._is_selected_in_sight(height):
            self.verticalScrollBar().setValue(self._offset + (tops[0] if tops[0] < 0 else tops[0] + ROW - height))
        self.viewport().update()

    def _selected_tops(self) -> list[int]:
        chosen = self._axis.view_state.selection.shapes
        return [index * ROW - self._offset for index, shape in enumerate(self.rows()) if shape.id in chosen]

    def _is_selected_in_sight(self, height: int) -> bool:
        """Whether the whole row of a selected shape is seen where the rows are so high."""
        return any(0 <= top <= height - ROW for top in self._selected_tops())

    def _select(self, shape: RotoShape, modifiers: Qt.KeyboardModifier, *, keep_selected: bool = False) -> None:
        """Select the shape; with Shift or Ctrl add it or take it away. `keep_selected`: one that is selected stays."""
        view = self._axis.view_state
        adds = modifiers & (Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.ControlModifier)
        if keep_selected:
            if shape.id not in view.selection.shapes:
                view.select((view.selection.shapes if adds else frozenset()) | {shape.id})
        else:
            view.select(view.selection.shapes ^ {shape.id} if adds else frozenset({shape.id}))

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
            shape = rows[index]
            marks, chosen = self._marks_of(shape), self.hand.chosen(shape.id)
            row = self._painter.row(shape, marks, self._axis.scale, size, shape.id in selected, chosen, viewport)
            painter.drawPixmap(0, index * ROW - self._offset, row)
        if not rows:
            self._paint_hint(painter)
        paint_playhead(painter, self._axis, viewport)
        painter.setClipRect(LABEL_WIDTH, 0, viewport.width(), viewport.height())
        self._ends().paint(painter)
        painter.setClipping(False)
        self._paint_box(painter)
        paint_focus(painter, self, viewport)
        painter.end()

    def _paint_box(self, painter: QPainter) -> None:
        if self.hand.box is not None:
            painter.setPen(QPen(QColor(style.TEXT), 1, Qt.PenStyle.DashLine))
            painter.setBrush(QColor(255, 255, 255, 20))
            painter.drawRect(self.hand.box)

    def _paint_hint(self, painter: QPainter) -> None:
        painter.setPen(QColor(style.WEAK))
        box = QRectF(LABEL_WIDTH + style.MARGIN, 0, self.viewport().width() - LABEL_WIDTH, ROW)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, tr("The keys of your shapes appear here."))


def _is_escape(event: QEvent) -> bool:
    return isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape
