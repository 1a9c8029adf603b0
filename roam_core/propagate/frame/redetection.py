"""Re-detection: an object that was lost is looked for by the colours and the outline that it had on the artist's key.

Beyond the paper, whose landmarks go when their response is ambiguous and are made anew on the object: of what is wholly
hidden, or left behind by a region that leaked, nothing remains to make them on.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property

import cv2
import numpy as np

from roam_core.appearance.global_model import GlobalModel
from roam_core.arrays import Array, Float32
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.geometry import polyline
from roam_core.kernels.coverage import coverage
from roam_core.motion.keypoints import Keypoints
from roam_core.params import RedetectionParams, RegionParams, scale_for
from roam_core.proposal.cues.evidence import Field, KeyMemory
from roam_core.threads import each

Behind = Callable[[Grid], Float32]
"""What the key's background says of the cells of a grid `(rows, columns)`, nats for the object."""


@dataclass(frozen=True, eq=False)
class LastSeen:
    """When an object was last seen for sure.

    Attributes
    ----------
    carried : (3, 3) similarity from the key when the object was last whole. area : its area then, square pixels.
    middle : (2,) centroid of what was last seen of it. params : where it is looked for. since : frames since then.
    largest : the largest area that it has had when it was whole, where that is more than `area`.
    surroundings : (3, 3) similarity by which what lay around it on the key had gone when it was last whole.
    returning : frames on which it is still looked for since it was out of sight, however good it seems.
    """

    carried: Array
    area: float
    middle: Array
    params: RedetectionParams
    since: int = 0
    largest: float = 0.0
    surroundings: Array = field(default_factory=lambda: np.eye(3))
    returning: int = 0

    def sizes(self, surroundings: Array | None = None) -> list[float]:
        """Sizes in relation to `carried` that the object may have, up to the largest that it has had.

        What is about to be hidden seems to shrink: the size that was last seen may be too small. And where the camera
        zoomed meanwhile, the object may have grown as its `surroundings (3, 3)` did, whose way from the key that is.
        """
        sizes, step = list(self.params.sizes), self.params.sizes[-1]
        while 0.0 < sizes[-1] ** 2 * step * self.area < self.largest:
            sizes.append(sizes[-1] * step)
        if surroundings is None:
            return sizes
        zoom = _size_of(surroundings) / _size_of(self.surroundings)
        return sizes if sizes[0] <= zoom <= sizes[-1] else [*sizes, *(zoom * each for each in self.params.sizes)]

    @property
    def reach(self) -> float:
        """Pixels around `middle` in which the object may be."""
        return float(np.sqrt(max(self.area, self.largest)) * (self.params.near + self.params.pace * self.since))

    @property
    def is_worth_a_look(self) -> bool:
        """Whether to look for it on this frame: what has long been gone is looked for on some frames only."""
        return self.since <= self.params.long_gone or self.since % self.params.sometimes == 0

    def is_lost(self, region: Field) -> bool:
        """True when too little is left of the object to carry it on."""
        return area_of(region) <= self.params.lost * self.area

    def missed(self) -> LastSeen:
        """After one more frame on which the object was not seen."""
        return replace(self, since=self.since + 1, returning=self.params.long_gone)

    def after(self, key: KeyMemory, region: Field, resemblance: float = 1.0) -> LastSeen:
        """After a frame on which the object was seen, as `region`; `key` knows the way from the key to there.

        Its size and turn are taken over where they are sure: from `RedetectionParams.whole` of its area and
        `almost` full `resemblance` (`AppearanceTemplate.resemblance`) on.
        """
        area = carried_area(key)
        returning = max(self.returning - 1, 0)
        if resemblance >= self.params.almost and area_of(region) >= self.params.whole * area:
            largest = max(area, self.area, self.largest)
            middle = middle_of(region)
            return LastSeen(key.to_now, area, middle, self.params, 0, largest, key.surroundings, returning)
        return replace(self, middle=middle_of(region), since=0, returning=returning)


@dataclass(frozen=True, eq=False)
class Likeness:
    """How much each place of a picture looks like the object: `scores (rows, columns)` on a grid."""

    scores: Float32
    grid: Grid

    def best(self, near: Array, reach: float, beyond: tuple[Array, float] | None = None) -> tuple[float, Array]:
        """The highest score within `reach` pixels of `near (2,)`, and its place `(2,)` in the image.

        `beyond`, a place and a distance, leaves out what lies around that place.
        """
        allowed = self._away(near) <= reach
        if beyond is not None:
            allowed &= self._away(beyond[0]) > beyond[1]
        scores = np.where(allowed, self.scores, -np.inf)
        row, column = np.unravel_index(int(np.argmax(scores)), scores.shape)
        return float(scores[row, column]), self.grid.to_image(np.array([column + 0.5, row + 0.5]))

    def _away(self, near: Array) -> Array:
        """The distance `(rows, columns)` of each cell's centre from a place `(2,)`, in pixels."""
        rows, columns = self.scores.shape
        corner, cell = np.asarray(self.grid.region.origin), 1.0 / self.grid.factor
        x = corner[0] + cell[0] * (np.arange(columns) + 0.5) - near[0]
        y = corner[1] + cell[1] * (np.arange(rows) + 0.5) - near[1]
        return np.asarray(np.hypot(x, y[:, None]))


