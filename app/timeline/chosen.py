"""ChosenPlaces: the keys that are chosen, by where they lie. Never saved, never undone."""

from __future__ import annotations

from collections.abc import Hashable
from typing import Generic, TypeVar
from weakref import ref

from PySide6.QtCore import QObject, Signal

from roam_core.roto import Project

from ..model.document import Document

P = TypeVar("P", bound=Hashable)


class ChosenPlaces(QObject, Generic[P]):
    """Chosen places of keys. Those whose keys are gone are chosen no more, until undo brings them back.

    Signals
    -------
    changed() : other keys are chosen.
    """

    changed = Signal()

    def __init__(self, document: Document, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document = document
        self._places: frozenset[P] = frozenset()
        self._project = document.project
        self._before: list[tuple[ref[Project], frozenset[P]]] = []
        """What was chosen in states of the project that undo or redo may bring back."""
        document.changed.connect(self._prune)
        document.replaced.connect(self.clear)

    def places_in(self, project: Project) -> frozenset[P]:
        """Where all keys lie that may be chosen."""
        raise NotImplementedError

    @property
    def places(self) -> frozenset[P]:
        return self._places

    def select(self, places: frozenset[P]) -> None:
        if places != self._places:
            self._places = places
            self.changed.emit()

    def restore(self, places: frozenset[P]) -> None:
        """Choose again what was chosen before; an undo meanwhile may have taken some of it away."""
        self.select(places & self.places_in(self._document.project))

    def clear(self) -> None:
        self._project, self._before = self._document.project, []
        self.select(frozenset())

    def _prune(self, _ids: object = None) -> None:
        """Keys that are gone are not chosen; after undo or redo those are that were chosen in their place."""
        left, self._project = self._project, self._document.project
        if self._places:
            others = [each for each in self._before if each[0]() is not None and each[0]() is not left]
            self._before = [*others, (ref(left), self._places)]
            held = self.places_in(self._project)
            back = [places for state, places in others if state() is self._project]
            self.select((self._places if self._places <= held else self._places.union(*back)) & held)
