"""Tables and oracle: the same energy, asked for in two ways."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.energy import total
from roam_core.energy.total import CurveContext
from roam_core.params import RoamParams
from tests.reference.cyclic_viterbi import chain_energy

# No sample of any edge falls on a border between pixels, where rounding would choose the side.
NODES = (
    np.array([(12.31, 14.83), (25.17, 13.29), (31.73, 24.43), (22.61, 33.97), (11.23, 27.59)]) + np.sqrt(2.0) / 100.0
)
MOVES = np.array([(0.0, 0.0), (2.0, 0.0), (0.0, -2.0), (-2.0, 2.0)])


@pytest.fixture
def context() -> CurveContext:
    field = np.random.default_rng(2).random((30, 28)).astype(np.float32)
    return CurveContext(field, origin=(6, 8), spacing=12.0)


def test_any_labelling_of_the_tables_has_the_oracles_energy(context: CurveContext) -> None:
    params = RoamParams(mu=0.3, lambda_gradient=1.7)
    unary, pairwise = total.tables(NODES, MOVES, context, params)
    for labels in np.random.default_rng(4).integers(0, len(MOVES), (20, len(NODES))):
        direct = total.energies(NODES + MOVES[labels], context, params)
        assert chain_energy(unary, pairwise, labels) == pytest.approx(direct["total"], abs=1e-12)


def test_the_shares_sum_to_the_total(context: CurveContext) -> None:
    shares = dict(total.energies(NODES, context, RoamParams()))
    assert shares.pop("total") == pytest.approx(sum(shares.values()))


@pytest.mark.parametrize(("weight", "term"), [("mu", "l2"), ("lambda_gradient", "gradient")])
def test_each_weight_scales_its_own_term(context: CurveContext, weight: str, term: str) -> None:
    params = RoamParams()
    once = total.energies(NODES, context, params)
    twice = total.energies(NODES, context, replace(params, **{weight: 2.0 * getattr(params, weight)}))
    changed = {name for name in once if twice[name] != once[name]}
    assert changed == {term, "total"}
    assert twice[term] == pytest.approx(2.0 * once[term])


def test_the_region_may_lie_anywhere(context: CurveContext) -> None:
    moved = replace(context, origin=(context.origin[0] + 50, context.origin[1] - 20))
    here = total.energies(NODES, context, RoamParams())
    there = total.energies(NODES + np.array([50.0, -20.0]), moved, RoamParams())
    assert there["total"] == pytest.approx(here["total"])
