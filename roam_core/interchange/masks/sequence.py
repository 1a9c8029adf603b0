"""A sequence of masks as shapes: few, with few points that stay put and few keys, and how near they lie is told."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import bezier, polyline
from roam_core.interchange.masks.fitting import Outlines
from roam_core.interchange.masks.keys import SLACK, Keys
from roam_core.interchange.masks.nodes import nodes_on
from roam_core.interchange.masks.points import chosen, curves, dense
from roam_core.interchange.masks.tracks import Ring, Track
from roam_core.kernels.coverage import coverage
from roam_core.kernels.mask_fit import distances
from roam_core.roto import BlendMode, Keyframe, RotoShape
from roam_core.roto.lifetimes import lifetime_of
from roam_core.translatable import enumerated, sentence

TREMBLES = 0.01
"""A part is drawn frame by frame when so much of its outline, over all frames, lies farther than the tolerance from
midway between the frames before and after."""
FREE = 0.2
"""Share of the outline of such a part that may lie beyond the tolerance on a frame; of all others none may."""
SELDOM = 0.1
"""Share of the frames on which a segment of such a part need not be one cubic."""
COARSE, FINER, TRIES = 0.8, 0.75, 4
"""Tolerances within which segments are cubics at first; by how much less, so many times, as long as a frame is not
held by a key of its own."""
NAMED = 12
"""Frames on which a part is not held that are told by their numbers."""


@dataclass(frozen=True)
class Wanted:
    """What is asked for: see `MaskOptions`; `scrap` in square pixels of the masks, `scale` over 480 lines."""

    tolerance: float
    scrap: float
    scale: float
    every: bool


@dataclass(frozen=True, eq=False)
class Fitted:
    """A part as keys, and how near its curve lies to the masks.

    Attributes
    ----------
    keys : (frame, points (P, 3, 2)) of each. frames : on which the part is there, of those that have a mask.
    tolerance : pixels. drawn : whether the masks were drawn frame by frame, so that `FREE` of the outline may stray.
    within : the least share of the outline, of the mask and of the curve, that is within the tolerance on a frame.
    greatest, mean : pixels from the outlines of the masks to the curve and back, over all frames.
    beyond : frames, of those that have a mask, on which the measure is not held.
    overlap : the least IoU of a frame.
    """

    keys: tuple[tuple[int, Array], ...]
    frames: tuple[int, ...]
    tolerance: float
    drawn: bool
    within: float
    greatest: float
    mean: float
    beyond: tuple[int, ...]
    overlap: float

    def report(self, name: str, offset: int = 0) -> str:
        """What was achieved, in one sentence; `offset` is taken off frames."""
        points = len(self.keys[0][1])
        kept = sentence("1 key")
        if len(self.frames) > 1:
            kept = sentence("{keys} keys for {frames} frames", keys=len(self.keys), frames=len(self.frames))
        missed = ""
        if self.beyond:
            beyond = enumerated([str(frame - offset) for frame in self.beyond], NAMED)
            missed = sentence("; not held on frame {frames}", frames=beyond)
        return sentence(
            "{name!r}: {points} points, {kept}; at least {share:.0f} % of the outline within {tolerance:g} px on every "
            "frame ({mean:.2f} px on average, {greatest:.1f} px at the farthest), IoU at least {overlap:.3f}{missed}.",
            name=name,
            points=points,
            kept=kept,
            share=at_least(self.within, 2) * 100.0,
            tolerance=self.tolerance,
            mean=self.mean,
            greatest=self.greatest,
            overlap=at_least(self.overlap, 3),
            missed=missed,
        )


def at_least(value: float, digits: int) -> float:
    """What is promised of a value in so many digits behind the point: no more than it is, so that 0.997 is no 100 %."""
    parts = float(10**digits)
    return math.floor(round(value * parts, 6)) / parts


def part_as_keys(track: Track, wanted: Wanted, checked: Callable[[], None], told: Callable[[float], None]) -> Fitted:
    """The keys of one part. `told` is called with the finished fraction; `checked` at every safe point."""
    lines = [ring.line for ring in track.rings]
    places = nodes_on(lines, wanted.scale, checked)
    told(0.2)
    samples = dense(lines, places)
    free = FREE if trembling(samples, lines, wanted.tolerance) > TREMBLES else 0.0
    keys = _every(track, samples, free, wanted, checked)
    told(0.4)
    if not wanted.every:
        keys.stride(lambda done: told(0.4 + 0.4 * done))
        keys.reduce(lambda done: told(0.8 + 0.15 * done))
        keys.merge()
    keys.even_out()
    told(1.0)
    return _measured(keys, track)


def trembling(samples: Array, lines: list[Array], tolerance: float) -> float:
    """The share of the outlines `lines` that lies farther than the tolerance from midway between their neighbours.

    `samples (F, M, 2)` are the same places on all of them. What moves evenly has none.
    """
    away = [
        distances(0.5 * (samples[k - 1] + samples[k + 1]), lines[k], 0.5 * tolerance) for k in range(1, len(lines) - 1)
    ]
    return float(np.mean([each > tolerance for each in away])) if away else 0.0


def _every(track: Track, samples: Array, free: float, wanted: Wanted, checked: Callable[[], None]) -> Keys:
    """A key on every frame, with as few points as hold them all."""
    lines = [ring.line for ring in track.rings]
    reach = (COARSE if free else SLACK) * wanted.tolerance
    best: Keys | None = None
    for _ in range(TRIES):
        at, smooth = chosen(samples, reach, SELDOM if free else 0.0, checked)
        outlines = Outlines(track.frames, lines, samples[:, at], smooth, free, wanted.scrap)
        keys = Keys(outlines, wanted.tolerance, checked)
        keys.fit_every(curves(samples, at))
        if best is None or keys.missed < best.missed:
            best = keys
        if not keys.missed:
            break
        reach *= FINER
    assert best is not None
    return best


def _measured(keys: Keys, track: Track) -> Fitted:
    found = tuple((track.frames[k], keys.points[k]) for k in keys.at)
    shape = RotoShape("measured", "measured", tuple(Keyframe(frame, points) for frame, points in found))
    greatest, total, overlap, within = 0.0, 0.0, 1.0, 1.0
    for frame, ring in zip(track.frames, track.rings, strict=True):
        line = bezier.flatten(shape.at(frame).points, tolerance=0.02)
        ours = polyline.resample(line, max(int(polyline.length(line)), 12))
        true = polyline.resample(ring.line, max(int(polyline.length(ring.line)), 12))
        there, back = distances(true, line, 0.0), distances(ours, ring.line, 0.0)
        greatest = max(greatest, float(there.max()), float(back.max()))
        within = min(within, *(float((each <= keys.tolerance).mean()) for each in (there, back)))
        total += 0.5 * float(there.mean() + back.mean())
        overlap = min(overlap, _overlap(ring.line, line))
    beyond = tuple(track.frames[k] for k in np.flatnonzero(keys.errors > keys.tolerance))
    drawn = keys.outlines.free > 0.0
    mean = total / len(track.frames)
    return Fitted(found, tuple(track.frames), keys.tolerance, drawn, within, greatest, mean, beyond, overlap)


def _overlap(one: Array, other: Array) -> float:
    """IoU of two closed outlines, each pixel by its share."""
    both = np.vstack([one, other])
    low = np.floor(both.min(axis=0)) - 1.0
    columns, rows = (int(each) for each in np.ceil(np.ptp(both, axis=0)) + 3)
    first, second = (coverage(line - low, (rows, columns)) for line in (one, other))
    return float(np.minimum(first, second).sum() / max(np.maximum(first, second).sum(), 1e-9))


def in_order(tracks: list[Track]) -> list[Track]:
    """The parts in the order of compositing: a hole above what it is cut out of, an island above the hole around it."""
    above: dict[int, set[int]] = {k: set() for k in range(len(tracks))}
    number = {id(track): k for k, track in enumerate(tracks)}
    for k, track in enumerate(tracks):
        for ring in track.rings:
            under = _under(ring)
            if under is not None and id(under) in number:
                above[k].add(number[id(under)])
    level = [0] * len(tracks)
    for _ in range(len(tracks)):
        raised = [max([level[k], *(level[j] + 1 for j in above[k])]) for k in range(len(tracks))]
        if raised == level or max(raised) > len(tracks):
            break
        level = raised
    return [
        tracks[k] for k in sorted(range(len(tracks)), key=lambda k: (level[k], tracks[k].frames[0], -tracks[k].largest))
    ]


def _under(ring: Ring) -> Track | None:
    """The part that this one lies on: that of a hole's parent, or the hole around an island."""
    around = ring.parent if ring.parent is not None else ring.around
    return None if around is None else around.track


def as_shapes(parts: list[tuple[Track, Fitted]], first: int, last: int, compound: str, offset: int) -> list[RotoShape]:
    """Shapes of parts, all of one `compound`, in the order of compositing; `first` and `last` are the masks' frames.

    A part that is there on the first or the last mask goes on beyond it. `offset` is taken off frames.
    """
    shapes: list[RotoShape] = []
    outer = hole = 0
    for track, part in parts:
        if track.is_hole:
            hole += 1
        else:
            outer += 1
        start = None if track.frames[0] == first else track.frames[0] - offset
        stop = None if track.frames[-1] == last else track.frames[-1] + 1 - offset
        shapes.append(
            RotoShape(
                id=f"shape-{len(shapes) + 1}",
                name=f"Hole {hole}" if track.is_hole else f"Shape {outer}",
                keys=tuple(Keyframe(frame - offset, points) for frame, points in part.keys),
                blend=BlendMode.SUBTRACT if track.is_hole else BlendMode.ADD,
                lifetime=lifetime_of(start, stop),
                compound=compound,
            )
        )
    return shapes
