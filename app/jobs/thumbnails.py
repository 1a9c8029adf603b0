"""Small pictures of recent projects: drawn and read on the worker, never on the window's thread."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, QPointF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QImage, QPainter, QPen, QPixmap, QPolygonF

from roam_core.roto import Project

from .. import style
from ..model.recent import Recent
from ..model.shown import shown_shapes
from .runner import Report, Runner

if TYPE_CHECKING:
    from numpy.typing import NDArray

SIZE = QSize(352, 198)
"""Twice the size at which they are shown: sharp on screens of any density."""
OUTLINE_WIDTH = 3.0
GREY = 56


@dataclass(frozen=True)
class RecentEntry:
    """What was found out about a recent entry: whether it is still there, and its picture if it has one."""

    recent: Recent
    is_there: bool
    picture: QImage | None


class Thumbnails(QObject):
    """Keeps pictures in a folder of the cache; without one (`cache` is None) it keeps none.

    Signals
    -------
    seen(entries) : the list of `RecentEntry` that `look` asked for, in its order.
    """

    seen = Signal(object)

    def __init__(self, cache: Path | None, runner: Runner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._cache, self._runner = cache, runner

    def keep(
        self, recent: Recent, pixels: NDArray[Any], project: Project, frame: int, others: tuple[Recent, ...] = ()
    ) -> None:
        """Draw a picture of a project: its plate `(h, w, 3)` uint8 on a frame, and the outlines on it.

        Only the pictures of `others` stay beside it.
        """
        if self._cache is None:
            return
        target = recent.picture_in(self._cache)
        kept = {target, *(other.picture_in(self._cache) for other in others)}

        def work(report: Report) -> str:
            target.parent.mkdir(parents=True, exist_ok=True)
            drawn(pixels, project, frame).save(str(target))
            for old in set(target.parent.glob("*.png")) - kept:
                old.unlink(missing_ok=True)
            return ""

        self._runner.start(f"thumbnail of {recent.path}", work)

    def look(self, entries: tuple[Recent, ...]) -> None:
        """Find out what is still there; disks may be slow or gone."""
        cache = self._cache

        def work(report: Report) -> str:
            report.partial([_entry(recent, cache) for recent in entries])
            return ""

        self._runner.start("recent", work).partial.connect(self.seen)


def drawn(pixels: NDArray[Any], project: Project, frame: int) -> QImage:
    """The plate `(h, w, 3)` uint8, filling `SIZE`, with the outlines of the visible shapes in their colours."""
    height, width = pixels.shape[:2]
    plate = QImage(pixels.tobytes(), width, height, 3 * width, QImage.Format.Format_RGB888)
    result = QImage(SIZE, QImage.Format.Format_RGB32)
    scale = max(SIZE.width() / width, SIZE.height() / height)
    smooth = Qt.TransformationMode.SmoothTransformation
    small = plate.scaled(round(width * scale), round(height * scale), Qt.AspectRatioMode.IgnoreAspectRatio, smooth)
    left, top = (SIZE.width() - small.width()) / 2, (SIZE.height() - small.height()) / 2
    painter = QPainter(result)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.drawImage(QPointF(left, top), small)
    # Shapes lie in full-size pixels; a proxy's picture has fewer.
    across = small.width() / (project.clip.size[0] if project.clip else width)
    for shown in shown_shapes(project, frame):
        outline = shown.shape.at(frame).flatten(1.0) * across + (left, top)
        painter.setPen(QPen(QColor.fromRgbF(*shown.shape.colour), OUTLINE_WIDTH))
        polygon = QPolygonF([QPointF(x, y) for x, y in outline.tolist()])
        if shown.shape.closed:
            painter.drawPolygon(polygon)
        else:
            painter.drawPolyline(polygon)
    painter.end()
    return result


def grey_plate(size: tuple[int, int]) -> NDArray[Any]:
    """A plate `(h, w, 3)` uint8 in the proportions of `size` (width, height), where there is none to be had."""
    import numpy as np

    width = SIZE.width()
    return np.full((max(1, round(width * size[1] / max(size[0], 1))), width, 3), GREY, dtype=np.uint8)


def empty_picture(size: QSize) -> QPixmap:
    """A frame with nothing in it."""
    pixmap = QPixmap(size)
    pixmap.fill(QColor(style.FIELD))
    painter = QPainter(pixmap)
    painter.setPen(QColor(style.LINE))
    painter.drawRect(0, 0, size.width() - 1, size.height() - 1)
    painter.end()
    return pixmap


def _entry(recent: Recent, cache: Path | None) -> RecentEntry:
    try:
        # A pattern (`plate.%04d.exr`) is no file itself; its folder tells.
        is_there = recent.path.exists() or ("%" in recent.path.name and recent.path.parent.is_dir())
    except OSError:
        is_there = False
    picture = QImage() if cache is None else QImage(str(recent.picture_in(cache)))
    return RecentEntry(recent, is_there, None if picture.isNull() else picture)
