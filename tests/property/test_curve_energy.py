"""Solver and brute force over all configurations of tiny curves: one minimum, with every term of the curve.

What a configuration costs is told by the paper's equations (`tests.reference.energy`), not by the engine's terms.
"""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from roam_core.arrays import Array
from roam_core.energy.colour_fields import ColourFields
from roam_core.energy.total import CurveContext
from roam_core.features import Region
from roam_core.features.grid import Grid
from roam_core.inference.contour_dp import best_moves
from roam_core.params import AppearanceParams, RoamParams
from tests.reference.energy import ref_curve_energies
from tests.unit.kernels.conftest import EXACT

WEIGHTS = {
    "gradient and l2": RoamParams(mu=0.4, lambda_gradient=1.3),
    "ribbon": RoamParams(mu=0.4, lambda_local=0.3, appearance=AppearanceParams(term="ribbon", ribbon_depth=4.0)),
    "competition and global": RoamParams(mu=0.4, lambda_local=0.1, lambda_global=0.07, appearance=AppearanceParams()),
    "rest at the pre-warp": RoamParams(mu=0.4, l2_rest=1.0, lambda_local=0.1, appearance=AppearanceParams()),
    "rest between": RoamParams(mu=0.4, l2_rest=0.7, lambda_gradient=1.3),
}


def tiny(seed: int) -> tuple[Array, Array, CurveContext]:
    """A curve of three to five nodes with three moves each on pictures of chance."""
    rng = np.random.default_rng(seed)
    count = int(rng.integers(3, 6))
    angles = np.sort(rng.uniform(0.0, 2.0 * np.pi, count))
    nodes = 12.0 + rng.uniform(4.0, 9.0, (count, 1)) * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    moves = np.vstack([np.zeros(2), rng.uniform(-3.0, 3.0, (2, 2))])
    foreground, background, whole = rng.uniform(-12.0, -6.0, (3, 22, 24)).astype(np.float32)
    colours = ColourFields(Grid(Region(0, 0, 24, 22), 22, 24), foreground, background, 3.0, whole + np.float32(9.0))
    gradient = rng.random((24, 24)).astype(np.float32)
    orientation = float(rng.choice([-1.0, 1.0]))
    rest = np.roll(nodes, -1, axis=0) - nodes + rng.uniform(-3.0, 3.0, nodes.shape)
    return nodes, moves, CurveContext(gradient, (0, 0), 8.0, orientation, colours, rest)


@pytest.mark.parametrize("name", list(WEIGHTS))
@settings(max_examples=8)
@given(seed=st.integers(0, 10_000))
def test_the_solver_finds_the_least_of_the_energies_of_all_configurations(name: str, seed: int) -> None:
    nodes, moves, context = tiny(seed)
    params = WEIGHTS[name]
    all_energies = [
        ref_curve_energies(nodes + moves[list(labels)], context, params)["total"]
        for labels in product(range(len(moves)), repeat=len(nodes))
    ]
    solved, energy = best_moves(nodes, moves, context, params)
    assert energy == pytest.approx(min(all_energies), rel=EXACT, abs=EXACT)
    assert energy == pytest.approx(ref_curve_energies(solved, context, params)["total"], rel=EXACT, abs=EXACT)
