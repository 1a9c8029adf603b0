"""Frames that show nothing: all of one colour, but for grain."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.arrays import UInt8
from roam_core.features import PreparedFrame, Region
from roam_core.features.blank import is_blank
from roam_core.geometry.bezier import polygon_points
from roam_core.params.evidence import BlankParams

SIZE, PARAMS = (240, 320), BlankParams()
SQUARE = polygon_points([(100, 100), (140, 100), (140, 140), (100, 140)])
OUTSIDE = SQUARE + 5000.0


def blank(image: UInt8, outline: np.ndarray = SQUARE) -> bool:
    return is_blank(PreparedFrame(image), [outline], PARAMS)


def flat(*colour: int) -> UInt8:
    return np.tile(np.uint8(colour), (*SIZE, 1))


@pytest.mark.parametrize("outline", [SQUARE, OUTSIDE], ids=["inside", "outside"])
@pytest.mark.parametrize("colour", [(0, 0, 0), (255, 255, 255), (16, 200, 90)])
@pytest.mark.parametrize("grain", [0.0, 5.0])
def test_a_picture_of_one_colour_is_blank(colour: tuple[int, int, int], grain: float, outline: np.ndarray) -> None:
    noise = np.random.default_rng(3).normal(0.0, grain, (*SIZE, 3))
    assert blank(np.uint8(np.clip(flat(*colour) + noise, 0, 255)), outline)


@pytest.mark.parametrize("outline", [SQUARE, OUTSIDE], ids=["inside", "outside"])
@pytest.mark.parametrize("spot", [(110, 120), (10, 300)], ids=["at the outline", "elsewhere"])
@pytest.mark.parametrize("channel", [0, 1, 2])
def test_one_with_a_single_spot_is_not(spot: tuple[int, int], channel: int, outline: np.ndarray) -> None:
    """A light in the night."""
    image = flat(8, 8, 8)
    image[spot[0] : spot[0] + 10, spot[1] : spot[1] + 10, channel] = 60
    assert not blank(image, outline)


def test_what_levels_cut_at_black_is_not_blank_and_what_they_stretch_counts_as_stretched() -> None:
    image = flat(20, 20, 20)
    image[:, 160:] = 26
    dark, stretched = (np.uint8(np.clip(4 * (np.arange(256) - black), 0, 255)) for black in (200, 10))
    assert blank(image)
    for table in (dark, stretched):
        assert not is_blank(PreparedFrame(image).levelled(table), [SQUARE + 40.0], PARAMS)


def test_a_small_picture_is_looked_at_too() -> None:
    image = flat(40, 40, 40)[:6, :40]
    assert blank(image)
    image[:, 20:] = 90
    assert not blank(image)


def test_no_more_is_looked_at_of_a_picture_that_shows_something_around_the_outlines(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    frame, looked_at = PreparedFrame(np.random.default_rng(4).integers(0, 255, (*SIZE, 3), dtype=np.uint8)), []
    within = PreparedFrame.within

    def watched(self: PreparedFrame, region: Region) -> UInt8:
        looked_at.append(region)
        return within(self, region)

    monkeypatch.setattr(PreparedFrame, "within", watched)
    assert not is_blank(frame, [SQUARE], PARAMS)
    assert looked_at == [Region.around(SQUARE, PARAMS.margin, SIZE)]
