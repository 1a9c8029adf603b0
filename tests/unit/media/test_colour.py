"""Colour for the screen and for the engine, against the curves written out value by value."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.arrays import Array, Float32, Image
from roam_core.errors import RoamError
from roam_core.media.colour import to_display, to_engine, unit_floats
from roam_core.media.curves import COLOUR_SPACES, LINEAR, LOG, SRGB, linear_from_log

RAMP = np.linspace(0.0, 1.0, 3 * 40 * 50, dtype=np.float32).reshape(40, 50, 3)
BYTES = np.arange(256, dtype=np.uint8)[:, None, None].repeat(3, axis=2)


def ref_srgb(value: float) -> float:
    """The sRGB curve of one linear value, clipped."""
    value = min(max(value, 0.0), 1.0)
    return 12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055


def ref_log(value: float) -> float:
    """Linear light of one Cineon value: 0.002 density per code, gamma 0.6, 95 and 685 as black and white."""
    black = 10 ** ((95 - 685) * 0.002 / 0.6)
    return (10 ** ((1023 * value - 685) * 0.002 / 0.6) - black) / (1 - black)


def ref_perceived(image: Float32, space: str) -> Array:
    curve = {SRGB: float, LINEAR: ref_srgb, LOG: lambda value: ref_srgb(ref_log(value))}[space]
    return np.array([curve(float(value)) for value in image.ravel()]).reshape(image.shape)


@pytest.mark.parametrize("space", COLOUR_SPACES)
def test_float_pictures_follow_the_curves(space: str) -> None:
    expected = ref_perceived(RAMP, space)
    seen = to_engine(RAMP, space)
    assert seen.dtype == np.float32
    np.testing.assert_allclose(seen, expected, atol=1.1e-4)
    shown = to_display(RAMP, space)
    assert shown.dtype == np.uint8
    np.testing.assert_allclose(shown, expected * 255, atol=0.53)


@pytest.mark.parametrize("space", COLOUR_SPACES)
def test_8_bit_pictures_follow_the_curves(space: str) -> None:
    expected = ref_perceived(BYTES.astype(np.float32) / 255, space)
    seen = to_engine(BYTES, space)
    np.testing.assert_allclose(seen / 255.0 if seen.dtype == np.uint8 else seen, expected, atol=1e-6)
    np.testing.assert_allclose(to_display(BYTES, space), expected * 255, atol=0.501)


def test_8_bit_srgb_is_passed_on_without_a_copy() -> None:
    assert to_display(BYTES, SRGB) is BYTES
    assert to_engine(BYTES, SRGB) is BYTES


@pytest.mark.parametrize("space", COLOUR_SPACES)
def test_what_lies_outside_the_range_is_clipped_and_nan_is_black(space: str) -> None:
    image = np.array([-np.inf, -3.0, 1.0, 7.0, np.inf, np.nan], np.float32).reshape(1, 2, 3)
    assert to_engine(image, space).ravel().tolist() == [0, 0, 1, 1, 1, 0]
    assert to_display(image, space).ravel().tolist() == [0, 0, 255, 255, 255, 0]


@pytest.mark.parametrize("space", COLOUR_SPACES)
@pytest.mark.parametrize("image", [RAMP, BYTES], ids=["float", "8-bit"])
def test_read_only_and_sliced_pictures_are_left_alone(space: str, image: Float32) -> None:
    frozen = image.copy()
    frozen.setflags(write=False)
    np.testing.assert_array_equal(to_display(frozen[::2, ::-1], space), to_display(image, space)[::2, ::-1])
    np.testing.assert_array_equal(to_engine(frozen[::2, ::-1], space), to_engine(image, space)[::2, ::-1])
    np.testing.assert_array_equal(frozen, image)


def test_cineon_black_and_white() -> None:
    np.testing.assert_allclose(linear_from_log(np.array([95.0, 685.0]) / 1023), [0.0, 1.0], atol=1e-12)


def test_an_unknown_space_is_told() -> None:
    for convert in (to_display, to_engine):
        with pytest.raises(RoamError, match="'Kodachrome' is not known to the OpenColorIO configuration"):
            convert(RAMP, "Kodachrome")


HALVES = np.arange(65536, dtype=np.uint16).view(np.float16)
WORDS = np.arange(65536, dtype=np.uint16)


@pytest.mark.parametrize("space", [*COLOUR_SPACES, "ACEScg"])
@pytest.mark.parametrize("values", [HALVES, WORDS], ids=["half", "16 bits"])
@pytest.mark.filterwarnings("ignore:invalid value encountered in cast")
def test_every_half_and_16_bit_value_is_converted_as_the_float_of_it(space: str, values: Image) -> None:
    """To the last bit, through the tables that they are looked up in."""
    image = values.reshape(256, 256, 1).repeat(3, axis=2)
    floats = unit_floats(image)
    for convert in (to_engine, to_display):
        np.testing.assert_array_equal(convert(image, space), convert(floats, space))
