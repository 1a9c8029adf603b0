"""Errors of spans between keys: the compiled loops against the slow twin."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.kernels.key_spans import cubic_span_errors, linear_span_errors, outline_distances
from tests.reference.key_spans import ref_distances, ref_span_error
from tests.unit.kernels.conftest import COMPILED


def moving(frames: int, curves: int = 1, seed: int = 0) -> Array:
    """Rings of 12 places that wander and shiver."""
    rng = np.random.default_rng(seed)
    angle = np.linspace(0, 2 * np.pi, 12, endpoint=False)
    ring = 20 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    path = np.cumsum(rng.normal(0, 2, (frames, curves, 1, 2)), axis=0)
    return np.asarray(ring + path + rng.normal(0, 0.3, (frames, curves, 12, 2)))


@pytest.mark.parametrize("closed", [True, False])
@pytest.mark.parametrize("cubic", [True, False])
def test_every_span_agrees_with_the_twin(closed: bool, cubic: bool) -> None:
    samples = moving(6, 2)
    measured = cubic_span_errors if cubic else linear_span_errors
    for start in range(6):
        errors = measured(samples, closed, start, 1e9)
        expected = [ref_span_error(samples, closed, start, stop, cubic=cubic) for stop in range(start + 1, 6)]
        assert np.isinf(errors[: start + 1]).all()
        np.testing.assert_allclose(errors[start + 1 :], expected, atol=1e-6)


@pytest.mark.parametrize("measured", [cubic_span_errors, linear_span_errors])
def test_spans_beyond_the_tolerance_are_infinite_and_the_others_exact(measured: type[linear_span_errors]) -> None:
    samples = moving(14, seed=3)
    everything = measured(samples, True, 0, 1e9)
    some = measured(samples, True, 0, 2.0)
    within = everything <= 2.0
    assert within.sum() not in (0, 13)
    np.testing.assert_array_equal(np.isfinite(some), within)
    np.testing.assert_array_equal(some[within], everything[within])


def test_a_cubic_motion_is_followed_exactly() -> None:
    count = 200 if COMPILED else 50
    u = np.linspace(0, 1, count)
    path = np.stack([300 * u**3 - 200 * u, 150 * u * (1 - u)], axis=1)[:, None, None]
    samples = moving(1) + path
    errors = cubic_span_errors(samples, True, 0, 400.0 / count**2)  # what a chord of one frame strays
    assert np.isfinite(errors[1:]).all()


def test_sliding_along_the_outline_costs_nothing_beyond_its_corners() -> None:
    side = np.stack([np.linspace(0, 100, 11), np.zeros(11)], axis=1)
    slid = side.copy()
    slid[1:-1, 0] += 4.0
    pair = [array[None, None] for array in (side, slid)]
    np.testing.assert_allclose(outline_distances(pair[0], pair[1], False), 0.0, atol=1e-12)


@pytest.mark.parametrize("closed", [True, False])
def test_distances_agree_with_the_twin(closed: bool) -> None:
    places, others = moving(3, 2, 1), moving(3, 2, 2)
    np.testing.assert_allclose(
        outline_distances(places, others, closed), ref_distances(places, others, closed), atol=1e-12
    )


def test_shapes_of_arrays_are_checked() -> None:
    with pytest.raises(ValueError, match=r"not \(F, C, S, 2\)"):
        linear_span_errors(np.zeros((3, 4, 2)), True, 0, 1.0)
    with pytest.raises(ValueError, match="frame 3"):
        cubic_span_errors(np.zeros((3, 1, 4, 2)), True, 3, 1.0)
    with pytest.raises(ValueError, match=r"not both \(F, C, S, 2\)"):
        outline_distances(np.zeros((3, 1, 4, 2)), np.zeros((3, 1, 5, 2)), True)
