"""The read-out: where the pointer is on the plate, and the values of the pixel under it."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel, QWidget

from ...canvas.plate.pixel_marks import values_text
from ...canvas.view import CanvasView
from ...translation import number, tr

WIDEST = "x 8888.8  y 8888.8    R 255  G 255  B 255  A 255"


class Readout(QLabel):
    """`x 512.4  y 220.1   R 103  G 98  B 71`: position in full-resolution pixels, values as the plate holds them."""

    def __init__(self, canvas: CanvasView, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._canvas = canvas
        self._position: tuple[float, float] | None = None
        self.setObjectName("weak")
        self.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self.setToolTip(tr("The pixel under the pointer; the values are the plate's own, before exposure and gamma"))
        canvas.pointer_moved.connect(self._follow)
        for signal in (canvas.stage.changed, canvas.view_changed):  # another view shows another picture
            signal.connect(self._pull)

    @property
    def widest(self) -> int:
        """The width that positions of four figures and values of eight bits take."""
        return self.fontMetrics().horizontalAdvance(WIDEST)

    def _follow(self, position: tuple[float, float] | None) -> None:
        self._position = position
        self._pull()

    def _pull(self) -> None:
        self.setText("" if self._position is None else self._words(*self._position))

    def _words(self, x: float, y: float) -> str:
        where = f"x {number(x, '.1f')}  y {number(y, '.1f')}"
        picture, size = self._canvas.stage.shown_picture(), self._canvas.plate_size()
        if picture is None:
            return where
        # A proxy has fewer pixels than the plate.
        column, row = x * picture.size.width() / size.width(), y * picture.size.height() / size.height()
        if not (0 <= column < picture.size.width() and 0 <= row < picture.size.height()):
            return where
        values = picture.value(column, row)
        texts = values_text(values)
        if len(texts) == 1:
            return f"{where}    A {texts[0]}"
        opacity = picture.opacity(column, row)
        told = "" if opacity is None else f"  A {opacity}"
        return f"{where}    R {texts[0]}  G {texts[1]}  B {texts[2]}{told}"
