"""The Tracker's promises: determinism, artist keys, kinds of images, failing with a name. For every configuration."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from copy import copy, deepcopy
from dataclasses import replace

import cv2
import numpy as np
import pytest

from roam_core.cancel import Cancelled, CancelToken
from roam_core.errors import RoamError
from roam_core.features import PreparedFrame
from roam_core.geometry import bezier
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.params import CONFIGS, params_for, scale_for
from roam_core.propagate import Termination, Tracker, track
from roam_core.propagate.between.span import fill_span
from roam_core.roto import Keyframe, Origin, RotoShape, edit
from roam_core.roto.feather import turned
from roam_core.roto.imported import IMPORT
from tests.golden.shots import Shot, gliding, outline_distance, square

pytestmark = pytest.mark.parametrize("config", list(CONFIGS))


def tracked(shot: Shot, config: str, shape: RotoShape | None = None) -> RotoShape:
    """A shape carried forward through the whole shot."""
    tracker = Tracker(config)
    tracker.start(shot.read(shot.first), shape or shot.shape(), shot.first)
    for frame in shot.frames[1:]:
        tracker.step(shot.read(frame), frame)
    return tracker.shape


def test_a_gliding_square_is_followed(config: str, box_shot: Shot) -> None:
    shape = tracked(box_shot, config)
    centres = [shape.at(frame).anchors.mean(axis=0) for frame in box_shot.frames]
    true = [box_shot.truth(frame)[:, ANCHOR].mean(axis=0) for frame in box_shot.frames]
    off = np.hypot(*(np.array(centres) - np.array(true)).T)
    assert off.mean() < 1.0
    assert off.max() < 2.0  # `baseline` moves by whole pixels: one that costs the same either way is one pixel


def test_a_turning_blob_is_followed_below_a_pixel(config: str, blob_shot: Shot) -> None:
    shape = tracked(blob_shot, config)
    for frame in blob_shot.frames:
        assert outline_distance(shape.at(frame).points, blob_shot.truth(frame)) < 1.0


def test_two_threads_give_the_bits_of_one(config: str, blob_shot: Shot) -> None:
    before, runs = cv2.getNumThreads(), []
    try:
        for count in (1, 2):
            cv2.setNumThreads(count)
            runs.append(tracked(blob_shot, config))
    finally:
        cv2.setNumThreads(before)
    for ours, theirs in zip(runs[0].keys, runs[1].keys, strict=True):
        np.testing.assert_array_equal(ours.points, theirs.points)
        assert ours.confidence == theirs.confidence


def test_a_caller_who_has_numpy_raise_gets_the_same(config: str, blob_shot: Shot) -> None:
    """`full` and `medium` ended in a FloatingPointError where `np.seterr(all="raise")` was set."""
    expected, before = tracked(blob_shot, config), cv2.getNumThreads()
    filled = edit.set_key(blob_shot.shape(), 1004, blob_shot.truth(1004))
    try:
        cv2.setNumThreads(1)  # on other threads numpy raises nothing
        with np.errstate(all="raise"):
            found = tracked(blob_shot, config)
            fill_span(blob_shot.read, [filled], blob_shot.first, 1004, config)
    finally:
        cv2.setNumThreads(before)
    for ours, theirs in zip(found.keys, expected.keys, strict=True):
        np.testing.assert_array_equal(ours.points, theirs.points)


def test_a_result_says_what_became_of_its_frame(config: str, blob_shot: Shot) -> None:
    tracker = Tracker(config)
    tracker.start(blob_shot.read(1001), blob_shot.shape(), 1001)
    result = tracker.step(blob_shot.read(1002), 1002)
    assert result.frame == tracker.frame == 1002
    assert result.shape is tracker.shape
    assert result.key is not None
    assert result.key.origin is Origin.ENGINE
    assert result.termination in (Termination.CONVERGED, Termination.MAX_ITERATIONS)
    assert 0.5 < result.confidence <= 1.0
    assert result.key.confidence == result.confidence
    assert result.key.vertex_confidence is not None
    assert result.key.vertex_confidence.shape == (result.shape.point_count,)
    assert (result.key.vertex_confidence >= 0.0).all()
    assert (result.key.vertex_confidence <= 1.0).all()
    shares = dict(result.energies)
    assert shares.pop("total") == pytest.approx(sum(shares.values()))
    assert result.seconds > 0.0


def test_two_runs_give_the_same_bits(config: str, blob_shot: Shot) -> None:
    assert tracked(blob_shot, config) == tracked(blob_shot, config)


def test_the_numbers_of_the_frames_tell_the_engine_nothing(config: str, blob_shot: Shot) -> None:
    shape, first = blob_shot.shape(), blob_shot.first
    tracker = Tracker(config)
    tracker.start(blob_shot.read(first), replace(shape, keys=(replace(shape.keys[0], frame=7),)), 7)
    for frame in blob_shot.frames[1:]:
        tracker.step(blob_shot.read(frame), frame - first + 7)
    for now, was in zip(tracker.shape.keys, tracked(blob_shot, config).keys, strict=True):
        assert now.frame == was.frame - first + 7
        np.testing.assert_array_equal(now.points, was.points)


def test_floats_and_bytes_give_the_same_bits(config: str, blob_shot: Shot) -> None:
    trackers = Tracker(config), Tracker(config)
    trackers[0].start(blob_shot.read(1001), blob_shot.shape(), 1001)
    trackers[1].start(blob_shot.read(1001).astype(np.float32) / 255, blob_shot.shape(), 1001)
    for frame in (1002, 1003):
        trackers[0].step(blob_shot.read(frame), frame)
        trackers[1].step(blob_shot.read(frame).astype(np.float32) / 255, frame)
    assert trackers[0].shape == trackers[1].shape


def test_a_grey_image_is_tracked_like_its_three_equal_channels(config: str, blob_shot: Shot) -> None:
    trackers = Tracker(config), Tracker(config)
    for frame in (1001, 1002):
        grey = blob_shot.read(frame)[..., 1]
        for tracker, image in zip(trackers, (grey, np.repeat(grey[..., None], 3, axis=2)), strict=True):
            if frame == 1001:
                tracker.start(image, blob_shot.shape(), frame)
            else:
                tracker.step(image, frame)
    assert trackers[0].shape == trackers[1].shape
    assert outline_distance(trackers[0].shape.at(1002).points, blob_shot.truth(1002)) < 1.5


def test_a_prepared_frame_is_the_picture_it_was_made_of(config: str, blob_shot: Shot) -> None:
    prepared = Tracker(config)
    prepared.start(PreparedFrame(blob_shot.read(1001)), blob_shot.shape(), 1001)
    prepared.step(PreparedFrame(blob_shot.read(1002)), 1002)
    plain = Tracker(config)
    plain.start(blob_shot.read(1001), blob_shot.shape(), 1001)
    plain.step(blob_shot.read(1002), 1002)
    assert prepared.shape == plain.shape


# ---- the artist's points and keys ------------------------------------------------------------------------------------


def test_a_polygon_stays_a_polygon(config: str, box_shot: Shot) -> None:
    shape = tracked(box_shot, config)
    for key in shape.keys:
        np.testing.assert_array_equal(key.points[:, IN], key.points[:, ANCHOR])
        np.testing.assert_array_equal(key.points[:, OUT], key.points[:, ANCHOR])


def test_points_keep_their_number_and_smooth_points_stay_smooth(config: str, blob_shot: Shot) -> None:
    cusp = edit.cusp_points(blob_shot.truth(1001), [2])
    shape = tracked(blob_shot, config, RotoShape("a", "A", (Keyframe(1001, cusp),)))
    for key in shape.keys:
        assert len(key.points) == len(cusp)
        smooth = [edit.is_smooth(point) for point in key.points]
        assert smooth == [index != 2 for index in range(len(cusp))]
        np.testing.assert_array_equal(key.points[2, IN], key.points[2, ANCHOR])


def test_an_artists_key_on_the_way_is_taken_as_it_is_and_led_on_from(config: str, blob_shot: Shot) -> None:
    mine = Keyframe(1003, blob_shot.truth(1003) + np.array([0.25, 0.5]))
    shape = tracked(blob_shot, config, blob_shot.shape().with_key(mine))
    assert shape.key_at(1003) == mine
    assert shape.artist_frames == (1001, 1003)
    later = Tracker(config)
    later.start(blob_shot.read(1003), RotoShape("shape-1", "shape-1", (mine,)), 1003)
    later.step(blob_shot.read(1004), 1004)
    assert shape.at(1004).points.tobytes() == later.shape.at(1004).points.tobytes()


def test_tracking_again_replaces_the_engines_keys_only(config: str, blob_shot: Shot) -> None:
    mine = Keyframe(1004, blob_shot.truth(1004))
    first = tracked(blob_shot, config, blob_shot.shape().with_key(mine))
    spoilt = first.with_key(Keyframe(1002, first.at(1002).points + 9.0, origin=Origin.ENGINE))
    assert tracked(blob_shot, config, spoilt) == first


def test_a_correction_is_led_on_from(config: str, blob_shot: Shot) -> None:
    tracker = Tracker(config)
    tracker.start(blob_shot.read(1001), blob_shot.shape(), 1001)
    tracker.step(blob_shot.read(1002), 1002)
    tracker.correct(edit.set_key(tracker.shape, 1002, blob_shot.truth(1002)))
    tracker.step(blob_shot.read(1003), 1003)
    assert tracker.shape.artist_frames == (1001, 1002)
    fresh = Tracker(config)
    fresh.start(blob_shot.read(1002), blob_shot.shape(1002), 1002)
    fresh.step(blob_shot.read(1003), 1003)
    assert tracker.shape.at(1003).points.tobytes() == fresh.shape.at(1003).points.tobytes()


def test_a_second_step_to_a_frame_has_the_direction_of_the_first(config: str, blob_shot: Shot) -> None:
    for begun, frames in ((1001, (1002, 1003)), (1003, (1002, 1001))):
        tracker = Tracker(config)
        tracker.start(blob_shot.read(begun), blob_shot.shape(begun), begun)
        results = [tracker.step(blob_shot.read(frame), frame) for frame in (*frames, frames[-1])]
        directions = [result.key.inputs.partition(":")[0] for result in results if result.key is not None]
        assert directions == ["forward" if frames[-1] > begun else "backward"] * 3


def test_a_tracker_that_begins_between_keys_goes_back_as_a_run_does(config: str, blob_shot: Shot) -> None:
    shape = tracked(blob_shot, config)
    early, begun = shape.keys[:3], blob_shot.frames[5]
    shape = replace(shape, keys=(*early, Keyframe(blob_shot.frames[-1] + 4, early[-1].points + 15.0)))
    tracker = Tracker(config)
    tracker.start(blob_shot.read(begun), shape, begun)
    stepped = tracker.step(blob_shot.read(begun - 1), begun - 1).key
    *_, last = track(blob_shot.read, [shape], [begun, begun - 1], config)
    assert stepped is not None
    assert last.results[0].key is not None
    assert stepped.inputs == last.results[0].key.inputs
    np.testing.assert_array_equal(stepped.points, last.results[0].key.points)


def test_what_a_correction_moved_is_the_artists_whoever_made_its_key(config: str, blob_shot: Shot) -> None:
    tracker = Tracker(config)
    tracker.start(blob_shot.read(1001), blob_shot.shape(), 1001)
    tracker.step(blob_shot.read(1002), 1002)
    tracker.correct(tracker.shape)
    assert tracker.shape.artist_frames == (1001,)  # the engine's own outline, as it was
    key = tracker.shape.key_at(1002)
    assert key is not None
    tracker.correct(tracker.shape.with_key(replace(key, points=blob_shot.truth(1002))))
    assert tracker.shape.artist_frames == (1001, 1002)
    assert tracker.shape.key_at(1002) == Keyframe(1002, blob_shot.truth(1002))
    tracker.step(blob_shot.read(1003), 1003)
    before = tracker.shape
    again = [*track(blob_shot.read, [before], range(1001, 1004), config)][-1].results[0].shape
    assert again.key_at(1002) == before.key_at(1002)


def test_a_correction_without_a_key_on_the_frame_sets_one(config: str, blob_shot: Shot) -> None:
    tracker = Tracker(config)
    tracker.start(blob_shot.read(1001), blob_shot.shape(), 1001)
    tracker.step(blob_shot.read(1002), 1002)
    tracker.correct(blob_shot.shape())  # as on the frame before
    assert tracker.shape.artist_frames == (1001, 1002)
    ended = replace(blob_shot.shape(), lifetime=(1001, 1002))
    tracker.correct(ended)
    assert tracker.shape == ended


def test_the_feather_curve_rides_along_and_turns_with_the_outline(config: str, blob_shot: Shot) -> None:
    soft = np.full((6, 3, 2), 2.0)
    shape = RotoShape("a", "A", (Keyframe(1001, blob_shot.truth(1001), soft),))
    after = tracked(blob_shot, config, shape)
    assert len(after.keys) == len(blob_shot.frames)
    for key in after.keys:
        np.testing.assert_array_equal(key.feather, turned(soft, blob_shot.truth(1001), key.points))


def test_a_run_from_a_key_of_a_file_carries_on_the_feather_of_that_key(config: str, blob_shot: Shot) -> None:
    """It jumped back to that of the artist's key before."""
    soft, softer = np.full((6, 3, 2), 2.0), np.full((6, 3, 2), 6.0)
    read = Keyframe(1003, blob_shot.truth(1003), softer, origin=Origin.ENGINE, inputs=f"{IMPORT}::0123")
    shape = RotoShape("a", "A", (Keyframe(1001, blob_shot.truth(1001), soft), read))
    tracker = Tracker(config)
    tracker.start(blob_shot.read(1003), shape, 1003)
    for frame in (1004, 1005):
        key = tracker.step(blob_shot.read(frame), frame).key
        assert key is not None
        np.testing.assert_array_equal(key.feather, turned(softer, read.points, key.points))


