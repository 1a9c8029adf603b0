"""Splines with keys fitted to the outlines of all frames: least squares over a window of keys, within a tolerance."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from roam_core.arrays import Array, Bools, Int64
from roam_core.geometry import bezier, polyline
from roam_core.kernels.mask_fit import (
    FINE,
    add_anchors,
    add_points,
    add_segments,
    distances,
    drawn,
    judged,
    put_on,
    segment_sums,
    solved_band,
)
from roam_core.proposal.outline.refine import from_both_ends

STEP = 2.0
"""Pixels between the samples of an outline that a curve is fitted to."""
WINDOW = (14, 14, 5)
"""Vertices of the curve to both sides in which a sample's nearest place is looked for, by rounds."""
TURN = 9.0
"""Price, in squared pixels, of a place whose outline runs at a right angle."""
ALONG = 0.02
"""Weight of the distance along the outline, against that across it."""
STAY = 0.02
"""Weight of an anchor's move along the outline off its spot, against the samples of one segment."""
LINE, THIRD, STILL = 0.3, 0.02, 1e-4
"""Weights, against the samples of one segment on one frame: handles off their common line; handles longer or shorter
than a third of the chord; control points off where they are."""
ROUNDS = 10
"""Times that samples are put on the curve and the curve is fitted to them."""
PATIENCE = (9.0, 4.0, 3.0, 2.2, 1.7, 1.4, 1.3, 1.2, 1.15, 1.0)
"""Tolerances beyond which, in each round, a window is given up."""
IDLE = 0.3
"""Weight of samples in the share of the outline that is let go."""
KNEE = 0.4
"""Share of the tolerance from which on a sample counts by its distance, not its square."""
REACH = 3.0
"""Tolerances beyond which nothing may lie but scraps."""
SHARE, LOOSE = 0.025, 0.3
"""The mean distance on a frame is at most two thirds of the tolerance, and at most this share of the area spread along
the outline (what IoU asks for), or this share of the tolerance if that is more."""
SURE, STRICT = 0.97, 0.85
"""Share of the tolerance that is worked to, and where nothing may stray: the curve that is looked at is a polygon."""


@dataclass(eq=False)
class Outlines:
    """The outlines of a part on all frames, and the spots of its points on them.

    Attributes
    ----------
    times : the number of each frame. rings : (K, 2) each, running the same way.
    spots : (F, P, 2) where the anchors lie by what the nodes say. smooth : (P,) which points are smooth.
    free : the share of the outline that may lie beyond the tolerance. scrap : square pixels farther than `REACH` at one
        place that are not followed.
    samples, tangents : of each ring, (M, 2) at equal steps. places : (M,) on the curve, in its vertices.
    loose : pixels that the distance may have on average, by `SHARE`.
    """

    times: list[int]
    rings: list[Array]
    spots: Array
    smooth: Bools
    free: float
    scrap: float
    samples: list[Array] = field(default_factory=list)
    tangents: list[Array] = field(default_factory=list)
    places: list[Array] = field(default_factory=list)
    loose: list[float] = field(default_factory=list)
    spot_tangents: Array = field(default_factory=lambda: np.empty(0))

    def __post_init__(self) -> None:
        directions = []
        for ring, spots in zip(self.rings, self.spots, strict=True):
            samples = polyline.resample(ring, max(int(polyline.length(ring) / STEP), 12))
            along = polyline.following(samples) - polyline.preceding(samples)
            along = along + 0.5 * (polyline.following(along) + polyline.preceding(along))
            along /= np.maximum(np.hypot(*along.T), 1e-12)[:, None]
            nearest = ((samples[None] - spots[:, None]) ** 2).sum(axis=2).argmin(axis=1)
            self.samples.append(samples)
            self.loose.append(SHARE * abs(polyline.signed_area(ring)) / max(polyline.length(ring), 1e-9))
            self.tangents.append(along)
            directions.append(along[nearest])
            self.places.append(_between(nearest, len(samples)))
        self.spot_tangents = np.stack(directions)
        self.order = from_both_ends(len(self.smooth))

    @property
    def count(self) -> int:
        return len(self.smooth)


