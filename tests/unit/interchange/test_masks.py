"""Shapes fitted to sequences of masks: parts, points that stay the same ones, what comes and what goes."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import OpenEXR
import pytest

from roam_core.arrays import Bools, UInt8
from roam_core.errors import RoamError
from roam_core.interchange import ImportOptions, read_shapes
from roam_core.matte import render_matte
from roam_core.roto import Clip

CLIP = Clip(Path("plate"), 1001, 1003, (160, 120))


def discs(*centres: tuple[int, int]) -> UInt8:
    mask = np.zeros((120, 160), dtype=np.uint8)
    for centre in centres:
        cv2.circle(mask, centre, 22, 255, -1, cv2.LINE_AA)
    return mask


def write(folder: Path, *masks: UInt8, first: int = 1001) -> Path:
    folder.mkdir()
    for number, mask in enumerate(masks, start=first):
        cv2.imwrite(str(folder / f"mask.{number:04d}.png"), mask)
    return folder


def overlap(a: Bools, b: Bools) -> float:
    return np.count_nonzero(a & b) / np.count_nonzero(a | b)


@pytest.mark.parametrize("name", ["", "mask.1002.png", "mask.%04d.png", "mask.####.png"])
def test_a_moving_part_is_one_shape_with_the_keys_that_it_needs(tmp_path: Path, name: str) -> None:
    masks = [discs((60 + 3 * f, 50)) for f in range(3)]
    imported = read_shapes(write(tmp_path / "masks", *masks) / name, CLIP)
    (shape,) = imported.layer.shapes()
    assert (shape.frames, shape.artist_frames, len(imported.notes)) == ((1001, 1003), (1001, 1003), 1)
    for frame, mask in zip(range(1001, 1004), masks, strict=True):
        assert overlap(render_matte([shape], frame, (120, 160)) > 0.5, mask > 127) > 0.97


def test_a_part_that_comes_later_is_a_shape_of_its_own(tmp_path: Path) -> None:
    folder = write(tmp_path / "masks", discs(), discs((40, 60)), discs((40, 60), (115, 60)))
    first, second = read_shapes(folder, CLIP).layer.shapes()
    assert (first.frames, second.frames) == ((1002, 1003), (1003,))
    assert not second.exists_at(1002)


def test_masks_of_another_size_are_scaled_and_the_offset_is_taken_off(tmp_path: Path) -> None:
    folder = write(tmp_path / "masks", discs((60, 50)), first=1)
    imported = read_shapes(folder, Clip(Path("plate"), 1001, 1003, (320, 240)), ImportOptions(frame_offset=-1000))
    (shape,) = imported.layer.shapes()
    assert shape.frames == (1001,)
    np.testing.assert_allclose(shape.at(1001).flatten().mean(axis=0), [121, 101], atol=1.5)
    assert "scaled" in imported.notes[-1]


@pytest.mark.parametrize(("name", "frame"), [("mask.png", 1001), ("mask_v2.png", 1001), ("mask.1002.png", 1002)])
def test_one_mask_that_bears_no_number_of_the_clip_is_of_its_first_frame(tmp_path: Path, name: str, frame: int) -> None:
    cv2.imwrite(str(tmp_path / name), discs((60, 50)))
    imported = read_shapes(tmp_path / name, CLIP)
    (shape,) = imported.layer.shapes()
    assert shape.frames == (frame,)
    assert any("its key stands on the first, 1001" in note for note in imported.notes) == (frame == 1001)
    (shifted,) = read_shapes(tmp_path / name, CLIP, ImportOptions(frame_offset=-1)).layer.shapes()
    assert shifted.frames == ({"mask.png": 2, "mask_v2.png": 3, "mask.1002.png": 1003}[name],)


def test_ids_in_exr_files_are_masks_as_those_of_one_frame_are(tmp_path: Path) -> None:
    """Read as a plate's pictures, ids were shares of four thousand millions: black."""
    folder = tmp_path / "masks"
    folder.mkdir()
    for number in range(3):
        ids = np.zeros((120, 160), np.uint32)
        ids[discs((40 + 3 * number, 50)) > 127], ids[discs((115, 60)) > 127] = 7, 3
        header = {"type": OpenEXR.scanlineimage, "compression": OpenEXR.ZIP_COMPRESSION}
        OpenEXR.File(header, {"id": ids}).write(str(folder / f"id.{1001 + number}.exr"))
    shapes = list(read_shapes(folder, CLIP).layer.shapes())
    assert [shape.frames[0] for shape in shapes] == [1001, 1001]
    assert overlap(render_matte(shapes, 1003, (120, 160)) > 0.5, ids > 0) > 0.97


def test_pictures_in_place_of_masks_are_told(tmp_path: Path) -> None:
    grey = np.random.default_rng(5).integers(40, 210, (120, 160), np.uint8)
    folder = write(tmp_path / "plate", cv2.GaussianBlur(grey, (0, 0), 9) + 3, discs((60, 50)))
    told = "1 of the 2 masks are grey for the most part, neither black nor white; if they are pictures"
    assert any(note.startswith(told) for note in read_shapes(folder, CLIP).notes)


def test_photographs_in_place_of_masks_are_refused_before_hours_go_into_them(tmp_path: Path) -> None:
    noise = cv2.GaussianBlur(np.random.default_rng(5).integers(0, 255, (120, 160, 3), np.uint8), (0, 0), 2)
    colour = np.asarray(noise // (1, 2, 3) + (0, 20, 60), np.uint8)
    read: list[str] = []
    options = ImportOptions(progress=lambda _, text: read.append(text))
    with pytest.raises(RoamError, match="plate holds pictures in colour, no masks; give the masks of them"):
        read_shapes(write(tmp_path / "plate", colour, colour, colour), CLIP, options)
    assert read == ["Looking at the masks"]
    alpha = np.dstack([colour, discs((60, 50))])
    for name, masks in {"one": (colour, discs((60, 50))), "alpha": (alpha, alpha)}.items():
        assert list(read_shapes(write(tmp_path / name, *masks), CLIP).layer.shapes())


def test_soft_masks_are_no_pictures(tmp_path: Path) -> None:
    soft = cv2.GaussianBlur(discs((60, 50), (110, 60)), (0, 0), 12)
    assert not any("pictures" in note for note in read_shapes(write(tmp_path / "masks", soft), CLIP).notes)


def test_black_masks_are_one_sentence(tmp_path: Path) -> None:
    with pytest.raises(RoamError, match="Nothing is white"):
        read_shapes(write(tmp_path / "masks", discs()), CLIP)


def test_a_folder_without_pictures_is_one_sentence(tmp_path: Path) -> None:
    with pytest.raises(RoamError):
        read_shapes(tmp_path, CLIP)


def test_a_file_without_a_suffix_is_no_folder(tmp_path: Path) -> None:
    (tmp_path / "thing").write_text("x")
    with pytest.raises(RoamError, match="no suffix"):
        read_shapes(tmp_path / "thing", CLIP)


def test_the_parts_of_a_sequence_are_outlines_of_one_thing(tmp_path: Path) -> None:
    folder = write(tmp_path / "masks", discs((40, 60)), discs((40, 60), (115, 60)))
    shapes = list(read_shapes(folder, CLIP).layer.shapes())
    assert [shape.compound for shape in shapes] == ["compound-1", "compound-1"]
