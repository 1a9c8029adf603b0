"""The data of an SVG path, and the basic shapes, as splines of ours: every command becomes cubic Bezier segments."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.interchange.svg.words import NUMBER, decimal, number

Place = tuple[float, float]

CIRCLE = 4.0 / 3.0 * math.tan(math.pi / 8.0)
"""Length of the handles of a quarter of the unit circle."""

PER_COMMAND, PER_ARC = 2, 48
"""Parts that a command of a path counts for."""

ARGUMENTS = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7, "Z": 0}


@dataclass
class Spline:
    """One outline in the making: rows of anchor, incoming and outgoing handle."""

    rows: list[list[Place]]
    closed: bool = False

    def line_to(self, place: Place) -> None:
        self.rows.append([place, place, place])

    def curve_to(self, out: Place, into: Place, place: Place) -> None:
        self.rows[-1][2] = out
        self.rows.append([place, into, place])

    def close(self) -> None:
        """Close the outline; an end that lies on the beginning is one point with it."""
        self.closed = True
        if len(self.rows) > 1 and self.rows[-1][0] == self.rows[0][0]:
            self.rows[0][1] = self.rows.pop()[1]

    @property
    def points(self) -> Array:
        """Spline points `(P, 3, 2)`."""
        return np.array(self.rows, dtype=np.float64)


@dataclass
class _Pen:
    """Follows the commands of a path."""

    splines: list[Spline] = field(default_factory=list)
    at: Place = (0.0, 0.0)
    start: Place = (0.0, 0.0)
    control: Place | None = None
    """The last control point, of which `S` and `T` take the mirror image; None after other commands."""

    command: str = ""

    def do(self, letter: str, values: list[float]) -> None:
        """Carry out one command; lower-case letters count from where the pen is."""
        kind = letter.upper()
        if letter.islower() and kind not in "HVAZ":
            values = [value + self.at[k % 2] for k, value in enumerate(values)]
        places = list(zip(values[::2], values[1::2], strict=False))
        if kind == "M":
            self._move(places[0])
        elif kind == "Z":
            self._close()
        else:
            self._draw(kind, letter.islower(), values, places)
        self.command = kind

    def _move(self, place: Place) -> None:
        self.at = self.start = place
        self.splines.append(Spline([[place, place, place]]))

    def _close(self) -> None:
        if self.splines:
            self.splines[-1].close()
        self.at = self.start

    def _draw(self, kind: str, relative: bool, values: list[float], places: list[Place]) -> None:
        if not self.splines:
            raise ValueError("a path must begin with M")
        if self.splines[-1].closed:  # a command after Z goes on from its start
            self._move(self.start)
        spline, at = self.splines[-1], self.at
        if kind == "L":
            end = places[0]
            spline.line_to(end)
        elif kind in "HV":
            axis = "HV".index(kind)
            value = values[0] + (at[axis] if relative else 0.0)
            end = (value, at[1]) if kind == "H" else (at[0], value)
            spline.line_to(end)
        elif kind == "A":
            end = (values[5] + at[0], values[6] + at[1]) if relative else (values[5], values[6])
            _arc(spline, at, values, end)
        else:
            end = self._curve(spline, kind, places)
        self.at = end

    def _curve(self, spline: Spline, kind: str, places: list[Place]) -> Place:
        if kind in "ST":
            family = "CS" if kind == "S" else "QT"
            mirrored = self.command != "" and self.command in family and self.control is not None
            control = self.control if mirrored and self.control is not None else self.at
            places = [(2 * self.at[0] - control[0], 2 * self.at[1] - control[1]) if mirrored else self.at, *places]
        if kind in "CS":
            out, into, end = places
            self.control = into
        else:
            self.control, end = places
            out, into = _towards(self.at, self.control, 2 / 3), _towards(end, self.control, 2 / 3)
        spline.curve_to(out, into, end)
        return end


def path_data(points: Array, closed: bool) -> str:
    """Points `(P, 3, 2)` as the data of a path; the segment that closes it is written out, for its handles' sake."""
    points = np.concatenate([points, points[:1]]) if closed else points
    words = [f"M {_pair(points[0, ANCHOR])}"]
    for start, end in pairwise(points):
        is_straight = (start[OUT] == start[ANCHOR]).all() and (end[IN] == end[ANCHOR]).all()
        places = [end[ANCHOR]] if is_straight else [start[OUT], end[IN], end[ANCHOR]]
        words.append(" ".join(["L" if is_straight else "C", *(_pair(place) for place in places)]))
    return " ".join([*words, "Z"] if closed else words)


def _pair(place: Array) -> str:
    return f"{decimal(float(place[0]))},{decimal(float(place[1]))}"


def parsed_path(text: str, count: Callable[[int], None] = lambda _: None) -> tuple[list[Spline], bool]:
    """The outlines of a path's data, and whether all of it was understood: what stands before a mistake counts.

    `count` is told of the parts of every command before it is carried out, and may refuse.
    """
    pen, position, letter = _Pen(), 0, ""
    while position < len(text):
        found = _COMMAND.match(text, position)
        if found is None:
            break
        position = found.end()
        if found.group(1):
            letter = found.group(1)
        elif letter == "" or letter in "Zz":
            return pen.splines, _END.match(text, position) is not None
        count(PER_ARC if letter in "Aa" else PER_COMMAND)
        try:
            values, position = _arguments(text, position, letter.upper())
            if not values and letter not in "Zz":
                raise ValueError("a command without its numbers")
            pen.do(letter, values)
        except ValueError:
            return pen.splines, False
        letter = {"M": "L", "m": "l"}.get(letter, letter)
        if _END.match(text, position):
            return pen.splines, True
    return pen.splines, True


