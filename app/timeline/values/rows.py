"""The rows of values: what of the shapes and layers in hand varies with time, its keys and how it runs between them.

There while something varies. The line in a row goes from the value's least at the bottom to its greatest at the top.
"""

from __future__ import annotations

import math

import numpy as np
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import (
    QColor,
    QContextMenuEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPen,
    QPolygonF,
)
from PySide6.QtWidgets import QMenu, QScrollArea, QWidget

from roam_core.roto import Animated, RotoShape
from roam_core.roto.value_curves import ValuePlace

from ...actions.key_names import NUDGES, key_name
from ...model.document import Document
from ...translation import tr
from ..axis import TimeAxis
from ..keys.row_painter import BACKGROUND, ROW
from ..keys.stretch import TIP, End, Stretch, StretchEnds
from ..keys.walking import KeyWalk, is_key_press
from ..row_band import RowBand
from ..scale import LABEL_WIDTH, TimeScale, whole_frames
from .drag import KeyDrag
from .key_forms import form_of, paint_key
from .selection import ValueSelection
from .shown import SHOWN_AS, KeyedValue, Kind, colour_of, keyed_values
from .verbs import ValueVerbs, unlocked

GRAB, STILL = 6, 3
"""Pixels around a key in which a press means it; that the pointer may move within a click."""
MOST = 6
"""Rows that have room at once; the others scroll."""
MARGIN = 4.0
"""Pixels between a row's edges and the least or greatest value."""
COPIES = Qt.KeyboardModifier.AltModifier
ADDS = Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.ControlModifier


