"""Feather curves: pulling, turning, taking back."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.geometry.bezier import ANCHOR, IN, OUT, polygon_points
from roam_core.roto import Keyframe, Origin, RotoShape, edit, feather
from roam_core.roto.imported import IMPORT
from roam_core.roto.keying import Keying, held_at, reshape
from roam_core.roto.placement import LayerTransform
from roam_core.roto.shape import placed, unplaced

SQUARE = polygon_points([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)])
KAPPA = 0.5522847498


def circle(radius: float) -> np.ndarray:
    angles = np.arange(4) * np.pi / 2
    anchors = radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    along = KAPPA * radius * np.stack([-np.sin(angles), np.cos(angles)], axis=1)
    return np.stack([anchors, anchors - along, anchors + along], axis=1)


def shape(points: np.ndarray, *frames: int) -> RotoShape:
    return RotoShape("shape-1", "Shape 1", tuple(Keyframe(frame, points) for frame in frames or (1,)))


@pytest.mark.parametrize("closed", [True, False])
def test_a_point_without_handles_runs_along_its_neighbours_chord_and_an_end_along_its_one_segment(closed: bool) -> None:
    along = feather.frames_along(SQUARE, closed)[:, 0]
    slant = np.sqrt(0.5)
    ends = [(slant, -slant), (-slant, -slant)] if closed else [(1.0, 0.0), (-1.0, 0.0)]
    np.testing.assert_allclose(along, [ends[0], (slant, slant), (-slant, slant), ends[1]], atol=1e-12)


def test_a_circle_pulled_alike_becomes_a_greater_circle() -> None:
    points = circle(10.0)
    across = -5.0  # this circle turns to the right: outside is on the left
    offsets = feather.pulled(points, None, np.ones(4), 0.0, across, True)
    np.testing.assert_allclose(points + offsets, circle(15.0), atol=1e-9)


def test_one_point_is_pulled_by_the_very_distance_and_the_others_stay() -> None:
    frame = feather.frames_along(SQUARE)[1]
    along, across = frame @ np.array([3.0, -4.0])
    weights = np.array([0.0, 1.0, 0.0, 0.0])
    offsets = feather.pulled(SQUARE, None, weights, along, across, True)
    np.testing.assert_allclose(offsets[1, ANCHOR], [3.0, -4.0], atol=1e-12)
    assert not offsets[[0, 2, 3]].any()


def test_directions_turn_with_the_curve() -> None:
    frames = feather.frames_along(circle(10.0))
    np.testing.assert_allclose(frames[:, 1], -circle(1.0)[:, ANCHOR], atol=1e-9)
    ends = feather.frames_along(SQUARE[:3], closed=False)
    np.testing.assert_allclose(ends[[0, 2], 0], [[1.0, 0.0], [0.0, 1.0]], atol=1e-12)


def test_a_handle_turns_on_the_feather_curve_alone() -> None:
    one = shape(circle(10.0))
    change = feather.turn(one, 0, OUT, (2.0, 0.0), edit.drag_handle)
    turned = reshape(one, 1, change)
    line = feather.curve(turned.at(1))
    np.testing.assert_array_equal(turned.at(1).points, circle(10.0))
    np.testing.assert_allclose(line[0, OUT], circle(10.0)[0, OUT] + [2.0, 0.0])
    arm, other = line[0, OUT] - line[0, ANCHOR], line[0, IN] - line[0, ANCHOR]
    assert arm[0] * other[1] - arm[1] * other[0] == pytest.approx(0.0, abs=1e-9)  # smooth stays smooth


def test_all_keys_in_the_ripple_are_feathered_alike() -> None:
    one = shape(SQUARE, 1, 5, 9)
    pull = feather.pull(one, np.array([1.0, 0.0, 0.0, 0.0]), 0.0, -2.0)
    rippled = reshape(one, 5, pull, Keying(ripple=range(1, 6)), held_at(one, 5))
    first, second, third = (key.feather for key in rippled.keys)
    np.testing.assert_array_equal(first, second)
    assert first is not None
    assert third is None


def test_reset_leaves_nothing_behind() -> None:
    one = reshape(shape(SQUARE), 1, feather.pull(shape(SQUARE), np.array([1.0, 1.0, 0.0, 0.0]), 0.0, -2.0))
    half = reshape(one, 1, feather.reset([0]))
    assert half.at(1).feather is not None
    assert not half.at(1).feather[0].any()
    assert reshape(half, 1, feather.reset([1])).at(1).feather is None
    assert reshape(shape(SQUARE), 1, feather.reset([0])) == shape(SQUARE)


def test_pulling_changes_no_argument() -> None:
    before = np.zeros_like(SQUARE)
    one = replace(shape(SQUARE), keys=(Keyframe(1, SQUARE, feather=before),))
    reshape(one, 1, feather.pull(one, np.ones(4), 1.0, 1.0))
    assert not before.any()


def tracked(*artist: int) -> RotoShape:
    """Keys on frames 1 to 9, the artist's on these and the engine's on all others."""
    keys = (Keyframe(f, SQUARE, origin=Origin.ARTIST if f in artist else Origin.ENGINE) for f in range(1, 10))
    return RotoShape("shape-1", "Shape 1", tuple(keys))


def widths(one: RotoShape) -> dict[int, float]:
    """How far the first feather point lies to the left on each key."""
    return {key.frame: 0.0 if key.feather is None else -float(key.feather[0, ANCHOR, 0]) for key in one.keys}


def feathered(one: RotoShape, frame: int, width: float) -> RotoShape:
    offset = np.zeros_like(SQUARE)
    offset[0] = [-width, 0.0]
    return edit.set_key(one, frame, SQUARE, offset)


def test_tracked_frames_go_along_with_a_feather_to_the_next_keys() -> None:
    one = feather.carried_on(feathered(tracked(1, 5, 9), 5, 8.0), 5)
    assert widths(one) == {1: 0, 2: 2, 3: 4, 4: 6, 5: 8, 6: 6, 7: 4, 8: 2, 9: 0}
    assert one.artist_frames == (1, 5, 9)


def test_beyond_the_last_key_a_feather_stays() -> None:
    one = feather.carried_on(feathered(tracked(4), 4, 8.0), 4)
    assert set(widths(one).values()) == {8.0}
    assert one.artist_frames == (4,)


QUARTER = np.array([[0.0, 1.0], [-1.0, 0.0]])
"""Turns rows of x and y by a quarter."""


def test_a_feather_turns_with_the_outline_as_a_whole_and_keeps_its_width() -> None:
    """A limb that swung by a quarter had its soft edge on the side where it lay before."""
    soft = feathered(tracked(1), 1, 8.0).keys[0].feather
    assert soft is not None
    after = 1.5 * SQUARE @ QUARTER + 30.0
    found = feather.turned(soft, SQUARE, after)
    assert found is not None
    np.testing.assert_allclose(found, soft @ QUARTER, atol=1e-12)
    assert feather.turned(None, SQUARE, after) is None
    np.testing.assert_array_equal(feather.turned(soft, SQUARE, np.zeros_like(SQUARE)), soft)


def test_between_two_keys_that_turn_a_feather_keeps_its_width() -> None:
    one = RotoShape("a", "A", tuple(Keyframe(f, p, feather=o) for f, p, o in turning()))
    here = SQUARE @ (np.eye(2) + QUARTER) / np.sqrt(2.0)
    found = feather.between_keys(one, 5, here)
    assert found is not None
    np.testing.assert_allclose(np.hypot(*found[0, ANCHOR]), 8.0)
    for frame, points, offset in turning():
        np.testing.assert_allclose(feather.between_keys(one, frame, points), offset, atol=1e-12)


def test_in_a_layer_that_turns_a_feather_is_turned_by_it_once() -> None:
    """The layer turned it, and then the outline that the layer had turned did so again."""
    matrices = {frame: np.eye(3) for frame in (1, 9)}
    matrices[9][:2, :2] = QUARTER.T
    layer = LayerTransform.of(matrices)
    soft = turning()[0][2]
    inside = tracked(1, 9).with_key(Keyframe(1, SQUARE, soft))
    inside = inside.with_keys(replace(key, points=SQUARE) for key in inside.keys)
    found = unplaced(
        feather.carried_on(placed(inside.with_keys([replace(inside.keys[-1], feather=soft)]), (layer,)), 1)
    )
    for key in found.keys:
        assert key.feather is not None
        np.testing.assert_allclose(key.feather, soft, atol=1e-9, err_msg=str(key.frame))


def turning() -> list[tuple[int, Array, Array]]:
    """Frames, outlines and feathers of a square that turns by a quarter; its first feather point is 8 px out."""
    soft = np.zeros_like(SQUARE)
    soft[0] = [-8.0, 0.0]
    return [(1, SQUARE, soft), (9, SQUARE @ QUARTER, soft @ QUARTER)]


def test_on_a_frame_without_a_key_of_the_artists_nothing_is_carried() -> None:
    one = tracked(1, 9)
    assert feather.carried_on(one, 5) is one


def test_keys_of_a_file_keep_their_feather() -> None:
    one = feathered(tracked(1, 5), 5, 8.0)
    one = one.with_key(replace(one.keys[2], inputs=f"{IMPORT}::0123"))
    assert widths(feather.carried_on(one, 5))[3] == 0.0


def test_a_feather_for_all_keys_turns_with_the_outline() -> None:
    """On a key that is turned by a quarter the soft edge lies out of the same points, by as much."""
    centre, turn = np.array([5.0, 5.0]), np.array([[0.0, 1.0], [-1.0, 0.0]])
    one = edit.set_key(feathered(tracked(1), 1, 8.0), 9, (SQUARE - centre) @ turn + centre)
    offset = one.keys[0].feather
    assert offset is not None
    given = feather.on_all_keys(one, 1, [0])
    assert [width for frame, width in widths(given).items() if frame < 9] == pytest.approx([8.0] * 8)
    assert given.keys[0] is one.keys[0]
    last = given.keys[-1].feather
    assert last is not None
    np.testing.assert_allclose(last, offset @ turn, atol=1e-12)
    assert given.artist_frames == (1, 9)


def test_a_feather_for_all_keys_leaves_other_points_alone() -> None:
    one = feathered(tracked(1), 1, 8.0)
    given = feather.on_all_keys(one, 5, [2])
    assert widths(given) == widths(one)


def test_keys_to_which_all_keys_brings_no_feather_stay_the_very_same() -> None:
    shape = RotoShape("a", "a", tuple(Keyframe(frame, SQUARE + frame) for frame in range(1, 5)))
    given = feather.on_all_keys(shape, 1, range(len(SQUARE)))
    assert all(after is before for after, before in zip(given.keys, shape.keys, strict=True))
