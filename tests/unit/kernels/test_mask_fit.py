"""Splines fitted to outlines of masks: the equations against the energies written out, distances by brute force."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.kernels import mask_fit

P = 4
"""Points of the splines."""
KEYS = 2
SIZE = P * KEYS * 6
ORDER = np.array([2, 0, 3, 1])
"""The place of each point among the unknowns."""


def a_spline(seed: int = 0) -> Array:
    """A closed spline `(P, 3, 2)` around (20, 20)."""
    angle = np.linspace(0.0, 2.0 * np.pi, P, endpoint=False)
    anchors = 20.0 + 12.0 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    rng = np.random.default_rng(seed)
    return np.asarray(anchors[:, None] + rng.normal(0.0, 3.0, (P, 3, 2)) * [[0.0], [1.0], [1.0]])


def bezier(points: Array, segment: int, t: float) -> Array:
    """A place of a closed spline by de Casteljau's construction."""
    after = (segment + 1) % len(points)
    row = [points[segment, 0], points[segment, 2], points[after, 1], points[after, 0]]
    while len(row) > 1:
        row = [a + t * (b - a) for a, b in pairwise(row)]
    return np.asarray(row[0])


def of_unknowns(z: Array, key: int) -> Array:
    """A key's points `(P, 3, 2)` among the unknowns."""
    return np.asarray(z.reshape(P, KEYS, 3, 2)[ORDER, key])


def energy_of(band: Array, side: Array, z: Array) -> float:
    """What a system in lower banded form says that z costs, against the zero vector."""
    matrix = sum(np.diag(band[k, : SIZE - k], -k) for k in range(SIZE))
    matrix = matrix + np.tril(matrix, -1).T
    return float(z @ matrix @ z - 2.0 * side @ z)


def assert_same_energy(band: Array, side: Array, energy: Callable[[Array], float]) -> None:
    rng = np.random.default_rng(9)
    for _ in range(4):
        z = rng.normal(0.0, 10.0, SIZE)
        assert energy_of(band, side, z) == pytest.approx(energy(z) - energy(np.zeros(SIZE)), rel=1e-9)


def empty() -> tuple[Array, Array]:
    return np.zeros((SIZE, SIZE)), np.zeros(SIZE)


def units(seed: int, count: int) -> Array:
    angle = np.random.default_rng(seed).uniform(0.0, 2.0 * np.pi, count)
    return np.stack([np.cos(angle), np.sin(angle)], axis=1)


def test_a_drawn_spline_has_eight_vertices_a_segment() -> None:
    points = a_spline()
    expected = [bezier(points, i, k / mask_fit.FINE) for i in range(P) for k in range(mask_fit.FINE)]
    np.testing.assert_allclose(mask_fit.drawn(points), expected)


SHARES = pytest.mark.parametrize(
    ("left", "right", "share"),
    [(0, 1, 0.3), (-1, 1, 0.3), (0, -1, 0.6), (0, 1, 0.0), (0, 1, 1.0)],
    ids=["between two keys", "after a fixed key", "before a fixed key", "on the left key", "on the right key"],
)


def between(z: Array, left: int, right: int, share: float, fixed: Array) -> Array:
    """A frame's points: the keys' mixture, of which those below 0 are fixed."""
    ends = [fixed[side] if key < 0 else of_unknowns(z, key) for side, key in enumerate((left, right))]
    return np.asarray((1.0 - share) * ends[0] + share * ends[1])


