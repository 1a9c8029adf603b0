"""Finished keys steadied: each engine key moved, across its outline, towards where the keys beside it have it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from roam_core.arrays import Array
from roam_core.cancel import CancelToken, Progress, half
from roam_core.features import PreparedFrame
from roam_core.geometry.simple import crossing_segments, untied
from roam_core.media.partial import ReadFrame
from roam_core.media.source import MissingFrame
from roam_core.params import UNTYING, scale_for
from roam_core.params.steadiness import SteadinessParams
from roam_core.propagate.frame.nodes import displaced
from roam_core.propagate.steadiness.residual import Flows, Places, both_ways
from roam_core.propagate.steadiness.settle import settled
from roam_core.roto import BlendMode, Keyframe, Origin, RotoShape
from roam_core.roto import control_points as controls
from roam_core.translatable import sentence


def steadied(
    read: ReadFrame,
    shapes: Sequence[RotoShape],
    frames: range,
    strength: float,
    params: SteadinessParams,
    token: CancelToken | None = None,
    progress: Progress | None = None,
) -> list[RotoShape]:
    """The shapes with their ENGINE keys in `frames` moved so that outlines go with the motion of the picture.

    All keys of a shape in the range are solved together, from where they were (`settle`); each moves across its outline
    alone, so that points do not slide. What an outline does by more than boil, or where the flow is in doubt, is left
    as it is. The artist's keys stay bit by bit, and so does whatever else a key holds, its stamp too. A key moves only
    where a key lies on a frame beside it, both with pictures. No outline comes to cross itself.

    Parameters
    ----------
    read : gives a frame's picture (h, w, 3) RGB, uint8, or floats in [0, 1], or its parts; raises `MissingFrame`. Each
        is asked for once, in order, with up to `params.reach` of those on either side of the range, whose keys hold
        those in it.
    shapes : in plate space. Open ones are never moved.
    frames : in steps of one. strength : in [0, 1]; 0 gives the very same shapes.

    Raises
    ------
    ValueError
        for another strength.
    Cancelled
        between two frames, or two keys, after `token` was cancelled.
    """
    if not 0.0 <= strength <= 1.0:
        raise ValueError(f"a strength is in [0, 1], not {strength}")
    asked = [k for k, shape in enumerate(shapes) if _can_move(shape, frames)]
    made = list(shapes)
    if strength == 0.0 or not asked:
        return made
    looked_at = range(frames.start - params.reach, frames.stop + params.reach)
    paths, scale = _watched(
        read, [shapes[k] for k in asked], looked_at, params, token, progress and half(progress, 0.0)
    )
    moving = progress and half(progress, 0.5)
    for done, (k, path) in enumerate(zip(asked, paths, strict=True)):
        if moving is not None:
            moving(done / len(asked), sentence("Shape {name}", name=path.shape.name))
        made[k] = path.moved(frames, strength, params, scale, token)
    return made


def _can_move(shape: RotoShape, frames: range) -> bool:
    is_area = shape.closed and shape.point_count > 1
    return is_area and any(key.origin is Origin.ENGINE and key.frame in frames for key in shape.keys)


@dataclass(eq=False)
class _Path:
    """A shape, and what its outline does from each frame to the next, with how far that is to be trusted."""

    shape: RotoShape
    keys: dict[int, Keyframe]
    places: Places | None = None
    steps: dict[int, tuple[Array, Array]] = field(default_factory=dict)

    def pair(self, frame: int) -> tuple[Array, Array] | None:
        """The outlines of this frame and the next; None where the shape has no key on either."""
        both = frame, frame + 1
        if not all(each in self.keys and self.shape.exists_at(each) for each in both):
            return None
        return self.keys[frame].points, self.keys[frame + 1].points

    def look(self, flows: Flows, frame: int, params: SteadinessParams, size: tuple[int, int]) -> None:
        """Note what the outline does from this frame to the next, in pictures of `size` (h, w)."""
        scale = scale_for(size)
        if (pair := self.pair(frame)) is None:
            return
        if self.places is None:
            self.places = Places.of(pair[0], params.residual, scale)
        subtracts = self.shape.blend is BlendMode.SUBTRACT
        back, there = both_ways(flows, *pair, self.places, params.residual, scale, subtracts=subtracts)
        trust = np.exp(-(((back - there) / (params.unsure * scale)) ** 2))
        for points in pair:
            trust = np.where(_inside(self.places.on(points)[0], size), trust, 0.0)
        self.steps[frame] = 0.5 * (back + there), trust

    def moved(
        self, frames: range, strength: float, params: SteadinessParams, scale: float, token: CancelToken | None
    ) -> RotoShape:
        """The shape with its engine's keys in `frames` moved."""
        if self.places is None:
            return self.shape
        made = [
            key
            for first, last in _rows(sorted(self.steps))
            for key in self._moved(range(first, last + 2), self.places, frames, strength, params, scale, token)
        ]
        return self.shape.with_keys(made) if made else self.shape

    def _moved(
        self,
        row: range,
        places: Places,
        frames: range,
        strength: float,
        params: SteadinessParams,
        scale: float,
        token: CancelToken | None,
    ) -> Iterator[Keyframe]:
        """The keys of frames that follow each other, those that moved."""
        steps, trust = (np.stack([self.steps[frame][k] for frame in row[:-1]]) for k in (0, 1))
        keys = [self.keys[frame] for frame in row]
        fixed = np.array([key.origin is not Origin.ENGINE or key.frame not in frames for key in keys])
        by = settled(steps, trust, fixed, strength, params, scale)
        for key, outwards, stays in zip(keys, by, fixed, strict=True):
            if stays:
                continue
            if token is not None:
                token.check()
            points = _moved_points(self.shape, key.points, places, outwards, params, scale)
            if not np.array_equal(points, key.points):
                yield replace(key, points=points)


