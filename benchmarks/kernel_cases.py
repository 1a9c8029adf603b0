"""A case for each kernel, of the size that a picture of 480 lines gives it: `python -m benchmarks kernels`."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import cv2
import numpy as np
import pytest

from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.geometry.bezier import segments
from roam_core.geometry.polyline import outward_normals
from roam_core.kernels.alignment import align, prices
from roam_core.kernels.anchoring import anchored
from roam_core.kernels.background_match import best_matches
from roam_core.kernels.colour_bins import bin_counts, looked_up
from roam_core.kernels.coverage import coverage, distance, holds_centres, swept_coverage
from roam_core.kernels.crossing import crossing_edges
from roam_core.kernels.cyclic_viterbi import cyclic_viterbi
from roam_core.kernels.diffusion import diffuse
from roam_core.kernels.distance_transform import distance_transform
from roam_core.kernels.edge_sums import edge_means
from roam_core.kernels.flattening import step_counts, vertices
from roam_core.kernels.gmm_density import em_steps, log_densities, matches
from roam_core.kernels.hypotheses import agreed_similarity, best_motion
from roam_core.kernels.key_spans import cubic_span_errors, linear_span_errors, outline_distances
from roam_core.kernels.local_match import INSIDE, OUTSIDE, log_ratio, nearest_colours
from roam_core.kernels.nearest_edges import nearest_edges
from roam_core.kernels.oblivious_trees import grown, mean_of_leaves, shares
from roam_core.kernels.patch_alignment import aligned, sides
from roam_core.kernels.posing import Costs, Prior, Samples, Ties, View, affines, energies, refined
from roam_core.kernels.region_sums import region_sums, row_sums
from roam_core.kernels.ribbon_means import ribbon_means
from roam_core.kernels.settling import settled
from roam_core.kernels.spline_fit import nearest_places, normal_band
from roam_core.motion.patches import Levels, Patches
from roam_core.params import ANCHORS, TextureParams
from roam_core.params.patches import PatchParams
from roam_core.proposal.outline.invariants import surroundings

Case = tuple[Callable[..., Any], tuple[Any, ...], dict[str, Any]]

SIZE = (480, 854)
GRID = (120, 160)
"""Cells of the evidence grid around an object."""
NODES, WINDOW, COMPONENTS = 100, 5, 3


def _call(function: Callable[..., Any], *args: Any, **kwargs: Any) -> Case:
    return function, args, kwargs


def _rng() -> np.random.Generator:
    return np.random.default_rng(0)


def _outline(count: int = NODES, radius: float = 90.0, centre: tuple[float, float] = (427.0, 240.0)) -> Any:
    """A wavy closed polyline `(count, 2)`."""
    angle = np.arange(count) * 2.0 * np.pi / count
    reach = radius * (1.0 + 0.2 * np.cos(5.0 * angle))[:, None]
    return np.asarray(centre) + reach * np.stack([np.cos(angle), np.sin(angle)], axis=1)


def _moves() -> Any:
    ticks = np.arange(WINDOW) - WINDOW // 2
    columns, rows = np.meshgrid(ticks, ticks)
    return np.stack([columns.ravel(), rows.ravel()], axis=1).astype(np.float64)


def _field(size: tuple[int, int] = SIZE) -> Any:
    return _rng().random(size, dtype=np.float32)


def _picture() -> Any:
    return np.clip(_rng().normal(120, 30, (*GRID, 3)), 0, 255).astype(np.uint8)


def _mixtures() -> tuple[Any, Any, Any]:
    rng = _rng()
    shape = NODES, COMPONENTS
    return np.full(shape, 1.0 / COMPONENTS), rng.uniform(0.0, 255.0, (*shape, 3)), np.full((*shape, 3), 400.0)


def _samples() -> tuple[Any, Any]:
    """Colours sorted by their edge, and where each edge's begin."""
    each = 80
    return _rng().uniform(0.0, 255.0, (NODES * each, 3)), np.arange(NODES + 1) * each


def _packed() -> Any:
    weight, mean, variance = _mixtures()
    constant = np.log(weight) - 0.5 * np.log(2.0 * np.pi * variance).sum(axis=2)
    return np.concatenate([mean, 0.5 / variance, constant[..., None]], axis=2).astype(np.float32)


