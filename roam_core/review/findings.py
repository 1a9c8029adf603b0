"""Frames worth a look before a shot goes out: those the engine doubts, and those on which an outline boils."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum

from roam_core.arrays import Array
from roam_core.params import is_doubtful
from roam_core.review.boil import BOILING, boil
from roam_core.roto import Project, RotoShape


class FindingKind(StrEnum):
    """Why a frame is listed."""

    DOUBT = "doubt"
    BOIL = "boil"


@dataclass(frozen=True)
class Finding:
    """A shape on a frame that is worth a look.

    Attributes
    ----------
    shape : its id. name : what it is called.
    value : the confidence in [0, 1] of a doubt, pixels of the plate of a boil.
    """

    kind: FindingKind
    frame: int
    shape: str
    name: str
    value: float

    @property
    def sentence(self) -> str:
        """What is found there, in a few words."""
        if self.kind is FindingKind.DOUBT:
            return f"{self.name} is doubtful, confidence {self.value:.2f}"
        return f"{self.name} boils by {self.value:.1f} px"


def doubtful(shapes: Iterable[RotoShape]) -> tuple[Finding, ...]:
    """The frames of shapes whose confidence is low, in the order of time; none on which they do not exist."""
    return _sorted(
        Finding(FindingKind.DOUBT, key.frame, shape.id, shape.name, key.confidence)
        for shape in shapes
        for key in shape.living_keys
        if key.confidence is not None and is_doubtful(key.confidence)
    )


def boiling(shapes: Iterable[RotoShape]) -> tuple[Finding, ...]:
    """The frames of shapes whose outline jitters visibly, in the order of time."""
    return _sorted(found for shape in shapes for found in boiling_frames(shape))


def boiling_frames(shape: RotoShape, measured: Array | None = None) -> list[Finding]:
    """Those of one shape, whose boil `(K, 2)` may have been `measured` already."""
    return [
        Finding(FindingKind.BOIL, int(frame), shape.id, shape.name, value)
        for frame, value in (boil(shape) if measured is None else measured).tolist()
        if value >= BOILING
    ]


def worst_of_stretches(found: Sequence[Finding]) -> list[Finding]:
    """Of each stretch of frames that follow each other the one with the greatest value; of one shape, as they go on."""
    worst: list[Finding] = []
    for each, before in zip(found, [None, *found], strict=False):
        if before is None or each.frame > before.frame + 1:
            worst.append(each)
        elif each.value > worst[-1].value:
            worst[-1] = each
    return worst


def findings(project: Project, measured: Mapping[str, Array] | None = None) -> tuple[Finding, ...]:
    """All that is worth a look in a project, in the order of time.

    `measured` is the boil of its shapes by their ids, where that is known already.
    """
    boils = (boiling_frames(shape, None if measured is None else measured[shape.id]) for shape in project.shapes)
    return _sorted((*doubtful(project.shapes), *(each for found in boils for each in found)))


def _sorted(found: Iterable[Finding]) -> tuple[Finding, ...]:
    return tuple(sorted(found, key=lambda each: (each.frame, each.kind, each.name)))
