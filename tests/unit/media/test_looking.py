"""Looks: neutral changes nothing, stops are stops, channels are channels, opacity stays."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.arrays import UInt8
from roam_core.media.colour import to_display, unit_floats
from roam_core.media.colour_config import View, displayed
from roam_core.media.curves import LINEAR, LOG, SRGB, linear_from_log, linear_from_srgb, srgb_from_linear
from roam_core.media.looking import Channel, Look, Plate, has_more_than_shown, is_seen_anew, seen, seen_plate


@pytest.fixture
def picture() -> UInt8:
    return np.random.default_rng(3).integers(0, 256, (5, 7, 3), dtype=np.uint8)


def test_a_neutral_look_shows_the_picture_itself(picture: UInt8) -> None:
    assert Look().is_neutral
    assert seen(picture, Look()) is picture
    np.testing.assert_array_equal(Look().table, np.arange(256))


def test_the_srgb_curve_is_inverted() -> None:
    values = np.linspace(0.0, 1.0, 101)
    np.testing.assert_allclose(srgb_from_linear(linear_from_srgb(values)), values, atol=1e-6)


@pytest.mark.parametrize("stops", [-3.0, -1.0, 0.5, 2.0])
def test_a_stop_doubles_the_light(stops: float) -> None:
    table = Look(exposure=stops).table
    light = linear_from_srgb(np.arange(256) / 255.0) * 2.0**stops
    np.testing.assert_allclose(table / 255.0, srgb_from_linear(np.clip(light, 0.0, 1.0)), atol=0.5 / 255.0 + 1e-9)
    assert (np.diff(table.astype(int)) >= 0).all()


def test_gamma_opens_the_shadows_and_keeps_black_and_white() -> None:
    table = Look(gamma=2.0).table
    assert (table[0], table[255]) == (0, 255)
    assert table[64] == round(255.0 * (64 / 255.0) ** 0.5)


def test_single_channels_are_grey(picture: UInt8) -> None:
    for index, channel in enumerate((Channel.RED, Channel.GREEN, Channel.BLUE)):
        np.testing.assert_array_equal(seen(picture, Look(channel=channel)), picture[:, :, index])
    brightness = seen(picture, Look(channel=Channel.LUMINANCE))
    np.testing.assert_allclose(brightness, picture @ np.array([0.2126, 0.7152, 0.0722]), atol=0.51)


@pytest.mark.parametrize("look", [Look(exposure=1.0), Look(channel=Channel.BLUE), Look(0.5, 1.3, Channel.RED)])
def test_opacity_is_left_alone(picture: UInt8, look: Look) -> None:
    cut = np.dstack([picture, picture[:, :, 0]])
    shown = seen(cut, look)
    np.testing.assert_array_equal(shown[:, :, 3], picture[:, :, 0])
    expected = seen(picture, look)
    np.testing.assert_array_equal(
        shown[:, :, :3], expected if expected.ndim == 3 else expected[:, :, None].repeat(3, 2)
    )


def test_a_matte_has_no_channels(picture: UInt8) -> None:
    grey = picture[:, :, 0].copy()
    np.testing.assert_array_equal(seen(grey, Look(channel=Channel.RED)), grey)
    np.testing.assert_array_equal(seen(grey, Look(gamma=2.0)), Look(gamma=2.0).table[grey])


@pytest.mark.parametrize("stops", [-4.0, -1.0, 1.5])
def test_a_linear_plate_is_exposed_before_it_is_clipped(stops: float) -> None:
    light = np.geomspace(0.01, 12.0, 30, dtype=np.float32).reshape(2, 5, 3)
    expected = to_display(light * np.float32(2.0**stops), LINEAR)
    np.testing.assert_array_equal(seen_plate(light, LINEAR, Look(exposure=stops)), expected)


def test_a_log_plate_gets_the_light_that_its_curve_means() -> None:
    code = np.linspace(0.45, 0.85, 12, dtype=np.float32).reshape(1, 4, 3)
    shown = seen_plate(code, LOG, Look(exposure=-2.0)) / 255.0
    light = np.clip(linear_from_log(code.astype(np.float64)) / 4.0, 0.0, 1.0)
    # A negative is denser by the same step everywhere; near black, where Cineon has an offset, that differs a little.
    np.testing.assert_allclose(shown, srgb_from_linear(light), atol=0.03)


@pytest.mark.parametrize("kind", [np.float16, np.float32])
def test_a_float_plate_encoded_for_a_display_brings_back_what_lies_above_white(kind: type) -> None:
    light = np.array([[[-0.5, 0.02, 0.18], [0.9, 1.5, 3.9]]])
    plate = srgb_from_linear(np.maximum(light, 0.0)).astype(kind)
    plate[0, 0, 0] = -0.5
    look = Look(exposure=-2.0)
    assert is_seen_anew(Plate(plate, SRGB), look)
    expected = np.rint(255.0 * srgb_from_linear(np.clip(light / 4.0, 0.0, 1.0)))
    np.testing.assert_allclose(seen_plate(plate, SRGB, look), expected, atol=1.0)


def test_only_floats_of_wide_range_hold_more_than_is_shown() -> None:
    values = np.zeros((1, 1, 3), dtype=np.float32)
    assert has_more_than_shown(values, LINEAR)
    assert has_more_than_shown(values, LOG)
    assert has_more_than_shown(values, SRGB)
    assert not has_more_than_shown(values.astype(np.uint16), SRGB)
    assert not has_more_than_shown(values.astype(np.uint8), LINEAR)


VIEW = ("sRGB - Display", "ACES 2.0 - SDR 100 nits (Rec.709)")


@pytest.mark.parametrize("space", [SRGB, LINEAR, LOG, "ACEScg"])
def test_a_view_is_seen_of_the_plates_own_values_then_gamma_and_channel(space: str) -> None:
    values = np.random.default_rng(4).random((6, 7, 3), dtype=np.float32)
    for plate in (values, (values * 255).astype(np.uint8)):
        light = plate / np.float32(255.0) if plate.dtype == np.uint8 else plate
        look = Look(exposure=1.0, gamma=1.5, channel=Channel.RED, view=VIEW)
        shown = displayed(np.ascontiguousarray(light, dtype=np.float32), space, View(*VIEW), 1.0)
        expected = seen(shown, Look(gamma=1.5, channel=Channel.RED))
        np.testing.assert_array_equal(seen_plate(plate, space, look), expected)
        assert is_seen_anew(Plate(plate, space), look)
        assert not is_seen_anew(Plate(plate, space), Look(gamma=1.5))


def test_exposing_a_plate_of_open_color_ios_brings_back_its_highlights() -> None:
    values = np.full((2, 2, 3), 4.0, np.float32)
    assert np.all(seen_plate(values, "ACEScg", Look()) == 255)
    shown = seen_plate(values, "ACEScg", Look(exposure=-3.0))
    np.testing.assert_array_equal(shown, seen_plate(values * 0.125, "ACEScg", Look()))
    assert np.all(shown < 200)


@pytest.mark.parametrize("look", [Look(), Look(exposure=-2.0), Look(exposure=1.0, gamma=2.0), Look(view=VIEW)])
@pytest.mark.parametrize("kind", [np.uint16, np.float16])
def test_plates_of_16_bits_are_seen_as_their_floats(look: Look, kind: type) -> None:
    values = np.random.default_rng(4).random((6, 7, 3))
    plate = (values * 65535).astype(kind) if kind is np.uint16 else (values * 4).astype(kind)
    np.testing.assert_array_equal(seen_plate(plate, LINEAR, look), seen_plate(unit_floats(plate), LINEAR, look))
