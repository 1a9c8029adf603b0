"""What every engine offers: an object is begun on a key, stepped from frame to frame, and says why it lies there."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Protocol

import numpy as np

from roam_core.appearance.global_model import GlobalModel
from roam_core.arrays import Array, Indices
from roam_core.cancel import CancelToken
from roam_core.features import PreparedFrame
from roam_core.landmarks.pool import Pool
from roam_core.motion.pose import Pose
from roam_core.propagate.frame.nodes import NodeMap
from roam_core.propagate.frame.result import Part, StepResult
from roam_core.propagate.shapes.objects import Unit
from roam_core.propagate.whole.state import RegionState
from roam_core.proposal.cues.evidence import Field, KeyMemory
from roam_core.proposal.outline.contour import KeyConstraints

Terms = Mapping[str, Array]

REGION = "region"
"""The cues together, smoothed and cleaned: what the curves of `best` were fitted to. No cue, and not in any sum."""
POSE = "pose"
"""How unlike its key a part looks around a node, in [0, 1]."""


@dataclass(frozen=True, eq=False)
class ByPose:
    """A lone shape by its pose, taken or not: its outlines, what the pose costs, how far it is trusted, whether
    nothing is seen of it, and whether it may be a part (`posed.is_believable`, `posed.is_steady`) that still looks as
    on its key.
    """

    points: tuple[Array, ...]
    cost: float
    confidence: float
    is_gone: bool
    is_believable: bool


@dataclass(frozen=True, eq=False)
class Motion:
    """How an object lies on a frame, beside its outlines.

    Attributes
    ----------
    since_key : `(3, 3)` the similarity, image to image, of the object since the key; None where the engine knows of no
        motion of the whole.
    region : the object's region, where the engine works with regions. of_region : which outlines are fitted to it.
    as_one_piece : the outlines are as they are on the key, only moved (`propagate.whole.rigid`).
    pose_costs : for each outline what its pose costs; None where it was not carried by its pose alone.
    gone : for each outline whether its pose is carried along without being seen. by_pose : of a lone shape.
    key : of the region, carried to the frame. at_poses : for each outline of an object in parts its points by its pose
        alone, free edges not yet drawn to the border of the region; None where it has none, or does not lie by it.
    in_parts : how an object in parts lies; None where it is none.
    """

    since_key: Array | None
    region: Field | None
    of_region: tuple[bool, ...]
    as_one_piece: bool = False
    pose_costs: tuple[float | None, ...] = ()
    gone: tuple[bool, ...] = ()
    by_pose: ByPose | None = None
    key: KeyMemory | None = None
    at_poses: tuple[Array | None, ...] = ()
    in_parts: InParts | None = None

    @classmethod
    def by_region(cls, state: RegionState) -> Motion:
        """That of an object all of whose outlines are fitted to its region."""
        count, as_one_piece = len(state.parts), state.agreement_as_one_piece is not None
        return cls(
            state.key.to_now, state.region, (True,) * count, as_one_piece, (None,) * count, (False,) * count,
            key=state.key,
        )  # fmt: skip


@dataclass(frozen=True, eq=False)
class UnionOfParts:
    """The parts of an object as one that is carried by regions (no picture is kept).

    `drawn` are its outlines on the key, `parts` as they lie, `constraints` what they keep of the key; `trust` is the
    IoU to be expected.
    """

    drawn: tuple[Part, ...]
    parts: tuple[Part, ...]
    constraints: tuple[KeyConstraints, ...]
    trust: float
    motion: Motion

    @classmethod
    def of(cls, state: RegionState) -> UnionOfParts:
        """What is known of it after a frame."""
        return cls(state.drawn, state.parts, state.constraints, state.trust, Motion.by_region(state))


@dataclass(frozen=True, eq=False)
class InParts:
    """An object in parts: its `units`, what `colours` each has on its key, None without a look, and the `union` of
    those that are parts; None where that is nothing.
    """

    units: tuple[Unit, ...]
    colours: tuple[GlobalModel | None, ...]
    union: UnionOfParts | None

    def colours_of(self, k: int) -> GlobalModel | None:
        """Those of the unit that an outline belongs to."""
        return next(colours for unit, colours in zip(self.units, self.colours, strict=True) if k in unit.members)


@dataclass(frozen=True, eq=False)
class LandmarkPieces:
    """What landmarks have of the energy: `ids (M,)`, `positions (M, 2)` in pixels, weighted `terms` of `(M,)` each."""

    ids: Indices
    positions: Array
    terms: Terms


@dataclass(frozen=True, eq=False)
class Account:
    """Why an outline lies where it lies on a frame.

    Attributes
    ----------
    nodes : (N, 2) on the outline, pixels; `segment`, `t` : (N,) where on the spline.
    terms : (N,) each. Energies by term, of which less is better; of the regions' cues how much more they speak, in
        nats, for the object on its side of the outline than on the other, of which more is better. Empty where there is
        nothing to tell.
    sides : the cues just inside and just outside the outline, nats for the object, `(N,)` each; empty for energies.
    landmarks : the landmarks' pieces, where the configuration has any.
    as_one_piece : where the object was carried as one piece, whatever its cues said, the share of the artist's key's
        corners that were found where its motion puts them; else None.
    """

    nodes: Array
    segment: Indices
    t: Array
    terms: Terms = field(default_factory=dict)
    sides: Mapping[str, tuple[Array, Array]] = field(default_factory=dict)
    landmarks: LandmarkPieces | None = None
    as_one_piece: float | None = None

    @classmethod
    def at(cls, nodes: NodeMap, points: Array) -> Account:
        """With nothing to tell yet of the outline with control points `(P, 3, 2)`."""
        return cls(nodes.nodes(points), nodes.segment, nodes.t)

    @property
    def more_is_better(self) -> bool:
        """True for the cues of regions, False for energies."""
        return REGION in self.terms

    @property
    def total(self) -> Array:
        """The sum over the terms at each node, `(N,)`."""
        return _total(self.terms, len(self.nodes))

    @property
    def landmark_total(self) -> Array:
        """The sum over the terms at each landmark, `(M,)`."""
        return np.empty(0) if self.landmarks is None else _total(self.landmarks.terms, len(self.landmarks.ids))

    @property
    def sums(self) -> dict[str, float]:
        """Each term over all nodes and landmarks; for energies, what tracking reported."""
        parts = [self.terms, {} if self.landmarks is None else self.landmarks.terms]
        names = dict.fromkeys(name for part in parts for name in part)
        return {name: float(sum(part[name].sum() for part in parts if name in part)) for name in names}


def _total(terms: Terms, count: int) -> Array:
    return np.asarray(sum((values for name, values in terms.items() if name != REGION), np.zeros(count)))


class Engine(Protocol):
    """An object as it is known after a frame. Nothing of it changes: a step gives another one."""

    @property
    def frame(self) -> PreparedFrame:
        """The picture that it stands on."""
        ...

    @property
    def landmarks(self) -> tuple[Pool | None, ...]:
        """The landmarks of each outline, in their order; None where the configuration has none."""
        ...

    @property
    def motion(self) -> Motion:
        """How the object lies, beside its outlines."""
        ...

    def step(self, picture: PreparedFrame, order: Sequence[int], token: CancelToken | None = None) -> Step:
        """Carry the outlines to the frame of `picture`.

        `order` are their indices as they are stacked there, the farthest first.

        Raises
        ------
        Cancelled
            at a safe point after `token` was cancelled.
        """
        ...

    def corrected(self, parts: tuple[Part, ...], order: Sequence[int], given: Sequence[bool]) -> Engine | None:
        """The same object where some outlines were `given` on its frame, and the others go on as they were.

        `parts` are all outlines as they lie now, `order` as in `step`. None where all hang on each other, so that the
        object has to be begun anew.
        """
        ...


class Step(Protocol):
    """What came of one step: the object after it, a result for each outline, and why."""

    @property
    def after(self) -> Engine:
        """The object after the step."""
        ...

    @property
    def results(self) -> tuple[StepResult, ...]:
        """One result an outline, in their order."""
        ...

    def account(self, k: int, points: Array, subtracts: bool) -> Account:
        """Why outline `k` lies where it lies, at its control points `(P, 3, 2)`. Nothing is solved for it."""
        ...


def by_pose(nodes: NodeMap, points: Array, pose: Pose | None) -> Account:
    """How unlike its key a part looks around each node of an outline, in [0, 1]; nothing where it has no pose."""
    account = Account.at(nodes, points)
    return account if pose is None else replace(account, terms={POSE: 1.0 - pose.support(account.nodes)})
