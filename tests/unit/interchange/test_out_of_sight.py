"""Shapes that an engine closed to a point leave with no opacity there: no program may blur or label the point."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core.geometry.bezier import polygon_points
from roam_core.interchange import exporter_for, read_shapes, write_shapes
from roam_core.interchange.protocol import STANDARD, KeyChoice, readied
from roam_core.matte import render_matte
from roam_core.roto import BlendMode, Clip, Keyframe, Layer, Origin, Project, RotoShape

SQUARE = polygon_points([(40.0, 30.0), (80.0, 30.0), (80.0, 70.0), (40.0, 70.0)])
POINT = 60.0 + 1e-4 * (SQUARE - SQUARE.mean(axis=(0, 1)))
CLIP = Clip(Path("plate"), 1, 6, (120, 100))
GONE = (3, 4)


def shape(**changes: object) -> RotoShape:
    keys = [Keyframe(1, SQUARE)]
    keys += [Keyframe(k, POINT if k in GONE else SQUARE, origin=Origin.ENGINE, inputs="x") for k in range(2, 7)]
    return replace(RotoShape("a", "a", tuple(keys), feather=12.0), **changes)  # type: ignore[arg-type]


def opacities(told: RotoShape, **options: object) -> list[float]:
    project = Project(CLIP, Layer("root", "root", (told,)))
    (ours,) = readied(project, replace(STANDARD, **options)).shapes  # type: ignore[arg-type]
    return [ours.opacity_at(frame) for frame in range(1, 7)]


def test_it_has_no_opacity_while_it_is_out_of_sight() -> None:
    assert opacities(shape(opacity=0.5)) == [0.5, 0.5, 0.0, 0.0, 0.5, 0.5]


@pytest.mark.parametrize(
    "changes", [{"feather": 0.0}, {"invert": True}, {"blend": BlendMode.INTERSECT}], ids=["hard", "inverted", "cuts"]
)
def test_what_shows_nothing_or_more_than_nothing_keeps_its_opacity(changes: dict[str, object]) -> None:
    assert opacities(shape(**changes)) == [1.0] * 6


def test_a_hard_shape_whose_keys_are_smoothed_would_show_something_again() -> None:
    assert opacities(shape(feather=0.0), smoothing=1.0) == [1.0, 1.0, 0.0, 0.0, 1.0, 1.0]


def test_the_artists_keys_alone_say_nothing_of_who_is_out_of_sight() -> None:
    assert opacities(shape(), keys=KeyChoice.ARTIST) == [1.0] * 6


def test_a_picture_of_one_frame_shows_none_of_it(tmp_path: Path) -> None:
    project = Project(CLIP, Layer("root", "root", (shape(),)))
    for frame, is_seen in ((2, True), (3, False)):
        write_shapes(project, tmp_path / "a.svg", "svg", replace(STANDARD, frame=frame, lossy=True))
        (told,) = read_shapes(tmp_path / "a.svg", CLIP).layer.shapes()
        assert (told.opacity_at(1) > 0.0) is is_seen


@pytest.mark.parametrize("name", ["nuke", "fusion", "json"])
def test_it_comes_back_with_an_empty_matte_there(name: str, tmp_path: Path) -> None:
    path = tmp_path / f"shapes{exporter_for(name).suffix}"
    write_shapes(Project(CLIP, Layer("root", "root", (shape(),))), path, name)
    (told,) = read_shapes(path, CLIP).layer.shapes()
    assert [told.opacity_at(frame) for frame in range(1, 7)] == [1.0, 1.0, 0.0, 0.0, 1.0, 1.0]
    for frame in range(1, 7):
        assert bool(render_matte([told], frame, (100, 120)).any()) is (frame not in GONE)


@pytest.mark.parametrize("feather", [0.0, 3.0])
def test_mattes_whose_keys_are_smoothed_are_black_there(feather: float, tmp_path: Path) -> None:
    """Smoothing opened the point again."""
    project = Project(CLIP, Layer("root", "root", (shape(feather=feather),)))
    write_shapes(project, tmp_path, "mattes", replace(STANDARD, smoothing=3.0))
    pictures = [cv2.imread(str(path), cv2.IMREAD_UNCHANGED) for path in sorted(tmp_path.glob("*.png"))]
    assert [bool(np.any(picture)) for picture in pictures] == [frame not in GONE for frame in CLIP.frame_range]


@pytest.mark.parametrize("name", ["coco", "cvat"])
def test_a_hard_one_is_labelled_nowhere_there(name: str, tmp_path: Path) -> None:
    """The point was an annotation of no area."""
    path = tmp_path / f"labels{exporter_for(name).suffix}"
    write_shapes(Project(CLIP, Layer("root", "root", (shape(feather=0.0),))), path, name)
    if name == "coco":
        assert [row["image_id"] for row in json.loads(path.read_text())["annotations"]] == [1, 2, 5, 6]
    else:
        told = re.findall(r'<polygon frame="(\d+)" keyframe="1" outside="([01])"', path.read_text())
        outside = {int(frame) + CLIP.first: word for frame, word in told}
        assert [outside[frame] for frame in (2, 3, 5)] == ["0", "1", "0"]
    assert [told.lifetime for told in read_shapes(path, CLIP).layer.shapes()] == [(1, 3), (5, 7)]
