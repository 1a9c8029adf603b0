"""A spline drawn closer to an outline: nearer than before, its kinds of points kept."""

from __future__ import annotations

import numpy as np

from roam_core.geometry import bezier, polyline
from roam_core.geometry.bezier import ANCHOR
from roam_core.params import RefineParams
from roam_core.propagate.frame.nodes import smooth_points
from roam_core.proposal.outline.refine import refined
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
