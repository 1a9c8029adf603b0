"""How far an outline lies beyond where the picture's motion takes the one of the frame before."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.features import PreparedFrame
from roam_core.geometry.polyline import resample
from roam_core.params.steadiness import RESIDUAL
from roam_core.propagate.steadiness.residual import Flows, Places, beyond, residual
from tests.golden.shots import Shot, blob, gliding

SCALE = 1.0


@pytest.fixture(scope="module")
def shot() -> Shot:
    """A disc that goes 3 pixels to the right before a background that stands still."""
    return gliding(blob(np.full(8, 30.0)), 2, (80.0, 60.0), (3.0, 0.0))


@pytest.fixture(scope="module")
def flows(shot: Shot) -> Flows:
    before, after = (PreparedFrame(shot.read(frame)) for frame in shot.frames)
    found = Flows.of(before, after, [shot.truth(frame) for frame in shot.frames], RESIDUAL, SCALE)
    assert found is not None
    return found


def test_an_outline_that_goes_with_its_object_has_none(shot: Shot, flows: Flows) -> None:
    before, after = (shot.truth(frame) for frame in shot.frames)
    found = residual(flows, before, after, Places.of(before, RESIDUAL, SCALE), RESIDUAL, SCALE)
    assert np.abs(found).mean() < 0.25


def test_one_that_stays_behind_lies_outside_at_the_back_and_inside_at_the_front(shot: Shot, flows: Flows) -> None:
    before = shot.truth(shot.first)
    places = Places.of(before, RESIDUAL, SCALE)
    found = residual(flows, before, before, places, RESIDUAL, SCALE)
    _, outward = places.on(before)
    assert found == pytest.approx(-3.0 * outward[:, 0], abs=0.8)


def test_a_hole_goes_with_what_lies_around_it(shot: Shot, flows: Flows) -> None:
    """Around the disc nothing moves: a hole that stays does right, one that goes along with the disc does not.

    Looked at 10 px off: nearer by, flow takes the motion of the bright disc for that of what lies beside it, too.
    """
    far = replace(RESIDUAL, inset=10.0)
    before, after = (shot.truth(frame) for frame in shot.frames)
    places = Places.of(before, RESIDUAL, SCALE)
    stays = residual(flows, before, before, places, far, SCALE, subtracts=True)
    goes = residual(flows, before, after, places, far, SCALE, subtracts=True)
    assert np.abs(stays).mean() < 0.6 < 1.2 < np.abs(goes).mean()


def test_what_was_lost_counts_as_so_far_off_and_no_farther(shot: Shot, flows: Flows) -> None:
    before = shot.truth(shot.first)
    places = Places.of(before, RESIDUAL, SCALE)
    found = residual(flows, before, before + 60.0, places, RESIDUAL, SCALE)
    assert np.abs(found).max() == RESIDUAL.most


def test_how_far_a_ring_lies_beyond_is_asked_of_its_nearest_spot() -> None:
    """A circle within a larger one, whose vertices lie elsewhere: the difference of the radii all around."""
    angle = np.linspace(0.0, 2.0 * np.pi, 120, endpoint=False)
    circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    larger = resample(np.roll(25.0 * circle, 3, axis=0), 120)
    assert beyond(20.0 * circle, circle, larger, RESIDUAL.along) == pytest.approx(np.full(120, 5.0), abs=0.05)


def test_places_lie_about_evenly_and_on_every_point(shot: Shot) -> None:
    points = shot.truth(shot.first)
    places = Places.of(points, RESIDUAL, SCALE)
    positions, outward = places.on(points)
    gaps = np.hypot(*(np.roll(positions, -1, axis=0) - positions).T)
    assert gaps.max() <= RESIDUAL.spacing * 1.3
    assert positions[places.t == 0] == pytest.approx(points[:, 0])
    away = positions - points[:, 0].mean(axis=0)
    assert ((away * outward).sum(axis=1) > 0).all()


def test_out_of_the_picture_there_is_no_motion(shot: Shot) -> None:
    picture = PreparedFrame(shot.read(shot.first))
    assert Flows.of(picture, picture, [shot.truth(shot.first) + 5000.0], RESIDUAL, SCALE) is None
