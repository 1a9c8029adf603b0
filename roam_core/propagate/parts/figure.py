"""An object drawn in parts: each with a motion of its own, nearest first, seen past those that hide it.

The union of the parts is carried by regions, as a whole object is; it tells where the object is, and so where a part is
needed that no other part accounts for. Each part is found by its pose (`motion.pose`), anchored to the key; parts that
overlapped there hold together by springs (`geometry.joints`). An occluder is a part that subtracts: it belongs to
nothing, and hides what lies below it. Behind it, an object that is not in parts goes on being carried by regions.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TypeVar

import cv2
import numpy as np
from numpy.typing import NDArray

from roam_core.arrays import Array, Float32, UInt8
from roam_core.cancel import CancelToken
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.features.pyramid import Pyramid
from roam_core.geometry import bezier, similarity
from roam_core.geometry.joints import Joint, joints
from roam_core.kernels.posing import Ties
from roam_core.matte.vectorise import shapes_from_mask
from roam_core.motion.pose import Pose, Surroundings
from roam_core.params import PoseParams, RegionParams, scale_for
from roam_core.propagate.frame.contour_fit import enclosed
from roam_core.propagate.frame.free_edges import Border, drawn_to
from roam_core.propagate.frame.result import Part, StepResult, Termination
from roam_core.propagate.shapes.objects import Role, Unit
from roam_core.propagate.whole import posed, region
from roam_core.propagate.whole.region import RegionStep
from roam_core.propagate.whole.state import RegionState
from roam_core.propagate.whole.state import begin as begin_whole
from roam_core.roto import BlendMode

T = TypeVar("T")


@dataclass(frozen=True, eq=False)
class Limb:
    """A unit of the object.

    Attributes
    ----------
    unit : which shapes it is made of, and its role. drawn : those as on the key. parts : those as they lie now.
    pose : its pose; None for a whole object, and for a part without a look of its own, hidden on the key or too small.
    whole : the state of a whole object.
    results : what the last frame gave for each shape; empty on the key.
    """

    unit: Unit
    drawn: tuple[Part, ...]
    parts: tuple[Part, ...]
    pose: Pose | None = None
    whole: RegionState | None = None
    results: tuple[StepResult, ...] = ()

    @property
    def is_occluder(self) -> bool:
        return self.unit.role is Role.OCCLUDER

    @cached_property
    def lines(self) -> list[Array]:
        """The outlines of what is solid in it, closed polylines `(K, 2)`."""
        return [bezier.flatten(part.points) for part in self.parts if self.is_occluder or not part.subtracts]

    @cached_property
    def gaps(self) -> list[Array]:
        """The outlines of its holes."""
        return [bezier.flatten(part.points) for part in self.parts if part.subtracts and not self.is_occluder]

    def expected(self, params: PoseParams) -> Array:
        """Where its outlines should lie on the next frame, places `(N, 2)`."""
        if self.pose is None:
            return np.vstack(self.lines)
        chain, values = self.pose.template.chain, self.pose.expected(params)
        return np.vstack([chain.carried(values, bezier.flatten(part.points)) for part in self.drawn])


@dataclass(frozen=True, eq=False)
class FigureState:
    """After a frame: its picture, the limbs bottom first, where they hang together, and the parts as one object."""

    frame: PreparedFrame
    limbs: tuple[Limb, ...]
    joints: tuple[Joint, ...]
    union: RegionState | None
    steps: int = 0

    @property
    def parts(self) -> tuple[Part, ...]:
        """All shapes as they lie now, in their order."""
        return self._in_order([limb.parts for limb in self.limbs])

    @property
    def results(self) -> tuple[StepResult, ...]:
        """What the last frame gave, in the order of the shapes."""
        return self._in_order([limb.results for limb in self.limbs])

    def limb_of(self, shape: int) -> Limb:
        """The limb that a shape, by its index, belongs to."""
        return next(limb for limb in self.limbs if shape in limb.unit.members)

    @property
    def whole(self) -> Limb | None:
        """What is not in parts behind the occluders, where that is one object."""
        wholes = [limb for limb in self.limbs if limb.whole is not None]
        return wholes[0] if len(wholes) == 1 else None

    @property
    def pose_costs(self) -> tuple[float | None, ...]:
        """What the pose of each shape costs, in their order; None where it has none."""
        costs = [None if limb.pose is None else limb.pose.cost for limb in self.limbs]
        return self._in_order([(cost,) * len(limb.unit.members) for limb, cost in zip(self.limbs, costs, strict=True)])

    def _in_order(self, by_limb: Sequence[tuple[T, ...]]) -> tuple[T, ...]:
        pairs = [
            pair
            for limb, values in zip(self.limbs, by_limb, strict=True)
            for pair in zip(limb.unit.members, values, strict=True)
        ]
        return tuple(value for _, value in sorted(pairs, key=lambda pair: pair[0]))


def begin(
    frame: PreparedFrame, parts: Sequence[Part], units: Sequence[Unit], params: RegionParams, order: Sequence[int]
) -> FigureState:
    """The state on a frame whose outlines are given; `order` are the shapes' indices as stacked, bottom first."""
    assert params.part is not None
    scale = scale_for(frame.size)
    limbs = [_drawn(unit, parts) for unit in units]
    learned = tuple(_learned(frame, limbs, k, params, order) for k in range(len(limbs)))
    found = joints([limb.lines[0] for limb in limbs], scale, params.figure.joints)
    held = [joint for joint in found if _holds(joint, limbs)]
    return FigureState(frame, learned, tuple(held), _union(frame, limbs, params))


