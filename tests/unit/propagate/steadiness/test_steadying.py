"""What the steadying pass says that it did."""

from __future__ import annotations

import numpy as np

from roam_core.geometry.bezier import polygon_points
from roam_core.propagate.steadiness.steadying import Steadied, told
from roam_core.roto import Keyframe, RotoShape


def square(name: str, side: float) -> RotoShape:
    corners = side * np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    return RotoShape(name, name, (Keyframe(1, polygon_points(corners)),))


def test_a_speck_counts_by_its_length() -> None:
    shapes = [square("body", 99.0), square("speck", 1.0)]
    boil = {("body", 1): (1.0, 0.5), ("speck", 1): (1.0, 10.5)}
    sentence = told(Steadied(shapes, {("body", 1): 0.2, ("speck", 1): 0.2}, boil))
    assert sentence == "2 keys moved; boil by the picture 1.00 px before, 0.60 px now."


def test_an_outline_without_length_is_no_error() -> None:
    sentence = told(Steadied([square("point", 0.0)], {("point", 1): 0.2}, {("point", 1): (1.0, 0.5)}))
    assert sentence == "1 key moved; boil by the picture 1.00 px before, 0.50 px now."
