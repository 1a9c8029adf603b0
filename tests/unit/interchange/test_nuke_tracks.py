"""Tracker4 and CornerPin2D nodes, taken apart by Tcl: positions, order of the corners, inert names."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.geometry.bezier import polygon_points
from roam_core.interchange import EXPORTERS, ExportOptions
from roam_core.interchange.nuke.tracks import COLUMNS, Track, box_motion, layer_motion, tracker_node
from roam_core.roto import Keyframe, Layer, LayerTransform, Origin, Project, RotoShape
from tests.unit.interchange import tcl
from tests.unit.interchange.conftest import CLIP

BOX = np.array([[100.0, 200.0], [300.0, 200.0], [300.0, 500.0], [100.0, 500.0]])


def moved(frame: int) -> Array:
    """The box turned by 2 degrees a frame about (10, 20), grown by 1 % a frame, and moved."""
    angle, scale = np.radians(2.0 * frame), 1.01**frame
    turn = scale * np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    return np.asarray((BOX - [10, 20]) @ turn.T + [10, 20] + [3.0 * frame, -frame])


def shape(name: str = "Box", frames: int = 12, artist: int = 0) -> RotoShape:
    keys = (
        Keyframe(1001 + f, polygon_points(moved(f)), origin=Origin.ARTIST if f == artist else Origin.ENGINE)
        for f in range(frames)
    )
    return RotoShape("shape-1", name, tuple(keys))


def knobs_of(body: str) -> dict[str, str]:
    words = tcl.available().split(body)
    return dict(zip(words[::2], words[1::2], strict=True))


def keys_of(curve: str) -> dict[int, float]:
    """Frame and value of each key of a knob's curve."""
    word, *rest = tcl.available().split(curve)
    assert word == "curve"
    assert set(rest[::3]) == {"L"}
    return {int(time[1:]): float(value) for time, value in zip(rest[1::3], rest[2::3], strict=True)}


def exported(folder: Path, *shapes: RotoShape, options: ExportOptions | None = None) -> list[str]:
    """Class and body of each node in turn."""
    path = folder / "tracks.nk"
    project = Project(CLIP, Layer("root", "Root", shapes))
    notes = EXPORTERS["nuke-tracks"].export(project, path, options or ExportOptions())
    assert notes == ()
    words = tcl.available().split(path.read_text(encoding="utf-8").removeprefix("# Written by ROAM\n"))
    assert words[:3] == ["version", "9.0", "v1"]
    return words[3:]


def test_the_pin_carries_the_box_of_the_reference(tmp_path: Path) -> None:
    species, body = exported(tmp_path, shape())[2:]
    assert species == "CornerPin2D"
    knobs = knobs_of(body)
    order = [3, 2, 1, 0]  # bottom left, bottom right, top right, top left of what is listed clockwise from the top left
    for number, corner in enumerate(order, start=1):
        x, y = (float(word) for word in tcl.available().split(knobs[f"from{number}"]))
        np.testing.assert_allclose([x, 1080 - y], BOX[corner], atol=1e-5)
        across, up = (keys_of(curve) for curve in tcl.available().split(knobs[f"to{number}"]))
        assert list(across) == list(up) == list(range(1001, 1013))
        for frame in (1001, 1006, 1012):
            np.testing.assert_allclose([across[frame], 1080 - up[frame]], moved(frame - 1001)[corner], atol=1e-5)


def test_the_tracker_has_a_row_of_31_entries_for_each_corner(tmp_path: Path) -> None:
    species, body = exported(tmp_path, shape(), options=ExportOptions(frame_offset=-1000))[:2]
    assert (species, len(COLUMNS)) == ("Tracker4", 31)
    interpreter, knobs = tcl.available(), knobs_of(body)
    head, columns, rows = interpreter.split(knobs["tracks"])
    assert interpreter.split(head) == ["1", "31", "4"]
    assert len(interpreter.split(columns)) == 31
    table = [interpreter.split(row) for row in interpreter.split(rows)]
    assert [len(row) for row in table] == [31] * 4
    assert [row[1] for row in table] == [
        f"Box {side}" for side in ("bottom left", "bottom right", "top right", "top left")
    ]
    x, y = keys_of(table[0][2]), keys_of(table[0][3])
    np.testing.assert_allclose([x[6], 1080 - y[6]], moved(5)[3], atol=1e-5)
    assert knobs["reference_frame"] == "1"


def test_the_reference_is_the_first_key_of_the_artist(tmp_path: Path) -> None:
    words = exported(tmp_path, shape(artist=5))
    assert knobs_of(words[1])["reference_frame"] == "1006"
    x, y = (float(word) for word in tcl.available().split(knobs_of(words[3])["from4"]))
    left, top = moved(5).min(axis=0)
    np.testing.assert_allclose([x, 1080 - y], [left, top], atol=1e-5)


def test_a_shape_that_bends_gives_its_best_similarity() -> None:
    bent = shape()
    corners, frames = box_motion(bent)
    assert corners.shape == (12, 4, 2)
    assert frames == list(range(1001, 1013))
    sides = np.hypot(*(corners[:, 1] - corners[:, 0]).T)
    np.testing.assert_allclose(sides[1:] / sides[:-1], 1.01, rtol=1e-9)


@pytest.mark.parametrize("name", ["[exit]", "{", "}", 'a"b', "$x", "a\\", "\n", "[python {1}]", "\N{HAIRCUT}"])
def test_names_are_inert(tmp_path: Path, name: str) -> None:
    words = exported(tmp_path, shape(name))
    assert [words[0], words[2]] == ["Tracker4", "CornerPin2D"]
    interpreter = tcl.available()
    rows = interpreter.split(interpreter.split(knobs_of(words[1])["tracks"])[2])
    assert interpreter.split(rows[3])[1] == f"{name} top left"
    label = knobs_of(words[3])["label"]  # Nuke runs what stands in the brackets of a label
    assert label == name.replace("[", "(").replace("]", ")")