def _between(nearest: Int64, total: int) -> Array:
    """For each of `total` samples the place on the curve, in vertices, by steps between the anchors' samples."""
    at = np.maximum.accumulate(nearest[0] + (nearest - nearest[0]) % total)
    order = nearest[0] + np.arange(total)
    places = np.empty(total)
    stops = np.append(at, nearest[0] + total) + 1e-9 * np.arange(len(at) + 1)
    places[order % total] = np.interp(order, stops, FINE * np.arange(len(at) + 1.0))
    return places % (FINE * len(at))


@dataclass(frozen=True, eq=False)
class Fit:
    """Keys that were fitted: `points (k, P, 3, 2)`, the errors `(f,)` in pixels of the window's frames,
    and the mean squared distance."""

    points: Array
    errors: Array
    mean: float

    @property
    def worst(self) -> float:
        return float(self.errors.max()) if len(self.errors) else 0.0


def fitted(
    outlines: Outlines,
    frames: list[int],
    keys: list[int],
    points: Array,
    ends: tuple[tuple[int, Array] | None, tuple[int, Array] | None],
    tolerance: float,
    hopeless: bool = True,
    evened: bool = False,
) -> Fit | None:
    """The keys on the frames `keys`, moved so that on all `frames` the curve lies within the tolerance of the outline.

    Parameters
    ----------
    frames : numbers of outlines, rising, all between the ends. keys : the same, those with keys that may move.
    points : (k, P, 3, 2) where they are. ends : the keys before and after, which stay, with their numbers, or None.
    hopeless : give up, with None, as soon as it seems that the tolerance cannot be held.
    evened : go on to the end, and take the fit that is the nearest on average of those that hold the tolerance.
    """
    goal = (SURE if outlines.free else STRICT) * tolerance
    spans = [_span(outlines.times, frame, keys, ends) for frame in frames]
    places = [outlines.places[frame].copy() for frame in frames]
    weights = [np.ones(len(each)) for each in places]
    best: Fit | None = None
    gone = [np.zeros(len(each), dtype=bool) for each in places]
    for turn in range(ROUNDS):
        curves = _curves(points, spans, ends)
        strays, errors = [], np.empty(len(frames))
        for k, frame in enumerate(frames):
            samples, line, squares = outlines.samples[frame], drawn(curves[k]), np.empty(len(places[k]))
            put_on(line, samples, outlines.tangents[frame], places[k], WINDOW[min(turn, 2)], TURN, squares)
            away = np.sqrt(squares)
            far = np.flatnonzero(away > goal)
            away[far] = distances(samples[far], line, 0.0)
            strays.append(away)
            room = (goal, outlines.free, REACH, outlines.scrap)
            errors[k] = judged(away, samples, *room, gone[k])
            errors[k] = max(errors[k], goal * float(away.mean()) / max(outlines.loose[frame], LOOSE * tolerance))
            if errors[k] <= goal or not hopeless:  # what is taken over beyond the goal is judged whole, too
                back = distances(line, outlines.rings[frame], goal)
                errors[k] = max(errors[k], judged(back, line, *room, np.empty(len(line), dtype=np.bool_)))
        if turn > 0:
            worst = float(errors.max())
            mean = float(np.mean([np.mean(np.minimum(each, goal) ** 2) for each in strays]))
            if best is None or (max(worst, goal), mean) < (max(best.worst, goal), best.mean):
                best = Fit(points, errors, mean)
            if worst <= goal and not evened:
                return best
            if hopeless and worst > PATIENCE[turn] * tolerance:
                return None
        if turn > 0:
            _reweigh(weights, strays, gone, errors / goal, goal, outlines.free)
        moved = _solved(outlines, frames, spans, points, ends, places, weights)
        if moved is None:
            break
        points = moved
    return best if not hopeless else None