# ---- what is refused, and what fails with a name ---------------------------------------------------------------------


def test_an_open_shape_is_refused(config: str, blob_shot: Shot) -> None:
    shape = RotoShape("a", "Arm", (Keyframe(1001, blob_shot.truth(1001)),), closed=False)
    with pytest.raises(RoamError, match="'Arm' is open; close it"):
        Tracker(config).start(blob_shot.read(1001), shape, 1001)


def test_a_single_point_is_refused(config: str, blob_shot: Shot) -> None:
    shape = RotoShape("a", "Dot", (Keyframe(1001, bezier.polygon_points([(50.0, 50.0)])),))
    with pytest.raises(RoamError, match="'Dot' is a single point; draw an outline"):
        Tracker(config).start(blob_shot.read(1001), shape, 1001)


def test_a_frame_of_another_size_is_refused(config: str, blob_shot: Shot) -> None:
    tracker = Tracker(config)
    tracker.start(blob_shot.read(1001), blob_shot.shape(), 1001)
    with pytest.raises(RoamError, match="Frame 1002 is 100x90, the one before 160x120"):
        tracker.step(np.zeros((90, 100, 3), np.uint8), 1002)
    assert tracker.frame == 1001


def test_a_step_without_a_start_is_a_mistake_of_the_program(config: str) -> None:
    with pytest.raises(RuntimeError, match="start"):
        Tracker(config).step(np.zeros((8, 8, 3), np.uint8), 1)


