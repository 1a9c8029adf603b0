"""Scanlines by OpenEXR's own library: bit by bit what OpenImageIO reads, and what it refuses OpenImageIO tells of."""

from __future__ import annotations

import io
import itertools
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import Imath
import numpy as np
import OpenEXR
import pytest

from roam_core.arrays import Image
from roam_core.errors import RoamError
from roam_core.media import DamagedFrame, decoding, open_clip, scanlines
from roam_core.media.area import Area
from roam_core.media.decoding.worker import Worker
from roam_core.media.image_file import read_header, read_image, size_in_areas
from roam_core.media.scanlines import ScanlineReader
from tests.unit.media.conftest import write_image, write_parts

ROWS, COLUMNS = 330, 200
LOSSLESS = ("none", "rle", "zips", "zip", "piz")
LOSSY = ("pxr24", "b44", "b44a", "dwaa", "dwab")
WINDOWS: tuple[dict[str, Any], ...] = (
    {},
    {"x": 7, "y": 20, "full_width": 250, "full_height": 400},
    {"x": -5, "y": -30, "full_width": 170, "full_height": 100},
    {"x": -9, "y": -400, "full_x": -20, "full_y": -410, "full_width": 300, "full_height": 360},
)
SCANLINES = {"type": OpenEXR.scanlineimage, "compression": OpenEXR.ZIP_COMPRESSION}
AREAS = (None, Area(0, 1, 0, 1), Area(31, 97, 40, 160), Area(90, 100, 3, 4), Area(0, 99, 100, 170))


class Spy(ScanlineReader):
    """Tells of each picture whether it was given."""

    def __init__(self) -> None:
        super().__init__()
        self.given: list[bool] = []

    def read(self, *words: Any) -> Image | None:
        pixels = super().read(*words)
        self.given.append(pixels is not None)
        return pixels


def every_value(kind: str) -> Image:
    """A picture of all halves, or of floats of all kinds: denormal, infinite, no numbers of many bits."""
    if kind == "half":
        return np.resize(np.arange(1 << 16, dtype=np.uint16), (ROWS, COLUMNS, 3)).view(np.float16)
    drawn = np.random.default_rng(5).integers(0, 1 << 32, (ROWS, COLUMNS, 3), dtype=np.uint32)
    return drawn.view(np.float32)