def _reweigh(
    weights: list[Array], strays: list[Array], gone: list[Bools], errors: Array, goal: float, free: float
) -> None:
    """Weights for the next solution: where all must hold, what strays weighs more; else frames that stray do, and
    within each the samples count by their distance, not its square, so that what trembles pulls little."""
    for weight, stray, free_to_go, error in zip(weights, strays, gone, errors, strict=True):
        if free <= 0.0:
            weight *= np.where(stray > 0.85 * goal, np.clip(1.3 * (stray / goal) ** 2, 1.0, 20.0), 1.0)
            continue
        whole = float(weight.max()) * float(np.clip(error**1.5, 1.0, 3.0))
        weight[:] = whole * np.minimum(1.0, KNEE * goal / np.maximum(stray, 1e-9))
        weight[free_to_go] *= IDLE
        weight *= whole / weight.max()


def _span(
    times: list[int], frame: int, keys: list[int], ends: tuple[tuple[int, Array] | None, tuple[int, Array] | None]
) -> tuple[int, int, float]:
    """The keys about a frame, by their place among the free ones (-1 and the count for the ends), and its share."""
    right = int(np.searchsorted(keys, frame))
    if right < len(keys) and keys[right] == frame:
        return right, right, 0.0
    left = right - 1
    before = keys[left] if left >= 0 else (ends[0][0] if ends[0] else None)
    after = keys[right] if right < len(keys) else (ends[1][0] if ends[1] else None)
    assert before is not None
    assert after is not None
    return left, right, (times[frame] - times[before]) / (times[after] - times[before])


def _curves(
    points: Array, spans: list[tuple[int, int, float]], ends: tuple[tuple[int, Array] | None, ...]
) -> list[Array]:
    def at(k: int) -> Array:
        end = ends[0] if k < 0 else ends[1] if k >= len(points) else None
        return points[k] if end is None else end[1]

    return [at(left) if share == 0.0 else (1.0 - share) * at(left) + share * at(right) for left, right, share in spans]


def _solved(
    outlines: Outlines,
    frames: list[int],
    spans: list[tuple[int, int, float]],
    points: Array,
    ends: tuple[tuple[int, Array] | None, tuple[int, Array] | None],
    places: list[Array],
    weights: list[Array],
) -> Array | None:
    keys, count = len(points), outlines.count
    size = 6 * keys * count
    width = min(3 * 6 * keys, size)
    band, side = np.zeros((width, size)), np.zeros(size)
    none = np.zeros_like(points[0])
    fixed = np.stack([none if end is None else end[1] for end in ends])
    matrices, vectors = np.empty((count, 8, 8)), np.empty((count, 8))
    share_of = np.zeros(keys)
    typical = 0.0
    for k, frame in enumerate(frames):
        left, right, share = spans[k]
        a, b = left, right if right < keys else -1
        segment_sums(
            outlines.samples[frame], outlines.tangents[frame], places[k], weights[k], count, ALONG, matrices, vectors
        )
        add_segments(matrices, vectors, a, b, share, fixed, outlines.order, keys, band, side)
        each = len(places[k]) / count
        typical += each / len(frames)
        add_anchors(
            outlines.spots[frame],
            outlines.spot_tangents[frame],
            STAY * each,
            a,
            b,
            share,
            fixed,
            outlines.order,
            keys,
            band,
            side,
        )
        if a >= 0:
            share_of[a] += 1.0 - share
        if b >= 0:
            share_of[b] += share
    for key in range(keys):
        weight = typical * max(share_of[key], 0.5)
        add_points(
            points[key],
            outlines.smooth,
            key,
            (LINE * weight, THIRD * weight, STILL * weight),
            outlines.order,
            keys,
            band,
            side,
        )
    if not solved_band(band, side):
        return None
    moved = side.reshape(count, keys, 3, 2)[outlines.order].transpose(1, 0, 2, 3)
    return np.stack([bezier.aligned(each, outlines.smooth) for each in moved])
