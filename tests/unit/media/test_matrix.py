"""Every format, depth and layout of channels: written with OpenImageIO, Cineon byte by byte, and read back."""

from __future__ import annotations

import itertools
import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from roam_core.arrays import Image
from roam_core.media import open_clip
from roam_core.media.colour import to_engine, unit_floats
from tests.unit.media.conftest import HEIGHT, WIDTH, picture, write_image

INTEGER = {"uint8": 255, "uint10": 1023, "uint12": 4095, "uint16": 65535}
FORMATS: dict[str, tuple[str, ...]] = {
    "png": ("uint8", "uint16"),
    "tif": ("uint8", "uint16", "float"),
    "exr": ("half", "float"),
    "dpx": ("uint8", "uint10", "uint12", "uint16"),
    "tga": ("uint8",),
    "sgi": ("uint8", "uint16"),
}
LAYOUTS: dict[str, tuple[str, ...]] = {
    "grey": ("Y",),
    "grey and alpha": ("Y", "A"),
    "colour": ("R", "G", "B"),
    "colour and alpha": ("R", "G", "B", "A"),
}
EXR_LAYOUTS: dict[str, tuple[str, ...]] = {
    "blue first": ("B", "G", "R"),
    "depth before it": ("Z", "R", "G", "B"),
    "in a layer": ("N.X", "N.Y", "N.Z", "beauty.R", "beauty.G", "beauty.B"),
}
WITHOUT = {("dpx", "grey and alpha"), ("sgi", "grey and alpha"), ("tga", "grey and alpha"), ("tga", "grey")}
"""What OpenImageIO writes as something else, or not at all."""

TOLD = ("frames", "missing", "size", "fps", "pixel_aspect", "colour_space", "depth", "layer", "layers")
"""What a plate tells of its files."""

CASES = [
    (extension, depth, layout, channels)
    for extension, depths in FORMATS.items()
    for depth, (layout, channels) in itertools.product(
        depths, {**LAYOUTS, **(EXR_LAYOUTS if extension == "exr" else {})}.items()
    )
    if (extension, layout) not in WITHOUT
]


def stored(depth: str, channels: int) -> Image:
    """Values in [0, 1] that a depth holds exactly; of floating point some lie below 0 and above 1."""
    values = picture(channels, channels)
    if depth in INTEGER:
        top = INTEGER[depth]
        return (np.round(values * top) / top).astype(np.float64)
    return (values * 4.0 - 1.0).astype(np.float16 if depth == "half" else np.float32).astype(np.float64)


def written(path: Path, depth: str, values: Image, channels: tuple[str, ...], **fields: Any) -> Path:
    """A file of these values; depths between 8 and 16 bits are told to the writer as such."""
    kind = depth if depth in ("uint8", "half", "float") else "uint16"
    if depth in ("uint10", "uint12"):
        fields["oiio__BitsPerSample"] = int(depth[4:])
    if "A" in channels:
        fields["oiio__UnassociatedAlpha"] = 1  # the writer is not to divide by it
    pixels: Image = values.astype(np.float32)
    if kind in ("uint8", "uint16"):
        top = INTEGER[kind]
        pixels = np.round(values * top).astype(kind)
    return write_image(path, pixels, kind, channelnames=channels, **fields)


def shown(values: Image, channels: tuple[str, ...]) -> Image:
    """What of the values is the picture."""
    last = [name.rpartition(".")[2] for name in channels]
    wanted = ("R", "G", "B") if "R" in last else ("Y", "Y", "Y")
    return values[..., [last.index(name) for name in wanted]]


