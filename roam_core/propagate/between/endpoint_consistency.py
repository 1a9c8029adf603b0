"""The estimates of a span between two keys, and how far each of them missed the other key.

Three speak for each frame: the pass from the first key, the one from the last, and the keys themselves carried by
the object's similarity and blended (planar motion). Where an estimate that starts on one key arrives beside the other,
no truth but the artist's is needed to see it: so much it counts, place by place along the outline.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import cv2
import numpy as np

from roam_core.arrays import Array, Bools, Float32
from roam_core.features import Region
from roam_core.features.grid import Grid
from roam_core.geometry import bezier, similarity
from roam_core.params import RegionParams
from roam_core.propagate.between.directional_pass import DirectionalPass, Stop
from roam_core.propagate.frame.contour_fit import enclosed
from roam_core.propagate.frame.nodes import smooth_points
from roam_core.propagate.frame.result import Part
from roam_core.proposal.outline.contour import KeyConstraints


@dataclass(frozen=True, eq=False)
class Key:
    """An artist's key at one end of a span: its frame and, for each outline, its part or None where it has none."""

    frame: int
    parts: tuple[Part | None, ...]

    @property
    def members(self) -> list[int]:
        """Which outlines have a part."""
        return [k for k, part in enumerate(self.parts) if part is not None]

    @property
    def drawn(self) -> tuple[Part, ...]:
        """The parts that there are."""
        return tuple(part for part in self.parts if part is not None)


@dataclass(frozen=True, eq=False)
class Residual:
    """How far an estimate lay from a key, pixels of a 480-line image: on a grid, and at the points of each outline."""

    grid: Grid
    around: Float32
    points: tuple[Array | None, ...]
    loss: float

    def of(self, k: int) -> Array:
        """The misses `(P,)` at the points of an outline that is on both keys."""
        values = self.points[k]
        assert values is not None
        return values

    def on(self, grid: Grid, transform: Array) -> Float32:
        """The misses on another grid, carried by a similarity `(3, 3)`."""
        return np.asarray(grid.warped(self.around, transform @ self.grid.map_to_image))


