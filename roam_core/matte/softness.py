"""How soft the plate's edge is along the keys of shapes: the shutter, and a width at each point."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass

import cv2
import numpy as np

from roam_core.arrays import Array, Bools, Image, Indices
from roam_core.cancel import CancelToken, Progress
from roam_core.geometry import bezier
from roam_core.geometry.polyline import signed_area
from roam_core.matte.edge_profile import costs, profiles
from roam_core.matte.rasterise import has_area, shape_patch
from roam_core.media import MissingFrame
from roam_core.media.source import ReadImage
from roam_core.params.softness import SoftnessParams
from roam_core.roto import BlendMode, Keyframe, Layer, RotoShape
from roam_core.roto.feather import frames_along
from roam_core.roto.sight import is_point
from roam_core.translatable import sentence

Spot = tuple[str, int]
"""A key: the id of its shape, and its frame."""

TOGETHER = frozenset({BlendMode.ADD, BlendMode.PLUS, BlendMode.MAX})
"""How a matte joins what lies under it so that both grow into one."""


@dataclass(frozen=True, eq=False)
class Edge:
    """What the plate shows along the outline of one key.

    Attributes
    ----------
    costs : (P, D) what speaks against each width at each point, a place; all alike where nothing can be seen.
    places : (P,) how many places along the outline tell of each point.
    speed : (P,) pixels a frame that each point moves across its outline.
    """

    costs: Array
    places: Indices
    speed: Array


@dataclass(frozen=True, eq=False)
class Softness:
    """What was measured.

    Attributes
    ----------
    shutter : frames that the camera's shutter was open; 0 where it was too short to see, None where the shapes move
        too little to tell.
    focus : (P,) a key, pixels over which coverage falls from 1 to 0 beside the motion across the shutter.
    total : (P,) a key, the same with the motion.
    seen : (P,) a key, where the picture could be read at all.
    """

    shutter: float | None
    focus: Mapping[Spot, Array]
    total: Mapping[Spot, Array]
    seen: Mapping[Spot, Bools]

    def typical(self, spots: Iterable[Spot]) -> float | None:
        """The median width in pixels over which coverage falls from 90 to 10 per cent at points that could be read.

        A pixel's own width is in it: that of a hard edge is 0.8. None where nothing could be read.
        """
        chosen = [np.hypot(self.total[spot], 1.0)[self.seen[spot]] for spot in spots if spot in self.total]
        widths = np.concatenate(chosen) if chosen else np.zeros(0)
        return 0.8 * float(np.median(widths)) if widths.size else None


def middle(points: Array, feather: Array | None) -> Array:
    """Where coverage is a half, as Bezier points `(P, 3, 2)`: halfway to the feather curve."""
    return points if feather is None else points + 0.5 * feather


def measured(
    read: ReadImage,
    asked: Sequence[RotoShape],
    root: Layer,
    params: SoftnessParams,
    token: CancelToken,
    progress: Progress,
) -> Softness:
    """How soft the plate's edge is along every key of the shapes that are asked for.

    Parameters
    ----------
    read : gives a frame's picture (h, w, 3), uint8, or floats in [0, 1]; a frame that raises `MissingFrame` is left
        out.
    asked, root : closed shapes in plate space, and all that the project holds, in plate space too.
    """
    frames = sorted({frame for shape in asked for frame in shape.frames})
    edges: dict[Spot, Edge] = {}
    for done, frame in enumerate(frames):
        token.check()
        progress(done / len(frames), sentence("Looking at frame {frame}", frame=frame))
        with suppress(MissingFrame):
            edges |= edges_at(read(frame), asked, root, frame, params)
    return softness(edges, params, token)


def edges_at(
    picture: Image, asked: Iterable[RotoShape], root: Layer, frame: int, params: SoftnessParams
) -> dict[Spot, Edge]:
    """What the picture of a frame shows along those shapes that are asked for and have a key there.

    An outline beside or under another shape of `root` that grows into one with its own is no edge of the object:
    nothing is read there. A single point has no edge, nor has an outline that has closed to one.
    """
    keyed = {shape.id: shape for shape in asked if _has_edge(shape, frame)}
    crowds: dict[str, Indices] = {}
    for group in grown_together(root):
        joined = [shape for shape in group if _joins(shape, frame)]
        if any(shape.id in keyed for shape in joined):
            crowds |= dict.fromkeys((s.id for s in joined), _crowd(joined, frame, picture.shape[:2], params))
    return {(shape.id, frame): _edge(picture, shape, frame, crowds.get(shape.id), params) for shape in keyed.values()}


def _has_edge(shape: RotoShape, frame: int) -> bool:
    key = shape.key_at(frame)
    return key is not None and shape.point_count > 1 and has_area(shape, frame) and not is_point(key.points)


def grown_together(layer: Layer) -> list[list[RotoShape]]:
    """The shapes in sight by what they may grow into one with; first those that do with what lies beside the layer.

    Those in a layer that takes away, or is inverted, are apart from all others.
    """
    own: list[RotoShape] = []
    apart: list[list[RotoShape]] = []
    for child in layer.children if layer.visible else ():
        if isinstance(child, RotoShape):
            own.append(child)
            continue
        first, *rest = grown_together(child)
        if child.blend in TOGETHER and not child.invert:
            own += first
        else:
            apart.append(first)
        apart += rest
    return [own, *apart]


def _joins(shape: RotoShape, frame: int) -> bool:
    """True where a shape grows into one with others; the outline of any other is an edge wherever it lies."""
    return shape.visible and not shape.invert and shape.blend in TOGETHER and has_area(shape, frame)


def _crowd(shapes: Sequence[RotoShape], frame: int, size: tuple[int, ...], params: SoftnessParams) -> Indices:
    """How many shapes lie at or near each pixel: `(h, w)`."""
    reach = round(params.apart)
    near = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * reach + 1, 2 * reach + 1))
    count = np.zeros((size[0], size[1]), dtype=np.intp)
    for shape in shapes:
        patch = shape_patch(_plain(shape, frame), frame, (size[0], size[1]))
        if not patch.values.size:
            continue
        covered = np.pad((patch.values >= 0.5).astype(np.uint8), reach)
        top, left = patch.top - reach, patch.left - reach
        seen = cv2.dilate(covered, near)[max(-top, 0) : size[0] - top, max(-left, 0) : size[1] - left]
        count[max(top, 0) :, max(left, 0) :][: seen.shape[0], : seen.shape[1]] += seen
    return count


def _plain(shape: RotoShape, frame: int) -> RotoShape:
    """The shape on one frame, hard along the middle of its edge."""
    outline = shape.at(frame)
    key = Keyframe(frame, middle(outline.points, outline.feather))
    return RotoShape(shape.id, shape.name, (key,))


def _edge(picture: Image, shape: RotoShape, frame: int, crowd: Indices | None, params: SoftnessParams) -> Edge:
    outline = shape.at(frame)
    points = middle(outline.points, outline.feather)
    segment, t = _places(points, params)
    places, normals = _normals(points, segment, t)
    seen = _readable(places, picture.shape[:2], params)
    if crowd is not None:
        seen[seen] = crowd[*_pixels(places[seen])] <= 1
    owner = (segment + (t >= 0.5)) % shape.point_count
    table, told = np.zeros((shape.point_count, len(params.widths))), np.zeros(shape.point_count, dtype=np.intp)
    if seen.any():
        found = costs(profiles(picture, places[seen], normals[seen], params), params)
        np.add.at(table, owner[seen], found)
        np.add.at(told, owner[seen], 1)
    speed = np.abs((_velocity(shape, frame) * _at_points(points)).sum(axis=1))
    return Edge(table / np.maximum(told, 1)[:, None], told, speed)


def _places(points: Array, params: SoftnessParams) -> tuple[Indices, Array]:
    """Places along a closed curve, some of each segment: `(segment, t)`."""
    lengths = bezier.segment_lengths(points)
    counts = np.clip(np.ceil(lengths / params.every), 2, params.most_places).astype(np.intp)
    segment = np.repeat(np.arange(len(counts)), counts)
    first = np.cumsum(counts) - counts
    return segment, (np.arange(len(segment)) - first[segment] + 0.5) / counts[segment]


def _normals(points: Array, segment: Indices, t: Array) -> tuple[Array, Array]:
    """Positions `(N, 2)` on a closed curve, and the unit vectors out of it."""
    along = bezier.evaluate(points, segment, np.minimum(t + 0.02, 1.0)) - bezier.evaluate(points, segment, t - 0.02)
    normals = np.stack([along[:, 1], -along[:, 0]], axis=1) / np.maximum(np.hypot(*along.T), 1e-9)[:, None]
    return bezier.evaluate(points, segment, t), normals * turn(points)


def _at_points(points: Array) -> Array:
    """At each point the unit vector out of a closed curve, `(P, 2)`."""
    return -turn(points) * frames_along(points)[:, 1]


def turn(points: Array) -> float:
    """1 where a closed curve has its inside to the right of its direction (clockwise on the screen), else -1."""
    return 1.0 if signed_area(bezier.flatten(points)) > 0.0 else -1.0


def _readable(places: Array, size: tuple[int, ...], params: SoftnessParams) -> Bools:
    """Which places lie so far inside the picture that both sides can be seen."""
    inner = np.minimum(places, np.array([size[1], size[0]]) - places).min(axis=1)
    return np.asarray(inner >= params.reach)


def _pixels(places: Array) -> tuple[Indices, Indices]:
    return places[:, 1].astype(np.intp), places[:, 0].astype(np.intp)


def _velocity(shape: RotoShape, frame: int) -> Array:
    """Pixels a frame by which the points move about a key, `(P, 2)`; at the ends, those of the side that is keyed.

    On the way to or from a point the outline closes or opens: that is no motion.
    """
    index = shape.frames.index(frame)
    first = frame - 0.5 if index > 0 and not is_point(shape.keys[index - 1].points) else frame
    last = frame + 0.5 if any(not is_point(key.points) for key in shape.keys[index + 1 : index + 2]) else frame
    if first >= last:
        return np.zeros((shape.point_count, 2))
    return (shape.at(last).anchors - shape.at(first).anchors) / (last - first)


def softness(edges: Mapping[Spot, Edge], params: SoftnessParams, token: CancelToken) -> Softness:
    """The shutter and the widths that say least against all that was seen."""
    token.check()
    shutter, common = _in_common(edges, params)
    opened = shutter or 0.0
    focus = {}
    for shape_id, frames in _by_shape(edges).items():
        token.check()
        # Of one shape after the other: of all keys of many shapes these tables fill the memory.
        free = {frame: _beside(edges[shape_id, frame], opened, params) for frame in frames}
        for frame in frames:
            said = free[frame] + params.in_time * sum(free[near] for near in (frame - 1, frame + 1) if near in frames)
            focus[shape_id, frame] = _along(said, common, params)
    total = {spot: np.hypot(width, opened * edges[spot].speed) for spot, width in focus.items()}
    return Softness(shutter, focus, total, {spot: _read(edge, params) for spot, edge in edges.items()})


def _read(edge: Edge, params: SoftnessParams) -> Bools:
    """At which points the picture says anything of the width: where there is contrast, and nothing else beside it."""
    return np.asarray(np.ptp(edge.costs, axis=1) >= params.least_said)


def _by_shape(spots: Iterable[Spot]) -> dict[str, set[int]]:
    frames: dict[str, set[int]] = defaultdict(set)
    for shape_id, frame in spots:
        frames[shape_id].add(frame)
    return frames


def _in_common(edges: Mapping[Spot, Edge], params: SoftnessParams) -> tuple[float | None, float]:
    """The shutter that explains the widths best by the points' motion, and the one width beside it for all."""
    rows = [
        (edge.costs[seen], edge.places[seen], edge.speed[seen])
        for edge in edges.values()
        if (seen := _read(edge, params)).any()
    ]
    if not rows:
        return None, 0.0
    table, places, speed = (np.concatenate(column) for column in zip(*rows, strict=True))

    def against(shutter: float, width: float) -> float:
        said = _cost_of(table, np.hypot(width, shutter * speed), params)
        return float(np.average(said, weights=places))

    tried = np.array([[against(shutter, width) for width in params.widths] for shutter in params.shutters])
    best, width = np.unravel_index(tried.argmin(), tried.shape)
    column = tried[:, width]
    common = params.widths[width]
    if column.max() - column.min() < params.least_gain:
        return None, common
    shutter = _vertex(params.shutters, column, int(best))
    is_seen = shutter >= params.least_shutter and tried[0].min() - tried.min() >= params.least_gain
    return shutter if is_seen else 0.0, common


