"""ValueSelection: the keys of values and outlines that are chosen in value rows and curves."""

from __future__ import annotations

from roam_core.roto import Project
from roam_core.roto.timing import artist_places
from roam_core.roto.value_curves import ValuePlace, value_places

from ..chosen import ChosenPlaces
from .shown import OUTLINES


class ValueSelection(ChosenPlaces[ValuePlace]):
    """Chosen keys as (id of the shape or layer, kind, frame): those of values, and the artist's of outlines."""

    def places_in(self, project: Project) -> frozenset[ValuePlace]:
        outlines = ((shape_id, kind.value, frame) for shape_id, frame in artist_places(project) for kind in OUTLINES)
        return value_places(project) | frozenset(outlines)

    def frames_of(self, item_id: str, kind: str) -> frozenset[int]:
        """The frames of the chosen keys of one curve."""
        return frozenset(frame for owner, name, frame in self.places if (owner, name) == (item_id, kind))
