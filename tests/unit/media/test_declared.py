"""Declared plates: the files' values under another name, everywhere where a project's plate is opened."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roam_core.cli.plate import opened
from roam_core.media import declared, open_clip
from roam_core.media.colour import to_engine
from roam_core.roto import Clip
from tests.unit.media.conftest import write_image


@pytest.fixture
def plate_path(tmp_path: Path) -> Path:
    for number in (1, 2, 4):
        write_image(tmp_path / f"p.{number:04d}.png", np.full((4, 6, 3), 40 * number, np.uint8), "uint8")
    return tmp_path


def test_what_the_files_say_anyway_needs_no_declaration(plate_path: Path) -> None:
    source = open_clip(plate_path)
    assert declared(source, source.colour_space, source.fps, source.pixel_aspect) is source


def test_values_and_frames_are_the_files_own(plate_path: Path) -> None:
    source = open_clip(plate_path)
    plate = declared(source, "linear", 30.0, 2.0)
    assert (plate.colour_space, plate.fps, plate.pixel_aspect) == ("linear", 30.0, 2.0)
    assert (plate.path, plate.frames, plate.missing, plate.size) == (source.path, (1, 2, 4), (3,), (6, 4))
    assert (plate.depth, plate.frame_name(2)) == (source.depth, source.frame_name(2))
    np.testing.assert_array_equal(plate.read(2), source.read(2))


def test_a_command_sees_the_projects_plate_as_the_project_declares_it(plate_path: Path) -> None:
    clip = replace(Clip.of(open_clip(plate_path)), colour_space="linear")
    with opened(str(plate_path), clip) as plate:
        np.testing.assert_array_equal(plate.read(2), to_engine(open_clip(plate_path).read(2), "linear"))
    with opened(str(plate_path), replace(clip, path=Path("/elsewhere"))) as plate:
        assert plate.source.colour_space == "sRGB"


@pytest.mark.parametrize(
    ("name", "kind", "depth"),
    [
        ("p.png", "uint8", "8 bits"),
        ("p.tif", "uint16", "16 bits"),
        ("p.exr", "half", "half float"),
        ("p.exr", "float", "float"),
    ],
)
def test_the_depth_is_told_in_words(tmp_path: Path, name: str, kind: str, depth: str) -> None:
    pixels = np.zeros((4, 6, 3), np.dtype({"half": "float16"}.get(kind, kind)))
    file = write_image(tmp_path / name, pixels.astype(np.float32) if kind in ("half", "float") else pixels, kind)
    assert open_clip(file).depth == depth
