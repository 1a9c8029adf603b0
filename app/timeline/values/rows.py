"""The rows of values: what of the shapes and layers in hand varies with time, its keys and how it runs between them.

There while something varies. The line in a row goes from the value's least at the bottom to its greatest at the top.
"""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import (
    QColor,
    QContextMenuEvent,
    QHelpEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPolygonF,
    QWheelEvent,
)
from PySide6.QtWidgets import QMenu, QSizePolicy, QToolTip, QWidget

from roam_core.roto import RotoShape
from roam_core.roto.value_curves import ValuePlace

from ... import style
from ...actions.key_names import NUDGES, key_name
from ...model.document import Document
from ...translation import tr
from ..axis import TimeAxis, paint_playhead
from ..keys.row_painter import BACKGROUND, ROW
from ..scale import LABEL_WIDTH
from .drag import KeyDrag
from .key_forms import form_of, paint_key
from .selection import ValueSelection
from .shown import SHOWN_AS, KeyedValue, colour_of, keyed_values
from .verbs import ValueVerbs

GRAB, STILL = 6, 3
"""Pixels around a key in which a press means it; that the pointer may move within a click."""
MOST = 6
"""Rows that are shown at once."""
MARGIN = 4.0
"""Pixels between a row's edges and the least or greatest value."""
ADDS = Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.ControlModifier