@dataclass(frozen=True, eq=False)
class Span:
    """Two keys and the passes from each of them to the other.

    Attributes
    ----------
    first, last : the keys. onwards, back : the passes that start on them; None for a key without a part.
    size : (h, w) of the pictures. scale : `params.scale_for(size)`.
    params : how outlines are fitted to regions. asked_beyond : the nearest keys beyond these two were asked, too.
    """

    first: Key
    last: Key
    onwards: DirectionalPass | None
    back: DirectionalPass | None
    size: tuple[int, int]
    scale: float
    params: RegionParams
    asked_beyond: bool = False

    @property
    def better(self) -> Span:
        """This span, its outlines by their poses alone where these came nearer to the other keys."""
        return self._better_in_parts._better_of_lone_shape

    @property
    def _better_in_parts(self) -> Span:
        """The same; no free edge is drawn to the border of the object's region where the pose alone came nearer."""
        by_poses = self._losses(lambda stop: stop.at_poses)
        stiff = {k for k, loss in by_poses.items() if loss <= self.losses[k]}
        if not stiff or self.onwards is None or self.back is None:
            return self
        onwards, back = (
            way.by_poses_alone([k in stiff for k in key.members])
            for way, key in ((self.onwards, self.first), (self.back, self.last))
        )
        return replace(self, onwards=onwards, back=back)

    @property
    def _better_of_lone_shape(self) -> Span:
        """The same; by the poses of a lone shape instead of its region.

        They must look as on their keys, and on most frames like a part, where they are seen at all.
        """
        posed = self.posed
        if posed is None:
            return self
        poses = [
            stop.motion.by_pose
            for directional_pass, _, _ in posed._ways
            if directional_pass is not None
            for stop in directional_pass.stops.values()
            if stop.motion.by_pose is not None
        ]
        seen = [pose for pose in poses if not pose.is_gone]  # on the keys, at least
        if float(np.mean([pose.is_believable for pose in seen])) < 0.5:
            return self
        if float(np.mean([pose.cost for pose in seen])) > self.params.span.endpoint_consistency.dear:
            return self
        ours, theirs = (
            sum(residual.loss for residual in span.residuals[:2]) if span.residuals else 0.0 for span in (self, posed)
        )
        return posed if theirs < self.params.span.endpoint_consistency.lenient * ours else self

    @property
    def posed(self) -> Span | None:
        """The same, by the poses of a lone shape alone; None where it has none."""
        onwards = None if self.onwards is None else self.onwards.posed
        back = None if self.back is None else self.back.posed
        return None if onwards is None or back is None else replace(self, onwards=onwards, back=back)

    @cached_property
    def union(self) -> Span | None:
        """The same of the union of an object's parts, each key with outlines of its own; None where it has none."""
        ahead, behind = (None if way is None else way.of_union for way, _, _ in self._ways)
        if ahead is None or behind is None:
            return None
        first, last = (_union_on(way, key.frame) for way, key in ((self.onwards, self.first), (self.back, self.last)))
        return replace(
            self,
            first=replace(self.first, parts=(*first, *(None for _ in last))),
            last=replace(self.last, parts=(*(None for _ in first), *last)),
            onwards=ahead,
            back=behind,
        )

    @cached_property
    def residuals(self) -> tuple[Residual, Residual, Residual, Residual] | None:
        """Of the pass onwards, of the one back, and of planar motion at the last and the first key.

        None where a pass did not arrive.
        """
        there, here = stop_at(self.onwards, self.last.frame), stop_at(self.back, self.first.frame)
        if there is None or here is None:
            return None
        return (
            self._missed(self.last, self.first, there.points),
            self._missed(self.first, self.last, here.points),
            self._missed(self.last, self.first, carried(self.first, there.carried)),
            self._missed(self.first, self.last, carried(self.last, here.carried)),
        )

    @cached_property
    def is_planar(self) -> bool:
        """True where each key, carried as one piece, came nearer to the other than the passes did."""
        if self.residuals is None:
            return False
        onwards, back, planar_there, planar_here = self.residuals
        return planar_there.loss + planar_here.loss < onwards.loss + back.loss

    @cached_property
    def losses(self) -> dict[int, float]:
        """For each outline that is on both keys, the mean share in which it missed the other key, from either."""
        return self._losses(lambda stop: stop.points)

    def _losses(self, of: Callable[[Stop], Sequence[Array | None]]) -> dict[int, float]:
        """As `losses`, by outlines of each stop that may be missing."""
        there, here = stop_at(self.onwards, self.last.frame), stop_at(self.back, self.first.frame)
        if there is None or here is None:
            return {}
        came = dict(zip(self.first.members, of(there), strict=True))
        back = dict(zip(self.last.members, of(here), strict=True))
        found: dict[int, float] = {}
        for k in came.keys() & back.keys():
            first, last, ahead, behind = self.first.parts[k], self.last.parts[k], came[k], back[k]
            if first is not None and last is not None and ahead is not None and behind is not None:
                found[k] = 0.5 * (self._loss(ahead, last.points) + self._loss(behind, first.points))
        return found

    @cached_property
    def believed(self) -> dict[int, tuple[frozenset[int], frozenset[int]]]:
        """For each outline the frames on which its pose is believed in the pass onwards, and in the one back.

        Where only one of them came to the other key, it alone is; where none did, the one that did not follow another
        thing. Each is on its half of the span where neither did, and none where both did.
        """
        found = {}
        for k in {*self.first.members, *self.last.members}:
            onwards, back = (
                self._believed_in(k, way, key, far)
                for (way, key, _), far in zip(self._ways, self._reach(k), strict=True)
            )
            found[k] = onwards | {self.first.frame}, back | {self.last.frame}
        return found

    @property
    def _ways(self) -> tuple[tuple[DirectionalPass | None, Key, Key], ...]:
        """Each pass, where it begins, and where it leads."""
        return (self.onwards, self.first, self.last), (self.back, self.last, self.first)

    @property
    def is_astray(self) -> bool:
        """True of a lone shape by its pose that no pass brought to the other key, and none tells which is right."""
        if not all(way is not None and way.is_posed for way, _, _ in self._ways):
            return False
        both = set(self.first.members) & set(self.last.members)
        return any(not any(self._have_arrived(k)) and len(set(self._have_led(k))) == 1 for k in both)

    @property
    def has_arrived(self) -> bool:
        """Whether a pass brought any outline to where it lies on the other key."""
        return any(any(self._have_arrived(k)) for k in {*self.first.members} & {*self.last.members})

    def _reach(self, k: int) -> list[float]:
        """How far along the span each pass is believed of an outline."""
        arrived, led = self._have_arrived(k), self._have_led(k)
        if not any(arrived) and all(led):
            return [0.5, 0.5]
        return [1.0 if each else 0.0 for each in (arrived if any(arrived) else led)]

    def _have_arrived(self, k: int) -> list[bool]:
        """Which passes brought an outline to where it lies on the other key."""
        return [self._arrived(k, *way) for way in self._ways]

    def _have_led(self, k: int) -> list[bool]:
        """Which passes did not follow another thing than the outline."""
        return [not self._followed_another(k, *way) for way in self._ways]

    def _arrived(self, k: int, way: DirectionalPass | None, key: Key, other: Key) -> bool:
        """Whether a pass brought an outline to where it lies on the other key."""
        end, true = stop_at(way, other.frame), other.parts[k]
        if end is None or true is None or k not in key.members:
            return False
        return 1.0 - self._loss(end.points[key.members.index(k)], true.points) >= self.params.span.arrived

    def _followed_another(self, k: int, way: DirectionalPass | None, key: Key, other: Key) -> bool:
        """Whether an outline that did not come to the other key looks, where it came to, as on its own.

        What it was learned from there then is not the part, but what hid it on its key.
        """
        end = stop_at(way, other.frame)
        if end is None or k not in key.members:
            return False
        cost = end.motion.pose_costs[key.members.index(k)]
        return cost is not None and cost < self.params.span.endpoint_consistency.dear

    def _believed_in(self, k: int, way: DirectionalPass | None, key: Key, reach: float) -> frozenset[int]:
        """The frames on which the pose of an outline is believed in a pass that begins on `key`, up to `reach` of it.

        They are those on which it is seen, and more likely right than wrong: a pass that lost a part may have found it
        again on the other key.
        """
        if way is None or k not in key.members:
            return frozenset()
        place, farthest = key.members.index(k), reach * (self.last.frame - self.first.frame)
        return frozenset(
            frame
            for frame, stop in way.stops.items()
            if abs(frame - key.frame) <= farthest
            and not (stop.motion.gone and stop.motion.gone[place])
            and self.is_likely(k, stop, key)
        )

    def is_likely(self, k: int, stop: Stop | None, key: Key) -> bool:
        """Whether the pass from a key takes an outline to be more likely right than wrong where it stands."""
        return stop is not None and stop.confidence[key.members.index(k)] >= self.params.span.likely

    def _loss(self, found: Array, true: Array) -> float:
        """The share in which two outlines differ."""
        grid = grid_over([found, true], self.size, self.params.span.endpoint_consistency.look, self.scale)
        a, b = (enclosed([Part(points)], grid) > 0.5 for points in (found, true))
        union = int(np.count_nonzero(a | b))
        return int(np.count_nonzero(a ^ b)) / union if union else 0.0

    def constraints(self, k: int, u: float) -> KeyConstraints:
        """What an outline keeps of both keys, or of the one that has it, `u` of the way between them."""
        first, last = self._constraints[k]
        return first.towards(last, u)

    @cached_property
    def _constraints(self) -> list[tuple[KeyConstraints, KeyConstraints]]:
        made = []
        for k in range(len(self.first.parts)):
            first, last = (key.parts[k] or self._part(k) for key in (self.first, self.last))
            smooth = smooth_points(first.points) & smooth_points(last.points)
            params = self.params
            made.append(
                KeyConstraints.of_keys(
                    first.points, last.points, smooth, params.contour_fit, self.scale, params.kept_shares
                )
            )
        return made

    def subtracts(self, k: int) -> bool:
        """Whether an outline cuts a hole."""
        return self._part(k).subtracts

    def _part(self, k: int) -> Part:
        part = self.first.parts[k] or self.last.parts[k]
        assert part is not None
        return part

    def _missed(self, key: Key, source: Key, arrived: Sequence[Array]) -> Residual:
        """What arrived from the parts of `source`, against the parts of `key`."""
        came = dict(zip(source.members, arrived, strict=True))
        true = key.drawn
        found = [Part(came[k], part.subtracts) for k, part in zip(source.members, source.drawn, strict=True)]
        endpoint_consistency = self.params.span.endpoint_consistency
        grid = grid_over([part.points for part in (*true, *found)], self.size, endpoint_consistency.look, self.scale)
        a, b = enclosed(found, grid) > 0.5, enclosed(true, grid) > 0.5
        around = _displacement(a, b, grid, endpoint_consistency.reach, self.scale)
        union = int(np.count_nonzero(a | b))
        loss = int(np.count_nonzero(a ^ b)) / union if union else 0.0
        points = tuple(
            _averaged(np.hypot(*(came[k] - part.points)[:, bezier.ANCHOR].T) / self.scale)
            if part is not None and k in came
            else None
            for k, part in enumerate(key.parts)
        )
        return Residual(grid, around, points, loss)


