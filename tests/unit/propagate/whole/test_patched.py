"""What whole objects make of their patches: points, and whether all of it goes with one pose."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import numpy.testing as npt
import pytest

from roam_core.arrays import UInt8
from roam_core.features import PreparedFrame
from roam_core.geometry.bezier import ANCHOR, polygon_points
from roam_core.params import params_for
from roam_core.propagate.frame.result import Part
from roam_core.propagate.whole import patched, posed
from roam_core.propagate.whole.region import step
from roam_core.propagate.whole.state import RegionState, begin

PARAMS = replace(params_for("best").region, rigid=2.0)
SIZE = 240, 320
DRAWN = polygon_points([(90, 60), (210, 60), (210, 180), (90, 180)])

SLID, WENT = np.array([9.0, 4.0]), np.array([4.0, 0.0])


def texture(seed: int) -> UInt8:
    rough = np.random.default_rng(seed).integers(0, 256, (*SIZE, 3)).astype(np.uint8)
    return np.asarray(cv2.normalize(cv2.GaussianBlur(rough, (0, 0), 2.0), None, 30, 220, cv2.NORM_MINMAX), np.uint8)  # type: ignore[call-overload]


def read(frame: int, lower: float = 0.0) -> PreparedFrame:
    """A card that goes right by 2 pixels a frame before a still wall; its lower half by `lower` more."""
    image = texture(1)
    for rows, x in ((slice(60, 120), 2.0 * frame), (slice(120, 180), (2.0 + lower) * frame)):
        moved = cv2.warpAffine(texture(2), np.array([[1.0, 0.0, x], [0.0, 1.0, 0.0]]), SIZE[::-1])
        left = 90 + round(x)
        image[rows, left : left + 120] = moved[rows, left : left + 120]
    return PreparedFrame(image)


def after(frames: int, lower: float = 0.0) -> RegionState:
    state = begin(read(0), (Part(DRAWN),), PARAMS)
    for frame in range(1, frames + 1):
        state = step(state, read(frame, lower), PARAMS).state
    return state


def test_points_that_slid_are_expected_where_the_patches_have_them() -> None:
    state = after(2)
    (part,), (drawn,), (constraints,) = state.parts, state.drawn, state.constraints
    slid, to_now = replace(part, points=part.points + SLID), state.key.to_now
    args = slid, drawn, constraints, to_now
    found = patched.expected_points(*args, state.patches, state.patch_motion, PARAMS, 0.5)
    npt.assert_allclose(found[:, ANCHOR], (DRAWN + WENT)[:, ANCHOR], atol=1.5)
    alone = patched.expected_points(*args, None, None, PARAMS, 0.5)
    assert np.hypot(*(alone - DRAWN - WENT)[:, ANCHOR].T).min() > 6.0


@pytest.mark.parametrize(("lower", "goes"), [(0.0, True), (4.0, False)])
def test_an_object_whose_halves_part_does_not_go_with_one_pose(lower: float, goes: bool) -> None:
    state = after(3, lower)
    pose = posed.learned(read(0), DRAWN[:, ANCHOR], PARAMS.pose, ())
    assert pose is not None
    for frame in range(1, 4):
        pose = posed.step(pose, state.drawn, read(frame - 1, lower), read(frame, lower), PARAMS)
    assert patched.go_with(pose, state.patches, state.patch_motion, PARAMS) is goes
    assert patched.go_with(pose, None, None, PARAMS)


def test_patches_are_learned_only_where_they_are_asked() -> None:
    assert after(0).patches is not None
    none = begin(read(0), (Part(DRAWN),), replace(PARAMS, patches=None))
    assert none.patches is none.patch_motion is None
    assert step(none, read(1), none.params).state.patch_motion is None
