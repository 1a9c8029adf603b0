"""Which shapes are one object."""

from __future__ import annotations

import numpy as np

from roam_core.geometry.bezier import polygon_points
from roam_core.propagate.objects import objects
from roam_core.propagate.result import Part


def square(x: float, y: float, side: float, *, hole: bool = False) -> Part:
    return Part(polygon_points(np.array([(0, 0), (1, 0), (1, 1), (0, 1)]) * side + (x, y)), hole)


def test_near_shapes_are_one_object_and_far_ones_their_own() -> None:
    parts = [square(0, 0, 40), square(300, 0, 40), square(50, 0, 40), square(85, 30, 40)]
    assert objects(parts, 20.0) == [[0, 2, 3], [1]]


def test_a_hole_in_the_middle_of_a_large_shape_belongs_to_it() -> None:
    parts = [square(0, 0, 400), square(180, 180, 20, hole=True), square(900, 0, 10, hole=True)]
    assert objects(parts, 20.0) == [[0, 1], [2]]


def test_one_shape_is_one_object() -> None:
    assert objects([square(0, 0, 10)], 20.0) == [[0]]
