"""From masks to shapes: one for each region, holes that subtract, sub-pixel outlines, all kinds of mask images."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from roam_core.arrays import Array, UInt8
from roam_core.errors import RoamError
from roam_core.geometry import polyline
from roam_core.matte import render_matte, shapes_from_mask
from roam_core.matte.vectorise import coverage_of, is_in_colour, outlines, read_mask, specks_left_out
from roam_core.roto import BlendMode, Origin
from tests.golden.shots import dense, overlap
from tests.unit.media.conftest import write_image

SIZE = (90, 120)


def disc(x: float, y: float, radius: float, size: tuple[int, int] = SIZE, samples: int = 16) -> Array:
    """Antialiased coverage of a disc, by counting."""
    height, width = size
    grid = [(np.arange(n * samples) + 0.5) / samples for n in size]
    inside = (grid[1][None] - x) ** 2 + (grid[0][:, None] - y) ** 2 < radius**2
    return inside.reshape(height, samples, width, samples).mean(axis=(1, 3))


def box(*boxes: tuple[int, int, int, int], size: tuple[int, int] = SIZE) -> UInt8:
    """A mask with boxes (left, top, right, bottom) of 255."""
    mask = np.zeros(size, dtype=np.uint8)
    for left, top, right, bottom in boxes:
        mask[top:bottom, left:right] = 255
    return mask


@pytest.mark.parametrize("radius", [8.0, 20.3, 33.3])
def test_a_soft_disc_is_met_far_below_a_pixel(radius: float) -> None:
    centre = np.array([58.3, 44.8])
    (ring,) = outlines(disc(*centre, radius))[0]
    assert np.abs(np.hypot(*(ring - centre).T) - radius).max() < 0.1


@pytest.mark.parametrize("radius", [12.0, 33.3])
def test_the_spline_of_a_soft_disc_is_met_below_half_a_pixel(radius: float) -> None:
    centre = np.array([58.3, 44.8])
    (shape,) = shapes_from_mask(disc(*centre, radius), tolerance=0.5)
    off = np.hypot(*(dense(shape.keys[0].points) - centre).T) - radius
    assert np.abs(off).mean() < 0.2
    assert np.abs(off).max() < 0.6


def test_one_shape_for_each_region_the_largest_first() -> None:
    shapes = shapes_from_mask(box((5, 5, 25, 25), (40, 10, 100, 70), (8, 50, 20, 62)), frame=1004)
    assert [shape.id for shape in shapes] == ["shape-1", "shape-2", "shape-3"]
    areas = [abs(polyline.signed_area(shape.at(1004).flatten())) for shape in shapes]
    assert areas == sorted(areas, reverse=True)
    assert areas == pytest.approx([3600.0, 400.0, 144.0], rel=0.1)
    assert all(shape.frames == (1004,) and shape.keys[0].origin is Origin.ARTIST for shape in shapes)
    assert all(shape.blend is BlendMode.ADD and shape.closed for shape in shapes)


def test_holes_subtract_and_follow_their_region() -> None:
    mask = box((10, 10, 70, 70), (80, 20, 110, 50))
    mask[20:40, 20:40] = 0
    mask[50:60, 50:60] = 0
    shapes = shapes_from_mask(mask)
    blends = [shape.blend for shape in shapes]
    assert blends == [BlendMode.ADD, BlendMode.SUBTRACT, BlendMode.SUBTRACT, BlendMode.ADD]
    assert [shape.name for shape in shapes] == ["Shape 1", "Shape 1 hole 1", "Shape 1 hole 2", "Shape 2"]
    assert overlap(render_matte(shapes, 0, SIZE) > 0.5, mask > 0) > 0.985


def test_all_outlines_of_a_mask_are_of_one_compound_and_those_of_others_of_theirs() -> None:
    mask = np.zeros((60, 90), dtype=bool)
    mask[10:50, 10:40] = mask[10:50, 50:80] = True
    mask[20:40, 20:30] = False
    shapes = shapes_from_mask(mask, 4)
    assert len(shapes) == 3
    (name,) = {shape.compound for shape in shapes}
    assert name == shapes_from_mask(mask.copy(), 4)[0].compound
    others = [(mask.T, 4), (mask, 5), (np.roll(mask, 1, axis=1), 4), (mask[::-1], 4), (mask[:, :85], 4)]
    assert len({name, *(shapes_from_mask(*other)[0].compound for other in others)}) == 5  # upside down it is the same


def test_an_island_in_a_hole_is_a_region_of_its_own() -> None:
    mask = box((10, 10, 80, 80))
    mask[20:70, 20:70] = 0
    mask[35:55, 35:55] = 255
    shapes = shapes_from_mask(mask)
    assert [shape.blend for shape in shapes] == [BlendMode.ADD, BlendMode.SUBTRACT, BlendMode.ADD]
    assert overlap(render_matte(shapes, 0, SIZE) > 0.5, mask > 0) > 0.985


@pytest.mark.parametrize(
    "edges", [(0, 0, 40, 40), (80, 0, 120, 90), (0, 50, 120, 90), (0, 0, 120, 90)],
    ids=["corner", "side", "bottom", "everything"],
)  # fmt: skip
def test_a_mask_at_the_border_ends_at_the_border(edges: tuple[int, int, int, int]) -> None:
    (shape,) = shapes_from_mask(box(edges))
    line = shape.at(0).flatten()
    np.testing.assert_allclose(line.min(axis=0), edges[:2], atol=0.5)
    np.testing.assert_allclose(line.max(axis=0), edges[2:], atol=0.5)
    assert overlap(render_matte([shape], 0, SIZE) > 0.5, box(edges) > 0) > 0.99


@pytest.mark.parametrize("seed", range(4))
def test_the_matte_of_the_shapes_is_the_mask(seed: int) -> None:
    noise = cv2.GaussianBlur(np.random.default_rng(seed).normal(size=(140, 180)), (0, 0), 12.0)
    mask = noise > 0.3 * noise.std()
    shapes = shapes_from_mask(mask)
    assert overlap(render_matte(shapes, 0, mask.shape) > 0.5, mask) > 0.95
    assert sum(shape.point_count for shape in shapes) < 150


SOFT = disc(60.0, 45.0, 30.0)
HARD = SOFT > 0.5


@pytest.mark.parametrize(
    "mask",
    [
        HARD,
        HARD.astype(np.uint8),
        HARD.astype(np.int64) * 3,
        HARD.astype(np.uint8) * 255,
        HARD.astype(np.uint16) * 65535,
        HARD.astype(np.float32),
        HARD.astype(np.float64)[..., None],
        np.repeat(HARD[..., None].astype(np.uint8) * 255, 3, axis=2),
        np.stack([np.full(SIZE, 200, np.uint8)] * 3 + [HARD.astype(np.uint8) * 255], axis=2),
        np.stack([np.full(SIZE, 200, np.uint8), HARD.astype(np.uint8) * 255], axis=2),
        np.stack([HARD * 1.0, np.zeros(SIZE), np.zeros(SIZE)], axis=2),
    ],
    ids=["bool", "0/1", "labels", "uint8", "uint16", "float32", "one channel", "RGB", "RGBA", "grey and alpha", "red"],
)
def test_every_kind_of_mask_gives_the_same_outline(mask: NDArray[np.generic]) -> None:
    expected = outlines(HARD)[0][0]
    np.testing.assert_allclose(outlines(mask)[0][0], expected, atol=1e-6)


def test_grey_is_coverage() -> None:
    grey = np.round(SOFT * 255).astype(np.uint8)
    np.testing.assert_allclose(coverage_of(grey), SOFT, atol=1 / 500)
    np.testing.assert_allclose(coverage_of(np.array([[np.nan, -1.0, 2.0]])), [[0.0, 0.0, 1.0]])


@pytest.mark.parametrize("mask", [np.zeros(SIZE, np.uint8), np.zeros(SIZE), np.zeros(SIZE, bool), np.zeros((0, 0))])
def test_an_empty_mask_has_no_shape(mask: NDArray[np.generic]) -> None:
    assert shapes_from_mask(mask) == []


def test_specks_are_left_out_unless_there_is_nothing_else() -> None:
    speck = (5, 5, 7, 7)
    assert len(shapes_from_mask(box(speck, (30, 30, 60, 60)))) == 1
    (shape,) = shapes_from_mask(box(speck))
    np.testing.assert_allclose(shape.at(0).anchors.mean(axis=0), (6.0, 6.0), atol=0.5)


def test_what_is_left_out_is_counted() -> None:
    mask = box((5, 5, 7, 7), (30, 30, 60, 60), (70, 5, 71, 6))
    mask[40:42, 40:42] = 0
    assert specks_left_out(mask) == 3
    assert specks_left_out(box((5, 5, 7, 7))) == 0  # there is nothing larger
    assert specks_left_out(np.zeros(SIZE)) == 0


@pytest.mark.parametrize("colours", [1, 3])
def test_an_alpha_that_is_opaque_all_over_says_nothing(colours: int) -> None:
    white = HARD.astype(np.uint8) * 255
    mask = np.stack([white] * colours + [np.full(SIZE, 255, np.uint8)], axis=2)
    np.testing.assert_array_equal(coverage_of(mask), coverage_of(white))


def test_what_is_no_mask_is_refused() -> None:
    with pytest.raises(ValueError, match="a mask has shape"):
        coverage_of(np.zeros(5))


# ---- mask files ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["mask.png", "mask.tif", "mask.jpg"])
def test_a_mask_is_read_from_a_file(tmp_path: Path, name: str) -> None:
    cv2.imwrite(str(tmp_path / name), HARD.astype(np.uint8) * 255)
    assert overlap(coverage_of(read_mask(tmp_path / name, SIZE)) > 0.5, HARD) > 0.99


def test_alpha_and_sixteen_bits_survive_reading(tmp_path: Path) -> None:
    cv2.imwrite(str(tmp_path / "a.png"), np.round(SOFT * 65535).astype(np.uint16))
    np.testing.assert_allclose(coverage_of(read_mask(tmp_path / "a.png")), SOFT, atol=1e-4)
    rgba = np.stack([np.full(SIZE, 255, np.uint8)] * 3 + [HARD.astype(np.uint8) * 255], axis=2)
    cv2.imwrite(str(tmp_path / "b.png"), rgba)
    np.testing.assert_array_equal(coverage_of(read_mask(tmp_path / "b.png")) > 0.5, HARD)


def test_a_mask_of_which_a_part_is_stored_lies_in_its_display_window(tmp_path: Path) -> None:
    stored, window = SOFT[20:70, 30:100, None].astype(np.float32), {"x": 30, "y": 20}
    file = write_image(tmp_path / "tight.exr", stored, "float", **window, full_width=SIZE[1], full_height=SIZE[0])
    expected = np.zeros(SIZE)
    expected[20:70, 30:100] = stored[..., 0]
    np.testing.assert_allclose(coverage_of(read_mask(file, SIZE)), expected)


def test_masks_that_cannot_serve_are_refused(tmp_path: Path) -> None:
    (tmp_path / "text.png").write_text("no picture")
    noise = np.random.default_rng(1).integers(0, 256, SIZE, dtype=np.uint8)
    for name in ("cut.png", "cut.jpg", "cut.tif"):
        cv2.imwrite(str(tmp_path / name), noise)
        whole = (tmp_path / name).read_bytes()
        (tmp_path / name).write_bytes(whole[: len(whole) // 2])
        with pytest.raises(RoamError, match="cannot be read as a mask"):
            read_mask(tmp_path / name)
    cv2.imwrite(str(tmp_path / "small.png"), np.full((4, 4), 255, np.uint8))
    with pytest.raises(RoamError, match="does not exist"):
        read_mask(tmp_path / "none.png")
    with pytest.raises(RoamError, match="cannot be read as a mask"):
        read_mask(tmp_path / "text.png")
    with pytest.raises(RoamError, match="is a folder"):
        read_mask(tmp_path)
    os.mkfifo(tmp_path / "pipe.png")
    with pytest.raises(RoamError, match="is a pipe"):
        read_mask(tmp_path / "pipe.png")
    (tmp_path / "large.gif").write_bytes(b"GIF89a" + b"\xff" * 100)
    with pytest.raises(RoamError, match="claims to be 65535 x 65535 pixels"):
        read_mask(tmp_path / "large.gif")
    with pytest.raises(RoamError, match="is 4x4, the clip is 120x90"):
        read_mask(tmp_path / "small.png", SIZE)


@pytest.mark.parametrize("kind", [np.int32, np.int64, np.uint32, np.int16])
@pytest.mark.parametrize("white", [1, 255])
def test_integers_that_arithmetic_made_of_a_mask_are_white_where_it_was(kind: type, white: int) -> None:
    mask = box((20, 20, 60, 50))
    np.testing.assert_array_equal(coverage_of((mask // 255).astype(kind) * kind(white)), mask / 255.0)


@pytest.mark.parametrize("kind", [np.int8, np.int16, np.int32])
def test_integers_with_a_sign_are_white_where_their_type_ends(kind: type) -> None:
    mask = box((20, 20, 60, 50))
    np.testing.assert_array_equal(coverage_of((mask // 255).astype(kind) * kind(np.iinfo(kind).max)), mask / 255.0)


@pytest.mark.parametrize("brightest", [17, 200, 254, 256, 1000, 16383])
def test_a_dark_picture_of_sixteen_bits_is_no_mask(brightest: int) -> None:
    assert shapes_from_mask((box((20, 20, 60, 50)) > 0).astype(np.uint16) * np.uint16(brightest)) == []


@pytest.mark.parametrize("white", [255, 1023, 4095])
def test_sixteen_bits_that_hold_a_mask_of_fewer_are_white_where_it_was(white: int) -> None:
    mask = box((20, 20, 60, 50))
    np.testing.assert_array_equal(coverage_of((mask // 255).astype(np.uint16) * np.uint16(white)), mask / 255.0)


@pytest.mark.parametrize(("white", "kind"), [(255.0, np.float32), (255.0, np.float64), (65535.0, np.float64)])
def test_a_soft_mask_in_floats_of_a_picture_is_met_at_half_of_its_white(white: float, kind: type) -> None:
    soft = cv2.GaussianBlur(box((20, 20, 60, 50)).astype(np.float64) / 255.0, (0, 0), 4.0)
    np.testing.assert_allclose(coverage_of((soft * white).astype(kind)), soft, atol=1e-6)
    np.testing.assert_allclose(coverage_of(soft * 0.7 * white), soft * 0.7, atol=1e-6)
    for light in (1.2, 16.0, 100.0, 5000.0):  # coverage that overshoots, and light of a scene
        np.testing.assert_array_equal(coverage_of(soft * light), np.clip(soft * light, 0.0, 1.0))


@pytest.mark.parametrize("tone", [128, 200, 254])
def test_the_brighter_of_two_tones_is_white(tone: int) -> None:
    mask = box((20, 20, 60, 50)) // 255
    for two in (mask * np.uint8(tone), mask * np.uint16(tone * 257), mask * np.float32(tone / 255.0)):
        np.testing.assert_array_equal(coverage_of(two), mask)
    np.testing.assert_array_equal(coverage_of(np.dstack([mask * np.uint8(tone), 0 * mask, 0 * mask])), mask)
    assert coverage_of(mask * np.uint8(127)).max() < 0.5
    grey = mask * np.uint8(tone)
    grey[0, 0] = 64  # a third tone: these are shades
    assert coverage_of(grey).max() == tone / 255.0


def test_what_is_no_number_is_black_and_the_infinite_white() -> None:
    values = np.array([[np.nan, np.inf, -np.inf, -3.0], [0.5, 1.0, 0.0, 0.25]])
    np.testing.assert_array_equal(coverage_of(values), [[0.0, 1.0, 0.0, 0.0], [0.5, 1.0, 0.0, 0.25]])


@pytest.mark.parametrize("size", [[4, 4], np.array([4, 4]), (np.int64(4), 4.0)])
def test_the_size_of_a_mask_may_be_any_pair_of_whole_numbers(tmp_path: Path, size: Any) -> None:
    cv2.imwrite(str(tmp_path / "mask.png"), np.zeros((4, 4), np.uint8))
    assert read_mask(tmp_path / "mask.png", size).shape == (4, 4, 1)
    with pytest.raises(ValueError, match="height, width"):
        read_mask(tmp_path / "mask.png", (4, 4, 1))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("kind", "ids"), [(np.uint8, (1, 2)), (np.uint32, (3, 7)), (np.uint32, (40, 200)), (np.uint32, (9, 4_000_000_001))]
)
def test_of_a_mask_of_labels_each_gives_shapes(kind: type, ids: tuple[int, int]) -> None:
    """Also where they touch, and one lies within the other; the lesser of two labels was taken for black."""
    one, other = box((10, 10, 50, 60)) > 0, box((50, 10, 80, 60), (20, 20, 30, 30)) > 0
    labels = np.zeros(SIZE, kind)
    labels[one], labels[other] = kind(ids[0]), kind(ids[1])
    np.testing.assert_array_equal(coverage_of(labels), labels > 0)
    shapes = shapes_from_mask(labels)
    assert [shape.name for shape in shapes] == ["Shape 1", "Shape 1 hole 1", "Shape 2", "Shape 3"]
    found = [render_matte([shape], 0, SIZE) > 0.5 for shape in shapes]
    assert overlap(found[0] & ~found[1], one) > 0.97
    assert overlap(found[2] | found[3], other) > 0.97


def test_each_of_many_labels_lies_where_it_is() -> None:
    numbers = np.arange(1, 36, dtype=np.uint32).reshape(5, 7)[::-1]
    labels = np.kron(numbers * np.uint32(100_000_000), np.ones((20, 20), np.uint32))
    found = {tuple(shape.at(0).anchors.mean(axis=0).round()) for shape in shapes_from_mask(labels)}
    assert found == {(10.0 + 20.0 * x, 10.0 + 20.0 * y) for x in range(7) for y in range(5)}


def test_wide_integers_of_a_picture_are_shades() -> None:
    soft = (np.clip(disc(60.0, 45.0, 25.0) * 1.2 - 0.1, 0.0, 1.0) * 255).astype(np.uint8)
    for reckoned in (soft.astype(np.uint32), soft.astype(np.int64) * 257, soft.astype(np.uint32) * 0x01010101):
        np.testing.assert_allclose(coverage_of(reckoned), soft / 255.0, atol=1e-6)


@pytest.mark.parametrize("shape", [(1, 90, 120), (3, 90, 120)])
def test_a_mask_with_its_channels_first_is_refused(shape: tuple[int, ...]) -> None:
    with pytest.raises(RoamError, match=r"has its channels first; give one of them, such as mask\[0\]"):
        shapes_from_mask(np.ones(shape, bool))


def test_a_photograph_is_told_from_masks_in_colour() -> None:
    """Masks of data sets paint objects in dark red, also those that fill most of the picture."""
    noise = cv2.GaussianBlur(np.random.default_rng(2).normal(size=(*SIZE, 3)), (0, 0), 2.0)
    photograph = np.clip(128.0 + 60.0 * noise / noise.std(), 0, 255).astype(np.uint8)
    cover = disc(60.0, 45.0, 70.0)
    red = np.round(cover[..., None] * (128, 0, 0)).astype(np.uint8)
    assert (cover > 0.5).mean() > 0.8
    assert is_in_colour(photograph)
    assert is_in_colour(photograph / np.float32(255.0))
    for mask in (red, np.repeat(photograph[..., :1], 3, axis=2), photograph[..., 0], np.zeros((*SIZE, 3), np.uint8)):
        assert not is_in_colour(mask)
