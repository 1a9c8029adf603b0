"""The confidence of a whole frame, from those of its shapes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from roam_core.geometry import bezier
from roam_core.propagate.shapes.provenance import source_of
from roam_core.roto import BlendMode, RotoShape


def whole_confidence(rated: Sequence[tuple[RotoShape, float]], frame: int) -> tuple[float, int]:
    """How far a frame is trusted as a whole, in [0, 1], and which of its shapes costs most of that.

    It is the IoU to be expected of the frame: the mean of the shapes' confidences by the area, each by itself, that
    they have on the artist's key that they go back to (`provenance.source_of`), or on their first key. A shape that has
    shrunk to nothing by mistake so weighs what is missing, and a scrap weighs little. Subtracting shapes weigh nothing,
    unless there are no others.

    Parameters
    ----------
    rated : at least one shape, each with its confidence on the frame.
    """
    areas = np.array([_area(shape, frame) for shape, _ in rated])
    added = areas * [shape.blend is not BlendMode.SUBTRACT for shape, _ in rated]
    weights = next((each for each in (added, areas) if each.any()), np.ones(len(rated)))
    lacking = weights / weights.sum() * [1.0 - confidence for _, confidence in rated]
    return max(0.0, float(1.0 - lacking.sum())), int(lacking.argmax())


def _area(shape: RotoShape, frame: int) -> float:
    key = shape.key_at(frame)
    source = None if key is None else source_of(shape, key)
    return bezier.area((source or shape.keys[0]).points)
