"""Means along candidate edges: against the twin, and where they can be told by hand."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.kernels.edge_sums import edge_means
from tests.reference.edge_sums import ref_edge_means
from tests.unit.kernels.conftest import EXACT

STAY = np.zeros((1, 2))


def test_equals_the_twin_inside_and_outside_the_image() -> None:
    rng = np.random.default_rng(3)
    field = rng.random((30, 40)).astype(np.float32)
    nodes = rng.uniform((-15.0, -15.0), (55.0, 45.0), (14, 2))
    moves = rng.uniform(-3.0, 3.0, (5, 2))
    np.testing.assert_allclose(
        edge_means(field, nodes, moves), ref_edge_means(field, nodes, moves), rtol=EXACT, atol=1e-12
    )


def test_a_constant_field_has_its_value_on_every_edge_inside() -> None:
    nodes = np.array([(5.2, 5.1), (20.7, 6.3), (12.4, 22.9)])
    moves = np.array([(0.0, 0.0), (1.5, -2.0), (-3.0, 3.0)])
    np.testing.assert_allclose(edge_means(np.full((30, 30), 0.25, np.float32), nodes, moves), 0.25)


def test_the_last_vertex_belongs_to_the_next_edge() -> None:
    field = np.zeros((5, 10), dtype=np.float32)
    field[2, 6] = 1.0
    means = edge_means(field, np.array([(2.5, 2.5), (6.5, 2.5)]), STAY)
    assert means.ravel() == pytest.approx([0.0, 0.25])


def test_an_edge_outside_the_image_means_nothing() -> None:
    nodes = np.array([(-9.0, -9.0), (-3.0, -8.0), (-5.0, -2.0)])
    assert not edge_means(np.ones((8, 8), np.float32), nodes, STAY).any()


def test_an_edge_of_no_length_is_the_pixel_it_lies_in() -> None:
    field = np.arange(12, dtype=np.float32).reshape(3, 4)
    assert edge_means(field, np.array([(2.5, 1.5), (2.5, 1.5)]), STAY).ravel() == pytest.approx([6.0, 6.0])


def test_a_moved_edge_has_the_mean_of_the_same_edge_drawn_there() -> None:
    """The tables and the oracle must speak of the same number, however far an edge is stretched by its moves."""
    rng = np.random.default_rng(8)
    field = rng.random((40, 40)).astype(np.float32)
    nodes = np.array([(8.0, 8.0), (20.25, 9.5), (24.0, 21.75), (10.5, 25.0)])
    moves = np.array([(0.0, 0.0), (4.0, -4.0), (-4.0, 4.0)])
    table = edge_means(field, nodes, moves)
    labels = np.array([1, 2, 0, 1])
    drawn = edge_means(field, nodes + moves[labels], STAY).ravel()
    np.testing.assert_array_equal(drawn, table[np.arange(4), labels, np.roll(labels, -1)])
