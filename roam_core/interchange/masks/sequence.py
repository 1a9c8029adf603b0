"""A sequence of masks as shapes: few, with few points that stay put and few keys, and how near they lie is told."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from roam_core.geometry import bezier, polyline
from roam_core.interchange.masks.fitting import Outlines
from roam_core.interchange.masks.keys import SLACK, Keys
from roam_core.interchange.masks.nodes import nodes_on
from roam_core.interchange.masks.points import chosen, curves, dense
from roam_core.interchange.masks.tracks import Ring, Track
from roam_core.kernels.coverage import coverage
from roam_core.kernels.mask_fit import distances
from roam_core.roto import BlendMode, Keyframe, RotoShape
from roam_core.roto.project import PALETTE

Array = NDArray[np.float64]

OPEN = 1_000_000
"""Frame that stands for "always" at an open end of a lifetime."""
COARSEST = 40
"""Square pixels for each node of a ring that is so small that it gets fewer."""


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
    greatest, mean : pixels from the outlines of the masks to the curve and back, over all frames; scraps among them.
    beyond : frames on which the tolerance is not held, scraps apart.
    overlap : the least IoU of a frame.
    """

    keys: tuple[tuple[int, Array], ...]
    frames: tuple[int, ...]
    greatest: float
    mean: float
    beyond: int
    overlap: float

    def report(self, name: str, tolerance: float) -> str:
        """What was achieved, in one sentence."""
        points = len(self.keys[0][1])
        kept = f"{len(self.keys)} keys for {len(self.frames)} frames" if len(self.frames) > 1 else "1 key"
        within = (
            f"within {tolerance:g} px of the masks' outline on every frame"
            if not self.beyond
            else f"within {tolerance:g} px of the masks' outline on all frames but {self.beyond}"
        )
        return (
            f"{name!r}: {points} points, {kept}, {within} but for scraps ({self.mean:.2f} px on average, "
            f"{self.greatest:.1f} px at the farthest scrap), IoU at least {self.overlap:.3f}."
        )


def part_as_keys(track: Track, wanted: Wanted, checked: Callable[[], None], told: Callable[[float], None]) -> Fitted:
    """The keys of one part. `told` is called with the finished fraction; `checked` at every safe point."""
    lines = [ring.line for ring in track.rings]
    places = nodes_on(lines, wanted.scale, checked)
    told(0.2)
    samples = dense(lines, places)
    at, smooth = chosen(samples, SLACK * wanted.tolerance, checked)
    told(0.3)
    keys = Keys(Outlines(track.frames, lines, samples[:, at], smooth, wanted.scrap), wanted.tolerance, checked)
    keys.fit_every(curves(samples, at))
    told(0.4)
    if not wanted.every:
        keys.stride(lambda done: told(0.4 + 0.4 * done))
        keys.reduce(lambda done: told(0.8 + 0.15 * done))
        keys.merge()
    keys.even_out()
    told(1.0)
    return _measured(keys, track)


def _measured(keys: Keys, track: Track) -> Fitted:
    found = tuple((track.frames[k], keys.points[k]) for k in keys.at)
    shape = RotoShape("measured", "measured", tuple(Keyframe(frame, points) for frame, points in found))
    greatest, total, overlap = 0.0, 0.0, 1.0
    for frame, ring in zip(track.frames, track.rings, strict=True):
        line = bezier.flatten(shape.at(frame).points, tolerance=0.02)
        there = distances(polyline.resample(ring.line, max(int(polyline.length(ring.line)), 12)), line, 0.0)
        back = distances(line, ring.line, 0.0)
        greatest = max(greatest, float(there.max()), float(back.max()))
        total += float(there.mean())
        overlap = min(overlap, _overlap(ring.line, line))
    beyond = int(np.count_nonzero(keys.errors > keys.tolerance))
    return Fitted(found, tuple(track.frames), greatest, total / len(track.frames), beyond, overlap)


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


def as_shapes(parts: list[tuple[Track, Fitted]], first: int, last: int, offset: int) -> list[RotoShape]:
    """Shapes of parts in the order of compositing; `first` and `last` are the masks' frames.

    A part that is there on the first or the last mask goes on beyond it. `offset` is taken off frames.
    """
    shapes: list[RotoShape] = []
    outer = hole = 0
    for track, part in parts:
        if track.is_hole:
            hole += 1
        else:
            outer += 1
        start = -OPEN if track.frames[0] == first else track.frames[0] - offset
        stop = OPEN if track.frames[-1] == last else track.frames[-1] + 1 - offset
        shapes.append(
            RotoShape(
                id=f"shape-{len(shapes) + 1}",
                name=f"Hole {hole}" if track.is_hole else f"Shape {outer}",
                keys=tuple(Keyframe(frame - offset, points) for frame, points in part.keys),
                colour=PALETTE[len(shapes) % len(PALETTE)],
                blend=BlendMode.SUBTRACT if track.is_hole else BlendMode.ADD,
                lifetime=None if (start, stop) == (-OPEN, OPEN) else (start, stop),
            )
        )
    return shapes
