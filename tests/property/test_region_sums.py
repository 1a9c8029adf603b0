"""The discrete Green theorem (equation 5): sums along the edges equal the sum over the region."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from roam_core.arrays import Float32, Int64
from roam_core.energy.curve import pairwise_global
from roam_core.geometry import polyline
from roam_core.kernels.region_sums import region_sums, row_sums
from tests.reference.region_sums import ref_region_sum

STAY = np.zeros((1, 2))

fields = arrays(np.float32, (7, 9), elements=st.floats(-6.0, 6.0, width=32))
polygons = arrays(np.int64, st.tuples(st.integers(3, 9), st.just(2)), elements=st.integers(-2, 10))
"""Vertices on the integer grid of pixels, as in the paper; they may repeat, and the edges may cross."""


@settings(max_examples=40)
@given(fields, polygons)
def test_edge_sums_equal_the_region_sum_on_pixel_centres(field: Float32, grid: Int64) -> None:
    nodes = grid + 0.5
    total = region_sums(row_sums(field), nodes, STAY).sum()
    assert total == pytest.approx(ref_region_sum(field, nodes), abs=1e-4)


@settings(max_examples=40)
@given(fields, polygons, st.floats(-0.9, 0.9), st.floats(-0.9, 0.9))
def test_edge_sums_equal_the_region_sum_anywhere(field: Float32, grid: Int64, dx: float, dy: float) -> None:
    nodes = grid * np.array([0.93, 1.07]) + np.array([dx, dy])
    total = region_sums(row_sums(field), nodes, STAY).sum()
    assert total == pytest.approx(ref_region_sum(field, nodes), abs=1e-4)


@settings(max_examples=40)
@given(fields, polygons.filter(lambda grid: polyline.signed_area(grid.astype(float)) != 0.0))
def test_the_global_term_does_not_depend_on_the_way_round(field: Float32, grid: Int64) -> None:
    nodes = grid + 0.25
    sums = row_sums(field)
    sign = float(np.sign(polyline.signed_area(nodes)))
    one = pairwise_global(nodes, STAY, sums, sign, 2.0).sum()
    other = pairwise_global(nodes[::-1].copy(), STAY, sums, -sign, 2.0).sum()
    assert one == pytest.approx(other, abs=1e-4)
    assert one == pytest.approx(-sign * ref_region_sum(field, nodes) / 2.0, abs=1e-4)
