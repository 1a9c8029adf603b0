"""Means over both sides of candidate edges: against the twin, and where they can be told by hand."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.kernels.ribbon_means import ribbon_means
from tests.reference.ribbon_means import ref_ribbon_mean

STAY = np.zeros((1, 2))


@pytest.mark.parametrize("step", [2.0, 3.0])
def test_equals_the_twin_inside_and_outside_the_image(step: float) -> None:
    rng = np.random.default_rng(7)
    left, right = rng.random((2, 24, 30)).astype(np.float32)
    nodes = rng.uniform((-6.0, -6.0), (36.0, 30.0), (6, 2))
    moves = rng.uniform(-3.0, 3.0, (4, 2))
    means = ribbon_means(left, right, nodes, moves, 7.0, step)
    ahead = np.roll(nodes, -1, axis=0)
    for n, i, j in np.ndindex(means.shape):
        twin = ref_ribbon_mean(left, right, nodes[n] + moves[i], ahead[n] + moves[j], 7.0, step)
        assert means[n, i, j] == pytest.approx(twin, abs=1e-6)


def test_left_and_right_are_those_of_the_screen() -> None:
    left, right = np.zeros((2, 20, 20), np.float32)
    left[:, 10:], right[:, :10] = 1.0, 3.0
    # Downwards along the border: on screen, what lies on the left of the way is the right half of the picture.
    means = ribbon_means(left, right, np.array([(10.0, 4.0), (10.0, 16.0)]), STAY, 6.0, 2.0)
    assert means.ravel() == pytest.approx([4.0, 0.0])


def test_an_edge_of_no_length_is_its_point() -> None:
    field = np.arange(36, dtype=np.float32).reshape(6, 6)
    assert ribbon_means(field, field, np.full((2, 2), 2.5), STAY, 4.0, 2.0).ravel() == pytest.approx([28.0, 28.0])
