"""What the key's patches say among the other cues."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import numpy.testing as npt

from roam_core.arrays import Float32
from roam_core.params import RegionParams
from roam_core.proposal.cues.evidence import cues, gathered
from roam_core.proposal.cues.patch_sides import PatchSides
from tests.unit.proposal.cues.test_label_propagation import seen

PARAMS = RegionParams()


def everywhere(shape: tuple[int, int], value: float) -> Float32:
    return np.full(shape, value, np.float32)


def test_what_patches_put_inside_counts_as_the_keys_word() -> None:
    sources = seen()
    shape = sources.grid.shape
    sure = replace(sources, patches=PatchSides(everywhere(shape, 1.0), everywhere(shape, 0.0)))
    told = dict(cues(sure, PARAMS))
    npt.assert_allclose(told["lineage"], PARAMS.label_propagation_weight)
    alone = dict(cues(replace(sources, label_propagation=None), PARAMS))
    for name, cue in alone.items():
        npt.assert_allclose(told[name], PARAMS.beside_label_propagation * cue, rtol=1e-6)
    assert gathered(sure, PARAMS).inside[sources.band].all()


def test_what_they_put_outside_is_evidence_among_others() -> None:
    sources = seen()
    against = replace(
        sources, patches=PatchSides(everywhere(sources.grid.shape, 0.0), everywhere(sources.grid.shape, 0.5))
    )
    told, before = dict(cues(against, PARAMS)), dict(cues(sources, PARAMS))
    npt.assert_allclose(told.pop("patches"), -0.5 * PARAMS.patches_outside)
    for name, cue in before.items():
        npt.assert_array_equal(told[name], cue)


def test_patches_that_say_nothing_change_nothing() -> None:
    sources = seen()
    nothing = PatchSides(everywhere(sources.grid.shape, 0.0), everywhere(sources.grid.shape, 0.0))
    npt.assert_array_equal(gathered(replace(sources, patches=nothing), PARAMS).values, gathered(sources, PARAMS).values)