def corrected(
    state: FigureState, parts: Sequence[Part], params: RegionParams, order: Sequence[int], given: Sequence[bool]
) -> FigureState:
    """The state after a frame on which the artist gave some of the shapes.

    What was given is learned anew; the other limbs stay as they are, with the looks of their own keys.
    """
    fresh = [any(given[k] for k in limb.unit.members) for limb in state.limbs]
    limbs = [_drawn(limb.unit, parts) if new else limb for limb, new in zip(state.limbs, fresh, strict=True)]
    learned = tuple(_learned(state.frame, limbs, k, params, order) if new else limbs[k] for k, new in enumerate(fresh))
    held = tuple(_held_now(joint, state.limbs, fresh) for joint in state.joints)
    return replace(state, limbs=learned, joints=held, union=_union(state.frame, learned, params))


def _held_now(joint: Joint, before: Sequence[Limb], fresh: Sequence[bool]) -> Joint:
    """A joint when some limbs were given anew: on those it lies where their poses had it last."""
    places = joint.places.copy()
    for row, k in enumerate(joint.shapes):
        pose = before[k].pose
        if fresh[k] and pose is not None:
            places[row] = pose.carried(places[row][None])[0]
    return replace(joint, places=places)


def _drawn(unit: Unit, parts: Sequence[Part]) -> Limb:
    drawn = tuple(parts[k] for k in unit.members)
    return Limb(unit, drawn, drawn)


def _learned(frame: PreparedFrame, limbs: Sequence[Limb], k: int, params: RegionParams, order: Sequence[int]) -> Limb:
    """A limb as drawn, with what it looks like where no other covers it."""
    assert params.part is not None
    limb, covers = limbs[k], [line for nearer in _nearer(limbs, k, order) for line in nearer.lines]
    if limb.unit.role is Role.WHOLE:
        return replace(limb, whole=begin_whole(frame, limb.parts, params, covers))
    return replace(limb, pose=posed.learned(frame, limb.lines[0], params.part, [*limb.gaps, *covers]))


def _depth(limb: Limb, order: Sequence[int]) -> int:
    return order.index(limb.unit.members[0])


def _nearer(limbs: Sequence[Limb], k: int, order: Sequence[int]) -> list[Limb]:
    """The limbs that lie before another one."""
    return [limb for limb in limbs if _depth(limb, order) > _depth(limbs[k], order)]


def _holds(joint: Joint, limbs: Sequence[Limb]) -> bool:
    """Whether two limbs that meet hang on each other."""
    return all(limbs[k].unit.role is Role.PART and limbs[k].drawn[0].attached for k in joint.shapes)


def _union(frame: PreparedFrame, limbs: Sequence[Limb], params: RegionParams) -> RegionState | None:
    """What the parts enclose together and nothing hides, as one object; None where that is nothing."""
    solid = [part for limb in limbs if limb.unit.role is Role.PART for part in limb.parts]
    if not solid:
        return None
    spots = np.vstack([bezier.flatten(part.points) for part in solid])
    window = Region.around(spots, params.figure.margin * scale_for(frame.size), frame.size)
    if window.is_empty:
        return None
    hidden = [part for limb in limbs if limb.is_occluder for part in limb.parts]
    grid = Grid.over(window, 1.0)
    covered = np.zeros(grid.shape, np.float32)
    for limb in limbs:
        if limb.unit.role is Role.PART:
            covered = np.maximum(covered, enclosed(limb.parts, grid))
    for part in hidden:
        covered *= 1.0 - enclosed([Part(part.points)], grid)
    outlines = tuple(
        Part(shape.keys[0].points + window.origin, shape.blend is BlendMode.SUBTRACT)
        for shape in shapes_from_mask(covered)
    )
    return begin_whole(frame, outlines, replace(params, pose=None)) if outlines else None