class ValueRows(QWidget):
    """Click a key to choose it and go there, drag it along time; a click beside goes to that frame.

    A click takes the keyboard: then Delete means keys, and Alt with arrows moves them.
    """

    def __init__(
        self, document: Document, axis: TimeAxis, chosen: ValueSelection, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._document, self._axis, self._chosen = document, axis, chosen
        self.verbs = ValueVerbs(document, axis.view_state, chosen, self.hasFocus)
        self._drag: KeyDrag | None = None
        self._pressed, self._is_drag, self._presses = QPointF(), False, 0
        self.menu = QMenu(self)
        """What a right click offers."""
        self.setAccessibleName(tr("Keys of opacity and feather"))
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        view = axis.view_state
        for signal in (document.changed, document.replaced, view.selection_changed):
            signal.connect(self._pull)
        for changed in (axis.changed, view.frame_changed, chosen.changed):
            changed.connect(self.update)
        self._pull()

    def sizeHint(self) -> QSize:
        return QSize(600, ROW)

    def rows(self) -> list[KeyedValue]:
        """The values that are shown, as a drag would leave them: no more than have room."""
        view = self._axis.view_state
        shown = view.preview if self._drag is not None else None
        return keyed_values(shown or self._document.project, view)[:MOST]

    def row_at(self, y: float) -> KeyedValue | None:
        """The value whose row lies at `y` pixels."""
        rows, index = self.rows(), int(y) // ROW
        return rows[index] if 0 <= index < len(rows) else None

    def key_at(self, at: QPointF) -> ValuePlace | None:
        """The key near a place, or None."""
        row = self.row_at(at.y())
        if row is None or at.x() < LABEL_WIDTH:
            return None
        distance, frame = min((abs(self._axis.scale.x(frame) - at.x()), frame) for frame in row.value.frames)
        return (row.item.id, row.kind.value, frame) if distance <= GRAB else None

    # ---- events

    def mousePressEvent(self, event: QMouseEvent) -> None:
        at, row = event.position(), self.row_at(event.position().y())
        if event.button() != Qt.MouseButton.LeftButton or row is None:
            return
        if at.x() < LABEL_WIDTH:
            self._select(row)
            return
        place, self._pressed, self._is_drag = self.key_at(at), at, False
        if place is None:
            self._chosen.clear()
            self._axis.scrub(at.x())
            return
        places = self._chosen.places
        if event.modifiers() & ADDS:
            self._chosen.select(places ^ {place})
        elif place not in places:
            self._chosen.select(frozenset({place}))
        self._drag = KeyDrag(self._document, self._axis, self._chosen, self.verbs.moved)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        at = event.position()
        if not event.buttons() & Qt.MouseButton.LeftButton:
            return
        if self._drag is None:
            if at.x() >= LABEL_WIDTH:
                self._axis.scrub(at.x())
            return
        self._is_drag = self._is_drag or (at - self._pressed).manhattanLength() > STILL
        if self._is_drag:
            self._axis.bring_in(at.x())
            self._drag.to(round((at.x() - self._pressed.x()) / self._axis.scale.pixels), 0.0)
            self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        drag, self._drag = self._drag, None
        if drag is None or event.button() != Qt.MouseButton.LeftButton:
            return
        if self._is_drag:
            drag.finish()
        elif (place := self.key_at(event.position())) is not None and not event.modifiers() & ADDS:
            self._chosen.select(frozenset({place}))
            self._axis.view_state.set_frame(place[2])
        self.update()

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """A menu for the chosen keys; a key under the pointer that is not chosen is chosen first."""
        place = self.key_at(QPointF(event.pos()))
        if place is not None and place not in self._chosen.places:
            self._chosen.select(frozenset({place}))
        self.menu.popup(event.globalPos())

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            QToolTip.showText(event.globalPos(), self.tip_at(QPointF(event.pos())), self)
            return True
        is_escape = isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape
        if event.type() == QEvent.Type.ShortcutOverride and self._drag is not None and is_escape:
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Esc drops a drag; what nudges points in the viewer nudges keys here."""
        frames = NUDGES.get(key_name(event), (0.0, 0.0))[0]
        if event.key() == Qt.Key.Key_Escape and self._drag is not None:
            self._drag.cancel()
            self._drag = None
            self.update()
        elif frames:
            self._presses += not event.isAutoRepeat()
            self.verbs.nudge(int(frames), f"nudge-values-{self._presses}")
        else:
            event.ignore()

    def wheelEvent(self, event: QWheelEvent) -> None:
        self._axis.wheel(event, event.position().x())

    def tip_at(self, at: QPointF) -> str:
        """What is said of the value on the frame under the pointer."""
        row = self.row_at(at.y())
        if row is None:
            return ""
        if at.x() < LABEL_WIDTH:
            return tr("{title}. Click to select", title=row.title)
        place = self.key_at(at)
        frame = place[2] if place is not None else self._axis.scale.frame(at.x())
        factor, unit = SHOWN_AS[row.kind]
        seen = f"{row.value.at(frame) * factor:.4g} {unit}"
        if place is not None:
            return tr("{title}, frame {frame}: {value}, a key", title=row.title, frame=frame, value=seen)
        return tr("{title}, frame {frame}: {value}", title=row.title, frame=frame, value=seen)

    # ---- the rest is private

    def _select(self, row: KeyedValue) -> None:
        view, item = self._axis.view_state, row.item
        if isinstance(item, RotoShape):
            view.select(frozenset({item.id}))
        else:
            view.select(frozenset(shape.id for shape in item.shapes()), layers=frozenset({item.id}))

    def _pull(self, _ids: object = None) -> None:
        rows = len(self.rows())
        self.setVisible(rows > 0)
        self.setFixedHeight(max(rows, 1) * ROW)
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(style.PANEL))
        for index, row in enumerate(self.rows()):
            painter.save()
            painter.translate(0.0, index * ROW)
            self._paint_row(painter, row)
            painter.restore()
        paint_playhead(painter, self._axis, self)
        painter.end()

    def _paint_row(self, painter: QPainter, row: KeyedValue) -> None:
        scale, colour = self._axis.scale, QColor.fromRgbF(*colour_of(row.item))
        painter.fillRect(QRectF(0, ROW - 1, self.width(), 1), QColor(style.WINDOW))
        painter.setPen(QColor(style.WEAK))
        name = painter.fontMetrics().elidedText(row.title, Qt.TextElideMode.ElideMiddle, LABEL_WIDTH - 34)
        painter.drawText(QRectF(22, 0, LABEL_WIDTH - 30, ROW - 1), Qt.AlignmentFlag.AlignVCenter, name)
        painter.setClipRect(QRectF(scale.left, 0, self.width() - scale.left, ROW))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(QColor(BACKGROUND), 1))
        painter.drawPolyline(self._line(row))
        shift = self._drag.frames if self._drag is not None else 0
        chosen = self._chosen.frames_of(row.item.id, row.kind)
        for key in row.value.keys:
            at = QPointF(scale.x(key.frame), (ROW - 1) / 2)
            paint_key(painter, at, form_of(key), colour, key.frame - shift in chosen)

    def _line(self, row: KeyedValue) -> QPolygonF:
        """How the value runs through the frames in sight."""
        scale = self._axis.scale
        frames = np.arange(np.floor(scale.first), np.ceil(scale.last) + 1)
        values = np.array([row.value.at(frame) for frame in frames.tolist()])
        low, span = values.min(), max(np.ptp(values), 1e-9)
        heights = MARGIN + (1.0 - (values - low) / span) * (ROW - 1 - 2 * MARGIN)
        return QPolygonF([QPointF(scale.x(f), y) for f, y in zip(frames.tolist(), heights.tolist(), strict=True)])
