"""ValueSelection: the keys of values and outlines that are chosen in value rows and curves. Never saved or undone."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from roam_core.roto import Project
from roam_core.roto.timing import artist_places
from roam_core.roto.value_curves import ValuePlace, value_places

from ...model.document import Document
from .shown import OUTLINES


class ValueSelection(QObject):
    """Chosen keys as (id of the shape or layer, kind, frame). Keys that are gone are chosen no more.

    Signals
    -------
    changed() : other keys are chosen.
    """

    changed = Signal()

    def __init__(self, document: Document, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document = document
        self._places: frozenset[ValuePlace] = frozenset()
        document.changed.connect(self._prune)
        document.replaced.connect(self.clear)

    @property
    def places(self) -> frozenset[ValuePlace]:
        return self._places

    def frames_of(self, item_id: str, kind: str) -> frozenset[int]:
        """The frames of the chosen keys of one curve."""
        return frozenset(frame for owner, name, frame in self._places if (owner, name) == (item_id, kind))

    def select(self, places: frozenset[ValuePlace]) -> None:
        if places != self._places:
            self._places = places
            self.changed.emit()

    def clear(self) -> None:
        self.select(frozenset())

    def _prune(self, _ids: object = None) -> None:
        if self._places:
            self.select(self._places & places_of(self._document.project))


def places_of(project: Project) -> frozenset[ValuePlace]:
    """Where all keys lie that may be chosen: those of values, and the artist's of outlines by either kind."""
    outlines = ((shape_id, kind.value, frame) for shape_id, frame in artist_places(project) for kind in OUTLINES)
    return value_places(project) | frozenset(outlines)
