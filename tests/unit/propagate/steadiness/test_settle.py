"""How far an outline is to move on each frame, for steps that are known."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.arrays import Array, Bools
from roam_core.params.steadiness import STEADINESS
from roam_core.propagate.steadiness.settle import settled

FRAMES, PLACES = 9, 5


def moved(offsets: Array, fixed: Bools | None = None, strength: float = 1.0, trust: float = 1.0) -> Array:
    """Where outlines that were off by `offsets (T,)` at every place, on a picture without motion, lie then."""
    steps = np.tile(np.diff(offsets)[:, None], PLACES)
    held = np.zeros(FRAMES, dtype=bool) if fixed is None else fixed
    by = settled(steps, np.full(steps.shape, trust), held, strength, STEADINESS, 1.0)
    assert by.shape == (FRAMES, PLACES)
    assert by == pytest.approx(np.tile(by[:, :1], PLACES))
    return np.asarray(offsets + by[:, 0])


def test_it_is_the_least_of_what_it_says() -> None:
    """Small steps count in full: the solution is that of the plain normal equations."""
    offsets = 0.01 * np.random.default_rng(1).normal(size=FRAMES)
    first, second = np.diff(np.eye(FRAMES), axis=0), np.diff(np.eye(FRAMES), n=2, axis=0)
    stiff = STEADINESS.step * first.T @ first + STEADINESS.turn * second.T @ second
    assert moved(offsets) == pytest.approx(np.linalg.solve(np.eye(FRAMES) + stiff, offsets), abs=1e-5)


@pytest.mark.parametrize("held", [0, 4, 8])
def test_fixed_frames_stay_and_hold_those_beside_them(held: int) -> None:
    offsets = np.full(FRAMES, 1.0)
    offsets[held] = 0.0
    fixed = np.arange(FRAMES) == held
    found = moved(offsets, fixed)
    assert found[held] == 0.0
    beside = held + 1 if held < FRAMES - 1 else held - 1
    assert 0.2 < found[beside] < 0.9


def test_trembling_of_a_pixel_is_less_the_stronger_it_is_asked_for() -> None:
    offsets = 0.5 * (-1.0) ** np.arange(FRAMES)
    left = [np.abs(np.diff(moved(offsets, strength=strength))).mean() for strength in (0.1, 0.5, 1.0)]
    assert 1.0 > left[0] > left[1] > left[2]
    assert left[1] < 0.2


def test_what_beats_by_many_pixels_is_left_alone() -> None:
    offsets = 6.0 * (-1.0) ** np.arange(FRAMES)
    assert moved(offsets) == pytest.approx(offsets, abs=0.02)


def test_an_even_drift_moves_nothing_between_fixed_frames() -> None:
    fixed = np.isin(np.arange(FRAMES), (0, FRAMES - 1))
    offsets = 0.4 * np.arange(FRAMES)
    assert moved(offsets, fixed) == pytest.approx(offsets, abs=1e-9)


def test_what_cannot_be_trusted_or_is_not_asked_for_moves_nothing() -> None:
    offsets = 0.5 * (-1.0) ** np.arange(FRAMES)
    assert np.array_equal(moved(offsets, trust=0.0), offsets)
    assert np.array_equal(moved(offsets, strength=0.0), offsets)
