"""Little shots drawn by formula: a textured body over a textured background, its true outline known on every frame."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial import cKDTree

from roam_core.arrays import Array, Bools, Float32, UInt8
from roam_core.geometry import bezier, similarity
from roam_core.matte import shape_matte
from roam_core.roto import Keyframe, RotoShape


def texture(seed: int, dark: float, bright: float, waves: int = 16) -> Texture:
    """A smooth colour pattern, defined at every real position: waves of 9 to 40 pixels in all directions."""
    rng = np.random.default_rng(seed)
    angle, length = rng.uniform(0.0, 2.0 * np.pi, waves), rng.uniform(9.0, 40.0, waves)
    wave = np.stack([np.cos(angle), np.sin(angle)], axis=1) * (2.0 * np.pi / length)[:, None]
    return Texture(wave, rng.uniform(0.0, 2.0 * np.pi, (waves, 3)), dark, bright)


@dataclass(frozen=True, eq=False)
class Texture:
    """Sum of `wave (W, 2)` radians a pixel with `phase (W, 3)`, brought into [dark, bright]."""

    wave: Array
    phase: Array
    dark: float
    bright: float

    def at(self, positions: Array) -> Array:
        """Colours `(..., 3)` at `positions (..., 2)`."""
        along = positions @ self.wave.T
        total = np.sin(along) @ np.cos(self.phase) + np.cos(along) @ np.sin(self.phase)  # the sum of sin(along + phase)
        level = np.clip(0.5 + total / np.sqrt(len(self.wave)) / 2.5, 0.0, 1.0)
        return np.asarray(self.dark + (self.bright - self.dark) * level)


@dataclass(frozen=True, eq=False)
class Shot:
    """A rigid body `rest (P, 3, 2)`, carried to the picture by one similarity `(2, 3)` a frame.

    `size` is (h, w); the background's texture glides by `drift` pixels a frame.
    """

    rest: Array
    poses: tuple[Array, ...]
    size: tuple[int, int] = (120, 160)
    first: int = 1001
    seed: int = 7
    drift: tuple[float, float] = (0.0, 0.0)

    @property
    def frames(self) -> range:
        return range(self.first, self.first + len(self.poses))

    def truth(self, frame: int) -> Array:
        """The true outline `(P, 3, 2)`."""
        return similarity.apply(self.poses[frame - self.first], self.rest)

    def shape(self, frame: int | None = None, shape_id: str = "shape-1") -> RotoShape:
        """A shape with one artist key, the true outline, on `frame` (the first one if None)."""
        frame = self.first if frame is None else frame
        return RotoShape(shape_id, shape_id, (Keyframe(frame, self.truth(frame)),))

    def read(self, frame: int) -> UInt8:
        """The picture `(h, w, 3)`."""
        return self.pictures[frame - self.first]

    def matte(self, frame: int) -> Float32:
        """True coverage `(h, w)`."""
        return shape_matte(self.shape(frame), frame, self.size)

    def reversed(self) -> Shot:
        """The same pictures in the opposite order, under the same numbers."""
        turned = replace(self, poses=self.poses[::-1])
        turned.__dict__["pictures"] = self.pictures[::-1]
        return turned

    @cached_property
    def pictures(self) -> list[UInt8]:
        return [self._drawn(frame) for frame in self.frames]

    def _drawn(self, frame: int) -> UInt8:
        height, width = self.size
        centres = np.stack(np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5), axis=-1)
        body = texture(self.seed, 0.7, 1.0).at(similarity.apply(inverse(self.poses[frame - self.first]), centres))
        glide = np.asarray(self.drift) * (frame - self.first)
        background = texture(self.seed + 1, 0.0, 0.3).at(centres - glide)
        coverage = self.matte(frame)[..., None]
        return np.asarray(np.round(255.0 * (coverage * body + (1.0 - coverage) * background)), dtype=np.uint8)


def pose(x: float, y: float, degrees: float = 0.0, scale: float = 1.0) -> Array:
    """The similarity `(2, 3)` that turns and scales about the origin and carries the origin to (x, y)."""
    c, s = scale * np.cos(np.radians(degrees)), scale * np.sin(np.radians(degrees))
    return np.array([[c, -s, x], [s, c, y]])


def inverse(transform: Array) -> Array:
    """The similarity `(2, 3)` that undoes another."""
    linear = np.linalg.inv(transform[:, :2])
    return np.column_stack([linear, -linear @ transform[:, 2]])


def square(side: float) -> Array:
    """A polygon `(4, 3, 2)` around the origin."""
    half = side / 2.0
    return bezier.polygon_points([(-half, -half), (half, -half), (half, half), (-half, half)])


def blob(radii: ArrayLike) -> Array:
    """A smooth closed spline `(P, 3, 2)` around the origin through points at `radii (P,)` and equal angles."""
    radii = np.asarray(radii, dtype=np.float64)
    angle = np.arange(len(radii)) * (2.0 * np.pi / len(radii))
    anchors = radii[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    tangent = (np.roll(anchors, -1, axis=0) - np.roll(anchors, 1, axis=0)) / 6.0
    return np.stack([anchors, anchors - tangent, anchors + tangent], axis=1)


def outline_distance(ours: Array, true: Array, closed: bool = True) -> float:
    """Mean distance in pixels of two outlines `(P, 3, 2)`, the worse of the two directions."""
    a, b = (dense(points, closed) for points in (ours, true))
    return float(max(cKDTree(one).query(other)[0].mean() for one, other in ((a, b), (b, a))))


def distance_to_line(positions: Array, line: Array) -> Array:
    """Distances `(K,)` of positions to a closed polyline."""
    start, along = line, np.roll(line, -1, axis=0) - line
    t = np.einsum("kec,ec->ke", positions[:, None] - start, along) / (along**2).sum(axis=1)
    foot = start + np.clip(t, 0.0, 1.0)[..., None] * along
    return np.asarray(np.hypot(*np.moveaxis(positions[:, None] - foot, 2, 0)).min(axis=1))


def dense(points: Array, closed: bool = True, count: int = 800) -> Array:
    """Positions `(count, 2)` at equal arc length along a spline."""
    return bezier.evaluate(points, *bezier.arc_length_pairs(points, count, closed), closed)


def overlap(a: Bools, b: Bools) -> float:
    """Intersection over union of two masks; 1 for two empty ones."""
    union = int(np.count_nonzero(a | b))
    return int(np.count_nonzero(a & b)) / union if union else 1.0


def gliding(rest: Array, count: int, start: Sequence[float], step: Sequence[float], **values: object) -> Shot:
    """A shot in which the body moves by the same `step` each frame."""
    poses = tuple(pose(start[0] + k * step[0], start[1] + k * step[1]) for k in range(count))
    return Shot(rest, poses, **values)  # type: ignore[arg-type]
