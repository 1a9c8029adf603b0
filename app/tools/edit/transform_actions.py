"""TransformActions: mirroring the selected points or shapes, and transforming them by numbers. One undo step each."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from PySide6.QtWidgets import QWidget

from roam_core.arrays import Array
from roam_core.geometry import affine

from ...model.document import Document
from ...model.reasons import why_not
from ...model.view_state import ViewState
from ...translation import tr
from ...widgets.asking import ask
from ..reshape import Grab, grab_selection, pixel_aspect, selection_extent
from .numbers import Numbers, NumbersDialog, matrix_of


class TransformActions:
    """Actions on the selection of the view state, about the middle of its box."""

    def __init__(self, document: Document, view_state: ViewState, parent: QWidget | None = None) -> None:
        self._document, self._view, self._parent = document, view_state, parent

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "points.mirror_across": lambda: self.mirror(tr("Mirror horizontally"), -1.0, 1.0),
            "points.mirror_down": lambda: self.mirror(tr("Mirror vertically"), 1.0, -1.0),
            "points.transform": self.ask_numbers,
        }

    def mirror(self, text: str, across: float, down: float) -> None:
        """Mirror the selection in place."""
        if grab := self._grab():
            matrix = affine.scaling(across, down, self._middle())
            project = self._document.project
            self._document.apply(text, grab.settled(project, grab.transformed(project, matrix)))

    def ask_numbers(self) -> None:
        """Ask for the numbers of a transform; what they do is previewed while they are typed."""
        if grab := self._grab():
            dialog = NumbersDialog(self._parent)
            dialog.changed.connect(lambda: self._preview(grab, dialog.numbers))
            dialog.finished.connect(lambda _: self._view.set_preview(None))
            self._preview(grab, dialog.numbers)  # from now on no run takes the playhead to another frame
            ask(dialog, lambda: self.transform(dialog.numbers), self._document.replaced)

    def transform(self, numbers: Numbers) -> None:
        """Transform the selection by `numbers`."""
        if grab := self._grab():
            project, matrix = self._document.project, self._matrix(numbers)
            self._document.apply(tr("Transform"), grab.settled(project, grab.transformed(project, matrix)))

    def _preview(self, grab: Grab, numbers: Numbers) -> None:
        if grab.is_held(self._document.project) and grab.frame == self._view.frame:
            self._view.set_preview(grab.transformed(self._document.project, self._matrix(numbers)))

    def _grab(self) -> Grab | None:
        """What the selection holds; says so when that is nothing."""
        grab = grab_selection(self._document.project, self._view)
        if grab.weights:
            return grab
        self._view.say_here(why_not(self._document.project, self._view))
        return None

    def _matrix(self, numbers: Numbers) -> Array:
        """What the numbers mean for what is selected."""
        return matrix_of(numbers, self._middle(), pixel_aspect(self._document.project))

    def _middle(self) -> tuple[float, float]:
        """The middle of the box about the selected points, or about the outlines of whole shapes."""
        corners = selection_extent(self._document.project, self._view)
        if corners is None:
            return 0.0, 0.0
        x, y = np.mean(corners, axis=0).tolist()
        return x, y
