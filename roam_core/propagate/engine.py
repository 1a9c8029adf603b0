"""The engines behind one face: regions of a whole object, an object in parts, or the paper's curves one by one."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from roam_core.cancel import CancelToken
from roam_core.features import PreparedFrame
from roam_core.landmarks.pool import Pool
from roam_core.params import RoamParams
from roam_core.propagate import figure, posed, region
from roam_core.propagate import step as outline
from roam_core.propagate.figure import FigureState
from roam_core.propagate.objects import Role, Unit
from roam_core.propagate.region import RegionState
from roam_core.propagate.result import Part, StepResult
from roam_core.propagate.step import TrackerState
from roam_core.threads import each

Array = NDArray[np.float64]
State = RegionState | FigureState | tuple[TrackerState, ...]
"""What is known of an object after a frame."""


def begin(
    picture: PreparedFrame, parts: tuple[Part, ...], params: RoamParams, made: Sequence[Unit], order: Sequence[int]
) -> State:
    """The state on a frame whose outlines are given.

    `made` tells what they are in their object (`objects.units`), `order` their indices as they are stacked on the
    frame, the farthest first.
    """
    if params.region is None:
        return tuple(outline.begin(picture, part.points, params, is_hole=part.subtracts) for part in parts)
    if params.region.part is None or (len(made) == 1 and made[0].role is Role.WHOLE):
        return region.begin(picture, parts, params.region)
    return figure.begin(picture, parts, made, params.region, order)


def corrected(
    state: State,
    picture: PreparedFrame,
    parts: tuple[Part, ...],
    params: RoamParams,
    made: Sequence[Unit],
    order: Sequence[int],
    given: Sequence[bool],
) -> State:
    """The state after a frame on which some outlines were `given`: what hangs on nothing else goes on as it was."""
    if isinstance(state, FigureState):
        assert params.region is not None
        return figure.corrected(state, parts, params.region, order, given)
    return begin(picture, parts, params, made, order)


def step(
    state: State,
    picture: PreparedFrame,
    params: RoamParams,
    token: CancelToken | None,
    order: Sequence[int],
) -> tuple[State, tuple[StepResult, ...]]:
    """Carry the outlines from the state's frame to the one of `picture`; one result an outline, in their order.

    `order` is that of `begin`, on this frame.
    """
    if isinstance(state, RegionState):
        assert params.region is not None
        return region.step(state, picture, params.region, token)
    if isinstance(state, FigureState):
        assert params.region is not None
        return figure.step(state, picture, params.region, order, token)
    pairs = each(lambda outline_state: outline.step(outline_state, picture, params, token), state)
    return tuple(after for after, _ in pairs), tuple(result for _, result in pairs)


def as_region(state: State) -> tuple[RegionState | None, tuple[bool, ...]]:
    """The state of what is carried as one region, and which outlines are of it, in their order."""
    if isinstance(state, RegionState):
        return state, (True,) * len(state.parts)
    if not isinstance(state, FigureState):
        return None, (False,) * len(state)
    limb, count = state.whole, len(state.parts)
    if limb is None:
        return None, (False,) * count
    return limb.whole, tuple(k in limb.unit.members for k in range(count))


def pose_costs(state: State) -> tuple[float | None, ...]:
    """For each outline of a figure what its pose costs (`motion.pose`), in their order; None where it has none."""
    if isinstance(state, FigureState):
        return state.pose_costs
    return (None,) * len(state.parts if isinstance(state, RegionState) else state)


def by_pose(state: State, params: RoamParams) -> tuple[tuple[Array, ...], float] | None:
    """The outlines of a lone shape by its pose, and what that costs; None where that may not be believed."""
    if not isinstance(state, RegionState) or state.pose is None or params.region is None:
        return None
    if not posed.is_believable(state.pose, params.region):
        return None
    parts = posed.carried(state.pose, state.drawn)
    return tuple(part.points for part in parts), state.pose.cost


def landmarks(state: State) -> tuple[Pool | None, ...]:
    """The landmarks of each outline, in their order; None where the configuration has none."""
    if isinstance(state, RegionState | FigureState):
        return (None,) * len(state.parts)
    return tuple(None if each.landmarks is None else each.landmarks.pool for each in state)


def picture(state: State) -> PreparedFrame:
    """The picture that the state stands on."""
    return state.frame if isinstance(state, RegionState | FigureState) else state[0].frame