@dataclass(frozen=True, eq=False)
class FigureStep:
    """One step: the `state` after it, and those of what is not in parts, by the shapes that each is made of."""

    state: FigureState
    wholes: Mapping[tuple[int, ...], RegionStep]


def step(
    state: FigureState,
    frame: PreparedFrame,
    params: RegionParams,
    order: Sequence[int],
    token: CancelToken | None = None,
) -> FigureStep:
    """Carry all shapes from the state's frame to `frame`.

    `order` are their indices as they are stacked on `frame`, bottom first.
    """
    assert params.part is not None
    scale, union = scale_for(frame.size), state.union
    if union is not None:
        union = region.step(union, frame, replace(params, pose=None), token).state
    spots = np.vstack([limb.expected(params.part) for limb in state.limbs])
    reach = max((limb.pose.reach(params.part) for limb in state.limbs if limb.pose is not None), default=1.0)
    window = Region.around(spots, (params.figure.margin + params.part.search_move * reach) * scale, frame.size)
    pyramid = None
    if not posed.is_narrow(window, params.part):
        pyramid = Pyramid.of(frame, window, 1.0 / scale, params.part.pyramid)
    solving = _Solving(state, frame, pyramid, union, params, token)
    for k in sorted(range(len(state.limbs)), key=lambda k: -_depth(state.limbs[k], order)):
        if token is not None:
            token.check()
        solving.solve(k)
    limbs = tuple(solving.to_the_edges(k) for k in range(len(state.limbs)))
    return FigureStep(FigureState(frame, limbs, state.joints, union, state.steps + 1), solving.wholes)


