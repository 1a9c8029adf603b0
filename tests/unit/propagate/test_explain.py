"""Explaining a key: the pieces are the energies that tracking reported, and the cues the ones that were added."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import numpy.testing as npt
import pytest

from roam_core.errors import RoamError
from roam_core.features import PreparedFrame
from roam_core.media.source import MissingFrame
from roam_core.propagate import FrameResult, Tracker, track
from roam_core.propagate.between.span import fill_span
from roam_core.propagate.engines.protocol import REGION
from roam_core.propagate.explain import Explanation, explain
from roam_core.roto import BlendMode, Keyframe, Origin, RotoShape
from tests.golden.shots import Shot

LAST = 1004
NAMES = {"landmarks": "landmark"}
"""What a term of the oracle is called where it is told by piece."""


def solved(shot: Shot, shapes: list[RotoShape], config: str, frames: range = range(1001, LAST + 1)) -> FrameResult:
    """The last frame of a run."""
    *_, last = track(shot.read, shapes, frames, config)
    return last


def explained(shot: Shot, shapes: list[RotoShape], frame: int = LAST) -> list[Explanation]:
    return explain(lambda number: PreparedFrame(shot.read(number)), shapes, frame, None)


@pytest.mark.parametrize("config", ["baseline", "lean", "medium", "full"])
def test_the_pieces_sum_to_the_energies_that_tracking_reported(blob_shot: Shot, config: str) -> None:
    (result,) = solved(blob_shot, [blob_shot.shape()], config).results
    (told,) = explained(blob_shot, [result.shape])
    assert (told.config, told.apart) == (config, 0.0)
    reported = {NAMES.get(name, name): value for name, value in result.energies.items()}
    assert told.account.sums == pytest.approx({k: v for k, v in reported.items() if k != "total"}, abs=1e-6)
    assert told.account.total.sum() + told.account.landmark_total.sum() == pytest.approx(reported["total"], abs=1e-6)
    assert told.account.terms["gradient"].shape == told.account.t.shape == (len(told.account.nodes),)
    if config in ("medium", "full"):
        assert told.account.landmarks is not None
        assert len(told.account.landmarks.ids) == len(told.account.landmarks.positions) > 0
        assert len(set(told.account.landmarks.ids)) == len(told.account.landmarks.ids)
    else:
        assert told.account.landmarks is None


@pytest.mark.parametrize("config", ["baseline", "lean", "medium", "full"])
def test_a_run_that_left_frames_out_is_explained_through_those_that_it_went(blob_shot: Shot, config: str) -> None:
    (result,) = solved(blob_shot, [blob_shot.shape()], config, range(1001, 1006, 2)).results
    (told,) = explained(blob_shot, [result.shape], 1005)
    assert told.apart == 0.0
    reported = {NAMES.get(name, name): value for name, value in result.energies.items()}
    assert told.account.sums == pytest.approx({k: v for k, v in reported.items() if k != "total"}, abs=1e-6)


def test_keys_that_were_deleted_since_do_not_hide_that_a_run_went_over_their_frames(blob_shot: Shot) -> None:
    (result,) = solved(blob_shot, [blob_shot.shape()], "lean").results
    thinned = replace(result.shape, keys=tuple(key for key in result.shape.keys if key.frame in (1001, LAST)))
    (told,) = explained(blob_shot, [thinned])
    assert told.apart == 0.0


@pytest.mark.parametrize("config", ["lean", "best"])
def test_a_frame_that_was_stepped_to_twice_is_explained(blob_shot: Shot, config: str) -> None:
    tracker = Tracker(config)
    tracker.start(blob_shot.read(1001), blob_shot.shape(), 1001)
    for frame in (1002, 1003, 1003):
        tracker.step(blob_shot.read(frame), frame)
    (told,) = explained(blob_shot, [tracker.shape], 1003)
    assert (told.config, told.key.frame) == (config, 1003)
    assert told.account.terms


def test_the_cues_speak_for_the_object_inside_and_against_it_outside(blob_shot: Shot) -> None:
    (result,) = solved(blob_shot, [blob_shot.shape()], "best").results
    (told,) = explained(blob_shot, [result.shape])
    assert told.apart == 0.0
    assert told.account.more_is_better
    assert set(told.account.sides) == {
        "local",
        "key",
        "global",
        "motion",
        "prior",
        "bias",
        "background",
        "texture",
        "lineage",
        "patches",
        REGION,
    }
    inside, outside = told.account.sides[REGION]
    assert (inside > 0).mean() > 0.95
    assert (outside < 0).mean() > 0.95
    npt.assert_array_equal(told.account.terms["key"], told.account.sides["key"][0] - told.account.sides["key"][1])
    npt.assert_allclose(told.account.total, sum(v for name, v in told.account.terms.items() if name != REGION))
    assert np.abs(told.account.terms["bias"]).max() <= 0.2  # on both sides the same, but for how much of it is heard


def test_at_a_hole_the_object_lies_outside(blob_shot: Shot) -> None:
    def small(points: np.ndarray) -> np.ndarray:
        return points.mean(axis=(0, 1)) + 0.3 * (points - points.mean(axis=(0, 1)))

    hole = replace(blob_shot.shape(shape_id="hole"), blend=BlendMode.SUBTRACT).map_points(small)
    # As one through which something else is seen, and by its region, not its pose.
    by_region = "best+region.hole_own=3+region.pose_unlike=0.01"
    last = solved(blob_shot, [blob_shot.shape(), hole], by_region)
    body, cut = explained(blob_shot, [result.shape for result in last.results])
    assert (body.apart, cut.apart) == (0.0, 0.0)
    inside, outside = cut.account.sides["prior"]
    npt.assert_array_equal(cut.account.terms["prior"], outside - inside)
    assert np.abs(cut.account.terms["prior"]).max() > 0
    assert body.account.terms["prior"].mean() > 0


def test_an_artists_key_is_the_artists(blob_shot: Shot) -> None:
    (told,) = explained(blob_shot, [blob_shot.shape()], 1001)
    assert told.key.origin is Origin.ARTIST
    assert (told.config, told.account.terms, told.account.sides, told.account.landmarks) == ("", {}, {}, None)
    assert len(told.account.nodes) > told.shape.point_count


def test_a_run_backward_and_over_a_correction_is_explained_from_its_own_key(blob_shot: Shot) -> None:
    shape = blob_shot.shape(1006).with_key(Keyframe(1004, blob_shot.truth(1004)))
    (result,) = solved(blob_shot, [shape], "lean", range(1006, 1001, -1)).results
    (told,) = explained(blob_shot, [result.shape], 1002)
    assert told.apart == 0.0
    assert told.account.sums == pytest.approx({k: v for k, v in result.energies.items() if k != "total"}, abs=1e-6)


def test_a_filled_key_tells_how_far_the_run_from_the_nearer_key_is(blob_shot: Shot) -> None:
    shape = blob_shot.shape().with_key(Keyframe(1005, blob_shot.truth(1005)))
    (filled,) = fill_span({n: blob_shot.read(n) for n in blob_shot.frames}, [shape], 1001, 1005)
    (told,) = explained(blob_shot, [filled], 1002)
    assert told.config == "best"
    (run,) = solved(blob_shot, [shape], "best", range(1001, 1003)).results
    apart = filled.at(1002).points - run.shape.at(1002).points
    assert told.apart == pytest.approx(np.hypot(*apart.reshape(-1, 2).T).max())
    assert told.apart > 0.0
    assert REGION in told.account.terms


def test_a_frame_filled_from_its_farther_key_is_explained_from_there(blob_shot: Shot) -> None:
    """The nearer key lies on a black frame: nothing was learned there."""
    pictures = {n: blob_shot.read(n) for n in blob_shot.frames}
    pictures[1005] = np.zeros_like(pictures[1005])
    shape = blob_shot.shape().with_key(Keyframe(1005, blob_shot.truth(1005)))
    (filled,) = fill_span(pictures, [shape], 1001, 1005)
    (told,) = explain(lambda frame: PreparedFrame(pictures[frame]), [filled], 1004, None)
    (run,) = solved(blob_shot, [shape], "best", range(1001, 1005)).results
    apart = filled.at(1004).points - run.shape.at(1004).points
    assert told.apart == pytest.approx(np.hypot(*apart.reshape(-1, 2).T).max())


def test_pictures_of_keys_are_looked_at_once_for_all_shapes_and_one_that_went_is_named(blob_shot: Shot) -> None:
    ends = replace(blob_shot.shape(), lifetime=(1001, 1004))  # it has no key on the other end
    both = blob_shot.shape().with_key(Keyframe(1005, blob_shot.truth(1005)))
    apart = [replace(each, id=name, link=name) for name, each in (("a", both), ("b", both), ("c", ends))]
    filled = fill_span({n: blob_shot.read(n) for n in blob_shot.frames}, apart, 1001, 1005)
    asked: list[int] = []

    def read(frame: int) -> PreparedFrame:
        asked.append(frame)
        if frame == 1001 and is_gone:
            raise MissingFrame("frame 1001 is missing")
        return PreparedFrame(blob_shot.read(frame))

    is_gone = False
    assert [told.shape.id for told in explain(read, filled, 1004, None)] == ["a", "b"]
    assert asked.count(1001) == 2  # whether it shows something, and the kinds of edge there
    is_gone = True
    with pytest.raises(MissingFrame, match="1001"):
        explain(read, filled, 1003, None)


def test_a_shape_that_left_the_picture_has_no_terms(blob_shot: Shot) -> None:
    away = blob_shot.shape().map_points(lambda points: points - 400.0)
    (result,) = solved(blob_shot, [away], "lean").results
    (told,) = explained(blob_shot, [result.shape])
    assert (told.config, told.account.terms) == ("lean", {})


def test_shapes_without_a_key_there_are_left_out(blob_shot: Shot) -> None:
    assert explained(blob_shot, [blob_shot.shape(1002)], 1001) == []


def test_a_key_that_is_out_of_date_is_refused(blob_shot: Shot) -> None:
    (result,) = solved(blob_shot, [blob_shot.shape()], "baseline").results
    changed = result.shape.with_key(Keyframe(1001, blob_shot.truth(1001) + 1.0))
    with pytest.raises(RoamError, match="on frame 1004 is out of date"):
        explained(blob_shot, [changed])


def test_a_key_of_an_unknown_configuration_is_refused(blob_shot: Shot) -> None:
    alien = Keyframe(LAST, blob_shot.truth(LAST), origin=Origin.ENGINE, inputs="forward:superb:0123")
    with pytest.raises(RoamError, match="does not say which configuration"):
        explained(blob_shot, [blob_shot.shape().with_key(alien)])
