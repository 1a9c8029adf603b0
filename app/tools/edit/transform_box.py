"""Box: the transform box about points, what lies under the pointer on it, and the map that a drag of it means."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import affine, projective

from ...translation import N_, tr
from ..tool import Modifier, Pointer

Vector = tuple[float, float]

REACH = 7.0
"""Radius of the hit area of a handle, screen pixels."""

EDGE_REACH = 5.0
"""Half the width of a side's hit area, screen pixels."""

TURN_REACH = 24.0
"""How far outside of a corner a press still turns the box, screen pixels."""

STALK = 26.0
"""How far beyond its upper side the box carries the handle that turns it, screen pixels."""

LEAST_SIDE = 32.0
"""A side that has no length (one point, points in a row) is drawn this long, screen pixels."""

LEAST_FACTOR = 1e-3
"""No drag scales by less: points that fell together could never be told apart again."""

LEAST_DEPTH = 0.02
"""How near to the horizon a pinned corner takes anything, as a share of what lies farthest from it."""

PIN_HALVINGS = 40
"""How finely the place is looked for where a pinned corner is held before it would fold the box."""

SNAP_DEGREES = 15.0
CENTRE = (0.5, 0.5)
HANDLES: tuple[Vector, ...] = (
    (0.0, 0.0), (0.5, 0.0), (1.0, 0.0), (1.0, 0.5), (1.0, 1.0), (0.5, 1.0), (0.0, 1.0), (0.0, 0.5),
)  # fmt: skip
"""The places of the handles in the box, once around; corners are the even ones."""

IDENTITY = affine.translation((0.0, 0.0))


class Act(Enum):
    """What a drag of a part of the box does; the value is the undo step's first word."""

    MOVE = N_("Move")
    TURN = N_("Rotate")
    SCALE = N_("Scale")
    SHEAR = N_("Shear")
    PIN = N_("Corner pin")
    PIVOT = N_("Move pivot")


@dataclass(frozen=True)
class Part:
    """A part of the box: what dragging it does, and its place in the box (of a side: its middle)."""

    act: Act
    place: Vector = CENTRE