def light(kind: str) -> Image:
    """A picture of noise and even places, some of it negative and some above 1."""
    values = np.random.default_rng(6).random((ROWS, COLUMNS, 3), dtype=np.float32) * 3.0 - 0.5
    values[:, COLUMNS // 2 :] = np.round(values[:, COLUMNS // 2 :] * 4.0) / 4.0
    return values.astype(np.float16 if kind == "half" else np.float32)


def require_same(read: Image, expected: Image) -> None:
    assert read.dtype == expected.dtype
    assert read.shape == expected.shape
    assert read.tobytes() == expected.tobytes()


def said(read: Callable[[], object]) -> str:
    with pytest.raises(RoamError) as refused:
        read()
    return str(refused.value)


@pytest.mark.parametrize("kind", ["half", "float"])
@pytest.mark.parametrize("compression", [*LOSSLESS, *LOSSY])
def test_every_area_has_the_bits_that_openimageio_reads(tmp_path: Path, compression: str, kind: str) -> None:
    values = light(kind) if compression in LOSSY else every_value(kind)
    for window, order in itertools.product(WINDOWS, ("increasingY", "decreasingY")):
        fields = {"compression": compression, "openexr__lineOrder": order, **window}
        file = write_image(tmp_path / "p.exr", values, kind, **fields)
        whole, reader = read_image(file), Spy()
        for area in AREAS:
            expected = whole if area is None else area.of(whole)
            require_same(read_image(file, "", area, reader), expected)
        assert reader.given
        assert all(reader.given)
        assert size_in_areas(file, "", reader) == size_in_areas(file)


def test_values_that_are_no_numbers_are_read_as_they_are_stored(tmp_path: Path) -> None:
    values = every_value("half")
    assert np.isnan(values).any()
    file = write_image(tmp_path / "p.exr", values, "half", compression="zip")
    require_same(read_image(file, "", None, ScanlineReader()), values)


def test_layers_by_their_names(tmp_path: Path) -> None:
    names = ("R", "G", "B", "A", "diffuse.R", "diffuse.G", "diffuse.B", "spec light.B", "spec light.R", "spec light.G")
    values = light("half")
    channels = {name: np.ascontiguousarray(values[..., place % 3] * place) for place, name in enumerate(names)}
    file = tmp_path / "p.exr"
    OpenEXR.File(SCANLINES, channels).write(str(file))
    layers = read_header(file).layers
    assert len(layers) == 4
    for layer in layers:
        reader = Spy()
        require_same(read_image(file, layer, None, reader), read_image(file, layer))
        assert reader.given == [True]


def test_halves_beside_a_float_are_read_as_floats(tmp_path: Path) -> None:
    values = every_value("half")
    channels = {name: np.ascontiguousarray(values[..., place]) for place, name in enumerate("RGB")}
    channels["Z"] = np.ascontiguousarray(every_value("float")[..., 0])
    file = tmp_path / "p.exr"
    OpenEXR.File(SCANLINES, channels).write(str(file))
    for layer in read_header(file).layers:
        reader = Spy()
        read = read_image(file, layer, None, reader)
        assert read.dtype == np.float32
        require_same(read, read_image(file, layer))
        assert reader.given == [True]


def test_one_channel_is_given_thrice(tmp_path: Path) -> None:
    file = write_image(tmp_path / "p.exr", light("half")[..., :1], "half", channelnames=("Y",))
    reader = Spy()
    read = read_image(file, "", None, reader)
    require_same(read, np.repeat(light("half")[..., :1], 3, axis=2))
    assert reader.given == [True]


def test_tiles_are_left_to_openimageio(tmp_path: Path) -> None:
    file = write_image(tmp_path / "p.exr", light("float"), "float", tile_width=32, tile_height=32)
    reader = Spy()
    require_same(read_image(file, "", None, reader), light("float"))
    assert reader.given == []


def test_whole_numbers_are_left_to_openimageio(tmp_path: Path) -> None:
    numbers = {name: np.arange(ROWS * COLUMNS, dtype=np.uint32).reshape(ROWS, COLUMNS) for name in "RGB"}
    file, reader = tmp_path / "p.exr", Spy()
    OpenEXR.File(SCANLINES, numbers).write(str(file))
    require_same(read_image(file, "", None, reader), read_image(file))
    assert reader.given == []


def test_of_several_parts_the_first_is_given(tmp_path: Path) -> None:
    file = write_parts(
        tmp_path / "p.exr", [("beauty", "", ("R", "G", "B")), ("depth", "", ("Z",)), ("light", "", ("R", "G", "B"))]
    )
    given = {}
    for layer in read_header(file).layers:
        reader = Spy()
        require_same(read_image(file, layer, None, reader), read_image(file, layer))
        given[layer] = reader.given
    assert given == {"beauty": [True], "depth.Z": [], "light": []}


@pytest.mark.parametrize(
    "steps", [{"Y": 1, "RY": 2, "BY": 2}, {"R": 1, "G": 1, "B": 2}, {"R": 1, "G": 1, "B": 1, "Z": 2}]
)
def test_channels_with_fewer_pixels_are_refused_in_the_same_sentence(tmp_path: Path, steps: dict[str, int]) -> None:
    file = tmp_path / "p.exr"
    header, half = OpenEXR.Header(COLUMNS, ROWS), Imath.PixelType(Imath.PixelType.HALF)
    header["channels"] = {name: Imath.Channel(half, step, step) for name, step in steps.items()}
    output = OpenEXR.OutputFile(str(file), header)
    output.writePixels({name: light("half")[::step, ::step, 0].tobytes() for name, step in steps.items()})
    output.close()
    assert said(lambda: read_image(file, "", None, ScanlineReader())) == said(lambda: read_image(file))


@pytest.mark.parametrize("name", ["bé 日.exr", os.fsdecode(b"\xff\xfe.exr")])
def test_names_of_files_in_any_letters(tmp_path: Path, name: str) -> None:
    file = Path(os.fsdecode(os.fsencode(tmp_path) + b"/" + os.fsencode(name)))
    file.write_bytes(write_image(tmp_path / "p.exr", light("half"), "half").read_bytes())
    reader = Spy()
    require_same(read_image(file, "", None, reader), light("half"))
    assert reader.given == [True]


def test_a_channel_whose_name_is_no_text_is_left_to_openimageio(tmp_path: Path) -> None:
    file = write_image(tmp_path / "p.exr", light("half"), "half", channelnames=("x.R", "x.G", "x.B"))
    file.write_bytes(file.read_bytes().replace(b"x.R\0", b"\xff.R\0").replace(b"x.G\0", b"\xff.G\0"))
    for layer in read_header(file).layers:
        require_same(read_image(file, layer, None, ScanlineReader()), read_image(file, layer))


# ---- damaged files ---------------------------------------------------------------------------------------------------


def damaged(file: Path, how: str) -> Path:
    """Cut the file short, or have its middle be zeros."""
    content = bytearray(file.read_bytes())
    middle = len(content) // 2
    if how == "middle":
        content[middle - 3000 : middle + 3000] = bytes(6000)
    file.write_bytes(content if how == "middle" else content[: middle if how == "half" else 350])
    return file


@pytest.mark.parametrize("how", ["half", "head", "middle"])
@pytest.mark.parametrize("compression", [*LOSSLESS, *LOSSY])
def test_damage_is_told_as_openimageio_tells_it(tmp_path: Path, compression: str, how: str) -> None:
    file = damaged(write_image(tmp_path / "p.exr", light("half"), "half", compression=compression), how)
    assert outcome(lambda: read_image(file, "", None, ScanlineReader())) == outcome(lambda: read_image(file))


def outcome(read: Callable[[], Image]) -> str | bytes:
    """The bits of what is read, for there are compressions that make a picture of anything; else what is said."""
    try:
        return read().tobytes()
    except RoamError as error:
        return str(error)


@pytest.mark.parametrize("compression", ["zip", "dwab"])
def test_rows_before_the_damage_are_given(tmp_path: Path, compression: str) -> None:
    file = write_image(tmp_path / "p.exr", light("half"), "half", compression=compression)
    area = Area(0, 20, 30, 90)
    expected = area.of(read_image(file))
    content = file.read_bytes()
    file.write_bytes(content[: -len(content) // 8])
    reader = Spy()
    require_same(read_image(file, "", area, reader), expected)
    assert reader.given == [True]


def test_a_reader_that_lost_much_memory_reads_no_more(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = write_image(tmp_path / "whole.exr", light("half"), "half", compression="zip")
    torn = damaged(write_image(tmp_path / "p.exr", light("half"), "half", compression="zip"), "half")
    monkeypatch.setattr(scanlines, "MOST_LOST", 2 * scanlines.ROWS_AT_ONCE * COLUMNS * 3 * 2)
    reader = Spy()
    for _ in range(3):
        require_same(read_image(whole, "", None, reader), light("half"))
        said(lambda: read_image(torn, "", None, reader))
    require_same(read_image(whole, "", None, reader), light("half"))
    assert reader.given == [True, False] * 3 + [False]


# ---- where it is used ------------------------------------------------------------------------------------------------


def test_a_process_that_decodes_reads_scanlines_so(tmp_path: Path) -> None:
    file = write_image(tmp_path / "p.exr", light("half"), "half")
    worker, reader = Worker(io.BytesIO(), io.BytesIO()), Spy()
    worker._scanlines = reader
    worker._image(str(file), "", [3, 9, 2, 11])
    worker._size_in_areas(str(file), "")
    assert reader.given == [True, True]


def test_its_complaints_are_not_seen(
    tmp_path: Path, apart: Callable[[], None], capfd: pytest.CaptureFixture[str]
) -> None:
    torn = damaged(write_image(tmp_path / "a" / "p.1.exr", light("half"), "half", compression="zip"), "middle")
    plate = open_clip(torn)
    here = said(lambda: plate.read(1))
    apart()
    with pytest.raises(DamagedFrame) as refused:
        plate.read(1)
    assert str(refused.value) == here
    assert decoding.read_image(write_image(tmp_path / "w.exr", light("half"), "half")).shape == (ROWS, COLUMNS, 3)
    assert capfd.readouterr() == ("", "")