def _watched(
    read: ReadFrame,
    shapes: Sequence[RotoShape],
    frames: range,
    params: SteadinessParams,
    token: CancelToken | None,
    progress: Progress | None,
) -> tuple[list[_Path], float]:
    """What each shape does on `frames`, those with a key and a picture; and the scale of the pictures."""
    paths = [_Path(shape, {key.frame: key for key in shape.keys}) for shape in shapes]
    keyed = {frame for path in paths for frame in path.keys}
    wanted = [frame for frame in frames if frame in keyed]
    before: tuple[int, PreparedFrame] | None = None
    scale = 1.0
    for done, frame in enumerate(wanted):
        if token is not None:
            token.check()
        if progress is not None:
            progress(done / len(wanted), sentence("Looking at frame {frame}", frame=frame))
        try:
            picture = PreparedFrame(read(frame))
        except MissingFrame:
            before = None
            continue
        if before is not None and before[0] == frame - 1 and before[1].size == picture.size:
            scale = scale_for(picture.size)
            _look(paths, before[1], picture, frame - 1, params)
        before = frame, picture
    return paths, scale


def _look(
    paths: Sequence[_Path], before: PreparedFrame, after: PreparedFrame, frame: int, params: SteadinessParams
) -> None:
    """Note what every outline does from this frame to the next."""
    outlines = [points for path in paths for points in path.pair(frame) or ()]
    if not outlines:
        return
    flows = Flows.of(before, after, outlines, params.residual, scale_for(before.size))
    if flows is not None:
        for path in paths:
            path.look(flows, frame, params, before.size)


def _inside(positions: Array, size: tuple[int, int]) -> Array:
    """Which places `(N,)` lie in a picture of `size` (h, w): beyond it there is no motion to go by."""
    return np.asarray(((positions >= 0.0) & (positions <= np.array(size[::-1]))).all(axis=1))


def _rows(frames: Sequence[int]) -> Iterator[tuple[int, int]]:
    """The first and the last of frames that follow each other without a gap."""
    first = 0
    for k, frame in enumerate(frames):
        if k + 1 == len(frames) or frames[k + 1] != frame + 1:
            yield frames[first], frame
            first = k + 1


def _moved_points(
    shape: RotoShape, points: Array, places: Places, outwards: Array, params: SteadinessParams, scale: float
) -> Array:
    """Control points `(P, 3, 2)` whose curve goes `outwards (N,)` at its places, as the shape can hold them."""
    _, normals = places.on(points)
    moved = displaced(points, places.segment, places.t, outwards[:, None] * normals, params.rigidity)
    moved = controls.settled(untied(moved, points, scale, UNTYING), shape)
    crosses = len(crossing_segments(moved, scale, UNTYING)) > 0
    return points if crosses and len(crossing_segments(points, scale, UNTYING)) == 0 else moved
