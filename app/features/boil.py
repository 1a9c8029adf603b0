"""BoilOf: how much each shape boils, frame by frame, measured anew only where its keys are others than before."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from PySide6.QtCore import QObject, Signal

from roam_core.arrays import Array
from roam_core.review.boil import Triple, boil_of, triples
from roam_core.roto import RotoShape

from ..model.document import Document


class BoilOf(QObject):
    """The boil of shapes in pixels of the plate: pairs (frame, boil) `(K, 2)` in the order of time.

    While a shape is tracked one frame of it changes at a time: only the three frames around it are measured again. What
    was measured by the picture stands until one of its three keys is another. `boil_of_document` gives the document's.

    Signals
    -------
    changed() : shapes were measured by the picture.
    """

    changed = Signal()

    def __init__(self, document: Document) -> None:
        super().__init__(document)
        self._shapes: dict[str, tuple[RotoShape, Array]] = {}
        self._frames: dict[str, dict[int, tuple[Triple, float]]] = {}
        document.replaced.connect(self._forget)

    def __call__(self, shape: RotoShape) -> Array:
        """What is known of a shape, or measured now."""
        known = self._shapes.get(shape.id)
        if known is None or known[0] is not shape:
            known = self._shapes[shape.id] = shape, self._measured(shape)
        return known[1]

    def take(self, shapes: Mapping[str, RotoShape], measured: Mapping[str, Array]) -> None:
        """Hold what was measured by the picture, of shapes as they were then, by their ids."""
        for shape_id, shape in shapes.items():
            values = {int(frame): value for frame, value in measured[shape_id].tolist()}
            known = self._frames.setdefault(shape_id, {})
            known |= {
                keys[1].frame: (keys, values[keys[1].frame]) for keys in triples(shape) if keys[1].frame in values
            }
            self._shapes.pop(shape_id, None)
        self.changed.emit()

    def _measured(self, shape: RotoShape) -> Array:
        before, found = self._frames.get(shape.id, {}), triples(shape)
        fresh = [keys for keys in found if not _is_known(before.get(keys[1].frame), keys)]
        values = iter(boil_of(fresh, shape.closed).tolist())
        now = {keys[1].frame: (keys, next(values)) for keys in fresh}
        kept = {keys[1].frame: now.get(keys[1].frame) or before[keys[1].frame] for keys in found}
        self._frames[shape.id] = kept
        return np.array([(frame, value) for frame, (_, value) in kept.items()]).reshape(-1, 2)

    def _forget(self) -> None:
        self._shapes.clear()
        self._frames.clear()


def boil_of_document(document: Document) -> BoilOf:
    """The one that all who show the boil of a document share."""
    found = document.findChild(BoilOf)
    return found if isinstance(found, BoilOf) else BoilOf(document)


def _is_known(known: tuple[Triple, float] | None, keys: Triple) -> bool:
    return known is not None and all(a is b for a, b in zip(known[0], keys, strict=True))
