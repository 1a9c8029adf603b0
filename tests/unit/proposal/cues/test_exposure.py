"""How much brighter the picture has become since the key: told only where its background agrees on it."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.arrays import Array, Bools, UInt8
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.params.evidence import ExposureParams
from roam_core.proposal.cues.exposure import exposure_gain
from roam_core.proposal.cues.key_view import KeyView

SIDE = 120
GRID = Grid(Region(0, 0, SIDE, SIDE), SIDE, SIDE)
PARAMS = ExposureParams()
NOWHERE = np.zeros((SIDE, SIDE), bool)
WITHIN = float(np.exp(PARAMS.within))


def ground(seed: int = 3) -> UInt8:
    """Coarse texture `(SIDE, SIDE)`."""
    return np.uint8(np.kron(np.random.default_rng(seed).integers(60, 140, (SIDE // 4, SIDE // 4)), np.ones((4, 4))))


def lit(picture: UInt8, by: float | Array) -> UInt8:
    return np.uint8(np.clip(np.round(picture * by), 0, 255))


def told(now: UInt8, inside: Bools = NOWHERE, key: UInt8 | None = None, carried: Array | None = None) -> float | None:
    picture = np.repeat((ground() if key is None else key)[..., None], 3, axis=2)
    by = np.eye(3) if carried is None else carried
    view = KeyView(PreparedFrame(picture), by, GRID.warped(inside.astype(np.float32), by))
    return exposure_gain(view, now, inside, GRID, PARAMS)


@pytest.mark.parametrize("gain", [0.5, 0.65, 0.8, 1.25, 1.6])
def test_a_change_of_exposure_is_told_up_to_what_patches_differ_by(gain: float) -> None:
    expected = gain * WITHIN if gain < 1.0 else gain / WITHIN
    assert told(lit(ground(), gain)) == pytest.approx(expected, rel=0.01)


def test_the_same_light_is_no_change_at_all() -> None:
    grain = np.random.default_rng(4).normal(0.0, 3.0, (SIDE, SIDE))
    assert told(ground()) == 1.0
    assert told(np.uint8(np.clip(0.97 * ground() + grain, 0, 255))) == 1.0


def test_there_is_no_leap_where_a_change_begins() -> None:
    gains = [told(lit(ground(), gain)) for gain in np.linspace(0.9, 1.0, 21)]
    assert np.abs(np.diff(np.array(gains, float))).max() < 0.01


def test_it_is_told_where_the_camera_has_gone_on() -> None:
    carried = np.array([[1.0, 0.0, 8.0], [0.0, 1.0, -4.0], [0.0, 0.0, 1.0]])
    moved = np.roll(ground(), (-4, 8), axis=(0, 1))
    assert told(lit(moved, 0.6), carried=carried) == pytest.approx(0.6 * WITHIN, rel=0.02)


def test_shadows_on_some_of_it_are_no_change_of_exposure() -> None:
    third = np.ones((SIDE, SIDE))
    third[:, : SIDE // 3] = 0.5
    assert told(lit(ground(), third)) == 1.0


def test_nothing_is_told_where_patches_disagree() -> None:
    gains = np.kron(np.random.default_rng(5).uniform(0.5, 1.0, (SIDE // 20, SIDE // 20)), np.ones((20, 20)))
    assert told(lit(ground(), gains)) is None


def test_nothing_is_told_of_another_ground() -> None:
    assert told(ground(8)) is None


def test_nothing_is_told_by_what_is_flat() -> None:
    flat = np.full((SIDE, SIDE), 100, np.uint8)
    assert told(lit(flat, 0.7), key=flat) is None


def test_nothing_is_told_of_what_is_cut_at_white() -> None:
    bright = np.uint8(ground() // 8 + 235)
    assert told(lit(bright, 1.2), key=bright) is None


def test_the_object_itself_tells_nothing() -> None:
    inside = np.zeros((SIDE, SIDE), bool)
    inside[:, SIDE // 10 :] = True
    assert told(lit(ground(), np.where(inside, 0.5, 1.0)), inside) == 1.0
    inside[:] = True
    assert told(lit(ground(), 0.5), inside) is None
