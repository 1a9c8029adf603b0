"""How high the timeline is: as the artist dragged it, until then by what was opened, half of the window while tall."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject
from PySide6.QtWidgets import QSplitter

from ... import style

LEAST, SHARE, TALL_SHARE = 200, 0.22, 0.5
"""Pixels and share of the window's height that it has before it is dragged; its share while it is tall."""
ROWS, MOST_SHARE = 2, 0.33
"""Key rows that have room in `LEAST` pixels; the share up to which more rows of an opened project make it higher."""


class TimelineHeight(QObject):
    """Keeps the lower part of a splitter at its height while the window changes its own.

    Before it is dragged it has room for the shapes of the project that was opened; what is drawn since moves nothing.
    `dragged` is the height in pixels that the artist gave it, None before that.
    """

    def __init__(self, halves: QSplitter) -> None:
        super().__init__(halves)
        self._halves = halves
        self.dragged: int | None = None
        self._is_tall, self._rows = False, 0
        halves.splitterMoved.connect(lambda *_: self._note_drag())
        halves.installEventFilter(self)

    def make_tall(self, tall: bool) -> None:
        """Give it half of the window, or what it had before."""
        self._is_tall = tall
        self._pull()

    def make_room(self, rows: int) -> None:
        """Have room for so many key rows, as far as the viewer can spare it, where it was not dragged."""
        self._rows = rows
        self._pull()

    def forget_drag(self) -> None:
        """Give it the height of a new window."""
        self.dragged = None
        self._pull()

    def remembered(self) -> dict[str, dict[str, int]]:
        """What comes back when the window is opened again."""
        return {} if self.dragged is None else {"dragged": {"pixels": self.dragged}}

    def recall(self, kept: dict[str, dict[str, str]]) -> None:
        """Take back what `remembered` gave; what makes no sense stays as it is."""
        pixels = kept.get("dragged", {}).get("pixels")
        if isinstance(pixels, int) and not isinstance(pixels, bool) and pixels > 0:
            self.dragged = pixels
            self._pull()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() is QEvent.Type.Resize:
            self._pull()
        return False

    @property
    def _wanted(self) -> int:
        height = self._halves.height()
        if self._is_tall:
            return round(TALL_SHARE * height)
        if self.dragged is not None:
            return self.dragged
        rows = min(LEAST + (self._rows - ROWS) * style.ROW_HEIGHT, round(MOST_SHARE * height))
        return max(LEAST, round(SHARE * height), rows)

    def _note_drag(self) -> None:
        if not self._is_tall:
            self.dragged = self._halves.sizes()[1]

    def _pull(self) -> None:
        lower = self._wanted
        self._halves.setSizes([self._halves.height() - lower, lower])