def _moving(frames: int = 40, places: int = 120) -> Any:
    """An outline that swings to and fro `(frames, 1, places, 2)`."""
    swing = np.sin(np.arange(frames) / 6.0)[:, None, None] * np.array([20.0, 8.0])
    return (_outline(places) + swing)[:, None]


def _pricing() -> Case:
    lines = _outline(60), _outline(240, 93.0)
    ours, theirs = ((line, outward_normals(line), surroundings(line)) for line in lines)
    return _call(prices, ours, theirs, 12.0, 9.0, 1.0, 60.0)


def _alignment() -> Case:
    line, samples = _outline(60), _outline(240, 93.0)
    apart = np.square(line[:, None] - samples).sum(axis=2) / 144.0
    return _call(align, apart, np.full(60, 4.0), 6.0, np.arange(3))


def _anchoring() -> Case:
    anchors, choices = 24, 9
    places = np.arange(anchors)[:, None] * (480 // anchors) + np.arange(choices)
    return _call(
        anchored,
        _outline(480),
        places,
        np.zeros((anchors, choices)),
        np.zeros(anchors, bool),
        ANCHORS.looked_at,
        ANCHORS.hold,
    )


def _viterbi() -> Case:
    moves = len(_moves())
    rng = _rng()
    return _call(cyclic_viterbi, rng.random((NODES, moves)), rng.random((NODES, moves, moves)))


def _diffusion() -> Case:
    colours = 100.0 * _rng().random((*GRID, 3), dtype=np.float32)
    return _call(diffuse, _field(GRID), colours, np.ones(GRID, bool), 2.0, 12.0, 20)


def _colours() -> Case:
    return _call(nearest_colours, *_matched(), 5, 0.3)


def _background() -> Case:
    return _call(best_matches, _picture(), _picture(), np.ones(GRID, dtype=bool), 5, 1, 2.0, 0.5)


def _learned() -> tuple[Patches, Levels]:
    """The patches of a blurred picture, and the levels of the same."""
    grid, params = Grid.over(Region(0, 0, GRID[1], GRID[0]), 1.0), PatchParams()
    frame, inside = PreparedFrame(cv2.GaussianBlur(_picture(), (0, 0), 2.0)), np.zeros(GRID, dtype=bool)
    inside[20:-20, 20:-20] = True
    patches = Patches.learned(frame, inside, np.ones(GRID, dtype=bool), grid, 1.0, params)
    assert patches is not None
    return patches, Levels.of(frame, grid, params)


def _patches() -> Case:
    patches, now = _learned()
    start = patches.on_key
    beside = start.affines + np.array([1.0, -1.0, 0.0, 0.0, 0.0, 0.0])
    how = patches.alignment
    return _call(aligned, patches.templates, now.coarse, now.fine, beside, start.affines, start.likeness, how)


def _sides() -> Case:
    patches, now = _learned()
    places, weights = patches.on_key.affines, np.ones(len(patches.on_key.affines))
    said = patches.picture, patches.depth, now.fine, patches.params.alike, patches.params.ramp
    return _call(sides, patches.templates.centres, places, weights, patches.radius, *said)


def _log_ratio() -> Case:
    inside, outside = 400.0 * _rng().random((2, *GRID), dtype=np.float32)
    return _call(log_ratio, inside, outside, 2.0, 3.0)


def _matched() -> tuple[Any, ...]:
    rng = _rng()
    now, then = (rng.integers(0, 256, (*GRID, 3)).astype(np.float32) for _ in range(2))
    labels = np.full(GRID, OUTSIDE, dtype=np.uint8)
    labels[30:90, 40:120] = INSIDE
    wanted = np.zeros(GRID, bool)
    wanted[20:100, 30:130] = True
    shift = np.zeros((*GRID, 2), dtype=np.float32)
    return now, then, labels, wanted, shift


def _densities() -> Case:
    count = GRID[0] * GRID[1]
    rng = _rng()
    colours = 255.0 * rng.random((count, 3), dtype=np.float32)
    index = rng.integers(0, NODES, count).astype(np.int32)
    return _call(log_densities, colours, index, _packed(), -20.0, summed=False)


def _em() -> Case:
    colours, starts = _samples()
    return _call(em_steps, colours, starts, 1, _mixtures(), 20.0, 1)


def _matches() -> Case:
    colours, starts = _samples()
    return _call(matches, colours, starts, 1, _mixtures(), 2.5)


def _spline(count: int = 24) -> Any:
    """The wavy outline as a spline `(count, 3, 2)`."""
    anchors = _outline(count)
    tangent = (np.roll(anchors, -1, axis=0) - np.roll(anchors, 1, axis=0)) / 6.0
    return np.stack([anchors, anchors - tangent, anchors + tangent], axis=1)


def _places(samples: int, count: int = 24) -> Any:
    return np.arange(samples) * (count / samples)


def _nearest() -> Case:
    line, samples = _outline(400), _outline(480, 93.0)
    places = (np.arange(480) * 400) // 480
    return _call(nearest_places, line, outward_normals(line), samples, outward_normals(samples), places, 20, 9.0)


def _band() -> Case:
    prior = _spline()
    tangents = prior[:, 2] - prior[:, 1]
    tangents /= np.hypot(*tangents.T)[:, None]
    owner, smooth = np.arange(3 * len(prior)), np.ones(len(prior), bool)
    places = _places(480)
    return _call(
        normal_band, _outline(480, 93.0), places, prior.reshape(-1, 2), owner, tangents, smooth, (0.1, 0.1, 1.0)
    )


def _settling() -> Case:
    at = np.arange(0, 480, 6)
    return _call(
        settled, _outline(480, 93.0)[at] + 1.0, _outline(480, 93.0), at, np.full(80, 6.0), (0.007, 6.0), 3, 0.95
    )


def _posing() -> tuple[Any, ...]:
    """A limb of two bones on a picture of the area around it, with its prior and one spring."""
    rng = _rng()
    bones = np.array([[60.0, 60.0, -1.0, 0.0], [80.0, 60.0, 0.0, 0.0]])
    places = rng.uniform((40.0, 50.0), (100.0, 70.0), (1200, 2))
    skin = np.clip((places[:, :1] - 70.0) / 20.0, 0.0, 1.0)
    view = View(_picture().astype(np.float32), 1.0, 1.0, 0.0, 0.0, np.zeros(GRID, np.uint8), np.zeros(GRID, np.float32))
    weights = np.where(np.arange(1200) < 1000, 1e-3, -1e-4)
    samples = Samples(places, rng.normal(120, 30, (1200, 3)), weights, np.hstack([1.0 - skin, skin]))
    prior = Prior(np.zeros(7), np.full(7, 0.01), np.full(7, 0.01), 0.1, 0.1)
    ties = Ties(np.array([[40.0, 60.0]]), np.array([[1.0, 0.0]]), np.array([[42.0, 60.0]]), np.array([0.1]), 6.0)
    return view, samples, bones, Costs(12.0, 8.0, 0.5, 0.5), prior, ties


def _affines() -> Case:
    return _call(affines, _posing()[2], np.full(7, 0.1))


def _energies() -> Case:
    view, samples, bones, costs, prior, ties = _posing()
    return _call(energies, view, samples, bones, _rng().normal(0.0, 0.1, (100, 7)), costs, prior, ties)


def _refined() -> Case:
    view, samples, bones, costs, prior, ties = _posing()
    return _call(refined, view, samples, bones, np.zeros(7), costs, prior, ties, 12)


def _hypotheses() -> Case:
    rng = _rng()
    source = rng.normal(0, 50, (400, 2))
    target = source + rng.normal(0, 1, (400, 2)) + np.where(np.arange(400) < 100, 30.0, 0.0)[:, None]
    first = rng.integers(0, 400, 128)
    return _call(agreed_similarity, source, target, first, (first + rng.integers(1, 400, 128)) % 400, 2.0)


def _motions() -> Case:
    rng = _rng()
    spots = rng.normal(0, 1, (150, 2))
    motions = np.eye(3) + rng.normal(0, 0.05, (256, 3, 3))
    return _call(best_motion, motions, spots, spots + rng.normal(0, 0.02, spots.shape), 0.04, 1e-6)


def _trees() -> tuple[Any, Any, Any]:
    """Cells with the fourteen numbers of a texture, and the tests offered to each tree: which number, and its bound."""
    params, rng = TextureParams(), _rng()
    shape = params.trees, params.levels, params.tests
    samples = rng.random((14, GRID[0] * GRID[1])).astype(np.float32)
    return samples, rng.integers(14, size=shape, dtype=np.int32), rng.random(shape).astype(np.float32)


def _growing() -> Case:
    samples, features, bounds = _trees()
    return _call(grown, samples, samples[3] > 0.6, features, bounds)


def _one_test_a_level() -> tuple[Any, Any, Any]:
    """The same cells, and trees that have made their choice: the first test of each level."""
    samples, features, bounds = _trees()
    return samples, np.ascontiguousarray(features[..., 0]), np.ascontiguousarray(bounds[..., 0])


def _leaves() -> Case:
    samples, features, bounds = _one_test_a_level()
    tables = _rng().random((len(features), 2 ** features.shape[1])).astype(np.float32)
    return _call(mean_of_leaves, samples, features, bounds, tables)


CASES: dict[str, Callable[[], Case]] = {
    "affines": _affines,
    "agreed_similarity": _hypotheses,
    "align": _alignment,
    "aligned": _patches,
    "anchored": _anchoring,
    "best_matches": _background,
    "best_motion": _motions,
    "bin_counts": lambda: _call(bin_counts, _picture(), np.ones(GRID, dtype=bool)),
    "coverage": lambda: _call(coverage, _outline(), SIZE),
    "crossing_edges": lambda: _call(crossing_edges, _outline(400), True),
    "cubic_span_errors": lambda: _call(cubic_span_errors, _moving(), True, 0, 50.0),
    "cyclic_viterbi": _viterbi,
    "diffuse": _diffusion,
    "distance": lambda: _call(distance, _outline(), SIZE, 10.0),
    "distance_transform": lambda: _call(distance_transform, _rng().random((40, 13, 13)), 0.01),
    "edge_means": lambda: _call(edge_means, _field(), _outline(), _moves()),
    "em_steps": _em,
    "energies": _energies,
    "grown": _growing,
    "holds_centres": lambda: _call(holds_centres, _outline(), SIZE),
    "linear_span_errors": lambda: _call(linear_span_errors, _moving(), True, 0, 50.0),
    "log_ratio": _log_ratio,
    "nearest_colours": _colours,
    "log_densities": _densities,
    "looked_up": lambda: _call(looked_up, _picture(), _rng().random(32**3).astype(np.float32)),
    "matches": _matches,
    "mean_of_leaves": _leaves,
    "nearest_edges": lambda: _call(nearest_edges, _outline(centre=(80.0, 60.0), radius=45.0), GRID, 20.0),
    "nearest_places": _nearest,
    "normal_band": _band,
    "outline_distances": lambda: _call(outline_distances, _moving(), _moving() + 1.5, True),
    "prices": _pricing,
    "refined": _refined,
    "region_sums": lambda: _call(region_sums, row_sums(_field()), _outline(), _moves()),
    "ribbon_means": lambda: _call(ribbon_means, _field(), _field(), _outline(), _moves(), 8.0, 2.0),
    "row_sums": lambda: _call(row_sums, _field()),
    "settled": _settling,
    "shares": lambda: _call(shares, *_one_test_a_level()),
    "sides": _sides,
    "step_counts": lambda: _call(step_counts, segments(_spline()), 0.05),
    "swept_coverage": lambda: _call(swept_coverage, _outline(), _outline() + 8.0, SIZE),
    "vertices": lambda: _call(vertices, segments(_spline()), step_counts(segments(_spline()), 0.05)),
}
"""By the kernel's name: what makes its case."""


@pytest.mark.parametrize("name", list(CASES))
def test_kernel(name: str, benchmark: Any) -> None:
    function, args, kwargs = CASES[name]()
    function(*args, **kwargs)  # compiled, or read from the cache, before it is timed
    benchmark(function, *args, **kwargs)
