"""Outlines on real pictures with the context that the engine looks at: where solver and oracle have to agree."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core.arrays import Array, UInt8
from roam_core.energy.total import CurveContext
from roam_core.features import PreparedFrame
from roam_core.geometry import similarity
from roam_core.matte.vectorise import read_mask, shapes_from_mask
from roam_core.params import CONFIGS, AppearanceParams, RoamParams, scale_for
from roam_core.propagate.curves.step import begin, curve_context
from tests.golden.shots import Shot, blob, pose


@dataclass(frozen=True)
class Problem:
    """Nodes to be moved on a picture."""

    nodes: Array
    context: CurveContext
    params: RoamParams
    scale: float


def problem(image: UInt8, points: Array, params: RoamParams) -> Problem:
    """What the engine would solve if a pre-warp had left `points` a few pixels beside their object."""
    frame = PreparedFrame(image)
    scale = scale_for(frame.size)
    beside = similarity.apply(np.array([[1.0, -0.02, 2.6], [0.02, 1.0, -1.7]]), points)
    state = begin(frame, points, params)
    nodes = state.nodes.nodes(beside)
    return Problem(nodes, curve_context(frame, nodes, params, scale, state.models), params, scale)


CHOICES = {
    "drawn": ("drawn", RoamParams()),
    "drawn, competition": ("drawn", CONFIGS["lean"]),
    "drawn, rest at the pre-warp": ("drawn", replace(CONFIGS["lean"], mu=0.6, l2_rest=1.0)),
    "drawn, ribbon": (
        "drawn",
        replace(CONFIGS["lean"], lambda_local=0.2, window=3, appearance=AppearanceParams(term="ribbon")),
    ),
    "photograph": ("car-turn", RoamParams()),
    "photograph, competition": ("car-turn", CONFIGS["lean"]),
}


@pytest.fixture(
    params=[pytest.param(name, marks=[pytest.mark.shared] * name.startswith("photo")) for name in CHOICES],
    ids=list(CHOICES),
)
def real(request: pytest.FixtureRequest) -> Problem:
    """Problems on a drawn picture and on a photograph, without colour and with it."""
    picture, params = CHOICES[request.param]
    if picture == "drawn":
        shot = Shot(blob([34.0, 26.0, 22.0, 30.0, 36.0, 24.0]), (pose(80.0, 60.0),))
        return problem(shot.read(shot.first), shot.truth(shot.first), params)
    data: Path = request.getfixturevalue("shared") / "data" / "davis2016-train"
    photograph = cv2.imread(str(data / "JPEGImages" / "car-turn" / "00000.jpg"))
    mask = read_mask(data / "Annotations" / "car-turn" / "00000.png")
    return problem(np.ascontiguousarray(photograph[..., ::-1]), shapes_from_mask(mask)[0].keys[0].points, params)
