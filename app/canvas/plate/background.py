"""BackgroundLayer: what a cut-out lies on: a colour, a checkerboard, or a picture read beside the window's thread."""

from __future__ import annotations

import threading
from pathlib import Path

from PySide6.QtCore import QObject, QPointF, QRectF, QSizeF, Qt, Signal
from PySide6.QtGui import QBrush, QColor, QPainter, QPixmap

from roam_core.arrays import UInt8
from roam_core.errors import RoamError

from ...model.viewing import Background, BackgroundKind
from ...paint.viewport import Viewport
from ...translation import sentence_of
from .picture import Picture

SQUARE = 12
"""Side of the checkerboard's squares, in widget units."""
CHECKERS = QColor("#4a4a4a"), QColor("#6a6a6a")

_Choice = tuple[str, int]
"""The file of a picture, and how often one had been chosen: who chooses the same file again has made another of it."""


class BackgroundLayer(QObject):
    """Gives what to paint under a cut-out.

    Signals
    -------
    ready() : the picture that was asked for has been read, or cannot be.
    refused(sentence) : why it cannot.
    """

    ready = Signal()
    refused = Signal(str)
    _read = Signal(object, object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._picture: tuple[_Choice, Picture | None] = (("", 0), None)
        # One brush for good: another one, though it looks alike, would be another background to paint.
        self._checkers = checkerboard()
        self._thread: threading.Thread | None = None
        self._wanted: _Choice = ("", 0)
        self._read.connect(self._take)

    def of(self, background: Background) -> Picture | QBrush:
        """What the background is painted with; a checkerboard until its picture has been read."""
        if background.kind is BackgroundKind.COLOUR:
            return QBrush(QColor(background.colour))
        if background.kind is BackgroundKind.CHECKER:
            return self._checkers
        choice = background.image, background.choice
        if choice != self._wanted:
            self._wanted = choice
            if self._thread is None:
                self._start()
        held, picture = self._picture
        return picture if picture is not None and held == choice else self._checkers

    def close(self) -> None:
        """Wait for the picture that is being read."""
        if self._thread is not None:
            self._thread.join()

    def _start(self) -> None:
        self._thread = threading.Thread(target=self._work, args=(self._wanted,), name="ground")
        self._thread.start()

    def _work(self, choice: _Choice) -> None:
        """On a thread of its own: the signal brings the result back to the window's."""
        found: UInt8 | str = ""
        try:
            found = _read(Path(choice[0]))
        except RoamError as error:
            found = sentence_of(error)
        finally:  # after any other error, too, which goes its own way: the next picture has to be read
            self._read.emit(choice, found)

    def _take(self, choice: _Choice, found: UInt8 | str) -> None:
        if self._thread is not None:
            self._thread.join()  # this was its last word
        self._thread = None
        self._picture = choice, None if isinstance(found, str) else Picture(found)
        if isinstance(found, str) and found:
            self.refused.emit(found)
        if choice != self._wanted:
            self._start()
        self.ready.emit()


def checkerboard() -> QBrush:
    """Squares of two greys."""
    tile = QPixmap(2 * SQUARE, 2 * SQUARE)
    tile.fill(CHECKERS[0])
    painter = QPainter(tile)
    for corner in (0, SQUARE):
        painter.fillRect(corner, corner, SQUARE, SQUARE, CHECKERS[1])
    painter.end()
    return QBrush(tile)


def paint_background(
    painter: QPainter, background: Picture | QBrush, viewport: Viewport, image: QSizeF, ratio: float
) -> None:
    """Paint a background over the plate's area; a picture of another form fills it and is cut off at its sides."""
    area = viewport.transform.mapRect(QRectF(QPointF(), image))
    if isinstance(background, QBrush):
        painter.fillRect(area, background)
        return
    grow = max(image.width() / background.size.width(), image.height() / background.size.height())
    size = background.size * grow
    corner = viewport.to_widget((image.width() - size.width()) / 2, (image.height() - size.height()) / 2)
    painter.save()
    painter.setClipRect(area, Qt.ClipOperation.IntersectClip)
    background.paint(painter, Viewport(viewport.scale, corner.x(), corner.y(), viewport.pixel_aspect), size, ratio)
    painter.restore()


def _read(path: Path) -> UInt8:
    from roam_core.media import open_clip
    from roam_core.media.colour import to_display
    from roam_core.media.decoding import read_image

    # The one picture that was chosen, in the colour space of the sequence that it may be of.
    pixels = to_display(read_image(path), open_clip(path).colour_space)
    pixels.setflags(write=False)
    return pixels
