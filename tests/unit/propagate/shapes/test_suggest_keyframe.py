"""The frame that is offered as most worth fixing."""

from __future__ import annotations

from dataclasses import replace

import pytest

from roam_core.geometry import bezier
from roam_core.params import DOUBTFUL
from roam_core.propagate.shapes.suggest_keyframe import suggest_keyframe
from roam_core.roto import Keyframe, Origin, RotoShape

SQUARE = bezier.polygon_points([(0.0, 0.0), (9.0, 0.0), (9.0, 9.0)])
BAD = DOUBTFUL / 2.0


def artist(frame: int) -> Keyframe:
    return Keyframe(frame, SQUARE)


def tracked(confidences: dict[int, float | None], how: str = "forward") -> list[Keyframe]:
    return [
        Keyframe(frame, SQUARE, origin=Origin.ENGINE, confidence=each, inputs=f"{how}:best:0")
        for frame, each in confidences.items()
    ]


def shape(*keys: Keyframe) -> RotoShape:
    return RotoShape("shape-1", "Body", tuple(sorted(keys, key=lambda key: key.frame)))


def test_nothing_is_offered_where_nothing_is_doubtful() -> None:
    assert suggest_keyframe(shape(artist(1))) is None
    assert suggest_keyframe(shape(artist(1), *tracked({2: 1.0, 3: DOUBTFUL, 4: None}))) is None


def test_the_beginning_of_a_bad_stretch_is_offered_not_its_worst_frame() -> None:
    falling = {2: 0.99, 3: 0.98, 4: BAD, 5: BAD, 6: BAD - 0.01, 7: BAD, 8: BAD}
    assert suggest_keyframe(shape(artist(1), *tracked(falling))) == 4


def test_frames_on_which_the_shape_does_not_exist_are_not_offered() -> None:
    ended = replace(shape(artist(1), *tracked({2: 0.99, 3: BAD + 0.1, 4: BAD, 5: BAD})), lifetime=(1, 4))
    assert suggest_keyframe(ended) == 3
    assert suggest_keyframe(replace(ended, lifetime=(1, 3))) is None


def test_keys_that_a_shortened_lifetime_left_beside_it_make_no_frame_worth_more() -> None:
    first, second = {2: BAD, 3: 0.99}, {12: BAD, 13: 0.99, 14: 0.99}
    ended = replace(shape(artist(1), *tracked(second), *tracked(first, "fill")), lifetime=(1, 13))
    assert suggest_keyframe(ended) == 2


def test_backwards_a_bad_stretch_begins_at_its_end() -> None:
    falling = {2: BAD, 3: BAD, 4: BAD, 5: 0.99}
    assert suggest_keyframe(shape(artist(6), *tracked(falling, "backward"))) == 4


def test_a_long_stretch_goes_before_a_short_one() -> None:
    short, long = {2: 0.1, 3: 0.1}, {12: 0.3, 13: 0.3, 14: 0.3, 15: 0.3}
    assert suggest_keyframe(shape(artist(1), *tracked(short), artist(11), *tracked(long))) == 12


def test_a_hopeless_frame_goes_before_a_little_doubt() -> None:
    mild = dict.fromkeys(range(2, 5), DOUBTFUL - 0.01)
    assert suggest_keyframe(shape(artist(1), *tracked(mild), artist(9), *tracked({10: 0.0, 11: 0.0}))) == 10


def test_between_two_keys_the_worst_frame_is_offered() -> None:
    gap = {2: 0.9, 3: BAD, 4: BAD - 0.1, 5: BAD, 6: 0.9}
    assert suggest_keyframe(shape(artist(1), *tracked(gap, "fill"), artist(7))) == 4


@pytest.mark.parametrize("confidence", [0.0, BAD])
def test_the_earlier_of_two_equals(confidence: float) -> None:
    both = [*tracked({2: confidence}), artist(3), *tracked({4: confidence})]
    assert suggest_keyframe(shape(artist(1), *both)) == 2
