"""A run that begins on nothing is told: plates beyond white, shots that fade in."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core.arrays import Image
from roam_core.cli.plain_start import plain_start
from roam_core.roto import Keyframe, RotoShape
from tests.unit.cli.conftest import Plate, Roam

CORNERS = np.array([[20.0, 20.0], [40.0, 20.0], [40.0, 40.0], [20.0, 40.0]])
SHAPE = RotoShape("a", "A", (Keyframe(7, np.repeat(CORNERS[:, None], 3, axis=1)),))


def filled(value: float) -> Image:
    return np.full((60, 80, 3), value, np.float32)


@pytest.mark.parametrize(("value", "tone"), [(1.0, "white"), (0.0, "black"), (0.5, "of one tone")])
@pytest.mark.parametrize("kind", [np.float32, np.uint8])
def test_one_tone_is_told(value: float, tone: str, kind: type) -> None:
    picture = filled(value) if kind is np.float32 else np.rint(filled(value) * 255.0).astype(np.uint8)
    assert plain_start(picture, [SHAPE], 7).startswith(f"Frame 7 is {tone} in and around the shapes")


def test_dust_shows_nothing_and_what_lies_elsewhere_does_not_count() -> None:
    picture = filled(0.0)
    picture[30, 30] = 1.0
    picture[:, 60:] = 1.0
    assert "black" in plain_start(picture, [SHAPE], 7)


def test_an_object_or_an_edge_beside_it_is_something() -> None:
    for rows in (slice(20, 40), slice(42, 46)):
        picture = filled(0.0)
        picture[rows, 20:40] = 0.1
        assert plain_start(picture, [SHAPE], 7) == ""


def test_one_shape_that_lies_on_something_is_enough() -> None:
    picture = filled(0.0)
    picture[:, 60:] = np.random.default_rng(3).random((60, 20, 3))
    aside = RotoShape("b", "B", (Keyframe(7, SHAPE.keys[0].points + np.array([40.0, 0.0])),))
    assert plain_start(picture, [SHAPE], 7) != ""
    assert plain_start(picture, [SHAPE, aside], 7) == ""


@pytest.mark.parametrize("shift", [1000.0, -1000.0, 1e9, np.nan])
def test_shapes_beyond_the_picture_tell_nothing_of_it(shift: float) -> None:
    away = RotoShape("c", "C", (Keyframe(7, SHAPE.keys[0].points + shift),))
    assert plain_start(filled(0.0), [away], 7) == plain_start(filled(0.0), [], 7) == ""


def test_a_float_plate_in_255_levels_is_told_before_it_is_tracked(roam: Roam, plate: Plate, tmp_path: Path) -> None:
    folder = tmp_path / "floats"
    folder.mkdir()
    for file in sorted(plate.folder.iterdir())[:2]:
        levels = np.maximum(cv2.imread(str(file)).astype(np.float32), 2.0)
        assert cv2.imwrite(str(folder / f"{file.stem}.tif"), levels)
    done = roam("track", folder, "--init", plate.mask, "--config", "baseline")
    assert "is white in and around the shapes" in done.err
    assert "--colour" in done.err
    assert "in and around" not in roam("track", plate.folder, "--init", plate.mask, "--end", 1001).err
