"""The words on the canvas: what is empty and what to do about it, which view is shown, what is hidden."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QPainter

from ..actions.keymaps import told
from ..model.shown import lacks_base
from ..model.view_state import ViewState
from ..model.viewing import OF_MATTE, WITHOUT_SHAPES, ViewMode, title_of
from ..paint.viewport import Viewport
from ..translation import N_, tr
from .items import edges
from .items.confidence import LEGEND
from .plate.backdrop import paint_label, paint_sentence
from .plate.stage import Stage
from .view_snapshot import ViewSnapshot

DRAW_HINT = N_("Draw a shape: press <tool.bezier>")
NO_BASE = N_("Empty: what is shown only takes away, and nothing lies below it")
NO_JOINTS = N_("Joints: on frames with keys of yours alone")
OPENING, NO_PLATE = N_("Opening …"), N_("Drop a folder of images or a movie here")


class Words:
    """The words on one viewer.

    Attributes
    ----------
    is_waiting : a plate is being opened. lacks_plate : that of the project could not be.
    """

    def __init__(self, stage: Stage, view_state: ViewState) -> None:
        self._stage, self._view_state = stage, view_state
        self.is_waiting = self.lacks_plate = False

    def paint(
        self, painter: QPainter, widget: QSizeF, viewport: Viewport, snapshot: ViewSnapshot, *, is_idle: bool
    ) -> None:
        """Why the plate is empty, in its middle; the view's name at a corner; while `is_idle` the hint below."""
        area = QRectF(QPointF(), widget)
        if snapshot.image is not None:
            area = viewport.transform.mapRect(QRectF(QPointF(), snapshot.image))
        if sentence := self.sentence(snapshot):
            paint_sentence(painter, area, sentence)
        if label := label_of(snapshot):
            paint_label(painter, widget, label, Qt.AlignmentFlag.AlignTop)
        if is_idle and snapshot.image is not None and snapshot.shows_shapes and not snapshot.project.shapes:
            paint_label(painter, widget, self.hint, Qt.AlignmentFlag.AlignBottom)

    @property
    def hint(self) -> str:
        """What to do next, said while the project has no shape."""
        return told(tr(DRAW_HINT), self._view_state.keymap)

    def sentence(self, snapshot: ViewSnapshot) -> str:
        if snapshot.image is None:
            return tr(OPENING) if self.is_waiting else tr(NO_PLATE)
        return self._stage.emptiness(self.lacks_plate)


def label_of(snapshot: ViewSnapshot) -> str:
    """What is to be known of the view: nothing where it is the usual one, of all shapes."""
    told = [_view_of(snapshot)]
    if snapshot.alone and snapshot.mode is not ViewMode.SOURCE:
        told.append(tr("Solo: {names}", names=snapshot.alone))
    if snapshot.joints and snapshot.shows_shapes and not _has_key(snapshot):
        told.append(tr(NO_JOINTS))
    if snapshot.mode in OF_MATTE and lacks_base(snapshot.project, snapshot.frame):
        told.append(tr(NO_BASE))
    return "  ·  ".join(filter(None, told))


def _has_key(snapshot: ViewSnapshot) -> bool:
    return any(snapshot.frame in shape.artist_frames for shape in snapshot.project.shapes)


def _view_of(snapshot: ViewSnapshot) -> str:
    if not snapshot.shows_shapes and snapshot.mode not in WITHOUT_SHAPES:
        return tr("Shapes hidden")
    if snapshot.mode is ViewMode.OVERLAY:
        return tr(edges.LEGEND) if snapshot.edges else ""
    return tr(LEGEND) if snapshot.mode is ViewMode.CONFIDENCE else title_of(snapshot.mode)
