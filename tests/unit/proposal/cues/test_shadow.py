"""Shadows over a part of the picture: that there are any is told by the background, where by all that is expected."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest

from roam_core.arrays import Array, UInt8
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.params.evidence import ExposureParams
from roam_core.proposal.cues.exposure import UNCHANGED, Light, light_since
from roam_core.proposal.cues.key_view import KeyView
from roam_core.proposal.cues.shadow import relit

SIDE = 120
GRID = Grid(Region(0, 0, SIDE, SIDE), SIDE, SIDE)
PARAMS = ExposureParams()
EVERYWHERE = np.ones((SIDE, SIDE), bool)


def ground(seed: int = 3) -> UInt8:
    """Soft texture `(SIDE, SIDE, 3)`."""
    noise = np.random.default_rng(seed).normal(size=(SIDE, SIDE, 3))
    soft = np.dstack([cv2.GaussianBlur(channel, (0, 0), 2.0) for channel in np.moveaxis(noise, -1, 0)])
    return np.uint8(np.clip(110.0 + 40.0 * soft / soft.std(), 40, 180))


def under(picture: UInt8, factors: Array) -> UInt8:
    return np.uint8(np.clip(np.round(picture * factors[..., None]), 0, 255))


def half(by: float, beyond: int = SIDE // 2) -> Array:
    """Factors `(SIDE, SIDE)`: `by` on the right, from a column on."""
    factors = np.ones((SIDE, SIDE))
    factors[:, beyond:] = by
    return factors


def told(now: UInt8, key: UInt8) -> Light:
    view = KeyView(PreparedFrame(key), np.eye(3), GRID, np.zeros((SIDE, SIDE), np.float32))
    return light_since(view, PreparedFrame(now), np.zeros((SIDE, SIDE), bool), UNCHANGED, PARAMS)


@pytest.mark.parametrize("by", [0.4, 0.6, 1.5])
def test_a_shadow_that_came_or_went_is_told_beside_the_light_of_most(by: float) -> None:
    light = told(under(ground(), half(by, 2 * SIDE // 3)), ground())
    assert light.shades == pytest.approx((by,), rel=0.03)
    assert light.exposure == 1.0
    (part,) = light.in_parts
    assert (part.exposure, part.shades) == (pytest.approx(by, rel=0.03), ())


def test_shadows_that_moved_on_leave_darker_and_brighter_parts() -> None:
    key = under(ground(), np.roll(half(0.5, 3 * SIDE // 4), -SIDE // 2, axis=1))
    assert told(under(ground(), half(0.5, 3 * SIDE // 4)), key).shades == pytest.approx((0.5, 2.0), rel=0.05)


def test_what_is_little_or_of_no_one_light_is_no_shadow() -> None:
    assert not told(under(ground(), half(0.5, SIDE - 8)), ground()).shades
    patches = np.kron(np.random.default_rng(5).uniform(0.25, 0.66, (6, 6)), np.ones((20, 20)))
    factors = np.where(np.arange(SIDE) < SIDE // 3, 1.0, patches)
    assert not told(under(ground(), factors), ground()).shades
    assert not told(ground(), ground()).shades


def test_what_lies_in_a_shadow_comes_into_the_light_and_all_else_stays() -> None:
    light = replace(UNCHANGED, shades=(0.5,))
    now = under(ground(), half(0.5))
    found = relit(PreparedFrame(now), light, GRID, [(ground(), EVERYWHERE)], PARAMS.shadow)
    assert found is not None
    edge = slice(SIDE // 2 - 8, SIDE // 2 + 8)
    apart = np.abs(found.image.astype(float) - ground()).max(axis=2)
    assert np.delete(apart, np.r_[edge], axis=1).max() <= 2.0
    assert relit(PreparedFrame(ground()), light, GRID, [(ground(), EVERYWHERE)], PARAMS.shadow) is None


def test_the_nearest_of_what_is_expected_tells() -> None:
    """Where the key's background knows nothing, and the last frame has something else, the object still tells."""
    light, now = replace(UNCHANGED, shades=(0.5,)), under(ground(), half(0.5))
    left = np.arange(SIDE)[None, :] < SIDE // 2
    expected = [(ground(), EVERYWHERE & left), (ground(8), EVERYWHERE), (ground(), EVERYWHERE & ~left)]
    found = relit(PreparedFrame(now), light, GRID, expected, PARAMS.shadow)
    assert found is not None
    assert np.abs(found.image[:, SIDE // 2 + 8 :].astype(float) - ground()[:, SIDE // 2 + 8 :]).max() <= 2.0
