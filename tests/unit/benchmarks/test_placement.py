"""Where the simulated artist sets keys, on shots whose fewest keys are known."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from benchmarks import placement
from benchmarks.methods import Hold, Linear
from benchmarks.shots import Shot


@given(st.integers(0, 20), st.integers(1, 40), st.integers(1, 40), st.integers(1, 50))
def test_the_farthest_key_is_found_where_longer_spans_are_worse(key: int, rest: int, reach: int, guess: int) -> None:
    last = key + rest
    found = placement.farthest(key, last, lambda stop: stop - key <= reach, guess)
    assert found == min(key + reach, last)


@given(st.integers(1, 60), st.sets(st.integers(2, 60)), st.integers(1, 60))
def test_a_key_that_is_found_holds_whatever_the_spans_do(last: int, good: set[int], guess: int) -> None:
    asked = []

    def holds(stop: int) -> bool:
        asked.append(stop)
        return stop in good

    found = placement.farthest(0, last, holds, guess)
    assert 0 < found <= last
    assert found == 1 or found in good
    assert len(asked) == len(set(asked))


def test_a_held_square_is_edited_whenever_it_has_slid_too_far(sliding: Shot) -> None:
    # A square of side 20 overlaps itself by (20 - d) / (20 + d): .818 after two frames, .739 after three.
    placed = placement.edits(Hold(), sliding, 0.8)
    assert placed.keys == (104, 107, 110, 113)
    assert min(placed.overlaps) >= 0.8
    assert len(placed.overlaps) == len(sliding.frames) - 1 - len(placed.keys)


def test_holding_needs_keys_as_far_apart_as_the_square_may_slide(sliding: Shot) -> None:
    placed = placement.fills(Hold(), sliding, 0.8)
    assert placed.keys == (101, 104, 107, 110, 113)
    assert min(placed.overlaps) >= 0.8


def test_steady_motion_is_linear_between_its_ends(sliding: Shot) -> None:
    placed = placement.fills(Linear(), sliding, 0.9)
    assert placed.keys == (101, 113)
    assert len(placed.overlaps) == 11


def test_keys_themselves_reach_the_mask(sliding: Shot) -> None:
    assert min(placement.reachable(sliding)) > 0.97


def test_regular_keys_reach_as_far_as_whole_gaps_do(sliding: Shot) -> None:
    assert placement.every(sliding, 5) == [101, 106, 111]
    assert placement.every(sliding, 50) == [101, 113]
    assert placement.filled(Linear(), sliding, [101, 106, 111]) > 0.95
    ahead, behind = (placement.carried(Hold(), sliding, [101, 106, 111], direction) for direction in (1, -1))
    expected = np.mean([(20 - d) / (20 + d) for d in range(1, 5)])
    assert ahead == pytest.approx(expected, abs=0.02)
    assert behind == pytest.approx(expected, abs=0.02)


def test_every_frame_of_a_shot_belongs_to_one_span(sliding: Shot) -> None:
    keys = placement.fills(Hold(), sliding, 0.7).keys
    assert keys[0] == sliding.first
    assert keys[-1] == sliding.last
    assert all(a < b for a, b in pairwise(keys))
