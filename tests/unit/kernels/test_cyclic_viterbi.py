"""The exact minimum of cyclic chains, against plain Viterbi runs on chains of real size."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.kernels.cyclic_viterbi import cyclic_viterbi
from tests.reference.cyclic_viterbi import chain_energy, ref_cyclic_viterbi
from tests.unit.kernels.conftest import needs_compiler

LONG = [pytest.param(count, kinds, marks=needs_compiler) for count, kinds in ((120, 49), (220, 25))]


@pytest.mark.parametrize(("count", "kinds"), [(2, 9), (3, 25), (40, 25), *LONG])
def test_chains_of_real_size_equal_plain_viterbi_runs(count: int, kinds: int) -> None:
    rng = np.random.default_rng(count * 1000 + kinds)
    for smoothness in (0.0, 0.3, 3.0):
        unary = rng.normal(size=(count, kinds))
        gap = np.abs(np.arange(kinds)[:, None] - np.arange(kinds)) / kinds
        pairwise = rng.normal(size=(count, kinds, kinds)) + smoothness * kinds * gap
        labels, energy = cyclic_viterbi(unary, pairwise)
        assert energy == pytest.approx(ref_cyclic_viterbi(unary, pairwise)[1], abs=1e-9)
        assert energy == pytest.approx(chain_energy(unary, pairwise, labels), abs=1e-9)


def test_the_ring_must_close() -> None:
    """An open chain would start and end in different states: the bound of the first run is not the answer."""
    unary = np.zeros((3, 2))
    stay, cross = np.array([[0.0, 5.0], [5.0, 0.0]]), np.array([[5.0, 0.0], [0.0, 5.0]])
    labels, energy = cyclic_viterbi(unary, np.stack([stay, stay, cross]))
    assert energy == 5.0
    assert chain_energy(unary, np.stack([stay, stay, cross]), labels) == 5.0


def test_one_state_leaves_no_choice() -> None:
    labels, energy = cyclic_viterbi(np.full((4, 1), 2.0), np.full((4, 1, 1), 0.5))
    assert labels.tolist() == [0, 0, 0, 0]
    assert energy == 10.0


def test_equal_energies_give_the_same_labels_every_time() -> None:
    unary, pairwise = np.zeros((12, 9)), np.zeros((12, 9, 9))
    answers = {tuple(cyclic_viterbi(unary, pairwise)[0]) for _ in range(3)}
    assert len(answers) == 1


def test_tables_of_other_types_and_orders_give_the_same_answer() -> None:
    rng = np.random.default_rng(5)
    unary = rng.normal(size=(10, 5)).astype(np.float32)
    pairwise = np.asfortranarray(rng.normal(size=(10, 5, 5)).astype(np.float32))
    labels, energy = cyclic_viterbi(unary, pairwise)  # type: ignore[arg-type]
    expected, least = cyclic_viterbi(unary.astype(np.float64), np.ascontiguousarray(pairwise, dtype=np.float64))
    assert labels.tolist() == expected.tolist()
    assert energy == least


@pytest.mark.parametrize(("unary", "pairwise"), [((1, 3), (1, 3, 3)), ((4, 3), (3, 3, 3)), ((4, 3), (4, 3, 2))])
def test_what_is_no_cyclic_chain_is_refused(unary: tuple[int, ...], pairwise: tuple[int, ...]) -> None:
    with pytest.raises(ValueError, match="no cyclic chain"):
        cyclic_viterbi(np.zeros(unary), np.zeros(pairwise))


def test_infinity_forbids() -> None:
    rng = np.random.default_rng(9)
    unary, pairwise = rng.normal(size=(20, 6)), rng.normal(size=(20, 6, 6))
    unary[rng.random(unary.shape) < 0.2] = np.inf
    pairwise[rng.random(pairwise.shape) < 0.2] = np.inf
    labels, energy = cyclic_viterbi(unary, pairwise)
    assert energy == pytest.approx(ref_cyclic_viterbi(unary, pairwise)[1])
    assert energy == pytest.approx(chain_energy(unary, pairwise, labels))


@pytest.mark.parametrize("value", [np.inf, np.nan])
@pytest.mark.parametrize("count", [2, 7])
def test_a_ring_without_a_way_around_is_refused(count: int, value: float) -> None:
    pairwise = np.zeros((count, 4, 4))
    pairwise[1] = value
    with pytest.raises(ValueError, match="finite"):
        cyclic_viterbi(np.zeros((count, 4)), pairwise)


def test_a_ring_that_is_open_everywhere_but_where_it_closes_is_refused() -> None:
    """Each state leads to itself only, and the last node may close on any state but its own."""
    stay = np.where(np.eye(3) > 0, 0.0, np.inf)
    move = np.where(np.eye(3) > 0, np.inf, 0.0)
    with pytest.raises(ValueError, match="finite"):
        cyclic_viterbi(np.zeros((3, 3)), np.stack([stay, stay, move]))
