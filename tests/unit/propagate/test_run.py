"""Many frames: both directions, several shapes, gaps, cancelling, and the same bits in another process."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from roam_core.arrays import UInt8
from roam_core.cancel import Cancelled, CancelToken
from roam_core.errors import RoamError
from roam_core.media import MissingFrame
from roam_core.params import CONFIGS, OBJECTS
from roam_core.propagate import FrameResult, Termination, TrackMemory, fill_span, track
from roam_core.propagate.shapes import provenance
from roam_core.propagate.shapes.objects import objects
from roam_core.roto import BlendMode, Keyframe, Origin, Project, RotoShape, edit, file
from tests.conftest import ROOT
from tests.golden.shots import Shot, blob, gliding, outline_distance

pytestmark = pytest.mark.parametrize("config", list(CONFIGS))


def last(results: list[FrameResult]) -> RotoShape:
    return results[-1].results[0].shape


def test_every_frame_after_the_first_gives_a_result(config: str, blob_shot: Shot) -> None:
    results = list(track(blob_shot.read, [blob_shot.shape()], blob_shot.frames, config))
    assert [result.frame for result in results] == list(blob_shot.frames[1:])
    assert last(results).frames == tuple(blob_shot.frames)
    assert last(results).artist_frames == (1001,)


def test_forward_through_the_reversed_clip_is_backward_bit_by_bit(config: str, blob_shot: Shot) -> None:
    first, end = blob_shot.frames[0], blob_shot.frames[-1]
    backward = last(list(track(blob_shot.read, [blob_shot.shape(end)], blob_shot.frames[::-1], config)))
    mirrored = blob_shot.reversed()
    forward = last(list(track(mirrored.read, [mirrored.shape()], mirrored.frames, config)))
    for frame in blob_shot.frames:
        ours, twin = backward.key_at(frame), forward.key_at(first + end - frame)
        assert ours is not None
        assert twin is not None
        assert ours.points.tobytes() == twin.points.tobytes()
        assert ours.confidence == twin.confidence
    for frame in blob_shot.frames:
        assert outline_distance(backward.at(frame).points, blob_shot.truth(frame)) < 1.0


def test_frames_may_be_a_list(config: str, blob_shot: Shot) -> None:
    frames, shapes = list(blob_shot.frames), [blob_shot.shape()]
    one, other = (list(track(blob_shot.read, shapes, each, config)) for each in (blob_shot.frames, frames))
    assert [result.frame for result in other] == frames[1:]
    assert one[-1].results[0].shape == other[-1].results[0].shape
    with pytest.raises(RoamError, match="no frame to track"):
        list(track(blob_shot.read, shapes, [], config))


def test_shapes_far_apart_are_what_each_is_alone(config: str, blob_shot: Shot) -> None:
    shapes = [
        blob_shot.shape(),
        RotoShape("shape-2", "B", (Keyframe(1001, blob([4.0, 5.0, 4.0]) + np.array([8.0, 112.0])),)),
        RotoShape("shape-3", "C", (Keyframe(1001, blob([5.0, 4.0, 5.0, 4.0]) + np.array([150.0, 8.0])),)),
    ]
    assert len(objects(shapes, OBJECTS.near)) == 3
    together = list(track(blob_shot.read, shapes, blob_shot.frames[:4], config))[-1].results
    for shape, result in zip(shapes, together, strict=True):
        assert result.shape == last(list(track(blob_shot.read, [shape], blob_shot.frames[:4], config)))


def test_a_run_in_two_parts_is_a_run_in_one(config: str, blob_shot: Shot) -> None:
    """What a resumed run starts from is the key on its frame, not what the engine happened to remember."""
    key = blob_shot.shape(1003).keys[0]
    whole = last(list(track(blob_shot.read, [blob_shot.shape().with_key(key)], blob_shot.frames, config)))
    part = last(list(track(blob_shot.read, [blob_shot.shape().with_key(key)], blob_shot.frames[:3], config)))
    rest = last(list(track(blob_shot.read, [part], blob_shot.frames[2:], config)))
    assert rest == whole


@pytest.mark.parametrize("remembering", [True, False])
def test_a_run_stopped_on_an_engine_frame_goes_on_as_if_it_had_not_been(
    config: str, blob_shot: Shot, remembering: bool
) -> None:
    memory = TrackMemory() if remembering else None
    whole = last(list(track(blob_shot.read, [blob_shot.shape()], blob_shot.frames, config)))
    part = last(list(track(blob_shot.read, [blob_shot.shape()], blob_shot.frames[:3], config, memory=memory)))
    rest = last(list(track(blob_shot.read, [part], blob_shot.frames[2:], config, memory=memory)))
    assert rest == whole


def test_a_gap_in_the_plate_is_passed_over(config: str, blob_shot: Shot) -> None:
    def read(frame: int) -> UInt8:
        if frame == 1003:
            raise MissingFrame("Frame 1003 is missing.")
        return blob_shot.read(frame)

    results = list(track(read, [blob_shot.shape()], blob_shot.frames, config))
    assert [result.frame for result in results] == list(blob_shot.frames[1:])
    assert results[1].results[0].termination is Termination.MISSING_FRAME
    assert last(results).frames == (1001, 1002, 1004, 1005, 1006)
    assert outline_distance(last(results).at(1004).points, blob_shot.truth(1004)) < 1.5


@pytest.mark.parametrize("value", [0, 255], ids=["black", "white"])
def test_a_frame_that_shows_nothing_is_passed_over_like_a_gap(config: str, blob_shot: Shot, value: int) -> None:
    def read(frame: int) -> UInt8:
        return np.full_like(blob_shot.read(frame), value) if frame in (1003, 1004) else blob_shot.read(frame)

    results = list(track(read, [blob_shot.shape()], blob_shot.frames, config))
    ends = [result.results[0].termination for result in results]
    assert [end is Termination.MISSING_FRAME for end in ends] == [False, True, True, False, False]
    assert last(results).frames == (1001, 1002, 1005, 1006)
    assert outline_distance(last(results).at(1005).points, blob_shot.truth(1005)) < 1.5
    stopped = last(results[:2])
    with pytest.raises(MissingFrame, match="1003 shows nothing"):
        next(track(read, [stopped], blob_shot.frames[2:], config))
    again = list(track(read, [stopped], blob_shot.frames[1:], config))
    assert last(again) == last(results)


def test_a_shape_gets_no_keys_where_it_does_not_exist(config: str, blob_shot: Shot) -> None:
    shape = replace(blob_shot.shape(), lifetime=(1001, 1004))
    results = list(track(blob_shot.read, [shape], blob_shot.frames, config))
    assert [result.frame for result in results] == list(blob_shot.frames[1:])
    assert last(results).frames == (1001, 1002, 1003)
    assert results[-1].results[0].confidence == 1.0
    ends = [result.results[0].termination is Termination.OUTSIDE_LIFETIME for result in results]
    assert ends == [frame >= 1004 for frame in blob_shot.frames[1:]]


def test_a_shape_that_subtracts_from_nothing_is_followed_like_one_that_adds(config: str, blob_shot: Shot) -> None:
    """A holdout on a layer of its own, far from all that it cuts."""
    shape = blob_shot.shape()
    runs = [
        last(list(track(blob_shot.read, iter([replace(shape, blend=blend)]), iter(blob_shot.frames), config)))
        for blend in (BlendMode.ADD, BlendMode.SUBTRACT)
    ]
    for frame in blob_shot.frames:
        assert runs[0].at(frame).points.tobytes() == runs[1].at(frame).points.tobytes()


def test_an_artists_key_on_a_frame_that_shows_nothing_stays_and_teaches_nothing(config: str, blob_shot: Shot) -> None:
    """A flash, or a dropped frame, keyed by hand: what is tracked on from there goes by the look of the key before."""

    def read(frame: int) -> UInt8:
        return np.zeros_like(blob_shot.read(frame)) if frame == 1003 else blob_shot.read(frame)

    key = Keyframe(1003, blob_shot.truth(1003))
    results = list(track(read, [blob_shot.shape().with_key(key)], blob_shot.frames, config))
    assert results[1].results[0].termination is Termination.ARTIST_KEY
    shape = last(results)
    assert shape.key_at(1003) == key
    for frame in (1002, 1004, 1005):
        assert outline_distance(shape.at(frame).points, blob_shot.truth(frame)) < 1.5
        made = shape.key_at(frame)
        assert made is not None
        assert not provenance.is_stale(shape, made, None)
    stopped = last(results[:2])
    assert last(list(track(read, [stopped], blob_shot.frames[2:], config))) == shape
    assert last(list(track(read, [stopped], blob_shot.frames[1:], config))) == shape


@pytest.mark.parametrize("value", [0, 255], ids=["black", "white"])
def test_nothing_is_trusted_while_nothing_was_ever_seen(config: str, blob_shot: Shot, value: int) -> None:
    """An artist's key may lie on a frame that shows nothing; the next ones are carried on from it, unseen."""

    def read(frame: int) -> UInt8:
        return np.full_like(blob_shot.read(frame), value) if frame < 1004 else blob_shot.read(frame)

    shape = blob_shot.shape()
    for result in list(track(read, [shape], blob_shot.frames[:3], config)):
        [each] = result.results
        assert (each.confidence, each.termination) == (0.0, Termination.LOW_CONFIDENCE)
        key = each.key
        assert key is not None
        assert key.confidence == 0.0
        assert key.vertex_confidence is not None
        assert not key.vertex_confidence.any()
    ends = shape.with_key(Keyframe(1003, blob_shot.truth(1003)))
    pictures = {frame: read(frame) for frame in blob_shot.frames[:3]}
    [filled] = fill_span(pictures, [ends], 1001, 1003, config)
    [key] = [key for key in filled.keys if key.frame == 1002]
    assert key.confidence is not None
    assert key.confidence < 0.1


