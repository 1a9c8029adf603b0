"""Tool: what every tool of the canvas is. The view hands it the pointer in image coordinates and the keys it claims."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter, QPainterPath

from ..jobs.picture_work import PictureWork
from ..model.document import Document
from ..model.view_state import ViewState
from ..paint.viewport import Viewport
from ..translation import tr

Modifier = Qt.KeyboardModifier


@dataclass(frozen=True)
class Pointer:
    """The pointer over the picture.

    Attributes
    ----------
    position : (x, y) in image pixels.
    pixel : size of a screen pixel, in image pixels along x and y: the measure of hit areas and drag thresholds.
    modifiers : the keys that are held.
    pressure : how hard a pen presses, in [0, 1]; 1 for a mouse.
    """

    position: tuple[float, float]
    pixel: tuple[float, float]
    modifiers: Qt.KeyboardModifier = Modifier.NoModifier
    pressure: float = 1.0

    def holds(self, modifiers: Qt.KeyboardModifier) -> bool:
        """True when all of these keys are held."""
        return self.modifiers & modifiers == modifiers

    def screen_distance(self, position: tuple[float, float]) -> float:
        """Distance to an image position, in screen pixels."""
        dx, dy = (a - b for a, b in zip(self.position, position, strict=True))
        return float(((dx / self.pixel[0]) ** 2 + (dy / self.pixel[1]) ** 2) ** 0.5)


class Tool:
    """Base of the tools. A tool reads `document` and `view_state`, and edits through `document.apply` alone.

    The view repaints after every call, so a tool never asks for it.
    """

    name: ClassVar[str] = ""
    title: ClassVar[str] = ""
    hint: ClassVar[str] = ""
    """What to do with the tool, for the status bar; it goes with the tool."""
    is_hint_shy: ClassVar[bool] = False
    """Whether the hint is told only in place of another tool's: what was just done and said matters more."""

    def __init__(self, document: Document, view_state: ViewState) -> None:
        self.document = document
        self.view_state = view_state
        self.pictures: PictureWork | None = None
        """Gives the picture that is shown, and looks at it off the window's thread; None where no one lent it."""

    @property
    def cursor(self) -> Qt.CursorShape:
        """The pointer's form: it shows what a press would do."""
        return Qt.CursorShape.ArrowCursor

    def activate(self) -> None:
        """The tool comes into the hand."""
        self.view_state.say_hint(tr(self.hint), is_shy=self.is_hint_shy)

    def deactivate(self) -> None:
        """The tool is laid down; nothing may be left half done."""

    def press(self, pointer: Pointer) -> None:
        """The left button goes down."""

    def drag(self, pointer: Pointer) -> None:
        """The pointer moves with the button down."""

    def release(self, pointer: Pointer) -> None:
        """The left button comes up."""

    def double_press(self, pointer: Pointer) -> None:
        """The second press of a double click; the first went to `press`."""
        self.press(pointer)

    def hover(self, pointer: Pointer) -> None:
        """The pointer moves, or a modifier changes, with no button down."""

    def wheel(self, pointer: Pointer, notches: float) -> bool:
        """Ctrl and the wheel, by so many notches, up positive; False when the tool has no use for them."""
        return False

    def leave(self) -> None:
        """The pointer left the canvas."""

    def refresh(self) -> None:
        """The project or the frame changed, perhaps under a drag."""

    def drop(self) -> None:
        """Forget what is half done: another project was opened."""

    @property
    def claimed_keys(self) -> frozenset[str]:
        """Keys that belong to the tool right now, before any shortcut of the window: `Esc` during a drag."""
        return frozenset()

    @property
    def is_busy(self) -> bool:
        """True while something half done is in the hand: a drag, or a shape that is being drawn."""
        return bool(self.claimed_keys)

    @property
    def held_place(self) -> tuple[float, float] | None:
        """Where a single point or handle lies that is in the hand with the button down; None while there is none."""
        return None

    @property
    def held_outline(self) -> QPainterPath:
        """What of the outline through it the project does not know yet, in image coordinates."""
        return QPainterPath()

    @property
    def last_step(self) -> str:
        """What `take_back` takes back, in the artist's language; "" where nothing is half done that it could."""
        return ""

    def take_back(self) -> bool:
        """Take the last step of what is half done back, where there is one; False where there is none."""
        return False

    def key(self, name: str) -> None:
        """One of the claimed keys was pressed; `name` as in `app.actions.key_names.key_name`."""

    def paint(self, painter: QPainter, viewport: Viewport) -> None:
        """Paint the tool's own marks, in widget coordinates, above the shapes."""
