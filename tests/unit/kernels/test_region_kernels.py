"""The kernels of the region proposals against their slow twins."""

from __future__ import annotations

import numpy as np
import numpy.testing as npt
import pytest

from roam_core.kernels.alignment import align, prices
from roam_core.kernels.diffusion import diffuse
from roam_core.kernels.local_match import log_ratio, nearest_colours
from tests.reference.local_match import ref_align, ref_local_match, smoothing_energy


@pytest.mark.parametrize("reach", [3, 40])
@pytest.mark.parametrize("seed", range(4))
def test_the_ratio_of_the_nearest_colours_is_that_of_a_plain_search_through_the_window(seed: int, reach: int) -> None:
    rng = np.random.default_rng(seed)
    colours, memory = rng.integers(0, 40, (2, 9, 11, 3)).astype(np.float32)
    labels = rng.integers(0, 3, (9, 11)).astype(np.uint8)
    shift = rng.uniform(-reach, reach, (9, 11, 2)).astype(np.float32)
    wanted = np.ones((9, 11), dtype=bool)
    comp = log_ratio(*nearest_colours(colours, memory, labels, wanted, shift, 2, 0.3), 3.0, 2.5)
    ref = ref_local_match(colours, memory, labels, shift, 2, 3.0, 0.3, 2.5)
    npt.assert_allclose(comp, ref, atol=1e-4)


def test_pixels_that_are_not_wanted_are_like_nothing() -> None:
    picture = np.zeros((5, 5, 3), dtype=np.float32)
    labels = np.ones((5, 5), dtype=np.uint8)
    nobody, still = np.zeros((5, 5), bool), np.zeros((5, 5, 2), np.float32)
    assert not log_ratio(*nearest_colours(picture, picture, labels, nobody, still, 1, 0.1), 2.0, 3.0).any()


def test_every_sweep_lowers_the_smoothing_energy_towards_its_minimum() -> None:
    rng = np.random.default_rng(3)
    field = rng.normal(size=(8, 10)).astype(np.float32)
    colours = rng.uniform(0, 30, (8, 10, 3)).astype(np.float32)
    wanted = np.ones(field.shape, dtype=bool)
    energies = [
        smoothing_energy(diffuse(field, colours, wanted, 2.0, 12.0, sweeps), field, colours, 2.0, 12.0)
        for sweeps in (0, 1, 2, 5, 60, 120)
    ]
    assert energies == sorted(energies, reverse=True)
    assert energies[0] > 1.05 * energies[-1]
    npt.assert_allclose(energies[-1], energies[-2], rtol=1e-5)


def test_smoothing_comes_to_rest_where_every_wanted_cell_is_the_mean_of_its_own_value_and_its_neighbours() -> None:
    """Weighted by how alike they are; cells that are not wanted hold theirs, on the rim fewer neighbours have a say."""
    rng = np.random.default_rng(7)
    field = rng.normal(size=(7, 9)).astype(np.float32)
    colours, wanted = rng.uniform(0, 30, (7, 9, 3)), rng.random((7, 9)) < 0.6
    result = diffuse(field, colours.astype(np.float32), wanted, 2.0, 12.0, 300)
    for y, x in np.argwhere(wanted):
        total, weights = float(field[y, x]), 1.0
        for row, column in ((y - 1, x), (y + 1, x), (y, x - 1), (y, x + 1)):
            if 0 <= row < 7 and 0 <= column < 9:
                weight = 2.0 * np.exp(-((colours[y, x] - colours[row, column]) ** 2).sum() / (2.0 * 12.0**2))
                total, weights = total + weight * result[row, column], weights + weight
        assert result[y, x] == pytest.approx(total / weights, abs=1e-4)


def test_smoothing_holds_what_is_not_wanted() -> None:
    rng = np.random.default_rng(4)
    field = rng.normal(size=(6, 6)).astype(np.float32)
    wanted = np.zeros(field.shape, dtype=bool)
    wanted[2:4, 2:4] = True
    result = diffuse(field, np.zeros((6, 6, 3), np.float32), wanted, 5.0, 12.0, 10)
    npt.assert_array_equal(result[~wanted], field[~wanted])
    assert (result[wanted] != field[wanted]).all()


FARTHEST = 9.0
"""The most that distance costs."""


def test_prices_are_those_of_each_pair_by_itself() -> None:
    rng = np.random.default_rng(2)
    nodes, samples = ((rng.uniform(0, 30, (k, 2)), rng.normal(size=(k, 2)), rng.random((k, 3))) for k in (5, 8))
    cost = prices(nodes, samples, 6.0, FARTHEST, 1.5, 20.0)
    distances = np.square((nodes[0][:, None] - samples[0]) / 6.0).sum(axis=2)
    assert distances.min() < FARTHEST < distances.max()
    for n in range(5):
        for m in range(8):
            away = min(float(distances[n, m]), FARTHEST)
            opposite = 0.5 * (1.0 - float(nodes[1][n] @ samples[1][m]))
            unlike = float(np.square(nodes[2][n] - samples[2][m]).mean())
            assert cost[n, m] == pytest.approx(away + 1.5 * opposite + 20.0 * unlike)


@pytest.mark.parametrize("seed", range(6))
def test_alignment_is_the_least_of_all_ways_around(seed: int) -> None:
    rng = np.random.default_rng(seed)
    count, samples = 4, 9
    cost = rng.uniform(0, 2, (count, samples))
    expected = rng.uniform(1.0, 3.0, count)
    starts = [0, 4, 7]
    indices, energy = align(cost, expected, 0.7, np.array(starts))
    assert energy == pytest.approx(ref_align(cost, expected, 0.7, starts))
    steps = np.diff(np.append(indices, indices[0])) % samples
    ratios = steps / expected - 1.0
    assert energy == pytest.approx(cost[np.arange(count), indices].sum() + 0.7 * (ratios**2).sum())
    assert steps.sum() == samples


def test_alignment_wants_enough_samples() -> None:
    with pytest.raises(ValueError, match="too few"):
        align(np.zeros((4, 7)), np.ones(4), 1.0, np.array([0]))
