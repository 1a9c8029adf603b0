"""Where layers put what lies in them: a projective matrix a frame, and outlines carried by the layers above them.

Control points are what a layer carries: a shape stays the Bezier spline of its carried anchors and handles, so that
what is shown, edited, rendered and exported is one and the same curve.
"""

from __future__ import annotations

import bisect
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from roam_core.arrays import Array
from roam_core.geometry import projective
from roam_core.translatable import sentence


@dataclass(frozen=True, eq=False)
class LayerTransform:
    """The motion of a layer: `matrices (K, 3, 3)` from layer space to the space around it, one on each of `frames`.

    Frames increase strictly, the plate's own numbers; every matrix has 1 in its last corner and an inverse. Between two
    frames the matrix is the linear blend of theirs; before the first and after the last it holds still.

    Of a track it also holds, as pairs `(frame, value)` in the order of frames, the `confidence` in [0, 1] where one is
    known; the frames of its adjust keys, on which the artist says that it is right (`adjusted`); four corners in layer
    space by which the surface is pinned there (`surface`), none where no one has asked for them; and of a point track
    its `points` in layer space, with half the sides of their patterns and search areas (`areas`), pixels.
    """

    frames: tuple[int, ...]
    matrices: Array
    confidence: tuple[tuple[int, float], ...] = ()
    adjusted: tuple[int, ...] = ()
    surface: tuple[tuple[float, float], ...] = ()
    points: tuple[tuple[float, float], ...] = ()
    areas: tuple[float, ...] = ()
    extra: Mapping[str, Any] = field(default_factory=dict)
    _digest: int = field(init=False, repr=False)

    def __post_init__(self) -> None:
        matrices = np.array([projective.normalised(matrix) for matrix in self.matrices]).reshape(-1, 3, 3)
        if not self.frames or len(matrices) != len(self.frames):
            raise ValueError(sentence("a transform needs a frame for each matrix, and at least one"))
        if any(a >= b for a, b in zip(self.frames, self.frames[1:], strict=False)):
            raise ValueError(sentence("the frames of a transform must increase"))
        matrices.setflags(write=False)
        object.__setattr__(self, "matrices", matrices)
        if self.points and len(self.areas) != 2:
            raise ValueError(sentence("points of a track need the sizes of two areas"))
        if self.surface and np.array(self.surface).shape != (4, 2):
            raise ValueError(sentence("a surface has four corners"))
        here = set(self.frames)
        object.__setattr__(self, "confidence", tuple(sorted(pair for pair in self.confidence if pair[0] in here)))
        object.__setattr__(self, "adjusted", tuple(sorted(set(self.adjusted) & here)))
        told = self._told()
        object.__setattr__(self, "_digest", hash((self.frames, matrices.tobytes(), told)))

    @classmethod
    def of(cls, matrices: Mapping[int, ArrayLike]) -> LayerTransform:
        """The transform with these matrices by frame."""
        frames = tuple(sorted(matrices))
        return cls(frames, np.array([np.asarray(matrices[frame], dtype=np.float64) for frame in frames]))

    def __eq__(self, other: object) -> bool:
        if self is other:
            return True
        if not isinstance(other, LayerTransform) or self._digest != other._digest:
            return False
        same = self.frames == other.frames and np.array_equal(self.matrices, other.matrices)
        return same and self._told() == other._told() and dict(self.extra) == dict(other.extra)

    def __hash__(self) -> int:
        return self._digest

    def _told(self) -> tuple[object, ...]:
        return self.confidence, self.adjusted, self.surface, self.points, self.areas

    @property
    def by_frame(self) -> dict[int, Array]:
        """The matrices by frame."""
        return dict(zip(self.frames, self.matrices, strict=True))

    @property
    def anchors(self) -> tuple[int, ...]:
        """The frames on which it is right by the artist's word: its adjust keys, or where it begins from rest."""
        if self.adjusted:
            return self.adjusted
        rest = [np.array_equal(matrix, projective.IDENTITY) for matrix in self.matrices]
        return tuple(frame for frame, still in zip(self.frames, rest, strict=True) if still)[:1]

    def with_matrices(
        self, matrices: Mapping[int, ArrayLike], confidence: Mapping[int, float] | None = None
    ) -> LayerTransform:
        """The transform with these matrices on their frames, in place of those that were there.

        What was known of their confidence goes; `confidence` tells it anew.
        """
        known = {frame: value for frame, value in self.confidence if frame not in matrices} | dict(confidence or {})
        moved = LayerTransform.of({**self.by_frame, **matrices})
        return replace(self, frames=moved.frames, matrices=moved.matrices, confidence=tuple(known.items()))

    def without(self, frames: Iterable[int]) -> LayerTransform | None:
        """The transform without its matrices on these frames; None where nothing is left."""
        gone = set(frames)
        left = {frame: matrix for frame, matrix in self.by_frame.items() if frame not in gone}
        if not left:
            return None
        rest = LayerTransform.of(left)
        return replace(self, frames=rest.frames, matrices=rest.matrices)

    def at(self, frame: float) -> Array:
        """The matrix `(3, 3)` at `frame` (fractions are for motion blur)."""
        index = bisect.bisect_right(self.frames, frame)
        before, after = max(index - 1, 0), min(index, len(self.frames) - 1)
        if before == after or self.frames[before] == frame:
            return np.asarray(self.matrices[before])
        u = (frame - self.frames[before]) / (self.frames[after] - self.frames[before])
        return np.asarray((1.0 - u) * self.matrices[before] + u * self.matrices[after])


Placement = tuple[LayerTransform, ...]
"""The transforms of the layers above something, the outermost first; empty where none moves it."""


def matrix_at(placement: Placement, frame: float) -> Array:
    """From the innermost layer's space to the plate, `(3, 3)`."""
    result: Array = projective.IDENTITY
    for transform in placement:
        result = result @ transform.at(frame)
    return result


@lru_cache(maxsize=256)
def matrices_at(placement: Placement, frames: tuple[int, ...]) -> Array:
    """`matrix_at` of each of the frames, `(K, 3, 3)`: the shapes of a layer are keyed on the same ones, as a rule."""
    matrices = np.array([matrix_at(placement, frame) for frame in frames])
    matrices.setflags(write=False)
    return matrices


def carried(points: Array, feather: Array | None, matrix: Array) -> tuple[Array, Array | None]:
    """Control points and feather offsets, `(P, 3, 2)` each, carried by `matrix (3, 3)`."""
    moved = projective.apply(matrix, points)
    return moved, None if feather is None else projective.apply(matrix, points + feather) - moved
