"""Which keys an edit reaches: with auto-key, without it, and with ripple."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.geometry.bezier import ANCHOR, polygon_points
from roam_core.roto import Interpolation, Keyframe, Origin, Outline, Project, RotoShape, Spline, edit
from roam_core.roto.control_points import settled
from roam_core.roto.keying import Keying, held_at, reshape
from roam_core.roto.placement import LayerTransform
from roam_core.roto.shape import placed

SQUARE = polygon_points([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)])
STEP = np.array([3.0, -2.0])


def right(frame: int) -> np.ndarray:
    return SQUARE + np.array((2.0 * frame, 0.0))


def shape(**values: object) -> RotoShape:
    """Artist keys on 1, 5 and 9, engine keys on 3 and 7, each two pixels a frame further right."""
    keys = [Keyframe(frame, right(frame)) for frame in (1, 5, 9)]
    keys += [Keyframe(f, right(f), origin=Origin.ENGINE, inputs="forward:best:0") for f in (3, 7)]
    return RotoShape("a", "A", tuple(keys), **values)  # type: ignore[arg-type]


def moved(outline: Outline) -> Outline:
    return replace(outline, points=outline.points + STEP)


def shift(before: RotoShape, after: RotoShape, frame: int) -> tuple[float, float]:
    """How far the first anchor moved on a frame."""
    dx, dy = (after.at(frame).anchors - before.at(frame).anchors)[0].tolist()
    return dx, dy


def test_auto_key_makes_an_artist_key_on_its_frame_alone() -> None:
    before = shape()
    after = reshape(before, 4, moved)
    assert after.artist_frames == (1, 4, 5, 9)
    assert shift(before, after, 4) == tuple(STEP)
    assert all(after.key_at(frame) is before.key_at(frame) for frame in before.frames)


def test_auto_key_makes_an_engine_frame_the_artists() -> None:
    after = reshape(shape(), 3, moved)
    assert after.artist_frames == (1, 3, 5, 9)


def test_a_change_of_nothing_makes_no_key() -> None:
    before = shape()
    assert reshape(before, 4, lambda outline: outline) == before
    soft = before.with_keys(replace(key, feather=np.ones_like(SQUARE)) for key in before.keys)
    for each in (before, soft):
        again = reshape(each, 4, lambda at: replace(at, points=at.points + 0.0, feather=copied(at.feather)))
        assert again == each, "equal arrays are no change, whoever made them"


def copied(feather: np.ndarray | None) -> np.ndarray | None:
    return None if feather is None else feather.copy()


def test_without_auto_key_a_key_that_is_there_takes_the_edit_alone() -> None:
    before = shape()
    after = reshape(before, 5, moved, Keying(auto=False))
    assert [shift(before, after, frame) for frame in (1, 5, 9)] == [(0.0, 0.0), tuple(STEP), (0.0, 0.0)]


def test_without_auto_key_the_keys_on_both_sides_take_the_edit_between_them() -> None:
    before = shape()
    after = reshape(before, 4, moved, Keying(auto=False))
    assert after.frames == before.frames
    assert after.artist_frames == before.artist_frames
    assert [shift(before, after, frame) for frame in (1, 3, 4, 5)] == [tuple(STEP)] * 4
    assert [after.key_at(frame) for frame in (7, 9)] == [before.key_at(frame) for frame in (7, 9)]


def test_without_auto_key_an_engine_frame_stays_the_engines_and_moves_with_its_keys() -> None:
    before = shape()
    after = reshape(before, 3, moved, Keying(auto=False))
    key = after.key_at(3)
    assert key is not None
    assert (key.origin, key.inputs) == (Origin.ENGINE, "forward:best:0")
    assert shift(before, after, 3) == tuple(STEP)


@pytest.mark.parametrize(("frame", "reached"), [(0, (1,)), (12, (9,))])
def test_without_auto_key_beyond_the_ends_the_nearest_key_takes_the_edit(frame: int, reached: tuple[int]) -> None:
    before = shape()
    after = reshape(before, frame, moved, Keying(auto=False))
    assert tuple(f for f in before.frames if after.key_at(f) != before.key_at(f)) == reached
    assert shift(before, after, frame) == tuple(STEP)


def test_ripple_changes_every_key_of_the_range_and_no_other() -> None:
    before = shape()
    after = reshape(before, 5, moved, Keying(ripple=range(3, 9)))
    assert [shift(before, after, frame) for frame in before.frames] == [
        (0.0, 0.0), tuple(STEP), tuple(STEP), tuple(STEP), (0.0, 0.0),
    ]  # fmt: skip
    assert after.artist_frames == before.artist_frames


def test_ripple_on_a_frame_outside_its_range_changes_that_frame_too() -> None:
    before = shape()
    after = reshape(before, 9, moved, Keying(ripple=range(1, 2)))
    assert [shift(before, after, frame) for frame in (1, 5, 9)] == [tuple(STEP), (0.0, 0.0), tuple(STEP)]


def test_ripple_without_auto_key_makes_no_key() -> None:
    before = shape()
    after = reshape(before, 4, moved, Keying(auto=False, ripple=range(1, 10)))
    assert after.frames == before.frames
    assert {shift(before, after, frame) for frame in (1, 2, 4, 9)} == {tuple(STEP)}


def test_an_edit_goes_on_from_where_its_drag_began() -> None:
    before = shape()
    start = held_at(before, 3)
    tracked = edit.set_engine_keys(before, [Keyframe(3, SQUARE + 90.0, origin=Origin.ENGINE)])
    after = reshape(tracked, 3, moved, start=start)
    np.testing.assert_array_equal(after.at(3).points, start.points + STEP)


def test_what_a_key_has_beside_its_points_stays() -> None:
    keys = [replace(key, interpolation=Interpolation.HOLD, extra={"later": 1}) for key in shape().keys]
    after = reshape(replace(shape(), keys=tuple(keys)), 5, moved, Keying(ripple=range(1, 10)))
    assert {key.interpolation for key in after.keys} == {Interpolation.HOLD}
    assert [dict(key.extra) for key in after.keys] == [{"later": 1}] * 5


def test_feather_can_be_changed_and_taken_away() -> None:
    feathered = reshape(shape(), 5, lambda outline: replace(outline, feather=np.ones_like(outline.points)))
    key = feathered.key_at(5)
    assert key is not None
    assert key.feather is not None
    bare = reshape(feathered, 5, lambda outline: replace(outline, feather=None)).key_at(5)
    assert bare is not None
    assert bare.feather is None


def test_a_b_spline_is_changed_by_its_control_points() -> None:
    _, drawn = edit.new_shape(Project(), SQUARE, 1, spline=Spline.BSPLINE)
    drawn = edit.set_control_points(drawn, 9, SQUARE + 5.0)

    def pulled(outline: Outline) -> Outline:
        points = outline.points.copy()
        points[1] += STEP
        return replace(outline, points=points)

    after = reshape(drawn, 1, pulled, Keying(ripple=range(1, 10)))
    for frame in (1, 9):
        controls = drawn.at(frame).control_points[:, ANCHOR].copy()
        controls[1] += STEP
        np.testing.assert_allclose(after.at(frame).control_points[:, ANCHOR], controls, atol=1e-9)


# ---- shapes in layers that move


def turning(**values: object) -> RotoShape:
    """Keys on 1 and 9, in a layer that turns by 20 degrees and grows by a tenth a frame."""
    matrices = {}
    for frame in range(1, 10):
        angle, size = np.radians(20.0 * (frame - 1)), 1.0 + 0.1 * (frame - 1)
        c, s = size * np.cos(angle), size * np.sin(angle)
        matrices[frame] = np.array([[c, -s, 5.0 * frame], [s, c, 0.0], [0.0, 0.0, 1.0]])
    keys = tuple(Keyframe(frame, right(frame), feather=np.ones_like(SQUARE)) for frame in (1, 9))
    return placed(RotoShape("a", "A", keys, **values), (LayerTransform.of(matrices),))  # type: ignore[arg-type]


@pytest.mark.parametrize("frame", [4, 12])
def test_without_auto_key_an_outline_in_a_moving_layer_goes_where_it_is_dragged(frame: int) -> None:
    """Its keys on both sides, or the last one, take the change as the layer carries it."""
    before = turning()
    after = reshape(before, frame, moved, Keying(auto=False))
    assert after.frames == before.frames
    np.testing.assert_allclose(after.at(frame).points, before.at(frame).points + STEP, atol=1e-9)
    np.testing.assert_allclose(after.at(frame).feather, before.at(frame).feather, atol=1e-9)


def test_without_auto_key_points_that_do_not_move_stay_bit_by_bit_in_a_moving_layer() -> None:
    before = turning()
    after = reshape(before, 4, lambda each: replace(each, points=with_first_moved(each.points)), Keying(auto=False))
    for key in before.keys:
        np.testing.assert_array_equal(after.key_at(key.frame).points[1:], key.points[1:])
        np.testing.assert_array_equal(after.key_at(key.frame).feather, key.feather)
    assert shift(before, after, 4) == pytest.approx(tuple(STEP))


def test_without_auto_key_a_b_spline_in_a_moving_layer_goes_where_it_is_dragged() -> None:
    before = turning(spline=Spline.BSPLINE)
    before = replace(before, keys=tuple(replace(k, points=settled(k.points, before)) for k in before.keys))
    after = reshape(before, 4, moved, Keying(auto=False))
    np.testing.assert_allclose(after.at(4).points, before.at(4).points + STEP, atol=1e-9)


def with_first_moved(points: np.ndarray) -> np.ndarray:
    result = points.copy()
    result[0] += STEP
    return result
