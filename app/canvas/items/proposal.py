"""Paints a proposal over its shape: the outlines as they would be, and hatched what would change."""

from __future__ import annotations

from enum import StrEnum

from PySide6.QtCore import Qt
from PySide6.QtGui import QBrush, QColor, QPainter, QPainterPath, QPen

from roam_core.propagate.frame.topology_proposals import Proposal

from ...paint import marks
from ...paint.outline_paths import outline_path
from ...paint.viewport import Viewport

DASHES = [5.0, 4.0]
WIDTH = 2.0
SHADE = QColor(0, 0, 0, 110)
"""Under the hatching, so that it reads on a bright plate too. White, because a shape may have any colour."""


class Side(StrEnum):
    """Which side of a proposal is shown: both at once, or how the shapes are, or how they would be."""

    BOTH = "both"
    BEFORE = "before"
    AFTER = "after"


class ProposalPainter:
    """Remembers the paths of the proposal that it painted last."""

    def __init__(self) -> None:
        self._paths: tuple[Proposal, QPainterPath, QPainterPath] | None = None

    def paint(self, painter: QPainter, viewport: Viewport, proposal: Proposal, side: Side = Side.BOTH) -> None:
        """Paint the outlines after the change, dashed, over those before it, which the canvas has painted.

        Alone, what would be is a whole line, and before it there is nothing to add.
        """
        if side is Side.BEFORE:
            return
        if self._paths is None or self._paths[0] is not proposal:
            self._paths = proposal, *_paths(proposal)
        _, after, differing = self._paths
        painter.setPen(Qt.PenStyle.NoPen)
        if side is Side.BOTH:
            area = viewport.transform.map(differing)
            for brush in (QBrush(SHADE), QBrush(marks.faded(marks.BRIGHT, 0.7), Qt.BrushStyle.BDiagPattern)):
                painter.setBrush(brush)
                painter.drawPath(area)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        path = viewport.transform.map(after)
        painter.setPen(QPen(marks.EDGE, WIDTH + 2 * marks.EDGE_WIDTH))
        painter.drawPath(path)
        pen = QPen(marks.BRIGHT, WIDTH)
        if side is Side.BOTH:
            pen.setDashPattern(DASHES)
        painter.setPen(pen)
        painter.drawPath(path)


def _paths(proposal: Proposal) -> tuple[QPainterPath, QPainterPath]:
    """The outlines after, and the area in which before and after differ, in image coordinates."""
    after, differing = QPainterPath(), QPainterPath()
    differing.setFillRule(Qt.FillRule.OddEvenFill)
    for shape in proposal.after:
        after.addPath(outline_path(shape.at(proposal.frame).points, shape.closed))
    for shape in proposal.before:
        differing.addPath(outline_path(shape.at(proposal.frame).points, shape.closed))
    differing.addPath(after)
    return after, differing
