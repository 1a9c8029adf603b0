"""The contour's step: exact at every round, never uphill, in one voice with the oracle."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.cancel import Cancelled, CancelToken
from roam_core.energy import total
from roam_core.geometry import polyline
from roam_core.inference.contour_dp import best_moves, descend, square_moves, untangled
from tests.reference.cyclic_viterbi import ref_cyclic_viterbi
from tests.unit.inference.conftest import Problem


@pytest.mark.parametrize(("window", "step"), [(1, 1.0), (3, 2.0), (5, 1.0)])
def test_moves_are_a_lattice_around_staying(window: int, step: float) -> None:
    moves = square_moves(window, step)
    assert moves.shape == (window**2, 2)
    assert moves[len(moves) // 2].tolist() == [0.0, 0.0]
    reach = window // 2 * step
    assert moves.min(axis=0).tolist() == [-reach, -reach]
    assert moves.max(axis=0).tolist() == [reach, reach]
    assert len({tuple(move) for move in moves}) == window**2


@pytest.mark.parametrize("window", [0, 4, -3])
def test_a_window_of_moves_is_odd(window: int) -> None:
    with pytest.raises(ValueError, match="odd"):
        square_moves(window, 1.0)


@pytest.mark.parametrize("step", [2.0, 1.0])
def test_one_round_is_exact_and_its_energy_is_the_oracles(real: Problem, step: float) -> None:
    moves = square_moves(real.params.window, step)
    unary, pairwise = (
        np.zeros((len(real.nodes), len(moves))),
        total.pairwise_table(real.nodes, moves, real.context, real.params),
    )
    nodes, energy = best_moves(real.nodes, moves, real.context, real.params)
    assert energy == pytest.approx(ref_cyclic_viterbi(unary, pairwise)[1], abs=1e-9)
    assert energy == pytest.approx(total.energies(nodes, real.context, real.params)["total"], abs=1e-9)


def test_the_energy_falls_and_ends_at_the_oracles(real: Problem) -> None:
    before = total.energies(real.nodes, real.context, real.params)["total"]
    solution = descend(real.nodes, real.context, real.params, real.scale)
    trace = np.array([before, *solution.trace])
    assert (np.diff(trace) <= 1e-9).all()
    assert trace[-1] < before
    assert trace[-1] == pytest.approx(total.energies(solution.nodes, real.context, real.params)["total"], abs=1e-9)


def test_a_solved_outline_that_converged_stays_where_it_is(real: Problem) -> None:
    nodes = real.nodes
    for _ in range(40):
        solution = descend(nodes, real.context, real.params, real.scale)
        if np.array_equal(solution.nodes, nodes):
            break
        nodes = solution.nodes
    assert solution.converged
    assert np.array_equal(solution.nodes, nodes)


def test_a_cancelled_token_stops_the_rounds(real: Problem) -> None:
    token = CancelToken()
    token.cancel()
    with pytest.raises(Cancelled):
        descend(real.nodes, real.context, real.params, real.scale, token)


def test_further_unaries_take_part_in_the_minimum(real: Problem) -> None:
    target = real.nodes + np.array([3.0, 0.0])

    def pulled(nodes: np.ndarray, moves: np.ndarray) -> np.ndarray:
        away = nodes[:, None] + moves - target[:, None]
        return np.asarray(10.0 * (away**2).sum(axis=2))

    moves = square_moves(7, 1.0)
    nodes, energy = best_moves(real.nodes, moves, real.context, real.params, pulled)
    np.testing.assert_allclose(nodes, target, atol=1.0)
    curve = total.energies(nodes, real.context, real.params)["total"]
    assert energy == pytest.approx(curve + pulled(nodes, np.zeros((1, 2))).sum(), abs=1e-9)


def test_no_round_ties_a_simple_curve_into_loops(real: Problem) -> None:
    assert polyline.is_simple(real.nodes)
    assert polyline.is_simple(descend(real.nodes, real.context, real.params, real.scale).nodes)


RECTANGLE = polyline.resample(np.array([(0.0, 0.0), (40.0, 0.0), (40.0, 10.0), (0.0, 10.0)]), 50)


def test_untangling_puts_loops_back_and_leaves_the_rest() -> None:
    moved = RECTANGLE + np.array([1.0, 0.0])
    low = np.flatnonzero((RECTANGLE[:, 1] < 0.1) & (np.abs(RECTANGLE[:, 0] - 20.0) < 3.0))
    moved[low, 1] += 14.0  # through the opposite side
    assert not polyline.is_simple(moved)
    result = untangled(RECTANGLE, moved, 8)
    assert polyline.is_simple(result)
    np.testing.assert_array_equal(result[low], RECTANGLE[low])
    kept = (result == moved).all(axis=1)
    assert np.count_nonzero(kept) > len(kept) / 2


def test_a_curve_that_only_crosses_is_put_back_as_a_whole() -> None:
    scattered = np.random.default_rng(1).permutation(RECTANGLE)
    assert polyline.is_simple(untangled(RECTANGLE, scattered, 8))
