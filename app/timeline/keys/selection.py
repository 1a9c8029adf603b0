"""KeySelection: the keys that are chosen in the timeline. Never saved, never undone."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from roam_core.roto import Origin
from roam_core.roto.timing import Place

from ...model.document import Document


class KeySelection(QObject):
    """Chosen artist's keys as (shape id, frame). Keys that are gone are chosen no more.

    Signals
    -------
    changed() : other keys are chosen.
    """

    changed = Signal()

    def __init__(self, document: Document, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document = document
        self._places: frozenset[Place] = frozenset()
        document.changed.connect(self._prune)
        document.replaced.connect(self.clear)

    @property
    def places(self) -> frozenset[Place]:
        return self._places

    def frames_of(self, shape_id: str) -> frozenset[int]:
        """The chosen keys of one shape."""
        return frozenset(frame for owner, frame in self._places if owner == shape_id)

    def select(self, places: frozenset[Place]) -> None:
        if places != self._places:
            self._places = places
            self.changed.emit()

    def clear(self) -> None:
        self.select(frozenset())

    def _prune(self, _ids: object = None) -> None:
        if self._places:
            self.select(frozenset(place for place in self._places if self._is_there(*place)))

    def _is_there(self, shape_id: str, frame: int) -> bool:
        project = self._document.project
        key = project.shape(shape_id).key_at(frame) if project.has(shape_id) else None
        return key is not None and key.origin is Origin.ARTIST
