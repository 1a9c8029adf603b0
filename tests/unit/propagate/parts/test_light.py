"""Light that changes over an object in parts: all are known in that of the first key."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from roam_core import track
from roam_core.arrays import Array, UInt8
from roam_core.params import RoamParams, params_for
from roam_core.roto import RotoShape, edit
from tests.golden.shots import outline_distance
from tests.unit.propagate.figures import Figure, body_with_arms, hazy

COUNT, GIVEN, HAZY = 10, 5, 6
BEST = params_for("best+region.levels=none")
"""As they are: levels would see through some of the haze."""
WITHOUT_LIGHT = params_for("best+region.levels=none+region.exposure=none")


@pytest.fixture(scope="module")
def figure() -> Figure:
    return body_with_arms(COUNT)


def run(shapes: Sequence[RotoShape], pictures: Sequence[UInt8], params: RoamParams, first: int = 0) -> list[RotoShape]:
    *_, last = track(lambda frame: pictures[frame], shapes, range(first, COUNT), params)
    return [result.shape for result in last.results]


def confidence(shapes: Sequence[RotoShape], frame: int) -> float:
    """The least of all parts on a frame."""
    values = [key.confidence for shape in shapes if (key := shape.key_at(frame)) is not None]
    return min(value for value in values if value is not None)


def distances(shapes: Sequence[RotoShape], figure: Figure, frame: int) -> Array:
    """How far the outline of each part lies from the true one, pixels."""
    pairs = zip(shapes, figure.parts, strict=True)
    return np.array([outline_distance(shape.at(frame).points, part.truth(frame)) for shape, part in pairs])


def test_parts_look_as_on_their_keys_in_haze(figure: Figure) -> None:
    pictures = hazy(figure.pictures)
    known, unknown = (run(figure.shapes(), pictures, params) for params in (BEST, WITHOUT_LIGHT))
    assert confidence(known, HAZY) > 0.9
    assert confidence(unknown, HAZY) < 0.3
    assert distances(known, figure, HAZY).max() < 0.2 < distances(unknown, figure, HAZY).max()


def test_parts_that_are_not_corrected_still_know_their_light(figure: Figure) -> None:
    """The whole begins anew on a correction; what the others look like was learned in another light."""
    pictures = hazy(figure.pictures)
    shapes = run(figure.shapes(), pictures, BEST)
    corrected = [
        edit.set_key(shapes[1], GIVEN, figure.parts[1].truth(GIVEN)) if k == 1 else each
        for k, each in enumerate(shapes)
    ]
    again = run(corrected, pictures, BEST, GIVEN)
    assert confidence(again, COUNT - 1) > 0.9
    assert distances(again, figure, COUNT - 1).max() < 0.2
