"""Solo as a verb: the selected shapes and layers alone are shown, and all again."""

from __future__ import annotations

from collections.abc import Callable

from roam_core.roto.layers import top_items

from ...model.document import Document
from ...model.view_state import ViewState
from ...translation import tr
from .shapes import NOTHING_SELECTED, rows_in_hand


class SoloVerbs:
    """Solos what is selected, and keeps to what the project has: another project is shown whole."""

    def __init__(self, document: Document, view_state: ViewState) -> None:
        self._document, self._view = document, view_state
        self._begun = document.begun
        document.changed.connect(lambda _: view_state.solo.follow(document.project))
        document.replaced.connect(self._follow_project)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"shape.solo": self.toggle}

    def toggle(self) -> None:
        """Show the selected shapes and layers alone, or all again where some are shown alone."""
        solo, project = self._view.solo, self._document.project
        rows = [] if solo.ids else rows_in_hand(project, self._view)
        if not rows and not solo.ids:
            self._view.say_here(tr(NOTHING_SELECTED))
        solo.set(rows, project)

    def _follow_project(self) -> None:
        solo, project = self._view.solo, self._document.project
        if self._begun != self._document.begun:
            self._begun = self._document.begun
            solo.set((), project)
        else:  # the same one, with another clip
            solo.follow(project)


def switch_solo(document: Document, view: ViewState, pressed: str, others: list[str]) -> None:
    """Solo a row that is not, or let go of it, and the others with it; what stays soloed stays so."""
    solo, project = view.solo, document.project
    rows = {pressed, *others}
    solo.set(solo.ids - rows if pressed in solo.ids else top_items(project, solo.ids | rows), project)
