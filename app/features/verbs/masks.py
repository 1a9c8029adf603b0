"""MaskShapes: shapes of the present frame from a picture of its mask."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from roam_core.errors import RoamError
from roam_core.roto import RotoShape

from ...jobs.picture_work import PictureWork
from ...jobs.runner import Ending, Report
from ...model.document import Document
from ...model.view_state import ViewState
from ...translation import tr, translated
from .finishing import put_in


class MaskShapes:
    """Asks for a mask picture, white inside, and fits shapes to it off the window's thread.

    `ask()` gives the file that the artist chose, if any.
    """

    def __init__(
        self, ask: Callable[[], Path | None], document: Document, view_state: ViewState, pictures: PictureWork
    ) -> None:
        self._ask, self._document, self._view, self._pictures = ask, document, view_state, pictures

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"shape.from_mask": self.choose}

    def choose(self) -> None:
        """Ask for the picture."""
        if self._document.project.clip is None:
            self._view.say(tr("Open a clip first: a mask belongs to one of its frames."))
        elif (chosen := self._ask()) is not None:
            self.read(chosen)

    def read(self, path: Path) -> None:
        """Fit shapes to the mask in `path`, keyed on the present frame; what is wrong with it is said."""
        width, height = self._document.project.require_clip().size
        frame, tool = self._view.frame, self._view.tool

        def look(report: Report) -> tuple[list[RotoShape], str]:
            from roam_core.matte.vectorise import is_in_colour, read_mask, shapes_from_mask
            from roam_core.media.unseen import unseen_of_mask

            report.progress(0.0, tr("Reading {name} …", name=path.name))
            mask = read_mask(path, (height, width))
            if is_in_colour(mask):
                raise RoamError(
                    tr(
                        "{name} is a picture in colour, no mask; paint the object white and the rest black.",
                        name=path.name,
                    )
                )
            shapes = shapes_from_mask(mask, frame)
            if not shapes:
                raise RoamError(
                    tr("Nothing is white in {name}; paint the object white and the rest black.", name=path.name)
                )
            return shapes, translated(unseen_of_mask(path))

        self._pictures.find("mask", look, lambda found: self._take(found, tool), ended=self._end)

    def _take(self, found: tuple[list[RotoShape], str], tool: str) -> None:
        shapes, further_pages = found
        put_in(self._document, self._view, tool, shapes, tr("Shape from mask"))
        if further_pages:
            self._view.say(further_pages)

    def _end(self, ending: Ending, sentence: str) -> None:
        if ending is Ending.FAILED:
            self._view.say(sentence)