def test_a_cancelled_step_leaves_the_tracker_where_it_stood(config: str, blob_shot: Shot) -> None:
    tracker, token = Tracker(config), CancelToken()
    tracker.start(blob_shot.read(1001), blob_shot.shape(), 1001)
    tracker.step(blob_shot.read(1002), 1002)
    before = tracker.shape
    token.cancel()
    with pytest.raises(Cancelled):
        tracker.step(blob_shot.read(1003), 1003, token)
    assert tracker.frame == 1002
    assert tracker.shape is before
    resumed = tracker.step(blob_shot.read(1003), 1003).shape
    whole = tracked(blob_shot, config)
    assert resumed.at(1003).points.tobytes() == whole.at(1003).points.tobytes()


def test_a_missing_frame_is_bridged(config: str, blob_shot: Shot) -> None:
    tracker = Tracker(config)
    tracker.start(blob_shot.read(1001), blob_shot.shape(), 1001)
    skipped = tracker.skip(1002)
    assert skipped.termination is Termination.MISSING_FRAME
    assert skipped.key is None
    result = tracker.step(blob_shot.read(1003), 1003)
    assert result.shape.frames == (1001, 1003)
    assert outline_distance(result.shape.at(1003).points, blob_shot.truth(1003)) < 1.5


def test_a_shape_that_leaves_the_picture_is_doubted(config: str) -> None:
    shot = gliding(square(24.0), 9, (130.0, 60.0), (9.0, 0.5))
    tracker = Tracker(config)
    tracker.start(shot.read(shot.first), shot.shape(), shot.first)
    ends = [tracker.step(shot.read(frame), frame) for frame in shot.frames[1:]]
    assert all(np.isfinite(end.shape.at(end.frame).points).all() for end in ends)
    gone = [end for end in ends if shot.truth(end.frame)[..., 0].min() > shot.size[1]]
    assert len(gone) >= 2
    assert all(end.confidence < 0.8 for end in gone)
    assert ends[0].confidence > max(end.confidence for end in gone)


