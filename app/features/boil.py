"""BoilOf: how much each shape boils, frame by frame, measured anew only where its keys are others than before."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array
from roam_core.review.boil import Triple, boil_of, triples
from roam_core.roto import RotoShape

from ..model.document import Document


class BoilOf:
    """The boil of shapes in pixels of the plate: pairs (frame, boil) `(K, 2)` in the order of time.

    While a shape is tracked one frame of it changes at a time: only the three frames around it are measured again.
    """

    def __init__(self, document: Document) -> None:
        self._shapes: dict[str, tuple[RotoShape, Array]] = {}
        self._frames: dict[str, dict[int, tuple[Triple, float]]] = {}
        document.replaced.connect(self._forget)

    def __call__(self, shape: RotoShape) -> Array:
        """What is known of a shape, or measured now."""
        known = self._shapes.get(shape.id)
        if known is None or known[0] is not shape:
            known = self._shapes[shape.id] = shape, self._measured(shape)
        return known[1]

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


def _is_known(known: tuple[Triple, float] | None, keys: Triple) -> bool:
    return known is not None and all(a is b for a, b in zip(known[0], keys, strict=True))
