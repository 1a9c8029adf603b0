"""Fewest keys: as few as brute force finds, within the tolerance, the artist's always among them."""

from __future__ import annotations

from itertools import combinations, pairwise

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.cancel import Cancelled, CancelToken
from roam_core.errors import RoamError
from roam_core.interchange import ExportOptions, KeyChoice
from roam_core.interchange.keys.reduction import Motion, fewest, reduced
from roam_core.interchange.nuke.exporter import roto_document
from roam_core.interchange.silhouette.exporter import silhouette_document
from roam_core.roto import Interpolation, Keyframe, Layer, Origin, Project, RotoShape
from tests.golden.shots import blob
from tests.reference.key_spans import ref_span_error
from tests.unit.interchange import nuke_judge, silhouette_judge
from tests.unit.interchange.conftest import CLIP
from tests.unit.interchange.judged import farthest

ROUND = blob([30.0, 22.0, 26.0, 34.0, 20.0]) + 200.0


def tracked(frames: int, shiver: float = 0.0, artist: tuple[int, ...] = (1001,), seed: int = 0) -> RotoShape:
    """A shape that swings, turns and breathes, with a key of the engine's on every frame."""
    rng = np.random.default_rng(seed)
    keys = []
    for index in range(frames):
        angle = 0.02 * index
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        points = (ROUND - 200.0) * (1.0 + 0.1 * np.sin(index / 9)) @ turn.T + 200.0
        points = points + np.array([40 * np.sin(index / 11), 3.0 * index]) + rng.normal(0, shiver, (len(ROUND), 1, 2))
        origin = Origin.ARTIST if 1001 + index in artist else Origin.ENGINE
        keys.append(Keyframe(1001 + index, points, origin=origin))
    return RotoShape("shape-1", "Tracked", tuple(keys))


def brute_force(samples: Array, tolerance: float, *, cubic: bool) -> tuple[int, float]:
    """The fewest keys, and of those choices the smallest largest error, over every subset of frames."""
    last = len(samples) - 1
    for inner in range(last):
        best = np.inf
        for chosen in combinations(range(1, last), inner):
            spans = pairwise((0, *chosen, last))
            best = min(best, max(ref_span_error(samples, True, a, b, cubic=cubic) for a, b in spans))
        if best <= tolerance:
            return inner + 2, best
    raise AssertionError("a key on every frame has no error")


@pytest.mark.parametrize("motion", Motion)
@pytest.mark.parametrize("seed", range(4))
def test_as_few_as_brute_force_finds(motion: Motion, seed: int) -> None:
    rng = np.random.default_rng(seed)
    ring = np.stack([np.cos(np.arange(6.0)), np.sin(np.arange(6.0))], axis=1) * 20
    samples = ring + np.cumsum(rng.normal(0, 1.0, (8, 1, 1, 2)), axis=0) + rng.normal(0, 0.2, (8, 1, 6, 2))
    chosen = fewest(samples, True, 0.8, motion)
    worst = max(ref_span_error(samples, True, a, b, cubic=motion is Motion.CUBIC) for a, b in pairwise(chosen))
    assert (len(chosen), pytest.approx(worst, abs=1e-9)) == brute_force(samples, 0.8, cubic=motion is Motion.CUBIC)


def test_the_outline_stays_within_the_tolerance_on_every_frame() -> None:
    shape = tracked(60, shiver=0.05)
    reduction = reduced(shape, 0.5)
    assert len(reduction.shape.keys) < 20
    strays = [farthest(reduction.shape.at(frame).points, shape.at(frame).points) for frame in range(1001, 1061)]
    assert 0.25 < max(strays) <= 0.5 + 0.05  # between the places that were compared
    assert reduction.max_error <= 0.5
    assert 0.0 < reduction.mean_error < reduction.max_error
    assert (reduction.before, reduction.slopes) == (60, ())


def test_a_cubic_needs_fewer_keys_than_a_straight_line() -> None:
    shape = tracked(60)
    assert len(reduced(shape, 0.25, Motion.CUBIC).shape.keys) < len(reduced(shape, 0.25).shape.keys)


def test_keys_of_the_artist_stay_and_are_themselves() -> None:
    shape = tracked(40, artist=(1001, 1007, 1008, 1031))
    reduction = reduced(shape, 5.0)
    assert {1001, 1007, 1008, 1031, 1040} <= set(reduction.shape.frames)
    for frame in shape.artist_frames:
        assert reduction.shape.key_at(frame) == shape.key_at(frame)


def test_held_spans_stay_held() -> None:
    keys = [Keyframe(frame, ROUND + 9.0 * frame, origin=Origin.ENGINE) for frame in range(1, 8)]
    held = Keyframe(8, ROUND, origin=Origin.ENGINE, interpolation=Interpolation.HOLD)
    shape = RotoShape("shape-1", "Held", (*keys, held, Keyframe(20, ROUND + 5.0, origin=Origin.ENGINE)))
    for motion in Motion:
        reduction = reduced(shape, 0.1, motion)
        assert reduction.shape.frames == (1, 7, 8, 20)
        assert reduction.shape.key_at(8) == held
        assert reduction.max_error < 1e-9


