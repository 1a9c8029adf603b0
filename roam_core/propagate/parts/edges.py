"""Kinds of edge: where the outline of a shape is free, where it is a seam of its object, and where it is hidden.

A free edge is drawn to the picture, a seam goes with the shape's own motion (`propagate.frame.free_edges`), of what a
nearer shape hides the picture says nothing. Here this is measured on a picture with the outlines as they are: nothing
is solved. It agrees with where the engine draws to the border of the object's region as far as that is right.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from enum import IntEnum

import numpy as np
from scipy.ndimage import median_filter

from roam_core.arrays import Array, Bools, Indices
from roam_core.features import PreparedFrame, Region
from roam_core.features.pyramid import Pyramid
from roam_core.geometry import bezier, polyline
from roam_core.media.source import MissingFrame
from roam_core.motion.template import contrast
from roam_core.params import EDGES, scale_for
from roam_core.propagate.shapes.objects import Role, near, stacked, units
from roam_core.propagate.shapes.provenance import Stamps, source_of
from roam_core.propagate.shapes.taking_part import governing_key
from roam_core.propagate.whole.posed import is_narrow
from roam_core.roto import BlendMode, RotoShape

ReadPicture = Callable[[int], PreparedFrame]


class Edge(IntEnum):
    """What an outline is at a place.

    UNKNOWN : outside the picture. FREE : the picture changes there, and no other shape of the object lies beyond it.
    SEAM : it runs inside the object, or the picture is the same on both sides. HIDDEN : a nearer shape lies before it.
    """

    UNKNOWN = 0
    FREE = 1
    SEAM = 2
    HIDDEN = 3


@dataclass(frozen=True, eq=False)
class Edges:
    """The edges of one closed shape on one frame, sample by sample along its outline.

    Attributes
    ----------
    segment, t : (N,) where the samples lie on the spline; every point of the shape is one.
    places : (N, 2) where they lie in the picture, pixels.
    lengths : (N,) how much of the outline each stands for, pixels.
    kinds : (N,) the values of `Edge`.
    contrast : (N,) in [0, 1], how much the picture changes across the outline; NaN outside the picture.
    """

    segment: Indices
    t: Array
    places: Array
    lengths: Array
    kinds: Indices
    contrast: Array

    def share(self, kind: Edge) -> float:
        """The share of the outline, in [0, 1], that is of a kind."""
        return float(self.lengths[self.kinds == kind].sum() / max(float(self.lengths.sum()), 1e-9))

    @property
    def shares(self) -> dict[str, float]:
        """The share of every kind, by its name in small letters."""
        return {kind.name.lower(): self.share(kind) for kind in (Edge.FREE, Edge.SEAM, Edge.HIDDEN, Edge.UNKNOWN)}


def edges(
    picture: PreparedFrame,
    shapes: Sequence[RotoShape],
    frame: int,
    only: Collection[str] | None = None,
    samples: Mapping[str, tuple[Indices, Array]] | None = None,
) -> dict[str, Edges]:
    """The edges on `frame`, which shows `picture`, of each closed shape that is there, by its id.

    `shapes` are all of a project, bottom first; `only` the ids of those that are asked for. `samples` are pairs
    (segment, t) by shape where other places of an outline than evenly spaced ones are asked for.
    """
    found: dict[str, Edges] = {}
    for members in sorted(set(Stamps(shapes, size=picture.size).objects.values())):
        if only is None or any(shapes[k].id in only for k in members):
            together = [shapes[k] for k in members if shapes[k].exists_at(frame)]
            found |= _of_object(picture, together, frame, only, samples or {})
    return found


def edges_on_key(
    read: ReadPicture, shapes: Sequence[RotoShape], frame: int, now: Mapping[str, Edges]
) -> dict[str, tuple[int, Edges]]:
    """For each of the shapes whose edges on `frame` are given, the frame of its key, and the same samples there.

    That is the artist's key that the shape on `frame` goes back to; shapes without one, or without a picture of it, are
    left out.
    """
    keyed: dict[int, list[str]] = {}
    for shape in shapes:
        if shape.id in now and (key := _drawn_frame(shape, frame)) is not None:
            keyed.setdefault(key, []).append(shape.id)
    found: dict[str, tuple[int, Edges]] = {}
    for key, ids in keyed.items():
        if key == frame:
            found |= {name: (key, now[name]) for name in ids}
            continue
        samples = {name: (now[name].segment, now[name].t) for name in ids}
        with suppress(MissingFrame):
            found |= {name: (key, each) for name, each in edges(read(key), shapes, key, ids, samples).items()}
    return found


def _drawn_frame(shape: RotoShape, frame: int) -> int | None:
    """The frame of the artist's key that a shape on `frame` goes back to; the one before it between keys."""
    key = shape.key_at(frame)
    drawn = governing_key(shape, frame, True) or governing_key(shape, frame, False)
    drawn = drawn if key is None else source_of(shape, key)
    return None if drawn is None else drawn.frame


