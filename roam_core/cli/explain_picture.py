"""The picture of `roam explain`: outline, nodes and landmarks over the frame, coloured by what a term says there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import cv2
import numpy as np

from roam_core.arrays import Array, Indices, UInt8
from roam_core.features import Region
from roam_core.geometry import bezier

if TYPE_CHECKING:  # numba: a command's help must not wait for it
    from roam_core.propagate.explain import Explanation

Colour = tuple[int, int, int]

TOTAL = "total"
WIDEST, LARGEST = 1600.0, 8.0
"""Pixels of the picture's longer side, and the greatest enlargement."""
LEGEND = 84
"""Height of the legend in pixels."""
GOOD, EVEN, BAD = (54, 110, 240), (244, 240, 214), (226, 48, 40)
"""RGB from where a term favours the outline to where it costs most or speaks against it."""
ROOM = (26.0, 16.0)
"""Width and height in pixels that a number takes up."""
WHITE, BLACK, GREY = (255, 255, 255), (0, 0, 0), (170, 170, 170)
FRACTION = 4
"""Bits of a fraction of a pixel in which OpenCV is told positions."""


def choices(explanations: Sequence[Explanation]) -> list[str]:
    """The terms that can be drawn: all that any of the shapes has, and their total."""
    names = dict.fromkeys(name for each in explanations for name in each.account.sums)
    return [*names, TOTAL]


def drawn(image: UInt8, explanations: Sequence[Explanation], term: str) -> UInt8:
    """The frame around the outlines `(h, w, 3)` RGB, enlarged, with a legend below it.

    Nodes and the edges between them are coloured by `term`, landmarks (diamonds with their ids) likewise; nodes without
    a value, such as those of an artist's key, are grey. White squares are the artist's points, with their numbers.
    """
    canvas = _Canvas.around(image, np.vstack([each.account.nodes for each in explanations]))
    scales = _Scale.of(explanations, term)
    for each in explanations:
        _draw_outline(canvas, each, _node_values(each, term), scales)
        _draw_points(canvas, each)
    for each in explanations:
        _draw_landmarks(canvas, each, _landmark_values(each, term), scales)
    return np.vstack([canvas.pixels, _legend(canvas.pixels.shape[1], explanations, term, scales)])


@dataclass(frozen=True, eq=False)
class _Canvas:
    """Enlarged, paled pixels of a part of the image whose top-left corner is `origin`."""

    pixels: UInt8
    origin: Array
    factor: float

    @classmethod
    def around(cls, image: UInt8, nodes: Array) -> _Canvas:
        height, width = image.shape[:2]
        near = np.clip(nodes, 0.0, (width, height))
        margin = max(24.0, 0.2 * float(np.ptp(near, axis=0).max()))
        area = Region.around(near, margin, (height, width))
        rows, columns = area.slices
        part = image[rows, columns]
        factor = min(WIDEST / max(part.shape[:2]), LARGEST)
        size = (max(1, round(part.shape[1] * factor)), max(1, round(part.shape[0] * factor)))
        large = cv2.resize(part, size, interpolation=cv2.INTER_CUBIC if factor > 1 else cv2.INTER_AREA)
        grey = cv2.cvtColor(cv2.cvtColor(large, cv2.COLOR_RGB2GRAY), cv2.COLOR_GRAY2RGB)
        pale = cv2.addWeighted(large, 0.35, grey, 0.3, 0.0)
        return cls(np.ascontiguousarray(pale), np.asarray(area.origin, dtype=np.float64), factor)

    def at(self, positions: Array) -> Indices:
        """Positions in the image as OpenCV wants them for drawing: from pixel centres, in fractions of a pixel."""
        here = (positions - self.origin) * self.factor - 0.5
        return np.asarray(np.rint(here * (1 << FRACTION)), dtype=np.intp)


@dataclass(frozen=True)
class _Scale:
    """Values from `low` to `high` as colours; where more is better, `high` has the good one."""

    low: float
    high: float
    more_is_better: bool

    @classmethod
    def of(cls, explanations: Sequence[Explanation], term: str) -> tuple[_Scale, _Scale]:
        """Those of nodes and of landmarks: from the least to the greatest but for a few outliers."""
        better = any(each.account.more_is_better for each in explanations)
        return (
            cls._over([_node_values(each, term) for each in explanations], more_is_better=better),
            cls._over([_landmark_values(each, term) for each in explanations], more_is_better=False),
        )

    @classmethod
    def _over(cls, parts: list[Array | None], *, more_is_better: bool) -> _Scale:
        known = [part for part in parts if part is not None and len(part)]
        low, high = np.percentile(np.concatenate(known), [3.0, 97.0]) if known else (0.0, 0.0)
        return cls(float(low), float(high), more_is_better)

    def colour(self, value: float) -> Colour:
        u = float(np.clip((value - self.low) / max(self.high - self.low, 1e-12), 0.0, 1.0))
        u = 1.0 - u if self.more_is_better else u
        start, stop, v = (GOOD, EVEN, 2.0 * u) if u < 0.5 else (EVEN, BAD, 2.0 * u - 1.0)
        red, green, blue = (round((1.0 - v) * a + v * b) for a, b in zip(start, stop, strict=True))
        return red, green, blue


def _node_values(each: Explanation, term: str) -> Array | None:
    if term == TOTAL:
        return each.account.total if each.account.terms else None
    return each.account.terms.get(term)


def _landmark_values(each: Explanation, term: str) -> Array | None:
    if each.account.landmarks is None:
        return None
    return each.account.landmark_total if term == TOTAL else each.account.landmarks.terms.get(term)


