"""What of a plate's files is not shown is told: pages of a TIFF, frames of an animated WebP."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import cv2
import numpy as np
import OpenImageIO as oiio  # noqa: N813 - the name its own manual uses
import pytest

from roam_core.interchange import read_shapes
from roam_core.media import decoding, open_clip
from roam_core.media.movie_plate import MoviePlate
from roam_core.media.unseen import unseen, unseen_of_mask
from roam_core.roto import Clip

TOLD = "pages.tif holds several pictures, of which the first is the plate: to have all, save them as numbered files."


def write_pages(path: Path, sizes: list[tuple[int, int]]) -> Path:
    """A TIFF of pages of these sizes (width, height)."""
    output = oiio.ImageOutput.create(str(path))
    specs = [oiio.ImageSpec(width, height, 3, "uint8") for width, height in sizes]
    assert output.open(str(path), specs)
    for page, spec in enumerate(specs):
        if page:
            assert output.open(str(path), spec, "AppendSubimage")
        assert output.write_image(np.full((spec.height, spec.width, 3), 40 * page, np.uint8))
    output.close()
    return path


@pytest.mark.parametrize("isolated", [False, True])
def test_pages_of_a_tiff_are_told(tmp_path: Path, isolated: bool, request: pytest.FixtureRequest) -> None:
    if isolated:
        request.addfinalizer(decoding.trust)
        decoding.isolate()
    write_pages(tmp_path / "pages.tif", [(32, 24)] * 3)
    assert unseen(open_clip(tmp_path)) == TOLD


def test_one_page_and_its_thumbnail_are_one_picture(tmp_path: Path) -> None:
    assert unseen(open_clip(write_pages(tmp_path / "a.tif", [(32, 24), (8, 6)]))) == ""
    assert unseen(open_clip(write_pages(tmp_path / "b.tif", [(32, 24)]))) == ""


def test_further_pages_of_a_mask_are_told_where_shapes_are_made_of_it(tmp_path: Path) -> None:
    mask = write_pages(tmp_path / "pages.tif", [(32, 24)] * 3)
    told = "pages.tif holds several pictures, of which the first is the mask: to have all, save them as numbered files."
    assert unseen_of_mask(mask) == told
    white = np.zeros((24, 32, 1), np.uint8)
    white[6:18, 8:24] = 255
    output, spec = oiio.ImageOutput.create(str(mask)), oiio.ImageSpec(32, 24, 1, "uint8")
    assert output.open(str(mask), [spec, spec])
    assert output.write_image(white)
    assert output.open(str(mask), spec, "AppendSubimage")
    assert output.write_image(255 - white)
    output.close()
    assert told in read_shapes(mask, Clip(tmp_path / "plate.png", 1, 1, (32, 24))).notes
    assert told not in read_shapes(write_one(tmp_path / "one.png", white), Clip(tmp_path / "p", 1, 1, (32, 24))).notes


def write_one(path: Path, picture: Any) -> Path:
    """A PNG of one picture."""
    cv2.imwrite(str(path), picture)
    return path


def test_an_animation_alone_in_its_folder_is_a_movie_there_too(tmp_path: Path) -> None:
    path = tmp_path / "turn.gif"
    output = oiio.ImageOutput.create(str(path))
    specs = [oiio.ImageSpec(32, 24, 3, "uint8")] * 3
    assert output.open(str(path), specs)
    for page in range(3):
        if page:
            assert output.open(str(path), specs[page], "AppendSubimage")
        assert output.write_image(np.full((24, 32, 3), 80 * page, np.uint8))
    output.close()
    plate = open_clip(tmp_path)
    assert isinstance(plate, MoviePlate)
    assert (plate.path, plate.frames) == (path, (1, 2, 3))
