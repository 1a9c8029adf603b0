"""What is told of keys that were tracked with dials or parameters that are gone."""

from __future__ import annotations

import pytest

from roam_core.geometry import bezier
from roam_core.propagate.shapes.departed import departed_settings
from roam_core.roto import Keyframe, Origin, RotoShape

SQUARE = bezier.polygon_points([(0.0, 0.0), (9.0, 0.0), (9.0, 9.0)])


def tracked_with(*configs: str) -> RotoShape:
    """A shape with a tracked key for each configuration, twice, between other keys that no run made."""
    inputs = ["", "import::0:from=1", *(f"forward:{config}:0:from=1" for config in configs for _ in range(2))]
    keys = [Keyframe(1, SQUARE)]
    keys += [Keyframe(2 + k, SQUARE, origin=Origin.ENGINE, inputs=each) for k, each in enumerate(inputs)]
    return RotoShape("shape-1", "Body", tuple(keys))


def test_nothing_is_told_of_what_is_still_offered() -> None:
    assert departed_settings([]) == ""
    assert departed_settings([tracked_with("best", "best+reach=2+region.band=6", "lean+firmness=2")]) == ""


@pytest.mark.parametrize("config", ["best+firmness=2", "best+reach=2+learning=0.5"])
def test_a_departed_dial_is_told_once(config: str) -> None:
    told = departed_settings([tracked_with("best", config), tracked_with(config)])
    assert told == (
        f"Keys were tracked with '{config}', which turns a dial that is offered no more: they stay as they are."
    )


@pytest.mark.parametrize("config", ["best+region.nose=2", "abacus", "best+reach=900"])
def test_a_parameter_that_is_not_there_is_told_once(config: str) -> None:
    told = departed_settings([tracked_with("best", config)])
    assert told == f"Keys were tracked with '{config}', which this program does not know: they count as stale."


def test_many_names_and_long_ones_make_one_sentence_too() -> None:
    told = departed_settings([tracked_with(*(f"n{k}" for k in range(5)), "a" * 300, "best+firmness=2")])
    assert told.startswith("Keys were tracked with 'best+firmness=2', which turns a dial")
    assert f"; and with '{'a' * 57}...', 'n0', 'n1' and 3 more, which this program" in told
    assert told.count(".") == 4
