"""Dials: what they turn, what a configuration with turned dials is called, and that names come back as parameters."""

from __future__ import annotations

from pathlib import Path

import pytest

from roam_core.dials import DIALS, dials_of, name_of
from roam_core.errors import RoamError
from roam_core.geometry.bezier import polygon_points
from roam_core.params import CONFIGS, departed, params_for
from roam_core.propagate.shapes.provenance import clip_stamp, is_stale, stamp
from roam_core.roto import Clip, Keyframe, Origin, RotoShape, edit

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])


@pytest.mark.parametrize("config", list(CONFIGS))
def test_every_dial_that_is_offered_turns_something_both_ways(config: str) -> None:
    params = CONFIGS[config]
    offered = dials_of(params)
    assert offered
    for dial in offered:
        assert dial.turn(params, 1.0) == params
        assert dial.turn(params, dial.low) != params != dial.turn(params, dial.high)


def test_what_a_configuration_has_not_cannot_be_turned() -> None:
    assert {dial.name for dial in dials_of(CONFIGS["baseline"])} == {"reach", "firmness", "smoothness"}
    assert {dial.name for dial in dials_of(CONFIGS["full"])} == {dial.name for dial in DIALS} - {"steadiness"}


def test_what_told_nothing_for_regions_is_not_offered_there_and_a_name_that_turns_it_is_understood() -> None:
    assert {dial.name for dial in dials_of(CONFIGS["best"])} == {"reach", "smoothness", "key", "steadiness"}
    turned, usual = params_for("best+firmness=2").region, CONFIGS["best"].region
    assert turned is not None
    assert usual is not None
    assert turned.prior_weight == 2.0 * usual.prior_weight
    (sentence,) = departed("best+firmness=2+reach=2")
    assert "firmness" in sentence
    assert departed("best+reach=2+region.prior_weight=0.1") == departed("lean+firmness=2") == []


def test_a_name_tells_the_dials_that_are_turned_and_comes_back_as_parameters() -> None:
    name = name_of("best", {"key": 1.0, "learning": 0.0, "reach": 1.5})
    assert name == "best+reach=1.5+learning=0"
    params, best = params_for(name), CONFIGS["best"].region
    assert params.region is not None
    assert best is not None
    assert params.config == name
    assert (params.region.band, params.region.adaptation) == (best.band * 1.5, 0.0)
    assert params_for(name) is params
    assert name_of("best", {"reach": 1.0}) == "best"


@pytest.mark.parametrize(
    "name", ["best+speed=2", "best+reach=fast", "best+reach=nan", "best+reach=900", "abacus+reach=2"]
)
def test_a_name_that_makes_no_sense_is_refused_in_a_sentence(name: str) -> None:
    with pytest.raises(RoamError, match=r"\.$"):
        params_for(name)


def test_a_frame_made_with_turned_dials_is_fresh_until_its_key_changes() -> None:
    clip, params = Clip(Path("shot"), 1, 9, (64, 48)), params_for("best+reach=2")
    shape = RotoShape("s", "s", (Keyframe(1, SQUARE),))
    inputs = stamp([shape], 2, 1, params, clip_stamp(clip), True)
    made = Keyframe(2, SQUARE, origin=Origin.ENGINE, inputs=inputs)
    tracked = edit.set_engine_keys(shape, [made])
    assert not is_stale(tracked, made, clip)
    assert is_stale(edit.set_key(tracked, 1, SQUARE + 1), made, clip)
    other = Keyframe(2, SQUARE, origin=Origin.ENGINE, inputs=inputs.replace("reach=2", "reach=3"))
    assert is_stale(tracked, other, clip)


def test_key_colours_at_nothing_leave_the_key_out() -> None:
    region, usual = params_for("best+key=0").region, params_for("best").region
    assert region is not None
    assert usual is not None
    assert region.texture is not None
    assert (region.key_weight, region.key_aged, region.texture.key) == (0.0, 0.0, 0.0)
    louder = params_for("best+key=2").region
    assert louder is not None
    assert 0.0 < louder.key_aged < usual.key_aged
