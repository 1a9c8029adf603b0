"""The landmarks of one outline through time: the pool, its pairs with the nodes, and what they say of a frame."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from roam_core.arrays import Array, Bools
from roam_core.energy.joint import Pairs, completed, paired
from roam_core.energy.joint_total import LandmarkContext, Placing
from roam_core.features import PreparedFrame
from roam_core.kernels.coverage import coverage
from roam_core.landmarks.filters import between, peaks
from roam_core.landmarks.pool import LastSeen, Pool
from roam_core.landmarks.star import Star
from roam_core.motion.klt import Warp
from roam_core.params import LandmarkParams, scale_for


@dataclass(frozen=True, eq=False)
class LandmarkState:
    """The landmarks as they are on a frame, and the pairs of equation 8 with their shifts."""

    pool: Pool
    pairs: Pairs


def begin(frame: PreparedFrame, nodes: Array, params: LandmarkParams | None, first_id: int = 0) -> LandmarkState | None:
    """Landmarks detected inside the outline `nodes (N, 2)` that the artist gave, paired with it; None if unwanted."""
    if params is None:
        return None
    pool = Pool.learned(frame, _covered(nodes, frame.size), params, first_id)
    return LandmarkState(pool, paired(nodes, pool.positions, params.neighbours))


def search(state: LandmarkState, frame: PreparedFrame) -> LastSeen:
    """Look for the landmarks around where they were on the frame before."""
    reach = state.pool.params.search * scale_for(frame.size)
    return state.pool.located(frame, state.pool.positions, reach)


def context(state: LandmarkState, frame: PreparedFrame, warp: Warp) -> LandmarkContext:
    """The star and the shifts as the pre-warp expects them, and what the filters say around there.

    Landmarks that are ambiguous on this frame, and so removed after it, have no say in where the curve goes.
    """
    scale, params = scale_for(frame.size), state.pool.params
    rest = Star.of(state.pool.positions).carried(warp.transform)
    last_seen = state.pool.located(frame, rest.leaves, params.reach * scale)
    pairs = state.pairs.turned(warp.transform).of(last_seen.sharpness >= params.ambiguity)
    return LandmarkContext(rest, last_seen.response, last_seen.cell, pairs, scale)


def adapted(
    state: LandmarkState, frame: PreparedFrame, seen: LandmarkContext, placing: Placing, nodes: Array, trust: float
) -> LandmarkState:
    """The landmarks after a frame that was solved with `placing` and `nodes (N, 2)`, adapted by `trust`.

    Inference knows whole cells; between them the filters' answers tell the place. Rounded places would be learned from,
    and the landmarks would walk by up to half a cell a frame.
    """
    leaves = placing.star(seen).leaves + seen.cell * between(seen.response, *placing.leaves.T)
    sharpness = peaks(seen.response, state.pool.params.filters.lobe)[1]
    pool = state.pool.adapted(frame, leaves, sharpness, _covered(nodes, frame.size), trust)
    survivors = np.searchsorted(state.pool.ids, pool.ids[pool.ids < state.pool.next_id])
    solved = seen.pairs.followed(nodes, leaves, state.pool.params.shift_rate)
    pairs = solved.between(survivors)
    return LandmarkState(pool, completed(pairs, nodes, pool.positions, pool.params.neighbours))


def renewed(state: LandmarkState, nodes: Array, fresh: Bools) -> LandmarkState:
    """The landmarks with the `fresh (N,)` ones of `nodes (N, 2)` paired anew, their shifts as they are now."""
    keep = ~fresh[state.pairs.node]
    kept = Pairs(state.pairs.node[keep], state.pairs.leaf[keep], state.pairs.shift[keep])
    return replace(state, pairs=completed(kept, nodes, state.pool.positions, state.pool.params.neighbours))


def _covered(nodes: Array, size: tuple[int, int]) -> Bools:
    return np.asarray(coverage(nodes, size) > 0.5)
