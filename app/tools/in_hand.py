"""ToolInHand: the tools of all viewers, one of which is in the hand; what one viewer begins goes on in another."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from ..jobs.picture_work import PictureWork
from ..model.document import Document
from ..model.view_state import ViewState
from .edit.eraser import Eraser
from .tool import Tool
from .toolbox import TOOLS


class ToolInHand(QObject):
    """Follows `view_state.tool`.

    Signals
    -------
    changed() : another tool is in the hand.
    looked() : a tool has found something in the picture.
    used(viewer, position) : in that viewer the tool was given the pointer at an image position `(x, y)`; None where the
        pointer left it, or a key was pressed.
    """

    changed = Signal()
    looked = Signal()
    used = Signal(object, object)

    def __init__(self, document: Document, view_state: ViewState, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._view_state = view_state
        self._tools: dict[str, Tool] = {name: tool(document, view_state) for name, tool in TOOLS.items()}
        self._tool = self._tools[view_state.tool]
        self._eraser, self._erases = Eraser(document, view_state), False
        view_state.ask_hand(lambda: self.tool.is_busy)
        self._tool.activate()
        view_state.tool_changed.connect(self._take)

    @property
    def tool(self) -> Tool:
        """The tool in the hand; while the other end of a pen is down, the eraser."""
        return self._eraser if self._erases else self._tool

    def turn_pen(self, erases: bool) -> None:
        """The other end of the pen is down, or no longer."""
        if self._erases and not erases:
            self._eraser.drop()
        self._erases = erases

    def take_back(self) -> bool:
        """Take the last step of what the tool has half done back; False where there is none."""
        if not self.tool.take_back():
            return False
        self.used.emit(None, None)
        return True

    def lend(self, pictures: PictureWork) -> None:
        """Let the tools look at the picture that is shown."""
        for tool in self._tools.values():
            tool.pictures = pictures
        pictures.looked.connect(self.looked)

    def _take(self) -> None:
        """Put the tool that the view state names into the hand."""
        self.turn_pen(False)
        self._tool.deactivate()
        self._tool = self._tools[self._view_state.tool]
        self._tool.activate()
        self.changed.emit()