def test_a_feather_curve_is_kept_within_the_tolerance_too() -> None:
    offsets = np.zeros_like(ROUND)
    offsets[2] = 10.0
    keys = [Keyframe(f, ROUND, offsets * np.sin(f / 5.0) ** 2, Origin.ENGINE) for f in range(30)]
    reduction = reduced(RotoShape("shape-1", "Soft", tuple(keys)), 0.5)
    assert 2 < len(reduction.shape.keys) < 30


def test_a_smooth_span_becomes_straight_ones() -> None:
    keys = (Keyframe(1, ROUND, interpolation=Interpolation.SMOOTH), Keyframe(41, ROUND + 100.0))
    shape = RotoShape("shape-1", "Eased", keys)
    reduction = reduced(shape, 0.5)
    assert {key.interpolation for key in reduction.shape.keys} == {Interpolation.LINEAR}
    assert len(reduction.shape.keys) > 3
    assert [key.origin for key in reduction.shape.keys[1:-1]] == [Origin.ENGINE] * (len(reduction.shape.keys) - 2)


@pytest.mark.parametrize("motion", [Motion.CUBIC, Motion.EASED])
def test_a_smooth_span_stays_one_where_the_target_moves_so(motion: Motion) -> None:
    """Fast motion strays from straight steps between frames: it got keys on frames where the artist had none."""
    keys = (
        Keyframe(1, ROUND, interpolation=Interpolation.SMOOTH),
        Keyframe(9, ROUND + 200.0, interpolation=Interpolation.SMOOTH),
        Keyframe(12, ROUND),
    )
    shape = RotoShape("shape-1", "Eased", keys)
    reduction = reduced(shape, 0.05, motion)
    assert reduction.shape.frames == shape.frames
    assert reduction.max_error == 0.0
    for frame in np.arange(1.0, 12.01, 0.25):
        np.testing.assert_array_equal(reduction.shape.at(frame).points, shape.at(frame).points)


def test_nuke_gets_a_smooth_span_as_it_is() -> None:
    keys = (Keyframe(1001, ROUND, interpolation=Interpolation.SMOOTH), Keyframe(1009, ROUND + 200.0))
    shape = RotoShape("shape-1", "Eased", keys)
    text, _ = roto_document(
        Project(CLIP, Layer("root", "Root", (shape,))), ExportOptions(keys=KeyChoice.REDUCED, tolerance=0.05)
    )
    (written,) = nuke_judge.judge(text).root.shapes()
    assert len(written.times) == 2
    assert farthest(written.points(1003.5), shape.at(1003.5).points) < 0.01


def test_one_key_stays_one_key() -> None:
    shape = RotoShape("shape-1", "Still", (Keyframe(7, ROUND),))
    for motion in Motion:
        assert reduced(shape, 0.5, motion).shape == shape


@pytest.mark.parametrize("tolerance", [0.0, -1.0, float("nan"), float("inf")])
def test_a_senseless_tolerance_is_refused(tolerance: float) -> None:
    with pytest.raises(RoamError, match="tolerance"):
        reduced(tracked(3), tolerance)


def test_a_reduction_can_be_cancelled() -> None:
    token = CancelToken()
    token.cancel()
    with pytest.raises(Cancelled):
        reduced(tracked(3), 0.5, token=token)


def test_nuke_gets_the_slopes_and_moves_as_promised() -> None:
    soft = tuple(
        Keyframe(key.frame, key.points, np.full_like(key.points, np.sin(key.frame / 7.0)), key.origin)
        for key in tracked(50).keys
    )
    shape = RotoShape("shape-1", "Tracked", soft)
    options = ExportOptions(keys=KeyChoice.REDUCED, tolerance=0.3)
    text, notes = roto_document(Project(CLIP, Layer("root", "Root", (shape,))), options)
    (written,) = nuke_judge.judge(text).root.shapes()
    assert len(written.times) < 20
    assert f"{len(written.times)} keys for 50 frames" in notes[0]
    for frame in range(1001, 1051, 4):
        assert farthest(written.points(frame), shape.at(frame).points) <= 0.3 + 0.05
        offsets = shape.at(frame).feather
        np.testing.assert_allclose(written.feather_points(frame), shape.at(frame).points + offsets, atol=1.0)


def test_between_frames_a_cubic_stays_within_the_tolerance_too() -> None:
    """What jumps on one frame is met by a cubic on every frame, with a swing in between."""
    keys = [Keyframe(k.frame, k.points + (25.0 if k.frame > 1010 else 0.0), origin=k.origin) for k in tracked(24).keys]
    shape = RotoShape("shape-1", "Jumps", tuple(keys))
    options = ExportOptions(keys=KeyChoice.REDUCED, tolerance=0.3)
    text, notes = roto_document(Project(CLIP, Layer("root", "Root", (shape,))), options)
    (written,) = nuke_judge.judge(text).root.shapes()
    assert len(written.times) < 24
    strays = [farthest(written.points(frame), shape.at(frame).points) for frame in np.arange(1001.0, 1024.01, 0.25)]
    assert max(strays) <= 0.3 + 0.05
    assert "at quarter frames, too" in notes[0]


def test_silhouette_gets_the_few_keys_and_the_sentence() -> None:
    options = ExportOptions(keys=KeyChoice.REDUCED, tolerance=1.0)
    text, notes = silhouette_document(Project(CLIP, Layer("root", "Root", (tracked(50),))), options)
    (written,) = silhouette_judge.judge(text)[1].shapes()
    assert 2 < len(written.keys) < 25
    assert "at most" in notes[0]
