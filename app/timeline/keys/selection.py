"""KeySelection: the keys that are chosen in the timeline."""

from __future__ import annotations

from roam_core.roto import Project
from roam_core.roto.timing import Place, artist_places

from ..chosen import ChosenPlaces


class KeySelection(ChosenPlaces[Place]):
    """Chosen artist's keys as (shape id, frame)."""

    def places_in(self, project: Project) -> frozenset[Place]:
        return artist_places(project)

    def frames_of(self, shape_id: str) -> frozenset[int]:
        """The chosen keys of one shape."""
        return frozenset(frame for owner, frame in self.places if owner == shape_id)