def test_a_shape_wholly_outside_has_left(config: str, blob_shot: Shot) -> None:
    shape = RotoShape("a", "A", (Keyframe(1001, blob_shot.truth(1001) + np.array([300.0, 0.0])),))
    tracker = Tracker(config)
    tracker.start(blob_shot.read(1001), shape, 1001)
    result = tracker.step(blob_shot.read(1002), 1002)
    assert result.termination is Termination.LEFT_FRAME
    assert result.confidence == 0.0


def test_an_object_of_sixteen_pixels(config: str) -> None:
    shot = gliding(square(16.0), 5, (40.0, 40.0), (1.5, 0.5), size=(80, 80))
    shape = tracked(shot, config)
    for frame in shot.frames:
        off = shape.at(frame).anchors.mean(axis=0) - shot.truth(frame)[:, ANCHOR].mean(axis=0)
        assert np.hypot(*off) < 2.5
        assert outline_distance(shape.at(frame).points, shot.truth(frame)) < 2.5


@pytest.mark.parametrize(
    "anchors",
    [
        [(40.0, 40.0)] * 3,
        [(40.0, 40.0), (60.0, 50.0)],
        [(-500.0, -500.0), (700.0, -500.0), (700.0, 600.0), (-500.0, 600.0)],
        [(20.0, 20.0), (60.0, 60.0), (60.0, 20.0), (20.0, 60.0)],
        [(-20.0, 30.0), (40.0, 30.0), (40.0, 80.0)],
        [(79.0, 59.0), (80.0, 59.0), (80.0, 60.0)],
    ],
    ids=["no extent", "two points", "larger than the picture", "crossing itself", "half outside", "tiny"],
)
def test_whatever_an_artist_draws_is_carried_on(
    config: str, blob_shot: Shot, anchors: list[tuple[float, float]]
) -> None:
    shape = RotoShape("a", "A", (Keyframe(1001, bezier.polygon_points(anchors)),))
    tracker = Tracker(config)
    tracker.start(blob_shot.read(1001), shape, 1001)
    for frame in (1002, 1003):
        result = tracker.step(blob_shot.read(frame), frame)
        assert np.isfinite(result.shape.at(frame).points).all()
        assert 0.0 <= result.confidence <= 1.0
        assert isinstance(result.termination, Termination)


