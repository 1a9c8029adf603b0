"""The pre-warp's ways, behind one face."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.features import PreparedFrame
from roam_core.geometry import bezier, similarity
from roam_core.motion.warp import warp
from roam_core.params import RoamParams
from tests.golden.shots import blob, gliding

SHOT = gliding(blob([30.0, 24.0, 20.0, 26.0, 32.0, 22.0]), 2, (70.0, 58.0), (4.0, 2.0))
LINE = bezier.flatten(SHOT.truth(SHOT.first))
BEFORE, AFTER = (PreparedFrame(SHOT.read(frame)) for frame in SHOT.frames)


@pytest.mark.parametrize(("way", "moved"), [("none", (0.0, 0.0)), ("klt", (4.0, 2.0)), ("flow", (4.0, 2.0))])
def test_each_way_finds_what_it_can(way: str, moved: tuple[float, float]) -> None:
    found = warp(BEFORE, AFTER, LINE, replace(RoamParams(), warp=way), 1.0)
    middle = LINE.mean(axis=0)
    np.testing.assert_allclose(similarity.apply(found.transform, middle) - middle, moved, atol=1.0)
    assert (found.points > 2) == (way != "none")


@pytest.mark.parametrize("way", ["none", "klt", "flow"])
def test_a_shape_outside_the_picture_stands_still(way: str) -> None:
    found = warp(BEFORE, AFTER, LINE + 5000.0, replace(RoamParams(), warp=way), 1.0)
    np.testing.assert_array_equal(found.transform, similarity.IDENTITY)
    assert found.points == 0


def test_a_way_that_does_not_exist_is_refused_in_a_sentence() -> None:
    with pytest.raises(RoamError, match="no pre-warp 'teleport'"):
        warp(BEFORE, AFTER, LINE, replace(RoamParams(), warp="teleport"), 1.0)
