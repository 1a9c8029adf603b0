"""Everything in time shifted: what stands on a frame stands on another one, and nothing else changes."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import (
    Animated,
    Keyframe,
    Layer,
    LayerTransform,
    Mark,
    Origin,
    Project,
    RotoShape,
    ValueKey,
    edit,
    file,
)
from roam_core.roto.imported import IMPORT, import_stamp, stamped
from roam_core.roto.lifetimes import EVER, LAST_FRAME, lifetime_of, open_ends
from roam_core.roto.shifting import shifted
from tests.unit.roto.every_field import present_project

SQUARE = polygon_points([(20, 20), (60, 20), (60, 60), (20, 60)])
FADE = Animated((ValueKey(3, 1.0), ValueKey(9, 0.25)))


def moving(offset: float) -> LayerTransform:
    """A layer that goes to the right by one pixel a frame, from frame `offset` on."""
    frames = [int(offset) + k for k in range(11)]
    return LayerTransform.of({f: np.array([[1.0, 0, f - offset], [0, 1, 0], [0, 0, 1]]) for f in frames})


def shape(shape_id: str, *frames: int) -> RotoShape:
    return RotoShape(shape_id, shape_id, tuple(Keyframe(frame, SQUARE + frame) for frame in frames))


@pytest.fixture
def project() -> Project:
    """A shape in a layer that moves, beside a shape at the root, and a note."""
    faded = replace(shape("shape-1", 2, 8), opacity=FADE, feather=FADE, lifetime=(2, 9), depth=((4, 1), (6, 0)))
    layer = Layer("layer-1", "Wall", (faded,), opacity=FADE, transform=replace(moving(0), adjusted=(0, 5)))
    return Project(root=Layer("root", "Root", (layer, shape("shape-2", 1, 5))), marks=(Mark(4, "look"),))


def test_all_of_a_project_is_as_it_was_so_many_frames_before(project: Project) -> None:
    after = shifted(project, 100)
    for was, now in zip(project.shapes, after.shapes, strict=True):
        assert now.frames == tuple(frame + 100 for frame in was.frames)
        for frame in np.arange(0.0, 12.0, 0.5):
            np.testing.assert_array_equal(was.at(frame).points, now.at(frame + 100).points)
            assert was.opacity_at(frame) == now.opacity_at(frame + 100)
            assert was.feather_at(frame) == now.feather_at(frame + 100)
            assert was.exists_at(frame) == now.exists_at(frame + 100)
            assert was.depth_at(int(frame)) == now.depth_at(int(frame) + 100)
    layer = after.find("layer-1")
    assert isinstance(layer, Layer)
    assert layer.transform is not None
    assert layer.transform.adjusted == (100, 105)
    assert layer.opacity_at(109) == 0.25
    assert after.marks == (Mark(104, "look"),)


def test_no_field_that_tells_a_frame_is_forgotten(tmp_path: Path) -> None:
    before = replace(present_project(tmp_path), clip=None)
    after = shifted(before, 7)
    assert shifted(after, -7) == before
    numbers = [list(_numbers(json.loads(file.dumps(each, tmp_path)))) for each in (before, after)]
    assert len(numbers[0]) > 100
    for was, now in zip(*numbers, strict=True):
        assert now in ((was + 7,) if isinstance(was, int) and was > 1000 else (was, was + 7))  # Box has a key on 0


def _numbers(document: object) -> Iterator[float]:
    """All numbers of a document in JSON, in order."""
    if isinstance(document, dict):
        for each in document.values():
            yield from _numbers(each)
    elif isinstance(document, list):
        for each in document:
            yield from _numbers(each)
    elif isinstance(document, int | float):
        yield document


def test_what_is_chosen_alone_is_shifted(project: Project) -> None:
    after = shifted(project, 3, ["shape-2"])
    assert after.shape("shape-2").frames == (4, 8)
    assert after.find("layer-1") is project.find("layer-1")
    assert after.marks == project.marks
    layer = shifted(project, 3, ["layer-1", "shape-1"]).find("layer-1")
    assert isinstance(layer, Layer)
    assert (layer.children[0].frames, layer.transform.frames[0]) == ((5, 11), 3)  # type: ignore[union-attr]


def test_a_shape_of_a_layer_that_moves_and_stays_is_shifted_as_it_is_seen(project: Project) -> None:
    after = shifted(project, 2, ["shape-1"])
    for frame in project.shape("shape-1").frames:
        was, now = project.shape("shape-1").at(frame).points, after.shape("shape-1").at(frame + 2).points
        np.testing.assert_allclose(now, was, atol=1e-9)
    assert after.find("layer-1").transform == project.find("layer-1").transform  # type: ignore[union-attr]


@pytest.mark.parametrize("lifetime", [None, (-EVER, 9), (2, EVER)])
def test_an_open_end_of_a_lifetime_stays_open(lifetime: tuple[int, int] | None) -> None:
    held, _ = edit.add_items(Project(), [replace(shape("shape-1", 1), lifetime=lifetime)])
    (now,) = shifted(held, 50).shapes
    moved = None if lifetime is None else tuple(end if abs(end) == EVER else end + 50 for end in lifetime)
    assert now.lifetime == moved


def test_the_frames_of_a_run_go_along_in_its_stamp_which_tells_by_how_much() -> None:
    run = "fill:best:0123456789abcdef:from=1:to=5:alone"
    key = Keyframe(3, SQUARE, origin=Origin.ENGINE, inputs=run)
    held, _ = edit.add_items(Project(), [shape("shape-1", 1, 5).with_key(key)])
    twice = shifted(shifted(held, 10), -12)
    assert twice.shapes[0].keys[1].inputs == "fill:best:0123456789abcdef:from=-1:to=3:alone:shifted=-2"
    assert shifted(twice, 2) == held


def test_keys_between_those_of_a_file_depend_on_these_alone() -> None:
    between = Keyframe(3, SQUARE, origin=Origin.ENGINE, inputs=IMPORT)
    drawn = stamped(shape("shape-1", 1, 5).with_key(between))
    assert isinstance(drawn, RotoShape)
    (now,) = shifted(edit.add_items(Project(), [drawn])[0], 20).shapes
    assert now.keys[1].inputs == import_stamp(now, 23)


def test_what_would_lie_beyond_all_frames_is_refused(project: Project) -> None:
    with pytest.raises(RoamError, match="beyond frame"):
        shifted(project, LAST_FRAME)


@pytest.mark.parametrize("start", [None, -50_000_000, 5, 103_680_000])
@pytest.mark.parametrize("stop", [None, 9, 103_680_100])
def test_open_ends_stay_open_and_others_where_they_are(start: int | None, stop: int | None) -> None:
    """Also of plates that are numbered by time code, beyond what stands for always."""
    lifetime = lifetime_of(start, stop)
    if lifetime is None or lifetime[0] >= lifetime[1]:
        return
    assert open_ends(lifetime) == (start, stop)


def test_what_has_nine_digits_is_shifted() -> None:
    """One frame on was too far, and a lifetime lost its end."""
    shape = RotoShape("s", "s", (Keyframe(103_680_005, SQUARE),), lifetime=(103_680_001, 103_680_009))
    (moved,) = shifted(edit.add_shape(Project(), shape), 2).shapes
    assert (moved.frames, moved.lifetime) == ((103_680_007,), (103_680_003, 103_680_011))
