"""Where things lie in the timeline of the tests, and the clip that it shows."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QPoint

from app.timeline.keys.row_painter import ROW
from app.timeline.timeline import Timeline
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Clip

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])
CLIP = Clip(Path("shot"), 1001, 1048, (64, 48))


def x_of(timeline: Timeline, frame: int) -> int:
    return round(timeline.axis.scale.x(frame))


def row_middle(index: int) -> int:
    return index * ROW + ROW // 2


def place(timeline: Timeline, frame: int, row: int) -> QPoint:
    """The middle of a frame in a row of keys, in the viewport."""
    return QPoint(x_of(timeline, frame), row_middle(row))
