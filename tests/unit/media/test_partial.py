"""Parts of pictures: bit by bit those of the whole, whatever the format, the layer and the colour space."""

from __future__ import annotations

import itertools
import os
from pathlib import Path
from typing import Any

import numpy as np
import OpenImageIO as oiio  # noqa: N813 - the name its own manual uses
import pytest

from roam_core import read_mask
from roam_core.arrays import Image
from roam_core.errors import RoamError
from roam_core.media import DamagedFrame, FrameCache, MissingFrame, open_clip
from roam_core.media.area import Area
from roam_core.media.colour import to_engine
from roam_core.media.curves import COLOUR_SPACES
from roam_core.media.image_file import read_image
from roam_core.media.partial import COLUMNS_AT_ONCE, LookedAt, PartialFrames, PartialPicture
from roam_core.media.source import PlateSource
from tests.unit.media.conftest import write_image, write_parts

HEIGHT, WIDTH = 150, 90
WIDE = 1200
"""Columns of pictures of which not all are read."""
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


def part_of(plate: PlateSource, frame: int, area: Area, space: str) -> PartialPicture:
    """A frame of which an area is decoded."""
    areas = plate.areas(frame)
    assert areas is not None
    return PartialPicture((plate.size[1], plate.size[0]), space, areas, (area.top, area.left), areas.read(area))


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
        for held in (Area(64, 96, 0, width), Area(0, 32, 0, width), Area(64, 96, 20, 50), Area(0, 32, 69, 70)):
            if held.columns < width and space not in COLOUR_SPACES:
                continue  # OpenColorIO is given whole strips
            picture = part_of(plate, 1001, held, space)
            part = picture.within(*box)
            assert part.dtype == whole.dtype
            np.testing.assert_array_equal(part, whole[box[0] : box[1], box[2] : box[3]])
            np.testing.assert_array_equal(picture.within(50, 60, 3, 9), whole[50:60, 3:9])


@pytest.mark.parametrize("name", FILES)
@pytest.mark.parametrize("area", [Area(0, 1, 0, 1), Area(31, 97, 20, 70), Area(64, 65, 69, 70), Area(90, 100, 3, 40)])
def test_an_area_is_read_as_it_is_in_the_whole(tmp_path: Path, name: str, area: Area) -> None:
    extension, depth, fields = FILES[name]
    write_image(tmp_path / f"p.1001.{extension}", noise(1, depth), depth, **fields)
    plate = open_clip(tmp_path)
    areas = plate.areas(1001)
    assert areas is not None
    read, whole = areas.read(area), plate.read(1001)
    assert read.dtype == whole.dtype
    assert read.base is None or read.base.nbytes == read.nbytes  # the rest is not kept
    np.testing.assert_array_equal(read, area.of(whole))


def test_the_areas_of_a_layer(tmp_path: Path) -> None:
    write_parts(tmp_path / "p.1.exr", [("depth", "", ("Z",)), ("beauty", "", ("R", "G", "B"))])
    plate = open_clip(tmp_path / "p.1.exr")
    areas = plate.areas(1)
    assert areas is not None
    np.testing.assert_array_equal(areas.read(Area(3, 7, 5, 9)), plate.read(1)[3:7, 5:9])


