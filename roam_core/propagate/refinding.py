"""Re-detection: an object that was lost is looked for by the colours and the outline that it had on the artist's key.

Beyond the paper, whose landmarks go when their response is ambiguous and are made anew on the object: of what is wholly
hidden, or left behind by a region that leaked, nothing remains to make them on.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import cv2
import numpy as np
from numpy.typing import NDArray

from roam_core.appearance.global_model import GlobalModel
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.proposal.evidence import Field
from roam_core.threads import each

Array = NDArray[np.float64]
Float32 = NDArray[np.float32]

ACROSS = 16.0
"""Cells across the object (the root of its area) at which it is looked for."""
SIZES = (0.8, 1.0, 1.25)
"""Sizes that are tried, in relation to the last one that was sure."""
ALIKE = 0.6
"""Share of the key's own score from which a place is the object's."""
ALONE = 0.8
"""Share of the best score that no other place may have."""
RING = 0.5
"""Width of the surroundings that must look unlike the object, in roots of its area."""
CLIP = 3.0
"""Bound on the log-ratio of a cell, nats."""

LOST = 0.1
"""Share of the area that it should have under which an object is lost."""
WHOLE = 0.5
"""Share of it from which its size and turn are sure."""
LONG_GONE, SOMETIMES = 8, 4
"""Frames unseen after which an object is looked for on every fourth frame only."""
NEAR, PACE = 2.0, 0.5
"""Roots of its area around its last place within which an object is looked for, and by how many more a frame unseen."""


@dataclass(frozen=True, eq=False)
class Sighting:
    """When an object was last seen for sure.

    Attributes
    ----------
    carried : (3, 3) similarity from the key when the object was last whole. area : its area then, square pixels.
    middle : (2,) centroid of what was last seen of it. since : frames since then.
    """

    carried: Array
    area: float
    middle: Array
    since: int = 0

    @property
    def reach(self) -> float:
        """Pixels around `middle` in which the object may be."""
        return float(np.sqrt(self.area) * (NEAR + PACE * self.since))

    @property
    def is_worth_a_look(self) -> bool:
        """Whether to look for it on this frame: what has long been gone is looked for on some frames only."""
        return self.since <= LONG_GONE or self.since % SOMETIMES == 0

    def is_lost(self, region: Field) -> bool:
        """True when too little is left of the object to carry it on."""
        return area_of(region) <= LOST * self.area


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
class Lookout:
    """What an object looked like on the artist's key: its picture and region, and what follows from them."""

    frame: PreparedFrame
    region: Field

    @cached_property
    def middle(self) -> Array:
        """The centroid `(2,)` on the key."""
        return middle_of(self.region)

    @cached_property
    def rim(self) -> Array:
        """The places `(K, 2)` on the key between which all others of the object lie."""
        inside = self.region.inside
        rows = np.flatnonzero(inside.any(axis=1))
        ends = [inside[rows].argmax(axis=1), inside.shape[1] - 1 - inside[rows, ::-1].argmax(axis=1)]
        return self.region.grid.to_image(np.vstack([np.stack([end, rows], axis=1) for end in ends]) + 0.5)

    @cached_property
    def extent(self) -> float:
        """The root of its area on the key, in pixels."""
        return float(np.sqrt(area_of(self.region)))

    @cached_property
    def colours(self) -> GlobalModel:
        """Its colours against those of all the rest of the key's picture, not of its surroundings alone."""
        grid = Grid.over(_whole(self.frame), float(self.region.grid.factor.mean()))
        inside = self.region.on(grid) > 0.5
        return GlobalModel.learned(grid.of(self.frame.image), inside, ~inside)

    @cached_property
    def own_score(self) -> float:
        """How much the object looks like itself: the score of its place on the key."""
        cell = self.extent / ACROSS
        likeness = self._likeness(self.frame, np.eye(2), self.middle, 2.0 * cell)
        return likeness.best(self.middle, 2.0 * cell)[0]

    def found(self, frame: PreparedFrame, sighting: Sighting) -> Array | None:
        """The similarity `(3, 3)` from the key that puts the object where it is seen; None where it is not.

        Turn and size are those of the sighting, but for `SIZES`.
        """
        if self.extent < 1.0:
            return None
        near, reach = sighting.middle, sighting.reach
        turns = [size * sighting.carried[:2, :2] for size in SIZES]
        tried = each(lambda turn: self._likeness(frame, turn, near, reach), turns)
        seen = [likeness.best(near, reach) for likeness in tried]
        chosen = int(np.argmax([score for score, _ in seen]))
        score, place = seen[chosen]
        if not score >= max(ALIKE * self.own_score, 0.0):
            return None
        rival, _ = tried[chosen].best(near, reach, beyond=(place, float(np.sqrt(sighting.area))))
        if rival > ALONE * score:
            return None
        placed = np.eye(3)
        placed[:2, :2] = turns[chosen]
        placed[:2, 2] = place - turns[chosen] @ self.middle
        return placed

    def _likeness(self, frame: PreparedFrame, turn: Array, near: Array, reach: float) -> Likeness:
        """Mean log-ratio inside the outline, under `turn (2, 2)` and put everywhere, less that of its surroundings."""
        extent = self.extent * float(np.sqrt(abs(np.linalg.det(turn))))
        corners = (self.rim - self.middle) @ turn.T
        room = np.abs(corners).max(axis=0) + (RING + 2.0 / ACROSS) * extent
        spots = np.stack([near - reach - room, near + reach + room])
        area = Region.around(spots, 0.0, frame.size)
        if area.is_empty:
            return Likeness(np.full((1, 1), -np.inf, dtype=np.float32), Grid(Region(0, 0, 1, 1), 1, 1))
        grid = Grid.over(area, min(ACROSS / extent, 1.0))
        ratio = self.colours.log_ratio(grid.of(frame.image), CLIP)
        inside = self._template(turn, room, grid)
        width = 2 * max(round(RING * extent * float(grid.factor.mean())), 1) + 1
        around = cv2.dilate(inside, cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (width, width))) - inside
        inner, outer = (
            cv2.filter2D(ratio, cv2.CV_32F, part / max(float(part.sum()), 1e-6), borderType=cv2.BORDER_CONSTANT)
            for part in (inside, around)
        )
        return Likeness(np.asarray(inner - outer, dtype=np.float32), grid)

    def _template(self, turn: Array, room: Array, grid: Grid) -> Float32:
        """The object's coverage in cells of `grid` under `turn (2, 2)`, its middle in the middle."""
        columns, rows = (2 * int(np.ceil(value)) + 1 for value in room * grid.factor)
        placed = np.eye(3)
        placed[:2, :2] = np.diag(grid.factor) @ turn
        placed[:2, 2] = np.array([columns, rows]) / 2.0 - placed[:2, :2] @ self.middle
        canvas = Grid(Region(0, 0, columns, rows), rows, columns)
        return self.region.on(canvas, placed)


def area_of(region: Field) -> float:
    """Square pixels inside."""
    return np.count_nonzero(region.inside) / float(np.prod(region.grid.factor))


def middle_of(region: Field) -> Array:
    """The centroid `(2,)` of the inside, in the image; the middle of the grid where nothing is inside."""
    counts = [np.count_nonzero(region.inside, axis=axis) for axis in (0, 1)]
    if not counts[0].any():
        return region.grid.to_image(np.array([region.grid.columns, region.grid.rows]) / 2.0)
    return region.grid.to_image(np.array([np.average(np.arange(len(count)), weights=count) for count in counts]) + 0.5)


def _whole(frame: PreparedFrame) -> Region:
    return Region(0, 0, frame.size[1], frame.size[0])
