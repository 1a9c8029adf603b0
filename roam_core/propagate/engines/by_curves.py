"""The paper's curves, each by itself: an object is its outlines, and no outline knows of another."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from roam_core.arrays import Array
from roam_core.cancel import CancelToken
from roam_core.energy.shares import curve_shares, joint_shares
from roam_core.features import PreparedFrame
from roam_core.landmarks.pool import Pool
from roam_core.params import RoamParams
from roam_core.propagate.curves import step as curve
from roam_core.propagate.curves.step import CurveStep, TrackerState
from roam_core.propagate.engines.protocol import Account, LandmarkPieces, Motion
from roam_core.propagate.frame.result import Part, StepResult
from roam_core.threads import each


@dataclass(frozen=True, eq=False)
class CurveEngine:
    """Outlines carried one by one (`propagate.curves.step`)."""

    states: tuple[TrackerState, ...]
    params: RoamParams

    @classmethod
    def begun(cls, picture: PreparedFrame, parts: Sequence[Part], params: RoamParams) -> CurveEngine:
        """On a frame whose outlines are given."""
        return cls(tuple(curve.begin(picture, part.points, params, is_hole=part.subtracts) for part in parts), params)

    @property
    def frame(self) -> PreparedFrame:
        return self.states[0].frame

    @property
    def landmarks(self) -> tuple[Pool | None, ...]:
        return tuple(None if state.landmarks is None else state.landmarks.pool for state in self.states)

    @property
    def motion(self) -> Motion:
        count = len(self.states)
        return Motion(None, None, (False,) * count, pose_costs=(None,) * count)

    def step(self, picture: PreparedFrame, order: Sequence[int], token: CancelToken | None = None) -> CurvesStep:
        steps = each(lambda state: curve.step(state, picture, self.params, token), self.states)
        return CurvesStep(tuple(steps), self.params)

    def corrected(self, parts: tuple[Part, ...], order: Sequence[int], given: Sequence[bool]) -> None:
        return None


@dataclass(frozen=True, eq=False)
class CurvesStep:
    """One step of all outlines."""

    steps: tuple[CurveStep, ...]
    params: RoamParams

    @property
    def after(self) -> CurveEngine:
        return CurveEngine(tuple(step.state for step in self.steps), self.params)

    @property
    def results(self) -> tuple[StepResult, ...]:
        return tuple(step.result for step in self.steps)

    def account(self, k: int, points: Array, subtracts: bool) -> Account:
        """The pieces of the joint energy at the nodes that inference moved."""
        step, params = self.steps[k], self.params
        account, seen = Account.at(step.begun.nodes, points), step.observation
        if seen is None:
            return account
        terms = dict(curve_shares(account.nodes, seen.curve, params))
        pool = step.begun.landmarks
        if seen.landmarks is None or step.placing is None or params.landmarks is None or pool is None:
            return replace(account, terms=terms)
        at_nodes, at_landmarks = joint_shares(account.nodes, step.placing, seen.landmarks, params.landmarks)
        found = LandmarkPieces(pool.pool.ids, step.placing.star(seen.landmarks).leaves, at_landmarks)
        return replace(account, terms=terms | dict(at_nodes), landmarks=found)