def _vertex(shutters: Sequence[float], tried: Array, best: int) -> float:
    """The lowest place of the parabola through the best one tried and its neighbours."""
    if not 0 < best < len(shutters) - 1:
        return shutters[best]
    a, b, _ = np.polyfit(shutters[best - 1 : best + 2], tried[best - 1 : best + 2], 2)
    return float(np.clip(-b / (2.0 * a), shutters[best - 1], shutters[best + 1])) if a > 0.0 else shutters[best]


def _cost_of(table: Array, widths: Array, params: SoftnessParams) -> Array:
    """What `table (N, D)` says against widths `(N,)` that lie between those that were tried."""
    place = np.interp(widths, params.widths, np.arange(len(params.widths)))
    low = np.minimum(place.astype(np.intp), len(params.widths) - 2)
    share, row = place - low, np.arange(len(table))
    return np.asarray((1.0 - share) * table[row, low] + share * table[row, low + 1])


def _beside(edge: Edge, shutter: float, params: SoftnessParams) -> Array:
    """What speaks against each width beside the motion across the shutter: `(P, D)`, of all places of a point."""
    motion = shutter * edge.speed
    each = [_cost_of(edge.costs, np.hypot(width, motion), params) for width in params.widths]
    return np.asarray(np.stack(each, axis=1) * np.minimum(edge.places, params.heard)[:, None])


def _along(said: Array, common: float, params: SoftnessParams) -> Array:
    """The widths `(P,)` along a closed outline that say least, where a change from point to point has its price."""
    from roam_core.kernels.cyclic_viterbi import cyclic_viterbi  # numba: a command's help must not wait for it

    widths = np.asarray(params.widths)
    steps = np.abs(np.subtract.outer(np.arange(len(widths)), np.arange(len(widths)))) * params.bend
    pairs = np.broadcast_to(steps, (len(said), *steps.shape))
    labels, _ = cyclic_viterbi(said + np.minimum(params.soft * np.abs(widths - common), params.leap), pairs)
    return np.asarray(widths[labels])
