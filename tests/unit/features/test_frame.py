"""What the engine sees of a picture: kinds of images, regions, the squared gradient."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roam_core.features import PreparedFrame, Region
from roam_core.features.frame import as_uint8

LEVELS = np.arange(256, dtype=np.uint8)


def picture(height: int = 40, width: int = 60) -> np.ndarray:
    return np.random.default_rng(6).integers(0, 256, (height, width, 3), dtype=np.uint8)


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_every_level_survives_as_a_float(kind: type) -> None:
    image = np.repeat(LEVELS.reshape(16, 16, 1), 3, axis=2)
    np.testing.assert_array_equal(as_uint8((image / 255.0).astype(kind)), image)


@pytest.mark.parametrize(
    ("image", "words"),
    [
        (np.zeros((0, 8, 3), np.uint8), r"shape \(0, 8, 3\)"),
        (np.full((4, 4, 3), 117.0), "mean of this one is 117"),
    ],
    ids=["no rows", "not in range"],
)
def test_what_is_no_picture_is_refused_in_a_sentence(image: np.ndarray, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        PreparedFrame(image)


def test_floats_out_of_range_are_cut() -> None:
    image = np.array([[[-0.5, 0.5, 1.5], [np.nan, np.inf, -np.inf]]], dtype=np.float32)
    np.testing.assert_array_equal(as_uint8(image), [[[0, 128, 255], [0, 255, 0]]])


def test_light_far_above_white_is_cut_and_does_not_pass_for_integers() -> None:
    """A lamp in a plate of half floats ended the run on its frame: "divide it by 255"."""
    dim = np.random.default_rng(1).uniform(0.0, 0.9, (40, 50, 3)).astype(np.float32)
    lit = dim.copy()
    lit[5:9, 5:9] = 60000.0
    expected = as_uint8(dim)
    expected[5:9, 5:9] = 255
    np.testing.assert_array_equal(as_uint8(lit), expected)


@pytest.mark.parametrize(("white", "type_"), [(255, np.uint8), (65535, np.uint16)])
def test_integers_as_floats_are_refused_also_where_most_is_black(white: int, type_: type) -> None:
    """Of 16 bits it was said that they are to be divided by 255."""
    sprite = np.zeros((40, 50, 3))
    sprite[10:20, 10:25] = np.random.default_rng(2).uniform(0.4, 1.0, (10, 15, 3)) * white
    with pytest.raises(ValueError, match=f"divide it by {white}$"):
        as_uint8(sprite.astype(type_).astype(np.float32))


def test_a_grey_image_is_one_of_equal_channels() -> None:
    grey = picture()[..., 0]
    frame = PreparedFrame(grey)
    assert frame.size == (40, 60)
    np.testing.assert_array_equal(frame.image, np.repeat(grey[..., None], 3, axis=2))
    np.testing.assert_array_equal(frame.grey, grey)


@pytest.mark.parametrize("image", [np.zeros((4, 4, 4), np.uint8), np.zeros(4, np.uint8), np.zeros((4, 4, 3), np.int32)])
def test_what_is_no_image_is_refused(image: np.ndarray) -> None:
    with pytest.raises(ValueError, match="an image has"):
        PreparedFrame(image)


@pytest.mark.parametrize("kind", ["array", "view", "broadcast", "bytearray"])
def test_a_picture_stays_as_it_was_given(kind: str) -> None:
    """Also where its array cannot be written to, but that which it is a view of can: a decoder's own buffer."""
    buffer = np.full((6, 8, 3), 7, np.uint8)
    if kind == "bytearray":
        buffer = np.frombuffer(bytearray(buffer.tobytes()), np.uint8).reshape(6, 8, 3)
    image = {"array": buffer, "broadcast": np.broadcast_to(buffer, (6, 8, 3))}.get(kind, buffer[:])
    if kind != "array":
        image.flags.writeable = False
    frame = PreparedFrame(image)
    buffer[:] = 99
    assert (frame.image == 7).all()


def test_a_picture_that_nobody_can_change_is_not_copied() -> None:
    held = np.full((6, 8, 3), 7, np.uint8)
    held.flags.writeable = False
    for image in (held, held[:], np.frombuffer(held.tobytes(), np.uint8).reshape(6, 8, 3)):
        assert np.may_share_memory(PreparedFrame(image).image, image)


def test_a_region_holds_all_positions_and_their_margin() -> None:
    region = Region.around(np.array([(10.5, 20.2), (30.9, 25.0)]), 4.0, (100, 100))
    assert region == Region(6, 16, 35, 29)
    assert region.origin == (6, 16)
    assert picture(100, 100)[region.slices].shape == (13, 29, 3)


def test_a_region_ends_at_the_image() -> None:
    assert Region.around(np.array([(-30.0, 5.0), (500.0, 9.0)]), 10.0, (12, 34)) == Region(0, 0, 34, 12)
    assert Region.around(np.array([(-30.0, -30.0), (-20.0, -25.0)]), 5.0, (12, 34)).is_empty


def test_a_region_is_aligned_with_others_and_stays_in_the_picture() -> None:
    size = (100, 199)
    assert Region(11, 20, 31, 41).aligned(2, size) == Region(10, 20, 32, 42)
    assert Region(170, 3, 198, 100).aligned(9, size) == Region(162, 0, 198, 100)
    assert Region(170, 3, 199, 99).aligned(8, size) == Region(168, 0, 199, 100)
    assert Region(3, 5, 8, 9).aligned(1, size) == Region(3, 5, 8, 9)


