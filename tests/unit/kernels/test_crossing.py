"""Crossing edges against the slow twin."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.kernels.crossing import crossing_edges
from tests.reference.crossing import ref_crossing_edges


@pytest.mark.parametrize("closed", [True, False])
@pytest.mark.parametrize("seed", range(5))
def test_crossings_are_those_of_the_plain_double_loop(seed: int, closed: bool) -> None:
    line = np.random.default_rng(seed).uniform(0, 100, (14, 2))
    comp = crossing_edges(line, closed).tolist()
    assert comp == ref_crossing_edges(line, closed)
    assert comp


def test_a_convex_outline_and_a_single_point_have_none() -> None:
    angle = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    assert len(crossing_edges(np.stack([np.cos(angle), np.sin(angle)], axis=1), True)) == 0
    assert len(crossing_edges(np.zeros((1, 2)), True)) == 0
