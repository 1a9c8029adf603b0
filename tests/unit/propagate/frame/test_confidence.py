"""Confidence: no sign speaks for a frame, what goes wrong is seen, and a filled frame is judged by both keys."""

from __future__ import annotations

from dataclasses import astuple, fields, replace

import numpy as np
import pytest

from roam_core.features import Region
from roam_core.features.grid import Grid
from roam_core.geometry import bezier
from roam_core.params import CONFIDENCE, params_for
from roam_core.propagate.engines.by_regions import RegionEngine
from roam_core.propagate.frame.confidence import (
    ConfidenceFeatures,
    SpanFeatures,
    expected_overlap,
    vertex_confidence,
)
from roam_core.propagate.frame.result import Part
from roam_core.propagate.group import GroupTracker
from roam_core.proposal.cues.evidence import SURE, Expectation, Field
from tests.golden.shots import Shot

WELL = ConfidenceFeatures(0.0, 0.0, 0.0, 0.0, 0.0)
HALF_WAY = SpanFeatures(0.05, 0.05, 1.0, 2.3)
GRID = Grid(Region(0, 0, 60, 40), 40, 60)


def square(x0: float, y0: float, x1: float, y1: float) -> Part:
    return Part(bezier.polygon_points([(x0, y0), (x1, y0), (x1, y1), (x0, y1)]))


RELIABLE = np.ones(GRID.shape, np.float32)


def box(nats: float) -> Field:
    """A region of 20 by 20 cells that is so sure of itself inside and outside."""
    values = np.full(GRID.shape, -nats, dtype=np.float32)
    values[10:30, 20:40] = nats
    return Field(GRID, values)


def everywhere(field: Field) -> Expectation:
    inside, coverage = field.inside, field.inside.astype(np.float32)
    return Expectation(coverage, inside, inside, coverage, np.zeros_like(inside))


@pytest.mark.parametrize("weights", [CONFIDENCE.features, CONFIDENCE.span_features])
def test_no_sign_speaks_for_a_frame(weights: tuple[float, ...]) -> None:
    assert min(weights[1:]) > 0.0


@pytest.mark.parametrize("features", [WELL, HALF_WAY], ids=["carried", "filled"])
def test_every_sign_costs_confidence(features: ConfidenceFeatures | SpanFeatures) -> None:
    before = expected_overlap(features)
    for field in fields(features):
        worse = replace(features, **{field.name: getattr(features, field.name) + 0.3})
        assert 0.0 < expected_overlap(worse) < before < 1.0


def test_a_frame_without_a_flaw_is_given_nearly_one() -> None:
    assert expected_overlap(WELL) > 0.95


def test_the_model_is_logistic() -> None:
    assert expected_overlap(HALF_WAY, (0.05, 1.0, 0.0, 0.0, 0.0)) == pytest.approx(0.5)


def test_signs_of_a_region_that_is_found_as_expected() -> None:
    sure = box(SURE)
    features = ConfidenceFeatures.of([square(20, 10, 40, 30)], sure, everywhere(sure), RELIABLE, 1)
    np.testing.assert_allclose(astuple(features), astuple(WELL), atol=1e-9)


def test_curves_that_enclose_half_the_region() -> None:
    sure = box(SURE)
    features = ConfidenceFeatures.of([square(20, 10, 30, 30)], sure, everywhere(sure), RELIABLE, 1)
    assert features.unenclosed == pytest.approx(np.log(2.0))


def test_faint_evidence_is_flat_and_undecided() -> None:
    faint, features = box(0.5), []
    for field in (faint, box(2.0)):
        features.append(ConfidenceFeatures.of([square(20, 10, 40, 30)], field, everywhere(field), RELIABLE, 1))
    assert features[0].flat == pytest.approx(1.0 - 0.5 / SURE)
    assert features[1].flat == pytest.approx(0.5)
    assert features[0].undecided == 3.0  # of 2400 cells, for 400 inside, capped
    assert features[1].undecided == 0.0


def test_what_the_key_did_not_have_is_new() -> None:
    found = box(SURE)
    known = found.inside.astype(np.float32)
    known[:, 30:] = 0.0
    expected = replace(everywhere(found), remembered=known)
    assert ConfidenceFeatures.of([square(20, 10, 40, 30)], found, expected, RELIABLE, 1).new == pytest.approx(0.5)


def test_what_the_flow_did_not_bring_from_the_key_is_broken() -> None:
    found, flow_reliability = box(SURE), RELIABLE.copy()
    flow_reliability[:, 30:] = 0.2  # half of the border
    features = ConfidenceFeatures.of([square(20, 10, 40, 30)], found, everywhere(found), flow_reliability, 1)
    assert features.broken == pytest.approx(0.4, abs=0.01)


def test_nothing_found_leaves_no_confidence() -> None:
    nothing = Field(GRID, np.full(GRID.shape, -SURE, dtype=np.float32))
    features = ConfidenceFeatures.of([square(20, 10, 40, 30)], nothing, everywhere(nothing), RELIABLE, 1)
    assert np.isfinite(astuple(features)).all()
    assert expected_overlap(features) < 0.05


def test_a_filled_frame_is_surest_beside_a_key_and_in_a_short_span() -> None:
    beside, middle = (expected_overlap(SpanFeatures.of(0.1, 0.9, u, 10)) for u in (0.1, 0.5))
    assert beside > middle > expected_overlap(SpanFeatures.of(0.1, 0.9, 0.5, 20))
    assert middle > expected_overlap(SpanFeatures.of(0.3, 0.9, 0.5, 10))
    assert middle > expected_overlap(SpanFeatures.of(0.1, 0.6, 0.5, 10))
    assert SpanFeatures.of(0.1, 0.9, 0.2, 10).middle == pytest.approx(SpanFeatures.of(0.1, 0.9, 0.8, 10).middle)


def test_a_vertex_is_trusted_by_its_edge_and_by_its_frame() -> None:
    support = np.array([0.0, 0.5, 1.0])
    good, bad = vertex_confidence(support, 0.9), vertex_confidence(support, 0.5)
    assert (np.diff(good) > 0).all()
    assert (good > bad).all()
    for extreme in (0.0, 1.0):
        assert ((vertex_confidence(support, extreme) > 0) & (vertex_confidence(support, extreme) < 1)).all()


def test_a_run_counts_its_frames_from_the_key(box_shot: Shot) -> None:
    def features() -> ConfidenceFeatures:
        engine = tracker.standing.engine
        assert isinstance(engine, RegionEngine)
        state = engine.state
        assert state.features is not None
        return state.features

    best = params_for("best")
    assert best.region is not None
    tracker = GroupTracker(replace(best, region=replace(best.region, pose=None)))
    tracker.start(box_shot.read(1001), [box_shot.shape()], 1001)
    for count, frame in enumerate(box_shot.frames[1:5], 1):
        [result] = tracker.step(box_shot.read(frame), frame)
        assert features().age == pytest.approx(np.log(count))
        assert result.confidence == expected_overlap(features()) > 0.8
    tracker.correct([result.shape])
    tracker.step(box_shot.read(1006), 1006)
    assert features().age == 0.0
