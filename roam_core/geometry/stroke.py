"""Splines of few points fitted to lines that a hand draws: what is fitted stays as it is while the line grows."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import fit, polyline
from roam_core.params import CURVE_FIT

Run = tuple[Array, Array, Array]
"""Samples `(K, 2)`, and the unit directions in which a curve along them leaves and arrives."""


class StrokeFit:
    """Fits a line from its beginning to its end, piece by piece.

    The line is cut at its corners, and where it is long between them; each run is fitted by itself (`geometry.fit`),
    with a common tangent at cuts that are no corners. Where a cut lies depends on the line about it alone, so a line
    that goes on keeps the curve that it had, but for its end. Runs that are as they were are not fitted again; this
    changes the time alone.

    `tolerance` is in pixels of the line.
    """

    def __init__(self, tolerance: float) -> None:
        self._tolerance = tolerance
        self._known: dict[bytes, list[Array]] = {}

    def points(self, line: Array, *, closed: bool) -> Array:
        """The spline `(P, 3, 2)` of a line `(K, 2)`; `closed` leads its end to its beginning."""
        if polyline.length(line, closed=False) < CURVE_FIT.min_stroke:
            return fit.chained([fit.straight(line[0], line[-1])])
        runs = list(_runs(np.vstack([line, line[:1]]) if closed else line, self._tolerance))
        if closed:
            runs[-1] = _led_into(runs[-1], runs[0])
        fitted = {_key(run): self._known.get(_key(run)) or self._fitted(run) for run in runs}
        self._known = fitted
        pieces = [piece for run in runs for piece in fitted[_key(run)]]
        return fit.joined(pieces) if closed else fit.chained(pieces)

    def _fitted(self, run: Run) -> list[Array]:
        samples, leaving, arriving = run
        if fit.off_chord(samples) <= self._tolerance / 2.0:
            return [fit.straight(samples[0], samples[-1])]
        return fit.fit_run(samples, leaving, arriving, self._tolerance)


def _runs(line: Array, tolerance: float) -> Iterator[Run]:
    """The line in runs from cut to cut, tremor taken out."""
    dense, softness = _sampled(line), CURVE_FIT.hand_softness / CURVE_FIT.hand_step
    reach = max(2, round(CURVE_FIT.hand_reach / CURVE_FIT.hand_step))
    corners = fit.corners(fit.smoothed_open(dense, softness), reach, np.radians(CURVE_FIT.hand_corner))
    corners = corners[(corners >= reach) & (corners < len(dense) - reach)]
    for start, stop in pairwise([0, *corners.tolist(), len(dense) - 1]):
        soft = fit.smoothed_open(dense[start : stop + 1], softness)
        tail = 2 * reach if stop == len(dense) - 1 else 0
        cuts = [0, *_cuts(soft, tail, tolerance), len(soft) - 1]
        for a, b in pairwise(cuts):
            run = soft[a : b + 1]
            leaving = fit.centre_tangent(soft, a) if a > 0 else fit.end_tangent(run)
            arriving = fit.centre_tangent(soft, b) if b < len(soft) - 1 else -fit.end_tangent(run[::-1])
            yield run, leaving, arriving


def _cuts(soft: Array, tail: int, tolerance: float) -> Iterator[int]:
    """Where a stretch between two corners is cut: every span, unless it is straight or ends soon.

    What is nearer to the end of the line than `tail` samples may still turn out to be a corner.
    """
    span = max(4, round(CURVE_FIT.hand_span / CURVE_FIT.hand_step))
    before, cut = 0, span
    while cut + span // 2 + tail < len(soft):
        if fit.off_chord(soft[before : cut + span // 2]) > tolerance / 2.0:
            yield cut
            before = cut
        cut += span


def _sampled(line: Array) -> Array:
    """The line at even steps from its beginning, and its end."""
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(line, axis=0).T))])
    count = max(int(along[-1] / CURVE_FIT.hand_step), 1)
    places = np.append(np.arange(count) * CURVE_FIT.hand_step, along[-1])
    return np.stack([np.interp(places, along, line[:, axis]) for axis in range(2)], axis=1)


def _led_into(last: Run, first: Run) -> Run:
    """The last run of a ring, arriving as the first one leaves, unless there is a corner between them."""
    samples, leaving, arriving = last
    turn = np.arccos(np.clip(arriving @ first[1], -1.0, 1.0))
    return samples, leaving, (first[1] if turn < np.radians(CURVE_FIT.hand_corner) else arriving)


def _key(run: Run) -> bytes:
    return b"".join(part.tobytes() for part in run)
