"""The banded normal equations against dense least squares, nearest places against every edge."""

from __future__ import annotations

import numpy as np
from scipy.linalg import solveh_banded

from roam_core.geometry import polyline
from roam_core.kernels.spline_fit import nearest_places, normal_band
from tests.golden.shots import blob
from tests.reference.spline_fit import ref_fitted, ref_nearest


def test_the_band_has_the_solution_of_dense_least_squares() -> None:
    rng = np.random.default_rng(4)
    points = 40.0 + blob([20.0, 26.0, 18.0, 24.0, 22.0, 19.0, 25.0])
    count = len(points)
    places = np.sort(rng.uniform(0.0, count, 60))
    samples = rng.normal(40.0, 12.0, (60, 2))
    angle = rng.uniform(0.0, 6.28, count)
    tangents = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    smooth = rng.uniform(size=count) > 0.4
    weights = (0.3, 0.2, 1.5)
    turn = np.array([0, 2, 4, 6, 5, 3, 1])
    owner = (3 * turn[:, None] + np.arange(3)).ravel()
    band, right = normal_band(samples, places, points.reshape(-1, 2), owner, tangents, smooth, weights)
    ours = solveh_banded(band, right, lower=True).reshape(-1, 2)[owner].reshape(-1, 3, 2)
    assert np.allclose(ours, ref_fitted(samples, places, points, tangents, smooth, weights), atol=1e-3)


def test_a_point_that_nothing_tells_of_stays_where_it_was() -> None:
    points = 400.0 + blob([20.0, 26.0, 18.0, 24.0, 22.0, 19.0, 25.0])
    places = np.linspace(0.0, 3.0, 40)
    samples = points[0, 0] + np.stack([10.0 * places, places], axis=1)
    owner = np.arange(3 * len(points))
    flat = points.reshape(-1, 2)
    band, right = normal_band(samples, places, flat, owner, np.ones((7, 2)), np.zeros(7, bool), (0.0, 0.0, 0.0))
    ours = solveh_banded(band, right, lower=True).reshape(-1, 3, 2)
    assert np.allclose(ours[5], points[5])
    assert not np.allclose(ours[1], points[1])


def test_nearest_places_are_the_nearest_of_all_edges() -> None:
    rng = np.random.default_rng(5)
    angle = np.arange(40) * (2.0 * np.pi / 40)
    line = 50.0 + 30.0 * np.stack([np.cos(angle), 0.8 * np.sin(angle)], axis=1)
    normals = polyline.outward_normals(line)
    chosen = rng.integers(0, 40, 25)
    samples = line[chosen] + rng.uniform(-3.0, 3.0, (25, 2))
    found = nearest_places(line, normals, samples, normals[chosen], chosen, 6, 1e-6)
    for place, sample in zip(found, samples, strict=True):
        k = int(np.floor(place))
        a, b = line[k % 40], line[(k + 1) % 40]
        assert np.hypot(*(a + (place - k) * (b - a) - sample)) <= ref_nearest(line, sample)[0] + 0.02


def test_a_place_that_was_a_few_vertices_off_comes_to_the_nearest_edge_within_its_window() -> None:
    angle = np.arange(40) * (2.0 * np.pi / 40)
    line = 50.0 + 30.0 * np.stack([np.cos(angle), 0.8 * np.sin(angle)], axis=1)
    normals, at = polyline.outward_normals(line), np.array([0, 1, 20, 38])
    for off in (-4, 3):
        found = nearest_places(line, normals, line[at] + 0.2, normals[at], (at + off) % 40, 6, 1e-6)
        np.testing.assert_allclose((found - at + 20) % 40, 20.0, atol=0.2)
    short = nearest_places(line, normals, line[at], normals[at], (at - 4) % 40, 2, 1e-6)
    np.testing.assert_allclose((short - at + 20) % 40, 19.0, atol=1.01)


def test_a_place_that_faces_the_other_way_is_not_taken() -> None:
    line = np.array([[0.0, 0.0], [10.0, 0.0], [20.0, 0.0], [20.0, 2.0], [10.0, 2.0], [0.0, 2.0]])
    normals = polyline.outward_normals(line)
    sample = np.array([[10.0, 0.8]])
    above = nearest_places(line, normals, sample, np.array([normals[4]]), np.array([4]), 3, 100.0)
    below = nearest_places(line, normals, sample, np.array([normals[1]]), np.array([1]), 3, 100.0)
    assert abs(above[0] - 4.0) <= 1.0
    assert abs(below[0] - 1.0) <= 1.0
