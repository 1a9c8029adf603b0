"""An outline drawn to where the frames beside have it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.geometry import bezier
from roam_core.params import RESIDUAL, UNTYING, SteadinessParams
from roam_core.propagate.steadiness.residual import Places
from roam_core.propagate.steadiness.settle import known_steps, settled
from tests.golden.shots import blob

CIRCLE = blob(np.full(8, 40.0)) + 100.0
PLACES = Places.of(CIRCLE, RESIDUAL, 1.0)
PARAMS = SteadinessParams()


def radius(points: np.ndarray) -> float:
    return float(np.hypot(*(bezier.flatten(points) - 100.0).T).mean())


def test_without_neighbours_it_stays_where_it_was_found() -> None:
    assert settled(CIRCLE, PLACES, [], [], PARAMS, UNTYING, 1.0) == pytest.approx(CIRCLE)


@pytest.mark.parametrize("weight", [0.25, 0.5, 2.0])
def test_one_that_lies_outside_of_both_neighbours_goes_in_to_the_mean_of_the_three(weight: float) -> None:
    """What lies about a third of `alike` apart counts in full, about."""
    out = np.full(len(PLACES.t), 0.5)
    params = replace(PARAMS, weight=weight)
    near = weight * np.exp(-0.5 / params.fades**2)
    found = radius(settled(CIRCLE, PLACES, [out], [-out], params, UNTYING, 1.0))
    assert found - radius(CIRCLE) == pytest.approx(-0.5 * 2.0 * near / (1.0 + 2.0 * near), abs=0.03)


def test_one_that_was_elsewhere_on_this_frame_alone_comes_back_to_where_all_others_are() -> None:
    out, still = np.full(len(PLACES.t), 8.0), np.zeros(len(PLACES.t))
    found = settled(CIRCLE, PLACES, [out, still], [-out, still], replace(PARAMS, weight=0.5), UNTYING, 1.0)
    assert radius(found) - radius(CIRCLE) == pytest.approx(-8.0, abs=0.2)


def test_an_even_motion_that_the_flow_does_not_see_moves_nothing() -> None:
    """One pixel outwards on every frame: what both sides say takes itself out."""
    step = np.full(len(PLACES.t), 1.0)
    found = settled(CIRCLE, PLACES, [step, step], [step, step], PARAMS, UNTYING, 1.0)
    assert found == pytest.approx(CIRCLE, abs=1e-6)


def test_a_neighbour_that_is_elsewhere_is_not_followed() -> None:
    far = np.full(len(PLACES.t), 15.0)
    assert radius(settled(CIRCLE, PLACES, [far], [], PARAMS, UNTYING, 1.0)) == pytest.approx(radius(CIRCLE), abs=1e-3)


def test_it_goes_only_where_it_trembles() -> None:
    step = np.where(PLACES.segment == 0, 2.0, 0.0)
    moved = np.hypot(*(settled(CIRCLE, PLACES, [step], [-step], PARAMS, UNTYING, 1.0) - CIRCLE)[:, 0].T)
    assert moved[[0, 1]].min() > 0.2
    assert moved[[3, 4, 5, 6]].max() < 0.1


def test_more_frames_than_are_asked_for_change_nothing() -> None:
    rng = np.random.default_rng(1)
    steps = list(rng.normal(size=(4, len(PLACES.t))))
    asked = replace(PARAMS, reach=2)
    ours = settled(CIRCLE, PLACES, steps[:2], [], asked, UNTYING, 1.0)
    assert settled(CIRCLE, PLACES, steps, [], asked, UNTYING, 1.0) == pytest.approx(ours)


def test_what_is_known_ends_where_a_step_is_not() -> None:
    steps = [np.zeros(3), None, np.ones(3)]
    assert len(known_steps(steps)) == 1
    assert known_steps([]) == []
