"""The global models, mixtures and histograms: inside against surroundings, and what is remembered of the key."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.appearance.band import Band
from roam_core.appearance.colour_models import ColourModels
from roam_core.appearance.global_histogram import GlobalHistogram
from roam_core.appearance.global_mixture import GlobalMixture
from roam_core.arrays import UInt8
from roam_core.features import PreparedFrame
from roam_core.geometry import polyline
from roam_core.params import CONFIGS, AppearanceParams, RoamParams

Kind = type[GlobalMixture] | type[GlobalHistogram]
KINDS = pytest.mark.parametrize("kind", [GlobalMixture, GlobalHistogram])
PARAMS = AppearanceParams(clip=6.0)
NODES = polyline.resample(np.array([(30.0, 30.0), (70.0, 30.0), (70.0, 70.0), (30.0, 70.0)]), 20)


def picture(inside: int, outside: int = 60) -> UInt8:
    image = np.full((100, 100, 3), outside, dtype=np.float64)
    image[30:70, 30:70] = inside
    image += np.random.default_rng(inside).normal(0.0, 3.0, image.shape)
    return np.clip(image, 0, 255).astype(np.uint8)


def agreement(model: GlobalMixture | GlobalHistogram, image: UInt8) -> float:
    """Mean of the log-ratio inside less its mean outside, over the band."""
    band = Band.around(PreparedFrame(image), NODES, 12.0, 1.0)
    ratio = model.log_ratio(band, PARAMS)
    assert not ratio[~band.near].any()
    return float(ratio[band.near & band.inside].mean() - ratio[band.near & ~band.inside].mean())


@KINDS
def test_it_tells_the_object_from_its_surroundings_wherever_they_are(kind: Kind) -> None:
    model = kind.learned(PreparedFrame(picture(200)), NODES, PARAMS, 1.0)
    assert agreement(model, picture(200)) > 5.0
    assert agreement(model, picture(60, 200)) < -5.0


@KINDS
def test_it_learns_what_changes_and_remembers_the_key(kind: Kind) -> None:
    model = kind.learned(PreparedFrame(picture(200)), NODES, PARAMS, 1.0)
    before = agreement(model, picture(120))
    for _ in range(30):
        model = model.adapted(PreparedFrame(picture(120)), NODES, PARAMS, 1.0, 1.0)
    assert agreement(model, picture(120)) > before + 3.0
    assert agreement(model, picture(200)) > (5.0 if kind is GlobalMixture else 3.0)


@KINDS
def test_a_shape_without_an_inside_knows_nothing(kind: Kind) -> None:
    model = kind.learned(PreparedFrame(picture(200)), NODES + 1000.0, PARAMS, 1.0)
    assert agreement(model, picture(200)) == 0.0


def test_models_are_made_as_the_configuration_asks() -> None:
    frame = PreparedFrame(picture(200))
    assert ColourModels.learned(frame, NODES, RoamParams(), 1.0) is None
    lean = ColourModels.learned(frame, NODES, CONFIGS["lean"], 1.0)
    assert lean is not None
    assert lean.whole is None
    both = ColourModels.learned(frame, NODES, replace(CONFIGS["lean"], lambda_global=0.01), 1.0)
    assert both is not None
    assert isinstance(both.whole, GlobalMixture)
    full = ColourModels.learned(frame, NODES, CONFIGS["full"], 1.0)
    assert full is not None
    assert isinstance(full.whole, GlobalHistogram)


def test_only_a_trusted_frame_teaches() -> None:
    params = replace(CONFIGS["lean"], lambda_global=0.01)
    models = ColourModels.learned(PreparedFrame(picture(200)), NODES, params, 1.0)
    assert models is not None
    frame = PreparedFrame(picture(120))
    assert models.adapted(frame, NODES, params, 1.0, 0.1) is models
    taught = models.adapted(frame, NODES, params, 1.0, 0.9)
    assert not np.array_equal(taught.edges.inside.mean, models.edges.inside.mean)
    assert isinstance(taught.whole, GlobalMixture)
    assert isinstance(models.whole, GlobalMixture)
    assert not np.array_equal(taught.whole.inside.weight, models.whole.inside.weight)
