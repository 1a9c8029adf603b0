"""Nudges: chosen keys moved along time by the keyboard, a row of nudges as one drag would move them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Generic, TypeVar

from roam_core.roto import Project

from ...model.document import Document
from ...translation import tr
from ..chosen import ChosenPlaces

P = TypeVar("P", bound=tuple[object, ...])

Moved = Callable[[Project, frozenset[P], int], Project]
"""The project with the keys at some places shifted by so many frames; what lies where they arrive gives way."""


class Nudges(Generic[P]):
    """Moves chosen keys by some frames, each nudge an edit from where the first of a row of them began.

    So keys that are passed on the way are there again behind those that move, as with a drag. A row ends with any
    other edit, undo among them, and when other keys are chosen.
    """

    def __init__(self, document: Document, chosen: ChosenPlaces[P], moved: Moved[P]) -> None:
        self._document, self._chosen, self._moved = document, chosen, moved
        self._begun: tuple[Project, frozenset[P]] | None = None
        self._left: tuple[Project, frozenset[P]] | None = None
        """The project and the places as the last nudge left them."""
        self._offset = 0

    def by(self, places: frozenset[P], frames: int, merge_key: str) -> None:
        """Move the keys at `places`, not out of the clip; nudges with one `merge_key` are one undo step."""
        document = self._document
        is_same_row = self._left is not None and document.project is self._left[0] and places == self._left[1]
        if self._begun is None or not is_same_row:
            self._begun, self._offset = (document.project, places), 0
        project, own = self._begun
        self._offset = _inside(project, own, self._offset + frames)
        document.apply(tr("Move keys"), self._moved(project, own, self._offset), merge_key)
        there = frozenset(_shifted(place, self._offset) for place in own)
        self._chosen.select(there)
        self._left = document.project, there


def _inside(project: Project, places: frozenset[P], frames: int) -> int:
    """As many of `frames` as take none of the keys out of the clip; one that lies outside may come in."""
    clip, own = project.clip, [_frame(place) for place in places]
    if clip is None or not own:
        return frames
    return max(min(frames, max(clip.last - max(own), 0)), min(clip.first - min(own), 0))


def _frame(place: P) -> int:
    frame = place[-1]
    assert isinstance(frame, int)
    return frame


def _shifted(place: P, frames: int) -> P:
    """The same on another frame, which a place names last."""
    return (*place[:-1], _frame(place) + frames)  # type: ignore[return-value]
