"""The second viewer: another view of the same frame, with its own zoom; the tool in the hand is that of the first."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from PySide6.QtCore import QSize
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from roam_core.arrays import UInt8

from ..canvas.view import CanvasView
from ..model.viewing import ViewMode, title_of
from ..translation import tr
from ..widgets.controls import ChoiceBox

LEAST_WIDTH = 200


class SecondViewer(QWidget):
    """Makes its viewer when it is first shown, and gives it pictures only while it is seen.

    `make` gives the viewer, `present` the frame and picture that the first viewer shows.
    """

    def __init__(self, make: Callable[[], CanvasView], present: Callable[[], tuple[int, UInt8 | None] | None]) -> None:
        super().__init__()
        self._make, self._present = make, present
        self.canvas: CanvasView | None = None
        self._waits = self._lacks_plate = False
        self.mode = ChoiceBox(tr("What the second viewer shows"))
        for mode in ViewMode:
            self.mode.addItem(title_of(mode), mode)
        self.mode.setCurrentIndex(self.mode.findData(ViewMode.MATTE))
        self.mode.activated.connect(self._push_mode)
        self.setMinimumWidth(LEAST_WIDTH)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)

    def sizeHint(self) -> QSize:
        return QSize(960, 600)

    def set_image(self, frame: int, image: UInt8 | None) -> None:
        """The plate's picture of a frame, as for the first viewer."""
        if self.canvas is not None and self.isVisible():
            self.canvas.set_image(frame, image)

    def set_waiting(self, waits: bool, lacks_plate: bool) -> None:
        """What the empty viewer says, as the first one."""
        self._waits, self._lacks_plate = waits, lacks_plate
        if self.canvas is not None:
            self.canvas.set_waiting(waits, lacks_plate)

    def remembered(self) -> dict[str, dict[str, Any]]:
        """What comes back when the window is opened again."""
        return {"view": {"mode": str(self.mode.currentData())}}

    def recall(self, kept: Mapping[str, Mapping[str, Any]]) -> None:
        """Take back what `remembered` gave; what makes no sense stays as it is."""
        index = self.mode.findData(kept.get("view", {}).get("mode"))
        if index >= 0:
            self.mode.setCurrentIndex(index)
            self._push_mode()

    def showEvent(self, event: QShowEvent) -> None:
        if self.canvas is None:
            self.canvas = self._make()
            column = self.layout()
            assert column is not None
            column.addWidget(self.canvas)
            self._push_mode()
            self.canvas.set_waiting(self._waits, self._lacks_plate)
            self.canvas.view_changed.connect(self._pull_mode)
        if (present := self._present()) is not None:
            self.canvas.set_image(*present)

    def _push_mode(self, _index: int = 0) -> None:
        if self.canvas is not None:
            self.canvas.viewing.set_mode(self.mode.currentData())

    def _pull_mode(self) -> None:
        if self.canvas is not None:
            self.mode.setCurrentIndex(self.mode.findData(self.canvas.mode))
