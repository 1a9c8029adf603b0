"""`roam plane`: the surface under shapes is followed into a layer, told frame by frame, and what it refuses."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core.geometry import projective
from roam_core.geometry.bezier import polygon_points
from roam_core.geometry.plane_motion import PlaneMotion
from roam_core.media import open_clip
from roam_core.roto import Clip, Keyframe, Layer, Project, RotoShape, file
from roam_core.roto.following import moving_layer
from tests.unit.cli.conftest import Roam
from tests.unit.cli.test_bad_input import require_refusal
from tests.unit.motion import test_plane_track as board
from tests.unit.motion.plane_scene import Scene

SCENE = Scene(crossing=(-6, 10), covers=0.8)
COUNT = 6
"""Frames 1-6 of the plate are frames 0-5 of the scene, while something crosses the plane."""


@pytest.fixture(scope="module")
def plate(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("plane") / "plate"
    folder.mkdir()
    for frame in range(COUNT):
        assert cv2.imwrite(str(folder / f"plate.{frame + 1:04d}.png"), SCENE.picture(frame))
    return folder


@pytest.fixture
def project(plate: Path, tmp_path: Path) -> Path:
    """A screen on the plane, a hand that passes before it, keyed on every frame, and one more that does not."""
    screen = RotoShape("screen", "Screen", (Keyframe(1, SCENE.outline(0)),))
    keys = tuple(Keyframe(frame + 1, polygon_points(SCENE.occluder(frame))) for frame in range(COUNT))
    other = RotoShape("other", "Other", (Keyframe(1, polygon_points(np.array([(1.0, 1.0), (9.0, 1.0), (9.0, 9.0)]))),))
    shapes = screen, RotoShape("hand", "Hand", keys), other
    path = tmp_path / "p.roam"
    file.save(Project(Clip.of(open_clip(plate)), Layer("root", "Root", shapes)), path)
    return path


def corner_errors(path: Path) -> np.ndarray:
    """How far the screen's corners are from where they are, by frame."""
    found = file.load(path)
    placed = [found.shape("screen").at(frame + 1).anchors for frame in range(COUNT)]
    layer = moving_layer(found, ["screen"])
    assert layer is not None
    true = [SCENE.outline(frame)[:, 0] for frame in range(COUNT)]
    return np.hypot(*np.moveaxis(np.array(placed) - np.array(true), 2, 0)).mean(axis=1)


def test_a_surface_is_followed_and_what_covers_it_is_left_out_by_name(roam: Roam, project: Path) -> None:
    done = roam("plane", project, "--shape", "Screen", "--exclude", "Hand", "--motion", "homography")
    assert (done.status, done.out) == (0, "")
    assert done.err == "" or done.err.startswith("Followed the plane from frame 1 to 6. ")
    assert corner_errors(project).max() < 0.5
    found = file.load(project)
    assert [shape.id for shape in found.shapes] == ["screen", "hand", "other"]
    assert found.shape("screen").artist_frames == (1,)


def test_what_turns_on_wide_pixels_needs_no_shear(roam: Roam, tmp_path: Path) -> None:
    kind, plate, path = PlaneMotion.SIMILARITY, tmp_path / "plate", tmp_path / "wide.roam"
    plate.mkdir()
    for frame in range(board.COUNT):
        assert cv2.imwrite(str(plate / f"plate.{frame + 1:04d}.png"), board.squeezed(kind, frame))
    clip = replace(Clip.of(open_clip(plate)), pixel_aspect=2.0)
    shape = RotoShape("board", "Board", (Keyframe(1, board.NARROW),))
    file.save(Project(clip, Layer("root", "Root", (shape,))), path)
    assert roam("plane", path, "--motion", "similarity").status == 0
    corners = file.load(path).shape("board").at(board.COUNT).anchors
    assert np.abs(corners - board.squeezed_corners(kind, board.COUNT - 1)).max() < 0.5


