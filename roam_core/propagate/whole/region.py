"""One frame by regions: evidence around the whole object, the proposed region, every shape's curve fitted to it.

The paper lets a segmentation propose drastic changes where it and the curve differ markedly. Here it proposes on every
frame: all shapes that are tracked together are one object; its region is carried, the curves follow its outlines.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np

from roam_core.appearance.global_model import GlobalModel
from roam_core.appearance.texture_model import TextureModel
from roam_core.arrays import Array, Float32
from roam_core.cancel import CancelToken
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.geometry import bezier, similarity
from roam_core.motion.pose import Pose
from roam_core.params import RegionParams, scale_for
from roam_core.propagate.frame.confidence import (
    ConfidenceFeatures,
    PoseFeatures,
    edge_support,
    expected_overlap,
    overlap,
    vertex_confidence,
)
from roam_core.propagate.frame.contour_fit import enclosed, fitted, trusts_of
from roam_core.propagate.frame.covering import carried_behind, covered, learned_colours, sure_sides
from roam_core.propagate.frame.redetection import LastSeen, as_on_key, is_better
from roam_core.propagate.frame.result import Part, StepResult, Termination
from roam_core.propagate.whole import patched, posed
from roam_core.propagate.whole.interest import grid_around
from roam_core.propagate.whole.observation import Observation, behind, observed
from roam_core.propagate.whole.rigid import PlanePose
from roam_core.propagate.whole.state import RegionState
from roam_core.proposal.cues.evidence import SURE, Field, KeyMemory, gathered
from roam_core.proposal.cues.key_view import lab
from roam_core.proposal.segment import region as proposed


@dataclass(frozen=True, eq=False)
class RegionStep:
    """One step.

    Attributes
    ----------
    begun : the state that it set out from; where the object is `redetected`, it lies there as on its key. state,
        results : what came of it. observation : what was seen before; None where the object has left the picture.
    """

    begun: RegionState
    state: RegionState
    results: tuple[StepResult, ...]
    observation: Observation | None
    redetected: bool = False


def step(
    state: RegionState,
    frame: PreparedFrame,
    params: RegionParams,
    token: CancelToken | None = None,
    covers: Sequence[Array] = (),
) -> RegionStep:
    """Carry all shapes from the state's frame to `frame`, on which `covers`, closed polylines, lie before them.

    Where that leaves the object lost or in doubt it is looked for around its last place, as it was on the key, and
    taken from there if that promises more. If it is not found, and what is left is something else, that is let go.
    An object that was out of sight is taken from where its keypoints are known again, if that promises anything.
    """
    frame = state.key.in_its_light(frame)
    if state.pose is not None and params.pose is not None:
        state = replace(state, pose=posed.step(state.pose, state.drawn, state.frame, frame, params, covers))
    carried = _carried(state, frame, params, token, tuple(covers))
    is_returning = carried.state.last_seen.returning > 0
    if not is_returning and not _is_doubted(carried.state, params):
        return carried

    def carried_from(found: RegionState) -> RegionStep:
        around = carried.state.key.surroundings
        return replace(_carried(found, frame, params, token, tuple(covers), around), redetected=True)

    known = _known_again(state, carried.state, frame, params) if is_returning else None
    if known is not None:
        again = carried_from(known)
        if again.state.trust > params.believed and not _is_background(again, params):
            return again
    if not _is_doubted(carried.state, params):
        return carried
    found = _as_last_seen(state, carried.state, frame, params)
    if found is not None:
        again = carried_from(found)
        if _is_taken(again, carried.state, params):
            return again
    observation = carried.observation
    if observation is None or not _is_gone(carried.state, observation, params):
        return carried
    grid = observation.sources.grid
    nothing = Field.of_coverage(grid, np.zeros(grid.shape, np.float32))
    return _along(replace(state, covers=tuple(covers)), observation, nothing, params)


def _is_taken(again: RegionStep, carried: RegionState, params: RegionParams) -> bool:
    """Whether what was found elsewhere is taken in place of what was `carried` on.

    Neither promises more than it looks alike. But light that is not told speaks against what is right, too: by itself
    what was found has to promise hardly less.
    """
    trust, compared = again.state.trust, min(_promise(again.state, carried), again.state.resemblance)
    if trust <= carried.trust - params.better or _is_background(again, params):
        return False
    return is_better(trust, compared, min(carried.trust, carried.resemblance), params)


def _is_background(stepped: RegionStep, params: RegionParams) -> bool:
    """Whether most of the region is background that looks as on the key: something that is like the object."""
    seen, inside = stepped.observation, stepped.state.region.inside
    if params.background is None or seen is None or seen.sources.background is None or not inside.any():
        return False
    unchanged = seen.sources.background.unchanged(lab(seen.sources.after), params.background)
    return bool(unchanged[inside].mean() > 0.5)


def _is_gone(state: RegionState, observation: Observation, params: RegionParams) -> bool:
    """Whether nothing of the object is in sight, and what is left of its region is something else.

    Where next to nothing is to be expected of it; or where it is not believed, and the key, carried, lies elsewhere.
    What may be a limb, behind something that was not drawn, is still there.
    """
    if state.features is None or state.is_posed or (state.pose is not None and posed.is_small(state.pose, params)):
        return False
    if expected_overlap(state.features, params=params.confidence) < params.hopeless:
        return True
    return state.trust < params.believed and not (observation.sources.expected.remembered > 0.5).any()


def _is_doubted(state: RegionState, params: RegionParams) -> bool:
    """Whether so little is to be expected of a frame that the object is looked for on it by its colours.

    So is one of too little resemblance, and one that has come back of late: what is seen of it need not be all. A
    limb that is held to its pose soon has lookalikes: only where less is to be expected of it. What its colours do not
    tell from its surroundings has them everywhere: only where nothing is left of it.
    """
    if state.last_seen.returning > 0 and state.is_told_by_colours:
        return True
    bound = params.doubted
    if state.resemblance < bound:
        return True
    if state.trust < bound and not state.appearance.is_distinct:
        bound = min(bound, params.hopeless)
    elif state.trust < bound and state.is_posed:
        bound *= params.redetection.posed
    return state.trust < bound


def _promise(again: RegionState, carried: RegionState) -> float:
    """The trust in a state that was looked for, to be compared with that in the one that was carried on."""
    ours, theirs = again.features, carried.features
    if carried.trust > 0.0 and isinstance(ours, ConfidenceFeatures) and isinstance(theirs, ConfidenceFeatures):
        again = replace(again, features=ours.over_the_key_as(theirs))
    return again.trust


def _as_last_seen(
    state: RegionState, carried: RegionState, frame: PreparedFrame, params: RegionParams
) -> RegionState | None:
    """As if, the frame before, the object had lain as on the key where it is seen on `frame`.

    `carried` is what came of carrying it there. What was held to its pose is looked for without it, and only if its
    colours tell it from its surroundings: those of a limb, where it hangs on, do not.
    """
    if not carried.last_seen.is_worth_a_look or (carried.is_posed and not state.appearance.is_distinct):
        return None
    key_behind = behind(carried.key, frame, params)
    to_now = state.appearance.found(frame, carried.last_seen, key_behind, carried.key.surroundings)
    if to_now is None:
        return None
    return _as_on_key_at(to_now, state, carried, frame, params)


def _known_again(
    state: RegionState, carried: RegionState, frame: PreparedFrame, params: RegionParams
) -> RegionState | None:
    """As if, the frame before, the object had lain as on the key where its keypoints are known again on `frame`."""
    if not carried.last_seen.is_worth_a_look or carried.is_posed:
        return None
    to_now = state.appearance.found_by_keypoints(frame, carried.last_seen)
    return None if to_now is None else _as_on_key_at(to_now, state, carried, frame, params)


def _as_on_key_at(
    to_now: Array, state: RegionState, carried: RegionState, frame: PreparedFrame, params: RegionParams
) -> RegionState:
    """As if, the frame before, the object had lain as on the key where `to_now (3, 3)` puts it."""
    picture = as_on_key(state.key.frame, to_now)
    parts = tuple(replace(part, points=similarity.apply(to_now[:2], part.points)) for part in state.drawn)
    spots = np.vstack([part.points.reshape(-1, 2) for part in parts])
    grid = grid_around(spots, frame.size, params, scale_for(frame.size))
    region = Field.of_coverage(grid, state.key.region.on(grid, to_now))
    key = replace(state.key, to_now=to_now)
    rigidity = state.rigidity.at(to_now)
    return replace(
        state,
        frame=picture,
        region=region,
        parts=parts,
        key=key,
        colours=key.colours,
        texture=None if state.texture is None else state.texture.as_on_key(),
        rigidity=rigidity,
        flow_reliability=np.zeros(grid.shape, np.float32),  # it lies there roughly
        pose=None if carried.is_posed else state.pose,
        patch_motion=None if state.patches is None else state.patches.carried(to_now, params.believed),
    )


def _carried(
    state: RegionState,
    frame: PreparedFrame,
    params: RegionParams,
    token: CancelToken | None,
    covers: tuple[Array, ...],
    surroundings: Array | None = None,
) -> RegionStep:
    """All shapes carried on from where the state has them: as one piece where that is to be seen, else by regions.

    The pose is that of `frame` already; so is the motion of the key's `surroundings (3, 3)` where it is given.
    """
    observation = observed(state, frame, params, token, surroundings)
    if observation is None:
        return _left(state, frame)
    if token is not None:
        token.check()
    state = replace(state, covers=covers)
    if observation.plane_pose is not None:
        return _as_one_piece(state, observation, observation.plane_pose, params)
    ratio = evidence(observation, params, covers)
    if token is not None:
        token.check()
    found = proposed.cleaned(ratio, observation.sources.expected.possible, params.overlap, params.components.speck)
    if state.pose is not None:
        parts = posed.carried(state.pose, state.drawn)
        if _is_opened(state, state.pose, frame.size):
            found = posed.continued(state.pose, parts, found, state.key.frame.size, params)
        elif posed.is_believed(state.pose, parts, found, params, state.is_posed):
            return _as_posed(state, observation, state.pose, parts, params)
    return _along(state, observation, found, params)


def _is_opened(state: RegionState, pose: Pose, size: tuple[int, int]) -> bool:
    """True where, by its pose, more of the object has come into the picture than the key knows of."""
    return state.rigidity.cut_off.is_in_sight(pose.carried, size)


def _along(state: RegionState, observation: Observation, found: Field, params: RegionParams) -> RegionStep:
    """The shapes laid along the region that was found."""
    expected, scale = observation.sources.expected, scale_for(observation.frame.size)
    parts = tuple(replace(part, points=similarity.apply(observation.moved[:2], part.points)) for part in state.parts)
    shapes = zip(parts, state.drawn, state.constraints, strict=True)
    to_now, patches = observation.sources.key.to_now, (state.patches, observation.patch_motion)
    expected_points = [patched.expected_points(*shape, to_now, *patches, params, scale) for shape in shapes]
    placed = fitted(parts, state.constraints, found, scale, params, expected_points, expected.likely)
    outlines = [replace(part, points=points) for part, (points, _) in zip(parts, placed, strict=True)]
    flow_reliability = _flow_reliability(observation, found)
    features = ConfidenceFeatures.of(outlines, found, expected, state.steps + 1, params.confidence)
    confidence = expected_overlap(features, params=params.confidence)
    seen = [seen for _, seen in placed]
    trusts = trusts_of(state.drawn, seen, confidence)
    results = tuple(result(*each, found, params) for each in zip(outlines, seen, trusts, strict=True))
    parts = tuple(
        replace(part, points=points) if seen else part for part, (points, seen) in zip(parts, placed, strict=True)
    )
    return _held_while_steady(
        _after(state, observation, found, flow_reliability, parts, features, results, params), params
    )


def evidence(observation: Observation, params: RegionParams, covers: Sequence[Array]) -> Field:
    """What all cues say together, behind what covers the object that it stays as it is."""
    return carried_behind(gathered(observation.sources, params), covers, observation.sources.expected)


def _as_one_piece(state: RegionState, observation: Observation, pose: PlanePose, params: RegionParams) -> RegionStep:
    """The shapes as drawn on the key, carried by the motion of a plane."""
    grid, parts = observation.sources.grid, pose.carried(state.drawn)
    found = Field.of_coverage(grid, enclosed(parts, grid))
    features = pose.features(found.inside, state.steps + 1)
    confidence = expected_overlap(features, params=params.confidence)
    energy = {"rigid": features.disagreeing, "total": features.disagreeing}
    results = tuple(
        StepResult(
            points=part.points,
            confidence=confidence,
            vertex_confidence=vertex_confidence(pose.support(drawn), confidence, params.confidence),
            energies=energy,
            termination=Termination.of(confidence),
        )
        for part, drawn in zip(parts, state.drawn, strict=True)
    )
    flow_reliability = _flow_reliability(observation, found)
    return _after(state, observation, found, flow_reliability, parts, features, results, params)


def _as_posed(
    state: RegionState,
    observation: Observation,
    pose: Pose,
    parts: tuple[Part, ...],
    params: RegionParams,
) -> RegionStep:
    """The shapes as drawn on the key, under their pose."""
    found = Field.of_coverage(observation.sources.grid, enclosed(parts, observation.sources.grid))
    features, results = PoseFeatures.of(pose), posed.results(pose, parts, params.confidence)
    flow_reliability = _flow_reliability(observation, found)
    return _after(state, observation, found, flow_reliability, parts, features, results, params)


def _held_while_steady(stepped: RegionStep, params: RegionParams) -> RegionStep:
    """A large shape lies by its pose while it has looked as on its key on all frames, its free edges at the region.

    Behind that the region goes on with points of its own: once the pose no longer holds they lie as if it never had.
    Then the pose is looked for no more, but for a fill while anything looks clearly as on the key.
    """
    state, pose, found = stepped.state, stepped.state.pose, stepped.state.region
    if pose is None or posed.is_small(pose, params):
        return stepped
    is_steady = state.is_steady and posed.is_steady(pose, params) and not _is_opened(state, pose, state.frame.size)
    if not is_steady or not patched.go_with(pose, state.patches, state.patch_motion, params):
        kept = pose if params.pose_kept and posed.is_clear(pose, params) else None
        return replace(stepped, state=replace(state, is_steady=False, pose=kept))
    parts = posed.carried(pose, stepped.begun.drawn)
    parts = posed.at_the_edges(parts, found, scale_for(stepped.state.frame.size), params.figure.free_edges)
    state = replace(stepped.state, features=PoseFeatures.of(pose))
    return replace(stepped, state=state, results=posed.results(pose, parts, params.confidence))


def _adapted(
    state: RegionState, observation: Observation, found: Field, params: RegionParams
) -> tuple[GlobalModel, TextureModel | None]:
    """The global colours and the textures after a frame on which `found` is the object's region."""
    sources, rate = observation.sources, params.adaptation
    steadiness = overlap(sources.expected.rigid, found.inside) * (0.5 + 0.5 * observation.agreement)
    if steadiness <= params.trusted or not found.inside.any():
        return state.colours, state.texture
    colours = state.colours.adapted(learned_colours(sources.after, found, state.covers), rate)
    if state.texture is None:
        return colours, None
    return colours, state.texture.adapted(sources.texture_around, *sure_sides(found, state.covers), rate)


