"""BoilOf: how much each shape boils, frame by frame, measured anew only where its keys are others than before."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import takewhile
from weakref import ref

import numpy as np
from PySide6.QtCore import QObject, QTimer, Signal

from roam_core.arrays import Array, Bools
from roam_core.review.boil import boil_of, told_keys
from roam_core.roto import Keyframe, RotoShape

from ..model.document import Document

AT_ONCE = 10_000
"""Points of keys that are measured in one go: the window answers in between."""
LOOKED_AT = 8
"""Points that are measured in the time that it takes to see that a key is what it was."""


class BoilOf(QObject):
    """The boil of shapes in pixels of the plate: pairs (frame, boil) `(K, 2)` in the order of time.

    While a shape is tracked one frame of it changes at a time: only the three frames around it are measured again. What
    was measured by the picture stands until one of its three keys is another. `boil_of_document` gives the document's.

    Signals
    -------
    changed() : shapes were measured, by the picture or of those that `so_far` left for later.
    """

    changed = Signal()

    def __init__(self, document: Document) -> None:
        super().__init__(document)
        self._shapes: dict[str, tuple[RotoShape, Array]] = {}
        """What is known of each shape, and of which value of it."""
        self._replaced: dict[str, tuple[ref[RotoShape], Array]] = {}
        """The same of the value before that, which an undo brings back."""
        self._left: list[RotoShape] = []
        self._later = QTimer(self, interval=0)
        self._later.timeout.connect(self._go_on)
        document.replaced.connect(self._forget)

    def so_far(self, shapes: Sequence[RotoShape]) -> list[tuple[RotoShape, Array]]:
        """Those of the shapes whose boil is known, each with it; a few are measured now, the others in idle moments.

        Hundreds of shapes on thousands of frames take seconds. `changed` tells that all are known.
        """
        self._left = self._measured_some([shape for shape in shapes if not self._is_known(shape)])
        if self._left:
            self._later.start()
        else:
            self._later.stop()
        return [(shape, self(shape)) for shape in shapes if self._is_known(shape)]

    def _is_known(self, shape: RotoShape) -> bool:
        """Whether the boil of this value of a shape is known, as of the one before the last it is after an undo."""
        known, before = self._shapes.get(shape.id), self._replaced.get(shape.id)
        if known is not None and known[0] is not shape and before is not None and before[0]() is shape:
            self._keep(shape, before[1])
            return True
        return known is not None and known[0] is shape

    def _keep(self, shape: RotoShape, boil: Array) -> None:
        if (known := self._shapes.get(shape.id)) is not None and known[0] is not shape:
            self._replaced[shape.id] = ref(known[0]), known[1]
        self._shapes[shape.id] = shape, boil

    def _measured_some(self, shapes: list[RotoShape]) -> list[RotoShape]:
        """Measure as many of the shapes as go at once, at least one; those that are left."""
        points = 0
        for place, shape in enumerate(shapes):
            if points >= AT_ONCE:
                return shapes[place:]
            points += len(shape.keys) * (LOOKED_AT if shape.id in self._shapes else shape.point_count)
            self(shape)
        return []

    def _go_on(self) -> None:
        self._left = self._measured_some(self._left)
        if not self._left:
            self._later.stop()
            self.changed.emit()

    def _forget(self) -> None:
        self._shapes.clear()
        self._replaced.clear()
        self._left = []
        self._later.stop()

    def __call__(self, shape: RotoShape) -> Array:
        """What is known of a shape, or measured now."""
        if not self._is_known(shape):
            self._keep(shape, _measured(shape, self._shapes.get(shape.id)))
        return self._shapes[shape.id][1]

    def take(self, shapes: Mapping[str, RotoShape], measured: Mapping[str, Array]) -> None:
        """Hold what was measured by the picture, of shapes as they were then, by their ids."""
        for shape_id, shape in shapes.items():
            boil, found = self(shape).copy(), measured[shape_id].reshape(-1, 2)
            _, here, there = np.intersect1d(boil[:, 0], found[:, 0], assume_unique=True, return_indices=True)
            boil[here, 1] = found[there, 1]
            self._keep(shape, boil)
        self.changed.emit()


def boil_of_document(document: Document) -> BoilOf:
    """The one that all who show the boil of a document share."""
    found = document.findChild(BoilOf)
    return found if isinstance(found, BoilOf) else BoilOf(document)


def _measured(shape: RotoShape, known: tuple[RotoShape, Array] | None) -> Array:
    """The boil of a shape; what is known of another value of it holds where the three keys are the very same."""
    there, told = shape.living_keys, told_keys(shape)
    boil = np.column_stack([[there[k].frame for k in told.tolist()], np.zeros(len(told))]).reshape(-1, 2)
    kept = np.zeros(len(told), dtype=bool)
    if known is not None and known[0].closed == shape.closed:
        same = _unchanged(known[0].living_keys, there)
        kept = same[told - 1] & same[told] & same[told + 1]
        boil[kept, 1] = known[1][np.searchsorted(known[1][:, 0], boil[kept, 0]), 1]
    fresh = [(there[k - 1], there[k], there[k + 1]) for k in told[~kept].tolist()]
    boil[~kept, 1] = boil_of(fresh, shape.closed)
    return boil


def _unchanged(before: Sequence[Keyframe], after: Sequence[Keyframe]) -> Bools:
    """Which of the keys `after` were there before: as a rule all up to one place, and from another one on."""
    same = np.zeros(len(after), dtype=bool)
    first = sum(1 for _ in takewhile(_are_same, zip(before, after, strict=False)))
    last = sum(1 for _ in takewhile(_are_same, zip(reversed(before[first:]), reversed(after[first:]), strict=False)))
    same[:first], same[len(after) - last :] = True, True
    held = {key.frame: key for key in before[first : len(before) - last]}
    for place in range(first, len(after) - last):
        same[place] = held.get(after[place].frame) is after[place]
    return same


def _are_same(pair: tuple[Keyframe, Keyframe]) -> bool:
    return pair[0] is pair[1]