@pytest.mark.parametrize("gone", [[3], [2, 3], [6]])
def test_frames_that_the_plate_lacks_have_a_line_too(
    roam: Roam, project: Path, plate: Path, tmp_path: Path, gone: list[int]
) -> None:
    for path in sorted(plate.iterdir()):
        if int(path.stem.split(".")[1]) not in gone:
            (tmp_path / "gaps").mkdir(exist_ok=True)
            (tmp_path / "gaps" / path.name).write_bytes(path.read_bytes())
    held = file.load(project)
    assert held.clip is not None
    file.save(replace(held, clip=replace(held.clip, path=tmp_path / "gaps")), project)
    end = min(max(5, *gone), 6 - (6 in gone))
    done = roam("plane", project, "--shape", "screen", "--exclude", "Hand", "--end", end, "--json")
    assert done.status == 0, done.err
    lines = {line["frame"]: line for line in map(json.loads, done.out.splitlines())}
    assert list(lines) == list(range(2, end + 1))
    assert [frame for frame, line in lines.items() if line["matrix"] is None] == [each for each in gone if each <= end]


def test_every_frame_is_told_in_json(roam: Roam, project: Path, tmp_path: Path) -> None:
    before, target = project.read_bytes(), tmp_path / "tracked.roam"
    words = "--shape", "screen", "--leave-out", "others", "--motion", "homography", "--save", target, "--json"
    done = roam("plane", project, *words)
    lines = [json.loads(line) for line in done.out.splitlines()]
    assert done.status == 0
    assert [line["frame"] for line in lines] == [2, 3, 4, 5, 6]
    assert all(0.0 < line["confidence"] <= 1.0 and line["seconds"] > 0.0 and line["error"] > 0.0 for line in lines)
    told = projective.apply(np.array(lines[-1]["matrix"]), SCENE.outline(0)[:, 0])
    np.testing.assert_allclose(told, SCENE.outline(5)[:, 0], atol=0.5)
    assert project.read_bytes() == before
    assert corner_errors(target).max() < 0.5


def test_backward_and_a_part(roam: Roam, project: Path) -> None:
    found = file.load(project)
    late = replace(found.shape("screen"), keys=(Keyframe(COUNT, SCENE.outline(COUNT - 1)),))
    file.save(found.with_shape(late), project)
    words = "--shape", "Screen", "--exclude", "Hand", "--motion", "homography", "--backward", "--end", 3, "--json"
    done = roam("plane", project, *words)
    assert [json.loads(line)["frame"] for line in done.out.splitlines()] == [5, 4, 3]
    assert corner_errors(project)[2:].max() < 0.5


def test_what_is_excluded_is_not_looked_at(roam: Roam, project: Path, tmp_path: Path) -> None:
    """The matrices differ where the named shape covers the surface, and only because it is named."""
    told = []
    for number, words in enumerate((("--exclude", "Other"), ("--leave-out", "nothing"), ("--exclude", "Hand"))):
        target = tmp_path / f"{number}.roam"
        done = roam("plane", project, "--shape", "Screen", *words, "--save", target, "--json")
        told.append([json.loads(line)["matrix"] for line in done.out.splitlines()])
    assert told[0] == told[1]
    assert told[0] != told[2]


@pytest.mark.parametrize(
    "words",
    [
        ("--shape", "Nobody"),
        ("--exclude", "Nobody"),
        ("--shape", "Screen", "--exclude", "Screen"),
        ("--shape", "Screen", "--exclude", "Hand", "--leave-out", "above"),
        ("--shape", "Screen", "--start", "6"),
        ("--shape", "Screen", "--end", "77"),
        ("--exclude", "Screen", "--exclude", "Hand", "--exclude", "Other"),
    ],
)
def test_what_cannot_be_done_is_refused(roam: Roam, project: Path, words: tuple[str, ...]) -> None:
    before = project.read_bytes()
    require_refusal(roam("plane", project, *words))
    assert project.read_bytes() == before