def test_a_faint_picture_is_not_taken_for_one_that_shows_nothing(config: str, blob_shot: Shot) -> None:
    """Seven levels from the darkest to the brightest: all that is followed there is trusted as it was."""

    def read(frame: int) -> UInt8:
        return np.uint8(20.0 + np.round(blob_shot.read(frame) * (7.0 / 255.0)))

    results = [result.results[0] for result in track(read, [blob_shot.shape()], blob_shot.frames[:3], config)]
    assert all(each.confidence > 0.0 for each in results)


def test_a_missing_first_frame_is_an_error(config: str, blob_shot: Shot) -> None:
    def read(frame: int) -> UInt8:
        raise MissingFrame(f"Frame {frame} is missing.")

    with pytest.raises(MissingFrame, match="1001"):
        next(track(read, [blob_shot.shape()], blob_shot.frames, config))


def test_an_unreadable_frame_ends_the_run_with_what_is_finished(config: str, blob_shot: Shot) -> None:
    def read(frame: int) -> UInt8:
        if frame == 1004:
            raise RoamError("Frame 1004 cannot be decoded.")
        return blob_shot.read(frame)

    run = track(read, [blob_shot.shape()], blob_shot.frames, config)
    finished = [next(run), next(run)]
    with pytest.raises(RoamError, match="1004"):
        next(run)
    assert [result.frame for result in finished] == [1002, 1003]


