"""The pictures that labels are of: the plate's own files, named where there are some, told where there are none."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from roam_core.interchange import EXPORTERS, ExportOptions, read_shapes
from roam_core.interchange.labels.coco import coco_document
from roam_core.roto import Clip
from tests.unit.interchange.test_labels import CLIP, car, project


def put_files(folder: Path, *names: str) -> Path:
    folder.mkdir()
    for name in names:
        (folder / name).touch()
    return folder


def images_of(clip: Clip, **options: Any) -> tuple[list[str], list[str]]:
    """The names of the images of a project on that clip, and the notes on it."""
    what = replace(project(car()), clip=clip)
    document, notes, losses = coco_document(what, ExportOptions(**options))
    assert losses == []
    numbers = [image["frame"] - options.get("frame_offset", 0) for image in document["images"]]
    assert numbers == sorted(set(numbers))
    return [image["file_name"] for image in document["images"]], notes


@pytest.mark.parametrize("name", ["plate.{}.png", "plate_{}_v002.JPG", "{}.exr", "a b {}.tif"])
def test_cocos_images_are_the_plates_own_files(tmp_path: Path, name: str) -> None:
    """Names were made up, which no loader finds: `shot.001001.png` for `plate.1001.png`."""
    names = [name.format(frame) for frame in CLIP.frame_range]
    folder = put_files(tmp_path / "shot", *names)
    pattern = replace(CLIP, path=folder / name.format("%04d"))
    for clip in (pattern, replace(CLIP, path=folder)) if "v002" not in name else (pattern,):
        found, notes = images_of(clip, frame_offset=7)
        assert found == names
        assert not any("made up" in note for note in notes)
    assert images_of(pattern, frames=range(1003, 1005))[0] == names[2:4]


def test_frames_without_a_picture_are_no_images_of_coco(tmp_path: Path) -> None:
    there = [frame for frame in CLIP.frame_range if frame not in (1004, 1005)]
    folder = put_files(tmp_path / "shot", *(f"plate.{frame}.png" for frame in there))
    found, notes = images_of(replace(CLIP, path=folder))
    assert found == [f"plate.{frame}.png" for frame in there]
    assert "Frames without a picture are left out of the images: 2, the first is 1004." in notes


@pytest.mark.parametrize("name", ["gone.%04d.exr", "gone", "shot.mov", "other", "animation"])
def test_made_up_names_of_cocos_images_are_told(tmp_path: Path, name: str) -> None:
    """Of a movie, a plate that is not at hand, other frames in its place, a picture that holds the whole clip."""
    (tmp_path / "shot.mov").touch()
    put_files(tmp_path / "other", "plate.0001.png", "plate.0002.png")
    put_files(tmp_path / "animation", "plate.gif")
    found, notes = images_of(replace(CLIP, path=tmp_path / name), frames=range(1002, 1003))
    stem = name.split(".")[0]
    assert found == [f"{stem}.001002.png"]
    assert f"{name} gives no picture files: the images' names are made up, as {stem}.001002.png." in notes


def test_a_lone_picture_is_named_as_it_is(tmp_path: Path) -> None:
    folder = put_files(tmp_path / "stills", "still.tif", "other.tif")
    clip = replace(CLIP, path=folder / "still.tif", first=1, last=1)
    assert images_of(clip)[0] == ["still.tif"]


@pytest.mark.parametrize("name", ["plate.{}.jp2", "plate_{}_v002.png", "take3/{}/beauty_01.exr", "plate.{}"])
def test_a_data_set_is_read_by_the_digits_that_count_its_images(tmp_path: Path, name: str) -> None:
    """The last digits of a name were taken, those of an extension or a version too: then the images' order."""
    document = {
        "images": [{"id": k, "file_name": name.format(1003 + 2 * k), "width": 320, "height": 240} for k in range(3)],
        "categories": [],
        "annotations": [
            {"id": k, "image_id": k, "category_id": 1, "segmentation": [[9, 9, 50, 9, 50, 50]]} for k in range(3)
        ],
    }
    path = tmp_path / "labels.json"
    path.write_text(json.dumps(document))
    made = read_shapes(path, CLIP)
    assert next(iter(made.layer.shapes())).frames == (1003, 1005, 1007)
    assert made.notes == ()


def test_missing_pictures_are_told_where_cvat_counts_none(tmp_path: Path) -> None:
    """It numbers the files that it is given: after a gap each shape lay on the picture before its own."""
    folder = put_files(tmp_path / "shot", *(f"plate.{frame}.png" for frame in CLIP.frame_range if frame != 1004))
    what = replace(project(car()), clip=replace(CLIP, path=folder))
    notes = EXPORTERS["cvat"].export(what, tmp_path / "p.xml")
    told = [note for note in notes if "without gaps" in note]
    assert ["shot lacks 1: fill them, or from frame 1004 on" in note for note in told] == [True]
    (folder / "plate.1004.png").touch()
    assert not any("without gaps" in note for note in EXPORTERS["cvat"].export(what, tmp_path / "p.xml"))
