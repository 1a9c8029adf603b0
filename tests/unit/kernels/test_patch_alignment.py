"""Patches of a key aligned with a picture, on motions that were planted; what they say of the cells around them."""

from __future__ import annotations

import numpy as np
import numpy.testing as npt
import pytest

from roam_core.arrays import Array
from roam_core.kernels.patch_alignment import Alignment, Picture, Templates, aligned, sides

HOW = Alignment(
    rounds=8, like_least=5.0, like_most=15.0, like=14.0, shift=15.0, move=4.0, strain=0.15, independent=0.22,
    parted=4.0, step=4.0, step_strain=0.25, own=0.3, beyond=0.6,
)  # fmt: skip
SIZE = 56, 64
STILL = np.array([1.0, 0.0, 0.0, 1.0])
CENTRES = np.array([[20.0, 28.0], [44.0, 28.0]])


def look(places: Array) -> Array:
    """A smooth pattern `(..., 3)` at real places `(..., 2)`, with one period for each channel."""
    x, y = np.moveaxis(places, -1, 0)
    waves = [np.sin(x / 3.1) + np.cos(y / 4.3), np.sin((x + y) / 5.7), np.cos((x - 2.0 * y) / 7.9) + np.sin(y / 2.9)]
    return np.asarray(110.0 + 40.0 * np.stack(waves, axis=-1))


def cells(factor: float = 1.0, left: float = 0.0, top: float = 0.0) -> Array:
    """Where the cells of a picture lie `(h, w, 2)`, pixels of the image."""
    columns, rows = np.meshgrid(np.arange(SIZE[1]) + 0.5, np.arange(SIZE[0]) + 0.5)
    return np.stack([columns, rows], axis=-1) / factor + (left, top)


def shown(motion: Array, factor: float = 1.0, left: float = 0.0, top: float = 0.0, brighter: float = 0.0) -> Picture:
    """The pattern as one motion, about the first patch's centre, carries it."""
    back = (cells(factor, left, top) - motion[:2]) @ np.linalg.inv(motion[2:].reshape(2, 2)).T + CENTRES[0]
    image = np.rint(np.clip(look(back) + brighter, 0, 255)).astype(np.uint8)
    return Picture(image, factor, factor, left, top)


def templates(count: int = 60, flat: int | None = None) -> Templates:
    """Two patches of the pattern; the one called `flat` has no texture."""
    rng = np.random.default_rng(0)
    places = CENTRES[:, None] + rng.uniform(-9.0, 9.0, (2, count, 2))
    colours, step = look(places), 1e-3
    slopes = np.stack([(look(places + to) - colours) / step for to in ((step, 0.0), (0.0, step))], axis=-1)
    if flat is not None:
        colours[flat], slopes[flat] = 110.0, 0.0
    both = np.stack([colours] * 2).astype(np.float32), np.stack([slopes] * 2).astype(np.float32)
    return Templates(CENTRES, places, *both, np.array([[1], [0]], np.int32), np.ones((2, 1)))


def start(x: float = 0.0, y: float = 0.0) -> Array:
    return np.hstack([CENTRES + np.array([x, y]), np.tile(STILL, (2, 1))])


def run(patches: Templates, picture: Picture, carried: Array) -> tuple[Array, Array, Array]:
    return aligned(patches, picture, picture, carried, start(), np.ones(2), HOW)


def expected(motion: Array) -> Array:
    """The centres as the motion carries them."""
    return np.asarray((CENTRES - CENTRES[0]) @ motion[2:].reshape(2, 2).T + motion[:2])


MOTIONS = {
    "moved": np.array([22.3, 29.2, 1.0, 0.0, 0.0, 1.0]),
    "turned": np.array([20.0, 28.0, np.cos(0.2), -np.sin(0.2), np.sin(0.2), np.cos(0.2)]),
    "sheared and grown": np.array([19.0, 28.5, 1.1, 0.08, -0.02, 0.95]),
}


@pytest.mark.parametrize("name", MOTIONS)
def test_the_motion_that_was_planted_is_found(name: str) -> None:
    motion = MOTIONS[name]
    found, likeness, _ = run(templates(), shown(motion), start())
    npt.assert_allclose(found[:, :2], expected(motion), atol=0.1)
    npt.assert_allclose(found[:, 2:], np.tile(motion[2:], (2, 1)), atol=0.03)
    assert (likeness > 0.98).all()


def test_cells_that_are_no_pixels_and_a_part_of_the_picture_tell_the_same() -> None:
    motion = MOTIONS["moved"]
    found, _, _ = run(templates(), shown(motion, factor=1.5, left=7.0, top=11.0), start())
    npt.assert_allclose(found[:, :2], expected(motion), atol=0.1)


