"""ValueSelection: the keys of values and outlines that are chosen in value rows and curves."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from PySide6.QtCore import QObject

from roam_core.roto import Keyframe, Project, ValueKey
from roam_core.roto.timing import artist_places
from roam_core.roto.value_curves import ValuePlace, value_places

from ...model.document import Document
from ..chosen import ChosenPlaces
from .shown import OUTLINES


@dataclass(frozen=True)
class CopiedKeys:
    """Keys that were copied: of values by (id of the shape or layer, name), of outlines by the id of the shape.

    `curves` are the kinds of the outlines' curves by which they were chosen.
    """

    values: Mapping[tuple[str, str], Sequence[ValueKey]]
    outlines: Mapping[str, Sequence[Keyframe]]
    curves: frozenset[str] = frozenset()

    @property
    def frames(self) -> list[int]:
        """The frames that they were copied from."""
        own = [key.frame for keys in self.values.values() for key in keys]
        return own + [key.frame for keys in self.outlines.values() for key in keys]

    @property
    def owners(self) -> set[str]:
        """The ids of the shapes and layers that they were copied from."""
        return {item_id for item_id, _ in self.values} | set(self.outlines)


class ValueSelection(ChosenPlaces[ValuePlace]):
    """Chosen keys as (id of the shape or layer, kind, frame): those of values, and the artist's of outlines."""

    def __init__(self, document: Document, parent: QObject | None = None) -> None:
        super().__init__(document, parent)
        self.copied: CopiedKeys | None = None
        """What was copied of them last; None once something else was, or another project is shown."""
        document.replaced.connect(self.forget)

    def forget(self) -> None:
        """Nothing of what was copied is to be pasted."""
        self.copied = None

    def places_in(self, project: Project) -> frozenset[ValuePlace]:
        outlines = ((shape_id, kind.value, frame) for shape_id, frame in artist_places(project) for kind in OUTLINES)
        return value_places(project) | frozenset(outlines)

    def frames_of(self, item_id: str, kind: str) -> frozenset[int]:
        """The frames of the chosen keys of one curve."""
        return frozenset(frame for owner, name, frame in self.places if (owner, name) == (item_id, kind))
