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

WELL = ConfidenceFeatures(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
HALF_WAY = SpanFeatures(0.05, 0.05, 1.0)
GRID = Grid(Region(0, 0, 60, 40), 40, 60)


def square(x0: float, y0: float, x1: float, y1: float) -> Part:
    return Part(bezier.polygon_points([(x0, y0), (x1, y0), (x1, y1), (x0, y1)]))


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


@pytest.mark.parametrize("constant", [0.05, 2.0, -1.5])
def test_the_model_is_logistic(constant: float) -> None:
    params = replace(CONFIDENCE, span_features=(constant, 1.0, 0.0, 0.0))
    log_odds = constant - HALF_WAY.missed
    assert expected_overlap(HALF_WAY, params) == pytest.approx(1.0 / (1.0 + np.exp(-log_odds)))


def test_signs_of_a_region_that_is_found_as_expected() -> None:
    sure = box(SURE)
    features = ConfidenceFeatures.of([square(20, 10, 40, 30)], sure, everywhere(sure), 1)
    np.testing.assert_allclose(astuple(replace(features, thin=0.0)), astuple(WELL), atol=1e-9)


def test_what_is_thin_has_more_border_for_its_cells() -> None:
    wide, narrow = box(SURE), Field(GRID, np.full(GRID.shape, -SURE, dtype=np.float32))
    narrow.values[10:30, 20:24] = SURE
    features = [
        ConfidenceFeatures.of([square(20, 10, x, 30)], field, everywhere(field), 1)
        for x, field in ((40, wide), (24, narrow))
    ]
    assert features[0].thin == pytest.approx((26**2 - 14**2) / 20**2)  # three cells to both sides
    assert features[1].thin == pytest.approx(10 * 26 / (4 * 20))
    assert expected_overlap(features[1]) < expected_overlap(features[0])


def test_curves_that_enclose_half_the_region() -> None:
    sure = box(SURE)
    features = ConfidenceFeatures.of([square(20, 10, 30, 30)], sure, everywhere(sure), 1)
    assert features.unenclosed == pytest.approx(np.log(2.0))


def test_faint_evidence_is_flat() -> None:
    for field, flat in ((box(0.5), 1.0 - 0.5 / SURE), (box(2.0), 0.5)):
        features = ConfidenceFeatures.of([square(20, 10, 40, 30)], field, everywhere(field), 1)
        assert features.flat == pytest.approx(flat)


def test_what_the_key_did_not_have_is_new() -> None:
    found = box(SURE)
    known = found.inside.astype(np.float32)
    known[:, 30:] = 0.0
    expected = replace(everywhere(found), remembered=known)
    assert ConfidenceFeatures.of([square(20, 10, 40, 30)], found, expected, 1).new == pytest.approx(0.5)


def test_what_the_key_had_and_the_region_has_not_is_missing() -> None:
    found = box(SURE)
    expected = replace(everywhere(found), remembered=np.roll(found.inside, 5, axis=1).astype(np.float32))
    features = ConfidenceFeatures.of([square(20, 10, 40, 30)], found, expected, 1)
    assert (features.missing, features.new) == pytest.approx((0.25, 0.25))


def test_what_was_looked_for_is_not_preferred_for_lying_over_the_key() -> None:
    looked_for = replace(WELL, unenclosed=0.1, new=0.0, missing=0.0)
    carried = replace(WELL, unenclosed=0.1, new=0.3, missing=0.2)
    assert expected_overlap(looked_for) > expected_overlap(carried)
    assert expected_overlap(looked_for.over_the_key_as(carried)) == expected_overlap(carried)
    assert replace(looked_for, unenclosed=0.0).over_the_key_as(carried) == replace(carried, unenclosed=0.0)


def test_nothing_found_leaves_no_confidence() -> None:
    nothing = Field(GRID, np.full(GRID.shape, -SURE, dtype=np.float32))
    features = ConfidenceFeatures.of([square(20, 10, 40, 30)], nothing, everywhere(nothing), 1)
    assert np.isfinite(astuple(features)).all()
    assert expected_overlap(features) < 0.05


def test_a_filled_frame_is_as_sure_as_its_passes_and_keys() -> None:
    well = expected_overlap(SpanFeatures.of(0.1, 0.9, 0.95))
    for worse in ((0.3, 0.9, 0.95), (0.1, 0.6, 0.95), (0.1, 0.9, 0.7), (0.1, 0.9, 0.0)):
        assert expected_overlap(SpanFeatures.of(*worse)) < well
    assert astuple(SpanFeatures.of(0.0, 1.0, 1.0)) == (0.0, 0.0, 0.0)


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
