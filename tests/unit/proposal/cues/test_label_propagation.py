"""The sides that cells bring along from the key by the flow, and what breaks their lines."""

from __future__ import annotations

from dataclasses import astuple, replace

import cv2
import numpy as np
import pytest

from roam_core.arrays import Float32, UInt8
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.geometry.bezier import polygon_points
from roam_core.motion.flow import carried_by_flow, dense_flow, on_grid
from roam_core.params import LabelPropagationParams, RegionParams
from roam_core.propagate.frame.result import Part
from roam_core.propagate.whole.observation import observed
from roam_core.propagate.whole.state import begin
from roam_core.proposal.cues.evidence import Sources, cues, gathered
from roam_core.proposal.cues.label_propagation import LabelPropagation, label_propagation

PARAMS = LabelPropagationParams()
SIZE = (120, 160)
WHOLE = Region(0, 0, SIZE[1], SIZE[0])
FINE, COARSE = Grid.over(WHOLE, 1.0), Grid.over(WHOLE, 0.5)


def noise(seed: int) -> UInt8:
    rough = np.random.default_rng(seed).integers(0, 256, (*SIZE, 3)).astype(np.uint8)
    soft = cv2.GaussianBlur(rough, (0, 0), 2.5)
    return np.asarray(cv2.normalize(soft, None, 0, 255, cv2.NORM_MINMAX), dtype=np.uint8)  # type: ignore[call-overload]


def picture(x: int, hidden: bool = False) -> PreparedFrame:
    """A card of 60 by 50 pixels before a wall, its left side at `x`; a stranger may hide its right half."""
    image = noise(1)
    image[30:80, x : x + 60] = noise(2)[30:80, 40:100]
    if hidden:
        image[20:90, x + 30 : x + 70] = noise(3)[20:90, :40]
    return PreparedFrame(image)


def sides(x: int) -> Float32:
    field = np.full(SIZE, -1.0, dtype=np.float32)
    field[30:80, x : x + 60] = 1.0
    return field


def brought(before: PreparedFrame, after: PreparedFrame, flow_reliability: float = 1.0) -> LabelPropagation:
    forward, backward = dense_flow(before, after, FINE, is_exact=True)
    flows = on_grid(forward, FINE, COARSE), on_grid(backward, FINE, COARSE)
    there = carried_by_flow(sides(40), backward)
    pictures = COARSE.of(before.image), COARSE.of(after.image)
    return label_propagation(
        pictures, there, flows, np.full(COARSE.shape, flow_reliability, np.float32), COARSE, SIZE, PARAMS
    )


def test_a_card_that_glides_brings_its_outline_along() -> None:
    found = brought(picture(40), picture(46))
    inside = cv2.resize(sides(46), COARSE.shape[::-1], interpolation=cv2.INTER_AREA) > 0
    seen = found.depth > 0
    assert np.count_nonzero(seen & inside) / np.count_nonzero(seen | inside) > 0.92
    middle = found.flow_reliability[20:35, 28:48]
    assert middle.min() > 0.9
    assert found.likeness[20:35, 28:48].mean() > 0.8
    assert found.log_ratio[20:35, 28:48].min() > 0.5
    assert found.log_ratio[2:8, 2:10].max() < -0.5


def test_depth_is_told_in_pixels_of_the_finer_grid() -> None:
    found = brought(picture(40), picture(40))
    assert found.depth[27, 35] == pytest.approx(20.0)  # at most
    assert found.depth[27, 22] == pytest.approx(5.0, abs=1.0)
    assert found.depth[27, 17] == pytest.approx(-5.0, abs=1.0)


def test_what_is_hidden_breaks_the_lines_there_only() -> None:
    found = brought(picture(40), picture(42, hidden=True))
    free, hidden = (slice(20, 35), slice(25, 33)), (slice(20, 35), slice(40, 52))
    assert found.flow_reliability[free].mean() > 0.9
    assert found.flow_reliability[hidden].mean() < 0.8
    assert found.likeness[hidden].mean() < 0.5 * found.likeness[free].mean()


def test_the_same_pictures_bring_the_same_bits_wherever_in_memory_they_lie() -> None:
    first, kept = brought(picture(40), picture(46)), []
    for size in range(1, 2000, 97):
        kept.append(np.zeros(size, np.uint8))
        again = brought(picture(40), picture(46))
        for one, other in zip(astuple(first), astuple(again), strict=True):
            np.testing.assert_array_equal(one, other)


