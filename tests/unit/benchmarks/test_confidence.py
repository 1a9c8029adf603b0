"""What is fitted is found again, a shot has no say in its own confidence, and the worst fifth is counted right."""

from __future__ import annotations

from dataclasses import astuple, replace

import numpy as np
import pytest

from benchmarks import confidence, logistic, rated, shots
from benchmarks.rated import Rated
from benchmarks.shots import Shot
from roam_core.params import CONFIDENCE
from roam_core.propagate.frame.confidence import ConfidenceFeatures, SpanFeatures, expected_overlap
from tests.unit.propagate.figures import SIZE, body_and_sleeve


def made(weights: np.ndarray, seed: int, count: int = 60) -> list[Rated]:
    """Frames whose IoU is just what the model of these weights says."""
    features = np.random.default_rng(seed).uniform(0.0, 1.0, (count, len(weights) - 1))
    return [
        Rated(float(share), ((1.0, tuple(row)),))
        for share, row in zip(logistic.expected(features, weights), features, strict=True)
    ]


def test_the_weights_of_a_model_are_found_again() -> None:
    weights = np.array([3.0, 2.0, 0.5])
    found = confidence.weights_of({("a", "whole"): made(weights, 1), ("b", "whole"): made(weights, 2)})
    np.testing.assert_allclose(found, weights, rtol=0.25)


def test_no_weight_is_negative() -> None:
    found = confidence.weights_of({("a", "whole"): made(np.array([1.0, 2.0, -3.0]), 3)})
    assert found[2] == 0.0
    assert found[1] > 0.0


def test_the_model_is_that_of_the_engine() -> None:
    features = ConfidenceFeatures(0.1, 0.2, 0.05, 0.1, 0.6, 1.5, 0.4)
    weights = np.array([3.0, 2.0, 5.0, 0.3, 0.7, 0.1, 0.5, 2.0])
    assert logistic.expected(np.array(astuple(features)), weights) == pytest.approx(
        expected_overlap(features, replace(CONFIDENCE, features=tuple(weights.tolist())))
    )


def test_as_it_ships_frames_have_the_confidence_of_the_engine() -> None:
    features, span = ConfidenceFeatures(0.1, 0.2, 0.05, 0.1, 0.6, 1.5, 0.4), SpanFeatures(0.1, 0.8, 0.3)
    frames = {
        ("a", "whole"): [Rated(0.7, ((1.0, astuple(features)),))],
        ("a", "fill 10"): [Rated(0.9, ((1.0, astuple(span)),))],
    }
    for protocol, each in (("whole", features), ("fill 10", span)):
        [(ious, said)] = confidence.as_it_ships(frames, protocol).values()
        assert ious.tolist() == [frames["a", protocol][0].iou]
        assert said.tolist() == pytest.approx([expected_overlap(each)])


def test_a_shot_has_no_say_in_its_own_confidence() -> None:
    common, odd = np.array([3.0, 2.0]), np.array([-1.0, 0.0])
    frames = {("a", "w"): made(common, 1), ("b", "w"): made(common, 2), ("odd", "w"): made(odd, 3)}
    found, weights = confidence.left_out(frames)
    assert found["odd", "w"].mean() > 0.8  # by the others' model; its own frames are all at .27
    assert weights[0] < 2.9


def test_the_worst_fifth_and_what_is_possible() -> None:
    ious = np.array([0.5, 0.95, 0.6, 0.95, 0.7, 0.95, 0.95, 0.95, 0.95, 0.95])
    assert confidence.worst_fifth(ious, ious) == pytest.approx((2 / 3, 2 / 3))
    assert confidence.worst_fifth(ious, -ious) == pytest.approx((0.0, 2 / 3))


def test_objects_count_by_their_area_and_what_is_lost_for_nothing() -> None:
    weights = np.array([0.0, 1.0])
    frame = Rated(0.5, ((0.5, (0.0,)), (0.25, (0.0,))))
    by_pose = Rated(0.9, ((0.5, (0.0,)),), apart=0.4)
    assert confidence.confidences([frame, Rated(0.0, ()), by_pose], weights) == pytest.approx([0.375, 0.0, 0.65])


def test_calibration_of_a_rating_that_tells_the_truth() -> None:
    said, meant = confidence.calibration({"a": (np.linspace(0, 1, 50), np.linspace(0, 1, 50))})
    np.testing.assert_allclose(said, meant)


def test_what_lies_by_its_pose_has_the_confidence_of_that() -> None:
    figure = body_and_sleeve()
    body = figure.shapes(*figure.frames)[:1]
    masks = [shots.matte(body, frame, SIZE) > 0.5 for frame in figure.frames]
    for frame in rated.carried(Shot("body", 0, figure.pictures, masks), figure.frames):
        assert frame.known == ()
        assert frame.apart == pytest.approx(frame.iou, abs=0.1)


def test_frames_of_a_shot_are_rated_in_both_ways(gliding: Shot) -> None:
    carried = list(rated.carried(gliding, gliding.frames))
    assert len(carried) == 7
    filled = list(rated.filled(gliding, 7))
    assert len(filled) == 6
    for frames, kind in ((carried, ConfidenceFeatures), (filled, SpanFeatures)):
        assert min(frame.iou for frame in frames) > 0.9
        for frame in frames:
            ((share, features),) = frame.known
            assert share == pytest.approx(1.0)
            assert expected_overlap(kind(*features)) > 0.8
