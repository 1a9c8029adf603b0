"""A whole object: all its outlines are fitted to one region."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from roam_core.arrays import Array, Float32
from roam_core.cancel import CancelToken
from roam_core.features import PreparedFrame
from roam_core.features.grid import Grid
from roam_core.geometry import polyline
from roam_core.landmarks.pool import Pool
from roam_core.motion.template import Template
from roam_core.params import RegionParams, RoamParams, scale_for
from roam_core.propagate.engines.protocol import REGION, Account, ByPose, Motion, by_pose
from roam_core.propagate.frame.nodes import NodeMap
from roam_core.propagate.frame.result import Part, StepResult
from roam_core.propagate.whole import posed, region
from roam_core.propagate.whole.region import RegionStep
from roam_core.propagate.whole.state import RegionState, begin, knowing
from roam_core.proposal.cues.evidence import cues
from roam_core.proposal.segment.region import cleaned

BESIDE = 2.0
"""Cells from the outline to the places inside and outside of it where the cues are asked."""


@dataclass(frozen=True, eq=False)
class RegionEngine:
    """All outlines of an object fitted to its region (`propagate.whole.region`)."""

    state: RegionState
    params: RoamParams

    @classmethod
    def begun(cls, picture: PreparedFrame, parts: tuple[Part, ...], params: RoamParams) -> RegionEngine:
        """On a frame whose outlines are given."""
        return cls(begin(picture, parts, region_params(params)), params)

    @property
    def frame(self) -> PreparedFrame:
        return self.state.frame

    @property
    def landmarks(self) -> tuple[Pool | None, ...]:
        return (None,) * len(self.state.parts)

    @property
    def motion(self) -> Motion:
        return replace(Motion.by_region(self.state), by_pose=self._by_pose)

    @property
    def _by_pose(self) -> ByPose | None:
        """The lone shape by its pose; None where there is none."""
        pose, params = self.state.pose, region_params(self.params)
        if pose is None:
            return None
        points = tuple(part.points for part in posed.carried(pose, self.state.drawn))
        is_part = posed.is_believable(pose, params) or posed.is_steady(pose, params)
        trust = posed.trust(pose, params.confidence)
        return ByPose(points, pose.cost, trust, pose.is_gone, is_part)

    def step(self, picture: PreparedFrame, order: Sequence[int], token: CancelToken | None = None) -> WholeStep:
        return WholeStep(region.step(self.state, picture, region_params(self.params), token), self.params)

    def knowing(self, other: RegionEngine) -> RegionEngine:
        """The same on its key, with the textures of the object on another key as well as its own."""
        return replace(self, state=knowing(self.state, other.state))

    def looking_as(self, template: Template) -> RegionEngine:
        """The same on its key, where its pose goes by another template."""
        assert self.state.pose is not None
        pose = replace(self.state.pose, template=template)
        return replace(self, state=replace(self.state, pose=pose))

    def corrected(self, parts: tuple[Part, ...], order: Sequence[int], given: Sequence[bool]) -> None:
        return None


@dataclass(frozen=True, eq=False)
class WholeStep:
    """One step of a whole object."""

    step: RegionStep
    params: RoamParams

    @property
    def after(self) -> RegionEngine:
        return RegionEngine(self.step.state, self.params)

    @property
    def results(self) -> tuple[StepResult, ...]:
        return self.step.results

    def account(self, k: int, points: Array, subtracts: bool) -> Account:
        return account_of(self.step, points, subtracts, self.params)


def region_params(params: RoamParams) -> RegionParams:
    """The parameters of the regions, which a configuration of this engine has."""
    assert params.region is not None
    return params.region


def account_of(step: RegionStep, points: Array, subtracts: bool, params: RoamParams) -> Account:
    """Why an outline of the object lies at `points`: by its pose, or by the cues at its sides."""
    nodes = NodeMap.of(points, params, scale_for(step.state.frame.size))
    if step.state.is_posed:
        return by_pose(nodes, points, step.state.pose)
    account = replace(Account.at(nodes, points), as_one_piece=step.state.agreement_as_one_piece)
    if step.observation is None:
        return account
    chosen, sources = region_params(params), step.observation.sources
    beside = _both_sides(account.nodes, sources.grid)
    sides = {name: beside(values) for name, values in cues(sources, chosen)}
    evidence = region.evidence(step.observation, chosen, step.state.covers)
    found = cleaned(evidence, sources.expected.possible, chosen.overlap, chosen.components.speck)
    sides[REGION] = beside(found.values)
    sign = -1.0 if subtracts else 1.0  # inside a hole there is no object
    terms = {name: sign * (inside - outside) for name, (inside, outside) in sides.items()}
    return replace(account, terms=terms, sides=sides)


def _both_sides(nodes: Array, grid: Grid) -> Callable[[Float32], tuple[Array, Array]]:
    """Reads a field `(rows, columns)` on the grid at each node, `BESIDE` cells inside the outline and outside."""
    here = grid.to_grid(nodes)
    normals = polyline.outward_normals(here)
    cells = [
        np.clip(np.floor(here + offset * normals).astype(np.intp), 0, [grid.columns - 1, grid.rows - 1])
        for offset in (-BESIDE, BESIDE)
    ]

    def read(values: Float32) -> tuple[Array, Array]:
        inside, outside = (values[cell[:, 1], cell[:, 0]].astype(np.float64) for cell in cells)
        return inside, outside

    return read
