"""ViewSnapshot: all that the viewer shows of one state, but for where: a value, to be pinned and compared."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from PySide6.QtCore import QSizeF
from PySide6.QtGui import QPainter

from roam_core.propagate.parts.edges import Edges
from roam_core.roto import Project

from ..model.view_state import Selection
from ..model.viewing import Onion, ViewMode
from ..paint.outline_paths import OutlinePaths
from ..paint.viewport import Viewport
from .items.confidence import paint_confidence
from .items.onion import paint_onion
from .items.shapes import Hover, ShapePainter
from .plate.backdrop import Backdrop, Below
from .stabiliser import STANDING, Travel


@dataclass(frozen=True)
class ViewSnapshot:
    """One state of the viewer.

    Attributes
    ----------
    below : what lies below the shapes.
    image : the plate's size in full-resolution pixels, or None where there is no plate.
    mode, onion : how shapes are drawn.
    project, frame : whose shapes.
    shows_shapes : whether they are.
    alone : the names of what is soloed; empty where nothing is.
    edges : of shapes whose outlines are drawn by what kind of edge they are, by their ids.
    travelled : how far a stabilised view had gone along with what it follows, image pixels.
    is_whole : whether the picture or matte below is that of the frame, and none of before in its place.
    chosen : what was selected: whose ghosts the onion skin shows.
    joints : whether those of the shapes are asked for.
    """

    below: Below
    image: QSizeF | None
    mode: ViewMode
    onion: Onion
    project: Project
    frame: int
    shows_shapes: bool
    edges: Mapping[str, Edges] = field(default_factory=dict)
    alone: str = ""
    travelled: Travel = STANDING
    is_whole: bool = True
    chosen: Selection = field(default_factory=Selection)
    joints: bool = False


class SnapshotPainter:
    """Paints snapshots and remembers what lay below the shapes, and the shapes' paths."""

    def __init__(self) -> None:
        self._backdrop, self._shapes = Backdrop(), ShapePainter()

    @property
    def paths(self) -> OutlinePaths:
        """The shapes' outlines, as it remembers them."""
        return self._shapes.paths

    def paint(
        self,
        painter: QPainter,
        snapshot: ViewSnapshot,
        viewport: Viewport,
        ratio: float,
        selection: Selection,
        hover: Hover = None,
        whose: Selection | None = None,
    ) -> None:
        """Paint over the whole widget; only inside of the painter's clip. `whose` ghosts: None for the selection's."""
        whose = selection if whose is None else whose
        self._backdrop.paint(painter, snapshot.below, viewport, snapshot.image, ratio)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if not snapshot.shows_shapes:
            return
        if snapshot.mode is ViewMode.CONFIDENCE:
            paint_confidence(painter, viewport, snapshot.project, snapshot.frame)
        elif snapshot.mode is ViewMode.ONION:
            paint_onion(painter, viewport, snapshot.project, snapshot.frame, whose, snapshot.onion, self._shapes.paths)
        self._shapes.paint(painter, viewport, snapshot.project, snapshot.frame, selection, hover, snapshot.edges)