def test_the_gradient_is_strongest_on_the_border_between_two_flats() -> None:
    image = np.zeros((40, 60, 3), np.uint8)
    image[:, 30:, 1] = 200
    field = PreparedFrame(image).squared_gradient(Region(0, 0, 60, 40), 1.0, 144.0, 98.0)
    assert field.dtype == np.float32
    assert field[20].argmax() in (29, 30)
    np.testing.assert_array_equal(field[:, 29:31], 1.0)
    assert field[:, :24].max() == field[:, 36:].max() == 0.0


def test_faint_grain_does_not_pass_for_edges() -> None:
    grain = 128 + np.random.default_rng(1).integers(-2, 3, (60, 60, 3))
    assert PreparedFrame(grain.astype(np.uint8)).squared_gradient(Region(0, 0, 60, 60), 1.0, 144.0, 98.0).max() < 0.1


def test_a_region_is_cut_from_the_whole_picture_and_not_framed_by_its_border() -> None:
    """The blur looks beyond the region, so what a pixel shows does not depend on where the region was cut."""
    frame = PreparedFrame(picture(80, 80))
    whole = frame.squared_gradient(Region(0, 0, 80, 80), 1.5, 144.0, 98.0)
    part = frame.squared_gradient(Region(20, 30, 50, 60), 1.5, 144.0, 98.0)
    inside = whole[30:60, 20:50]
    unsaturated = (part < 1.0) & (inside < 1.0)
    ratio = part[unsaturated] / inside[unsaturated]
    np.testing.assert_allclose(ratio, ratio[0], rtol=1e-4)


def test_a_region_is_made_once() -> None:
    frame, region = PreparedFrame(picture()), Region(5, 5, 30, 30)
    assert frame.squared_gradient(region, 1.0, 144.0, 98.0) is frame.squared_gradient(region, 1.0, 144.0, 98.0)


def test_a_multiplied_picture_begins_with_what_was_given() -> None:
    frame = PreparedFrame(picture())
    twice = frame.multiplied(np.full(3, 0.5), np.full(3, 9.0)).multiplied(np.full(3, 1.3), np.zeros(3))
    np.testing.assert_array_equal(twice.image, np.clip(np.round(1.3 * picture()), 0, 255))
    np.testing.assert_array_equal(twice.grey, PreparedFrame(twice.image).grey)
    assert twice.size == frame.size
    assert twice.given is frame
    assert twice.multiplied(np.ones(3), np.zeros(3)) is frame
    assert frame.multiplied(np.ones(3), np.zeros(3)) is frame


def test_a_part_of_a_multiplied_picture_is_that_of_the_whole() -> None:
    by, plus = np.array([0.7, 1.0, 1.2]), np.array([20.0, 0.0, -40.0])
    frame = PreparedFrame(picture()).multiplied(by, plus)
    np.testing.assert_array_equal(frame.image, np.clip(np.round(by * picture() + plus), 0, 255))
    part = Region(5, 8, 31, 29)
    np.testing.assert_array_equal(frame.within(part), frame.image[part.slices[0], part.slices[1]])


def test_a_divided_region_counts_as_given_by_the_same_levels() -> None:
    table, region = np.arange(255, -1, -1).astype(np.uint8), Region(4, 6, 24, 16)
    frame = PreparedFrame(picture())
    rows, columns = region.slices
    expected = picture().astype(float)
    expected[rows, columns] = np.clip(np.round(expected[rows, columns] / 0.5), 0, 255)
    by = np.full((5, 10), 0.5, np.float32)
    np.testing.assert_array_equal(frame.divided(by, region).image, expected)
    levelled = frame.levelled(table).multiplied(np.full(3, 0.8), np.zeros(3)).divided(by, region)
    np.testing.assert_array_equal(levelled.image, table[expected.astype(int)])
    assert levelled.given is levelled


@pytest.mark.parametrize("channels", [1, 3])
def test_an_array_that_is_decoded_into_again_changes_nothing(channels: int) -> None:
    buffer = picture()[..., :channels].squeeze()
    before = buffer.copy()
    frame = PreparedFrame(buffer)
    buffer[:] = 0
    np.testing.assert_array_equal(frame.image, np.broadcast_to(before.reshape(40, 60, -1), (40, 60, 3)))


def test_luma_is_that_of_the_picture_whatever_part_was_asked_for_before() -> None:
    """It is kept for all that was looked at; also of one whose values a table replaces."""
    image = picture()
    for frame, shown in (
        (PreparedFrame(image), image),
        (PreparedFrame(image).levelled(LEVELS[::-1].copy()), 255 - image),
    ):
        for region in (Region(10, 5, 20, 15), Region(12, 6, 18, 9), Region(40, 30, 60, 40), Region(0, 0, 60, 40)):
            expected = cv2.cvtColor(np.ascontiguousarray(shown[region.slices]), cv2.COLOR_RGB2GRAY)
            np.testing.assert_array_equal(frame.grey_within(region), expected)
        np.testing.assert_array_equal(frame.grey, cv2.cvtColor(shown, cv2.COLOR_RGB2GRAY))
