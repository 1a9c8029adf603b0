"""Colour models of the edges: what they learn, where, and what they remember."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.appearance.band import Band
from roam_core.appearance.edge_models import EdgeModels, ribbon_samples
from roam_core.appearance.gmm import FLOOR
from roam_core.arrays import Array, UInt8
from roam_core.features import PreparedFrame
from roam_core.geometry import polyline
from roam_core.params import AppearanceParams

PARAMS = AppearanceParams(key_share=0.3, clip=6.0)
NODES = polyline.resample(np.array([(20.0, 20.0), (60.0, 20.0), (60.0, 60.0), (20.0, 60.0)]), 20)
"""A square, clockwise on screen, of edges eight pixels long."""


def picture(above: int = 60, left: int = 200, right: int = 120, seed: int = 0) -> UInt8:
    """A square whose halves have different greys, on a background of a third, with grain."""
    image = np.full((80, 80, 3), above, dtype=np.float64)
    image[20:60, 20:40], image[20:60, 40:60] = left, right
    image += np.random.default_rng(seed).normal(0.0, 3.0, image.shape)
    return np.clip(image, 0, 255).astype(np.uint8)


def ratio(models: EdgeModels, image: UInt8, params: AppearanceParams = PARAMS) -> Array:
    frame = PreparedFrame(image)
    band = Band.around(frame, NODES, 10.0, 1.0)
    inside, outside = models.log_densities(band, params)
    whole = np.zeros(frame.size)
    rows, columns = band.grid.region.slices
    whole[rows, columns] = inside - outside
    return whole


def test_samples_are_the_ribbons_pixels_by_edge_and_side() -> None:
    inside, outside = ribbon_samples(PreparedFrame(picture()), NODES, PARAMS, 1.0)
    assert outside.colours[:, 0].max() < 100.0 < inside.colours[:, 0].max()
    middle = 2  # the third edge of the upper side
    assert outside.starts[middle + 1] - outside.starts[middle] == pytest.approx(7 * 8, abs=12)


def test_each_edge_knows_its_own_colours() -> None:
    """Grey of the left half speaks for the object beside the left half alone."""
    models = EdgeModels.learned(PreparedFrame(picture()), NODES, PARAMS, 1.0)
    here = ratio(models, picture(seed=1))
    assert (here[22:58, 22:26] > 2.0).mean() > 0.9
    assert (here[22:58, 12:18] < -2.0).mean() > 0.9
    swapped = ratio(models, picture(left=120, right=200, seed=1))
    assert (swapped[30:50, 22:26] < 2.0).mean() > 0.9
    assert not here[38:42, 38:42].any()


def test_an_adapted_model_knows_the_new_and_never_forgets_the_key() -> None:
    key, later = PreparedFrame(picture()), picture(left=20, seed=2)
    models = EdgeModels.learned(key, NODES, PARAMS, 1.0)
    stripe = (slice(30, 50), slice(22, 27))
    before = ratio(models, later)[stripe].mean()
    for _ in range(40):
        models = models.adapted(PreparedFrame(later), NODES, PARAMS, 1.0, 1.0)
    assert ratio(models, later)[stripe].mean() > before + 2.0
    assert ratio(models, picture(seed=3))[stripe].mean() > 2.0
    forgetful = replace(PARAMS, key_share=0.0)
    assert (
        ratio(models, picture(seed=3), forgetful)[stripe].mean() < ratio(models, picture(seed=3))[stripe].mean() - 1.0
    )


def test_no_confidence_teaches_nothing() -> None:
    models = EdgeModels.learned(PreparedFrame(picture()), NODES, PARAMS, 1.0)
    after = models.adapted(PreparedFrame(picture(left=20)), NODES, PARAMS, 1.0, 0.0)
    np.testing.assert_allclose(after.inside.mean, models.inside.mean)


def test_what_lies_outside_the_picture_says_nothing() -> None:
    """Beyond the border one side of an edge cannot be seen: the other must not win for that."""
    frame = PreparedFrame(picture())
    nodes = NODES - np.array([20.0, 0.0])
    models = EdgeModels.learned(frame, nodes, PARAMS, 1.0)
    left = np.flatnonzero((nodes[:, 0] == 0.0) & (nodes[:, 1] > 30.0) & (nodes[:, 1] < 50.0))
    assert len(left) >= 2
    assert not models.inside.weight[left].any()
    far = EdgeModels.learned(frame, nodes + 500.0, PARAMS, 1.0)
    assert not far.inside.weight.any()
    inside, outside = far.log_densities(Band.around(frame, nodes + 500.0, 10.0, 1.0), PARAMS)
    assert inside == pytest.approx(FLOOR)
    assert outside == pytest.approx(FLOOR)


def test_the_cost_does_not_grow_with_the_size_of_the_image() -> None:
    double = np.kron(picture(), np.ones((2, 2, 1), np.uint8))
    small, large = (
        ribbon_samples(PreparedFrame(image), scale * NODES, PARAMS, scale)[0]
        for image, scale in ((picture(), 1.0), (double, 2.0))
    )
    assert len(large.colours) == pytest.approx(len(small.colours), rel=0.05)
