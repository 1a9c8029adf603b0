"""Parts of pictures: bit by bit those of the whole, whatever the format, the layer and the colour space."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

import numpy as np
import OpenImageIO as oiio  # noqa: N813 - the name its own manual uses
import pytest

from roam_core.arrays import Image
from roam_core.media import DamagedFrame, FrameCache, MissingFrame, open_clip
from roam_core.media.colour import to_engine
from roam_core.media.partial import PartialFrames, PartialPicture
from roam_core.media.source import PlateSource
from tests.unit.media.conftest import write_image, write_parts

HEIGHT, WIDTH = 150, 90
BOXES = ((0, 1, 0, 1), (40, 90, 10, 71), (33, 34, 0, WIDTH), (149, 150, 80, 90), (0, HEIGHT, 0, WIDTH))
FILES: dict[str, tuple[str, str, dict[str, Any]]] = {
    **{
        f"EXR {how}, tiles of {tile}": ("exr", "half", {"compression": how, "tile_width": tile, "tile_height": tile})
        for how, tile in itertools.product(("none", "zips", "zip", "piz", "dwab"), (0, 32))
    },
    "EXR float": ("exr", "float", {"compression": "zip"}),
    "EXR in a larger window": ("exr", "half", {"x": 7, "y": 20, "full_width": 120, "full_height": 200}),
    "EXR with overscan": (
        "exr", "half", {"x": -5, "y": -30, "full_x": 0, "full_y": 0, "full_width": 70, "full_height": 100},
    ),
    "EXR whose windows begin below": ("exr", "half", {"y": 60, "full_y": 50, "full_height": 160}),
    "DPX of 10 bits": ("dpx", "uint16", {"oiio__BitsPerSample": 10}),
    "TIFF in strips": ("tif", "uint16", {"compression": "zip"}),
    "TIFF in tiles": ("tif", "float", {"tile_width": 32, "tile_height": 16}),
}  # fmt: skip


def noise(seed: int, depth: str) -> Image:
    values = np.random.default_rng(seed).random((HEIGHT, WIDTH, 3), dtype=np.float32)
    return np.round(values * 65535).astype(np.uint16) if depth == "uint16" else values * 1.5 - 0.2


def unheard(frame: int, error: MissingFrame) -> None:
    raise AssertionError(f"{frame}: {error}")


def band_of(plate: PlateSource, frame: int, top: int, end: int, space: str) -> PartialPicture:
    """A frame of which the rows from `top` to before `end` are decoded."""
    rows = plate.rows(frame)
    assert rows is not None
    return PartialPicture((plate.size[1], plate.size[0]), space, rows, top, rows.read(top, end))


@pytest.mark.parametrize("name", FILES)
@pytest.mark.parametrize("space", ["as it is", "ACEScct"])
def test_a_part_is_that_part_of_the_whole(tmp_path: Path, name: str, space: str) -> None:
    extension, depth, fields = FILES[name]
    write_image(tmp_path / f"p.1001.{extension}", noise(1, depth), depth, **fields)
    plate = open_clip(tmp_path)
    space = plate.colour_space if space == "as it is" else space
    whole = to_engine(plate.read(1001), space)
    height, width = whole.shape[:2]
    for top, end, left, right in BOXES:
        box = min(top, height - 1), min(end, height), min(left, width - 1), min(right, width)
        for held in ((64, 96), (0, 32)):
            picture = band_of(plate, 1001, *held, space)
            part = picture.within(*box)
            assert part.dtype == whole.dtype
            np.testing.assert_array_equal(part, whole[box[0] : box[1], box[2] : box[3]])
            np.testing.assert_array_equal(picture.within(50, 60, 3, 9), whole[50:60, 3:9])


def test_the_rows_of_a_layer(tmp_path: Path) -> None:
    write_parts(tmp_path / "p.1.exr", [("depth", "", ("Z",)), ("beauty", "", ("R", "G", "B"))])
    plate = open_clip(tmp_path / "p.1.exr")
    rows = plate.rows(1)
    assert rows is not None
    np.testing.assert_array_equal(rows.read(3, 7), plate.read(1)[3:7])


@pytest.mark.parametrize("extension", ["png", "jpg"])
def test_other_formats_are_read_whole(tmp_path: Path, extension: str) -> None:
    write_image(tmp_path / f"p.1.{extension}", (noise(2, "uint16") // 257).astype(np.uint8), "uint8")
    plate = open_clip(tmp_path)
    assert plate.rows(1) is None
    picture = PartialFrames(plate, unheard).read(1)
    np.testing.assert_array_equal(picture.whole, plate.read(1))


class Counting:
    """A plate that tells which rows are read of it."""

    def __init__(self, plate: PlateSource) -> None:
        self._plate, self.reads = plate, list[tuple[int, int]]()
        self.readers, self.size, self.colour_space = 1, plate.size, plate.colour_space

    def read(self, frame: int) -> Image:
        self.reads.append((0, self.size[1]))
        return self._plate.read(frame)

    def rows(self, frame: int) -> Counting | Any:
        counting, rows = self, self._plate.rows(frame)
        assert rows is not None

        class Counted:
            def read(self, top: int, end: int) -> Image:
                counting.reads.append((top, end))
                return rows.read(top, end)

        return Counted()


def test_of_the_next_frame_those_rows_are_decoded_that_were_looked_at(tmp_path: Path) -> None:
    for frame in (1, 2, 3):
        write_image(tmp_path / f"p.{frame}.exr", noise(frame, "half"), "half", compression="zips")
    plate = Counting(open_clip(tmp_path))
    frames = PartialFrames(plate, unheard)  # type: ignore[arg-type]
    first = frames.read(1)
    first.within(70, 72, 0, 9)
    second = frames.read(2)
    assert plate.reads == [(0, HEIGHT), (64, 96)]
    second.within(70, 80, 0, 9)
    assert plate.reads[2:] == []
    second.within(20, 40, 0, 9)  # what is missing above is read, and no more
    assert plate.reads[2:] == [(0, 64)]
    frames.read(3)  # the nearest frame tells
    frames.read(2)  # or the frame itself
    frames.read(1)
    assert plate.reads[3:] == [(0, 96), (0, 96), (64, 96)]


def test_a_cache_counts_what_is_decoded(tmp_path: Path) -> None:
    write_image(tmp_path / "p.1.exr", noise(3, "half"), "half")
    plate = open_clip(tmp_path)
    cache = FrameCache(PartialFrames(plate, unheard))
    assert cache.read(1).nbytes == cache.used_bytes == HEIGHT * WIDTH * 3 * 2
    cache.close()


def cut(file: Path, share: float) -> None:
    content = file.read_bytes()
    file.write_bytes(content[: int(share * len(content))])


@pytest.mark.parametrize("share", [0.5, 0.97])
def test_a_file_that_is_cut_short_is_damaged_whichever_rows_are_wanted(tmp_path: Path, share: float) -> None:
    for frame in (1, 2):
        write_image(tmp_path / f"p.{frame}.exr", noise(frame, "half"), "half", compression="zip")
    plate = open_clip(tmp_path)
    cut(tmp_path / "p.2.exr", share)
    with pytest.raises(DamagedFrame, match=r"p\.2\.exr"):
        plate.rows(2)


def test_damage_in_the_middle_shows_where_it_is_looked_at(tmp_path: Path) -> None:
    file = write_image(tmp_path / "p.1.exr", noise(1, "half"), "half", compression="zip")
    plate = open_clip(tmp_path)
    content = bytearray(file.read_bytes())
    middle = len(content) // 2
    content[middle - 2000 : middle + 2000] = bytes(4000)
    file.write_bytes(content)
    told: list[str] = []
    rows = plate.rows(1)
    assert rows is not None
    top = rows.read(0, 16)
    picture = PartialPicture((HEIGHT, WIDTH), "linear", rows, 0, top, failed=lambda error: told.append(str(error)))
    assert picture.within(0, 16, 0, WIDTH).shape == (16, WIDTH, 3)
    with pytest.raises(DamagedFrame, match=r"p\.1\.exr"):
        picture.within(0, HEIGHT, 0, WIDTH)
    assert len(told) == 1
    oiio.geterror()
