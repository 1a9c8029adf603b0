"""Colours sorted into bins, against the slow twin."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.kernels.colour_bins import bin_counts, looked_up
from tests.reference.colour_bins import ref_bin_counts, ref_looked_up


@pytest.mark.parametrize("spread", [3.0, 90.0, 400.0])  # one colour, many, and mostly black or white
def test_counts_are_those_of_the_twin(spread: float) -> None:
    rng = np.random.default_rng(1)
    image = np.clip(rng.normal(128, spread, (40, 50, 3)), 0, 255).astype(np.uint8)
    wanted = rng.random((40, 50)) < 0.6
    counts = bin_counts(image, wanted)
    np.testing.assert_array_equal(counts, ref_bin_counts(image, wanted))
    assert counts.sum() == wanted.sum()


def test_nothing_wanted_is_no_colour() -> None:
    assert not bin_counts(np.zeros((4, 5, 3), np.uint8), np.zeros((4, 5), bool)).any()


def test_each_pixel_gets_what_its_bin_holds() -> None:
    rng = np.random.default_rng(2)
    image = rng.integers(0, 256, (7, 9, 3)).astype(np.uint8)
    table = rng.normal(0, 1, 32**3).astype(np.float32)
    np.testing.assert_array_equal(looked_up(image, table), ref_looked_up(image, table))
