"""Keys in time: what moves, what gives way, and that the engine's keys are told to be of the past."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roam_core.errors import RoamError
from roam_core.geometry import bezier
from roam_core.params import CONFIGS, DEFAULT_CONFIG
from roam_core.propagate.shapes.provenance import clip_stamp, is_stale, stamp
from roam_core.roto import (
    Clip,
    Interpolation,
    Keyframe,
    Mark,
    Origin,
    Project,
    RotoShape,
    Spline,
    control_points,
    edit,
    file,
    timing,
)

SQUARE = bezier.polygon_points([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)])
CLIP = Clip(Path("shot"), 1, 60, (64, 48))


def tracked(shape_id: str = "a") -> RotoShape:
    """Artist keys on 10 and 20; tracked forward from the first up to 14."""
    shape = RotoShape(shape_id, shape_id, (Keyframe(10, SQUARE), Keyframe(20, SQUARE + 1)))
    inputs = stamp([shape], 14, 10, CONFIGS[DEFAULT_CONFIG], clip_stamp(CLIP), True)
    made = [Keyframe(f, SQUARE, origin=Origin.ENGINE, confidence=0.5, inputs=inputs) for f in range(11, 15)]
    return edit.set_engine_keys(shape, made)


@pytest.fixture
def project() -> Project:
    return edit.add_shape(edit.add_shape(Project(CLIP), tracked()), tracked("b"))


def test_only_the_artists_keys_at_the_places_move(project: Project) -> None:
    moved = timing.move_keys(project, [("a", 10), ("b", 20), ("a", 12), ("gone", 3)], 5)
    a, b = moved.shape("a"), moved.shape("b")
    assert a.artist_frames == (15, 20)
    assert b.artist_frames == (10, 25)
    assert {12, 14} <= set(a.frames)
    assert np.array_equal(a.at(15).points, SQUARE)
    assert timing.artist_places(moved) == {("a", 15), ("a", 20), ("b", 10), ("b", 25)}


def test_tracked_frames_of_a_key_that_moved_are_stale(project: Project) -> None:
    assert not any(is_stale(project.shape("a"), key, CLIP) for key in project.shape("a").keys)
    shape = timing.move_keys(project, [("a", 10)], -2).shape("a")
    assert [key.frame for key in shape.keys if is_stale(shape, key, CLIP)] == [11, 12, 13, 14]


def test_a_key_gives_way_to_the_one_that_arrives(project: Project) -> None:
    shape = timing.move_keys(project, [("a", 10)], 10).shape("a")
    assert shape.artist_frames == (20,)
    assert np.array_equal(shape.at(20).points, SQUARE)
    onto_a_tracked_frame = timing.move_keys(project, [("a", 20)], -8).shape("a")
    assert onto_a_tracked_frame.artist_frames == (10, 12)


def test_neighbours_that_move_together_do_not_overwrite_each_other(project: Project) -> None:
    two = timing.copy_keys(project, [("a", 20)], 1)
    assert timing.move_keys(two, [("a", 20), ("a", 21)], 1).shape("a").artist_frames == (10, 21, 22)


def test_copies_are_the_artists_and_the_keys_stay(project: Project) -> None:
    shape = timing.copy_keys(project, [("a", 10)], 3).shape("a")
    assert shape.artist_frames == (10, 13, 20)
    assert np.array_equal(shape.at(13).points, SQUARE)


def test_pasted_keys_lose_what_the_engine_said_of_them(project: Project) -> None:
    engine = project.shape("a").key_at(12)
    assert engine is not None
    pasted = timing.paste_keys(project, {"b": [engine], "gone": [engine]}, 30).shape("b").key_at(42)
    assert pasted is not None
    assert (pasted.origin, pasted.confidence, pasted.inputs) == (Origin.ARTIST, None, "")


def test_keys_of_another_number_of_points_are_not_pasted(project: Project) -> None:
    assert timing.paste_keys(project, {"a": [Keyframe(30, SQUARE[:3])]}) == project


def test_a_b_spline_takes_the_key_of_a_bezier_as_a_b_spline(project: Project) -> None:
    rounded = control_points.with_spline(replace(project.shape("a"), keys=(Keyframe(10, SQUARE),)), Spline.BSPLINE)
    pasted = timing.paste_keys(project.with_shape(rounded), {"a": [Keyframe(30, SQUARE)]}).shape("a").at(30)
    np.testing.assert_allclose(pasted.points, control_points.settled(SQUARE, rounded))
    assert not np.allclose(pasted.points, SQUARE)


def test_deleting_spares_the_engines_keys_and_the_last_of_all(project: Project) -> None:
    shape = timing.delete_keys(project, [("a", 10), ("a", 12)]).shape("a")
    assert shape.frames == (11, 12, 13, 14, 20)
    lone = edit.add_shape(Project(), RotoShape("c", "c", (Keyframe(1, SQUARE),)))
    with pytest.raises(RoamError, match="at least one key"):
        timing.delete_keys(lone, [("c", 1)])


@pytest.mark.parametrize(
    ("first", "last", "goes"),
    [
        (10, 40, {10: 10, 15: 25, 20: 40}),
        (0, 20, {10: 0, 15: 10, 20: 20}),
        (10, 12, {10: 10, 15: 11, 20: 12}),
        (10, 3, {10: 10, 15: 11, 20: 12}),
        (10, 20, {10: 10, 15: 15, 20: 20}),
    ],
)
def test_stretched_frames_keep_their_order_and_their_shares(first: int, last: int, goes: dict[int, int]) -> None:
    assert timing.stretched([15, 10, 20, 10], first, last) == goes


@given(st.sets(st.integers(-50, 200), min_size=1, max_size=20), st.integers(-50, 50), st.integers(-50, 300))
def test_each_stretched_frame_has_a_place_of_its_own(frames: set[int], first: int, last: int) -> None:
    goes = list(timing.stretched(frames, first, last).items())
    assert [frame for frame, _ in goes] == sorted(frames)
    assert all(a < b for (_, a), (_, b) in pairwise(goes))
    assert goes[0][1] == first
    if len(goes) > 1:
        assert goes[-1][1] == max(last, first + len(goes) - 1)


def test_retimed_keys_take_the_place_of_others_and_the_engines_stay(project: Project) -> None:
    own = [("a", frame) for frame in project.shape("a").artist_frames]
    first, *_, last = project.shape("a").artist_frames
    after = timing.retime_keys(project, own, timing.stretched({frame for _, frame in own}, first, last + 10)).shape("a")
    assert (after.artist_frames[0], after.artist_frames[-1]) == (first, last + 10)
    engine = [key.frame for key in project.shape("a").keys if key.origin is Origin.ENGINE]
    assert [key.frame for key in after.keys if key.origin is Origin.ENGINE] == engine


def test_interpolation_is_set_where_keys_are(project: Project) -> None:
    shape = timing.set_interpolation(project, [("a", 10), ("a", 11), ("a", 55)], Interpolation.HOLD).shape("a")
    assert [key.frame for key in shape.keys if key.interpolation is Interpolation.HOLD] == [10, 11]


def test_marks_are_set_named_moved_and_removed() -> None:
    project = timing.set_mark(timing.set_mark(Project(), 20, "turn"), 10)
    assert project.marks == (Mark(10), Mark(20, "turn"))
    assert timing.set_mark(project, 10, "in").marks == (Mark(10, "in"), Mark(20, "turn"))
    assert timing.move_mark(project, 20, 5).marks == (Mark(5, "turn"), Mark(10))
    assert timing.move_mark(project, 20, 10).marks == (Mark(10, "turn"),)
    assert timing.move_mark(project, 10, 20).marks == (Mark(20, "turn"),)  # its note was lost
    noted = timing.set_mark(project, 10, "in")
    assert timing.move_mark(noted, 20, 10).marks == (Mark(10, "in\nturn"),)
    assert timing.move_mark(noted, 20, 20) == noted
    assert timing.move_mark(project, 3, 4) == project
    assert timing.remove_mark(project, 10).marks == (Mark(20, "turn"),)
    assert timing.mark_at(project, 11) is None


def test_marks_come_back_from_the_file_and_older_files_have_none() -> None:
    marked = timing.set_mark(Project(), 20, "turn")
    assert file.loads(file.dumps(marked, Path()), Path()) == marked
    assert '"marks"' not in file.dumps(Project(), Path())
    assert file.loads(file.dumps(Project(), Path()), Path()).marks == ()
    assert file.digest(marked) != file.digest(timing.set_mark(Project(), 20))
