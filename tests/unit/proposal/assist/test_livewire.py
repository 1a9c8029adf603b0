"""The magnetic lasso's paths: along edges, from place to place, within a piece of the picture."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roam_core.arrays import Array, UInt8
from roam_core.proposal.assist.livewire import LiveWire, snapped

CENTRE, RADIUS = (100.0, 80.0), 50.0


@pytest.fixture(scope="module")
def disc() -> UInt8:
    """A light disc on grainy dark background, 200 x 160."""
    picture = np.random.default_rng(4).normal(60.0, 4.0, (160, 200, 3))
    inside = np.hypot(*(np.mgrid[:160, :200] + 0.5 - np.array(CENTRE[::-1])[:, None, None])) < RADIUS
    picture[inside] += 120.0
    return cv2.GaussianBlur(picture, (0, 0), 0.7).astype(np.uint8)


def on_circle(degrees: float, radius: float = RADIUS) -> tuple[float, float]:
    angle = np.radians(degrees)
    return CENTRE[0] + radius * float(np.cos(angle)), CENTRE[1] + radius * float(np.sin(angle))


def off_circle(path: Array) -> Array:
    return np.abs(np.hypot(*(path - CENTRE).T) - RADIUS)


@pytest.mark.parametrize("step", [1.0, 2.0])
def test_the_path_follows_the_edge(disc: UInt8, step: float) -> None:
    start, end = on_circle(10.0), on_circle(100.0)
    path = LiveWire.around(disc, start, 120.0, step).path(end)
    assert tuple(path[0]) == start
    assert tuple(path[-1]) == end
    assert off_circle(path).max() < 2.0 * step
    assert np.hypot(*np.diff(path, axis=0).T).max() < 3.0 * step


def test_beyond_its_piece_the_path_goes_on_straight(disc: UInt8) -> None:
    wire = LiveWire.around(disc, on_circle(0.0), 30.0)
    assert wire.holds(on_circle(20.0))
    assert not wire.holds((20.0, 20.0))
    path = wire.path((20.0, 20.0))
    assert tuple(path[-1]) == (20.0, 20.0)
    assert wire.holds((float(path[-2][0]), float(path[-2][1])))


def test_a_seed_outside_is_put_on_the_border(disc: UInt8) -> None:
    wire = LiveWire.around(disc, (-40.0, 300.0), 40.0)
    assert wire.holds(wire.seed)
    np.testing.assert_allclose(wire.seed, (0.0, 160.0), atol=1e-3)
    assert len(wire.path((10.0, 150.0))) > 2


def test_a_picture_of_a_few_pixels_has_paths() -> None:
    wire = LiveWire.around(np.zeros((4, 5, 3), dtype=np.uint8), (2.0, 2.0), 50.0)
    np.testing.assert_array_equal(wire.path((4.5, 0.5))[[0, -1]], [(2.0, 2.0), (4.5, 0.5)])


@pytest.mark.parametrize("away", [-4.0, 4.0])
def test_a_place_snaps_to_the_edge_nearby(disc: UInt8, away: float) -> None:
    found = snapped(disc, on_circle(30.0, RADIUS + away), 6.0)
    assert off_circle(np.array([found])).max() < 1.5


def test_far_from_edges_a_place_stays(disc: UInt8) -> None:
    flat = np.full((50, 50, 3), 80, dtype=np.uint8)
    assert snapped(flat, (20.3, 30.7), 6.0) == (20.3, 30.7)
    assert snapped(disc, (-80.0, 20.0), 6.0) == (-80.0, 20.0)
