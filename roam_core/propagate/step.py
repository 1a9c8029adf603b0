"""One shape, one frame: pre-warp, inference, fit back to the control points, confidence."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from roam_core.cancel import CancelToken
from roam_core.energy import total
from roam_core.energy.total import CurveContext
from roam_core.features import PreparedFrame, Region
from roam_core.geometry import bezier, polyline, similarity
from roam_core.inference.contour_dp import descend
from roam_core.motion.klt import similarity_warp
from roam_core.params import DOUBTFUL, RoamParams, scale_for
from roam_core.propagate.confidence import frame_confidence, node_support
from roam_core.propagate.nodes import NodeMap
from roam_core.propagate.result import StepResult, Termination

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class TrackerState:
    """What the engine knows after a frame: cache, recomputable from the artist's keys, never saved in a project."""

    frame: PreparedFrame
    points: Array
    nodes: NodeMap


def begin(frame: PreparedFrame, points: Array, params: RoamParams) -> TrackerState:
    """The state on a frame whose outline is given."""
    return TrackerState(frame, points, NodeMap.of(points, params, scale_for(frame.size)))


def step(
    state: TrackerState, frame: PreparedFrame, params: RoamParams, token: CancelToken | None = None
) -> tuple[TrackerState, StepResult]:
    """Carry the outline from the state's frame to `frame`."""
    scale = scale_for(frame.size)
    warp = similarity_warp(state.frame, frame, bezier.flatten(state.points), params, scale)
    if token is not None:
        token.check()
    prior = similarity.apply(warp.transform, state.points)
    nodes = state.nodes.nodes(prior)
    if _is_outside(nodes, frame.size):
        return _left(state, frame, prior)
    context = curve_context(frame, nodes, params, scale)
    solution = descend(nodes, context, params, scale, token)
    points = state.nodes.points(solution.nodes, prior)
    fitted = state.nodes.nodes(points)
    support = node_support(fitted, context, scale)
    confidence = frame_confidence(support, warp)
    result = StepResult(
        points=points,
        confidence=confidence,
        vertex_confidence=_per_point(support, state.nodes, len(points)),
        energies=total.energies(fitted, context, params),
        termination=_termination(confidence, solution.converged),
    )
    return TrackerState(frame, points, state.nodes), result


def curve_context(frame: PreparedFrame, nodes: Array, params: RoamParams, scale: float) -> CurveContext:
    """The features around `nodes` that the curve's terms look at, wide enough for every round of moves."""
    reach = sum(params.window // 2 * s * params.max_iterations for s in params.steps) + 12.0
    region = Region.around(nodes, reach * scale, frame.size)
    field = frame.squared_gradient(region, params.gradient_sigma * scale)
    spacing = max(polyline.length(nodes) / len(nodes), 1e-6)
    return CurveContext(field, region.origin, spacing)


def _termination(confidence: float, converged: bool) -> Termination:
    if confidence < DOUBTFUL:
        return Termination.LOW_CONFIDENCE
    return Termination.CONVERGED if converged else Termination.MAX_ITERATIONS


def _left(state: TrackerState, frame: PreparedFrame, prior: Array) -> tuple[TrackerState, StepResult]:
    """The outline has left the picture: it goes on as it moved, and says so."""
    result = StepResult(prior, 0.0, np.zeros(len(prior)), {}, Termination.LEFT_FRAME)
    return TrackerState(frame, prior, state.nodes), result


def _is_outside(nodes: Array, size: tuple[int, int]) -> bool:
    low, high = nodes.min(axis=0), nodes.max(axis=0)
    return bool(high[0] <= 0 or high[1] <= 0 or low[0] >= size[1] or low[1] >= size[0])


def _per_point(support: Array, nodes: NodeMap, count: int) -> Array:
    """Support of the nodes as support of the control points: the mean over the two segments that meet there."""
    start, stop = nodes.segment, (nodes.segment + 1) % count
    total_support = np.bincount(start, support, count) + np.bincount(stop, support, count)
    members = np.bincount(start, minlength=count) + np.bincount(stop, minlength=count)
    return np.asarray(np.where(members > 0, total_support / np.maximum(members, 1), support.mean()))
