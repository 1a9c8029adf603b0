"""One shape, one frame: pre-warp, inference, fit back to the control points, confidence."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from roam_core.appearance.band import Band
from roam_core.appearance.colour_models import ColourModels
from roam_core.arrays import Array, Float32
from roam_core.cancel import CancelToken
from roam_core.energy import joint_total, total
from roam_core.energy.colour_fields import ColourFields
from roam_core.energy.joint_total import LandmarkContext, Placing
from roam_core.energy.total import CurveContext
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.geometry import polyline, similarity
from roam_core.geometry.simple import untied
from roam_core.inference.alternate import alternate
from roam_core.inference.contour_dp import Unary, descend
from roam_core.motion.klt import Warp
from roam_core.params import AppearanceParams, RoamParams, is_doubtful, scale_for
from roam_core.propagate.curves import landmarks
from roam_core.propagate.curves.landmarks import LandmarkState
from roam_core.propagate.curves.prewarp import expected
from roam_core.propagate.curves.reshaping import reshape
from roam_core.propagate.frame.confidence import frame_confidence, node_support, wholeness
from roam_core.propagate.frame.nodes import NodeMap
from roam_core.propagate.frame.redetection import Watch, as_on_key, is_better
from roam_core.propagate.frame.result import StepResult, Termination
from roam_core.proposal.cues.nearest_colours import NearestColours

LocalRatio = Callable[[Grid], Float32]
"""Something that gives ln p_f / p_b of each cell of a grid."""


@dataclass(frozen=True, eq=False)
class TrackerState:
    """What the engine knows after a frame: cache, recomputable from the artist's keys, never saved in a project.

    Attributes
    ----------
    frame, points : the picture and the outline (P, 3, 2) on it.
    nodes : where the nodes lie on the spline; their edges keep their index through time.
    models : the curve's colours, as far as the configuration wants any.
    landmarks : those inside the outline, where the configuration wants them.
    nearest : the pictures whose colours stand for the local models, where the configuration has it so.
    extent : the area of the artist's outline as the pre-warps have carried it since, square pixels.
    watch : what it is known again by, where the configuration looks for what is lost.
    """

    frame: PreparedFrame
    points: Array
    nodes: NodeMap
    models: ColourModels | None = None
    landmarks: LandmarkState | None = None
    nearest: NearestColours | None = None
    extent: float = 0.0
    watch: Watch | None = None

    @property
    def promise(self) -> float:
        """How much the inside looks like the object on the key, in [0, 1]; 1 where nobody watches."""
        return 1.0 if self.watch is None else self.watch.resemblance


@dataclass(frozen=True, eq=False)
class Solved:
    """What inference found on a frame: the nodes, whether it came to rest, and the landmarks if there are any."""

    nodes: Array
    converged: bool
    placing: Placing | None = None


def begin(frame: PreparedFrame, points: Array, params: RoamParams, is_hole: bool = False) -> TrackerState:
    """The state on a frame whose outline the artist gave: everything is learned from this key.

    So a correction teaches every edge what it looks like there, and a run through the key goes on exactly as one that
    was stopped and corrected at it: nothing of what was adapted before the key outlives it (path independence).
    A hole is not looked for when it is lost.
    """
    state = _learned(frame, points, params)
    if is_hole or state.nearest is None or state.nearest.params.doubted <= 0:
        return state
    return replace(state, watch=Watch.begun(points, frame, state.nearest.region, state.nearest.params))


def _learned(frame: PreparedFrame, points: Array, params: RoamParams, first_id: int = 0) -> TrackerState:
    """All that a frame teaches whose outline is known, landmarks numbered from `first_id` on; nobody watches yet."""
    scale = scale_for(frame.size)
    nodes = NodeMap.of(points, params, scale)
    line = nodes.nodes(points)
    models = ColourModels.learned(frame, line, params, scale)
    colour, nearest = params.appearance, None
    if colour is not None and colour.local_kind != "mixture":
        nearest = NearestColours.learned(frame, line, colour.cues)
    known = landmarks.begin(frame, line, params.landmarks, first_id)
    return TrackerState(frame, points, nodes, models, known, nearest, abs(polyline.signed_area(line)))


@dataclass(frozen=True, eq=False)
class Observation:
    """What is seen on a frame before inference: the pre-warped `nodes (N, 2)`, and what the terms look at."""

    nodes: Array
    curve: CurveContext
    landmarks: LandmarkContext | None


@dataclass(frozen=True, eq=False)
class CurveStep:
    """One step of one outline.

    Attributes
    ----------
    begun : the state that it set out from: the one given, or, where the object was looked for and found, one in which
        it lies there as on its key. state, result : what came of it.
    observation : what the terms looked at; None where the outline has left the picture. placing : the landmarks as
        inference has them, if there are any.
    """

    begun: TrackerState
    state: TrackerState
    result: StepResult
    observation: Observation | None = None
    placing: Placing | None = None


def step(state: TrackerState, frame: PreparedFrame, params: RoamParams, token: CancelToken | None = None) -> CurveStep:
    """Carry the outline from the state's frame to `frame`.

    Where its inside then looks too little like the object on the key, that is looked for, and taken from there if it
    looks more so (`propagate.frame.redetection`).
    """
    carried = _carried(state, frame, params, token)
    if state.watch is None or params.appearance is None or carried.state.promise >= params.appearance.cues.doubted:
        return carried
    found = _as_last_seen(carried.state, frame, params)
    if found is None:
        return carried
    again = _carried(found, frame, params, token)
    promise = again.state.promise
    return again if is_better(promise, promise, carried.state.promise, params.appearance.cues) else carried


def _as_last_seen(state: TrackerState, frame: PreparedFrame, params: RoamParams) -> TrackerState | None:
    """As if, the frame before, the object had lain as on the key where it is seen on `frame`.

    All that was learned since the key is forgotten: it was learned from something else.
    """
    watch, nearest = state.watch, state.nearest
    if watch is None or nearest is None or not watch.last_seen.is_worth_a_look:
        return None
    to_now = watch.appearance.found(frame, watch.last_seen)
    if to_now is None:
        return None
    picture, points = as_on_key(watch.appearance.frame, to_now), similarity.apply(to_now[:2], watch.drawn)
    first_id = 0 if state.landmarks is None else state.landmarks.pool.next_id
    fresh = _learned(picture, points, params, first_id)
    assert fresh.nearest is not None
    key = replace(nearest.key, to_now=to_now)
    return replace(fresh, nearest=replace(fresh.nearest, key=key), watch=watch)


def _carried(state: TrackerState, frame: PreparedFrame, params: RoamParams, token: CancelToken | None) -> CurveStep:
    """The outline carried on from where the state has it."""
    scale = scale_for(frame.size)
    moved, prior = expected(state.frame, frame, state.points, state.landmarks, params)
    if token is not None:
        token.check()
    observation = observed(state, frame, moved, prior, params)
    if observation is None:
        return _left(state, frame, prior, moved)
    context, seen = observation.curve, observation.landmarks
    solution = solved(observation, params, scale, token)
    points = untied(state.nodes.points(solution.nodes, prior), prior, scale, params.untying)
    pull = _pull(solution.placing, seen, params)
    least = _least_area(state, moved, params)
    new = reshape(frame, points, prior, state.nodes, context.for_any_curve(), params, scale, pull, least)
    points = new.points
    fitted = state.nodes.nodes(points)
    support = node_support(fitted, context, scale, params.confidence)
    confidence = frame_confidence(support, moved)
    extent = state.extent * abs(float(np.linalg.det(moved.transform[:, :2])))
    nearest, watch = state.nearest, state.watch
    if nearest is not None:
        nearest = nearest.adapted(frame, fitted, moved.transform)
        if watch is not None:
            watch = watch.after(frame, fitted, nearest.key, nearest.region, nearest.params)
    trust = confidence * wholeness(fitted, extent, params.confidence)
    if watch is not None:
        trust = min(trust, watch.resemblance)
    result = StepResult(
        points=points,
        confidence=trust,
        vertex_confidence=_per_point(support, state.nodes, len(points)),
        energies=_energies(fitted, solution.placing, context, seen, params),
        termination=_termination(trust, solution.converged),
        proposals=new.topology,
    )
    models = None if state.models is None else state.models.adapted(frame, fitted, params, scale, confidence)
    known = _marked(state.landmarks, frame, seen, solution.placing, fitted, confidence)
    if known is not None and new.changed:
        known = landmarks.renewed(known, fitted, new.fresh)
    after = TrackerState(frame, points, state.nodes, models, known, nearest, extent, watch)
    return CurveStep(state, after, result, observation, solution.placing)


def observed(
    state: TrackerState, frame: PreparedFrame, moved: Warp, prior: Array, params: RoamParams
) -> Observation | None:
    """What the terms see around the pre-warped outline `prior (P, 3, 2)`; None where it has left the picture."""
    nodes = state.nodes.nodes(prior)
    if _is_outside(nodes, frame.size):
        return None
    nearest = state.nearest
    local = None if nearest is None else lambda grid: nearest.log_ratio(frame, grid, moved.transform)
    curve = curve_context(frame, nodes, params, scale_for(frame.size), state.models, local)
    seen = None if state.landmarks is None else landmarks.context(state.landmarks, frame, moved)
    return Observation(nodes, curve, seen)


def solved(observation: Observation, params: RoamParams, scale: float, token: CancelToken | None = None) -> Solved:
    """The curve alone, or the curve and the landmarks in turn."""
    if observation.landmarks is None:
        alone = descend(observation.nodes, observation.curve, params, scale, token)
        return Solved(alone.nodes, alone.converged)
    both = alternate(observation.nodes, observation.curve, observation.landmarks, params, token)
    return Solved(both.nodes, both.converged, both.placing)


def _least_area(state: TrackerState, moved: Warp, params: RoamParams) -> float:
    """What proposals have to leave of the object on the frame that `moved` leads to, square pixels."""
    if state.nearest is None or params.proposals is None:
        return 0.0
    return params.proposals.least_share * state.nearest.remembered_area(moved.transform)


def _pull(placing: Placing | None, seen: LandmarkContext | None, params: RoamParams) -> Unary | None:
    """E^J on the nodes with the landmarks where they were found."""
    weights = params.landmarks
    if placing is None or seen is None or weights is None:
        return None
    star = placing.star(seen)
    return lambda nodes, moves: joint_total.node_table(nodes, moves, star, seen, weights)


def _energies(
    nodes: Array, placing: Placing | None, context: CurveContext, seen: LandmarkContext | None, params: RoamParams
) -> Mapping[str, float]:
    if seen is None or placing is None:
        return total.energies(nodes, context, params)
    return joint_total.energies(nodes, placing, context, seen, params)


def _marked(
    state: LandmarkState | None,
    frame: PreparedFrame,
    seen: LandmarkContext | None,
    placing: Placing | None,
    nodes: Array,
    confidence: float,
) -> LandmarkState | None:
    """The landmarks after the frame; they learn from it as far as it is trusted."""
    if state is None or seen is None or placing is None:
        return state
    return landmarks.adapted(state, frame, seen, placing, nodes, confidence)


def curve_context(
    frame: PreparedFrame,
    nodes: Array,
    params: RoamParams,
    scale: float,
    models: ColourModels | None = None,
    local: LocalRatio | None = None,
) -> CurveContext:
    """The features around `nodes` that the curve's terms look at, wide enough for every round of moves.

    `local`, where it is given, speaks in place of the edges' models, or with them (`AppearanceParams.local_kind`).
    """
    reach = sum(params.window // 2 * s * params.max_iterations for s in params.steps)
    region = Region.around(nodes, (reach + params.gradient_margin) * scale, frame.size)
    field = frame.squared_gradient(region, params.gradient_sigma * scale, params.gradient_floor, params.gradient_top)
    spacing = max(polyline.length(nodes) / len(nodes), 1e-6)
    orientation = 1.0 if polyline.signed_area(nodes) > 0 else -1.0
    colours = None
    if models is not None and params.appearance is not None:
        colours = _colour_fields(frame, nodes, params.appearance, scale, reach, models, local)
    return CurveContext(field, region.origin, spacing, orientation, colours, np.roll(nodes, -1, axis=0) - nodes)


def _colour_fields(
    frame: PreparedFrame,
    nodes: Array,
    params: AppearanceParams,
    scale: float,
    reach: float,
    models: ColourModels,
    local: LocalRatio | None,
) -> ColourFields:
    """What the colour models say of every cell that the ribbon of a moved edge may cover."""
    band = Band.around(frame, nodes, reach + params.ribbon_depth, scale)
    foreground, background = _local_densities(band, params, models, local)
    whole = None if models.whole is None else models.whole.log_ratio(band, params)
    return ColourFields(band.grid, foreground, background, params.clip, whole)


def _local_densities(
    band: Band, params: AppearanceParams, models: ColourModels, local: LocalRatio | None
) -> tuple[Float32, Float32]:
    """ln p_n^f and ln p_n^b by whatever `AppearanceParams.local_kind` names; only their difference is known of some."""
    if local is None:
        return models.edges.log_densities(band, params)
    ratio = np.clip(local(band.grid), -params.clip, params.clip)
    if params.local_kind == "both":
        foreground, background = models.edges.log_densities(band, params)
        ratio = np.float32(0.5) * (ratio + np.clip(foreground - background, -params.clip, params.clip))
    half = np.asarray(np.float32(0.5) * ratio, dtype=np.float32)
    return half, -half


def _termination(confidence: float, converged: bool) -> Termination:
    if is_doubtful(confidence):
        return Termination.LOW_CONFIDENCE
    return Termination.CONVERGED if converged else Termination.MAX_ITERATIONS


def _left(state: TrackerState, frame: PreparedFrame, prior: Array, moved: Warp) -> CurveStep:
    """The outline has left the picture: it goes on as it moved, and says so."""
    result = StepResult(prior, 0.0, np.zeros(len(prior)), {}, Termination.LEFT_FRAME)
    nearest = state.nearest and state.nearest.adapted(frame, state.nodes.nodes(prior), moved.transform)
    watch = state.watch and state.watch.missed()
    return CurveStep(state, replace(state, frame=frame, points=prior, nearest=nearest, watch=watch), result)


def _is_outside(nodes: Array, size: tuple[int, int]) -> bool:
    low, high = nodes.min(axis=0), nodes.max(axis=0)
    return bool(high[0] <= 0 or high[1] <= 0 or low[0] >= size[1] or low[1] >= size[0])


def _per_point(support: Array, nodes: NodeMap, count: int) -> Array:
    """Support of the nodes as support of the control points: the mean over the two segments that meet there."""
    start, stop = nodes.segment, (nodes.segment + 1) % count
    total_support = np.bincount(start, support, count) + np.bincount(stop, support, count)
    members = np.bincount(start, minlength=count) + np.bincount(stop, minlength=count)
    return np.asarray(np.where(members > 0, total_support / np.maximum(members, 1), support.mean()))
