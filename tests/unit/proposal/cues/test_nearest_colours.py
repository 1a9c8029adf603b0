"""The nearest colours of the last and of the key frame: what they say of the next one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.arrays import Array, Bools
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.geometry.similarity import IDENTITY
from roam_core.params import RegionParams
from roam_core.proposal.cues.nearest_colours import NearestColours

SIZE = (120, 160)
GRID = Grid.over(Region(20, 10, 140, 110), 1.0)
PARAMS = RegionParams()
RED, GREEN, BLUE = (180, 60, 60), (60, 150, 60), (60, 60, 180)
GRAIN = np.random.default_rng(3).normal(0.0, 4.0, (*SIZE, 3))


def box(x: float, side: float = 40.0) -> Array:
    """A square outline `(4, 2)` whose left edge lies at x."""
    return np.array([[x, 40.0], [x + side, 40.0], [x + side, 40.0 + side], [x, 40.0 + side]])


def picture(x: int, colour: tuple[int, int, int] = RED) -> PreparedFrame:
    """The square filled, on a green background."""
    image = np.full((*SIZE, 3), GREEN, dtype=np.float64)
    image[40:80, x : x + 40] = colour
    return PreparedFrame(np.clip(image + GRAIN, 0, 255).astype(np.uint8))


def inside(x: float) -> Bools:
    """The cells of `GRID` that the square covers."""
    rows, columns = np.mgrid[: GRID.rows, : GRID.columns] + 0.5
    place = GRID.to_image(np.stack([columns, rows], axis=-1))
    return np.asarray(((place > [x, 40.0]) & (place < [x + 40.0, 80.0])).all(axis=-1))


def test_the_object_is_seen_where_it_went_and_not_where_it_was() -> None:
    known = NearestColours.learned(picture(60), box(60.0), PARAMS)
    ratio = known.log_ratio(picture(66), GRID, IDENTITY)
    assert ratio.shape == GRID.shape
    assert np.mean((ratio > 0) == inside(66.0)) > 0.98
    gone = inside(60.0) & ~inside(66.0)
    assert ratio[gone].mean() < -1.0


@pytest.mark.parametrize(("weight", "aged"), [(0.0, 0.0), (0.5, 0.0), (0.0, 2.0)])
def test_a_colour_that_only_the_key_had_is_known_by_the_key(weight: float, aged: float) -> None:
    params = replace(PARAMS, key_weight=weight, key_aged=aged)
    key = NearestColours.learned(picture(60, RED), box(60.0), params)
    later = key.adapted(picture(60, BLUE), box(60.0), IDENTITY)
    border = inside(60.0)
    border[38:62, 48:72] = False  # deeper than the band nothing is asked
    ratio = later.log_ratio(picture(60, RED), GRID, IDENTITY)
    assert (ratio[border].mean() > 0.5) == (weight > 0.0 or aged > 0.0)


def test_the_key_grows_with_the_object() -> None:
    doubled = np.array([[2.0, 0.0, 5.0], [0.0, 2.0, -3.0]])
    known = NearestColours.learned(picture(60), box(60.0), PARAMS)
    assert known.remembered_area(IDENTITY) == pytest.approx(1600.0, rel=0.06)
    assert known.remembered_area(doubled) == pytest.approx(4.0 * known.remembered_area(IDENTITY))
    after = known.adapted(picture(60), box(60.0), doubled)
    assert after.remembered_area(IDENTITY) == pytest.approx(known.remembered_area(doubled))


def test_an_outline_outside_the_picture_encloses_nothing() -> None:
    known = NearestColours.learned(picture(60), box(60.0), PARAMS)
    away = known.adapted(picture(60), box(900.0), IDENTITY)
    assert not away.region.inside.any()
    assert np.isfinite(away.log_ratio(picture(60), GRID, IDENTITY)).all()
