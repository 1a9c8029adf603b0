"""Splines: splitting keeps the curve, sampling and fitting back are each other's inverse."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from roam_core.arrays import Array
from roam_core.geometry import bezier
from roam_core.kernels.flattening import step_counts
from tests.property.strategies import point_arrays


@given(point_arrays(), st.data(), st.floats(0.01, 0.99), st.booleans())
def test_a_split_keeps_the_curve(points: Array, data: st.DataObject, t: float, closed: bool) -> None:
    segment = data.draw(st.integers(0, bezier.segment_count(len(points), closed) - 1))
    split = bezier.split(points, segment, t, closed)
    u = np.linspace(0.0, 1.0, 9)
    for old in range(bezier.segment_count(len(points), closed)):
        whole = np.full(9, old)
        if old == segment:
            here = np.where(u <= t, segment, segment + 1)
            along = np.where(u <= t, u / t, (u - t) / (1.0 - t))
        else:
            here, along = whole + (old > segment), u
        before, after = bezier.evaluate(points, whole, u, closed), bezier.evaluate(split, here, along, closed)
        np.testing.assert_allclose(after, before, atol=1e-8)


@given(point_arrays(least=1), st.booleans())
def test_evaluation_equals_de_casteljau(points: Array, closed: bool) -> None:
    control = bezier.segments(points, closed)
    t = np.linspace(0.0, 1.0, 7)
    for segment, polygon in enumerate(control):
        line = bezier.evaluate(points, np.full(7, segment), t, closed)
        np.testing.assert_allclose(line, [casteljau(polygon, u) for u in t], atol=1e-9)


@given(point_arrays(), st.integers(2, 90), st.booleans())
def test_pairs_lie_on_the_spline_in_order(points: Array, count: int, closed: bool) -> None:
    segment, t = bezier.arc_length_pairs(points, count, closed)
    assert len(segment) == len(t) == count
    assert (t >= 0.0).all()
    assert (t <= 1.0).all()
    assert (segment < bezier.segment_count(len(points), closed)).all()
    assert (np.diff(segment + t) >= 0.0).all()


@given(point_arrays(), st.sampled_from([0.02, 0.1, 1.0]), st.booleans())
def test_a_flattened_spline_is_within_its_tolerance(points: Array, tolerance: float, closed: bool) -> None:
    control = bezier.segments(points, closed)
    counts = step_counts(control, tolerance)
    line = bezier.flatten(points, closed, tolerance)
    assert len(line) == counts.sum() + (not closed)
    for polygon, count in zip(control, counts, strict=True):
        if count == 4096:  # the bound on vertices: handles thousands of pixels long
            continue
        # Half way between two cuts a cubic strays about the most from its chord.
        for k in range(0, int(count), max(1, int(count) // 8)):
            start, middle, end = (casteljau(polygon, u / count) for u in (k, k + 0.5, k + 1))
            assert np.hypot(*(middle - (start + end) / 2.0)) <= tolerance * (1.0 + 1e-9) + 1e-9


def casteljau(polygon: Array, t: float) -> Array:
    """De Casteljau's construction, step by step."""
    while len(polygon) > 1:
        polygon = (1.0 - t) * polygon[:-1] + t * polygon[1:]
    return polygon[0]