def test_a_shape_that_does_not_move_is_named(tmp_path: Path) -> None:
    still = RotoShape("shape-1", "Still", (Keyframe(1001, polygon_points(BOX)),))
    notes = EXPORTERS["nuke-tracks"].export(Project(CLIP, Layer("root", "Root", (still,))), tmp_path / "a.nk")
    assert notes == ("'Still' has one key and no motion; it is left out.",)


def test_tracks_may_have_gaps_and_must_have_points() -> None:
    node = tracker_node([Track("P", [1, 5], np.array([[1.0, 2.0], [3.0, 4.0]]))], CLIP, 1)
    assert "{curve L x1 1.000000 L x5 3.000000}" in node
    with pytest.raises(RoamError, match="no track"):
        tracker_node([], CLIP, 1)
    with pytest.raises(RoamError, match="no image is"):
        Track("P", [1], np.array([[np.nan, 0.0]]))
    with pytest.raises(ValueError, match="do not rise"):
        Track("P", [1, 1], np.zeros((2, 2)))
    with pytest.raises(ValueError, match="positions"):
        Track("P", [1, 2], np.zeros((1, 2)))


def test_a_moving_layer_is_a_planar_track(tmp_path: Path) -> None:
    """Its pin is the layer's homography: Nuke solves it from the four corners, and so does OpenCV here."""
    tilt = np.array([[1.05, 0.02, 30.0], [-0.03, 0.98, -12.0], [1e-5, 2e-5, 1.0]])
    still = RotoShape("shape-1", "Still", (Keyframe(1001, polygon_points(BOX)),))
    motion = LayerTransform.of({1001: np.eye(3), 1005: np.eye(3), 1011: tilt})
    inner = Layer("layer-1", "Plane [x]", (still,), transform=motion)
    push = np.array([[1.0, 0.0, 7.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    outer = Layer("layer-2", "Outer", (inner,), transform=LayerTransform.of({1001: push}))
    path = tmp_path / "tracks.nk"
    assert EXPORTERS["nuke-tracks"].export(Project(CLIP, Layer("root", "Root", (outer,))), path) == ()
    words = tcl.available().split(path.read_text(encoding="utf-8").removeprefix("# Written by ROAM\n"))[3:]
    assert words[::2] == ["Tracker4", "CornerPin2D"] * 2  # of the layer, and of the shape that it carries
    rows = tcl.available().split(tcl.available().split(knobs_of(words[1])["tracks"])[2])
    assert tcl.available().split(rows[0])[1] == "Plane [x] bottom left"
    assert knobs_of(words[1])["reference_frame"] == "1001"
    pin = knobs_of(words[3])
    assert pin["label"] == "Plane (x)"
    split = tcl.available().split
    source = [[float(word) for word in split(pin[f"from{k}"])] for k in (1, 2, 3, 4)]
    curves = [[keys_of(curve) for curve in split(pin[f"to{k}"])] for k in (1, 2, 3, 4)]
    assert list(curves[0][0]) == list(range(1001, 1012))
    up = np.array([[1.0, 0.0, 0.0], [0.0, -1.0, 1080.0], [0.0, 0.0, 1.0]])
    for frame in (1001, 1008, 1011):
        target = [[across[frame], along[frame]] for across, along in curves]
        solved = up @ cv2.getPerspectiveTransform(np.float32(source), np.float32(target)) @ up
        expected = push @ motion.at(frame)
        np.testing.assert_allclose(solved / solved[2, 2], expected, atol=2e-3)


def test_an_empty_layer_pins_the_whole_picture() -> None:
    moving = Layer(
        "layer-1", "Empty", (), transform=LayerTransform.of({1001: np.eye(3), 1003: np.diag([2.0, 2.0, 1.0])})
    )
    project = Project(CLIP, Layer("root", "Root", (moving,)))
    frames, corners, box, reference = layer_motion(project, moving)
    assert (frames, reference) == ([1001, 1002, 1003], 1001)
    np.testing.assert_array_equal(box, [[0, 1080], [1920, 1080], [1920, 0], [0, 0]])
    np.testing.assert_allclose(corners[2], 2.0 * box)
    frames, *_ = layer_motion(project, moving, ExportOptions(frames=range(1002, 1010)))
    assert frames == [1002, 1003]


def test_frames_on_which_the_shape_is_closed_tell_no_motion(tmp_path: Path) -> None:
    """The engine closed it to a point there, and the box with it."""
    gone = (1004, 1005, 1012)
    keys = (
        Keyframe(
            frame,
            polygon_points((BOX - 250.0) * (1e-4 if frame in gone else 1.0) + 250.0 + 3.0 * (frame - 1001)),
            origin=Origin.ARTIST if frame == 1001 else Origin.ENGINE,
        )
        for frame in range(1001, 1013)
    )
    closing = RotoShape("shape-1", "Box", tuple(keys))
    corners, frames = box_motion(closing)
    assert frames == [1001, 1002, 1003, *range(1006, 1012)]
    np.testing.assert_allclose(corners[:, 1] - corners[:, 0], [[200.0, 0.0]] * len(frames), atol=1e-9)
    across, _ = (keys_of(curve) for curve in tcl.available().split(knobs_of(exported(tmp_path, closing)[3])["to1"]))
    assert list(across) == frames