@SHARES
def test_a_frames_equations_are_those_of_its_samples_distances(left: int, right: int, share: float) -> None:
    rng, count, along = np.random.default_rng(1), 30, 0.2
    samples, tangents = rng.uniform(0.0, 40.0, (count, 2)), units(2, count)
    places, weights = rng.uniform(0.0, mask_fit.FINE * P, count), rng.uniform(0.5, 2.0, count)
    fixed = np.stack([a_spline(3), a_spline(4)])
    matrices, vectors = np.ones((P, 8, 8)), np.ones((P, 8))
    mask_fit.segment_sums(samples, tangents, places, weights, P, along, matrices, vectors)
    band, side = empty()
    mask_fit.add_segments(matrices, vectors, left, right, share, fixed, ORDER, KEYS, band, side)

    def energy(z: Array) -> float:
        points, total = between(z, left, right, share, fixed), 0.0
        for sample, (tx, ty), place, weight in zip(samples, tangents, places, weights, strict=True):
            segment, t = divmod(place / mask_fit.FINE, 1.0)
            x, y = bezier(points, int(segment), t) - sample
            total += weight * ((ty * x - tx * y) ** 2 + along * (tx * x + ty * y) ** 2)
        return total

    assert_same_energy(band, side, energy)


@SHARES
def test_held_anchors_cost_what_they_slide_along_the_outline(left: int, right: int, share: float) -> None:
    targets, tangents = a_spline(5)[:, 0] + 1.0, units(6, P)
    fixed = np.stack([a_spline(3), a_spline(4)])
    band, side = empty()
    mask_fit.add_anchors(targets, tangents, 0.7, left, right, share, fixed, ORDER, KEYS, band, side)

    def energy(z: Array) -> float:
        anchors = between(z, left, right, share, fixed)[:, 0]
        return float(0.7 * (((anchors - targets) * tangents).sum(axis=1) ** 2).sum())

    assert_same_energy(band, side, energy)


@pytest.mark.parametrize("key", range(KEYS))
def test_a_keys_points_cost_what_they_leave_their_lines_thirds_and_places_by(key: int) -> None:
    """A handle of no length goes towards its neighbour; the handles of a corner have no common line."""
    points = a_spline(7)
    points[1, 1] = points[1, 0]
    smooth = np.array([True, False, True, True])
    line, third, stay = 2.0, 0.3, 0.05
    band, side = empty()
    mask_fit.add_points(points, smooth, key, (line, third, stay), ORDER, KEYS, band, side)

    def energy(z: Array) -> float:
        moved, total = of_unknowns(z, key), 0.0
        total += stay * float(((moved - points) ** 2).sum())
        for p in range(P):
            common = points[p, 2] - points[p, 1]
            across = np.array([-common[1], common[0]]) / np.hypot(*common)
            for part, other in ((1, (p - 1) % P), (2, (p + 1) % P)):
                chord, handle = points[other, 0] - points[p, 0], points[p, part] - points[p, 0]
                way = handle if np.hypot(*handle) > 0.0 else chord
                now = moved[p, part] - moved[p, 0]
                total += third * float(now @ way / np.hypot(*way) - np.hypot(*chord) / 3.0) ** 2
                total += line * float(now @ across) ** 2 if smooth[p] else 0.0
        return total

    assert_same_energy(band, side, energy)


@pytest.mark.parametrize("width", [1, 2, 5, 12])
def test_a_banded_system_is_solved_and_one_that_is_not_definite_is_told(width: int) -> None:
    rng = np.random.default_rng(width)
    lower = np.tril(rng.normal(size=(12, 12)))
    lower[np.subtract.outer(np.arange(12), np.arange(12)) >= width] = 0.0
    matrix = lower @ lower.T + 0.5 * np.eye(12)
    band = np.zeros((width, 12))
    for k in range(width):
        band[k, : 12 - k] = np.diag(matrix, -k)
    wanted = rng.normal(size=12)
    side = matrix @ wanted
    assert mask_fit.solved_band(band.copy(), side)
    np.testing.assert_allclose(side, wanted, atol=1e-9)
    band[0, 7] = -1.0
    assert not mask_fit.solved_band(band, matrix @ wanted)


def a_line(count: int = 60) -> Array:
    """A closed line with a deep bay."""
    angle = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    radius = 20.0 + 8.0 * np.cos(3.0 * angle)
    return np.asarray(30.0 + radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1))


