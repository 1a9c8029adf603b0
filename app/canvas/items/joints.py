"""Paints where parts hang together: a ring on each joint, and lines from it to the middles of its two parts."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QLineF, QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from roam_core.roto import Project

from ...features.belonging import Bone
from ...model.shown import shown_shapes
from ...paint import marks
from ...paint.viewport import Viewport

RING, MIDDLE = 11.0, 4.0
"""Diameters of a joint's ring, and of the dot on the middle of a part."""
WIDTH = 1.5


def paint_joints(painter: QPainter, viewport: Viewport, project: Project, frame: int, bones: Sequence[Bone]) -> None:
    """Paint the joints of parts that are both in sight, over the shapes; each line is in the colour of its part."""
    colours = {shown.shape.id: QColor.fromRgbF(*shown.shape.colour) for shown in shown_shapes(project, frame)}
    bones = [bone for bone in bones if all(shape_id in colours for shape_id in bone.shapes)]
    painter.save()
    for bone in bones:
        joint = viewport.to_widget(*bone.joint.tolist())
        for shape_id, middle in zip(bone.shapes, bone.middles.tolist(), strict=True):
            _paint_line(painter, joint, viewport.to_widget(*middle), colours[shape_id])
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for bone in bones:
        box = marks.box_around(viewport.to_widget(*bone.joint.tolist()), RING)
        for ink, width in ((marks.EDGE, WIDTH + 2 * marks.EDGE_WIDTH), (marks.BRIGHT, WIDTH)):
            painter.setPen(QPen(ink, width))
            painter.drawEllipse(box)
    painter.restore()


def _paint_line(painter: QPainter, joint: QPointF, middle: QPointF, colour: QColor) -> None:
    """From the rim of a joint's ring to the dot on the middle of a part."""
    line = QLineF(joint, middle)
    if line.length() > RING / 2:
        line.setP1(line.pointAt(RING / 2 / line.length()))
        for ink, width in ((marks.faded(marks.EDGE, 0.6), WIDTH + 2 * marks.EDGE_WIDTH), (colour, WIDTH)):
            painter.setPen(QPen(ink, width))
            painter.drawLine(line)
    painter.setPen(QPen(marks.EDGE, 2 * marks.EDGE_WIDTH))
    painter.setBrush(colour)
    painter.drawEllipse(marks.box_around(middle, MIDDLE + 2 * marks.EDGE_WIDTH))