def _after(
    state: RegionState,
    observation: Observation,
    found: Field,
    flow_reliability: Float32,
    parts: tuple[Part, ...],
    features: ConfidenceFeatures | PoseFeatures,
    results: tuple[StepResult, ...],
    params: RegionParams,
) -> RegionStep:
    """The step to a frame on which `found` is the object's region and `parts` are its shapes."""
    colours, texture = _adapted(state, observation, found, params)
    key = observation.sources.key
    if observation.plane_pose is not None:
        key = replace(key, to_now=observation.plane_pose.similarity)
    after = replace(
        state,
        frame=observation.frame,
        region=found,
        parts=parts,
        key=key,
        colours=colours,
        texture=texture,
        last_seen=_seen(state, key, found),
        rigidity=observation.rigidity,
        flow_reliability=flow_reliability,
        steps=state.steps + 1,
        features=features,
        patch_motion=patched.judged(state.patches, observation.patch_motion, found),
    )
    return RegionStep(state, replace(after, key=_grown(after, observation, params)), results, observation)


def _grown(state: RegionState, observation: Observation, params: RegionParams) -> KeyMemory:
    """The key with what has come into sight on a frame that is not in doubt, if around the object enough is new."""
    sources, key, asked = observation.sources, state.key, params.background
    if asked is None or sources.background is None or state.trust < params.doubted:
        return key
    outside = ~(sources.band | sources.expected.possible | state.region.inside)
    new = np.count_nonzero(outside & sources.background.new)
    if len(key.later) == asked.views or new <= asked.new * np.count_nonzero(outside):
        return key
    height, width = state.frame.size
    fine = Grid.over(Region(0, 0, width, height), 1.0 / scale_for(state.frame.size))
    reach = round(asked.apart * float((fine.factor / sources.grid.factor).max()))
    near = cv2.dilate(state.region.on(fine), np.ones((2 * reach + 1, 2 * reach + 1), np.uint8)) > 0
    hidden = covered(state.covers, fine)
    return key.with_view(fine, state.frame, ~near if hidden is None else ~(near | hidden))


