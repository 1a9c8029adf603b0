"""Sums over the inside of polygons as sums along their edges: where they can be told by hand."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.kernels.region_sums import region_sums, row_sums
from tests.reference.region_sums import ref_region_sum

STAY = np.zeros((1, 2))
SQUARE = np.array([(2.0, 2.0), (6.0, 2.0), (6.0, 5.0), (2.0, 5.0)])
"""Clockwise on screen; it encloses the centres of 4 x 3 pixels."""


def test_row_sums_count_what_lies_to_the_left() -> None:
    assert row_sums(np.array([[1.0, 2.0, 4.0]], np.float32)).tolist() == [[0.0, 1.0, 3.0, 7.0]]


def test_a_square_of_ones_has_its_area_with_the_sign_of_its_way_round() -> None:
    sums = row_sums(np.ones((8, 9), np.float32))
    assert region_sums(sums, SQUARE, STAY).sum() == 12.0
    assert region_sums(sums, SQUARE[::-1].copy(), STAY).sum() == -12.0


def test_neighbours_that_share_an_edge_share_no_pixel() -> None:
    """Vertices and edges on pixel centres, as in the paper: every pixel is counted for one of two neighbours."""
    field = np.random.default_rng(1).random((12, 14)).astype(np.float32)
    sums = row_sums(field)
    left = np.array([(1.5, 1.5), (6.5, 1.5), (6.5, 9.5), (1.5, 9.5)])
    right = np.array([(6.5, 1.5), (11.5, 1.5), (11.5, 9.5), (6.5, 9.5)])
    both = np.array([(1.5, 1.5), (11.5, 1.5), (11.5, 9.5), (1.5, 9.5)])
    apart = region_sums(sums, left, STAY).sum() + region_sums(sums, right, STAY).sum()
    assert apart == pytest.approx(region_sums(sums, both, STAY).sum())


def test_what_lies_outside_the_field_is_zero() -> None:
    sums = row_sums(np.ones((8, 9), np.float32))
    wide = np.array([(-20.0, -10.0), (40.0, -10.0), (40.0, 30.0), (-20.0, 30.0)])
    assert region_sums(sums, wide, STAY).sum() == 72.0
    assert region_sums(sums, wide + 100.0, STAY).sum() == 0.0


def test_any_labelling_has_the_sum_of_its_own_polygon() -> None:
    rng = np.random.default_rng(5)
    field = rng.normal(size=(30, 32)).astype(np.float32)
    angles = np.linspace(0.0, 2.0 * np.pi, 7, endpoint=False)
    nodes = np.stack([16.0 + 9.0 * np.cos(angles), 15.0 + 8.0 * np.sin(angles)], axis=1)
    moves = np.vstack([STAY, rng.uniform(-4.0, 4.0, (5, 2))])
    shares = region_sums(row_sums(field), nodes, moves)
    for labels in rng.integers(0, len(moves), (20, len(nodes))):
        total = shares[np.arange(len(nodes)), labels, np.roll(labels, -1)].sum()
        assert total == pytest.approx(ref_region_sum(field, nodes + moves[labels]), abs=1e-6)


def test_an_edge_that_stays_has_the_papers_share_and_a_moved_one_what_it_swept() -> None:
    sums = row_sums(np.ones((20, 20), np.float32))
    moves = np.array([(0.0, 0.0), (3.0, 0.0)])
    shares = region_sums(sums, SQUARE, moves)
    # The right side, from (6, 2) down to (6, 5): Q is 6 in three rows; both ends moved to the right sweep 9 pixels.
    assert shares[1, 0, 0] == 18.0
    assert shares[1, 1, 1] == 18.0 + 9.0