def test_a_mapping_that_lacks_a_frame_is_told_in_a_sentence(config: str, blob_shot: Shot) -> None:
    pictures = {frame: blob_shot.read(frame) for frame in (1001, 1002)}
    for frames in ((1001, 1002, 1003), (1003, 1002)):
        with pytest.raises(RoamError, match="There is no image of frame 1003; give one, or raise MissingFrame"):
            list(track(pictures.__getitem__, [blob_shot.shape()], frames, config))

    def read(frame: int) -> UInt8:
        return {"wrong": pictures[1001]}[f"{frame}"]

    with pytest.raises(KeyError, match="1001"):  # a defect of the caller's stays one
        list(track(read, [blob_shot.shape()], (1001, 1002), config))


def test_cancelling_keeps_the_finished_frames(config: str, blob_shot: Shot) -> None:
    token = CancelToken()
    run = track(blob_shot.read, [blob_shot.shape()], blob_shot.frames, config, token)
    finished = [next(run), next(run)]
    token.cancel()
    with pytest.raises(Cancelled):
        next(run)
    assert [result.frame for result in finished] == [1002, 1003]
    whole = last(list(track(blob_shot.read, [blob_shot.shape()], blob_shot.frames, config)))
    assert finished[-1].results[0].shape.at(1003).points.tobytes() == whole.at(1003).points.tobytes()


def test_a_cancelled_token_reads_no_further_frame(config: str, blob_shot: Shot) -> None:
    token, asked = CancelToken(), []

    def read(frame: int) -> UInt8:
        asked.append(frame)
        return blob_shot.read(frame)

    token.cancel()
    with pytest.raises(Cancelled):
        next(track(read, [blob_shot.shape()], blob_shot.frames, config, token))
    assert asked == [1001]


