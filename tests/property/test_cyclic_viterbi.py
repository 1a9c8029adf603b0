"""The solver against all labellings of tiny rings, ties included."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from roam_core.arrays import Array
from roam_core.kernels.cyclic_viterbi import cyclic_viterbi
from tests.reference.cyclic_viterbi import chain_energy, comp_cyclic_viterbi, ref_cyclic_viterbi

Tables = tuple[Array, Array]

VALUES = {
    "real": st.floats(-100.0, 100.0),
    "ties": st.integers(-2, 2).map(float),
}


@st.composite
def rings(draw: st.DrawFn) -> Tables:
    """Unary and pairwise tables of a ring of 2-6 nodes and 1-4 states; half of them full of ties."""
    count, kinds = draw(st.integers(2, 6)), draw(st.integers(1, 4))
    values = VALUES[draw(st.sampled_from(sorted(VALUES)))]
    unary = draw(arrays(np.float64, (count, kinds), elements=values))
    return unary, draw(arrays(np.float64, (count, kinds, kinds), elements=values))


@given(rings())
def test_equals_brute_force(tables: Tables) -> None:
    unary, pairwise = tables
    labels, energy = cyclic_viterbi(unary, pairwise)
    assert energy == pytest.approx(comp_cyclic_viterbi(unary, pairwise), abs=1e-9)
    assert energy == pytest.approx(chain_energy(unary, pairwise, labels), abs=1e-9)


@given(rings())
def test_the_twin_equals_brute_force(tables: Tables) -> None:
    labels, energy = ref_cyclic_viterbi(*tables)
    assert energy == pytest.approx(comp_cyclic_viterbi(*tables), abs=1e-9)
    assert energy == pytest.approx(chain_energy(*tables, labels), abs=1e-9)


@given(rings(), st.integers(1, 5))
def test_it_does_not_matter_which_node_is_the_first(tables: Tables, turn: int) -> None:
    unary, pairwise = tables
    energy = cyclic_viterbi(unary, pairwise)[1]
    turned = cyclic_viterbi(np.roll(unary, turn, axis=0), np.roll(pairwise, turn, axis=0))[1]
    assert turned == pytest.approx(energy, abs=1e-9)
