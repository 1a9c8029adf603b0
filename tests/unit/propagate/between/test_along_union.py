"""Parts between two keys that their poses do not bring along: they go with the union of both passes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from roam_core import fill_span, render_matte
from roam_core.geometry.simple import crossing_segments
from roam_core.params import RoamParams, params_for
from roam_core.propagate.frame.confidence import overlap
from roam_core.roto import RotoShape
from tests.unit.propagate.figures import SIZE, Figure, body_with_arms, flame, keys_of

FIRST, LAST = 0, 7


@pytest.fixture(scope="module")
def bending() -> Figure:
    return flame(LAST + 1)


def filled(figure: Figure, config: str | RoamParams = "best") -> list[RotoShape]:
    pictures = dict(enumerate(figure.pictures))
    return fill_span(pictures, figure.shapes(FIRST, LAST), FIRST, LAST, config)


def by_poses(covered: float = 0.0) -> RoamParams:
    """`best`, where no pass takes a part along, and all parts together miss their region from an overlap of less on."""
    params = params_for("best")
    assert params.region is not None
    figure = replace(params.region.figure, unfit=np.inf, covered=covered)
    return replace(params, region=replace(params.region, figure=figure))


def overlaps(figure: Figure, shapes: Sequence[RotoShape]) -> list[float]:
    """Those of each part with its truth, where no other lies, on every frame between the keys; the least of a frame."""
    found = []
    for frame in range(FIRST + 1, LAST):
        true = [render_matte([shape], frame, SIZE) > 0.5 for shape in figure.shapes(frame)]
        ours = [render_matte([shape], frame, SIZE) > 0.5 for shape in shapes]
        alone = ~np.logical_and.reduce(true)
        found.append(min(overlap(a & alone, b & alone) for a, b in zip(ours, true, strict=True)))
    return found


@pytest.fixture(scope="module")
def along(bending: Figure) -> list[RotoShape]:
    return filled(bending, by_poses(0.95))


def test_parts_of_what_bends_lie_where_it_went(bending: Figure, along: list[RotoShape]) -> None:
    assert min(overlaps(bending, along)) > 0.8
    assert min(overlaps(bending, filled(bending, by_poses()))) < 0.4


def test_so_do_those_that_their_passes_took_along(bending: Figure) -> None:
    assert min(overlaps(bending, filled(bending))) > 0.65


def test_they_are_simple_and_the_artists_keys_as_they_were(bending: Figure, along: list[RotoShape]) -> None:
    drawn = bending.shapes(FIRST, LAST)
    assert [shape.artist_keys for shape in along] == [shape.keys for shape in drawn]
    assert all(len(crossing_segments(key.points)) == 0 for shape in along for key in shape.keys)


def test_what_went_along_is_trusted_as_the_whole_is(along: list[RotoShape]) -> None:
    told = [[key.confidence for key in shape.keys if FIRST + 1 < key.frame < LAST] for shape in along]
    assert len(told) == 2
    assert all(confidence is not None and confidence > 0.9 for each in told for confidence in each)


def test_parts_whose_poses_fit_keep_to_them() -> None:
    stiff = body_with_arms(LAST + 1)
    found, stiffly = filled(stiff), filled(stiff, by_poses())
    assert [keys_of(_unstamped(shape)) for shape in found] == [keys_of(_unstamped(shape)) for shape in stiffly]


def test_what_both_passes_brought_to_one_place_stays_also_where_the_region_is_missed() -> None:
    stiff = body_with_arms(LAST + 1)
    found, stiffly = filled(stiff, by_poses(np.inf)), filled(stiff, by_poses())
    assert [keys_of(_unstamped(shape)) for shape in found] == [keys_of(_unstamped(shape)) for shape in stiffly]


def test_a_part_that_begins_on_a_key_tells_where_the_object_is(bending: Figure) -> None:
    lower, upper = bending.shapes(FIRST, LAST)
    begun = replace(upper, keys=upper.keys[1:])
    found, _ = fill_span(dict(enumerate(bending.pictures)), [lower, begun], FIRST, LAST)
    assert [key.frame for key in found.keys] == list(range(FIRST, LAST + 1))


def _unstamped(shape: RotoShape) -> RotoShape:
    """A shape without what tells from what its keys were made."""
    return replace(shape, keys=tuple(replace(key, inputs="") for key in shape.keys))