@pytest.mark.parametrize("extension", ["png", "jpg"])
def test_other_formats_are_read_whole(tmp_path: Path, extension: str) -> None:
    write_image(tmp_path / f"p.1.{extension}", (noise(2, "uint16") // 257).astype(np.uint8), "uint8")
    plate = open_clip(tmp_path)
    assert plate.areas(1) is None
    picture = PartialFrames(plate, unheard).read(1)
    np.testing.assert_array_equal(picture.whole, plate.read(1))


def test_rows_of_64_bit_values_are_those_of_the_whole(tmp_path: Path) -> None:
    values = noise(4, "double")
    file = write_image(tmp_path / "p.1.tif", values, "double", tiff__RowsPerStrip=8)
    plate, area = open_clip(tmp_path), Area(43, 71, 5, 40)
    np.testing.assert_array_equal(plate.read(1), values.astype(np.float32))
    np.testing.assert_array_equal(read_image(file, area=area), plate.read(1)[43:71, 5:40])
    np.testing.assert_array_equal(PartialFrames(plate, unheard).read(1).whole, to_engine(plate.read(1), "linear"))


def test_tiles_of_64_bit_values_are_refused_and_give_no_other_values(tmp_path: Path) -> None:
    file = write_image(tmp_path / "p.1.tif", noise(4, "double"), "double", tile_width=16, tile_height=16)
    told = r"p\.1\.tif has tiles of 64-bit values; save it with 32 bits\."
    with pytest.raises(RoamError, match=told):
        open_clip(file)
    with pytest.raises(RoamError, match=told):
        read_mask(file, (HEIGHT, WIDTH))


class Counting:
    """A plate that tells which areas are read of it."""

    def __init__(self, plate: PlateSource, colour_space: str = "") -> None:
        self._plate, self.reads = plate, list[Area]()
        self.readers, self.size, self.colour_space = 1, plate.size, colour_space or plate.colour_space

    def read(self, frame: int) -> Image:
        self.reads.append(Area(0, self.size[1], 0, self.size[0]))
        return self._plate.read(frame)

    def areas(self, frame: int) -> Counting | Any:
        counting, areas = self, self._plate.areas(frame)
        assert areas is not None

        class Counted:
            def read(self, area: Area) -> Image:
                counting.reads.append(area)
                return areas.read(area)

        return Counted()


def test_of_the_next_frame_those_rows_are_decoded_that_were_looked_at(tmp_path: Path) -> None:
    for frame in (1, 2, 3):
        write_image(tmp_path / f"p.{frame}.exr", noise(frame, "half"), "half", compression="zips")
    plate = Counting(open_clip(tmp_path))
    frames = PartialFrames(plate, unheard)  # type: ignore[arg-type]
    first = frames.read(1)
    first.within(70, 72, 0, 9)
    second = frames.read(2)
    assert plate.reads == [Area(0, HEIGHT, 0, WIDTH), Area(64, 96, 0, WIDTH)]
    second.within(70, 80, 0, 9)
    assert plate.reads[2:] == []
    second.within(20, 40, 0, 9)  # what is missing above is read, and no more
    assert plate.reads[2:] == [Area(0, 64, 0, WIDTH)]
    frames.read(3)  # the nearest frame tells
    frames.read(2)  # or the frame itself
    frames.read(1)
    assert plate.reads[3:] == [Area(0, 96, 0, WIDTH), Area(0, 96, 0, WIDTH), Area(64, 96, 0, WIDTH)]


def test_of_the_frames_that_a_long_gap_lacks_nothing_is_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for frame in (1, 200_000):
        write_image(tmp_path / f"p.{frame}.exr", noise(frame, "half"), "half", compression="zips")
    made: list[LookedAt] = []
    monkeypatch.setattr("roam_core.media.partial.LookedAt", lambda: made.append(LookedAt()) or made[-1])
    frames = PartialFrames(open_clip(tmp_path), unheard)
    frames.read(1).within(70, 72, 0, 9)
    for frame in range(2, 9):
        with pytest.raises(MissingFrame):
            frames.read(frame)
    assert len(made) == 1


@pytest.fixture
def wide(tmp_path: Path) -> Counting:
    """A plate of two frames, much wider than what is read of them."""
    for frame in (1, 2):
        write_image(tmp_path / f"p.{frame}.exr", wide_noise(frame), "half", compression="zip")
    return Counting(open_clip(tmp_path))


def wide_noise(seed: int) -> Image:
    return np.random.default_rng(seed).random((HEIGHT, WIDE, 3), dtype=np.float32) * 1.5 - 0.2


def second_of(plate: Counting, *box: int) -> PartialPicture:
    """The second frame, after a box was looked at of the first; what was read until then is forgotten."""
    frames = PartialFrames(plate, unheard)  # type: ignore[arg-type]
    frames.read(1).within(*box)
    second = frames.read(2)
    del plate.reads[:-1]
    return second


def test_columns_are_read_with_as_many_beside_as_an_object_may_move(wide: Counting) -> None:
    whole = to_engine(wide.read(2), wide.colour_space)
    second = second_of(wide, 70, 72, 400, 460)
    assert wide.reads == [Area(64, 96, 256, 640)]
    for moved in (-COLUMNS_AT_ONCE, 0, COLUMNS_AT_ONCE):
        np.testing.assert_array_equal(
            second.within(65, 90, 400 + moved, 460 + moved), whole[65:90, 400 + moved : 460 + moved]
        )
    assert wide.reads[1:] == []
    assert second.nbytes == 32 * 384 * 3 * 2


def test_rows_grow_by_those_that_are_missing_and_columns_by_all_of_the_rectangle(wide: Counting) -> None:
    whole = to_engine(wide.read(2), wide.colour_space)
    second = second_of(wide, 70, 72, 400, 460)
    del wide.reads[:]
    for box, read in (
        ((97, 99, 400, 460), Area(96, 128, 256, 640)),
        ((40, 41, 400, 460), Area(32, 64, 256, 640)),
        ((70, 71, 255, 300), Area(32, 128, 0, 640)),
        ((0, 1, 0, 1), Area(0, 32, 0, 640)),
        ((5, 6, 700, 701), Area(0, 128, 0, 896)),
        ((140, 150, WIDE - 1, WIDE), Area(0, 150, 0, WIDE)),
    ):
        np.testing.assert_array_equal(second.within(*box), whole[box[0] : box[1], box[2] : box[3]])
        assert wide.reads == [read]
        del wide.reads[:]
    np.testing.assert_array_equal(second.whole, whole)
    assert wide.reads == []


def test_an_object_that_moves_steadily_has_few_frames_read_twice(tmp_path: Path) -> None:
    file = write_image(tmp_path / "p.1.exr", wide_noise(1), "half", compression="zip")
    for frame in range(2, 12):
        os.link(file, tmp_path / f"p.{frame}.exr")
    plate = Counting(open_clip(tmp_path))
    whole = to_engine(plate.read(1), plate.colour_space)
    frames = PartialFrames(plate, unheard)  # type: ignore[arg-type]
    for frame in range(1, 12):
        left = 70 * frame
        np.testing.assert_array_equal(
            frames.read(frame).within(40, 90, left, left + 60), whole[40:90, left : left + 60]
        )
    assert len(plate.reads) == 1 + 11


def test_opencolorio_is_given_whole_strips(wide: Counting) -> None:
    wide.colour_space = "ACEScct"
    whole = to_engine(wide.read(2), "ACEScct")
    second = second_of(wide, 70, 72, 400, 460)
    assert wide.reads == [Area(64, 96, 0, WIDE)]
    np.testing.assert_array_equal(second.within(70, 90, 411, 450), whole[70:90, 411:450])


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
def test_a_file_that_is_cut_short_is_damaged_whichever_area_is_wanted(tmp_path: Path, share: float) -> None:
    for frame in (1, 2):
        write_image(tmp_path / f"p.{frame}.exr", noise(frame, "half"), "half", compression="zip")
    plate = open_clip(tmp_path)
    cut(tmp_path / "p.2.exr", share)
    with pytest.raises(DamagedFrame, match=r"p\.2\.exr"):
        plate.areas(2)


def test_damage_in_the_middle_shows_where_it_is_looked_at(tmp_path: Path) -> None:
    file = write_image(tmp_path / "p.1.exr", noise(1, "half"), "half", compression="zip")
    plate = open_clip(tmp_path)
    content = bytearray(file.read_bytes())
    middle = len(content) // 2
    content[middle - 2000 : middle + 2000] = bytes(4000)
    file.write_bytes(content)
    told: list[str] = []
    areas = plate.areas(1)
    assert areas is not None
    top = areas.read(Area(0, 16, 0, WIDTH))
    picture = PartialPicture(
        (HEIGHT, WIDTH), "linear", areas, (0, 0), top, failed=lambda error: told.append(str(error))
    )
    assert picture.within(0, 16, 0, WIDTH).shape == (16, WIDTH, 3)
    with pytest.raises(DamagedFrame, match=r"p\.1\.exr"):
        picture.within(0, HEIGHT, 0, WIDTH)
    assert len(told) == 1
    oiio.geterror()


def test_a_cache_holds_no_more_than_its_limit_of_parts_that_grow(tmp_path: Path) -> None:
    """What had grown was not counted, and what was taken away had not been added: the cache came to hold all."""
    file = write_image(tmp_path / "p.1.exr", wide_noise(1), "half", compression="zip")
    for frame in range(2, 41):
        os.link(file, tmp_path / f"p.{frame}.exr")
    cache = FrameCache(PartialFrames(open_clip(tmp_path), unheard), limit_bytes=3 * HEIGHT * WIDE * 6)
    counts = []
    for frame in range(1, 41):
        picture = cache.read(frame)
        held = [each for other in cache.cached_frames() if (each := cache.get(other)) is not None]
        assert cache.used_bytes == sum(each.nbytes for each in held) <= cache.limit_bytes
        counts.append(len(held))
        before, left = picture.nbytes, 37 * frame % 1100
        picture.within(0, HEIGHT, left, left + 60)
        assert cache.used_bytes == sum(each.nbytes for each in held), picture.nbytes - before
    assert max(counts) > 3, "parts take less room than the whole"
    cache.close()
    assert cache.used_bytes == 0
