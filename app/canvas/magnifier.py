"""Magnifier: the place to which a point is dragged, enlarged beside the pointer, which with the marks would hide it."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from PySide6.QtCore import QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from roam_core.media.looking import Look
from roam_core.roto import Project

from ..features.verbs.finishing import next_colour
from ..model.shown import shown_shapes
from ..paint import marks
from ..paint.clipping import painted_area
from ..paint.feather import paint_feather
from ..paint.outline_paths import OutlinePaths
from ..paint.viewport import Viewport
from ..tools.in_hand import ToolInHand
from .items.shapes import ink
from .plate.picture import Picture

SIDE = 161
"""Of the window, in widget units; odd, so that the cross lies on whole pixels."""
CLOSER = 4.0
"""How much larger than in the viewer everything is shown."""
ASIDE = 32.0
"""Room between the pointer and the window, in widget units."""
ARM, GAP = 14.0, 3.0
"""How far the lines of the cross reach, and how much of the place itself they leave free, in widget units."""
LINE_WIDTH = 1.0


class Scene(NamedTuple):
    """What a viewer shows.

    Attributes
    ----------
    picture : the plate's, or None where there is none to look at.
    size : what it covers, in full-resolution pixels.
    look : how it is looked at.
    project, frame : whose shapes; a drag's preview while there is one.
    viewport : where the picture lies in the viewer.
    """

    picture: Picture | None
    size: QSizeF
    look: Look
    project: Project
    frame: int
    viewport: Viewport


class Magnifier(QWidget):
    """A small window over `viewer` while the hand holds a point there; every event goes through it.

    `scene` gives what the viewer shows, or None while nothing is to be magnified; `paths` remembers outlines.
    """

    def __init__(
        self, viewer: QWidget, hand: ToolInHand, scene: Callable[[], Scene | None], paths: OutlinePaths
    ) -> None:
        super().__init__(viewer)
        self._viewer, self._in_hand, self._scene, self._paths = viewer, hand, scene, paths
        self._pointer: QPointF | None = None
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.resize(SIDE, SIDE)
        self.hide()
        hand.used.connect(self._follow_pointer)
        hand.changed.connect(self.follow)

    def _follow_pointer(self, viewer: object, position: tuple[float, float] | None) -> None:
        """The tool was used in some viewer, at an image position."""
        if viewer is not self._viewer:
            self._pointer = None
        elif position is not None and (scene := self._scene()) is not None:
            self._pointer = scene.viewport.to_widget(*position)
        self.follow()

    def follow(self, *_: object) -> None:
        """Show, move or hide the window by what is in the hand now."""
        scene, corner = self._scene(), None
        place = self._in_hand.tool.held_place if scene is not None and scene.picture is not None else None
        if scene is not None and place is not None and self._pointer is not None:
            corner = beside(self._pointer, scene.viewport.to_widget(*place), QSizeF(self._viewer.size()))
        if corner is not None:
            self.move(corner.toPoint())
            self.raise_()
            self.update()
        self.setVisible(corner is not None)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        scene, place = self._scene(), self._in_hand.tool.held_place
        if scene is not None and scene.picture is not None and place is not None:
            painter.setClipRect(self.rect())
            self._paint(painter, scene, scene.picture, place)
        painter.end()

    def _paint(self, painter: QPainter, scene: Scene, picture: Picture, place: tuple[float, float]) -> None:
        painter.fillRect(self.rect(), marks.SURROUND)
        viewport = scene.viewport.enlarged(CLOSER, place, QSizeF(self.size()))
        picture.paint(painter, viewport, scene.size, self.devicePixelRatioF(), scene.look)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._paint_outlines(painter, scene, viewport)
        _paint_cross(painter, QRectF(self.rect()).center())
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for ring, colour in enumerate((marks.SURROUND, marks.WEAK_TEXT, marks.SURROUND)):
            painter.setPen(colour)
            painter.drawRect(self.rect().adjusted(ring, ring, -1 - ring, -1 - ring))

    def _paint_outlines(self, painter: QPainter, scene: Scene, viewport: Viewport) -> None:
        """The outlines as they will be, thin, with what is drawn and no shape yet."""
        area = painted_area(painter, viewport)
        for item in shown_shapes(scene.project, scene.frame):
            if (path := self._paths.in_sight(item.shape, scene.frame, area)) is not None:
                marks.stroke(painter, viewport.transform.map(path), ink(item), LINE_WIDTH)
        paint_feather(painter, viewport, scene.project, scene.frame, frozenset())
        if not (drawn := self._in_hand.tool.held_outline).isEmpty():
            marks.stroke(painter, viewport.transform.map(drawn), next_colour(scene.project), LINE_WIDTH)


def beside(pointer: QPointF, place: QPointF, viewer: QSizeF) -> QPointF | None:
    """The corner of the window where it hides neither the pointer nor the point; None where the viewer has no room.

    Up and to the right, else where it fits inside of the viewer, all in widget units.
    """
    if min(viewer.width(), viewer.height()) < SIDE:
        return None
    for across, down in ((1.0, -1.0), (-1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)):
        middle = pointer + QPointF(across, down) * (ASIDE + SIDE / 2)
        corner = middle - QPointF(SIDE, SIDE) / 2
        corner.setX(min(max(corner.x(), 0.0), viewer.width() - SIDE))
        corner.setY(min(max(corner.y(), 0.0), viewer.height() - SIDE))
        kept_free = QRectF(corner, QSizeF(SIDE, SIDE)).adjusted(-ASIDE / 2, -ASIDE / 2, ASIDE / 2, ASIDE / 2)
        if not kept_free.contains(pointer) and not kept_free.contains(place):
            return corner
    return None


def _paint_cross(painter: QPainter, at: QPointF) -> None:
    """Four thin lines about the exact place; what lies in it is seen between them."""
    for colour, width in ((marks.EDGE, 2.5), (marks.BRIGHT, 1.0)):
        painter.setPen(QPen(colour, width, Qt.PenStyle.SolidLine, Qt.PenCapStyle.FlatCap))
        for side in (QPointF(1.0, 0.0), QPointF(-1.0, 0.0), QPointF(0.0, 1.0), QPointF(0.0, -1.0)):
            painter.drawLine(at + side * GAP, at + side * ARM)
