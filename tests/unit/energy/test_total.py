"""Tables and oracle: the energy of the paper's equations, as `tests.reference.energy` has them, in two ways."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
import pytest

from roam_core.energy import total
from roam_core.energy.colour_fields import ColourFields
from roam_core.energy.total import CurveContext, TableMemory
from roam_core.features import Region
from roam_core.features.grid import Grid
from roam_core.params import AppearanceParams, RoamParams
from tests.reference.cyclic_viterbi import chain_energy
from tests.reference.energy import ref_curve_energies
from tests.unit.kernels.conftest import EXACT

# No sample of any edge falls on a border between pixels, where rounding would choose the side.
NODES = (
    np.array([(12.31, 14.83), (25.17, 13.29), (31.73, 24.43), (22.61, 33.97), (11.23, 27.59)]) + np.sqrt(2.0) / 100.0
)
MOVES = np.array([(0.0, 0.0), (2.0, 0.0), (0.0, -2.0), (-2.0, 2.0)])


@pytest.fixture
def context() -> CurveContext:
    field = np.random.default_rng(2).random((30, 28)).astype(np.float32)
    return CurveContext(field, origin=(6, 8), spacing=12.0)


def test_the_shares_sum_to_the_total(context: CurveContext) -> None:
    shares = dict(total.energies(NODES, context, RoamParams()))
    assert shares.pop("total") == pytest.approx(sum(shares.values()))


def test_the_region_may_lie_anywhere(context: CurveContext) -> None:
    moved = replace(context, origin=(context.origin[0] + 50, context.origin[1] - 20))
    here = total.energies(NODES, context, RoamParams())
    there = total.energies(NODES + np.array([50.0, -20.0]), moved, RoamParams())
    assert there["total"] == pytest.approx(here["total"])


RIBBON = RoamParams(mu=0.3, lambda_local=0.4, appearance=AppearanceParams(term="ribbon", ribbon_depth=5.0))
COMPETITION = RoamParams(mu=0.3, lambda_local=0.05, lambda_global=0.02, appearance=AppearanceParams(term="region"))


CARRIED = (
    np.roll(NODES, -1, axis=0) - NODES + np.array([(1.0, 2.0), (-2.0, 0.5), (0.0, -1.0), (3.0, 1.0), (-2.0, -2.5)])
)
WARPED = RoamParams(mu=0.3, l2_rest=0.8)


def test_the_papers_l2_is_the_same_bit_by_bit_whatever_the_prewarp_carried(context: CurveContext) -> None:
    at_rest = replace(context, rest=CARRIED)
    tables = [total.pairwise_table(NODES, MOVES, each, RoamParams()) for each in (context, at_rest)]
    np.testing.assert_array_equal(*tables)


def test_an_outline_that_keeps_its_carried_edges_pays_no_l2(context: CurveContext) -> None:
    closed = np.roll(NODES, -1, axis=0) - NODES
    context = replace(context, rest=closed)
    params = replace(WARPED, l2_rest=1.0)
    assert total.energies(NODES + 2.5, context, params)["l2"] == pytest.approx(0.0, abs=1e-12)
    assert total.energies(1.1 * NODES, context, params)["l2"] == pytest.approx(0.3 * 0.01 * (closed**2).sum() / 144.0)


def test_other_curves_rest_at_length_zero(context: CurveContext) -> None:
    at_rest = replace(context, rest=CARRIED)
    halves = np.stack([NODES, 0.5 * (NODES + np.roll(NODES, -1, axis=0))], axis=1).reshape(-1, 2)
    ours = total.energies(halves, at_rest.for_any_curve(), WARPED)
    assert ours == total.energies(halves, context, replace(WARPED, l2_rest=0.0))


@pytest.fixture
def coloured(context: CurveContext) -> CurveContext:
    rng = np.random.default_rng(8)
    foreground, background, whole = rng.uniform(-13.0, -6.0, (3, 14, 15)).astype(np.float32)
    grid = Grid(Region(6, 8, 34, 38), 14, 15)  # cells of about two pixels, not quite square
    return replace(context, colours=ColourFields(grid, foreground, background, 4.0, whole + np.float32(9.0)))


JUDGED = {
    "no colour": RoamParams(mu=0.3, lambda_gradient=1.7),
    "rest edges": replace(WARPED, lambda_gradient=1.7),
    "ribbon": RIBBON,
    "ribbon and global": replace(RIBBON, lambda_global=0.02, l2_rest=0.5),
    "competition": COMPETITION,
}


@pytest.mark.parametrize("params", list(JUDGED.values()), ids=list(JUDGED))
@pytest.mark.parametrize("turned", [False, True], ids=["clockwise", "counter-clockwise"])
def test_the_oracle_has_the_energies_of_the_papers_equations(
    coloured: CurveContext, params: RoamParams, turned: bool
) -> None:
    at_rest = replace(coloured, rest=CARRIED, orientation=-1.0 if turned else 1.0)
    nodes = NODES[::-1].copy() if turned else NODES
    for labels in np.random.default_rng(5).integers(0, len(MOVES), (6, len(NODES))):
        ours = total.energies(nodes + MOVES[labels], at_rest, params)
        theirs = ref_curve_energies(nodes + MOVES[labels], at_rest, params)
        assert ours == pytest.approx({name: theirs.get(name, 0.0) for name in ours}, rel=EXACT, abs=EXACT)
        assert set(theirs) <= set(ours)


@pytest.mark.parametrize("params", list(JUDGED.values()), ids=list(JUDGED))
@pytest.mark.parametrize("turned", [False, True], ids=["clockwise", "counter-clockwise"])
def test_any_labelling_of_the_tables_has_the_energy_of_the_papers_equations(
    coloured: CurveContext, params: RoamParams, turned: bool
) -> None:
    at_rest = replace(coloured, rest=CARRIED, orientation=-1.0 if turned else 1.0)
    if params.appearance is None:
        at_rest = replace(at_rest, colours=None)
    nodes = NODES[::-1].copy() if turned else NODES
    unary, pairwise = np.zeros((len(nodes), len(MOVES))), total.pairwise_table(nodes, MOVES, at_rest, params)
    for labels in np.random.default_rng(4).integers(0, len(MOVES), (20, len(NODES))):
        direct = ref_curve_energies(nodes + MOVES[labels], at_rest, params)
        assert chain_energy(unary, pairwise, labels) == pytest.approx(direct["total"], rel=EXACT, abs=EXACT)


WEIGHTS = [each.name for each in fields(RoamParams) if each.name == "mu" or each.name.startswith("lambda_")]
"""Of the curve's terms, one of each."""