def _seen(state: RegionState, key: KeyMemory, found: Field) -> LastSeen:
    """What the frame on which `found` is the region says about where the object is."""
    before = state.last_seen
    return before.missed() if before.is_lost(found) else before.after(key, found)


def _flow_reliability(observation: Observation, found: Field) -> Float32:
    """How far each cell's side still is the key's word, once `found` was decided."""
    lines = observation.sources.label_propagation
    return np.ones(found.grid.shape, np.float32) if lines is None else lines.after(found.inside)


def result(part: Part, seen: bool, trust: float, found: Field, params: RegionParams) -> StepResult:
    """What an outline along the region that was `found` gives, if it is trusted so far; where it is not `seen` no point
    is.
    """
    anchors = part.points[:, bezier.ANCHOR]
    vertices = np.zeros(len(anchors))
    if seen:
        vertices = vertex_confidence(edge_support(anchors, found, params.confidence), trust, params.confidence)
    energy = -float(np.abs(np.clip(found.values, -SURE, SURE)).mean())
    return StepResult(
        points=part.points,
        confidence=trust,
        vertex_confidence=vertices,
        energies={"region": energy, "total": energy},
        termination=Termination.of(trust),
    )


def _left(state: RegionState, frame: PreparedFrame) -> RegionStep:
    """Nothing of the object is in the picture: the shapes rest where they left it, and say so."""
    results = tuple(
        StepResult(part.points, 0.0, np.zeros(len(part.points)), {}, Termination.LEFT_FRAME) for part in state.parts
    )
    missed = state.last_seen.missed()
    after = replace(state, frame=frame, last_seen=missed, steps=state.steps + 1, features=None)
    return RegionStep(state, after, results, None)