def to_edges(place: Array, line: Array) -> tuple[Array, Array]:
    """Distance and foot, in [0, 1], of a place on every edge of a closed line."""
    way = np.roll(line, -1, axis=0) - line
    foot = np.clip(((place - line) * way).sum(axis=1) / (way**2).sum(axis=1), 0.0, 1.0)
    return np.hypot(*(line + foot[:, None] * way - place).T), foot


def test_distances_are_those_to_the_nearest_of_all_edges() -> None:
    line, places = a_line(), np.random.default_rng(2).uniform(0.0, 60.0, (40, 2))
    expected = [to_edges(place, line)[0].min() for place in places]
    np.testing.assert_allclose(mask_fit.distances(places, line, 0.0), expected, atol=1e-9)


def test_distances_up_to_near_are_those_to_edges_about_the_last_nearest_one() -> None:
    """Of places along the line, either way round and across its start."""
    line = a_line()
    normals = np.roll(line, -1, axis=0) - np.roll(line, 1, axis=0)
    beside = line + 0.5 * normals[:, ::-1] * (1.0, -1.0) / np.hypot(*normals.T)[:, None]
    expected = [to_edges(place, line)[0].min() for place in beside]
    for places, wanted in ((beside, expected), (beside[::-1], expected[::-1])):
        np.testing.assert_allclose(mask_fit.distances(places, line, 1.0), wanted, atol=1e-9)
    jumped = np.stack([line[0] + 0.1, line[30] + 0.1])
    exact = [to_edges(place, line)[0].min() for place in jumped]
    np.testing.assert_allclose(mask_fit.distances(jumped, line, 1.0), exact, atol=1e-9)
    far = mask_fit.distances(jumped, line, 100.0)
    assert far[0] == pytest.approx(exact[0])
    assert far[1] > 10.0, "within reach of `near` the other side is not looked at"


def test_places_go_to_the_nearest_edges_that_run_their_way() -> None:
    line, rng = a_line(), np.random.default_rng(3)
    way = np.roll(line, -1, axis=0) - line
    along = way / np.hypot(*way.T)[:, None]
    begun = rng.uniform(0.0, 60.0, 25)
    samples, tangents = line[begun.astype(int)] + rng.normal(0.0, 3.0, (25, 2)), units(4, 25)
    for window, turn in ((4, 0.0), (4, 30.0), (29, 5.0)):
        places, squares = begun.copy(), np.zeros(25)
        mask_fit.put_on(line, samples, tangents, places, window, turn, squares)
        for m in range(25):
            away, foot = to_edges(samples[m], line)
            price = away**2 + turn * (1.0 - along @ tangents[m])
            looked_at = np.arange(int(begun[m]) - window, int(begun[m]) + window + 1) % 60
            best = looked_at[price[looked_at].argmin()]
            assert squares[m] == pytest.approx(away[best] ** 2)
            assert price[int(places[m]) % 60] == pytest.approx(price[best]) or foot[best] == 1.0
            assert places[m] == pytest.approx((best + foot[best]) % 60)


def test_a_run_along_a_cubic_is_that_cubic() -> None:
    true = np.array([(100.0, 50.0), (108.0, 59.0), (121.0, 62.0), (130.0, 53.0)])
    points = np.stack([true[[0, 0, 1]], true[[3, 2, 3]]])
    run = np.array([bezier(points, 0, t) for t in np.linspace(0.0, 1.0, 40)])
    control = np.zeros((4, 2))
    assert mask_fit.best_cubic(run, control) < 0.08
    np.testing.assert_allclose(control, true, atol=0.8)


def test_a_run_on_a_line_has_its_handles_on_the_line_and_one_of_two_samples_at_its_thirds() -> None:
    control = np.zeros((4, 2))
    ends = np.array([(1.0, 2.0), (10.0, 5.0)])
    assert mask_fit.best_cubic(ends, control) == 0.0
    np.testing.assert_allclose(control, [ends[0], (4.0, 3.0), (7.0, 4.0), ends[1]], atol=1e-6)


