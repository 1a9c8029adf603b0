"""What `boil` tells of outlines whose motion, and trembling, is known."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.cancel import Cancelled, CancelToken
from roam_core.media.source import MissingFrame
from roam_core.params.steadiness import RESIDUAL
from roam_core.propagate.steadiness.boil import boil
from roam_core.roto import Keyframe, RotoShape
from tests.golden.shots import Shot, gliding, square

FRAMES = range(1001, 1008)


@pytest.fixture(scope="module")
def shot() -> Shot:
    return gliding(square(60.0), len(FRAMES), (80.0, 70.0), (1.3, -0.7))


def drawn(shot: Shot, off: dict[int, float] | None = None) -> RotoShape:
    """The true outline on every frame, but on some of them larger by so many pixels to each side."""
    grown = {frame: (off or {}).get(frame, 0.0) for frame in FRAMES}
    return RotoShape("box", "Box", tuple(Keyframe(frame, _grown(shot.truth(frame), by)) for frame, by in grown.items()))


def _grown(points: Array, by: float) -> Array:
    middle = points.reshape(-1, 2).mean(axis=0)
    half = np.ptp(points[:, 0], axis=0) / 2
    return np.asarray(middle + (points - middle) * (half + by) / half)


def test_an_outline_that_goes_with_what_it_outlines_does_not_boil(shot: Shot) -> None:
    found = boil(shot.read, [drawn(shot)], FRAMES, RESIDUAL)
    assert set(found) == {("box", frame) for frame in FRAMES[1:-1]}
    assert max(each.pixels for each in found.values()) < 0.15


def test_an_outline_that_grows_on_one_frame_boils_there_by_as_much(shot: Shot) -> None:
    """And by half of it on the two frames beside: what is off there is one neighbour of two."""
    found = boil(shot.read, [drawn(shot, {1004: 2.0})], FRAMES, RESIDUAL)
    assert found["box", 1004].pixels == pytest.approx(2.0, abs=0.2)
    assert found["box", 1003].pixels == pytest.approx(1.0, abs=0.2)
    assert found["box", 1002].pixels < 0.15
    assert np.median(found["box", 1004].across) == pytest.approx(2.0, abs=0.2)
    assert found["box", 1004].places.shape == (len(found["box", 1004].across), 2)


def test_where_a_picture_is_missing_nothing_is_told_of_it_or_its_neighbours(shot: Shot) -> None:
    def read(frame: int) -> Array:
        if frame == 1004:
            raise MissingFrame("gone")
        return shot.read(frame)

    assert {frame for _, frame in boil(read, [drawn(shot)], FRAMES, RESIDUAL)} == {1002, 1006}


def test_open_shapes_and_frames_without_the_shape_are_left_out(shot: Shot) -> None:
    shape = drawn(shot)
    assert boil(shot.read, [replace(shape, closed=False)], FRAMES, RESIDUAL) == {}
    short = boil(shot.read, [replace(shape, lifetime=(1003, 1006))], FRAMES, RESIDUAL)
    assert {frame for _, frame in short} == {1004}


def test_a_shape_out_of_the_picture_has_no_boil(shot: Shot) -> None:
    away = RotoShape("away", "Away", (Keyframe(1001, shot.truth(1001) + 5000.0),))
    assert boil(shot.read, [away], FRAMES, RESIDUAL) == {}


def test_it_stops_when_it_is_told_to(shot: Shot) -> None:
    token = CancelToken()
    told: list[float] = []

    def progress(fraction: float, _: str) -> None:
        told.append(fraction)
        if len(told) == len(FRAMES) // 2:
            token.cancel()

    with pytest.raises(Cancelled):
        boil(shot.read, [drawn(shot)], FRAMES, RESIDUAL, token, progress)
    assert len(told) == len(FRAMES) // 2
