"""MagneticTool: a line that clings to the edges of the picture between clicks, and the spline fitted to it."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import count
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QPointF
from PySide6.QtGui import QPainter, QPainterPath

from roam_core.arrays import Array
from roam_core.geometry.stroke import StrokeFit
from roam_core.roto import edit

from ...features.verbs.finishing import finish_shape, next_colour
from ...jobs.picture_work import Shown
from ...jobs.runner import Report
from ...model.document import Document
from ...model.view_state import ViewState
from ...paint import marks
from ...paint.outline_paths import outline_path
from ...paint.viewport import Viewport
from ...translation import N_, tr
from ..hit_test import REACH
from ..tool import Modifier, Pointer
from .placing import FINISH_KEYS, TAKE_BACK_KEYS, TOO_FEW, PlacingTool

if TYPE_CHECKING:
    from roam_core.proposal.assist.livewire import LiveWire

Spot = tuple[float, float]

SNAP = 7.0
"""Screen pixels within which a click goes to the strongest edge."""

SIGHT, LEAST_SIGHT = 220.0, 48.0
"""Screen pixels around the last point in which edges are looked for; at least this many of the picture."""

TOLERANCE = 1.5
"""Screen pixels (pixels of the picture where these are larger) by which the spline may stray from the line."""

KEPT = 0.7
"""Share of the line that is kept when the pointer leaves the sight of the last point: there a new one is put."""


@dataclass(eq=False)
class Leg:
    """The line from one point to the next: `end` and `path (K, 2)` are None while it follows the pointer.

    `wire` gives its paths; it is None until the worker has made it, and again once the path is settled.
    """

    start: Spot
    end: Spot | None = None
    path: Array | None = None
    wire: LiveWire | None = None
    is_straight: bool = False

    def led_to(self, spot: Spot, scale: Array, straight: bool = False) -> Array:
        """Its line `(K, 2)` to a place, image pixels: along edges, or straight where it must be."""
        if self.wire is None or straight or self.is_straight:
            return np.array([self.start, spot])
        x, y = (np.array(spot) / scale).tolist()
        line: Array = self.wire.path((x, y)) * scale
        return np.vstack([[self.start], line[1:-1], [spot]])


class MagneticTool(PlacingTool):
    """Clicks place points, the line between them clings to edges; with Ctrl it is straight.

    Where the pointer goes far, points are placed on the way. A press on the first point, Return or a double click
    closes the shape, Esc or another tool leaves it open, Backspace takes the last point back.
    """

    name = "magnetic"
    title = N_("Magnetic lasso")
    hint = N_("Click along an edge: the line clings to it, straight with Ctrl. Return or the first point closes.")

    def __init__(self, document: Document, view_state: ViewState) -> None:
        super().__init__(document, view_state)
        self._legs: list[Leg] = []
        self._pixel = self._finest = np.ones(2)
        self._shown: Shown | None = None
        self._scale = np.ones(2)
        self._frame = 0
        self._closing: bool | None = None
        self._fit = StrokeFit(TOLERANCE)
        self._numbers = count()

    @property
    def legs(self) -> tuple[Leg, ...]:
        """The line so far; the last leg follows the pointer."""
        return tuple(self._legs)

    @property
    def points(self) -> Array:
        """The spline `(P, 3, 2)` of what is laid, as it will come out; where a press would close it, of the whole."""
        paths = [leg.led_to(leg.end, self._scale) if leg.path is None else leg.path for leg in self._legs if leg.end]
        closes = self._hover is not None and self._closing is None and self._closes(self._hover)
        if closes and self._hover is not None:
            paths.append(self._live(self._hover, closes))
        return self._points(paths, closes) if paths else np.empty((0, 3, 2))

    @property
    def is_begun(self) -> bool:
        return bool(self._legs)

    def deactivate(self) -> None:
        self._finish(closed=False)
        if self._legs:
            self._settle(wait=False)

    def drop(self) -> None:
        self._legs, self._shown, self._closing = [], None, None

    def press(self, pointer: Pointer) -> None:
        self._feel(pointer)
        if self._closing is not None:
            return
        if not self._legs:
            self._begin(pointer)
        elif self._closes(pointer):
            self._finish(closed=True)
        else:
            self._place(self._snapped(pointer), straight=pointer.holds(Modifier.ControlModifier))

    def double_press(self, pointer: Pointer) -> None:
        """Close the shape, whose last point the first press has placed."""
        if len(self._legs) > 1:
            self._finish(closed=True)

    def drag(self, pointer: Pointer) -> None:
        self.hover(pointer)

    def hover(self, pointer: Pointer) -> None:
        self._feel(pointer)
        self._go_on()

    def take_back(self) -> bool:
        if not self._legs:
            return False
        if self._closing is not False:  # what was left open waits without the leg that followed the pointer
            self._legs.pop()
        if self._legs:
            start = self._legs.pop().start
            self._closing = None
            self._follow_from(start)
        return True

    def key(self, name: str) -> None:
        if name in TAKE_BACK_KEYS:
            self.take_back()
        else:
            self._finish(closed=name in FINISH_KEYS)

    # ---- the line

    def _feel(self, pointer: Pointer) -> None:
        self._hover, self._pixel = pointer, np.array(pointer.pixel)
        # The nearest look counts for the fit: who steps back to close the shape keeps what was laid closer by.
        self._finest = np.minimum(self._finest, self._pixel) if self._legs else self._pixel

    def _begin(self, pointer: Pointer) -> None:
        shown = self.pictures.shown if self.pictures is not None else None
        if shown is None or shown.frame != self.view_state.frame:
            self.view_state.say_here(tr("There is no picture of this frame to find edges in (yet)."))
            return
        self._shown, self._frame = shown, shown.frame
        self._scale = np.array(shown.scale(self.document.project.require_clip().size))
        self._follow_from(self._snapped(pointer))

    def _follow_from(self, start: Spot) -> None:
        """A new leg that follows the pointer, as soon as the worker has looked around its start."""
        assert self._shown is not None
        assert self.pictures is not None
        leg = Leg(start)
        self._legs.append(leg)
        pixels, seed = self._shown.pixels, np.array(start) / self._scale
        pixel = float((self._pixel / self._scale).max())

        def look(_: Report) -> LiveWire:
            from roam_core.proposal.assist.livewire import LiveWire

            return LiveWire.around(pixels, tuple(seed.tolist()), max(SIGHT * pixel, LEAST_SIGHT), max(pixel, 1.0))

        job = self.pictures.find(f"wire {next(self._numbers)}", look, lambda wire: self._take(leg, wire))
        # Whatever ends without a wire leaves a straight line: the artist is never kept waiting for it.
        job.ended.connect(lambda *_: self._take(leg, None) if leg.wire is None and leg.path is None else None)

    def _take(self, leg: Leg, wire: LiveWire | None) -> None:
        """The worker has looked around the start of a leg; without a `wire` it stays straight."""
        if leg not in self._legs:
            return
        leg.wire, leg.is_straight = wire, leg.is_straight or wire is None
        self._settle()
        self._go_on()

    def _go_on(self) -> None:
        """Put a point on the way where the pointer left the sight of the last one."""
        if not self._legs or self._hover is None or self._closing is not None:
            return
        leg, pointer = self._legs[-1], self._hover
        x, y = (np.array(pointer.position) / self._scale).tolist()
        if leg.wire is None or leg.wire.holds((x, y)) or pointer.holds(Modifier.ControlModifier):
            return
        line = leg.led_to(pointer.position, self._scale)
        kept = line[: max(2, round(KEPT * (len(line) - 1)))]
        if len(kept) > 2:
            leg.path, leg.end, leg.wire = kept, (float(kept[-1, 0]), float(kept[-1, 1])), None
            self._follow_from(leg.end)

    def _place(self, spot: Spot, straight: bool) -> None:
        leg = self._legs[-1]
        leg.end, leg.is_straight = spot, leg.is_straight or straight
        self._settle()
        self._follow_from(spot)

    def _settle(self, wait: bool = True) -> None:
        """Lay the lines whose ends and wires are known, or all of them without `wait`; then finish, if that waits."""
        for leg in self._legs:
            if leg.end is not None and leg.path is None and (leg.wire or leg.is_straight or not wait):
                leg.path, leg.wire = leg.led_to(leg.end, self._scale), None
        if self._closing is not None and all(leg.path is not None for leg in self._legs):
            self._make_shape(self._closing)

    def _finish(self, closed: bool) -> None:
        if self._closing is not None or not self._legs:
            return
        if self._is_on_one_spot:
            self.drop()
            return
        if closed and len({leg.start for leg in self._legs}) < edit.MIN_POINTS_CLOSED:
            self.view_state.say(tr(TOO_FEW, min_points_closed=edit.MIN_POINTS_CLOSED))
            return
        self._closing = closed
        if closed:
            self._legs[-1].end = self._legs[0].start
        else:
            self._legs.pop()
        self._settle()

    def _make_shape(self, closed: bool) -> None:
        points, frame = self._points([leg.path for leg in self._legs if leg.path is not None], closed), self._frame
        # Laid down first: taking the select tool finishes what is in the hand.
        self.drop()
        finish_shape(self.document, self.view_state, self.name, points, frame, closed=closed)

    def _points(self, paths: list[Array], closed: bool) -> Array:
        """The spline `(P, 3, 2)` of these lines, one after the other; `closed` where the last ends at the first."""
        line, unit = np.vstack([path[k > 0 :] for k, path in enumerate(paths)]), np.maximum(self._finest, self._scale)
        return self._fit.points((line[:-1] if closed else line) / unit, closed=closed) * unit

    def _snapped(self, pointer: Pointer) -> Spot:
        """The strongest edge near the pointer; with Ctrl the pointer's own place."""
        from roam_core.proposal.assist.livewire import snapped

        if self._shown is None or pointer.holds(Modifier.ControlModifier):
            return pointer.position
        x, y = (np.array(pointer.position) / self._scale).tolist()
        reach = SNAP * float((np.array(pointer.pixel) / self._scale).max())
        found = snapped(self._shown.pixels, (x, y), reach)
        if found == (x, y):
            return pointer.position
        a, b = (np.array(found) * self._scale).tolist()
        return a, b

    def _closes(self, pointer: Pointer) -> bool:
        is_far_enough = len(self._legs) > 2 and not self._is_on_one_spot
        return is_far_enough and pointer.screen_distance(self._legs[0].start) <= REACH

    @property
    def _is_on_one_spot(self) -> bool:
        """True while nothing is laid but one point, however often it was clicked."""
        return len({leg.start for leg in self._legs}) < 2

    # ---- painting

    def paint(self, painter: QPainter, viewport: Viewport) -> None:
        if not self._legs:
            return
        colour = next_colour(self.document.project)
        closes = self._hover is not None and self._closing is None and self._closes(self._hover)
        points = self.points
        if len(points):
            path = viewport.transform.map(outline_path(points, closes))
            marks.stroke(painter, path, colour, marks.SELECTED_WIDTH)
        if self._hover is not None and self._closing is None and not closes:
            live = viewport.transform.map(_traced(self._live(self._hover, closes)))
            marks.stroke(painter, live, marks.faded(colour, 0.85), marks.OUTLINE_WIDTH)
        for index, leg in enumerate(self._legs):
            grown, last = closes and index == 0, index == len(self._legs) - 1
            marks.anchor(
                painter, viewport.to_widget(*leg.start), colour, round_=False, filled=last or grown, grown=grown
            )

    def _live(self, pointer: Pointer, closes: bool) -> Array:
        """The line that a press would make."""
        straight = pointer.holds(Modifier.ControlModifier)
        spot = self._legs[0].start if closes else self._snapped(pointer)
        return self._legs[-1].led_to(spot, self._scale, straight)


def _traced(line: Array) -> QPainterPath:
    path = QPainterPath(QPointF(*line[0]))
    for spot in line[1:].tolist():
        path.lineTo(*spot)
    return path