@pytest.mark.parametrize(("extension", "depth", "layout", "channels"), CASES)
def test_what_was_written_is_read(
    tmp_path: Path,
    apart: Callable[[], None],
    extension: str,
    depth: str,
    layout: str,
    channels: tuple[str, ...],
) -> None:
    values = stored(depth, len(channels))
    plate = open_clip(written(tmp_path / f"p.1001.{extension}", depth, values, channels))
    image = plate.read(1001)
    assert image.shape == (HEIGHT, WIDTH, 3)
    assert image.flags.c_contiguous
    expected = shown(values, channels)
    if depth == "uint8":
        assert image.dtype == np.uint8
        np.testing.assert_array_equal(image, np.round(expected * 255))
    elif depth in INTEGER:
        assert image.dtype == np.uint16
        values = unit_floats(image)
        np.testing.assert_allclose(values, expected, atol=1.5 / 65535)
        np.testing.assert_array_equal(np.round(values * INTEGER[depth]), np.round(expected * INTEGER[depth]))
    else:
        assert image.dtype == {"half": np.float16, "float": np.float32}[depth]
        np.testing.assert_array_equal(image, expected)
    words = {"half": "half float", "float": "float"}
    assert plate.depth == words.get(depth, f"{depth.removeprefix('uint')} bits")

    apart()
    again = open_clip(plate.path)
    assert all(getattr(again, name) == getattr(plate, name) for name in TOLD)
    decoded = again.read(1001)
    assert (decoded.dtype, decoded.shape, decoded.tobytes()) == (image.dtype, image.shape, image.tobytes())


@pytest.mark.parametrize("compression", ["none", "rle", "zips", "zip", "piz"])
@pytest.mark.parametrize("tile", [0, 8])
@pytest.mark.parametrize("depth", ["half", "float"])
def test_every_lossless_exr(tmp_path: Path, compression: str, tile: int, depth: str) -> None:
    values = stored(depth, 3)
    fields = {"compression": compression, "tile_width": tile, "tile_height": tile}
    path = written(tmp_path / "p.1.exr", depth, values, ("R", "G", "B"), **fields)
    np.testing.assert_array_equal(open_clip(path).read(1), values)


@pytest.mark.parametrize("compression", ["pxr24", "b44", "b44a", "dwaa", "dwab"])
def test_every_lossy_exr(tmp_path: Path, compression: str) -> None:
    values = np.tile(np.linspace(0.0, 1.0, WIDTH, dtype=np.float32)[None, :, None], (HEIGHT, 1, 3))
    path = write_image(tmp_path / "p.1.exr", values, "half", compression=compression)
    np.testing.assert_allclose(open_clip(path).read(1), values, atol=0.02)


def cineon(path: Path, codes: Image) -> Path:
    """A Cineon file, three channels of 10 bits in 32-bit words, by Kodak's format 4.5; big endian."""
    height, width = codes.shape[:2]
    header = bytearray(b"\xff" * 2048)
    struct.pack_into(
        ">IIIIII8s", header, 0, 0x802A5FD7, 2048, 1024, 1024, 0, 2048 + 4 * width * height, b"V4.5\0\0\0\0"
    )
    struct.pack_into(">BBBB", header, 192, 0, 3, 0, 0)
    for channel in range(3):
        at = 196 + 28 * channel
        struct.pack_into(">BBBBII4f", header, at, 0, channel + 1, 10, 0, width, height, 0.0, 0.0, 1023.0, 2.046)
    struct.pack_into(">BBBBII", header, 680, 0, 5, 0, 0, 0, 0)
    red, green, blue = (codes[..., channel].astype(np.uint32) for channel in range(3))
    path.write_bytes(bytes(header) + (red << 22 | green << 12 | blue << 2).astype(">u4").tobytes())
    return path


def test_cineon(tmp_path: Path) -> None:
    codes = np.round(picture(9) * 1023)
    codes[0, 0], codes[0, 1] = 95, 685
    plate = open_clip(cineon(tmp_path / "p.0001.cin", codes))
    image = plate.read(1)
    assert (plate.colour_space, plate.size, plate.depth) == ("log", (WIDTH, HEIGHT), "10 bits")
    np.testing.assert_array_equal(np.round(unit_floats(image) * 1023), codes)
    np.testing.assert_allclose(to_engine(image, "log")[0, :2], [[0.0] * 3, [1.0] * 3], atol=1e-3)
