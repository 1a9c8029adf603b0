"""Undo and redo, and the sentence that says what they did."""

from __future__ import annotations

from collections.abc import Callable

from ..model.document import Document
from ..model.view_state import ViewState
from ..translation import tr


class History:
    """The verbs behind the undo keys. Without a word an undo of something out of sight would seem to do nothing."""

    def __init__(self, document: Document, view_state: ViewState, take_back: Callable[[], bool]) -> None:
        """`take_back()` takes the last step of what a tool has half done back, and says whether there was any."""
        self._stack, self._view, self._take_back = document.undo_stack, view_state, take_back

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "edit.undo": self.undo,
            "edit.redo": self.redo,
        }

    def undo(self) -> None:
        """Take the last step back: that of what is being drawn, else the document's."""
        if self._take_back():
            return
        if text := self._stack.undoText():
            self._stack.undo()
            self._view.say(tr("Undone: {text}.", text=text))

    def redo(self) -> None:
        """Do the step again that was taken back last."""
        if text := self._stack.redoText():
            self._stack.redo()
            self._view.say(tr("Redone: {text}.", text=text))