def _of_object(
    picture: PreparedFrame,
    together: Sequence[RotoShape],
    frame: int,
    only: Collection[str] | None,
    samples: Mapping[str, tuple[Indices, Array]],
) -> dict[str, Edges]:
    """The edges of the shapes of one object."""
    asked = [k for k, shape in enumerate(together) if only is None or shape.id in only]
    if not asked:
        return {}
    scale = scale_for(picture.size)
    points = [shape.at(frame).points for shape in together]
    sampled = {k: _sampled(points[k], scale, samples.get(together[k].id)) for k in asked}
    window = Region.around(np.vstack([each.places for each in sampled.values()]), EDGES.margin * scale, picture.size)
    if is_narrow(window, EDGES.pose):
        return {together[k].id: sampled[k] for k in asked}
    stack = _Stack(Pyramid.of(picture, window, 1.0 / scale, EDGES.pose.pyramid), together, points, frame, picture.size)
    return {together[k].id: stack.judged(k, sampled[k]) for k in asked}


def _sampled(points: Array, scale: float, given: tuple[Indices, Array] | None) -> Edges:
    """Samples of an outline of which nothing is known yet, about `EdgesParams.step` apart in each segment."""
    if given is None:
        control = bezier.segments(points)
        roughly = np.hypot(*np.diff(control, axis=1).T).sum(axis=0)
        given = bezier.even_pairs(np.maximum(np.ceil(roughly / (EDGES.step * scale)).astype(np.intp), 1))
    segment, t = given
    places = bezier.evaluate(points, segment, t)
    ahead = np.hypot(*(polyline.following(places) - places).T)
    unknown = np.full(len(t), Edge.UNKNOWN, dtype=np.intp)
    return Edges(segment, t, places, 0.5 * (ahead + polyline.preceding(ahead)), unknown, np.full(len(t), np.nan))