def _draw_outline(canvas: _Canvas, each: Explanation, values: Array | None, scales: tuple[_Scale, _Scale]) -> None:
    places = canvas.at(each.account.nodes)
    count = len(places)
    means = None if values is None else 0.5 * (values + np.roll(values, -1))
    ends = [(tuple(map(int, places[n])), tuple(map(int, places[(n + 1) % count]))) for n in range(count)]
    for start, stop in ends:
        cv2.line(canvas.pixels, start, stop, BLACK, 6, cv2.LINE_AA, FRACTION)
    for n, (start, stop) in enumerate(ends):
        cv2.line(canvas.pixels, start, stop, _tint(means, n, scales[0]), 3, cv2.LINE_AA, FRACTION)
    for n, (place, _) in enumerate(ends):
        cv2.circle(canvas.pixels, place, 7 << FRACTION, BLACK, -1, cv2.LINE_AA, FRACTION)
        cv2.circle(canvas.pixels, place, 5 << FRACTION, _tint(values, n, scales[0]), -1, cv2.LINE_AA, FRACTION)


def _tint(values: Array | None, n: int, scale: _Scale) -> Colour:
    return GREY if values is None else scale.colour(float(values[n]))


def _draw_points(canvas: _Canvas, each: Explanation) -> None:
    """The artist's points with their numbers, outside of the outline where there is room."""
    anchors = each.key.points[:, bezier.ANCHOR]
    middle = anchors.mean(axis=0)
    places = canvas.at(anchors) >> FRACTION
    written = np.empty((0, 2))
    for k, (place, anchor) in enumerate(zip(places, anchors, strict=True)):
        x, y = int(place[0]), int(place[1])
        cv2.rectangle(canvas.pixels, (x - 8, y - 8), (x + 8, y + 8), WHITE, 1, cv2.LINE_AA)
        away = anchor - middle
        away = away / max(float(np.hypot(*away)), 1e-9)
        corner = (x + round(24 * away[0]) - 8, y + round(24 * away[1]) + 6)
        # Where points lie close, some numbers give way to the others.
        if (np.abs(written - corner) > ROOM).any(axis=1).all():
            _write(canvas.pixels, str(k), corner, 0.5)
            written = np.vstack([written, corner])


def _draw_landmarks(canvas: _Canvas, each: Explanation, values: Array | None, scales: tuple[_Scale, _Scale]) -> None:
    if each.account.landmarks is None:
        return
    for m, (place, name) in enumerate(
        zip(canvas.at(each.account.landmarks.positions) >> FRACTION, each.account.landmarks.ids, strict=True)
    ):
        x, y = int(place[0]), int(place[1])
        for reach, colour in ((10, BLACK), (8, _tint(values, m, scales[1]))):
            corners = np.array([(x, y - reach), (x + reach, y), (x, y + reach), (x - reach, y)], dtype=np.int32)
            cv2.fillConvexPoly(canvas.pixels, corners, colour, cv2.LINE_AA)
        _write(canvas.pixels, str(int(name)), (x + 11, y + 5), 0.5)


def _legend(width: int, explanations: Sequence[Explanation], term: str, scales: tuple[_Scale, _Scale]) -> UInt8:
    """What the colours mean, on a strip of its own."""
    strip = np.full((LEGEND, width, 3), 24, dtype=np.uint8)
    configs = sorted({each.config for each in explanations if each.config}) or ["the artist's key"]
    _write(strip, f"{term}, frame {explanations[0].key.frame}, {', '.join(configs)}", (12, 26), 0.62)
    left = 12
    for name, scale, values in zip(("nodes", "landmarks"), scales, _all_values(explanations, term), strict=True):
        if values:
            left = _draw_bar(strip, left, name, scale)
    if not any(_all_values(explanations, term)):
        _write(strip, "nothing was solved here", (12, 62), 0.5)
    return strip


def _all_values(explanations: Sequence[Explanation], term: str) -> tuple[list[Array], list[Array]]:
    nodes = [values for each in explanations if (values := _node_values(each, term)) is not None]
    marks = [values for each in explanations if (values := _landmark_values(each, term)) is not None and len(values)]
    return nodes, marks


def _draw_bar(strip: UInt8, left: int, name: str, scale: _Scale) -> int:
    """One scale of colours with its ends; gives the place to go on from."""
    unit = " nats (more is better)" if scale.more_is_better else " (less is better)"
    words = [f"{name}: {scale.low:.3g}", f"{scale.high:.3g}{unit}"]
    _write(strip, words[0], (left, 62), 0.5)
    start = left + _width(words[0], 0.5) + 8
    for k in range(140):
        value = scale.low + k / 139.0 * (scale.high - scale.low)
        strip[48:66, start + k : start + k + 1] = scale.colour(value)
    _write(strip, words[1], (start + 148, 62), 0.5)
    return start + 148 + _width(words[1], 0.5) + 28


def _width(text: str, size: float) -> int:
    return int(cv2.getTextSize(text, cv2.FONT_HERSHEY_SIMPLEX, size, 1)[0][0])


def _write(pixels: UInt8, text: str, at: tuple[int, int], size: float) -> None:
    """White text with a dark rim, readable on anything."""
    for colour, thickness in ((BLACK, 4), (WHITE, 1)):
        cv2.putText(pixels, text, at, cv2.FONT_HERSHEY_SIMPLEX, size, colour, thickness, cv2.LINE_AA)
