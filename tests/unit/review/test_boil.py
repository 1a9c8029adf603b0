"""Boil: none where an outline moves evenly or as one piece, as much as it jitters elsewhere."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.params import DOUBTFUL
from roam_core.review.boil import BOILING, boil
from roam_core.review.findings import Finding, FindingKind, boiling, doubtful, findings, worst_of_stretches
from roam_core.roto import Keyframe, Origin, RotoShape
from tests.golden.shots import blob, pose
from tests.unit.review.conftest import body, project_of

REST = blob([30.0, 26.0, 33.0, 28.0, 31.0, 27.0])


def tracked(outlines: list[Array], origin: Origin = Origin.ENGINE) -> RotoShape:
    keys = tuple(Keyframe(1 + k, points, origin=origin, confidence=0.9) for k, points in enumerate(outlines))
    return RotoShape("shape-1", "Blob", keys)


def moved(transform: Array) -> Array:
    return np.asarray(REST @ transform[:, :2].T + transform[:, 2])


def test_what_moves_evenly_or_speeds_up_turns_and_grows_as_one_piece_does_not_boil() -> None:
    poses = [pose(50.0 + 3.0 * k + 0.8 * k * k, 60.0 - k, 4.0 * k * k, 1.0 + 0.03 * k * k) for k in range(6)]
    values = boil(tracked([moved(each) for each in poses]))
    assert values[:, 0].tolist() == [2, 3, 4, 5]
    assert values[:, 1] == pytest.approx(0.0, abs=1e-9)


def test_jitter_of_the_points_is_measured_in_pixels() -> None:
    rng = np.random.default_rng(3)
    still = [REST + 60.0 for _ in range(40)]
    jittered = [points + rng.normal(0.0, 1.0, (len(REST), 1, 2)) for points in still]
    twice = [a + 2.0 * (b - a) for a, b in zip(still, jittered, strict=True)]
    once, doubled = boil(tracked(jittered))[:, 1], boil(tracked(twice))[:, 1]
    assert boil(tracked(still))[:, 1].max() < 1e-9
    assert 0.2 < once.mean() < 0.9, "what is more than a motion as one piece, averaged along the curve"
    assert doubled.mean() == pytest.approx(2.0 * once.mean(), rel=0.1)


def test_a_bump_shows_on_its_frame_most() -> None:
    outlines = [REST + 60.0 for _ in range(9)]
    outlines[4] = outlines[4].copy()
    outlines[4][2] += 8.0
    values = boil(tracked(outlines))
    assert values[np.argmax(values[:, 1]), 0] == 5
    assert values[:, 1].max() > BOILING
    assert (values[values[:, 0] == 2][:, 1] < 1e-9).all()


def test_nothing_is_found_on_frames_on_which_a_shape_does_not_exist() -> None:
    """A lifetime that was shortened after tracking leaves keys beside it, which nobody sees."""
    jittering = tracked([REST + 60.0 + np.random.default_rng(k).normal(0.0, 3.0, (len(REST), 1, 2)) for k in range(9)])
    doubted = replace(jittering, keys=tuple(replace(key, confidence=0.2) for key in jittering.keys), lifetime=(3, 7))
    assert [found.frame for found in doubtful([doubted])] == [3, 4, 5, 6]
    assert [found.frame for found in boiling([doubted])] == [4, 5]


def test_frames_without_both_neighbours_do_not_count_and_neither_do_keys_of_the_artist_alone() -> None:
    shape = tracked([REST + 60.0 + k % 2 for k in range(7)])
    gap = replace(shape, keys=shape.keys[:3] + shape.keys[4:])
    assert boil(gap)[:, 0].tolist() == [2, 6]
    assert len(boil(tracked([REST + 60.0] * 5, Origin.ARTIST))) == 0
    assert len(boil(replace(shape, keys=shape.keys[:2]))) == 0


def test_of_each_stretch_the_worst_frame_is_kept() -> None:
    found = [Finding(FindingKind.BOIL, frame, "shape-1", "Arm", value)
             for frame, value in ((3, 1.2), (4, 2.5), (5, 1.1), (8, 1.3), (10, 1.0), (11, 1.4))]  # fmt: skip
    assert [each.frame for each in worst_of_stretches(found)] == [4, 8, 11]
    assert worst_of_stretches([]) == []


def test_a_doubtful_and_a_boiling_frame_are_found_each_with_its_value() -> None:
    shape = body([0.0] * 10)
    keys = list(shape.keys)
    keys[3] = replace(keys[3], confidence=0.4)
    bent = keys[6].points.copy()
    bent[1] += 9.0
    keys[6] = replace(keys[6], points=bent)
    project = project_of(replace(shape, keys=tuple(keys)))
    (doubt,) = doubtful(project.shapes)
    assert (doubt.kind, doubt.frame, doubt.value) == (FindingKind.DOUBT, 1004, 0.4)
    assert doubt.value < DOUBTFUL
    assert 1007 in [found.frame for found in boiling(project.shapes)]
    assert [found.frame for found in findings(project)] == sorted(found.frame for found in findings(project))
    assert doubt.sentence == "Body is doubtful, confidence 0.40"
    assert all(found.sentence.endswith(" px") for found in boiling(project.shapes))
