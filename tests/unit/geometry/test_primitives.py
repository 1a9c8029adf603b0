"""Rectangles and ellipses, and the boxes that drags span."""

from __future__ import annotations

import numpy as np

from roam_core.geometry import bezier, polyline, primitives


def test_corners_of_a_rectangle_run_clockwise() -> None:
    points = primitives.rectangle((10.0, 20.0), (40.0, 30.0))
    np.testing.assert_array_equal(points[:, 0], [(10.0, 20.0), (40.0, 20.0), (40.0, 30.0), (10.0, 30.0)])
    assert polyline.signed_area(points[:, 0]) == 300.0


def test_an_ellipse_is_one() -> None:
    line = bezier.flatten(primitives.ellipse((10.0, 20.0), (110.0, 60.0)), tolerance=0.001)
    radius = np.hypot((line[:, 0] - 60.0) / 50.0, (line[:, 1] - 40.0) / 20.0)
    assert np.abs(radius - 1.0).max() < 3e-4
    assert polyline.signed_area(line) > 0.0


def box(*args: object, **kwargs: object) -> list[list[float]]:
    low, high = primitives.spanned(*args, **kwargs)  # type: ignore[arg-type]
    return [low.tolist(), high.tolist()]


def test_a_drag_in_any_direction_spans_a_box() -> None:
    assert box((30.0, 40.0), (10.0, 90.0)) == [[10.0, 40.0], [30.0, 90.0]]


def test_equal_sides_follow_the_longer_one_and_the_direction() -> None:
    assert box((30.0, 40.0), (20.0, 70.0), equal=True) == [[0.0, 40.0], [30.0, 70.0]]


def test_equal_sides_are_so_on_the_screen() -> None:
    """Pixels twice as wide as high: half as many of them across."""
    assert box((0.0, 0.0), (20.0, 10.0), (0.5, 1.0), equal=True) == [[0.0, 0.0], [20.0, 40.0]]


def test_a_box_about_its_centre() -> None:
    assert box((50.0, 50.0), (60.0, 30.0), about=True) == [[40.0, 30.0], [60.0, 70.0]]
    assert box((50.0, 50.0), (60.0, 30.0), equal=True, about=True) == [[30.0, 30.0], [70.0, 70.0]]