@pytest.mark.parametrize("weight", WEIGHTS)
@pytest.mark.parametrize("params", [RIBBON, COMPETITION], ids=["ribbon", "competition"])
def test_each_weight_scales_its_own_term(coloured: CurveContext, params: RoamParams, weight: str) -> None:
    once = total.energies(NODES, coloured, replace(params, **{weight: 0.1}))
    twice = total.energies(NODES, coloured, replace(params, **{weight: 0.2}))
    (term,) = {name for name in once if twice[name] != once[name]} - {"total"}
    assert once[term] != 0.0
    assert {name: twice[name] for name in once} == pytest.approx(
        once | {term: 2.0 * once[term], "total": once["total"] + once[term]}
    )


def test_the_judge_sees_every_term_with_all_that_it_looks_at(coloured: CurveContext) -> None:
    at_rest = replace(coloured, rest=CARRIED)
    assert [each.name for each in fields(CurveContext) if getattr(at_rest, each.name) is None] == []
    assert [weight for weight in WEIGHTS if not any(getattr(params, weight) for params in JUDGED.values())] == []


def test_region_terms_do_not_depend_on_the_number_of_nodes(coloured: CurveContext) -> None:
    """So that proposals of other curves can be compared: nodes in the middle of the edges change no sum over pixels."""
    halves = np.stack([NODES, 0.5 * (NODES + np.roll(NODES, -1, axis=0))], axis=1).reshape(-1, 2)
    few, many = (total.energies(nodes, coloured, COMPETITION) for nodes in (NODES, halves))
    assert many["local"] == pytest.approx(few["local"])
    assert many["global"] == pytest.approx(few["global"])


def test_log_ratios_are_clipped(coloured: CurveContext) -> None:
    assert coloured.colours is not None
    ratio = coloured.colours.log_ratio
    assert np.abs(ratio).max() == 4.0
    assert np.count_nonzero(np.abs(ratio) < 4.0) > ratio.size / 2


REMEMBERED = {"no colour": RoamParams(), "ribbon": RIBBON, "competition": COMPETITION, "rest edges": WARPED}


@pytest.mark.parametrize("params", list(REMEMBERED.values()), ids=list(REMEMBERED))
def test_remembered_tables_are_those_made_anew(coloured: CurveContext, params: RoamParams) -> None:
    coloured = replace(coloured, rest=CARRIED)
    memory, nodes = TableMemory(), NODES.copy()
    for moved in ([], [2], [], [0, 4], [1, 2, 3]):
        nodes = nodes.copy()
        nodes[moved] += 1.0
        remembered = memory.pairwise(nodes, MOVES, coloured, params)
        np.testing.assert_allclose(remembered, total.pairwise_table(nodes, MOVES, coloured, params), atol=1e-12)
    finer = memory.pairwise(nodes, 0.5 * MOVES, coloured, params)
    np.testing.assert_allclose(finer, total.pairwise_table(nodes, 0.5 * MOVES, coloured, params), atol=1e-12)
