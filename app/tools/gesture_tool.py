"""GestureTool: what all tools share that hold one gesture from a press to its release."""

from __future__ import annotations

from ..model.document import Document
from ..model.view_state import ViewState
from ..translation import tr
from .gestures import Gesture
from .tool import Pointer, Tool

DROP_KEYS = frozenset({"Esc", "Ctrl+Z"})
"""Keys that drop a gesture that is under way."""
GROWTH = 1.12
"""How much a notch of the wheel widens a radius."""


class GestureTool(Tool):
    """A tool whose press may begin a gesture; Esc, another tool or a change under its hand drops it."""

    def __init__(self, document: Document, view_state: ViewState) -> None:
        super().__init__(document, view_state)
        self._gesture: Gesture | None = None

    @property
    def claimed_keys(self) -> frozenset[str]:
        return DROP_KEYS if self._gesture else frozenset()

    @property
    def is_busy(self) -> bool:
        return self._gesture is not None

    @property
    def held_place(self) -> tuple[float, float] | None:
        return self._gesture.held_place if self._gesture else None

    def deactivate(self) -> None:
        self.drop()
        self.leave()

    def drag(self, pointer: Pointer) -> None:
        if self._gesture:
            self._gesture.move(pointer)

    def release(self, pointer: Pointer) -> None:
        # Laid down first: the edit that it makes comes back as a change of the document.
        gesture, self._gesture = self._gesture, None
        if gesture:
            gesture.release(pointer)
        self.hover(pointer)

    def refresh(self) -> None:
        gesture = self._gesture
        if gesture and not gesture.is_valid:
            self.drop()
            self.view_state.say(tr("The drag was dropped: its shape or the frame changed meanwhile."))
        elif gesture and gesture.is_dragging:
            gesture.drag(gesture.last)

    def drop(self) -> None:
        gesture, self._gesture = self._gesture, None
        if gesture:
            gesture.drop()

    def key(self, name: str) -> None:
        self.drop()