@dataclass(frozen=True, eq=False)
class Look:
    """An object that is looked for under `turn (2, 2)`, its size among that, by what the cells of a picture tell.

    Attributes
    ----------
    room : (2,) pixels to either side of its middle that it and its surroundings take. ratio : (rows, columns) what each
        cell of `grid` says, nats for the object.
    """

    turn: Array
    room: Array
    ratio: Float32
    grid: Grid


@dataclass(frozen=True, eq=False)
class AppearanceTemplate:
    """What an object looked like on the artist's key: its picture and region, and what follows from them.

    `unseen` is the density of a colour that the histograms never saw.
    """

    frame: PreparedFrame
    region: Field
    params: RedetectionParams
    unseen: float

    @cached_property
    def middle(self) -> Array:
        """The centroid `(2,)` on the key."""
        return middle_of(self.region)

    @cached_property
    def rim(self) -> Array:
        """The places `(K, 2)` on the key between which all others of the object lie."""
        return _rim(self.region)

    @cached_property
    def extent(self) -> float:
        """The root of its area on the key, in pixels."""
        return float(np.sqrt(area_of(self.region)))

    @cached_property
    def colours(self) -> GlobalModel:
        """Its colours against those of all the rest of the key's picture, not of its surroundings alone."""
        grid = Grid.over(_whole(self.frame), float(self.region.grid.factor.mean()))
        inside = self.region.on(grid) > 0.5
        return GlobalModel.learned(grid.colours_of(self.frame), inside, ~inside)

    @cached_property
    def own_score(self) -> float:
        """How much the object looks like itself: the score of its place on the key."""
        cell = self.extent / self.params.across
        looks = self._looks(self.frame, [np.eye(2)], self.middle, 2.0 * cell)
        return max((self._likeness(look).best(self.middle, 2.0 * cell)[0] for look in looks), default=-np.inf)

    @cached_property
    def keypoints(self) -> Keypoints:
        """Its keypoints on the key."""
        grid = Grid.over(_whole(self.frame), 1.0 / scale_for(self.frame.size))
        return Keypoints.of(self.frame, grid, self.region.on(grid) > 0.5)

    @property
    def is_distinct(self) -> bool:
        """Whether it is large enough on the key, and its colours tell it from its surroundings there."""
        return self.extent >= self.params.least and self.own_score >= self.params.distinct

    def found(
        self,
        frame: PreparedFrame,
        last_seen: LastSeen,
        behind: Behind | None = None,
        surroundings: Array | None = None,
    ) -> Array | None:
        """The similarity `(3, 3)` from the key that puts the object where it is seen; None where it is not.

        Turn and size are those where it was last seen, but for `LastSeen.sizes`. `behind` tells where the key's
        background is seen, `surroundings (3, 3)` how what lay around it there has gone since, where that is known.
        Larger than the picture nothing is looked for.
        """
        if self.extent < 1.0:
            return None
        near, reach = last_seen.middle, last_seen.reach
        sized = [size * last_seen.carried[:2, :2] for size in last_seen.sizes(surroundings)]
        turns = [turn for turn in sized if self._extent_under(turn) <= float(np.hypot(*frame.size))]
        looks = [look for alike in self._of_like_size(turns) for look in self._looks(frame, alike, near, reach, behind)]
        if not looks:
            return None
        tried = each(self._likeness, looks)
        seen = [likeness.best(near, reach) for likeness in tried]
        chosen = int(np.argmax([score for score, _ in seen]))
        score, place = seen[chosen]
        if not score >= max(self.params.alike * self.own_score, 0.0):
            return None
        turn = looks[chosen].turn
        rival, _ = tried[chosen].best(near, reach, beyond=(place, self._extent_under(turn)))
        if rival > self.params.alone * score:
            return None
        placed = np.eye(3)
        placed[:2, :2] = turn
        placed[:2, 2] = place - turn @ self.middle
        return placed

    def found_by_keypoints(self, frame: PreparedFrame, last_seen: LastSeen) -> Array | None:
        """The similarity `(3, 3)` from the key that its keypoints which are in sight agree on; None where too few do.

        They are looked for where it may be, as a whole, and there only on what has its colours. What has changed its
        size too much is something else.
        """
        params, scale = self.params.keypoints, scale_for(frame.size)
        if len(self.keypoints.places) < params.fewest:
            return None
        extent = self._extent_under(last_seen.carried[:2, :2])
        area = Region.around(last_seen.middle[None], last_seen.reach + extent, frame.size)
        if area.is_empty:
            return None
        cells = Grid.over(area, min(self.params.across / extent, 1.0))
        alike = cv2.dilate((self._ratio(frame, cells) > 0.0).astype(np.float32), np.ones((3, 3), np.uint8))
        if not alike.any():
            return None
        spots = np.argwhere(alike)[:, ::-1].astype(np.float64) + 0.5
        around = Region.around(cells.to_image(spots), 0.5 / float(cells.factor.min()), frame.size)
        grid = Grid.over(around, 1.0 / scale)
        seen = Keypoints.of(frame, grid, Field.of_coverage(cells, alike).on(grid) > 0.5)
        placed = self.keypoints.similarity_to(seen, params.near * scale, params)
        if placed is None:
            return None
        size = _size_of(placed) / _size_of(last_seen.carried)
        return placed if 1.0 / params.sizes < size < params.sizes else None

    def resemblance(self, frame: PreparedFrame, line: Array) -> float:
        """How much like the object what the closed polyline `(N, 2)` encloses looks: 1 as on the key, 0 not at all.

        The mean log-ratio inside less that of the surroundings, as everywhere here, in relation to the key's own.
        """
        extent = float(np.sqrt(abs(polyline.signed_area(line))))
        return self._resemblance(frame, line, extent, lambda grid: coverage(grid.to_grid(line), grid.shape))

    def resemblance_of(self, frame: PreparedFrame, region: Field) -> float:
        """The same of what lies in a region, as far as it is in the picture."""
        if not region.inside.any():
            return 0.0
        return self._resemblance(frame, _rim(region), float(np.sqrt(area_of(region))), region.on)

    def _resemblance(
        self, frame: PreparedFrame, rim: Array, extent: float, covered: Callable[[Grid], Float32]
    ) -> float:
        """The same of what lies between the places of `rim (N, 2)`, `extent` the root of its area.

        `covered` tells how much of each cell of a grid it takes.
        """
        area = Region.around(rim, (self.params.ring + 2.0 / self.params.across) * extent, frame.size)
        if extent < 1.0 or area.is_empty:
            return 0.0
        grid = Grid.over(area, min(self.params.across / extent, 1.0))
        shares = _shares(covered(grid), self.params.ring * extent * float(grid.factor.mean()))
        score = float((self._ratio(frame, grid) * shares).sum())
        return float(np.clip(score / max(self.own_score, 1e-6), 0.0, 1.0))

    def _extent_under(self, turn: Array) -> float:
        """The root of its area under `turn (2, 2)`, in pixels."""
        return self.extent * float(np.sqrt(abs(np.linalg.det(turn))))

    def _ratio(self, frame: PreparedFrame, grid: Grid) -> Float32:
        return self.colours.log_ratio(grid.colours_of(frame), self.params.clip, self.unseen)

    def _of_like_size(self, turns: list[Array]) -> list[list[Array]]:
        """`turns (2, 2)` from small to large: those within an octave together, for the same cells show them."""
        alike: list[list[Array]] = []
        for turn in sorted(turns, key=self._extent_under):
            if alike and self._extent_under(turn) <= 2.0 * self._extent_under(alike[-1][0]):
                alike[-1].append(turn)
            else:
                alike.append([turn])
        return alike

    def _looks(
        self, frame: PreparedFrame, turns: list[Array], near: Array, reach: float, behind: Behind | None = None
    ) -> list[Look]:
        """What tells where the object lies within `reach` pixels of `near`, under `turns (2, 2)` from small to large.

        The cells are as fine as the smallest asks for.
        """
        extents = [self._extent_under(turn) for turn in turns]
        margin = self.params.ring + 2.0 / self.params.across
        rooms = [
            np.abs((self.rim - self.middle) @ turn.T).max(axis=0) + margin * extent
            for turn, extent in zip(turns, extents, strict=True)
        ]
        room = np.max(rooms, axis=0)
        area = Region.around(np.stack([near - reach - room, near + reach + room]), 0.0, frame.size)
        if area.is_empty:
            return []
        grid = Grid.over(area, min(self.params.across / extents[0], 1.0))
        ratio = self._ratio(frame, grid)
        if behind is not None:
            ratio = ratio + behind(grid)
        return [Look(turn, room, ratio, grid) for turn, room in zip(turns, rooms, strict=True)]

    def _likeness(self, look: Look) -> Likeness:
        """Mean log-ratio inside the outline, put everywhere, less that of its surroundings."""
        ring = self.params.ring * self._extent_under(look.turn) * float(look.grid.factor.mean())
        shares = _shares(self._template(look), ring)
        scores = cv2.filter2D(look.ratio, cv2.CV_32F, shares, borderType=cv2.BORDER_CONSTANT)
        return Likeness(np.asarray(scores, dtype=np.float32), look.grid)

    def _template(self, look: Look) -> Float32:
        """The object's coverage in cells of the look's grid, its middle in the middle."""
        columns, rows = (2 * int(np.ceil(value)) + 1 for value in look.room * look.grid.factor)
        placed = np.eye(3)
        placed[:2, :2] = np.diag(look.grid.factor) @ look.turn
        placed[:2, 2] = np.array([columns, rows]) / 2.0 - placed[:2, :2] @ self.middle
        canvas = Grid(Region(0, 0, columns, rows), rows, columns)
        return self.region.on(canvas, placed)


