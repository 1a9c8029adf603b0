"""One frame of an object drawn in parts: its limbs solved one by one, the nearest first, then held together."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import takewhile

import cv2
import numpy as np
from numpy.typing import NDArray

from roam_core.arrays import Array, Float32, UInt8
from roam_core.cancel import CancelToken
from roam_core.features import PreparedFrame, Region
from roam_core.features.pyramid import Pyramid
from roam_core.geometry import similarity
from roam_core.kernels.posing import Ties
from roam_core.motion.pose import Pose, Surroundings
from roam_core.params import RegionParams, scale_for
from roam_core.propagate.frame.confidence import overlap
from roam_core.propagate.frame.contour_fit import enclosed
from roam_core.propagate.frame.covering import covered
from roam_core.propagate.frame.free_edges import Border, drawn_to
from roam_core.propagate.frame.result import Part, StepResult, Termination
from roam_core.propagate.parts.along import UnionMotion
from roam_core.propagate.parts.figure import FigureState, Limb, depth
from roam_core.propagate.shapes.objects import Role
from roam_core.propagate.whole import posed, region
from roam_core.propagate.whole.region import RegionStep
from roam_core.propagate.whole.state import RegionState


@dataclass(frozen=True, eq=False)
class FigureStep:
    """One step: the `state` after it, those of what is not in parts, by the shapes that each is made of, and that of
    the parts' union.
    """

    state: FigureState
    wholes: Mapping[tuple[int, ...], RegionStep]
    union: RegionStep | None


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
    scale, stepped = scale_for(frame.size), None
    if state.union is not None:
        stepped = region.step(state.union, frame, _for_the_union(state.union, params), token)
    union = None if stepped is None else stepped.state
    after = replace(state, frame=frame, union=union, steps=state.steps + 1)
    lit = after.light_now.removed(frame)
    spots = np.vstack([limb.expected(params.part) for limb in state.limbs])
    reach = max((limb.pose.reach(params.part) for limb in state.limbs if limb.pose is not None), default=1.0)
    window = Region.around(spots, (params.figure.margin + params.part.search_move * reach) * scale, frame.size)
    pyramid = None
    if not posed.is_narrow(window, params.part):
        pyramid = Pyramid.of(lit, window, 1.0 / scale, params.part.pyramid)
    solving = _Solving(state, frame, lit, pyramid, union, params, token)
    for k in sorted(range(len(state.limbs)), key=lambda k: -depth(state.limbs[k], order)):
        if token is not None:
            token.check()
        solving.solve(k)
    solving.hold_together()
    solving.go_along()
    limbs = tuple(solving.to_the_edges(k) for k in range(len(state.limbs)))
    return FigureStep(replace(after, limbs=limbs), solving.wholes, stepped)


class _Solving:
    """The limbs on one frame, as far as they are solved, from the nearest on; `lit` is its picture in their light."""

    def __init__(
        self,
        state: FigureState,
        frame: PreparedFrame,
        lit: PreparedFrame,
        pyramid: Pyramid | None,
        union: RegionState | None,
        params: RegionParams,
        token: CancelToken | None,
    ) -> None:
        assert params.part is not None
        self.state, self.frame, self.lit, self.pyramid, self.token = state, frame, lit, pyramid, token
        self.region_params, self.params, self.scale = params, params.part, scale_for(frame.size)
        self.limbs: dict[int, Limb] = {}  # the nearest first
        self.wholes: dict[tuple[int, ...], RegionStep] = {}
        self.outlined: dict[int, UInt8] = {}
        self.around: dict[int, Surroundings] = {}
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

    def hold_together(self) -> None:
        """Carry a limb that is hidden behind an occluder along with those that it hangs on.

        Nothing speaks for or against a pose there: what the search finds stays behind when the others have gone on.
        """
        if self.pyramid is None:
            return
        hidden = [k for k in self.around if self._is_gone(k) and self._is_behind(k)]
        placed = self.limbs.keys() - hidden
        for k in sorted(hidden, key=lambda k: -sum(j in placed for j in self._neighbours(k))):
            ties, before = self._ties(k, placed), self.state.limbs[k].pose
            assert before is not None
            self.limbs[k] = self._under(self.limbs[k], before.hung(self.around[k], ties, self.params))
            self.outlined[k] = self.pyramid.outlined(self.limbs[k].lines)[0]
            placed.add(k)

    def _is_gone(self, k: int) -> bool:
        """Whether nothing that is seen of a limb looks as on its key."""
        pose = self.limbs[k].pose
        return pose is not None and pose.look is not None and pose.look.closest >= self.params.gone

    def _is_behind(self, k: int) -> bool:
        """Whether nearer occluders cover most of a limb."""
        ours = self.outlined[k] > 0
        free = ours.copy()
        for nearer in takewhile(lambda j: j != k, self.limbs):
            if self.limbs[nearer].is_occluder:
                free &= self.outlined[nearer] == 0
        return 2 * int(np.count_nonzero(free)) < int(np.count_nonzero(ours))

    def go_along(self) -> None:
        """Lay the parts that no pose fits along with the whole, if their colours are rather there.

        They begin to where all together miss the object's region, and go on until their poses clearly fit.
        """
        union = self.union
        if union is None or self.pyramid is None or union.trust < self.region_params.doubted:
            return
        missed = self._overlap(union, self.pyramid) < self.region_params.figure.covered
        asked = [k for k in self.limbs if missed or self.state.limbs[k].goes_along]
        if not asked:
            return
        motion = UnionMotion.of(union, self.region_params.figure)
        for k in filter(self._is_unfit, asked):
            limb = self.limbs[k]
            parts = motion.carried(limb.laid)
            if motion.keeps(parts, limb.laid) and self._looks_rather(k, parts, union):
                results = tuple(region.result(part, True, union.trust, union.region, union.params) for part in parts)
                self.limbs[k] = replace(limb, parts=parts, goes_along=True, results=results)
                self.outlined[k] = self.pyramid.outlined(self.limbs[k].lines)[0]

    def _is_unfit(self, k: int) -> bool:
        """Whether what is seen of a part under its pose does not look as on its key; once it went along: not clearly.

        What is mostly hidden there is taken to fit, but where one that goes along, and so lies elsewhere, may hide it.
        """
        limb = self.limbs[k]
        if limb.pose is None or limb.pose.look is None or limb.unit.role is not Role.PART:
            return False
        if limb.pose.look.seen < self.params.glimpse:
            return any(nearer.goes_along for nearer in self._nearer(k))
        bound = self.params.clear if self.state.limbs[k].goes_along else self.region_params.figure.unfit
        return limb.pose.look.closest >= bound

    def _nearer(self, k: int) -> list[Limb]:
        """The limbs that lie before limb `k`, as far as they are solved."""
        return [self.limbs[j] for j in takewhile(lambda j: j != k, self.limbs)]

    def _overlap(self, union: RegionState, pyramid: Pyramid) -> float:
        """That of all parts with the object's region, where no occluder lies."""
        inside = _on(union, pyramid) > 0.0
        free, filled = np.ones_like(inside), np.zeros_like(inside)
        for k, limb in self.limbs.items():
            if limb.is_occluder:
                free &= self.outlined[k] == 0
            elif limb.unit.role is Role.PART:
                filled |= self.outlined[k] > 0
        return overlap(filled & free, inside & free)

    def _looks_rather(self, k: int, parts: Sequence[Part], union: RegionState) -> bool:
        """Whether the colours of a part are rather where `parts` have it than where it lies, as far as it is seen."""
        limb, grid = self.limbs[k], union.region.grid
        assert limb.colours is not None
        picture, clip = grid.colours_of(self.lit), self.region_params.redetection.clip
        ratio = limb.colours.log_ratio(picture, clip, self.region_params.unseen)
        hidden = covered([line for nearer in self._nearer(k) for line in nearer.lines], grid)
        gained = ratio * (enclosed(parts, grid) - enclosed(limb.parts, grid))
        said = gained[... if hidden is None else ~hidden].astype(np.float64)
        against = self.region_params.figure.against if self.state.limbs[k].goes_along else 0.0
        return float(said.sum()) > -against * float(np.abs(said).sum())

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
        self.around[k] = Surroundings(self.pyramid, self.hidden, self._needs_of(k), self._ties(k, self.limbs))
        return self._under(limb, before.step(self.around[k], self.params))

    def _under(self, limb: Limb, pose: Pose) -> Limb:
        """A limb under its pose on this frame."""
        parts = posed.carried(pose, limb.drawn)
        if self._has_left(parts):
            return self._out_of_sight(replace(limb, parts=parts), pose)
        results = posed.results(pose, parts, self.region_params.confidence)
        return replace(limb, parts=parts, pose=pose, goes_along=False, results=results)

    def _has_left(self, parts: Sequence[Part]) -> bool:
        return Region.around(np.vstack([part.points.reshape(-1, 2) for part in parts]), 0.0, self.frame.size).is_empty

    def _out_of_sight(self, limb: Limb, pose: Pose) -> Limb:
        """A limb that has left the picture: carried all the same, without confidence."""
        results = tuple(
            StepResult(part.points, 0.0, np.zeros(len(part.points)), {}, Termination.LEFT_FRAME) for part in limb.parts
        )
        return replace(limb, pose=pose, goes_along=False, results=results)

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

    def _ties(self, k: int, among: Collection[int]) -> Ties | None:
        """The springs to those limbs `among` others; one to a limb that is in doubt is weak."""
        pose = self.state.limbs[k].pose
        assert pose is not None
        places, targets, weights = [], [], []
        for joint in self.state.joints:
            other = joint.other(k)
            to = None if other is None or other not in among else self.limbs[other].pose
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


