"""Why a curve lies where it lies on a frame: what each term or cue says at its nodes and landmarks."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from roam_core.cancel import CancelToken
from roam_core.energy.shares import curve_shares, joint_shares
from roam_core.errors import RoamError
from roam_core.features import PreparedFrame
from roam_core.features.grid import Grid
from roam_core.geometry import polyline
from roam_core.media.source import MissingFrame
from roam_core.motion.pose import Pose
from roam_core.params import RoamParams, scale_for
from roam_core.propagate import engine, provenance, region
from roam_core.propagate import step as outline
from roam_core.propagate.confidence import PoseSigns
from roam_core.propagate.edges import Edges, edges, edges_on_key
from roam_core.propagate.engine import State
from roam_core.propagate.figure import FigureState
from roam_core.propagate.group import GroupTracker
from roam_core.propagate.memory import ReadPicture, solve_again
from roam_core.propagate.nodes import NodeMap
from roam_core.propagate.objects import stacked
from roam_core.propagate.prewarp import expected
from roam_core.propagate.provenance import Stamp, Stamps
from roam_core.propagate.region import RegionState
from roam_core.propagate.step import TrackerState
from roam_core.proposal.evidence import cues
from roam_core.proposal.region import cleaned
from roam_core.roto import BlendMode, Clip, Keyframe, Origin, RotoShape

Array = NDArray[np.float64]
Float32 = NDArray[np.float32]
Terms = Mapping[str, Array]

REGION = "region"
"""The cues together, smoothed and cleaned: what the curves of `best` were laid along. No cue, and not in any sum."""

POSE = "pose"
"""How unlike its key a part looks around a node, in [0, 1]."""

BESIDE = 2.0
"""Cells from the outline to the places inside and outside of it where the cues are asked."""


@dataclass(frozen=True, eq=False)
class LandmarkPieces:
    """What landmarks have of the energy: `ids (M,)`, `positions (M, 2)` in pixels, weighted `terms` of `(M,)` each."""

    ids: NDArray[np.intp]
    positions: Array
    terms: Terms


@dataclass(frozen=True, eq=False)
class Explanation:
    """One shape's key on one frame, taken apart.

    Attributes
    ----------
    shape, key : the shape, and its key on the frame.
    config : the configuration that made the key; "" for the artist's.
    nodes : (N, 2) on the outline, pixels; `segment`, `t` : (N,) where on the spline.
    terms : (N,) each. Energies by term, of which less is better; of the regions' cues how much more they speak, in
        nats, for the object on its side of the outline than on the other, of which more is better. Empty for an
        artist's key and where the shape has left the picture.
    sides : the cues just inside and just outside the outline, nats for the object, `(N,)` each; empty for energies.
    landmarks : the landmarks' pieces, where the configuration has any.
    apart : how far, in pixels, the key's control points lie from those that the run to this frame finds; 0 unless the
        key was filled from both sides, its shapes were tracked in other company, or on a machine that rounds otherwise.
    as_one_piece : where the object was carried as one piece, whatever its cues said, the share of the artist's key's
        corners that were found where its motion puts them; else None.
    edges : where its outline is free, a seam or hidden; None where the shape is not there.
    on_key : the frame of the artist's key that it goes back to, and the same samples there; None without one.
    """

    shape: RotoShape
    key: Keyframe
    config: str
    nodes: Array
    segment: NDArray[np.intp]
    t: Array
    terms: Terms = field(default_factory=dict)
    sides: Mapping[str, tuple[Array, Array]] = field(default_factory=dict)
    landmarks: LandmarkPieces | None = None
    apart: float = 0.0
    as_one_piece: float | None = None
    edges: Edges | None = None
    on_key: tuple[int, Edges] | None = None

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


@dataclass(frozen=True)
class _Run:
    """The run that a key came from: its configuration, direction, where it began, and the shapes that it solved."""

    config: str
    forward: bool
    begun: int
    members: tuple[int, ...]


def explain(
    read: ReadPicture,
    shapes: Sequence[RotoShape],
    frame: int,
    clip: Clip | None,
    token: CancelToken | None = None,
    only: Collection[str] | None = None,
) -> list[Explanation]:
    """Take apart the keys that closed `shapes`, all of a project, hold on `frame`; those without a key are left out.

    What the engine knew when it came to the frame is worked out anew from the artist's keys, as in
    `propagate.memory.take_up`, for all shapes that it solved together. A frame that was filled from both sides is
    explained by the run from the nearer of its artist keys. `only` are the ids of those that are asked for.

    Raises
    ------
    RoamError
        for a key that is out of date, and for one that no configuration of this program made.
    Cancelled
        at a safe point after `token` was cancelled.
    """
    found: dict[int, Explanation] = {}
    runs: dict[_Run, list[int]] = {}
    stamps = Stamps.of(shapes, clip)
    for index, shape in enumerate(shapes):
        key = shape.key_at(frame)
        if key is None or not shape.closed or (only is not None and shape.id not in only):
            continue
        if key.origin is Origin.ARTIST:
            found[index] = _bare(shape, key, RoamParams(), "", 1.0)
        else:
            runs.setdefault(_run_of(stamps, index, key), []).append(index)
    for run, asked in runs.items():
        found.update(_explained(read, stamps, asked, frame, run, token))
    return _with_edges(read, shapes, frame, [found[index] for index in sorted(found)])


def _with_edges(
    read: ReadPicture, shapes: Sequence[RotoShape], frame: int, found: Sequence[Explanation]
) -> list[Explanation]:
    """The explanations with the kinds of edge of their shapes; on the key where that has a picture."""
    if not found:
        return []
    now = edges(read(frame), shapes, frame, {each.shape.id for each in found})
    try:
        keyed = edges_on_key(read, shapes, frame, now)
    except MissingFrame:
        keyed = {}
    return [replace(each, edges=now.get(each.shape.id), on_key=keyed.get(each.shape.id)) for each in found]


def _run_of(stamps: Stamps, k: int, key: Keyframe) -> _Run:
    made, shape = Stamp.read(key.inputs), stamps.shapes[k]
    if provenance.known_params(made.config) is None:
        raise RoamError(
            f"The key of {shape.name!r} on frame {key.frame} does not say which configuration made it; track it again."
        )
    if stamps.is_stale(shape, key):
        raise RoamError(
            f"The key of {shape.name!r} on frame {key.frame} is out of date: the artist's key, the clip or the "
            "parameters have changed since. Track it again first."
        )
    assert made.begun is not None
    if made.gap is None:
        members = stamps.solved_with(k, made.begun, made.forward, made.alone)
        return _Run(made.config, made.forward, made.begun, members)
    first, last = made.gap
    ends = [frame for frame in made.gap if frame in shape.artist_frames]
    begun = min(ends, key=lambda frame: (abs(frame - key.frame), frame))
    together = stamps.filled_with(k, (first, last), made.alone)
    members = tuple(j for j in together if begun in stamps.shapes[j].artist_frames)
    return _Run(made.config, begun == first, begun, members)


def _explained(
    read: ReadPicture, stamps: Stamps, asked: Sequence[int], frame: int, run: _Run, token: CancelToken | None
) -> dict[int, Explanation]:
    """The keys of the shapes asked for, all of one run."""
    tracker, together = GroupTracker(run.config), [stamps.shapes[k] for k in run.members]
    solve_again(tracker, read, together, range(run.begun, frame, 1 if run.forward else -1), token)
    state, picture, order = tracker.standing.state, read(frame), stacked(together, frame)
    taken = _taken_apart(state, picture, together, frame, tracker.params, order, token)
    return {k: each for k, each in zip(run.members, taken, strict=True) if k in asked and each is not None}


def _taken_apart(
    state: State,
    picture: PreparedFrame,
    shapes: list[RotoShape],
    frame: int,
    params: RoamParams,
    order: Sequence[int],
    token: CancelToken | None,
) -> list[Explanation | None]:
    """Every shape of an object on `frame`, seen from the `state` on the frame before; None for one without a key."""
    after, solved = engine.step(state, picture, params, token, order)
    scale = scale_for(picture.size)
    result: list[Explanation | None] = []
    for index, (shape, came) in enumerate(zip(shapes, solved, strict=True)):
        key = shape.key_at(frame)
        if key is None:
            result.append(None)
            continue
        bare = replace(
            _bare(shape, key, params, params.config, scale), apart=float(np.hypot(*(key.points - came.points).T).max())
        )
        if isinstance(state, FigureState) and isinstance(after, FigureState):
            before, limb = state.limb_of(index).whole, after.limb_of(index)
            if before is None or limb.whole is None:
                result.append(_by_pose(bare, limb.pose))
            else:
                result.append(_by_region(bare, before, limb.whole, picture, params))
        elif isinstance(state, RegionState) and isinstance(after, RegionState):
            result.append(_by_region(bare, state, after, picture, params))
        elif isinstance(state, tuple):
            result.append(_by_energy(bare, state[index], picture, params))
    return result


def _by_region(
    bare: Explanation, before: RegionState, after: RegionState, picture: PreparedFrame, params: RoamParams
) -> Explanation:
    """By the pose where that laid the outline, else by the cues."""
    if isinstance(after.signs, PoseSigns):
        return _by_pose(bare, after.pose)
    return _by_cues(replace(bare, as_one_piece=after.agreement_as_one_piece), before, picture, params, after.covers)


def _by_pose(bare: Explanation, pose: Pose | None) -> Explanation:
    """How unlike its key a part looks around each node, in [0, 1]."""
    return bare if pose is None else replace(bare, terms={POSE: 1.0 - pose.support(bare.nodes)})


def _bare(shape: RotoShape, key: Keyframe, params: RoamParams, config: str, scale: float) -> Explanation:
    nodes = NodeMap.of(key.points, params, scale)
    return Explanation(shape, key, config, nodes.nodes(key.points), nodes.segment, nodes.t)


def _by_energy(bare: Explanation, state: TrackerState, picture: PreparedFrame, params: RoamParams) -> Explanation:
    """The pieces of the joint energy at the nodes that inference moved."""
    state, _ = outline.carried_on(state, picture, params)
    nodes = state.nodes.nodes(bare.key.points)
    bare = replace(bare, nodes=nodes, segment=state.nodes.segment, t=state.nodes.t)
    moved, prior = expected(state.frame, picture, state.points, state.landmarks, params)
    sight = outline.sighted(state, picture, moved, prior, params)
    if sight is None:
        return bare
    terms = dict(curve_shares(nodes, sight.curve, params))
    placing = outline.solved(sight, params, scale_for(picture.size)).placing
    if sight.landmarks is None or placing is None or params.landmarks is None or state.landmarks is None:
        return replace(bare, terms=terms)
    at_nodes, at_landmarks = joint_shares(nodes, placing, sight.landmarks, params.landmarks)
    found = LandmarkPieces(state.landmarks.pool.ids, placing.star(sight.landmarks).leaves, at_landmarks)
    return replace(bare, terms=terms | dict(at_nodes), landmarks=found)


def _by_cues(
    bare: Explanation, state: RegionState, picture: PreparedFrame, params: RoamParams, covers: Sequence[Array]
) -> Explanation:
    """What each cue says on the two sides of the outline; `covers` lie before the object."""
    assert params.region is not None
    state, _ = region.carried_on(state, picture, params.region, covers=covers)
    sight = region.sighted(state, picture, params.region)
    if sight is None:
        return bare
    sources = sight.sources
    beside = _both_sides(bare.nodes, sources.grid)
    sides = {name: beside(values) for name, values in cues(sources, params.region)}
    smoothed = cleaned(region.evidence(sight, params.region, covers), sources.expected.possible, params.region.overlap)
    sides[REGION] = beside(smoothed.values)
    # Inside a hole there is no object.
    sign = -1.0 if bare.shape.blend is BlendMode.SUBTRACT else 1.0
    terms = {name: sign * (inside - outside) for name, (inside, outside) in sides.items()}
    return replace(bare, terms=terms, sides=sides)


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


def _total(terms: Terms, count: int) -> Array:
    return np.asarray(sum((values for name, values in terms.items() if name != REGION), np.zeros(count)))
