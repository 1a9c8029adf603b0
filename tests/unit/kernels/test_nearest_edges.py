"""The nearest edge of every pixel: against the twin."""

from __future__ import annotations

import numpy as np

from roam_core.kernels.nearest_edges import FAR, nearest_edges
from tests.reference.nearest_edges import ref_edge_distances


def test_equals_the_twin() -> None:
    nodes = np.array([(6.3, 5.1), (20.2, 7.7), (17.4, 18.9), (3.8, 30.2)])
    index, distance = nearest_edges(nodes, (26, 28), 5.0)
    twin = ref_edge_distances(nodes, (26, 28))
    near = twin.min(axis=2) < 5.0
    assert 0 < np.count_nonzero(near) < near.size
    np.testing.assert_array_equal(index != FAR, near)
    np.testing.assert_allclose(distance[near], twin.min(axis=2)[near], rtol=1e-6)
    # Beyond a shared vertex two edges are equally near.
    chosen = np.take_along_axis(twin, np.where(near, index, 0)[..., None], axis=2)[..., 0]
    np.testing.assert_allclose(chosen[near], twin.min(axis=2)[near], atol=1e-6)


def test_nothing_is_near_an_outline_elsewhere() -> None:
    nodes = np.array([(100.0, 100.0), (120.0, 100.0), (110.0, 120.0)])
    assert (nearest_edges(nodes, (20, 20), 8.0)[0] == FAR).all()
