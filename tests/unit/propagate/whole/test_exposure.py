"""Light that falls on the whole picture: an object is known in the light of its key."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from roam_core import RotoShape, fill_span, keys_from_mask, render_matte, shapes_from_mask, track
from roam_core.arrays import UInt8
from roam_core.features import PreparedFrame
from roam_core.geometry import similarity
from roam_core.params import RoamParams, params_for
from roam_core.propagate import TrackMemory
from roam_core.propagate.frame.result import Part
from roam_core.propagate.whole.region import step
from roam_core.propagate.whole.state import begin
from tests.unit.propagate.dimmed import SIZE, body_into_the_dark, dimmed_body, shaded_body

BEST = params_for("best+region.levels=none")
"""As they are: a wall in haze would be told from the body by its levels alone."""
COUNT, BY = 13, 0.45
MIDDLE = np.array([[SIZE[1] / 2, SIZE[0] / 2]])
Shot = tuple[list[UInt8], list[UInt8]]


def without_exposure() -> RoamParams:
    assert BEST.region is not None
    return replace(BEST, region=replace(BEST.region, exposure=None))


@pytest.fixture(scope="module")
def dimmed() -> Shot:
    return dimmed_body(COUNT, BY)


def tracked(shot: Shot, params: RoamParams) -> list[RotoShape]:
    pictures, masks = shot
    *_, last = track(lambda frame: pictures[frame], shapes_from_mask(masks[0]), range(COUNT), params)
    return [result.shape for result in last.results]


def overlaps(shapes: Sequence[RotoShape], masks: Sequence[UInt8], frames: range) -> list[float]:
    found = []
    for frame in frames:
        ours, true = render_matte(shapes, frame, SIZE) > 0.5, masks[frame] > 0
        found.append(float((ours & true).sum() / (ours | true).sum()))
    return found


def test_the_wall_in_less_light_is_not_taken_for_the_body(dimmed: Shot) -> None:
    ends = range(COUNT - 4, COUNT)
    known, unknown = (
        np.mean(overlaps(tracked(dimmed, params), dimmed[1], ends)) for params in (BEST, without_exposure())
    )
    assert known > 0.93
    assert known > unknown + 0.1


def test_a_fill_hears_both_keys_in_the_light_of_each_frame(dimmed: Shot) -> None:
    pictures, masks = dimmed
    keyed = keys_from_mask(shapes_from_mask(masks[0]), masks[-1], COUNT - 1)
    known, unknown = (
        min(overlaps(fill_span(dict(enumerate(pictures)), keyed, 0, COUNT - 1, params), masks, range(1, COUNT - 1)))
        for params in (BEST, without_exposure())
    )
    assert known > 0.96
    assert known > unknown + 0.05


@pytest.mark.parametrize("remembering", [True, False], ids=["remembering", "solving again"])
def test_a_stop_in_falling_light_changes_nothing(dimmed: Shot, remembering: bool) -> None:
    pictures, masks = dimmed
    memory = TrackMemory() if remembering else None

    def on(shapes: list[RotoShape], frames: range) -> list[RotoShape]:
        *_, last = track(lambda frame: pictures[frame], shapes, frames, BEST, memory=memory)
        return [result.shape for result in last.results]

    stopped = on(on(shapes_from_mask(masks[0]), range(8)), range(7, COUNT))
    whole = tracked(dimmed, BEST)
    assert stopped == whole


def test_where_the_light_stays_the_points_are_the_same_bit_by_bit() -> None:
    shot = dimmed_body(COUNT, 0.0)
    ours, theirs = tracked(shot, BEST), tracked(shot, without_exposure())
    assert [key.points.tolist() for key in ours[0].keys] == [key.points.tolist() for key in theirs[0].keys]


def test_light_that_comes_back_leaves_nothing_behind(dimmed: Shot) -> None:
    """The light is always that since the key: it does not add up from frame to frame."""
    pictures, masks = dimmed
    region = BEST.region
    assert region is not None
    assert region.exposure is not None
    parts = tuple(Part(2.0 * shape.at(0).points) for shape in shapes_from_mask(masks[0]))
    enlarged = [PreparedFrame(picture).resized((2 * SIZE[0], 2 * SIZE[1])) for picture in pictures]
    state = begin(enlarged[0], parts, region)
    gains = []
    for frame in (*range(1, 8), *range(6, 0, -1)):
        state = step(state, enlarged[frame], region).state
        gains.append(state.key.light.exposure)
    fallen = 1.0 - BY * 7 / (COUNT - 1)
    assert gains[6] == pytest.approx(fallen * np.exp(region.exposure.within), rel=0.03)
    assert gains[-1] == 1.0


def test_light_that_falls_in_haze_is_told_beneath_the_levels() -> None:
    """Levels shift black, which light does not: on stretched values it would not be a factor."""
    pictures, masks = dimmed_body(COUNT, 0.0)
    lights = np.linspace(1.0, 1.0 - BY, COUNT)
    hazy = [
        np.uint8(np.round(light * (150.0 + (each - 128.0) / 2.0))) for light, each in zip(lights, pictures, strict=True)
    ]
    ends = range(COUNT - 4, COUNT)
    levelled, plain = params_for("best"), params_for("best+region.exposure=none")
    known, unknown = (np.mean(overlaps(tracked((hazy, masks), each), masks, ends)) for each in (levelled, plain))
    assert known > 0.93
    assert known > unknown + 0.3


def test_a_shadow_whose_edge_crosses_the_body_changes_nothing_of_it() -> None:
    pictures, masks = shaded_body(COUNT, 0.55)
    assert BEST.region is not None
    assert BEST.region.exposure is not None
    none = replace(BEST.region.exposure, shadow=replace(BEST.region.exposure.shadow, share=2.0))
    without = replace(BEST, region=replace(BEST.region, exposure=none))
    known, unknown = (
        min(overlaps(tracked((pictures, masks), params), masks, range(1, COUNT))) for params in (BEST, without)
    )
    assert known > 0.97
    assert known > unknown + 0.1


def test_what_a_shadow_goes_over_stands_still_and_looks_as_on_the_key() -> None:
    """Over a faint texture flow goes along with the body: drawn so, the wall would leave the key's light untold."""
    pictures, masks = shaded_body(COUNT, 0.55)
    region = BEST.region
    assert region is not None
    parts = tuple(Part(shape.at(0).points) for shape in shapes_from_mask(masks[0]))
    state = begin(PreparedFrame(pictures[0]), parts, region)
    for picture in pictures[1:]:
        state = step(state, PreparedFrame(picture), region).state
        assert state.resemblance > 0.7
        assert state.is_told_by_colours
        assert np.hypot(*(similarity.apply(state.key.surroundings[:2], MIDDLE) - MIDDLE)[0]) < 2.0
    assert state.key.light.exposure == pytest.approx(0.45, rel=0.1)


def test_one_that_goes_into_the_dark_is_not_left_for_what_looks_more_like_it() -> None:
    """The wall tells nothing of it: it stays as dark as it was. So the body looks less and less as on its key."""
    pictures, masks = body_into_the_dark(COUNT + 3, 0.7)
    *_, last = track(lambda frame: pictures[frame], shapes_from_mask(masks[0]), range(COUNT + 3), BEST)
    assert min(overlaps([last.results[0].shape], masks, range(1, COUNT + 3))) > 0.92