def test_a_still_picture_holds_the_shape(config: str) -> None:
    shot = gliding(blob([26.0, 24.0, 22.0, 25.0, 28.0]), 6, (80.0, 60.0), (0.0, 0.0))
    shape = last(list(track(shot.read, [shot.shape()], shot.frames, config)))
    for frame in shot.frames:
        assert outline_distance(shape.at(frame).points, shot.truth(frame)) < 1.0


def test_nothing_to_track_is_refused(config: str, blob_shot: Shot) -> None:
    with pytest.raises(RoamError, match="no shape to track; draw one"):
        next(track(blob_shot.read, [], blob_shot.frames, config))


@pytest.mark.parametrize("frames", [(1001, 1003, 1002), (1001, 1001, 1002), (1003, 1001, 1002), (1001, 1002, 1001)])
def test_frames_that_neither_rise_nor_fall_are_refused(config: str, frames: tuple[int, ...], blob_shot: Shot) -> None:
    with pytest.raises(ValueError, match="rise or fall"):
        next(track(blob_shot.read, [blob_shot.shape(frames[0])], frames, config))


def test_of_two_shapes_of_one_id_each_goes_on_as_if_it_had_not_been_stopped(config: str, blob_shot: Shot) -> None:
    """Masks made apart give equal ids: the keys of the first were taken for those of the last, and so for stale."""
    one = blob_shot.shape()
    shapes = [one, replace(one, keys=(Keyframe(1001, blob([4.0, 5.0, 4.0]) + np.array([8.0, 112.0])),))]
    *_, whole = track(blob_shot.read, shapes, blob_shot.frames, config)
    *_, stopped = track(blob_shot.read, shapes, blob_shot.frames[:3], config)
    known = [result.shape for result in stopped.results]
    *_, after = track(blob_shot.read, known, blob_shot.frames[2:], config)
    assert [result.shape for result in after.results] == [result.shape for result in whole.results]
    stamps = provenance.Stamps(known, "", blob_shot.size)
    assert [stamps.stale_frames(shape) for shape in known] == [[], []]


@pytest.mark.parametrize("frames", [(1001, 1003, 1004, 1006), (1006, 1004, 1003, 1001)])
def test_a_run_that_leaves_frames_out_goes_on_as_if_it_had_not_been_stopped(
    config: str, frames: tuple[int, ...], blob_shot: Shot
) -> None:
    pictures = {frame: blob_shot.read(frame) for frame in frames}
    whole = list(track(pictures, [blob_shot.shape(frames[0])], frames, config))
    rest = last(list(track(pictures, [whole[0].results[0].shape], frames[1:], config)))
    assert rest == last(whole)


def test_one_frame_is_a_run_of_none(config: str, blob_shot: Shot) -> None:
    assert list(track(blob_shot.read, [blob_shot.shape()], blob_shot.frames[:1], config)) == []


# ---- the same bits in another process --------------------------------------------------------------------------------


@cache
def tracked_digest(config: str) -> str:
    """Digest of a project tracked from scratch: what a second process has to come to as well."""
    shot = gliding(blob([26.0, 20.0, 22.0, 28.0]), 5, (60.0, 60.0), (1.7, -0.9), drift=(-0.5, 0.3))
    project = edit.add_shape(Project(), shot.shape())
    for result in track(shot.read, project.shapes, shot.frames, config):
        project = project.with_shape(result.results[0].shape)
    assert [key.origin for key in project.shapes[0].keys] == [Origin.ARTIST] + [Origin.ENGINE] * 4
    return file.digest(project)


PROGRAM = """
import json
from roam_core.params import CONFIGS
from tests.unit.propagate.test_run import tracked_digest
print(json.dumps({config: tracked_digest(config) for config in CONFIGS}))
"""


@cache
def digests_elsewhere(hash_seed: str) -> dict[str, str]:
    """What one other process comes to, with every configuration."""
    answer = subprocess.run(
        [sys.executable, "-c", PROGRAM],
        env=os.environ | {"PYTHONHASHSEED": hash_seed},
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    digests: dict[str, str] = json.loads(answer.stdout)
    return digests


@pytest.mark.parametrize("hash_seed", ["1", "4242"])
def test_other_processes_give_the_same_bits(config: str, hash_seed: str) -> None:
    assert digests_elsewhere(hash_seed)[config] == tracked_digest(config)