@dataclass(frozen=True, eq=False)
class Box:
    """A parallelogram, or a quadrilateral once a corner was pinned: `frame (3, 3)` carries the unit square to it.

    `pivot` is the place, in the box, about which it turns: (0, 0) the first corner, (1, 1) the one across.
    """

    frame: Array
    pivot: Vector = CENTRE
    pixel: Vector | None = None
    """That of the zoom by which a side without a length got one; None where both have their own."""

    @classmethod
    def around(cls, low: Vector, high: Vector, pixel: Vector, pivot: Vector = CENTRE) -> Box:
        """The upright box from `low` to `high`, image pixels; sides without a length get one that can be grabbed."""
        size, corner = np.subtract(high, low), np.array(low, dtype=np.float64)
        least = np.multiply(LEAST_SIDE, pixel)
        thin = size < 1e-6
        corner, size = np.where(thin, corner - least / 2, corner), np.where(thin, least, size)
        frame = np.array([[size[0], 0.0, corner[0]], [0.0, size[1], corner[1]], [0.0, 0.0, 1.0]])
        return cls(frame, pivot, pixel if thin.any() else None)

    @property
    def is_pinned(self) -> bool:
        """Whether it is no parallelogram."""
        return bool(self.frame[2, :2].any())

    @property
    def sides(self) -> Array:
        """The directions of its two sides in image pixels, as columns `(2, 2)`; between their middles where pinned."""
        if not self.is_pinned:
            return np.asarray(self.frame[:2, :2])
        across = self.at((1.0, 0.5)) - self.at((0.0, 0.5))
        return np.column_stack([across, self.at((0.5, 1.0)) - self.at((0.5, 0.0))])

    @property
    def corners(self) -> Array:
        """Its corners `(4, 2)`, once around."""
        return np.array([self.at(HANDLES[index]) for index in (0, 2, 4, 6)])

    def at(self, place: Vector) -> Array:
        """The image position `(2,)` of a place in the box."""
        return projective.apply(self.frame, place)

    def place(self, position: Vector) -> Array:
        """The place in the box of an image position."""
        if not self.is_pinned:
            corner = self.frame[:2, 2]
            return np.asarray(np.linalg.solve(self.sides, np.subtract(position, corner)), dtype=np.float64)
        return projective.apply(np.asarray(np.linalg.inv(self.frame), dtype=np.float64), position)

    def carried(self, matrix: Array) -> Box:
        """The box carried by `matrix`, `(2, 3)` or `(3, 3)`, its pivot with it."""
        whole = np.vstack([matrix, [0.0, 0.0, 1.0]]) if len(matrix) == 2 else matrix
        turns = not np.array_equal(whole[:, :2], np.eye(3)[:, :2])  # a box that is turned stays so at every zoom
        return replace(self, frame=whole @ self.frame, pixel=None if turns else self.pixel)

    def stalk(self, pixel: Vector) -> Array:
        """Where the handle that turns the box lies, image pixels: `STALK` beyond the middle of the first side."""
        middle = self.at((0.5, 0.0)) / pixel
        out = middle - self.at((0.5, 1.0)) / pixel
        return np.asarray((middle + out / max(float(np.hypot(*out)), 1e-9) * STALK) * pixel)

    def hit(self, pointer: Pointer) -> Part | None:
        """The part under the pointer: handles before the pivot, then what turns, the sides, the inside.

        With Ctrl a corner is pinned; with Shift besides it scales about the pivot.
        """

        def gap(position: Array) -> float:
            x, y = position.tolist()
            return pointer.screen_distance((x, y))

        handles = [Part(Act.SCALE, place) for place in HANDLES] + [Part(Act.PIVOT, self.pivot)]
        gaps = [gap(self.at(handle.place)) for handle in handles]
        nearest = int(np.argmin(gaps))
        if gaps[nearest] <= REACH:
            part = handles[nearest]
            is_corner = part.act is Act.SCALE and CENTRE[0] not in part.place
            pins = pointer.holds(Modifier.ControlModifier) and not pointer.holds(Modifier.ShiftModifier)
            return replace(part, act=Act.PIN) if is_corner and pins else part
        if gap(self.stalk(pointer.pixel)) <= REACH:
            return Part(Act.TURN)
        sides = [(gap(self._nearest_on_side(index, pointer)), HANDLES[index + 1]) for index in (0, 2, 4, 6)]
        side_gap, side = min(sides)
        if side_gap <= EDGE_REACH:
            return Part(Act.SHEAR, side)
        u, v = self.place(pointer.position).tolist()
        if 0.0 <= u <= 1.0 and 0.0 <= v <= 1.0:
            return Part(Act.MOVE)
        corners = min(gap(self.at(HANDLES[index])) for index in (0, 2, 4, 6))
        return Part(Act.TURN) if corners <= TURN_REACH else None

    def _nearest_on_side(self, index: int, pointer: Pointer) -> Array:
        """The position nearest to the pointer on the side that begins at handle `index`, on the screen."""
        a = self.at(HANDLES[index]) / pointer.pixel
        run = self.at(HANDLES[(index + 2) % 8]) / pointer.pixel - a
        along = float(
            np.clip((np.divide(pointer.position, pointer.pixel) - a) @ run / max(float(run @ run), 1e-9), 0.0, 1.0)
        )
        return np.asarray((a + along * run) * pointer.pixel)


@dataclass(frozen=True)
class Pull:
    """The map that a drag of a part of the box means, affine `(2, 3)` or projective `(3, 3)`, and how to say it."""

    matrix: Array
    sentence: str


def pulled(box: Box, part: Part, pressed: Pointer, pointer: Pointer, held: Array) -> Pull:
    """What a drag of `part` from `pressed` to `pointer` does to a box, and to what it holds, at `held (K, 2)`.

    Shift: a move or a pinned corner along one axis, a turn by 15 degrees, a scaling that keeps proportions. Ctrl:
    scaling and shear about the pivot instead of the side or corner across.
    """
    if part.act is Act.PIN:
        return _pinned(box, part.place, _along_axis(pressed, pointer), held)
    if part.act is Act.TURN:
        return _turned(box, pressed, pointer)
    if part.act is Act.SCALE:
        return _scaled(box, part.place, pressed, pointer)
    if part.act is Act.SHEAR:
        return _sheared(box, part.place, pressed, pointer)
    return _moved(pressed, pointer)


def _moved(pressed: Pointer, pointer: Pointer) -> Pull:
    dx, dy = _along_axis(pressed, pointer)
    return Pull(affine.translation((dx, dy)), tr("Move {dx:+.1f}, {dy:+.1f} px", dx=dx, dy=dy))


def _turned(box: Box, pressed: Pointer, pointer: Pointer) -> Pull:
    # On the screen, where a turn keeps its form also when the plate's pixels are not square.
    to_screen = np.diag(np.divide(1.0, pointer.pixel))
    pivot = box.at(box.pivot)
    begun, now = (np.arctan2(*(to_screen @ np.subtract(each.position, pivot))[::-1]) for each in (pressed, pointer))
    degrees = (float(np.degrees(now - begun)) + 180.0) % 360.0 - 180.0
    if pointer.holds(Modifier.ShiftModifier):
        degrees = round(degrees / SNAP_DEGREES) * SNAP_DEGREES
    linear = affine.along(np.linalg.inv(to_screen), affine.rotation(degrees, (0.0, 0.0))[:, :2])
    return Pull(affine.about(linear, pivot), tr("Rotate {degrees:+.1f}°", degrees=degrees))


