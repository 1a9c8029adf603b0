"""The parts of a sequence of masks: outlines and holes that are the same one from frame to frame."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np
from contourpy import FillType, contour_generator

from roam_core.arrays import Array
from roam_core.geometry import bezier, polyline, similarity
from roam_core.kernels.coverage import coverage
from roam_core.proposal.mask_keys.pairing import paired, poses

ALIKE = 0.5
"""IoU of two outlines, one moved onto the other, below which they are not the same part: it merged, or fell apart."""
CORNERS = 80
"""Vertices of an outline by which it is paired."""
CELLS = 64.0
"""Cells along the longer side at which two outlines are compared."""


@dataclass(eq=False)
class Ring:
    """An outline `line (K, 2)` of a mask, clockwise on screen.

    Of a hole, `parent` is the outline around it; of what lies in a hole, `around` is that hole.
    """

    line: Array
    parent: Ring | None = None
    around: Ring | None = None
    track: Track | None = None

    @property
    def area(self) -> float:
        return abs(polyline.signed_area(self.line))


@dataclass(eq=False)
class Track:
    """One part, or one hole, on successive masks: `frames` and its `rings` on them."""

    is_hole: bool
    frames: list[int] = field(default_factory=list)
    rings: list[Ring] = field(default_factory=list)

    @property
    def largest(self) -> float:
        """Square pixels, on the frame where it is largest."""
        return max(ring.area for ring in self.rings)

    def take(self, frame: int, ring: Ring) -> None:
        """The part goes on."""
        self.frames.append(frame)
        self.rings.append(ring)
        ring.track = self


class Tracker:
    """Joins the outlines of masks that come in order.

    A part goes on in the outline that is nearest to it in place, size and overlap, as long as it is alike; else, and
    after a mask without it, a new part begins. Outlines below `least` square pixels take no part.
    """

    def __init__(self, least: float) -> None:
        self.least = least
        self.tracks: list[Track] = []
        self.scraps = 0
        self.taken: list[int] = []
        self._live: list[Track] = []

    def take(self, field: Array, frame: int) -> None:
        """The next mask, as coverage `(h, w)`."""
        self.taken.append(frame)
        rings = self._large(rings_of(field))
        live: list[Track] = []
        pose: Array | None = None
        for holes in (False, True):
            wanted = [ring for ring in rings if (ring.parent is not None) == holes]
            members = [track for track in self._live if track.is_hole == holes]
            if wanted and members:
                pose = self._joined(members, wanted, frame, field.shape, pose)
            for ring in wanted:
                live.append(ring.track or self._begun(ring, frame, holes))
        self._live = live

    def _begun(self, ring: Ring, frame: int, is_hole: bool) -> Track:
        """The part, or the hole, that is first seen on this mask."""
        track = Track(is_hole)
        track.take(frame, ring)
        self.tracks.append(track)
        return track

    def _large(self, rings: list[Ring]) -> list[Ring]:
        large = [ring for ring in rings if ring.area >= self.least]
        if not large and rings:
            large = [max(rings, key=lambda ring: ring.area)]
        self.scraps += len(rings) - len(large)
        return large

    def _joined(
        self, tracks: list[Track], rings: list[Ring], frame: int, size: Any, pose: Array | None
    ) -> Array | None:
        splines = [bezier.polygon_points(_few(track.rings[-1].line)) for track in tracks]
        pairing = paired(splines, [ring.line for ring in rings], size, pose)
        for number, owner in pairing.owners.items():
            if _alike(tracks[owner].rings[-1].line, rings[number].line) >= ALIKE:
                tracks[owner].take(frame, rings[number])
        return pairing.pose if pairing.owners else None


def rings_of(field: Array) -> list[Ring]:
    """All outlines of coverage `(h, w)` at one half, to a fraction of a pixel, each followed by its holes."""
    generator: Any = contour_generator(z=np.pad(field, 1), fill_type=FillType.OuterOffset)
    points, offsets = generator.filled(0.5, np.inf)
    found: list[Ring] = []
    for vertices, starts in zip(points, offsets, strict=True):
        # Index space of the padded array, whose first pixel's centre is (-0.5, -0.5) of the image.
        lines = [vertices[a : b - 1] - 0.5 for a, b in pairwise(starts)]
        lines = [line if polyline.signed_area(line) > 0 else line[::-1] for line in lines if len(line) >= 3]
        if lines:
            outer = Ring(np.ascontiguousarray(lines[0]))
            found.extend([outer, *(Ring(np.ascontiguousarray(line), outer) for line in lines[1:])])
    holes = [ring for ring in found if ring.parent is not None]
    for ring in found if holes else []:
        inside = [hole for hole in holes if ring.parent is None and _contains(hole.line, ring.line[0])]
        ring.around = min(inside, key=lambda hole: hole.area, default=None)
    return found


def _contains(line: Array, place: Array) -> bool:
    (x, y), (ax, ay), (bx, by) = place, line.T, polyline.following(line).T
    crossing = (ay > y) != (by > y)
    at = ax + (y - ay) * (bx - ax) / np.where(by == ay, 1.0, by - ay)
    return bool(np.count_nonzero(crossing & (x < at)) % 2)


def _few(line: Array) -> Array:
    return line if len(line) <= CORNERS else polyline.resample(line, CORNERS)


def _alike(one: Array, other: Array) -> float:
    """The largest IoU of two outlines, the first carried by poses that may lay it on the second."""
    best = 0.0
    for pose in poses([bezier.polygon_points(_few(one))], [_few(other)]):
        moved = similarity.apply(pose, one)
        both = np.vstack([moved, other])
        low, extent = both.min(axis=0), np.ptp(both, axis=0)
        cell = max(float(extent.max()) / CELLS, 1e-6)
        columns, rows = (int(each) for each in np.ceil(extent / cell) + 1)
        first, second = (coverage((line - low) / cell, (rows, columns)) for line in (moved, other))
        best = max(best, float(np.minimum(first, second).sum() / max(np.maximum(first, second).sum(), 1e-9)))
    return best