def test_a_broken_line_stays_broken() -> None:
    fresh, old = (brought(picture(40), picture(42), flow_reliability) for flow_reliability in (1.0, 0.3))
    np.testing.assert_allclose(old.flow_reliability, 0.3 * fresh.flow_reliability, rtol=1e-4, atol=1e-6)
    np.testing.assert_array_equal(old.likeness, fresh.likeness)


def test_a_cell_that_is_decided_otherwise_forgets_most_of_the_key() -> None:
    depth = np.array([[5.0, 5.0, -5.0, -5.0]], dtype=np.float32)
    found = LabelPropagation(depth, np.ones_like(depth), np.full_like(depth, 0.8), PARAMS)
    after = found.after(np.array([[True, False, False, True]]))
    np.testing.assert_allclose(after, [[0.8, 0.8 * PARAMS.contradicted, 0.8, 0.8 * PARAMS.contradicted]])


@pytest.mark.parametrize("left", [0, 40])
def test_what_comes_from_beyond_the_cells_but_not_from_beyond_the_picture_lay_outside_for_sure(left: int) -> None:
    grid = Grid.over(Region(left, 20, 120, 80), 0.5)
    cells = np.zeros((*grid.shape, 3), np.uint8)
    flow = np.zeros((*grid.shape, 2), np.float32)
    flow[..., 0] = 5.0
    unknown, outside = np.zeros(grid.shape, np.float32), np.full((60, 120 - left), -1.0, np.float32)
    found = label_propagation((cells, cells), outside, (flow, -flow), unknown, grid, SIZE, PARAMS)
    expected = np.zeros(grid.shape, np.float32)
    expected[:, :5] = 1.0 if left > 0 else 0.0
    np.testing.assert_array_equal(found.flow_reliability, expected)
    assert (found.log_ratio[:, :5] < 0.0).all() == (left > 0)


def test_cells_that_were_not_looked_at_before_lay_outside_for_sure() -> None:
    params = RegionParams()
    card = Part(polygon_points([(40, 30), (60, 30), (60, 80), (40, 80)]))
    state = begin(picture(40), (card,), params)
    state = replace(state, flow_reliability=np.zeros_like(state.flow_reliability))
    there = replace(card, points=card.points + np.array([24.0, 0.0]))
    seen = observed(replace(state, parts=(there,)), picture(40), params)
    assert seen is not None
    assert seen.sources.label_propagation is not None
    old, grid = state.region.grid.region, seen.sources.grid
    assert old.x1 + 4 < grid.region.x1 < SIZE[1]
    column = round(float(grid.to_grid(np.array([old.x1, 0.0]))[0]))
    reliable = seen.sources.label_propagation.flow_reliability
    assert reliable[:, column + 2 :].min() > 0.8
    assert reliable[:, : column - 2].max() < 0.1


def test_where_the_lines_are_broken_the_other_cues_speak_alone() -> None:
    params, sources = RegionParams(), seen()
    assert sources.label_propagation is not None
    broken = replace(sources.label_propagation, flow_reliability=np.zeros(sources.grid.shape, np.float32))
    alone = gathered(replace(sources, label_propagation=None), params)
    np.testing.assert_array_equal(gathered(replace(sources, label_propagation=broken), params).values, alone.values)


def test_unbroken_lines_outweigh_colours_and_are_not_smoothed() -> None:
    params, sources = RegionParams(), seen()
    ones = np.ones(sources.grid.shape, np.float32)
    checks = np.where(np.indices(sources.grid.shape).sum(axis=0) % 2 == 0, 6.0, -6.0).astype(np.float32)
    field = gathered(replace(sources, label_propagation=LabelPropagation(checks, ones, ones, PARAMS)), params)
    assert sources.band.any()
    np.testing.assert_array_equal(field.inside[sources.band], checks[sources.band] > 0)


def test_each_cue_is_told_with_the_share_that_is_heard() -> None:
    params, sources = RegionParams(beside_label_propagation=0.25), seen()
    ones = np.ones(sources.grid.shape, np.float32)
    heard = dict(cues(replace(sources, label_propagation=LabelPropagation(ones, ones, ones, PARAMS)), params))
    alone = dict(cues(replace(sources, label_propagation=None), params))
    assert set(heard) == {*alone, "lineage"}
    for name, cue in alone.items():
        np.testing.assert_allclose(heard[name], 0.25 * cue, rtol=1e-6)


def seen() -> Sources:
    """The card a frame after its key, in the eyes of the engine."""
    params = RegionParams()
    card = Part(polygon_points([(40, 30), (100, 30), (100, 80), (40, 80)]))
    seen = observed(begin(picture(40), (card,), params), picture(43), params)
    assert seen is not None
    return seen.sources