def _union_on(way: DirectionalPass | None, frame: int) -> tuple[Part, ...]:
    """The outlines of the union of an object's parts on the key that a pass began on."""
    stop = stop_at(way, frame)
    return () if stop is None or stop.union is None else stop.union.drawn


def stop_at(directional_pass: DirectionalPass | None, frame: int) -> Stop | None:
    """Where a pass stands on a frame; None without a pass or a picture."""
    return None if directional_pass is None else directional_pass.at(frame)


def carried(key: Key, transform: Array) -> list[Array]:
    """The outlines of a key, moved as one piece by a similarity `(3, 3)`."""
    return [similarity.apply(transform[:2], part.points) for part in key.drawn]


def grid_over(splines: Sequence[Array], size: tuple[int, int], look: float, scale: float) -> Grid:
    """A grid `look` pixels of a 480-line image around closed splines `(P, 3, 2)`, its cells about such a pixel."""
    spots = np.vstack([points.reshape(-1, 2) for points in splines])
    area = Region.around(spots, look * scale, size)
    if area.is_empty:
        area = Region(0, 0, 1, 1)
    return Grid.over(area, 1.0 / scale)


def _displacement(found: Bools, true: Bools, grid: Grid, reach: float, scale: float) -> Float32:
    """The error between two regions per length of outline, averaged over `reach`: pixels of a 480-line image."""
    sigma = reach * scale * float(grid.factor.mean())
    error = cv2.GaussianBlur((found ^ true).astype(np.float32), (0, 0), sigma)
    rim = cv2.morphologyEx(true.astype(np.uint8), cv2.MORPH_GRADIENT, np.ones((3, 3), np.uint8))
    length = cv2.GaussianBlur(0.5 * rim.astype(np.float32), (0, 0), sigma)
    return np.asarray(error / (length + np.float32(1e-4)) / np.float32(grid.factor.mean() * scale), dtype=np.float32)


def _averaged(values: Array) -> Array:
    """Each value with its two neighbours around the outline."""
    return np.asarray(0.5 * values + 0.25 * (np.roll(values, 1) + np.roll(values, -1)))
