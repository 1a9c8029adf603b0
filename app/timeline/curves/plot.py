"""CurvePlot: the curves of one kind over the ruler's frames, with keys and tangents; the gestures are the hand's."""

from __future__ import annotations

from itertools import chain

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QEvent, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QContextMenuEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QResizeEvent,
    QTransform,
    QWheelEvent,
)
from PySide6.QtWidgets import QMenu

from roam_core.roto.value_curves import ValuePlace

from ... import style
from ...actions.key_names import NUDGES, key_name
from ...model.document import Document
from ...translation import number, tr
from ...widgets.tipped import tells
from ..axis import FocusRepaint, TimeAxis, paint_focus, place_playhead, show_frames
from ..keys.walking import KeyWalk, is_key_press, is_of_walk
from ..scale import LABEL_WIDTH
from ..values.key_forms import key_path
from ..values.selection import ValueSelection
from ..values.shown import KINDS, SHOWN_AS, Kind
from ..values.verbs import ValueVerbs
from .hand import CurveHand, Found, Handle
from .lines import CurveKey, CurveLine, lines_of, ticks, value_range

GRAB = 7.0
"""Pixels around a key, a handle's end or a curve in which a press means it."""
ZOOM = 1.2
"""A notch of the wheel with Ctrl: the factor by which the values in sight become fewer."""
NARROWEST, WIDEST = 1e-3, 1e7
"""Percent or pixels from the bottom to the top at least, and at most."""
KEY, HANDLE = 12, 8
"""Pixels that a key and a handle's end are wide."""
TICK_ROOM = 28
"""Pixels between two lines of the grid, at least."""
SYMBOLS = {
    form: QTransform.fromScale(0.5, 0.5).map(key_path(form)) for form in ("linear", "smooth", "hold", "tangents")
}
"""Keys by their form, one unit wide, as pyqtgraph wants them."""


