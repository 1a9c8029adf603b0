"""The two engines behind one face: regions of a whole object, or the paper's curves one by one."""

from __future__ import annotations

from roam_core.cancel import CancelToken
from roam_core.features import PreparedFrame
from roam_core.landmarks.pool import Pool
from roam_core.params import RoamParams
from roam_core.propagate import region
from roam_core.propagate import step as outline
from roam_core.propagate.region import RegionState
from roam_core.propagate.result import Part, StepResult
from roam_core.propagate.step import TrackerState
from roam_core.threads import each

State = RegionState | tuple[TrackerState, ...]
"""What is known of an object after a frame."""


def begin(picture: PreparedFrame, parts: tuple[Part, ...], params: RoamParams) -> State:
    """The state on a frame whose outlines are given."""
    if params.region is not None:
        return region.begin(picture, parts, params.region)
    return tuple(outline.begin(picture, part.points, params, is_hole=part.subtracts) for part in parts)


def step(
    state: State, picture: PreparedFrame, params: RoamParams, token: CancelToken | None = None
) -> tuple[State, tuple[StepResult, ...]]:
    """Carry the outlines from the state's frame to the one of `picture`; one result an outline, in their order."""
    if isinstance(state, RegionState):
        assert params.region is not None
        return region.step(state, picture, params.region, token)
    pairs = each(lambda outline_state: outline.step(outline_state, picture, params, token), state)
    return tuple(after for after, _ in pairs), tuple(result for _, result in pairs)


def landmarks(state: State) -> tuple[Pool | None, ...]:
    """The landmarks of each outline, in their order; None where the configuration has none."""
    if isinstance(state, RegionState):
        return (None,) * len(state.parts)
    return tuple(None if each.landmarks is None else each.landmarks.pool for each in state)


def picture(state: State) -> PreparedFrame:
    """The picture that the state stands on."""
    return state.frame if isinstance(state, RegionState) else state[0].frame
