"""How the light has changed since the key: told only where the key's background agrees on it."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.arrays import Array, Bools, UInt8
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.features.levels import Levels
from roam_core.params.evidence import ExposureParams, LevelsParams
from roam_core.proposal.cues.exposure import UNCHANGED, Light, light_since
from roam_core.proposal.cues.key_view import KeyView

SIDE = 120
GRID = Grid(Region(0, 0, SIDE, SIDE), SIDE, SIDE)
PARAMS = ExposureParams()
NOWHERE = np.zeros((SIDE, SIDE), bool)
WITHIN = float(np.exp(PARAMS.within))
LAST = Light(0.9, np.array([1.1, 1.0, 0.9]))
WARM = np.array([1.15, 1.0, 0.8])


def ground(seed: int = 3) -> UInt8:
    """Coarse texture `(SIDE, SIDE, 3)`, of all hues."""
    rng = np.random.default_rng(seed)
    luma = rng.integers(70, 140, (SIDE // 4, SIDE // 4, 1))
    return np.uint8(np.kron(luma + rng.integers(-30, 31, (SIDE // 4, SIDE // 4, 3)), np.ones((4, 4, 1))))


def lit(picture: UInt8, by: float | Array) -> UInt8:
    return np.uint8(np.clip(np.round(picture * by), 0, 255))


def shaded(by: Array) -> Array:
    """Factors `(SIDE, SIDE)` for all channels."""
    return np.repeat(by[..., None], 3, axis=2)


def told(now: UInt8, inside: Bools = NOWHERE, key: UInt8 | None = None, carried: Array | None = None) -> Light:
    by = np.eye(3) if carried is None else carried
    view = KeyView(
        PreparedFrame(ground() if key is None else key), by, GRID, GRID.warped(inside.astype(np.float32), by)
    )
    return light_since(view, PreparedFrame(now), inside, LAST, PARAMS)


def nearer(gains: Array | float, within: float) -> Array:
    """Factors as far from 1 as they are beyond what two patches of one light differ by."""
    logs = np.log(gains)
    return np.asarray(np.exp(logs - np.clip(logs, -np.log(within), np.log(within))))


@pytest.mark.parametrize("gain", [0.5, 0.65, 0.8, 1.25, 1.6])
def test_a_change_of_exposure_is_told_up_to_what_patches_differ_by(gain: float) -> None:
    light = told(lit(ground(), gain))
    assert light.exposure == pytest.approx(float(nearer(gain, WITHIN)), rel=0.01)
    np.testing.assert_array_equal(light.tint, np.ones(3))


def land() -> UInt8:
    """The ground in places darker and in places brighter: a factor does not explain what a veil does to it."""
    places = np.random.default_rng(9).uniform(0.4, 1.6, (SIDE // 20, SIDE // 20))
    return lit(ground(), shaded(np.kron(places, np.ones((20, 20)))))


def under(picture: UInt8, by: float, veil: Array | float) -> UInt8:
    """A picture `by` times as bright, under a veil of so many levels."""
    return np.uint8(np.clip(np.round(by * picture + np.asarray(veil)), 0, 255))


@pytest.mark.parametrize("by", [0.3, 0.6, 0.9])
def test_haze_is_told_as_a_factor_and_a_veil(by: float) -> None:
    veil = (1.0 - by) * np.array([180.0, 200.0, 220.0])
    light = told(under(land(), by, veil), key=land())
    np.testing.assert_allclose(light.gains, by, rtol=0.03)
    np.testing.assert_allclose(light.veil, veil, atol=2.5)


def test_haze_that_clears_is_told_as_well() -> None:
    light = told(land(), key=under(land(), 0.5, 90.0))
    np.testing.assert_allclose(light.gains, 2.0, rtol=0.03)
    np.testing.assert_allclose(light.veil, -180.0, atol=5.0)


def test_a_plate_in_log_encoding_becomes_brighter_by_a_veil_alone() -> None:
    light = told(under(land(), 1.0, 40.0), key=land())
    np.testing.assert_allclose(light.gains, 1.0, rtol=0.02)
    np.testing.assert_allclose(light.veil, 40.0, atol=2.0)


def test_so_it_does_where_levels_stretch_it() -> None:
    key = under(land(), 0.25, 80.0)
    levels = Levels.of(PreparedFrame(key), LevelsParams())
    assert levels is not None
    then, now = (PreparedFrame(each).levelled(levels.table) for each in (key, under(key, 1.0, 30.0)))
    light = light_since(KeyView(then, np.eye(3), GRID, np.zeros((SIDE, SIDE), np.float32)), now, NOWHERE, LAST, PARAMS)
    np.testing.assert_allclose(light.gains, 1.0, rtol=0.04)
    np.testing.assert_allclose(light.veil, 30.0, atol=4.0)
    np.testing.assert_allclose(light.removed(now).image.mean(), then.image.mean(), atol=1.5)


@pytest.mark.parametrize("now", [lit(land(), 0.6), lit(land(), 1.6), lit(land(), 0.8 * WARM)])
def test_what_factors_explain_asks_for_no_veil(now: UInt8) -> None:
    assert not told(now, key=land()).veil.any()


def test_haze_over_some_of_it_is_none_over_all() -> None:
    part = land()
    part[:, : SIDE // 3] = under(part[:, : SIDE // 3], 0.5, 100.0)
    light = told(part, key=land())
    np.testing.assert_array_equal(light.gains, UNCHANGED.gains)
    assert not light.veil.any()


def test_where_neither_a_factor_nor_a_veil_tells_enough_the_light_stays() -> None:
    hazes = np.kron(np.random.default_rng(6).uniform(0.0, 0.6, (SIDE // 20, SIDE // 20)), np.ones((20, 20)))[..., None]
    veiled = Light(0.8, np.ones(3), np.full(3, 30.0))
    view = KeyView(PreparedFrame(land()), np.eye(3), GRID, np.zeros((SIDE, SIDE), np.float32))
    now = PreparedFrame(np.uint8((1.0 - hazes) * land() + hazes * 200.0))
    assert light_since(view, now, NOWHERE, veiled, PARAMS) is veiled


def test_the_key_in_a_light_and_a_frame_out_of_it_are_the_other_one() -> None:
    light = Light(0.6, np.array([1.1, 1.0, 0.9]), np.array([50.0, 60.0, 70.0]))
    cast = light.cast(PreparedFrame(land()))
    np.testing.assert_array_equal(cast.image, np.round(light.gains * land() + light.veil))
    np.testing.assert_allclose(light.removed(PreparedFrame(cast.image)).image, land().astype(float), atol=1.0)


@pytest.mark.parametrize("exposure", [0.7, 1.0, 1.3])
def test_a_change_of_colour_temperature_is_told_beside_that_of_exposure(exposure: float) -> None:
    luma = np.array([0.299, 0.587, 0.114])
    tint = WARM * (luma @ ground().mean((0, 1))) / ((luma * WARM) @ ground().mean((0, 1)))
    light = told(lit(ground(), exposure * WARM))
    np.testing.assert_allclose(light.tint, nearer(tint, WITHIN), rtol=0.02)
    assert light.exposure == pytest.approx(float(nearer(exposure * WARM[0] / tint[0], WITHIN)), rel=0.02)
    np.testing.assert_array_equal(light.gains, light.exposure * light.tint)


def test_the_same_light_is_no_change_at_all() -> None:
    grain = np.random.default_rng(4).normal(0.0, 3.0, (SIDE, SIDE, 3))
    for now in (ground(), np.uint8(np.clip(np.array([0.98, 0.97, 0.96]) * ground() + grain, 0, 255))):
        np.testing.assert_array_equal(told(now).gains, UNCHANGED.gains)


def test_there_is_no_leap_where_a_change_begins() -> None:
    lights = [told(lit(ground(), 1.0 + share * (0.9 * WARM - 1.0))).gains for share in np.linspace(0.0, 1.0, 21)]
    assert np.abs(np.diff(np.array(lights), axis=0)).max() < 0.03


def test_of_a_picture_of_little_contrast_less_of_a_change_is_told_apart() -> None:
    """Its plate is stretched: a change that is small for the plate is not for what is seen of it."""
    key = np.uint8(np.round(80.0 + 0.25 * ground()))
    levels = Levels.of(PreparedFrame(key), LevelsParams())
    assert levels is not None
    then, now = (PreparedFrame(each).levelled(levels.table) for each in (key, lit(key, 0.95)))
    light = light_since(KeyView(then, np.eye(3), GRID, np.zeros((SIDE, SIDE), np.float32)), now, NOWHERE, LAST, PARAMS)
    assert light.exposure == pytest.approx(0.95 * WITHIN ** (1.0 / levels.contrast), abs=0.01)
    assert told(lit(key, 0.95), key=key).exposure == 1.0


def test_it_is_told_where_the_camera_has_gone_on() -> None:
    carried = np.array([[1.0, 0.0, 8.0], [0.0, 1.0, -4.0], [0.0, 0.0, 1.0]])
    moved = np.roll(ground(), (-4, 8), axis=(0, 1))
    light = told(lit(moved, 0.6), carried=carried)
    assert light.exposure == pytest.approx(0.6 * WITHIN, rel=0.02)


def test_shadows_on_some_of_it_are_no_change() -> None:
    third = np.ones((SIDE, SIDE))
    third[:, : SIDE // 3] = 0.5
    np.testing.assert_array_equal(told(lit(ground(), shaded(third))).gains, UNCHANGED.gains)


def test_where_patches_disagree_on_it_the_exposure_stays_and_the_tint_is_told() -> None:
    gains = np.kron(np.random.default_rng(5).uniform(0.5, 1.0, (SIDE // 20, SIDE // 20)), np.ones((20, 20)))
    light = told(lit(ground(), shaded(gains)))
    assert light.exposure == LAST.exposure
    np.testing.assert_array_equal(light.tint, np.ones(3))


def test_where_patches_disagree_on_it_the_tint_stays_and_the_exposure_is_told() -> None:
    hues = np.random.default_rng(5).uniform(0.8, 1.25, (SIDE // 20, SIDE // 20, 3))
    luma = np.array([0.299, 0.587, 0.114])
    hues /= (hues @ luma)[..., None]
    light = told(lit(ground(), np.kron(hues, np.ones((20, 20, 1)))))
    assert light.exposure == pytest.approx(1.0, abs=0.02)
    np.testing.assert_array_equal(light.tint, LAST.tint)


@pytest.mark.parametrize(
    ("key", "now"),
    [
        (ground(), ground(8)),
        (np.full((SIDE, SIDE, 3), 100, np.uint8), np.full((SIDE, SIDE, 3), 70, np.uint8)),
        (np.uint8(ground() // 12 + 235), lit(np.uint8(ground() // 12 + 235), 1.2)),
    ],
    ids=["another ground", "flat", "cut at white"],
)
def test_what_tells_nothing_leaves_the_light_as_it_was(key: UInt8, now: UInt8) -> None:
    np.testing.assert_array_equal(told(now, key=key).gains, LAST.gains)


def test_the_object_itself_tells_nothing() -> None:
    inside = np.zeros((SIDE, SIDE), bool)
    inside[:, SIDE // 10 :] = True
    now = lit(ground(), np.where(inside[..., None], 0.5 * WARM, 1.0))
    np.testing.assert_array_equal(told(now, inside).gains, UNCHANGED.gains)
    inside[:] = True
    np.testing.assert_array_equal(told(now, inside).gains, LAST.gains)
