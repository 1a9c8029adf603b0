"""Where layers put what lies in them: a projective matrix a frame, and outlines carried by the layers above them.

Control points are what a layer carries: a shape stays the Bezier spline of its carried anchors and handles, so that
what is shown, edited, rendered and exported is one and the same curve.
"""

from __future__ import annotations

import bisect
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from roam_core.arrays import Array
from roam_core.geometry import projective


@dataclass(frozen=True, eq=False)
class LayerTransform:
    """The motion of a layer: `matrices (K, 3, 3)` from layer space to the space around it, one on each of `frames`.

    Frames increase strictly, the plate's own numbers; every matrix has 1 in its last corner and an inverse. Between two
    frames the matrix is the linear blend of theirs; before the first and after the last it holds still.
    """

    frames: tuple[int, ...]
    matrices: Array
    extra: Mapping[str, Any] = field(default_factory=dict)
    _digest: int = field(init=False, repr=False)

    def __post_init__(self) -> None:
        matrices = np.array([projective.normalised(matrix) for matrix in self.matrices]).reshape(-1, 3, 3)
        if not self.frames or len(matrices) != len(self.frames):
            raise ValueError("a transform needs a frame for each matrix, and at least one")
        if any(a >= b for a, b in zip(self.frames, self.frames[1:], strict=False)):
            raise ValueError("the frames of a transform must increase")
        matrices.setflags(write=False)
        object.__setattr__(self, "matrices", matrices)
        object.__setattr__(self, "_digest", hash((self.frames, matrices.tobytes())))

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
        return same and dict(self.extra) == dict(other.extra)

    def __hash__(self) -> int:
        return self._digest

    @property
    def by_frame(self) -> dict[int, Array]:
        """The matrices by frame."""
        return dict(zip(self.frames, self.matrices, strict=True))

    def with_matrices(self, matrices: Mapping[int, ArrayLike]) -> LayerTransform:
        """The transform with these matrices on their frames, in place of those that were there."""
        return replace(LayerTransform.of({**self.by_frame, **matrices}), extra=self.extra)

    def without(self, frames: Iterable[int]) -> LayerTransform | None:
        """The transform without its matrices on these frames; None where nothing is left."""
        gone = set(frames)
        left = {frame: matrix for frame, matrix in self.by_frame.items() if frame not in gone}
        return replace(LayerTransform.of(left), extra=self.extra) if left else None

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


def carried(points: Array, feather: Array | None, matrix: Array) -> tuple[Array, Array | None]:
    """Control points and feather offsets, `(P, 3, 2)` each, carried by `matrix (3, 3)`."""
    moved = projective.apply(matrix, points)
    return moved, None if feather is None else projective.apply(matrix, points + feather) - moved