class _Stack:
    """The shapes of one object on a frame, over each other, on the cells of a picture."""

    def __init__(
        self,
        pyramid: Pyramid,
        shapes: Sequence[RotoShape],
        points: Sequence[Array],
        frame: int,
        size: tuple[int, int],
    ) -> None:
        self.pyramid, self.size, self.scale, self.params = pyramid, size, scale_for(size), EDGES.pose
        self.shapes, self.units, self.order = shapes, units(shapes, near(size)), stacked(shapes, frame)
        self.inside = [pyramid.outlined([bezier.flatten(each)])[0] > 0 for each in points]
        self.unit_of = {k: unit for unit in self.units for k in unit.members}
        self.nothing = np.zeros(pyramid.levels[0].shape[:2], dtype=bool)

    def judged(self, k: int, edges: Edges) -> Edges:
        """The samples of shape `k`, with what they are."""
        outwards = polyline.outward_normals(edges.places)
        if self._is_hole(k):
            outwards = -outwards  # the object lies around a hole
        away = self.params.beside_at * self.scale
        outside, within = edges.places + away * outwards, self._within(k, edges.places, -outwards, away)
        beyond = edges.places + EDGES.free.outside * self.scale * outwards
        nearer = self._nearer(k)
        hidden = self._in(nearer, edges.places) | self._in(nearer, within)
        hidden |= self._in(self._nearer(k, occluders=True), beyond)
        changes = self._contrast(within, outside)
        changes[~(self._is_seen(outside) & self._is_seen(edges.places))] = np.nan
        kinds = np.where((changes >= EDGES.changes) & ~self._in(self._others(k), beyond), Edge.FREE, Edge.SEAM)
        kinds = np.where(hidden, Edge.HIDDEN, np.where(np.isnan(changes), Edge.UNKNOWN, kinds))
        return replace(edges, kinds=kinds.astype(np.intp), contrast=changes)

    def _contrast(self, within: Array, outside: Array) -> Array:
        """How much the picture changes from one place to another, in [0, 1]; the median over neighbours."""
        apart = contrast(self.pyramid.colours(within, 0), self.pyramid.colours(outside, 0), self.params)
        return np.asarray(median_filter(apart, size=EDGES.around, mode="wrap"))

    def _within(self, k: int, places: Array, inwards: Array, away: float) -> Array:
        """Places `away` pixels from an outline on the object's side, nearer to it where the shape is narrow."""
        inside, cell = self.inside[k] ^ self._is_hole(k), self.scale
        found = places + EDGES.depths[0] * away * inwards
        for share in EDGES.depths[1:]:
            deeper = places + share * away * inwards
            is_inside = self._in(inside, deeper) & self._in(inside, deeper + cell * inwards)
            found = np.where(is_inside[:, None], deeper, found)
        return found

    def _nearer(self, k: int, occluders: bool = False) -> Bools:
        """Where something lies before shape `k`; only what is an occluder, if so."""
        depth = self._depth(k)
        covers = [j for j in range(len(self.shapes)) if self._depth(j) > depth and not self._is_hole(j)]
        return self._filled([j for j in covers if not occluders or self.unit_of[j].role is Role.OCCLUDER])

    def _others(self, k: int) -> Bools:
        """Where the other shapes of the object lie; an occluder belongs to nothing."""
        if self.unit_of[k].role is Role.OCCLUDER:
            return self.nothing
        solid = [j for j in range(len(self.shapes)) if j != k and not self._is_hole(j)]
        return self._filled([j for j in solid if self.unit_of[j].role is not Role.OCCLUDER])

    def _filled(self, chosen: Sequence[int]) -> Bools:
        """Where any of the solid shapes lies, without its holes."""
        filled = self.nothing.copy()
        for j in chosen:
            there = self.inside[j].copy()
            for hole in self.unit_of[j].members:
                if self._is_hole(hole):
                    there &= ~self.inside[hole]
            filled |= there
        return filled

    def _is_hole(self, k: int) -> bool:
        return self.shapes[k].blend is BlendMode.SUBTRACT and self.unit_of[k].role is not Role.OCCLUDER

    def _depth(self, k: int) -> int:
        return self.order.index(self.unit_of[k].members[0])

    def _is_seen(self, places: Array) -> Bools:
        height, width = self.size
        return np.asarray(((places >= 0.0) & (places < (width, height))).all(axis=1))

    def _in(self, mask: Bools, places: Array) -> Bools:
        """Which of the places lie on a cell that is set; none beyond the cells."""
        column, row = np.round(self.pyramid.to_level(places, 0)).astype(np.intp).T
        rows, columns = mask.shape
        there = (column >= 0) & (row >= 0) & (column < columns) & (row < rows)
        return np.asarray(there & mask[np.clip(row, 0, rows - 1), np.clip(column, 0, columns - 1)])