def _scaled(box: Box, place: Vector, pressed: Pointer, pointer: Pointer) -> Pull:
    fixed = _fixed(box, place, pointer)
    arm = _arm(box, fixed, place)
    reach = arm + np.linalg.solve(box.sides, _delta(pressed, pointer))
    if pointer.holds(Modifier.ShiftModifier):
        before, after = box.sides @ arm / pointer.pixel, box.sides @ reach / pointer.pixel  # as it is seen
        length = float(before @ before)
        factors = np.full(2, float(after @ before) / length if length > 1e-12 else 1.0)
    else:
        # A handle in the middle of a side pulls across it only; one that lies on the fixed place pulls nothing.
        pulls = (np.abs(arm) > 1e-9) & (np.asarray(place) != 0.5)
        factors = np.where(pulls, reach / np.where(pulls, arm, 1.0), 1.0)
    factors = np.where(factors < 0.0, -1.0, 1.0) * np.maximum(np.abs(factors), LEAST_FACTOR)
    linear = affine.along(box.sides, np.diag(factors))
    return Pull(
        affine.about(linear, box.at(fixed)),
        tr("Scale {x:.1f} %, {y:.1f} %", x=100.0 * float(factors[0]), y=100.0 * float(factors[1])),
    )


def _sheared(box: Box, place: Vector, pressed: Pointer, pointer: Pointer) -> Pull:
    fixed = _fixed(box, place, pointer)
    along = 0 if place[0] == 0.5 else 1
    arm = float(_arm(box, fixed, place)[1 - along])
    slip = float(np.linalg.solve(box.sides, _delta(pressed, pointer))[along])
    amount = slip / arm if abs(arm) > 1e-9 else 0.0
    linear = np.eye(2)
    linear[along, 1 - along] = amount
    return Pull(
        affine.about(affine.along(box.sides, linear), box.at(fixed)),
        tr("Shear {percent:+.1f} %", percent=100.0 * amount),
    )


def _fixed(box: Box, place: Vector, pointer: Pointer) -> Vector:
    """The place that stays: the pivot with Ctrl, else what lies across."""
    return box.pivot if pointer.holds(Modifier.ControlModifier) else (1.0 - place[0], 1.0 - place[1])


def _arm(box: Box, fixed: Vector, place: Vector) -> Array:
    """From the fixed place to another one, measured by the box's sides."""
    if not box.is_pinned:
        return np.subtract(place, fixed)
    return np.asarray(np.linalg.solve(box.sides, box.at(place) - box.at(fixed)))


def _pinned(box: Box, place: Vector, delta: Vector, held: Array) -> Pull:
    """One corner goes along and the others stay; it is held where the box, or what it holds, would fold."""
    index = HANDLES[::2].index(place)

    def pull(share: float) -> Array | None:
        corners = box.corners
        corners[index] += share * np.asarray(delta)
        try:
            frame = projective.of_square(corners)
        except ValueError:
            return None
        matrix = np.asarray(frame @ np.linalg.inv(box.frame))
        is_flat = _is_flat(projective.depth(frame, HANDLES[::2])) and _is_flat(projective.depth(matrix, held))
        return matrix if is_flat else None

    low, matrix = 0.0, pull(1.0)
    if matrix is None:
        high, matrix = 1.0, np.eye(3)
        for _ in range(PIN_HALVINGS):
            middle = (low + high) / 2
            if (there := pull(middle)) is None:
                high = middle
            else:
                low, matrix = middle, there
    else:
        low = 1.0
    dx, dy = low * delta[0], low * delta[1]
    return Pull(matrix, tr("Corner pin {dx:+.1f}, {dy:+.1f} px", dx=dx, dy=dy))


def _is_flat(depths: Array) -> bool:
    """Whether places of these depths lie well before the horizon."""
    return bool(depths.min() >= LEAST_DEPTH * depths.max() > 0.0)


def _along_axis(pressed: Pointer, pointer: Pointer) -> Vector:
    """How far the pointer went; with Shift along one axis."""
    dx, dy = _delta(pressed, pointer).tolist()
    if pointer.holds(Modifier.ShiftModifier):
        return (dx, 0.0) if abs(dx / pointer.pixel[0]) >= abs(dy / pointer.pixel[1]) else (0.0, dy)
    return dx, dy


def _delta(pressed: Pointer, pointer: Pointer) -> Array:
    return np.subtract(pointer.position, pressed.position)