class CurvePlot(pg.GraphicsView):  # type: ignore[misc]
    """Drag keys in time and value, and the ends of tangents; drag a box around keys; Ctrl+Alt+click sets a key.

    The wheel zooms time, with Ctrl values; then the middle button pans both. A click takes the keyboard: then Delete
    means keys, Alt with arrows moves them, Tab goes from key to key, and Ctrl+Shift with an arrow takes the next one to
    them.

    Signals
    -------
    range_changed() : other values are in sight.
    """

    range_changed = Signal()

    def __init__(self, document: Document, axis: TimeAxis, chosen: ValueSelection) -> None:
        super().__init__(background=style.PANEL)
        FocusRepaint(self)
        self._document, self._axis, self._chosen = document, axis, chosen
        self.verbs = ValueVerbs(document, axis.view_state, chosen, self.hasFocus, self.places)
        self.hand = CurveHand(document, axis, chosen, self.verbs, self.found_at, self.keys_in, self.value_at, self.pull)
        self.kind = Kind.OPACITY
        self.values_in_sight = 0.0, 1.0
        """The least and greatest value in sight."""
        self.lines: list[CurveLine] = []
        self.menu = QMenu(self)
        """What a right click offers."""
        self._walk = KeyWalk(axis.view_state, chosen, self._in_time, from_end_to_end=True)
        self._is_fitted, self._presses = True, 0
        self._build()
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccessibleName(tr("Curves"))
        self.setMouseTracking(True)
        view = axis.view_state
        for signal in (document.changed, document.replaced, axis.changed, chosen.changed):
            signal.connect(self.pull)
        for signal in (axis.fitted, view.selection_changed):
            signal.connect(self.fit)
        view.preview_changed.connect(self._pull_preview)
        view.frame_changed.connect(self._pull_playhead)

    def show_kind(self, kind: Kind) -> None:
        """Show another kind of curves, all of their values. Keys of curves that are shown no more are not chosen."""
        self.kind = kind
        self._chosen.select(frozenset(place for place in self._chosen.places if place[1] == kind))
        self.fit()

    def fit(self) -> None:
        """Bring all values into sight, and keep them there."""
        self._is_fitted = True
        self.pull()

    def pan(self, down: float) -> None:
        """Move the values in sight by so many pixels. While all are seen they stay: a hand that pans time shakes."""
        if self._is_fitted:
            return
        low, high = self.values_in_sight
        by = down / max(self.height(), 1) * (high - low)
        self.values_in_sight = low + by, high + by
        self.pull()

    def places(self) -> frozenset[ValuePlace]:
        """Where all keys of the curves lie."""
        return frozenset(line.place(key) for line, key in self._keys())

    # ---- where things lie

    def key_point(self, frame: float, value: float) -> QPointF:
        """Where a value on a frame lies, in pixels of the plot."""
        low, high = self.values_in_sight
        x = self._axis.scale.x(frame) - LABEL_WIDTH
        return QPointF(x, (high - value) / (high - low) * self.height())

    def value_at(self, y: float) -> float:
        """The value shown at a height, in pixels from the top."""
        low, high = self.values_in_sight
        return high - y / float(max(self.height(), 1)) * (high - low)

    def found_at(self, at: QPointF) -> Found:
        """What lies under a place: the end of a chosen key's handle before a key, a key before a curve."""
        found: list[tuple[float, Found]] = []
        for line, key in self._keys():
            place = line.place(key)
            for end, is_leaving in ((key.arriving, False), (key.leaving, True)):
                if end is not None and self._is_chosen(line, key):
                    found.append((_distance(at, self.key_point(*end)), Found(handle=Handle(place, is_leaving))))
            found.append((_distance(at, self.key_point(key.frame, key.value)) + 0.5, Found(key=place)))
        near = [each for each in found if each[0] <= GRAB]
        if near:
            return min(near, key=lambda each: each[0])[1]
        frame = self._axis.scale.time(at.x() + LABEL_WIDTH) - 0.5
        for line in self.lines:
            height = self.key_point(frame, float(np.interp(frame, line.frames, line.values))).y()
            if abs(height - at.y()) <= GRAB:
                return Found(curve=(line.item_id, line.kind))
        return Found()

    def keys_in(self, box: QRectF) -> frozenset[ValuePlace]:
        """The keys inside a box of the plot."""
        return frozenset(
            line.place(key) for line, key in self._keys() if box.contains(self.key_point(key.frame, key.value))
        )

    # ---- painting

    def pull(self, _ids: object = None) -> None:
        """Show what is there now; nothing while the editor is out of sight."""
        if not self.isVisible():
            return
        view, scale = self._axis.view_state, self._axis.scale
        project = view.preview if self.hand.is_busy and view.preview is not None else self._document.project
        self.lines = lines_of(project, view, self.kind, scale.first - 1.0, scale.last + 1.0)
        if self._is_fitted and not self.hand.is_busy:
            self.values_in_sight = value_range(self.lines, self.kind)
        show_frames(self._box, self._axis, self.width())
        self._box.setYRange(*self.values_in_sight, padding=0)
        self._pull_curves()
        self._pull_marks()
        self._pull_playhead()
        self.range_changed.emit()

    def grid(self) -> list[float]:
        """The values at which lines of the grid lie."""
        return ticks(*self.values_in_sight, most=self.height() // TICK_ROOM)

    def _build(self) -> None:
        self._box = pg.ViewBox(enableMouse=False, enableMenu=False, defaultPadding=0)
        self.setCentralItem(self._box)
        self._grid = pg.PlotCurveItem(connect="pairs", pen=pg.mkPen(style.LINE))
        self._handles = pg.PlotCurveItem(connect="pairs", pen=pg.mkPen(style.TEXT))
        self._ends = pg.ScatterPlotItem(size=HANDLE, symbol="o", pen=pg.mkPen(style.EDGE), brush=pg.mkBrush(style.TEXT))
        self._marks = pg.ScatterPlotItem(size=KEY)
        self._rubber = pg.PlotCurveItem(pen=pg.mkPen(style.TEXT, style=Qt.PenStyle.DashLine))
        self._playhead = pg.InfiniteLine(pen=pg.mkPen(style.ACCENT, width=1))
        self._curves: list[pg.PlotCurveItem] = []
        for depth, item in enumerate(
            (self._grid, self._playhead, self._handles, self._marks, self._ends, self._rubber)
        ):
            item.setZValue(10 * depth)
            self._box.addItem(item, ignoreBounds=True)

    def _pull_curves(self) -> None:
        while len(self._curves) < len(self.lines):
            self._curves.append(pg.PlotCurveItem(antialias=True))
            self._curves[-1].setZValue(15)
            self._box.addItem(self._curves[-1], ignoreBounds=True)
        for index, item in enumerate(self._curves):
            item.setVisible(index < len(self.lines))
            if index < len(self.lines):
                line = self.lines[index]
                dashes = Qt.PenStyle.SolidLine if line.keys else Qt.PenStyle.DotLine
                item.setPen(pg.mkPen(QColor.fromRgbF(*line.colour), width=1.5, style=dashes))
                item.setData(line.frames + 0.5, line.values)
        first, last = self._box.viewRange()[0]
        heights = np.repeat(self.grid(), 2)
        self._grid.setData(np.tile([first, last], len(heights) // 2), heights)

    def _pull_marks(self) -> None:
        spots, handles = [], []
        for line, key in self._keys():
            is_chosen = self._is_chosen(line, key)
            colour = QColor("#ffffff") if is_chosen else QColor.fromRgbF(*line.colour).lighter(115)
            edge = style.ACCENT if is_chosen else style.EDGE
            spots.append(
                {
                    "pos": (key.frame + 0.5, key.value),
                    "symbol": SYMBOLS[key.form],
                    "size": KEY,
                    "brush": pg.mkBrush(colour),
                    "pen": pg.mkPen(edge, width=1.5 if is_chosen else 1.0),
                }
            )
            if is_chosen:
                ends = [end for end in (key.arriving, key.leaving) if end is not None]
                handles += [((key.frame + 0.5, key.value), (frame + 0.5, value)) for frame, value in ends]
        self._marks.setData(spots)
        points = np.array(list(chain.from_iterable(handles)), dtype=np.float64).reshape(-1, 2)
        self._handles.setData(points[:, 0], points[:, 1])
        self._ends.setData(points[1::2, 0], points[1::2, 1])
        self._pull_rubber()

    def _pull_rubber(self) -> None:
        box = self.hand.box
        self._rubber.setVisible(box is not None)
        if box is not None:
            corners = box.topLeft(), box.topRight(), box.bottomRight(), box.bottomLeft(), box.topLeft()
            frames = [self._axis.scale.time(corner.x() + LABEL_WIDTH) for corner in corners]
            self._rubber.setData(frames, [self.value_at(corner.y()) for corner in corners])

    def _pull_playhead(self) -> None:
        place_playhead(self._playhead, self._axis)

    def _pull_preview(self) -> None:
        if self.hand.is_busy:
            self.pull()

    def _keys(self) -> list[tuple[CurveLine, CurveKey]]:
        return [(line, key) for line in self.lines for key in line.keys]

    def _is_chosen(self, line: CurveLine, key: CurveKey) -> bool:
        return key.frame - self.hand.shift in self._chosen.frames_of(line.item_id, line.kind)

    # ---- events; pyqtgraph's own handling is not wanted

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        # pyqtgraph's constructor resizes the view before there is anything in it.
        if hasattr(self, "_curves"):
            self.pull()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self.hand.press(event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """A press like any other: whoever clicks a key and drags it at once presses twice."""
        self.mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton:
            self.hand.move(event)
            return
        found = self.found_at(event.position())
        is_held = found.key is not None or found.handle is not None
        self.viewport().setCursor(Qt.CursorShape.SizeAllCursor if is_held else Qt.CursorShape.ArrowCursor)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self.hand.release(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        if event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            low, high = self.values_in_sight
            value, factor = self.value_at(event.position().y()), ZOOM ** (-event.angleDelta().y() / 120)
            if NARROWEST <= (high - low) * factor <= WIDEST:
                self.values_in_sight = value - (value - low) * factor, value + (high - value) * factor
                self._is_fitted = False
                self.pull()
            event.accept()
        else:
            self._axis.wheel(event, event.position().x() + LABEL_WIDTH)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """A menu for the chosen keys; a key under the pointer that is not chosen is chosen first. None in a drag."""
        if self.hand.is_busy:
            return
        place = self.found_at(QPointF(event.pos())).key
        if place is not None and place not in self._chosen.places:
            self._chosen.select(frozenset({place}))
        self.menu.popup(event.globalPos())

    def event(self, event: QEvent) -> bool:
        # Tab and Esc are keys of the window; here they mean the next key, and the drag under the hand.
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride:
            if is_of_walk(event) or (self.hand.is_busy and event.key() == Qt.Key.Key_Escape):
                event.accept()
                return True
        elif is_key_press(event) and not self.hand.is_busy and (self._walk.take(event) or is_of_walk(event)):
            return True
        return bool(super().event(event))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Esc drops a drag; what nudges points in the viewer nudges keys here, a frame or a unit, with Shift ten."""
        frames, down = NUDGES.get(key_name(event), (0.0, 0.0))
        if event.key() == Qt.Key.Key_Escape and self.hand.is_busy:
            self.hand.cancel()
        elif frames or down:
            self._presses += not event.isAutoRepeat()
            merge_key = f"nudge-curves-{self._presses}"
            if frames:
                self.verbs.nudge(int(frames), merge_key)
            else:
                self.verbs.raise_by(-down, merge_key)
        else:
            event.ignore()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        painter = QPainter(self.viewport())
        paint_focus(painter, self, self.viewport())
        painter.end()

    def viewportEvent(self, event: QEvent) -> bool:
        return tells(event, self.viewport(), self.tip_at) or bool(super().viewportEvent(event))

    def tip_at(self, at: QPointF) -> str:
        """The values of all curves on the frame under the pointer."""
        frame, unit = self._axis.scale.frame(at.x() + LABEL_WIDTH), SHOWN_AS[self.kind][1]
        told = [
            f"{number(np.interp(frame, line.frames, line.values), '.4g')} {unit}  {line.title}" for line in self.lines
        ]
        return "\n".join([tr("Frame {frame}, {kind}", frame=frame, kind=tr(KINDS[self.kind])), *told])

    def _in_time(self) -> list[ValuePlace]:
        """Where all keys lie, in the order of time."""
        return [line.place(key) for line, key in sorted(self._keys(), key=lambda each: each[1].frame)]


def _distance(a: QPointF, b: QPointF) -> float:
    return float(np.hypot(a.x() - b.x(), a.y() - b.y()))