_END = re.compile(r"[\s,]*+\Z")
_COMMAND = re.compile(r"[\s,]*([MmLlHhVvCcSsQqTtAaZz])?")
_NUMBER = re.compile(rf"[\s,]*({NUMBER})")
_FLAG = re.compile(r"[\s,]*([01])")


def _arguments(text: str, position: int, kind: str) -> tuple[list[float], int]:
    """The numbers of one command; the two flags of an arc are one digit each and may touch what follows."""
    values: list[float] = []
    for k in range(ARGUMENTS[kind]):
        found = (_FLAG if kind == "A" and k in (3, 4) else _NUMBER).match(text, position)
        if found is None:
            raise ValueError(f"{kind} wants {ARGUMENTS[kind]} numbers")
        values.append(number(found.group(1)))
        position = found.end()
    return values, position


def ellipse(x: float, y: float, rx: float, ry: float) -> Spline:
    """A full ellipse as four points."""
    rows: list[list[Place]] = []
    for cos, sin in ((1, 0), (0, 1), (-1, 0), (0, -1)):
        dx, dy = -sin * rx * CIRCLE, cos * ry * CIRCLE
        at = (x + cos * rx, y + sin * ry)
        rows.append([at, (at[0] - dx, at[1] - dy), (at[0] + dx, at[1] + dy)])
    return Spline(rows, closed=True)


def rectangle(x: float, y: float, width: float, height: float, rx: float, ry: float) -> Spline:
    """A rectangle, its corners rounded where both radii are positive."""
    rx, ry = min(rx, width / 2.0), min(ry, height / 2.0)
    right, bottom = x + width, y + height
    if rx <= 0.0 or ry <= 0.0:
        return polygon([(x, y), (right, y), (right, bottom), (x, bottom)], closed=True)
    spline = Spline([[(x + rx, y)] * 3])
    kx, ky = rx * (1.0 - CIRCLE), ry * (1.0 - CIRCLE)
    spline.line_to((right - rx, y))
    spline.curve_to((right - kx, y), (right, y + ky), (right, y + ry))
    spline.line_to((right, bottom - ry))
    spline.curve_to((right, bottom - ky), (right - kx, bottom), (right - rx, bottom))
    spline.line_to((x + rx, bottom))
    spline.curve_to((x + kx, bottom), (x, bottom - ky), (x, bottom - ry))
    spline.line_to((x, y + ry))
    spline.curve_to((x, y + ky), (x + kx, y), (x + rx, y))
    spline.close()
    return spline


def polygon(places: list[Place], *, closed: bool) -> Spline:
    """Straight lines from place to place."""
    return Spline([[place] * 3 for place in places], closed)


def _towards(start: Place, end: Place, share: float) -> Place:
    return (start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1]))


def _arc(spline: Spline, start: Place, values: list[float], end: Place) -> None:
    """An elliptical arc from where the pen is to `end`, in pieces of at most a quarter turn.

    The arc is that of a unit circle in coordinates that are turned and scaled so that the ellipse becomes one.
    """
    rx, ry, turn, is_large, is_positive = abs(values[0]), abs(values[1]), math.radians(values[2]), values[3], values[4]
    if start == end:
        return
    if rx == 0.0 or ry == 0.0:
        spline.line_to(end)
        return
    spread = np.array([[rx * math.cos(turn), -ry * math.sin(turn)], [rx * math.sin(turn), ry * math.cos(turn)]])
    a, b = (np.linalg.solve(spread, np.array(place)) for place in (start, end))
    half = (b - a) / 2.0
    reach = float(half @ half)
    if reach > 1.0:  # radii too small to reach: both are grown until they do
        spread, a, b, half = (
            spread * math.sqrt(reach),
            a / math.sqrt(reach),
            b / math.sqrt(reach),
            half / math.sqrt(reach),
        )
        reach = 1.0
    away = math.sqrt(max(1.0 / reach - 1.0, 0.0)) * np.array([-half[1], half[0]])
    centre = (a + b) / 2.0 + (away if bool(is_large) != bool(is_positive) else -away)
    first = math.atan2(a[1] - centre[1], a[0] - centre[0])
    sweep = (math.atan2(b[1] - centre[1], b[0] - centre[0]) - first) % (2.0 * math.pi)
    if not is_positive:
        sweep -= 2.0 * math.pi
    pieces = max(math.ceil(abs(sweep) / (math.pi / 2.0) - 1e-9), 1)
    step = sweep / pieces
    handle = 4.0 / 3.0 * math.tan(step / 4.0)
    for piece in range(pieces):
        angles = np.array([first + piece * step, first + (piece + 1) * step])
        on = centre + np.stack([np.cos(angles), np.sin(angles)], axis=1)
        along = handle * np.stack([-np.sin(angles), np.cos(angles)], axis=1)
        control = np.array([on[0] + along[0], on[1] - along[1], on[1]]) @ spread.T
        out, into, place = ((float(x), float(y)) for x, y in control)
        spline.curve_to(out, into, end if piece == pieces - 1 else place)