class ValueRows(RowBand[KeyedValue]):
    """Click a key to choose it and go there, drag it along time, with Alt a copy; a click beside goes to that frame.

    A click takes the keyboard: then copy, paste and delete mean keys, Alt with arrows moves them, Tab goes from key to
    key, and Ctrl+Shift with an arrow takes the next one to them.
    """

    def __init__(
        self, document: Document, axis: TimeAxis, chosen: ValueSelection, parent: QWidget | None = None
    ) -> None:
        super().__init__(document, axis, parent)
        self._chosen = chosen
        self.verbs = ValueVerbs(document, axis.view_state, chosen, self.hasFocus, self.places)
        self._walk = KeyWalk(axis.view_state, chosen, self._in_time)
        self._drag: KeyDrag | None = None
        self._stretch: Stretch | None = None
        """The bracket that is held, where the drag is of one."""
        self._lines: dict[tuple[str, Kind], tuple[Animated, TimeScale, QPolygonF]] = {}
        self._pressed, self._pressed_time, self._is_drag, self._presses = QPointF(), 0.0, False, 0
        self._scrubs = False
        self.menu = QMenu(self)
        """What a right click offers."""
        self.setAccessibleName(tr("Keys of opacity and feather"))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        chosen.changed.connect(self.update)
        self.pull()

    def rows(self) -> list[KeyedValue]:
        """The values that are shown, as a drag would leave them."""
        view = self._axis.view_state
        shown = view.preview if self._drag is not None else None
        return keyed_values(shown or self._document.project, view)

    def places(self) -> frozenset[ValuePlace]:
        """Where all keys of the rows lie."""
        return frozenset((row.item.id, row.kind.value, frame) for row in self.rows() for frame in row.value.frames)

    def key_at(self, at: QPointF) -> ValuePlace | None:
        """The key near a place, or None."""
        distance, place = self._nearest_key(at)
        return place if distance <= GRAB else None

    # ---- events

    def mousePressEvent(self, event: QMouseEvent) -> None:
        at, row = event.position(), self.row_at(event.position().y())
        if event.button() != Qt.MouseButton.LeftButton or row is None:
            return
        self._scrubs = False
        place, end, self._pressed, self._is_drag = self.key_at(at), self._end_at(at), at, False
        if at.x() < LABEL_WIDTH and place is None:
            self._select(row)
            return
        self._pressed_time, self._scrubs = self._axis.scale.time(at.x()), place is None and end is None
        self._stretch = None if end is None else Stretch(self._axis, end, at.x())
        if self._stretch is not None:
            self._drag = KeyDrag(self._document, self._axis, self._chosen, self.verbs)
            return
        if place is None:
            self._chosen.clear()
            self._axis.scrub(at.x())
            return
        places = self._chosen.places
        if event.modifiers() & ADDS:
            self._chosen.select(places ^ {place})
        elif place not in places:
            self._chosen.select(frozenset({place}))
        self._drag = KeyDrag(self._document, self._axis, self._chosen, self.verbs)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        at = event.position()
        if not event.buttons() & Qt.MouseButton.LeftButton:
            return
        if self._drag is None:
            if self._scrubs:
                self._axis.scrub(at.x())
            return
        self._is_drag = self._is_drag or (at - self._pressed).manhattanLength() > STILL
        if self._is_drag:
            self._axis.bring_in(at.x())
            if self._stretch is not None:
                self._drag.stretch(self._stretch, at.x())
                self.update()
                return
            frames = round(self._axis.scale.time(at.x()) - self._pressed_time)
            self._drag.to(frames, 0.0, copies=bool(event.modifiers() & COPIES))
            self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton:
            return
        drag, self._drag = self._drag, None
        if drag is None:
            return
        if self._is_drag:
            drag.finish()
        elif self._stretch is None:
            self._click(event)
        self.update()

    def _click(self, event: QMouseEvent) -> None:
        place = self.key_at(event.position())
        if place is not None and not event.modifiers() & ADDS:
            self._chosen.select(frozenset({place}))
            self._axis.view_state.set_frame(place[2])

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """A menu for the chosen keys; a key under the pointer that is not chosen is chosen first. None in a drag."""
        if self._drag is not None:
            return
        place = self.key_at(QPointF(event.pos()))
        if place is not None and place not in self._chosen.places:
            self._chosen.select(frozenset({place}))
        self.menu.popup(event.globalPos())

    def event(self, event: QEvent) -> bool:
        is_escape = isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape
        if event.type() == QEvent.Type.ShortcutOverride and self._drag is not None and is_escape:
            event.accept()
            return True
        # Behind the last key Tab goes to the next control.
        if is_key_press(event) and self._drag is None and self._walk.take(event):
            self._bring_into_sight(self._walk.at)
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

    def tip_at(self, at: QPointF) -> str:
        """What is said of the value on the frame under the pointer."""
        row = self.row_at(at.y())
        if row is None:
            return ""
        place = self.key_at(at)
        if at.x() < LABEL_WIDTH and place is None:
            return tr("{title}. Click to select", title=row.title)
        if self._end_at(at) is not None:
            return tr(TIP)
        frame = place[2] if place is not None else self._axis.scale.frame(at.x())
        factor, unit = SHOWN_AS[row.kind]
        return tr(
            "{title}, frame {frame}: {value:.4g} {unit}",
            title=row.title,
            frame=frame,
            value=row.value.at(frame) * factor,
            unit=unit,
        ) + (tr(", a key") if place else "")

    # ---- the rest is private

    def _in_time(self) -> list[ValuePlace]:
        """Where all keys of the rows lie, in the order of time; of one frame from the top down."""
        places = [(row.item.id, row.kind.value, frame) for row in self.rows() for frame in row.value.frames]
        return sorted(places, key=lambda place: place[2])

    def _bring_into_sight(self, place: ValuePlace | None) -> None:
        """Scroll by as little as shows the row of a key."""
        port = self.parentWidget()
        room = None if port is None else port.parentWidget()
        if isinstance(room, QScrollArea) and place is not None:
            index = next(i for i, row in enumerate(self.rows()) if (row.item.id, row.kind) == place[:2])
            room.ensureVisible(0, index * ROW + ROW // 2, 0, ROW // 2)

    def _nearest_key(self, at: QPointF) -> tuple[float, ValuePlace | None]:
        """The key of a row that is nearest to a place, and how many pixels it lies away."""
        row = self.row_at(at.y())
        if row is None:
            return math.inf, None
        distance, frame = self._axis.scale.nearest(row.value.frames, at.x())
        return distance, None if frame is None else (row.item.id, row.kind.value, frame)

    def _ends(self) -> StretchEnds:
        """The brackets beside the chosen keys, over all rows from the first to the last that has some."""
        chosen = unlocked(self._document.project, self._chosen.places)
        names = {place[:2] for place in chosen}
        rows = [index for index, row in enumerate(self.rows()) if (row.item.id, row.kind.value) in names]
        top, bottom = (min(rows) * ROW, (max(rows) + 1) * ROW) if rows else (0, 0)
        frames = [frame if self._drag is None else self._drag.frame_of(frame) for _, _, frame in chosen]
        return StretchEnds(self._axis, frames, top, bottom)

    def _end_at(self, at: QPointF) -> End | None:
        """The bracket under a place, or None."""
        return self._ends().at(at, self._nearest_key(at)[0]) if at.x() >= LABEL_WIDTH else None

    def paint_over(self, painter: QPainter) -> None:
        self._ends().paint(painter)

    def _select(self, row: KeyedValue) -> None:
        view, item = self._axis.view_state, row.item
        if isinstance(item, RotoShape):
            view.select(frozenset({item.id}))
        else:
            view.select(frozenset(shape.id for shape in item.shapes()), layers=frozenset({item.id}))

    def name_of(self, row: KeyedValue) -> str:
        return row.item.name

    def ending_of(self, row: KeyedValue) -> str:
        return f": {row.name}"

    def paint_row(self, painter: QPainter, row: KeyedValue) -> None:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(QColor(BACKGROUND), 1))
        painter.drawPolyline(self._line(row))

    def paint_keys(self, painter: QPainter, row: KeyedValue) -> None:
        scale, colour = self._axis.scale, QColor.fromRgbF(*colour_of(row.item))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        chosen = self._chosen.frames_of(row.item.id, row.kind)
        if self._drag is not None:
            chosen = frozenset(self._drag.frame_of(frame) for frame in chosen)
        for key in row.value.keys:
            if scale.has_left_of(key.frame):
                continue
            at = QPointF(scale.x(key.frame), (ROW - 1) / 2)
            paint_key(painter, at, form_of(key), colour, key.frame in chosen)

    def _line(self, row: KeyedValue) -> QPolygonF:
        """How the value runs through the frames in sight; reckoned once, and painted with every frame that is shown."""
        scale, place = self._axis.scale, (row.item.id, row.kind)
        known = self._lines.get(place)
        if known is None or known[0] is not row.value or known[1] != scale:
            known = self._lines[place] = row.value, scale, self._reckoned(row, scale)
        return known[2]

    def _reckoned(self, row: KeyedValue, scale: TimeScale) -> QPolygonF:
        frames = whole_frames(scale.first, scale.last, round(scale.right - scale.left))
        values = np.array([row.value.at(frame) for frame in frames.tolist()])
        low, span = values.min(), max(np.ptp(values), 1e-9)
        heights = MARGIN + (1.0 - (values - low) / span) * (ROW - 1 - 2 * MARGIN)
        return QPolygonF([QPointF(scale.x(f), y) for f, y in zip(frames.tolist(), heights.tolist(), strict=True)])
