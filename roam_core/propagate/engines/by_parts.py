"""An object in parts: limbs by their poses, what hides them, and whole objects behind that."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from roam_core.arrays import Array
from roam_core.cancel import CancelToken
from roam_core.features import PreparedFrame
from roam_core.landmarks.pool import Pool
from roam_core.params import RoamParams, scale_for
from roam_core.propagate.engines.by_regions import account_of, region_params
from roam_core.propagate.engines.protocol import Account, InParts, Motion, UnionOfParts, by_pose
from roam_core.propagate.frame.nodes import NodeMap
from roam_core.propagate.frame.result import Part, StepResult
from roam_core.propagate.parts import figure, solving
from roam_core.propagate.parts.figure import FigureState
from roam_core.propagate.parts.solving import FigureStep
from roam_core.propagate.shapes.objects import Unit


@dataclass(frozen=True, eq=False)
class PartsEngine:
    """An object in parts (`propagate.parts.figure`)."""

    state: FigureState
    params: RoamParams

    @classmethod
    def begun(
        cls,
        picture: PreparedFrame,
        parts: Sequence[Part],
        params: RoamParams,
        made: Sequence[Unit],
        order: Sequence[int],
    ) -> PartsEngine:
        """On a frame whose outlines are given; `made` tells what they are in their object."""
        return cls(figure.begin(picture, parts, made, region_params(params), order), params)

    @property
    def frame(self) -> PreparedFrame:
        return self.state.frame

    @property
    def landmarks(self) -> tuple[Pool | None, ...]:
        return (None,) * len(self.state.parts)

    @property
    def motion(self) -> Motion:
        """That of what is not in parts behind the occluders, where that is one object."""
        count, limb = len(self.state.parts), self.state.whole
        by_poses = Motion(
            None,
            None,
            (False,) * count,
            pose_costs=self.state.pose_costs,
            at_poses=self.state.at_poses,
            in_parts=self._in_parts,
        )
        if limb is None or limb.whole is None:
            return by_poses
        return replace(
            by_poses,
            since_key=limb.whole.key.to_now,
            region=limb.whole.region,
            of_region=tuple(k in limb.unit.members for k in range(count)),
            as_one_piece=limb.whole.agreement_as_one_piece is not None,
            key=limb.whole.key,
        )

    @property
    def _in_parts(self) -> InParts:
        limbs, union = self.state.limbs, self.state.union
        units, colours = tuple(limb.unit for limb in limbs), tuple(limb.colours for limb in limbs)
        return InParts(units, colours, None if union is None else UnionOfParts.of(union))

    def step(self, picture: PreparedFrame, order: Sequence[int], token: CancelToken | None = None) -> PartsStep:
        return PartsStep(solving.step(self.state, picture, region_params(self.params), order, token), self.params)

    def corrected(self, parts: tuple[Part, ...], order: Sequence[int], given: Sequence[bool]) -> PartsEngine:
        return PartsEngine(figure.corrected(self.state, parts, region_params(self.params), order, given), self.params)


@dataclass(frozen=True, eq=False)
class PartsStep:
    """One step of an object in parts."""

    step: FigureStep
    params: RoamParams

    @property
    def after(self) -> PartsEngine:
        return PartsEngine(self.step.state, self.params)

    @property
    def results(self) -> tuple[StepResult, ...]:
        return self.step.state.results

    def account(self, k: int, points: Array, subtracts: bool) -> Account:
        limb = self.step.state.limb_of(k)
        whole = self.step.union if limb.goes_along else self.step.wholes.get(limb.unit.members)
        if whole is not None:
            return account_of(whole, points, subtracts, self.params)
        nodes = NodeMap.of(points, self.params, scale_for(self.step.state.frame.size))
        return by_pose(nodes, points, limb.pose)
