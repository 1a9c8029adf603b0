"""The words on the canvas: what is empty and what to do about it, which view is shown, what is hidden."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QPainter

from ..model.shown import lacks_base
from ..model.viewing import OF_MATTE, WITHOUT_SHAPES, ViewMode, title_of
from ..paint.viewport import Viewport
from ..translation import N_, tr
from .items import edges
from .items.confidence import LEGEND
from .plate.backdrop import paint_label, paint_sentence
from .view_snapshot import ViewSnapshot

NO_BASE = N_("Empty: what is shown only takes away, and nothing lies below it")
OPENING, NO_PLATE = N_("Opening …"), N_("Drop a folder of images or a movie here")


def paint_words(
    painter: QPainter, widget: QSizeF, viewport: Viewport, snapshot: ViewSnapshot, sentence: str, hint: str
) -> None:
    """Paint the `sentence` in the middle of the plate, the view's name at a corner, the `hint` at the lower edge."""
    area = QRectF(QPointF(), widget)
    if snapshot.image is not None:
        area = viewport.transform.mapRect(QRectF(QPointF(), snapshot.image))
    if sentence:
        paint_sentence(painter, area, sentence)
    if label := label_of(snapshot):
        paint_label(painter, widget, label, Qt.AlignmentFlag.AlignTop)
    if hint:
        paint_label(painter, widget, hint, Qt.AlignmentFlag.AlignBottom)


def label_of(snapshot: ViewSnapshot) -> str:
    """What is to be known of the view: nothing where it is the usual one, of all shapes."""
    told = [_view_of(snapshot)]
    if snapshot.alone and snapshot.mode is not ViewMode.SOURCE:
        told.append(tr("Solo: {names}", names=snapshot.alone))
    if snapshot.mode in OF_MATTE and lacks_base(snapshot.project, snapshot.frame):
        told.append(tr(NO_BASE))
    return "  ·  ".join(filter(None, told))


def _view_of(snapshot: ViewSnapshot) -> str:
    if not snapshot.shows_shapes and snapshot.mode not in WITHOUT_SHAPES:
        return tr("Shapes hidden")
    if snapshot.mode is ViewMode.OVERLAY:
        return tr(edges.LEGEND) if snapshot.edges else ""
    return tr(LEGEND) if snapshot.mode is ViewMode.CONFIDENCE else title_of(snapshot.mode)
