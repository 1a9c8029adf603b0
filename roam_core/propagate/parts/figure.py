"""An object drawn in parts: each with a motion of its own, nearest first, seen past those that hide it.

The union of the parts is carried by regions, as a whole object is; it tells where the object is, and so where a part is
needed that no other part accounts for. Each part is found by its pose (`motion.pose`), anchored to the key; parts that
overlapped there hold together by springs (`geometry.joints`). An occluder is a part that subtracts: it belongs to
nothing, and hides what lies below it. Behind it, an object that is not in parts goes on being carried by regions.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TypeVar

import numpy as np

from roam_core.appearance.global_model import GlobalModel
from roam_core.arrays import Array
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.geometry import bezier
from roam_core.geometry.joints import Joint, joints
from roam_core.matte.vectorise import shapes_from_mask
from roam_core.motion.pose import Pose
from roam_core.params import PoseParams, RegionParams, scale_for
from roam_core.propagate.frame.contour_fit import enclosed, enclosed_by_any
from roam_core.propagate.frame.covering import visible
from roam_core.propagate.frame.result import Part, StepResult
from roam_core.propagate.shapes.objects import Role, Unit
from roam_core.propagate.whole import posed
from roam_core.propagate.whole.interest import grid_around
from roam_core.propagate.whole.state import RegionState
from roam_core.propagate.whole.state import begin as begin_whole
from roam_core.proposal.cues.exposure import UNCHANGED, Light
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
    laid : its outlines as they lay when the union of all parts began. goes_along : it went along with the union, for
        its pose did not fit.
    colours : those of what is seen of it on the key, against all around.
    results : what the last frame gave for each shape; empty on the key.
    """

    unit: Unit
    drawn: tuple[Part, ...]
    parts: tuple[Part, ...]
    pose: Pose | None = None
    whole: RegionState | None = None
    laid: tuple[Part, ...] = ()
    goes_along: bool = False
    colours: GlobalModel | None = None
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
    """After a frame.

    Attributes
    ----------
    frame : its picture. limbs : bottom first. joints : where they hang together. union : the parts as one object.
    light : what had become of the first key's light when the `union` began; all limbs are known in that of the key.
    """

    frame: PreparedFrame
    limbs: tuple[Limb, ...]
    joints: tuple[Joint, ...]
    union: RegionState | None
    steps: int = 0
    light: Light = UNCHANGED

    @property
    def light_now(self) -> Light:
        """What has become of the first key's light, as the background of the union tells it."""
        return self.light if self.union is None else self.union.key.light.after(self.light)

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

    @property
    def at_poses(self) -> tuple[Array | None, ...]:
        """The points of each shape by its pose alone, in their order; None where it has none, or goes along with the
        union.
        """
        outlines: list[tuple[Array | None, ...]] = [
            (None,) * len(limb.unit.members)
            if limb.pose is None or limb.goes_along
            else tuple(part.points for part in posed.carried(limb.pose, limb.drawn))
            for limb in self.limbs
        ]
        return self._in_order(outlines)

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
    learned = tuple(_learned(frame, frame, limbs, k, params, order) for k in range(len(limbs)))
    found = joints([limb.lines[0] for limb in limbs], scale, params.figure.joints)
    held = [joint for joint in found if _holds(joint, limbs)]
    return FigureState(frame, learned, tuple(held), _union(frame, limbs, params))


def corrected(
    state: FigureState, parts: Sequence[Part], params: RegionParams, order: Sequence[int], given: Sequence[bool]
) -> FigureState:
    """The state after a frame on which the artist gave some of the shapes.

    What was given is learned anew, as it looks in the light of the first key; the other limbs stay as they are, with
    the looks of their own keys.
    """
    light = state.light_now
    lit = light.removed(state.frame)
    fresh = [any(given[k] for k in limb.unit.members) for limb in state.limbs]
    limbs = [_drawn(limb.unit, parts) if new else limb for limb, new in zip(state.limbs, fresh, strict=True)]
    learned = tuple(
        _learned(state.frame, lit, limbs, k, params, order) if new else replace(limbs[k], laid=limbs[k].parts)
        for k, new in enumerate(fresh)
    )
    held = tuple(_held_now(joint, state.limbs, fresh) for joint in state.joints)
    return replace(state, limbs=learned, joints=held, union=_union(state.frame, learned, params), light=light)


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
    return Limb(unit, drawn, drawn, laid=drawn)


def _learned(
    frame: PreparedFrame,
    lit: PreparedFrame,
    limbs: Sequence[Limb],
    k: int,
    params: RegionParams,
    order: Sequence[int],
) -> Limb:
    """A limb as drawn, with what it looks like where no other covers it; `lit` is the frame in the first key's light.

    A whole object is learned from the frame as it is: it follows its light by itself.
    """
    assert params.part is not None
    limb, covers = limbs[k], [line for nearer in _nearer(limbs, k, order) for line in nearer.lines]
    if limb.unit.role is Role.WHOLE:
        return replace(limb, whole=begin_whole(frame, limb.parts, params, covers))
    pose = posed.learned(lit, limb.lines[0], params.part, [*limb.gaps, *covers])
    return replace(limb, pose=pose, colours=None if pose is None else _colours(lit, limb, covers, params))


def _colours(frame: PreparedFrame, limb: Limb, covers: Sequence[Array], params: RegionParams) -> GlobalModel:
    """The colours of a limb as drawn, where nothing covers it, against those around and before it."""
    spots = np.vstack([part.points.reshape(-1, 2) for part in limb.parts])
    grid = grid_around(spots, frame.size, params, scale_for(frame.size))
    inside = visible(enclosed(limb.parts, grid) > 0.5, covers, grid, params.least_seen)
    return GlobalModel.learned(grid.colours_of(frame), inside, ~inside)


def depth(limb: Limb, order: Sequence[int]) -> int:
    """How many shapes lie below a limb; `order` are the shapes' indices as stacked, bottom first."""
    return order.index(limb.unit.members[0])


def _nearer(limbs: Sequence[Limb], k: int, order: Sequence[int]) -> list[Limb]:
    """The limbs that lie before another one."""
    return [limb for limb in limbs if depth(limb, order) > depth(limbs[k], order)]


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
    covered = enclosed_by_any((limb.parts for limb in limbs if limb.unit.role is Role.PART), grid)
    for part in hidden:
        covered *= 1.0 - enclosed([Part(part.points)], grid)
    outlines = tuple(
        Part(shape.keys[0].points + window.origin, shape.blend is BlendMode.SUBTRACT)
        for shape in shapes_from_mask(covered, tolerance=1.0)
    )
    return begin_whole(frame, outlines, replace(params, pose=None)) if outlines else None
