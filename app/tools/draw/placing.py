"""PlacingTool: what the tools have in common that place a shape by clicks, one after the other."""

from __future__ import annotations

from abc import ABC, abstractmethod

from PySide6.QtCore import Qt

from ...model.document import Document
from ...model.view_state import ViewState
from ...translation import N_, tr
from ..tool import Pointer, Tool

FINISH_KEYS = frozenset({"Return", "Enter"})
TAKE_BACK_KEYS = frozenset({"Backspace", "Del", "Ctrl+Z"})
LEAVE_KEYS = frozenset({"Esc"})
TOO_FEW = N_("A closed shape needs at least {min_points_closed} points; click to place more.")


class PlacingTool(Tool, ABC):
    """While something is placed, its keys belong to the tool; over the first point the pointer shows that it closes."""

    def __init__(self, document: Document, view_state: ViewState) -> None:
        super().__init__(document, view_state)
        self._hover: Pointer | None = None

    @property
    @abstractmethod
    def is_begun(self) -> bool:
        """True while a shape is half drawn."""

    @abstractmethod
    def _closes(self, pointer: Pointer) -> bool:
        """True where a press would close the shape."""

    @property
    def cursor(self) -> Qt.CursorShape:
        closes = self._hover is not None and self._closes(self._hover)
        return Qt.CursorShape.PointingHandCursor if closes else Qt.CursorShape.CrossCursor

    @property
    def claimed_keys(self) -> frozenset[str]:
        return FINISH_KEYS | TAKE_BACK_KEYS | LEAVE_KEYS if self.is_begun else frozenset()

    def activate(self) -> None:
        super().activate()
        self._hover = None

    def leave(self) -> None:
        self._hover = None

    @property
    def last_step(self) -> str:
        return tr("Last point") if self.is_begun else ""
