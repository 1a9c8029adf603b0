"""Stabiliser: lets a viewer go along with what is selected, which then stands still on the screen."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from PySide6.QtCore import QObject

from roam_core.roto import Project

from ..model.view_state import ViewState
from ..model.viewing import Viewing
from ..paint.viewport import Viewport
from ..translation import N_, tr
from .places import Places, places_of

Shift = tuple[float, float]
"""In image pixels."""


class Travel(NamedTuple):
    """How far a view went along, image pixels, since it last began to."""

    leg: int = 0
    x: float = 0.0
    y: float = 0.0


STANDING = Travel()


NOTHING = N_("Select a shape or a layer: from then on the view goes along with it.")


class Stabiliser(QObject):
    """Looks after where what is followed was, and moves the view as it moves.

    Only another frame moves the view: an edit, an undo, a run that passes or another selection never does. What is
    followed is the selection, and when it is let go of, what was selected last. Of several the mean of their motions
    counts, so that the view does not leap where one of them begins or ends.

    `shown` gives the project as it is seen, `look` the viewport, and `move` shows a spot so many image pixels aside
    and gives how far it got: at its edge the plate stays in sight.
    """

    def __init__(
        self,
        view_state: ViewState,
        viewing: Viewing,
        shown: Callable[[], Project],
        look: Callable[[], Viewport],
        move: Callable[[Shift], Shift],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._view, self._viewing, self._shown, self._look, self._move = view_state, viewing, shown, look, move
        self._frame = view_state.frame
        self._wanted = self._followed = (view_state.selection.shapes, view_state.layers)
        self._seen: Places = {}
        """Where each was when the view was moved last."""
        self._held: Places = {}
        """Where the view has each, so that it stands still: other than where it is where the view could not go along,
        and known also of what is not there at the moment."""
        self._project: Project | None = None
        self._left: Viewport | None = None
        """As the view was left; None while it does not go along."""
        self.travelled = Travel()
        """How far it went: something pinned on the same leg is as much aside."""
        view_state.selection_changed.connect(self._note_selection)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"view.stabilise": self.toggle}

    def toggle(self) -> None:
        """Let the view go along with what is selected, or stand."""
        self._viewing.stabilise(not self._viewing.is_stabilised)
        if self._viewing.is_stabilised and not any(self._wanted):
            self._view.say(tr(NOTHING))

    def forget(self) -> None:
        """Another project: nothing of the last one is followed."""
        self._wanted = (self._view.selection.shapes, self._view.layers)
        self._start_here()

    def aside(self, travelled: Travel, frame: int) -> Shift:
        """How far aside something lies that was pinned on a frame when the view had `travelled` so far.

        It stays where it is seen, so that what stands still is compared in its place. On its own frame it lies on
        what is shown now, whatever was followed meanwhile; so it does once the view stood while frames passed.
        """
        if not self._viewing.is_stabilised or frame == self._frame or travelled.leg != self.travelled.leg:
            return 0.0, 0.0
        return self.travelled.x - travelled.x, self.travelled.y - travelled.y

    def follow(self) -> None:
        """Go along where another frame is shown than before."""
        if self._view.frame == self._frame:
            return
        if not self._viewing.is_stabilised:
            self._start_here()
            return
        self._take_up()
        project, there = self._shown(), self._places(self._view.frame)
        moved = [(there[i][0] - self._held[i][0], there[i][1] - self._held[i][1]) for i in there if i in self._held]
        shift = (sum(dx for dx, _ in moved) / len(moved), sum(dy for _, dy in moved) / len(moved)) if moved else (0, 0)
        if any(shift):
            shift = self._move(shift)
            self.travelled = Travel(self.travelled.leg, self.travelled.x + shift[0], self.travelled.y + shift[1])
        self._held = there | {i: (x + shift[0], y + shift[1]) for i, (x, y) in self._held.items()}
        self._left = self._look()
        self._frame, self._seen, self._project = self._view.frame, there, project

    def _start_here(self) -> None:
        """Know nothing of other frames than this one."""
        self._frame, self._project, self.travelled = self._view.frame, None, Travel(self.travelled.leg + 1)
        self._held, self._seen, self._left = {}, {}, None

    def _note_selection(self) -> None:
        if any(chosen := (self._view.selection.shapes, self._view.layers)):
            self._wanted = chosen

    def _places(self, frame: int) -> Places:
        return places_of(self._shown(), frame, *self._wanted)

    def _take_up(self) -> None:
        """What was edited, selected, panned or zoomed on the frame before holds as it is seen there."""
        if self._wanted != self._followed:
            self._followed, self._held, self._seen, self._project = self._wanted, {}, {}, None
        is_by_hand = self._look() != self._left
        here = self._seen if self._shown() is self._project else self._places(self._frame)
        for i, (x, y) in here.items():
            if is_by_hand or i not in self._held or i not in self._seen:
                self._held[i] = x, y
            elif (x, y) != self._seen[i]:
                held, seen = self._held[i], self._seen[i]
                self._held[i] = held[0] + x - seen[0], held[1] + y - seen[1]