def test_how_far_a_run_strays_is_the_distance_of_its_worst_sample() -> None:
    run = np.stack([np.linspace(0.0, 30.0, 31), np.zeros(31)], axis=1)
    run[15, 1] = 4.0
    control = np.zeros((4, 2))
    strays = mask_fit.best_cubic(run, control)
    curve = np.array(
        [bezier(np.stack([control[[0, 0, 1]], control[[3, 2, 3]]]), 0, t) for t in np.linspace(0, 1, 2000)]
    )
    worst = max(np.hypot(*(curve - place).T).min() for place in run)
    assert strays == pytest.approx(worst, abs=0.1)
    assert 3.0 < strays < 4.0


def test_runs_are_counted_on_the_rings_on_which_they_stray_and_no_further_than_needed() -> None:
    angle = np.linspace(0.0, 2.0 * np.pi, 40, endpoint=False)
    ring = 20.0 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    dented = ring.copy()
    dented[1] *= 0.6  # between 37 and 37 + 8, across the start of the ring
    dense = np.stack([ring, dented, dented, ring, dented])
    assert mask_fit.runs_beyond(dense, 37, 8, 1.0, 9) == 3
    assert mask_fit.runs_beyond(dense, 37, 8, 1.0, 1) == 2
    assert mask_fit.runs_beyond(dense, 5, 8, 1.0, 9) == 0
    assert mask_fit.runs_beyond(dense, 37, 8, 9.0, 9) == 0


def judged(away: Array, free: float, scrap: float = 0.0, reach: float = 2.0) -> tuple[float, list[int]]:
    """The verdict on a ring of a hundred vertices a pixel apart, at a tolerance of 1, and which are let go."""
    line = np.zeros((100, 2))
    corners = [*((k, 0) for k in range(25)), *((25, k) for k in range(25))]
    line[:50] = corners
    line[50:] = np.array([25, 25]) - np.array(corners)
    gone = np.ones(100, dtype=bool)
    line = np.roll(line, 10, axis=0)  # no corner at the start
    return float(mask_fit.judged(away, line, 1.0, free, reach, scrap, gone)), np.flatnonzero(gone).tolist()


def test_the_judge_takes_the_greatest_or_one_and_a_half_of_the_mean() -> None:
    away = np.full(100, 0.5)
    away[30] = 0.9
    assert judged(away, 0.0) == (pytest.approx(0.9), [])
    away[:] = 0.8
    assert judged(away, 0.0) == (pytest.approx(1.2), [])


def test_the_judge_lets_a_share_of_the_length_go_up_to_what_lies_beyond_reach() -> None:
    away = np.full(100, 0.1)
    away[40:44] = (1.2, 1.4, 1.3, 1.1)
    mean = (96 * 0.1 + 5.0) / 100.0
    assert judged(away, 0.05)[0] == pytest.approx(1.5 * mean, rel=0.01)
    assert judged(away, 0.031) == (pytest.approx(1.1), [40, 41, 42])
    away[41] = 3.0  # beyond two tolerances
    assert judged(away, 0.05)[0] == pytest.approx(1.5)
    assert judged(away, 0.05, scrap=0.9)[0] == pytest.approx(1.5)
    assert judged(away, 0.05, scrap=1.1)[0] < 0.5
    assert judged(np.full(100, 3.0), 0.05, scrap=1e9)[0] == pytest.approx(4.5)


def test_stretches_beyond_reach_are_weighed_one_by_one_also_across_the_start() -> None:
    away = np.full(100, 0.1)
    away[[0, 99]] = 2.5, 2.6  # one stretch of half a pixel squared and some
    away[50] = 2.9
    assert judged(away, 0.05, scrap=1.0)[0] == pytest.approx(1.3)
    assert judged(away, 0.05, scrap=0.8)[0] == pytest.approx(2.9 / 2.0)
    assert judged(away, 0.05, scrap=1.2)[0] < 0.5
