"""Positions carried by projective maps, each by its own."""

from __future__ import annotations

import numpy as np
import numpy.testing as npt
import pytest

from roam_core.geometry import projective

MAPS = np.array([np.eye(3), [[2.0, 0.5, 3.0], [-0.5, 2.0, 1.0], [1e-3, 2e-3, 1.0]], [[1, 0, 5], [0, 1, 0], [0, 0, -1]]])


@pytest.mark.parametrize("shape", [(3, 2), (3, 4, 2), (3, 1, 4, 3, 2)])
def test_each_map_carries_its_own_positions(shape: tuple[int, ...]) -> None:
    positions = np.random.default_rng(2).uniform(-50.0, 50.0, shape)
    carried = projective.apply_each(MAPS, positions)
    for k in (0, 1):
        npt.assert_allclose(carried[k], projective.apply(MAPS[k], positions[k]), atol=1e-9)
    npt.assert_allclose(carried[2], -(positions[2] + [5.0, 0.0]), atol=1e-9)  # behind the viewer it is turned over


def test_what_goes_to_infinity_is_refused() -> None:
    far = np.array([[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.01, 0.0, 1.0]]])
    with pytest.raises(ValueError, match="to infinity"):
        projective.apply_each(far, np.array([[[0.0, 0.0], [-100.0, 3.0]]]))
