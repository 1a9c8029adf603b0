"""Steady: tracked keys moved so that their outlines boil less; which shapes, on which frames, and why not."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtWidgets import QWidget

from roam_core.roto import Origin

from ...jobs.by_plate.steadying import Steadying
from ...model.document import Document
from ...model.view_state import ViewState, shapes_in_hand
from ...translation import tr
from ...widgets.asking import ask
from ..tracking import NO_CLIP, NO_SHAPE
from .steady_dialog import SteadyDialog


class Steady:
    """The verb on the shapes in hand, those selected, or all where none is, in the in/out range."""

    def __init__(self, window: QWidget, document: Document, view_state: ViewState, steadying: Steadying) -> None:
        self._window, self._document, self._view, self._steadying = window, document, view_state, steadying

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"shape.steady": self.ask}

    def ask(self) -> None:
        """Ask how much the shapes in hand are to be steadied; says why where that cannot be."""
        project, frames = self._document.project, range(*self._view.play_range)
        shapes = shapes_in_hand(project, self._view.selection)
        able = [shape for shape in shapes if shape.closed and not project.is_locked(shape.id)]
        asked = [
            shape.id for shape in able if any(key.origin is Origin.ENGINE and key.frame in frames for key in shape.keys)
        ]
        if project.clip is None:
            self._view.say(tr(NO_CLIP))
        elif not shapes:
            self._view.say(tr(NO_SHAPE))
        elif not able:
            self._view.say_here(tr("Only a closed shape that is not locked can be steadied; unlock or close one."))
        elif not asked:
            self._view.say_here(tr("No tracked key lies between in and out; track or fill the shapes first."))
        else:
            dialog = SteadyDialog(len(asked), self._view.play_range, self._window)
            ask(dialog, lambda: self._steadying.start(asked, frames, dialog.strength), self._document.replaced)
