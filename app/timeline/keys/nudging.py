"""Nudges: chosen keys moved along time by the keyboard, a row of nudges as one drag would move them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Generic, TypeVar

from roam_core.roto import Layer, Project
from roam_core.roto.layers import Item

from ...model.document import Document
from ...translation import tr
from ..chosen import ChosenPlaces

P = TypeVar("P", bound=tuple[object, ...])

Moved = Callable[[Project, frozenset[P], int], Project]
"""The project with the keys at some places shifted by so many frames; what lies where they arrive gives way."""


class Nudges(Generic[P]):
    """Moves chosen keys by some frames, each nudge an edit from where the first of a row of them began.

    So keys that are passed on the way are there again behind those that move, as with a drag. A row ends with any
    other edit of what they belong to, undo among them, and when other keys are chosen: what a run does to other shapes
    meanwhile stays.
    """

    def __init__(self, document: Document, chosen: ChosenPlaces[P], moved: Moved[P]) -> None:
        self._document, self._chosen, self._moved = document, chosen, moved
        self._begun: tuple[list[Item], frozenset[P]] | None = None
        """The items whose keys move, and the places, before the first nudge."""
        self._left: tuple[list[Item], frozenset[P]] | None = None
        """The same as the last nudge left them."""
        self._offset = 0

    def by(self, places: frozenset[P], frames: int, merge_key: str) -> None:
        """Move the keys at `places`, not out of the clip; nudges with one `merge_key` are one undo step."""
        document = self._document
        now = _items_of(document.project, places), places
        if self._begun is None or self._left != now:
            self._begun, self._offset = now, 0
        items, own = self._begun
        project = _with(document.project, items)
        self._offset = _inside(project, own, self._offset + frames)
        document.apply(tr("Move keys"), self._moved(project, own, self._offset), merge_key)
        there = frozenset(_shifted(place, self._offset) for place in own)
        self._chosen.select(there)
        self._left = _items_of(document.project, there), there


def _items_of(project: Project, places: frozenset[P]) -> list[Item]:
    """The shapes and layers that places name first; layers without what lies in them: that may be tracked meanwhile."""
    found = [project.find(item) for item in sorted({str(place[0]) for place in places}) if project.has(item)]
    return [replace(item, children=()) if isinstance(item, Layer) else item for item in found]


def _with(project: Project, items: list[Item]) -> Project:
    """The project with these in the place of its own; layers keep what lies in them."""
    for item in items:
        project = project.map_item(item.id, partial(_in_place_of, item))
    return project


def _in_place_of(item: Item, now: Item) -> Item:
    return replace(item, children=now.children) if isinstance(item, Layer) and isinstance(now, Layer) else item


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
