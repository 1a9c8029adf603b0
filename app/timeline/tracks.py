"""The rows of planar tracks: how far each can be trusted, frame by frame, and its adjust keys.

There while there are tracks. A row is a layer that one moves; its line is the confidence, from none at the bottom to
full at the top, and what lies under the line of doubt is filled. A frame is a click away.
"""

from __future__ import annotations

from itertools import pairwise

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QWidget

from roam_core.params import DOUBTFUL, is_doubtful
from roam_core.roto import Layer, LayerTransform
from roam_core.roto.following import unpinned

from .. import style
from ..model.document import Document
from ..translation import tr
from .axis import TimeAxis
from .keys.row_painter import BACKGROUND, DIAMOND, ROW
from .row_band import RowBand
from .scale import LABEL_WIDTH

GRAB = 6
MOST = 3
"""Rows that have room at once; the others scroll."""
MARGIN = 3.0
"""Pixels between a row's edges and no or full confidence."""


class TrackBand(RowBand[Layer]):
    """Click a frame to go there, an adjust key too; right-click an adjust key to remove it; click a name to select."""

    def __init__(self, document: Document, axis: TimeAxis, parent: QWidget | None = None) -> None:
        super().__init__(document, axis, parent)
        self._scrubs = False
        self.pull()

    def rows(self) -> list[Layer]:
        """The tracks that are shown: those of the selected shapes, or else all."""
        moving = [
            item
            for item in self._document.project.root.items()
            if isinstance(item, Layer) and item.transform is not None and len(item.transform.frames) > 1
        ]
        chosen = self._axis.view_state.selection.shapes
        meant = [layer for layer in moving if any(shape.id in chosen for shape in layer.shapes())]
        return meant or moving

    def adjust_key_at(self, at: QPointF) -> tuple[Layer, int] | None:
        """The adjust key near a place, with its layer."""
        layer = self.row_at(at.y())
        if layer is None:
            return None
        distance, frame = self._axis.scale.nearest(_of(layer).adjusted, at.x())
        return None if frame is None or distance > GRAB else (layer, frame)

    # ---- events

    def mousePressEvent(self, event: QMouseEvent) -> None:
        at, key = event.position(), self.adjust_key_at(event.position())
        self._scrubs = event.button() == Qt.MouseButton.LeftButton and at.x() >= LABEL_WIDTH
        if event.button() == Qt.MouseButton.RightButton and key is not None:
            if self._document.project.is_locked(key[0].id):
                self._axis.view_state.say(
                    tr("{name} is locked; unlock it to remove its adjust keys.", name=key[0].name)
                )
                return
            after = unpinned(self._document.project, key[0].id, key[1])
            self._document.apply(tr("Remove adjust key"), after)
        elif event.button() == Qt.MouseButton.LeftButton and key is not None:
            self._axis.view_state.set_frame(key[1])
        elif event.button() == Qt.MouseButton.LeftButton and at.x() < LABEL_WIDTH:
            layer = self.row_at(at.y())
            if layer is not None:
                self._axis.view_state.select(frozenset(shape.id for shape in layer.shapes()))
        elif event.button() == Qt.MouseButton.LeftButton:
            self._axis.scrub(at.x())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton and self._scrubs:
            self._axis.scrub(event.position().x())

    def tip_at(self, at: QPointF) -> str:
        """What is said of the track on the frame under the pointer."""
        layer = self.row_at(at.y())
        if layer is None:
            return ""
        key = self.adjust_key_at(at)
        if at.x() < LABEL_WIDTH and key is None:
            return tr("The motion of {name}: click to select its shapes", name=layer.name)
        if key is not None:
            return tr(
                "Frame {frame}: an adjust key of {name}\nClick to go there, right-click to remove it",
                frame=key[1],
                name=layer.name,
            )
        frame = self._axis.scale.frame(at.x())
        return tr("Frame {frame}: {told}", frame=frame, told=_told(_of(layer), frame))

    # ---- painting

    def name_of(self, row: Layer) -> str:
        return row.name

    def paint_row(self, painter: QPainter, row: Layer) -> None:
        own, scale = _of(row), self._axis.scale
        painter.setPen(QPen(QColor(BACKGROUND), 1, Qt.PenStyle.DotLine))
        painter.drawLine(QLineF(scale.x(own.frames[0]), _y(DOUBTFUL), scale.x(own.frames[-1]), _y(DOUBTFUL)))
        self._paint_confidence(painter, own)

    def paint_keys(self, painter: QPainter, row: Layer) -> None:
        scale = self._axis.scale
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(QColor(style.EDGE), 1))
        painter.setBrush(QColor(style.ACCENT))
        for frame in _of(row).adjusted:
            if scale.has_left_of(frame):
                continue
            x, middle = scale.x(frame), ROW / 2
            corners = ((0.0, -DIAMOND), (DIAMOND, 0.0), (0.0, DIAMOND), (-DIAMOND, 0.0))
            painter.drawPolygon(QPolygonF([QPointF(x + dx, middle + dy) for dx, dy in corners]))

    def _paint_confidence(self, painter: QPainter, own: LayerTransform) -> None:
        """The line, broken where frames are missing; every doubtful frame is filled up to the line of doubt."""
        scale = self._axis.scale
        for frame, value in own.confidence:
            if is_doubtful(value):
                left, top = scale.x(frame) - scale.pixels / 2, _y(DOUBTFUL)
                painter.fillRect(QRectF(left, top, max(scale.pixels, 1.0), _y(value) - top), QColor(style.DOUBT))
        painter.setPen(QPen(QColor(style.TEXT), 1))
        pairs = list(own.confidence)
        for (a, before), (b, after) in pairwise(pairs):
            if b - a == 1:
                painter.drawLine(QLineF(scale.x(a), _y(before), scale.x(b), _y(after)))


def _of(layer: Layer) -> LayerTransform:
    assert layer.transform is not None
    return layer.transform


def _y(confidence: float) -> float:
    """Where a confidence lies in a row, in pixels from its top."""
    return MARGIN + (1.0 - confidence) * (ROW - 1 - 2 * MARGIN)


def _told(own: LayerTransform, frame: int) -> str:
    value = dict(own.confidence).get(frame)
    if value is None:
        return tr("tracked before confidence was kept") if frame in own.frames else tr("not tracked")
    if value == 0.0:
        return tr("hidden: the motion goes evenly from the frames before to those after")
    return tr("confidence {confidence:.2f}", confidence=value) + (tr(", worth a look") if is_doubtful(value) else "")
