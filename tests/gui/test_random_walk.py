"""Random commands through the artist's own doors, undo and redo among them: nothing breaks, and all comes back."""

from __future__ import annotations

import random
from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication

from app.canvas.view import CanvasView
from app.features.clipboards.shapes import ShapeClipboard
from app.features.history import History
from app.features.verbs.shapes import ShapeVerbs
from app.model.document import Document
from app.model.view_state import ViewState
from app.tools.edit.transform_actions import TransformActions
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import edit, file
from tests.gui.hand import ALT, CTRL, NONE, SHIFT, Hand
from tests.gui.tools.conftest import SQUARE

COMMANDS = 10_000
MOST_SHAPES = 8
ASKING = {"points.transform", "key.paste_range"}
"""Actions that open a dialog."""

DRAWING = ("bezier", "polygon", "bspline", "ellipse", "rectangle", "freehand")
TOOLS = (*DRAWING, *("select",) * 6, *("transform",) * 3, *("reshape",) * 2, "feather")
MODIFIERS = (*(NONE,) * 6, SHIFT, CTRL, CTRL | SHIFT, CTRL | ALT)
MODES = ("auto_key", "point_keys", "ripple", "soft", "lasso")
NUDGES = (Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Up, Qt.Key.Key_Down)


class Walk:
    """An artist who does anything at all; the same seed does the same."""

    def __init__(self, canvas: CanvasView, document: Document, view_state: ViewState, seed: int) -> None:
        self.canvas, self.document, self.view, self.hand = canvas, document, view_state, Hand(canvas)
        self.random = random.Random(seed)
        self.edits = 0
        document.changed.connect(self.count)
        parts = (
            canvas,
            ShapeVerbs(document, view_state),
            ShapeClipboard(document, view_state),
            TransformActions(document, view_state),
        )
        handlers = {name: call for part in parts for name, call in part.handlers().items()}
        self.actions = [call for name, call in sorted(handlers.items()) if name not in ASKING]
        history = History(document, view_state, lambda: False).handlers()
        self.commands: tuple[Callable[[], object], ...] = (
            *(self.drag,) * 6,
            *(self.grab_a_point,) * 5,
            *(lambda: self.random.choice(self.actions)(),) * 6,
            *(history["edit.undo"],) * 4,
            *(history["edit.redo"],) * 3,
            *(self.take_tool,) * 2,
            *(self.choose,) * 3,
            lambda: self.view.set_frame(self.random.randint(1, 20)),
            lambda: self.view.editing.set(**{self.random.choice(MODES): self.random.random() < 0.5}),
            lambda: self.view.set_play_range(self.random.randint(1, 9), self.random.randint(11, 20)),
            lambda: self.hand.key(self.random.choice(NUDGES), ALT),
            lambda: self.hand.key(self.random.choice((Qt.Key.Key_Return, Qt.Key.Key_Escape))),
        )

    def go(self, count: int) -> None:
        """So many commands."""
        for _ in range(count):
            self.random.choice(self.commands)()
            if len(self.document.project.shapes) > MOST_SHAPES:
                ids = [shape.id for shape in self.document.project.shapes]
                self.document.apply("Delete", edit.remove_items(self.document.project, ids[::2]))

    def count(self, _ids: object) -> None:
        """The project is another one: by an edit, undo or redo."""
        self.edits += 1

    def spot(self) -> tuple[float, float]:
        return self.random.uniform(0.0, 200.0), self.random.uniform(0.0, 150.0)

    def drag(self) -> None:
        self.hand.drag(self.spot(), self.spot(), self.random.choice(MODIFIERS))

    def grab_a_point(self) -> None:
        """Drag a point that is there, or only begin to."""
        shapes = self.document.project.shapes
        if shapes:
            at = self.random.choice(self.random.choice(shapes).at(self.view.frame).control_points[:, 0].tolist())
            self.hand.press((at[0], at[1]), self.random.choice(MODIFIERS))
            self.hand.move(self.spot(), self.random.choice(MODIFIERS))
            if self.random.random() < 0.2:
                self.hand.key(Qt.Key.Key_Escape)
            self.hand.release(self.spot())

    def take_tool(self) -> None:
        self.view.set_tool(self.random.choice(TOOLS))

    def choose(self) -> None:
        shapes = self.document.project.shapes
        chosen = self.random.sample(shapes, min(len(shapes), self.random.randint(0, 2)))
        points = frozenset(
            (shape.id, index) for shape in chosen for index in range(shape.point_count) if self.random.random() < 0.4
        )
        self.view.select(frozenset(shape.id for shape in chosen), points if self.random.random() < 0.6 else frozenset())


def told(document: Document) -> str:
    """The whole project as its file would be."""
    return file.dumps(document.project, Path("/shots"))


@pytest.mark.parametrize("seed", [1])
def test_whatever_the_artist_does_is_undone_and_redone_wholly(
    canvas: CanvasView, document: Document, view_state: ViewState, seed: int
) -> None:
    project, _ = edit.new_shape(document.project, polygon_points(SQUARE), 1)
    document.open(project, None)
    canvas.hide()  # What is painted is tested elsewhere; here it would take most of the time.
    QGuiApplication.clipboard().clear()
    before = told(document)
    walk = Walk(canvas, document, view_state, seed)
    walk.go(COMMANDS)
    view_state.set_tool("select")
    after, stack = told(document), document.undo_stack
    stack.setIndex(stack.count())
    last = told(document)
    assert walk.edits > COMMANDS / 10
    stack.setIndex(0)
    assert told(document) == before
    stack.setIndex(stack.count())
    assert told(document) == last
    assert file.loads(after, Path("/shots"), "the walk") is not None
    QGuiApplication.clipboard().clear()