class _Solving:
    """The limbs on one frame, as far as they are solved, from the nearest on."""

    def __init__(
        self,
        state: FigureState,
        frame: PreparedFrame,
        pyramid: Pyramid | None,
        union: RegionState | None,
        params: RegionParams,
        token: CancelToken | None,
    ) -> None:
        assert params.part is not None
        self.state, self.frame, self.pyramid, self.token = state, frame, pyramid, token
        self.region_params, self.params, self.scale = params, params.part, scale_for(frame.size)
        self.limbs: dict[int, Limb] = {}
        self.wholes: dict[tuple[int, ...], RegionStep] = {}
        self.outlined: dict[int, UInt8] = {}
        self.hidden: tuple[UInt8, ...] = () if pyramid is None else pyramid.nothing
        self.moved = np.eye(3) if union is None or state.union is None else _moved(state.union, union)
        self.union = union if union is not None and union.trust >= params.figure.trusted else None
        self.needs = None if union is None or pyramid is None else _needs(union, pyramid, params.figure.nats)

    def solve(self, k: int) -> None:
        """Carry limb `k`, all that lie before it being solved."""
        limb = self.state.limbs[k]
        if limb.whole is not None:
            solved = self._as_whole(limb, limb.whole)
        elif limb.pose is None:
            solved = self._along(k)
        else:
            solved = self._as_posed(k, limb.pose)
        self.limbs[k] = solved
        if self.pyramid is None:
            return
        there = self.pyramid.outlined(solved.lines)
        self.outlined[k] = there[0]
        if solved.gaps:
            gaps = self.pyramid.outlined(solved.gaps)
            there = tuple(np.where(gap > 0, 0, fill).astype(np.uint8) for fill, gap in zip(there, gaps, strict=True))
        self.hidden = tuple(np.maximum(*each) for each in zip(self.hidden, there, strict=True))
        if self.needs is not None and not limb.is_occluder:
            self.needs = np.asarray(self.needs * (1.0 - there[0]), dtype=np.float32)

    def to_the_edges(self, k: int) -> Limb:
        """Limb `k`, all being solved, with its free edges where the object's region ends."""
        limb = self.limbs[k]
        if self.union is None or self.pyramid is None or limb.pose is None or limb.unit.role is not Role.PART:
            return limb
        covered = (self.covering - self.outlined[k] > 0).astype(np.uint8)
        solid, *holes = limb.parts
        points = drawn_to(self.border, solid.points, covered)
        result, *rest = limb.results
        return replace(
            limb, parts=(replace(solid, points=points), *holes), results=(replace(result, points=points), *rest)
        )

    @cached_property
    def covering(self) -> NDArray[np.uint16]:
        """How many limbs cover each cell of the finest level."""
        return np.asarray(np.sum(list(self.outlined.values()), axis=0, dtype=np.uint16))

    @cached_property
    def border(self) -> Border:
        """Where the region of the parts ends."""
        assert self.union is not None
        assert self.pyramid is not None
        return Border(self.union.region, self.pyramid.grid, self.scale, self.region_params.figure.free_edges)

    def _as_whole(self, limb: Limb, before: RegionState) -> Limb:
        covers = [line for nearer in self.limbs.values() for line in nearer.lines]
        stepped = region.step(before, self.frame, self.region_params, self.token, covers)
        self.wholes[limb.unit.members] = stepped
        parts = tuple(replace(part, points=each.points) for part, each in zip(limb.drawn, stepped.results, strict=True))
        return replace(limb, parts=parts, whole=stepped.state, results=stepped.results)

    def _as_posed(self, k: int, before: Pose) -> Limb:
        limb = self.state.limbs[k]
        if self.pyramid is None:
            return self._out_of_sight(limb, before.missed())
        pose = before.step(Surroundings(self.pyramid, self.hidden, self._needs_of(k), self._ties(k)), self.params)
        parts = posed.carried(pose, limb.drawn)
        if self._has_left(parts):
            return self._out_of_sight(replace(limb, parts=parts), pose)
        results = posed.results(pose, parts, self.region_params.confidence)
        return replace(limb, parts=parts, pose=pose, results=results)

    def _has_left(self, parts: Sequence[Part]) -> bool:
        return Region.around(np.vstack([part.points.reshape(-1, 2) for part in parts]), 0.0, self.frame.size).is_empty

    def _out_of_sight(self, limb: Limb, pose: Pose) -> Limb:
        """A limb that has left the picture: carried all the same, without confidence."""
        results = tuple(
            StepResult(part.points, 0.0, np.zeros(len(part.points)), {}, Termination.LEFT_FRAME) for part in limb.parts
        )
        return replace(limb, pose=pose, results=results)

    def _along(self, k: int) -> Limb:
        """A part without a look of its own: it goes with one that it hangs on, else with the object."""
        limb = self.state.limbs[k]
        hosts = [self.limbs[j].pose for j in self._neighbours(k) if j in self.limbs]
        host = next((pose for pose in hosts if pose is not None), None)
        if host is not None:
            parts = posed.carried(host, limb.drawn)
        else:
            parts = tuple(replace(part, points=similarity.apply(self.moved[:2], part.points)) for part in limb.parts)
        blind = self.region_params.figure.blind
        results = tuple(
            StepResult(part.points, blind, np.full(len(part.points), blind), {}, Termination.of(blind))
            for part in parts
        )
        return replace(limb, parts=parts, results=results)

    def _neighbours(self, k: int) -> list[int]:
        """The limbs that a limb hangs on."""
        return [other for joint in self.state.joints if (other := joint.other(k)) is not None]

    def _needs_of(self, k: int) -> tuple[Float32, ...] | None:
        if self.needs is None or self.pyramid is None or self.state.limbs[k].is_occluder:
            return None
        finest = cv2.GaussianBlur(self.needs, (0, 0), self.region_params.figure.smooth)
        sizes = [level.shape[1::-1] for level in self.pyramid.levels[1:]]
        coarser = [cv2.resize(finest, size, interpolation=cv2.INTER_AREA) for size in sizes]
        return (np.asarray(finest), *(np.asarray(each) for each in coarser))

    def _ties(self, k: int) -> Ties | None:
        """The springs to the limbs that are solved by now; one to a limb that is in doubt is weak."""
        pose = self.state.limbs[k].pose
        assert pose is not None
        places, targets, weights = [], [], []
        for joint in self.state.joints:
            other = joint.other(k)
            to = None if other is None or other not in self.limbs else self.limbs[other].pose
            if to is None:
                continue
            assert other is not None
            places.append(joint.place_on(k))
            targets.append(to.carried(joint.place_on(other)[None])[0])
            weights.append(self.params.tie * max(0.0, 1.0 - to.cost))
        if not places:
            return None
        at, reach = np.array(places), self.params.tie_reach * self.scale
        return Ties(at, pose.template.chain.skin(at), np.array(targets), np.array(weights), reach)


def _moved(before: RegionState, after: RegionState) -> Array:
    """The similarity `(3, 3)` by which the object went from one frame to the next."""
    return np.asarray(after.key.to_now @ np.linalg.inv(before.key.to_now))


def _needs(union: RegionState, pyramid: Pyramid, odds: float) -> Float32:
    """For each cell of the finest level, in [0, 1], whether the object is there; `odds` nats change them by e."""
    rows, columns = pyramid.levels[0].shape[:2]
    nats = union.region.nats_on(pyramid.grid)
    inside = (1.0 / (1.0 + np.exp(-np.clip(nats / odds, -4.0, 4.0)))).astype(np.float32)
    below, right = rows - pyramid.grid.rows, columns - pyramid.grid.columns
    return np.asarray(cv2.copyMakeBorder(inside, 0, below, 0, right, cv2.BORDER_REPLICATE))
