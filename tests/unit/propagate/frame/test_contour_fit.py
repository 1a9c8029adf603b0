"""Outlines fitted to a region: behind a post, and out of sight."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.features import Region
from roam_core.features.grid import Grid
from roam_core.geometry import bezier, polyline
from roam_core.matte import shape_matte
from roam_core.params import ContourFitParams, RegionParams
from roam_core.propagate.frame.contour_fit import enclosed, fitted, trusts_of
from roam_core.propagate.frame.nodes import smooth_points
from roam_core.propagate.frame.result import Part
from roam_core.proposal.cues.evidence import Field
from roam_core.proposal.outline.contour import KeyConstraints
from roam_core.roto import Keyframe, Origin, RotoShape
from roam_core.roto.sight import opened
from tests.golden.shots import blob

GRID = Grid.over(Region(0, 0, 240, 160), 0.5)
BODY = Part(blob([60.0, 50.0] * 6) + np.array([110.0, 80.0]))
HAND = Part(blob([12.0] * 6) + np.array([200.0, 40.0]))


def along(parts: list[Part], inside: np.ndarray, longest_bridge: float = 2.0) -> list[tuple[np.ndarray, bool]]:
    constraints = [KeyConstraints.of(part.points, smooth_points(part.points), ContourFitParams()) for part in parts]
    field, params = Field.of_coverage(GRID, inside.astype(np.float32)), RegionParams(longest_bridge=longest_bridge)
    return fitted(parts, constraints, field, 1.0, params)


@pytest.mark.parametrize(("longest_bridge", "least", "most"), [(2.0, 0.93, 1.0), (0.0, 0.4, 0.8)])
def test_behind_a_post_one_outline_has_both_sides(longest_bridge: float, least: float, most: float) -> None:
    seen = enclosed([BODY], GRID) > 0.5
    seen[:, 45:55] = False
    ((points, found),) = along([BODY], seen, longest_bridge)
    assert found
    ours = enclosed([Part(points)], GRID) > 0.5
    assert least <= (ours & seen).sum() / (ours | seen).sum() <= most
    assert len(polyline.crossings(bezier.flatten(points))) == 0


def test_what_is_out_of_sight_closes_while_the_rest_is_seen() -> None:
    body, hand = along([BODY, HAND], enclosed([BODY], GRID) > 0.5)
    assert body[1]
    assert not hand[1]
    assert np.ptp(hand[0], axis=(0, 1)).max() < 1.0
    np.testing.assert_allclose(hand[0][:, 0].mean(axis=0), [200.0, 40.0], atol=0.5)


def test_a_shape_before_another_stays_though_it_has_no_piece_of_its_own() -> None:
    arm = Part(blob([12.0] * 6) + np.array([140.0, 80.0]))
    _, (points, seen) = along([BODY, arm], enclosed([BODY, arm], GRID) > 0.5)
    assert not seen
    np.testing.assert_array_equal(points, arm.points)


def test_where_there_is_no_region_all_closes_in_its_place_and_the_matte_is_empty() -> None:
    for part, (points, seen) in zip([BODY, HAND], along([BODY, HAND], np.zeros(GRID.shape, dtype=bool)), strict=True):
        assert not seen
        np.testing.assert_allclose(points[:, 0].mean(axis=0), part.points[:, 0].mean(axis=0))
        shape = RotoShape("shape", "shape", (Keyframe(1, points, origin=Origin.ENGINE),), feather=20.0)
        assert not shape_matte(shape, 1, (160, 240)).any()
        np.testing.assert_allclose(opened(points, part.points), part.points)


def test_where_no_shape_claims_the_region_all_stays_as_it_was() -> None:
    inside = np.zeros(GRID.shape, dtype=bool)
    inside[:2, :2] = True
    ((points, seen),) = along([BODY], inside, 0.0)
    assert not seen
    np.testing.assert_array_equal(points, BODY.points)


@pytest.mark.parametrize(
    ("seen", "trusts"),
    [
        ((True, True), (0.9, 0.9)),
        ((True, False), (0.9, 0.9 * 0.96)),
        ((False, False), (0.0, 0.0)),
    ],
)
def test_who_is_out_of_sight_is_doubted_by_what_would_be_missing(
    seen: tuple[bool, bool], trusts: tuple[float, float]
) -> None:
    hole = Part(HAND.points, subtracts=True)
    found = trusts_of([BODY, HAND, hole], [*seen, False], 0.9)
    np.testing.assert_allclose(found, [*trusts, 0.9], atol=0.01)