@dataclass(frozen=True, eq=False)
class Watch:
    """What is kept of an outline's key so that its inside is known again, and how it has looked since.

    Attributes
    ----------
    drawn : (P, 3, 2) control points on the key. appearance : what it looked like there. last_seen : when it was last
        seen.
    resemblance : how much it looked so on the last frame, in [0, 1].
    """

    drawn: Array
    appearance: AppearanceTemplate
    last_seen: LastSeen
    resemblance: float = 1.0

    @classmethod
    def begun(cls, drawn: Array, frame: PreparedFrame, region: Field, params: RegionParams) -> Watch | None:
        """On the key, where the outline encloses `region`; None of what could not be told from its surroundings."""
        appearance = AppearanceTemplate(frame, region, params.redetection, params.unseen)
        if not appearance.is_distinct:
            return None
        return cls(drawn, appearance, LastSeen(np.eye(3), area_of(region), middle_of(region), params.redetection))

    def after(self, frame: PreparedFrame, line: Array, key: KeyMemory, region: Field, params: RegionParams) -> Watch:
        """After a frame with the outline `line (N, 2)`, which encloses `region` there."""
        alike = self.appearance.resemblance(frame, line)
        seen = self.last_seen.after(key, region, alike) if alike >= params.believed else self.last_seen.missed()
        return replace(self, last_seen=seen, resemblance=alike)

    def missed(self) -> Watch:
        """After a frame on which the outline lay outside the picture."""
        return replace(self, last_seen=self.last_seen.missed(), resemblance=0.0)


