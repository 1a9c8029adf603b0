"""Short runs from many start frames."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks import restarts
from benchmarks.shots import Shot


def test_runs_begin_at_regular_distances_and_end_with_the_shot() -> None:
    assert restarts.runs(range(1001, 1051), length=15, gap=20) == [
        range(1001, 1017),
        range(1021, 1037),
        range(1041, 1051),
    ]


def test_no_run_is_shorter_than_it_is_worth() -> None:
    assert [len(run) - 1 for run in restarts.runs(range(25), length=15, gap=20)] == [15, 4]
    assert [len(run) - 1 for run in restarts.runs(range(24), length=15, gap=20)] == [15]


def test_each_run_begins_from_the_truth(gliding: Shot) -> None:
    found = restarts.measured(gliding, "baseline", length=2, gap=3)
    assert len(found) == 2
    assert min(found) > 0.9


def test_runs_without_an_object_to_follow_are_passed_over(gliding: Shot) -> None:
    masks = [np.zeros_like(mask) if k == 0 else mask for k, mask in enumerate(gliding.masks)]
    hidden = Shot("hidden", gliding.first, gliding.pictures, masks)
    assert len(restarts.measured(hidden, "baseline", length=2, gap=3)) == 1


def test_the_spread_is_that_of_the_runs() -> None:
    spread = restarts.spread([0.5, 0.7])
    assert spread["mean"] == pytest.approx(0.6)
    assert spread["spread"] == pytest.approx(0.1)
    assert spread["least"] == pytest.approx(0.5)
