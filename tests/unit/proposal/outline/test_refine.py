"""A spline drawn closer to an outline: nearer than before, its kinds of points kept."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.geometry import bezier, polyline
from roam_core.geometry.bezier import ANCHOR
from roam_core.params import RefineParams
from roam_core.propagate.frame.nodes import smooth_points
from roam_core.proposal.outline.refine import refined
from roam_core.proposal.segment.region import contours
from tests.golden.shots import blob, outline_distance, square


def test_a_spline_beside_its_outline_is_drawn_onto_it() -> None:
    true = 60.0 + blob([30.0, 22.0, 26.0, 34.0, 24.0, 28.0])
    ring = polyline.resample(bezier.flatten(true), 300)
    at = np.array([int(np.argmin(np.hypot(*(ring - anchor).T))) for anchor in true[:, ANCHOR]])
    start = true + np.random.default_rng(3).normal(0.0, 2.0, true.shape)
    start[:, ANCHOR] = ring[at]
    ours = refined(start, ring, at, smooth_points(true), 4, RefineParams())
    assert outline_distance(ours, true) < 0.25 < outline_distance(start, true)
    assert np.hypot(*(ours - true)[:, ANCHOR].T).max() < 1.5


def test_corners_stay_corners() -> None:
    true = 60.0 + square(40.0)
    ring = polyline.resample(bezier.flatten(true), 160)
    at = np.array([int(np.argmin(np.hypot(*(ring - anchor).T))) for anchor in true[:, ANCHOR]])
    ours = refined(true + 0.7, ring, at, np.zeros(4, dtype=bool), 3, RefineParams())
    assert np.array_equal(ours[:, 1], ours[:, 0])
    assert np.array_equal(ours[:, 2], ours[:, 0])
    assert outline_distance(ours, true) < 0.2


def bridged() -> Array:
    """The outline `(K, 2)` of a large disc, and of a small one that hangs on to it by a bridge a pixel wide."""
    rows, columns = np.indices((120, 240)) + 0.5
    inside = (np.hypot(rows - 60, columns - 60) < 40) | (np.hypot(rows - 60, columns - 190) < 14)
    inside[60, 90:180] = True
    ring = np.asarray(contours(np.where(inside, 1.0, -1.0).astype(np.float32))[0][0], dtype=np.float64)
    return polyline.resample(ring, 300)


@pytest.mark.parametrize("seed", range(8))
def test_no_anchor_leaves_an_outline_that_doubles_back(seed: int) -> None:
    ring, params = bridged(), RefineParams()
    at = np.sort(np.random.default_rng(seed).choice(len(ring), 12, replace=False))
    start = np.repeat(ring[at][:, None], 3, axis=1) + np.array([[0.0, 0.0], [-3.0, 1.0], [3.0, -1.0]])
    ours = refined(start, ring, at, np.zeros(12, bool), 4, params)
    away = np.hypot(*(ours[:, None, ANCHOR] - ring).transpose(2, 0, 1)).min(axis=1)
    assert away.max() <= params.astray * polyline.length(ring) / len(ring) + 1e-6