@pytest.mark.parametrize("size", [(1, 1), (3, 5), (16, 16), (4, 300)])
@pytest.mark.parametrize("level", [0, 255])
def test_pictures_without_content_are_no_trouble(config: str, size: tuple[int, int], level: int) -> None:
    shape = RotoShape("a", "A", (Keyframe(1, bezier.polygon_points([(0.5, 0.5), (9.0, 1.0), (6.0, 9.0)])),))
    image = np.full((*size, 3), level, np.uint8)
    tracker = Tracker(config)
    tracker.start(image, shape, 1)
    assert np.isfinite(tracker.step(image, 2).shape.at(2).points).all()


def test_an_unknown_configuration_is_refused(config: str) -> None:
    assert params_for(config) is CONFIGS[config]
    assert params_for(CONFIGS[config]) is CONFIGS[config]
    with pytest.raises(RoamError, match=f"no configuration 'utmost'; choose from .*{config}"):
        Tracker("utmost")
    assert (scale_for((480, 854)), scale_for((1080, 1920)), scale_for((90, 120))) == (1.0, 2.25, 1.0)


@pytest.mark.parametrize("copied", [copy, deepcopy])
def test_copies_of_a_tracker_go_on_by_themselves(
    config: str, blob_shot: Shot, copied: Callable[[Tracker], Tracker]
) -> None:
    tracker = Tracker(config)
    tracker.start(blob_shot.read(1001), blob_shot.shape(), 1001)
    tracker.step(blob_shot.read(1002), 1002)
    astray, branch = copied(tracker), copied(tracker)
    for frame in (1005, 1001, 1004):
        astray.step(blob_shot.read(frame), frame)
    assert (tracker.frame, branch.frame, astray.frame) == (1002, 1002, 1004)
    whole = tracked(blob_shot, config)
    for each in (tracker, branch):
        for frame in blob_shot.frames[2:]:
            each.step(blob_shot.read(frame), frame)
        assert each.shape == whole


def test_a_tracker_is_pickled_until_it_is_started(config: str, blob_shot: Shot) -> None:
    tracker = pickle.loads(pickle.dumps(Tracker(config)))  # noqa: S301
    tracker.start(blob_shot.read(1001), blob_shot.shape(), 1001)
    assert tracker.params == CONFIGS[config]
    with pytest.raises(TypeError, match=r"a Tracker that was started is not pickled: .* roam_core.track"):
        pickle.dumps(tracker)