def _for_the_union(union: RegionState, params: RegionParams) -> RegionParams:
    """What the union is carried with: its parts have the poses.

    Where nothing was seen of it, they tell where it is: what its key expects beyond its last place is not looked at.
    """
    params = replace(params, pose=None)
    return replace(params, redetection=replace(params.redetection, whole=0.0)) if union.is_lost else params


def _moved(before: RegionState, after: RegionState) -> Array:
    """The similarity `(3, 3)` by which the object went from one frame to the next."""
    return np.asarray(after.key.to_now @ np.linalg.inv(before.key.to_now))


def _needs(union: RegionState, pyramid: Pyramid, odds: float) -> Float32:
    """For each cell of the finest level, in [0, 1], whether the object is there; `odds` nats change them by e."""
    nats = _on(union, pyramid)
    return np.asarray(1.0 / (1.0 + np.exp(-np.clip(nats / odds, -4.0, 4.0))), dtype=np.float32)


def _on(union: RegionState, pyramid: Pyramid) -> Float32:
    """The nats of the object's region on the finest level, its last rows and columns repeated beyond the picture."""
    rows, columns = pyramid.levels[0].shape[:2]
    below, right = rows - pyramid.grid.rows, columns - pyramid.grid.columns
    nats = union.region.nats_on(pyramid.grid)
    return np.asarray(cv2.copyMakeBorder(nats, 0, below, 0, right, cv2.BORDER_REPLICATE))
