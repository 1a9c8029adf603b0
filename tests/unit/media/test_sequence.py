"""Images of all kinds as the frames of a plate: depth, channels, windows, metadata, damage."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import numpy as np
import OpenImageIO as oiio  # noqa: N813 - the name its own manual uses
import pytest

from roam_core.errors import RoamError
from roam_core.media import DamagedFrame, image_file, measure, open_clip
from roam_core.media.colour import unit_floats
from roam_core.media.image_file import image_extensions, read_image
from roam_core.media.layers import Part, colour_layer, layers_of
from tests.unit.media.conftest import HEIGHT, WIDTH, picture, write_bytes_png, write_image


@pytest.mark.parametrize("extension", ["png", "tif", "bmp"])
def test_8_bits_stay_8_bits(tmp_path: Path, extension: str) -> None:
    pixels = (picture(1) * 255).astype(np.uint8)
    image = open_clip(write_image(tmp_path / f"p.0001.{extension}", pixels, "uint8")).read(1)
    assert image.dtype == np.uint8
    np.testing.assert_array_equal(image, pixels)


def test_jpeg_is_8_bit_rgb(tmp_path: Path) -> None:
    pixels = np.zeros((HEIGHT, WIDTH, 3), np.uint8)
    pixels[:] = (200, 100, 20)
    plate = open_clip(write_image(tmp_path / "00000.jpg", pixels, "uint8"))
    image = plate.read(0)
    assert (image.dtype, plate.colour_space) == (np.uint8, "sRGB")
    assert np.abs(image.astype(int) - pixels).max() <= 3


@pytest.mark.parametrize("extension", ["png", "tif"])
def test_16_bits_stay_16_bits(tmp_path: Path, extension: str) -> None:
    pixels = (picture(2) * 65535).astype(np.uint16)
    pixels[0, 0] = (0, 65535, 32768)
    plate = open_clip(write_image(tmp_path / f"p.0001.{extension}", pixels, "uint16"))
    image = plate.read(1)
    assert (image.dtype, plate.colour_space) == (np.uint16, "sRGB")
    np.testing.assert_array_equal(image, pixels)
    np.testing.assert_allclose(unit_floats(image), pixels / 65535.0, atol=1e-7)


def test_half_exr_is_linear_and_not_clipped(tmp_path: Path) -> None:
    pixels = picture(3) * 8.0 - 1.0
    fields = {"PixelAspectRatio": 2.0, "FramesPerSecond": 25.0}
    plate = open_clip(write_image(tmp_path / "p.1001.exr", pixels, "half", **fields))
    image = plate.read(1001)
    assert image.dtype == np.float16
    assert (plate.colour_space, plate.pixel_aspect, plate.fps) == ("linear", 2.0, 25.0)
    np.testing.assert_array_equal(image, pixels.astype(np.float16))


@pytest.mark.parametrize("rate", [(24000, 1001), (1, 2)])
def test_a_rational_frame_rate(tmp_path: Path, rate: tuple[int, int]) -> None:
    spec = oiio.ImageSpec(4, 4, 3, "half")
    spec.attribute("FramesPerSecond", oiio.TypeRational, rate)
    output = oiio.ImageOutput.create(str(tmp_path / "p.exr"))
    assert output.open(str(tmp_path / "p.exr"), spec)
    output.write_image(np.zeros((4, 4, 3), np.float32))
    output.close()
    assert open_clip(tmp_path / "p.exr").fps == float(Fraction(*rate))


@pytest.mark.parametrize(
    ("transfer", "space"),
    [
        ("Undefined", "log"),
        ("Printing density", "log"),
        ("Logarithmic", "log"),
        ("Linear", "linear"),
        ("ITU-R 709-4", "sRGB"),
        ("SMPTE 274M", "sRGB"),
    ],
)
def test_dpx_of_10_bits(tmp_path: Path, transfer: str, space: str) -> None:
    codes = np.round(picture(4) * 1023)
    fields = {"oiio__BitsPerSample": 10, "dpx__Transfer": transfer, "dpx__FrameRate": 25.0}
    file = write_image(tmp_path / "p.0001.dpx", (codes / 1023).astype(np.float32), "uint16", **fields)
    plate = open_clip(file)
    image = plate.read(1)
    assert (image.dtype, plate.colour_space, plate.fps) == (np.uint16, space, 25.0)
    np.testing.assert_array_equal(np.round(unit_floats(image) * 1023), codes)


def test_metadata_overrules_what_a_format_usually_holds(tmp_path: Path) -> None:
    video = write_image(tmp_path / "a.exr", picture(1), "half", oiio__ColorSpace="srgb_rec709_scene")
    assert open_clip(video).colour_space == "sRGB"
    floats = write_image(tmp_path / "b.tif", picture(1), "float")
    assert open_clip(floats).colour_space == "linear"


def test_a_pfm_is_linear_as_all_floating_point(tmp_path: Path) -> None:
    write_image(tmp_path / "p.1.pfm", np.full((4, 5, 3), 1.75, np.float32), "float")
    plate = open_clip(tmp_path)
    assert (plate.depth, plate.colour_space) == ("float", "linear")
    np.testing.assert_array_equal(plate.read(1), np.float32(1.75))


def test_grey_becomes_three_channels(tmp_path: Path) -> None:
    grey = (picture(5, 1) * 255).astype(np.uint8)
    image = read_image(write_image(tmp_path / "g.png", grey, "uint8"))
    np.testing.assert_array_equal(image, np.repeat(grey, 3, axis=2))


@pytest.mark.parametrize("extension", ["png", "tif"])
def test_alpha_is_left_out_and_not_multiplied_in(tmp_path: Path, extension: str) -> None:
    rgba = np.full((HEIGHT, WIDTH, 4), 200, np.uint8)
    rgba[..., 3] = 50
    file = write_image(tmp_path / f"p.{extension}", rgba, "uint8", oiio__UnassociatedAlpha=1)
    np.testing.assert_array_equal(read_image(file), rgba[..., :3])


def test_associated_alpha_is_not_divided_out(tmp_path: Path) -> None:
    rgba = np.full((HEIGHT, WIDTH, 4), 0.25, np.float32)
    assert np.all(read_image(write_image(tmp_path / "p.exr", rgba, "half")) == 0.25)


@pytest.mark.parametrize(
    ("names", "channels"),
    [
        (("R", "G", "B"), (0, 1, 2)),
        (("A", "B", "G", "R"), (3, 2, 1)),
        (("Z", "beauty.R", "beauty.G", "beauty.B"), (1, 2, 3)),
        (("spec.R", "spec.G", "spec.B", "R", "G", "B"), (3, 4, 5)),
        (("u.R", "full.R", "full.G", "full.B"), (1, 2, 3)),
        (("X", "Y2", "Z", "W"), (0, 1, 2)),
        (("BY", "RY", "Y"), (2, 2, 2)),
        (("Y",), (0, 0, 0)),
        (("depth", "A"), (0, 0, 0)),
    ],
)
def test_channels_that_show_as_colour(names: tuple[str, ...], channels: tuple[int, int, int]) -> None:
    assert colour_layer(layers_of([Part("", "", names)])).channels == channels


def test_an_exr_of_many_channels_gives_red_green_blue_by_name(tmp_path: Path) -> None:
    pixels = np.zeros((HEIGHT, WIDTH, 6), np.float32) + np.arange(6, dtype=np.float32)
    names = ("B", "depth.Z", "G", "R", "motion.u", "motion.v")
    image = read_image(write_image(tmp_path / "p.exr", pixels, "half", channelnames=names))
    assert image.shape == (HEIGHT, WIDTH, 3)
    assert image.flags.c_contiguous
    assert np.all(image == (3.0, 2.0, 0.0))


@pytest.mark.parametrize(
    "window",
    [(3, 2, 8, 6), (-4, -3, 8, 6), (12, 9, 8, 6), (-2, -2, WIDTH + 5, HEIGHT + 5), (40, 40, 8, 6)],
    ids=["inside", "top-left", "bottom-right", "overscan", "outside"],
)
@pytest.mark.parametrize("corner", [(0, 0), (100, -50)])
def test_a_data_window_is_put_into_the_display_window(
    tmp_path: Path, window: tuple[int, int, int, int], corner: tuple[int, int]
) -> None:
    x, y, width, height = window
    data = np.random.default_rng(0).integers(1, 100, (height, width, 3)).astype(np.float32)
    display = {"full_x": corner[0], "full_y": corner[1], "full_width": WIDTH, "full_height": HEIGHT}
    file = write_image(tmp_path / "p.0001.exr", data, "half", x=x + corner[0], y=y + corner[1], **display)
    expected = np.zeros((HEIGHT, WIDTH, 3), np.float32)
    for row in range(height):
        for column in range(width):
            if 0 <= row + y < HEIGHT and 0 <= column + x < WIDTH:
                expected[row + y, column + x] = data[row, column]
    plate = open_clip(file)
    assert plate.size == (WIDTH, HEIGHT)
    np.testing.assert_array_equal(plate.read(1), expected)


def test_a_tiffs_place_on_its_page_does_not_shift_it(tmp_path: Path) -> None:
    pixels = (picture(6) * 255).astype(np.uint8)
    file = write_image(tmp_path / "p.tif", pixels, "uint8", x=5, y=3, full_width=WIDTH + 5, full_height=HEIGHT + 3)
    plate = open_clip(file)
    assert plate.size == (WIDTH, HEIGHT)
    np.testing.assert_array_equal(plate.read(1), pixels)


@pytest.mark.parametrize(
    ("extension", "pixel_format"),
    [("png", "uint8"), ("jpg", "uint8"), ("tif", "uint16"), ("exr", "half"), ("dpx", "uint16")],
)
def test_a_file_cut_short_is_named(tmp_path: Path, extension: str, pixel_format: str) -> None:
    for frame in (1, 2):
        write_image(tmp_path / f"p.{frame}.{extension}", picture(frame), pixel_format)
    file = tmp_path / f"p.2.{extension}"
    file.write_bytes(file.read_bytes()[: file.stat().st_size * 2 // 3])
    plate = open_clip(tmp_path)
    assert plate.read(1).shape == (HEIGHT, WIDTH, 3)
    with pytest.raises(DamagedFrame, match=rf"p\.2\.{extension} ") as caught:
        plate.read(2)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("extension", ["png", "jpg", "exr", "dpx", "tif"])
@pytest.mark.parametrize("content", [b"", b"these are only words, and no picture at all\n" * 100])
def test_text_in_an_images_name_is_told(tmp_path: Path, extension: str, content: bytes) -> None:
    file = tmp_path / f"p.{extension}"
    file.write_bytes(content)
    with pytest.raises(RoamError, match=rf"p\.{extension} is no image"):
        open_clip(file)


@pytest.mark.parametrize(
    ("extension", "pixel_format"),
    [("png", "uint8"), ("jpg", "uint8"), ("tif", "uint16"), ("exr", "half"), ("dpx", "uint16")],
)
def test_damaged_bytes_anywhere_give_a_picture_or_a_sentence(tmp_path: Path, extension: str, pixel_format: str) -> None:
    whole = write_image(tmp_path / f"p.{extension}", picture(1), pixel_format).read_bytes()
    rng = np.random.default_rng(1)
    file = tmp_path / f"damaged.{extension}"
    outcomes = {"picture": 0, "sentence": 0}
    for reach in [64, 400, len(whole)] * 25:
        damaged = bytearray(whole)
        for place in rng.integers(0, min(reach, len(whole)), rng.integers(1, 6)):
            damaged[place] = rng.integers(0, 256)
        file.write_bytes(damaged)
        try:
            image = open_clip(file).read(1)
        except RoamError:
            outcomes["sentence"] += 1
        else:
            assert image.shape[2] == 3
            outcomes["picture"] += 1
    assert outcomes["sentence"] > 0


def test_a_message_that_quotes_bytes_of_the_file_is_told_without_them(tmp_path: Path) -> None:
    file = write_image(tmp_path / "p.exr", picture(1), "half")
    file.write_bytes(file.read_bytes().replace(b"chlist\0", b"\xff\xfelist\0"))
    with pytest.raises(RoamError, match=r"p\.exr"):
        open_clip(file).read(1)


def test_a_damaged_first_frame_does_not_keep_a_plate_from_opening(tmp_path: Path) -> None:
    write_bytes_png(tmp_path / "p.2.png")
    (tmp_path / "p.1.png").write_text("words")
    plate = open_clip(tmp_path)
    assert (plate.frames, plate.size) == ((1, 2), (WIDTH, HEIGHT))
    with pytest.raises(RoamError, match=r"p\.1\.png is no image"):
        plate.read(1)


def test_a_frame_of_another_size_is_named(tmp_path: Path) -> None:
    write_bytes_png(tmp_path / "p.1.png")
    write_bytes_png(tmp_path / "p.2.png", size=(8, 6))
    with pytest.raises(RoamError, match=r"p\.2\.png is 8 x 6 pixels, the plate is 16 x 12"):
        open_clip(tmp_path).read(2)


def test_a_header_that_claims_too_much_is_refused_before_it_is_allocated(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert oiio.get_int_attribute("limits:imagesize_MB") == image_file.LARGEST_IMAGE_MB
    window = {"full_width": 4000, "full_height": 1000}
    file = write_image(tmp_path / "p.exr", picture(1), "half", **window)
    assert open_clip(file).size == (4000, 1000)
    monkeypatch.setattr(measure, "MAX_PIXELS", 3_000_000)
    with pytest.raises(RoamError, match="claims to be 4000 x 1000 pixels, more than the 3 million"):
        open_clip(file)


def test_channels_that_lie_far_apart_are_read_without_those_between(tmp_path: Path) -> None:
    pixels = picture(1, 40)
    names = ("R", *(f"c{k}" for k in range(38)), "G")
    file = write_image(tmp_path / "p.exr", pixels, "float", channelnames=(*names[:-2], "B", "G"))
    np.testing.assert_array_equal(open_clip(file).read(1), pixels[..., [0, 39, 38]])


def test_extensions_of_plates_are_known() -> None:
    assert {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr", ".dpx", ".cin"} <= image_extensions()
    assert not {".txt", ".mov", ".z", ".null", "."} & image_extensions()
