"""What the engine gives back for a frame."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum
from functools import cached_property
from typing import TYPE_CHECKING, Protocol

import numpy as np

from roam_core.arrays import Array, Indices
from roam_core.geometry import bezier
from roam_core.params import is_doubtful
from roam_core.roto import Keyframe, Origin, RotoShape

if TYPE_CHECKING:  # numba: a command's help must not wait for it
    from roam_core.propagate.frame.topology_proposals import Proposal
    from roam_core.proposal.reshaping.topology import TopologyChange


class Termination(StrEnum):
    """Why the engine was done with a frame, or why it doubts it."""

    CONVERGED = "converged"
    MAX_ITERATIONS = "max_iterations"
    LEFT_FRAME = "left_frame"
    LOW_CONFIDENCE = "low_confidence"
    MISSING_FRAME = "missing_frame"
    ARTIST_KEY = "artist_key"
    OUTSIDE_LIFETIME = "outside_lifetime"
    CANCELLED = "cancelled"

    @classmethod
    def of(cls, confidence: float) -> Termination:
        """How a frame ends that was carried or filled without more ado: doubted or not."""
        return cls.LOW_CONFIDENCE if is_doubtful(confidence) else cls.CONVERGED


@dataclass(frozen=True, eq=False)
class Part:
    """One outline of an object: control points `(P, 3, 2)`, and whether it cuts a hole.

    One that is not `attached` hangs on no other.
    """

    points: Array
    subtracts: bool = False
    attached: bool = True

    @cached_property
    def area(self) -> float:
        """What the outline encloses, square pixels."""
        return bezier.area(self.points)


@dataclass(frozen=True, eq=False)
class StepResult:
    """One solved outline: control points `(P, 3, 2)`, confidence of the frame and of each point `(P,)`, energies.

    `proposals` are changes of topology that would lower the energy and that only the artist may make.
    """

    points: Array
    confidence: float
    vertex_confidence: Array
    energies: Mapping[str, float]
    termination: Termination
    proposals: tuple[TopologyChange, ...] = ()

    @property
    def unseen(self) -> StepResult:
        """The same where the picture shows nothing: whatever was found there is not to be trusted."""
        termination = self.termination if self.termination is Termination.LEFT_FRAME else Termination.of(0.0)
        none = np.zeros_like(self.vertex_confidence)
        return replace(self, confidence=0.0, vertex_confidence=none, termination=termination, proposals=())


class Solved(Protocol):
    """An outline that was carried or filled: `points (P, 3, 2)`, and how far they are trusted, each `(P,)` and all."""

    @property
    def points(self) -> Array: ...

    @property
    def confidence(self) -> float: ...

    @property
    def vertex_confidence(self) -> Array: ...


def engine_key(frame: int, solved: Solved, feather: Array | None, inputs: str) -> Keyframe:
    """The engine's key of what was solved on a frame, with the artist's `feather (P, 2)`, stamped `inputs`."""
    return Keyframe(
        frame,
        solved.points,
        feather=feather,
        origin=Origin.ENGINE,
        confidence=solved.confidence,
        vertex_confidence=solved.vertex_confidence,
        inputs=inputs,
    )


@dataclass(frozen=True, eq=False)
class Landmarks:
    """The landmarks of one shape on one frame, for those who want the motion of places on the object.

    The arrays are read-only copies: the engine goes on from its own, whatever a caller does.

    Attributes
    ----------
    ids : (M,) who they are: never given twice among those that go back to one outline.
    positions : (M, 2) pixels of the whole picture.
    learned_on : the frame of the outline, the artist's, that they go back to. With the shape and the id it tells who a
        landmark is, in whichever direction and however often a run passed it.
    """

    ids: Indices
    positions: Array
    learned_on: int

    def __post_init__(self) -> None:
        for name in ("ids", "positions"):
            array = np.array(getattr(self, name))
            array.setflags(write=False)
            object.__setattr__(self, name, array)


@dataclass(frozen=True)
class TrackResult:
    """One shape on one frame.

    Attributes
    ----------
    frame : the plate's frame number.
    shape : the shape with all its keys so far, the one of this frame included (without one on a missing frame).
    confidence : in [0, 1].
    energies : the joint energy by term, and their sum under "total"; empty where nothing was solved.
    termination : why the engine stopped or what it doubts.
    seconds : the engine's time for this shape and frame, without decoding.
    proposals : changes of topology that are offered, the greatest gain first; none of them was made.
    landmarks : those that were found on the frame; None where the configuration has none, or nothing was looked at.
    """

    frame: int
    shape: RotoShape
    confidence: float
    energies: Mapping[str, float]
    termination: Termination
    seconds: float = 0.0
    proposals: tuple[Proposal, ...] = ()
    landmarks: Landmarks | None = field(default=None, compare=False)

    @property
    def key(self) -> Keyframe | None:
        """The key on this frame."""
        return self.shape.key_at(self.frame)


@dataclass(frozen=True)
class FrameResult:
    """All tracked shapes on one frame, in the order in which they were given; `seconds` by the clock for all."""

    frame: int
    results: tuple[TrackResult, ...]
    seconds: float = 0.0