def test_what_became_brighter_is_still_known() -> None:
    motion = MOTIONS["moved"]
    found, likeness, _ = run(templates(), shown(motion, brighter=10.0), start())
    npt.assert_allclose(found[:, :2], expected(motion), atol=0.1)
    assert (likeness > 0.95).all()


def test_what_was_carried_astray_is_found_where_its_neighbour_is() -> None:
    motion = MOTIONS["moved"]
    carried = start(2.3, 1.2)
    carried[1, :2] += (-13.0, 9.0)
    found, likeness, _ = run(templates(), shown(motion), carried)
    npt.assert_allclose(found[:, :2], expected(motion), atol=0.1)
    assert likeness[1] > 0.98


def test_a_patch_without_texture_goes_with_its_neighbour_and_says_that_it_does_not_know() -> None:
    motion = MOTIONS["moved"]
    picture = shown(motion)
    picture.image[:, 34:] = 110
    found, likeness, open_by = run(templates(flat=1), picture, start())
    npt.assert_allclose(found[1, :2], expected(motion)[1], atol=0.75)
    assert likeness[1] > 0.9
    assert open_by[1] > 100.0 * open_by[0]


def test_what_is_hidden_does_not_match() -> None:
    picture = shown(start()[0])
    picture.image[:, 31:] = (250, 10, 250)
    _, likeness, _ = run(templates(), picture, start())
    assert likeness[0] > 0.9
    assert likeness[1] < 0.6


def test_a_patch_outside_the_picture_matches_nothing() -> None:
    far = start(300.0, 0.0)
    _, likeness, _ = aligned(templates(), shown(far[0]), shown(start()[0]), far, far, np.ones(2), HOW)
    npt.assert_allclose(likeness, 0.4)


def said(motion: Array, weight: float = 1.0, colour: int = 100) -> tuple[Array, Array]:
    """A key of one colour whose inside lies left of x = 20; the first patch speaks."""
    depth = np.clip(20.0 - cells()[..., 0], -20.0, 20.0).astype(np.float32)
    key, now = (np.full((*SIZE, 3), value, np.uint8) for value in (100, colour))
    pictures = (Picture(image, 1.0, 1.0, 0.0, 0.0) for image in (key, now))
    key_view, now_view = pictures
    return sides(CENTRES[:1], motion[None], np.array([weight]), 10.0, key_view, depth, now_view, 8.0, 3.0)


def test_a_patch_tells_the_sides_of_the_outline_where_it_lies_now() -> None:
    inside, outside = said(np.array([26.0, 28.0, 1.0, 0.0, 0.0, 1.0]))  # six pixels to the right
    assert inside[28, 21] > 0.7 * outside.max() > 0.4
    assert not inside[:, 26:].any()
    assert not outside[:, :26].any()
    assert inside[28, 25] < inside[28, 22]  # not sure beside the outline
    assert not inside[:18].any()
    assert not inside[39:].any()  # beyond its reach


def test_a_patch_that_turned_turns_its_outline() -> None:
    inside, outside = said(np.array([20.0, 28.0, 0.0, -1.0, 1.0, 0.0]))
    assert inside[24, 20] > 0.5 > inside[32, 20]
    assert outside[32, 20] > 0.5 > outside[24, 20]


def test_what_does_not_look_as_on_the_key_is_not_said_to_be_inside() -> None:
    like, _ = said(start()[0])
    unlike, outside = said(start()[0], colour=140)
    assert like[28, 16] > 0.5
    assert unlike[28, 16] < 0.05
    assert outside[28, 24] > 0.5  # what lies there was not seen on the key: it may look like anything


def test_a_patch_that_is_not_believed_and_one_that_collapsed_say_nothing() -> None:
    for each in (*said(start()[0], weight=0.0), *said(np.array([20.0, 28.0, 0.1, 0.0, 0.0, 0.1]))):
        assert not each.any()


@pytest.mark.parametrize("size", [0.3, 1e-200, 40.0])
def test_a_patch_whose_area_vanishes_or_grows_beyond_reason_goes_back_to_where_it_was_carried(size: float) -> None:
    carried = start()
    carried[1, 2:] = 1e-3 * STILL
    last = start()
    last[1, 2:] = size * STILL
    found, likeness, open_by = aligned(
        templates(), shown(start()[0]), shown(start()[0]), carried, last, np.ones(2), HOW
    )
    assert np.isfinite(found).all()
    assert np.isfinite(open_by).all()
    npt.assert_allclose(found[0], start()[0], atol=0.1)
    assert (likeness >= 0.0).all()