def is_better(again: float, compared: float, carried: float, params: RegionParams) -> bool:
    """Whether what was found elsewhere is taken in place of what was carried on.

    `again` is what it promises by itself, `compared` what it does beside `carried`, the promise of the other.
    """
    return again > params.believed and compared > carried + params.better


def as_on_key(key: PreparedFrame, to_now: Array) -> PreparedFrame:
    """The key's picture as if the object had been where the similarity `to_now (3, 3)` puts it."""
    return PreparedFrame(Grid.over(_whole(key), 1.0).warped(key.image, to_now))


def _rim(region: Field) -> Array:
    """The places `(K, 2)` in the image between which all others of a region lie."""
    inside = region.inside
    rows = np.flatnonzero(inside.any(axis=1))
    ends = [inside[rows].argmax(axis=1), inside.shape[1] - 1 - inside[rows, ::-1].argmax(axis=1)]
    return region.grid.to_image(np.vstack([np.stack([end, rows], axis=1) for end in ends]) + 0.5)


def _size_of(transform: Array) -> float:
    """How many times as large a similarity `(3, 3)` makes things."""
    return float(np.sqrt(abs(np.linalg.det(transform[:2, :2]))))


def area_of(region: Field) -> float:
    """Square pixels inside."""
    return np.count_nonzero(region.inside) / float(np.prod(region.grid.factor))


def carried_area(key: KeyMemory) -> float:
    """Square pixels that the object, carried from the key, takes up where nothing hides it."""
    return area_of(key.region) * abs(float(np.linalg.det(key.to_now[:2, :2])))


def middle_of(region: Field) -> Array:
    """The centroid `(2,)` of the inside, in the image; the middle of the grid where nothing is inside."""
    counts = [np.count_nonzero(region.inside, axis=axis) for axis in (0, 1)]
    if not counts[0].any():
        return region.grid.to_image(np.array([region.grid.columns, region.grid.rows]) / 2.0)
    return region.grid.to_image(np.array([np.average(np.arange(len(count)), weights=count) for count in counts]) + 0.5)


def _shares(inside: Float32, ring: float) -> Float32:
    """The share of each cell in what lies inside, less that in its surroundings, `ring` cells wide."""
    width = 2 * max(round(ring), 1) + 1
    around = cv2.dilate(inside, cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (width, width))) - inside
    inner, outer = (np.asarray(part / max(float(part.sum()), 1e-6)) for part in (inside, around))
    return np.asarray(inner - outer)


def _whole(frame: PreparedFrame) -> Region:
    return Region(0, 0, frame.size[1], frame.size[0])
