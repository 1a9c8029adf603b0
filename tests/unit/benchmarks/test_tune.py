"""Choosing parameters with one shot left out."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks import tune, variants
from roam_core.errors import RoamError
from roam_core.params import params_for


def test_a_shot_has_no_say_in_what_is_chosen_for_it() -> None:
    # The third trial is the best mean by far, thanks to the first shot alone.
    scores = np.array([[0.1, 0.2, 0.9], [0.5, 0.6, 0.5], [0.5, 0.6, 0.5]])
    held = tune.leave_one_out(scores)
    assert held.chosen == (1, 2, 2)
    assert held.mean == pytest.approx((0.2 + 0.5 + 0.5) / 3)


def test_the_present_parameters_win_a_draw() -> None:
    assert tune.leave_one_out(np.full((3, 4), 0.5)).chosen == (0, 0, 0)


def test_one_shot_cannot_be_left_out() -> None:
    with pytest.raises(RoamError, match="at least two"):
        tune.leave_one_out(np.ones((1, 3)))


def test_trials_are_all_combinations_and_the_present_first() -> None:
    params = params_for("best")
    trials = tune.combinations({"mu": [params.mu, 0.5], "region.bias": [0.0, -1.0]}, params, None)
    assert trials[0] == {"mu": params.mu, "region.bias": params.region.bias}  # type: ignore[union-attr]
    assert len(trials) == 5
    assert {"mu": 0.5, "region.bias": -1.0} in trials


def test_draws_are_the_same_each_time() -> None:
    params = params_for("baseline")
    values = {"mu": [float(k) for k in range(1, 40)]}
    drawn = tune.combinations(values, params, 5)
    assert drawn == tune.combinations(values, params, 5)
    assert len(drawn) == 6


def test_fields_are_changed_by_name() -> None:
    params = variants.with_field(variants.with_field(params_for("best"), "region.bias", -0.7), "window", 7)
    assert variants.field_of(params, "region.bias") == -0.7
    assert params.window == 7
    assert params.config == "best"
    full = params_for("full")
    blind = variants.with_field(full, "appearance.cues.doubted", 0.0)
    assert variants.field_of(blind, "appearance.cues.doubted") == 0.0
    assert variants.with_field(blind, "appearance.cues.doubted", full.appearance.cues.doubted) == full
