"""Plate names: what files that are written of a plate are called after it."""

from __future__ import annotations

from pathlib import Path

import pytest

from app.files.plate_names import file_stem
from app.folders import cache_folder
from resources import demo
from roam_core.roto import Clip


@pytest.mark.parametrize(
    ("path", "stem"),
    [
        ("plates/hero_v002.####.exr", "hero_v002"),
        ("plates/hero_v002.%04d.exr", "hero_v002"),
        ("plates/hero_v002_[1001-1048].exr", "hero_v002"),
        ("plates/$F4.exr", "plates"),
        ("plates/take#2.mov", "take#2"),
        ("plates/still.png", "still"),
    ],
)
def test_the_place_of_the_frame_number_is_left_out(path: str, stem: str) -> None:
    assert file_stem(Clip(Path(path), 1001, 1048, (64, 48))) == stem


@pytest.mark.parametrize("name", ["plate", "plate.v002", "plate#2"])
def test_a_folder_keeps_its_whole_name(tmp_path: Path, name: str) -> None:
    (tmp_path / name).mkdir()
    assert file_stem(Clip(tmp_path / name, 1001, 1048, (64, 48))) == name


def test_the_demos_files_bear_no_hash() -> None:
    folder = cache_folder() / demo.cache_name()
    folder.mkdir(parents=True, exist_ok=True)
    assert file_stem(Clip(folder, 1001, 1048, (960, 540))) == "demo"
