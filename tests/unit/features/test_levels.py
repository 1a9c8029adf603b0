"""Levels: what of a picture asks for more contrast, and what becomes of its values."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.arrays import UInt8
from roam_core.features import PreparedFrame
from roam_core.features.levels import Levels
from roam_core.params.evidence import LevelsParams

PARAMS = LevelsParams()
RAMP = np.tile(np.linspace(0.0, 1.0, 100), (70, 1))


def ramp(black: float, white: float) -> PreparedFrame:
    values = np.uint8(np.round(black + (white - black) * RAMP))
    return PreparedFrame(np.repeat(values[..., None], 3, axis=2))


def levels(picture: PreparedFrame) -> Levels | None:
    return Levels.of(picture, PARAMS)


def within(picture: PreparedFrame) -> UInt8:
    found = levels(picture)
    assert found is not None
    return picture.levelled(found.table).image


def test_a_picture_of_the_usual_contrast_is_seen_as_it_is() -> None:
    assert levels(ramp(10.0, 240.0)) is None


@pytest.mark.parametrize(("black", "white"), [(90.0, 160.0), (0.0, 80.0), (180.0, 250.0)])
def test_one_of_less_spans_what_a_usual_one_does(black: float, white: float) -> None:
    low, high = np.quantile(within(ramp(black, white))[..., 0], (PARAMS.dark, PARAMS.bright))
    assert low == pytest.approx(PARAMS.floor, abs=4.0)  # a level of the plate is up to three
    assert high == pytest.approx(PARAMS.floor + PARAMS.span, abs=4.0)


def test_one_of_nearly_none_is_not_made_of_grain() -> None:
    found = levels(ramp(100.0, 103.0))
    assert found is not None
    assert found.contrast == PARAMS.most


def test_plain_ground_around_an_object_asks_for_nothing() -> None:
    """On a usual plate there is plain ground, too: ice around a puck."""
    image = ramp(90.0, 120.0).image.copy()
    image[:, :8], image[:, 92:] = 10, 240
    assert levels(PreparedFrame(image)) is None


def test_a_levelled_picture_counts_as_given_and_is_made_once() -> None:
    picture = ramp(90.0, 160.0)
    found = levels(picture)
    assert found is not None
    levelled = picture.levelled(found.table)
    assert levelled is picture.levelled(found.table)
    darker = levelled.multiplied(np.array([0.5, 0.6, 0.7]), np.zeros(3))
    assert darker.given is levelled
    assert darker.plate is picture
    np.testing.assert_array_equal(
        darker.image, found.table[np.uint8(np.round(np.array([0.5, 0.6, 0.7]) * picture.image))]
    )
