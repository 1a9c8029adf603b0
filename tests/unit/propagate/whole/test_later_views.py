"""What comes into sight around an object after its key is kept, and known again."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest

from roam_core.arrays import Array, UInt8
from roam_core.features import PreparedFrame
from roam_core.geometry.bezier import polygon_points
from roam_core.params import params_for
from roam_core.propagate.frame.result import Part
from roam_core.propagate.whole.region import step
from roam_core.propagate.whole.state import RegionState, begin
from roam_core.proposal.cues.key_view import lab

PARAMS = params_for("best").region
BACKGROUND = PARAMS.background
SIZE = 160, 260
WORLD = 160, 800
LEFT, RIGHT, TOP, BOTTOM = 90, 150, 50, 110
DRAWN = polygon_points([(LEFT, TOP), (RIGHT, TOP), (RIGHT, BOTTOM), (LEFT, BOTTOM)])


def texture(seed: int, size: tuple[int, int], around: tuple[int, int, int]) -> UInt8:
    rough = np.random.default_rng(seed).normal(0.0, 1.0, (*size, 3))
    smooth = cv2.GaussianBlur(rough, (0, 0), 2.0)
    return np.uint8(np.clip(np.array(around) + 22.0 * smooth / smooth.std(), 0, 255))


GROUND, CARD = texture(1, WORLD, (110, 130, 90)), texture(2, (60, 60), (190, 90, 80))


def read(frame: int, pan: int) -> PreparedFrame:
    """A card that stays in the picture while the camera goes right along a wall, by `pan` pixels a frame."""
    image = GROUND[:, pan * frame : pan * frame + SIZE[1]].copy()
    image[TOP:BOTTOM, LEFT:RIGHT] = CARD
    return PreparedFrame(image)


def after(frames: int, pan: int, covers: tuple[Array, ...] = (), views: int = 8) -> RegionState:
    assert BACKGROUND is not None
    params = replace(PARAMS, background=replace(BACKGROUND, views=views))
    state = begin(read(0, pan), (Part(DRAWN),), params)
    for frame in range(1, frames + 1):
        state = step(state, read(frame, pan), params, covers=covers).state
    return state


@pytest.fixture(scope="module")
def panned() -> RegionState:
    return after(24, 8)


def test_a_camera_that_stays_shows_nothing_new() -> None:
    assert after(4, 0).key.later == ()


def test_what_a_camera_comes_to_is_known_wherever_it_goes(panned: RegionState) -> None:
    """After 24 frames nothing that the key showed is in sight beside the object."""
    grid = panned.region.grid
    background = panned.key.background(grid)
    assert panned.key.later
    assert background.on_key.mean() < 0.3
    outside = panned.region.on(grid) == 0.0
    assert background.known[outside].mean() > 0.8


def test_a_view_knows_nothing_of_the_object_and_close_to_it(panned: RegionState) -> None:
    assert BACKGROUND is not None
    for view in panned.key.later:
        rows, columns = np.nonzero(view.known)
        x, y = view.grid.to_image(np.stack([columns + 0.5, rows + 0.5], axis=1)).T
        apart = np.maximum(np.maximum(LEFT - x, x - RIGHT), np.maximum(TOP - y, y - BOTTOM))
        assert apart.min() > BACKGROUND.apart / panned.region.grid.factor.max() - 1.0


def test_views_are_carried_with_the_wall(panned: RegionState) -> None:
    grid = panned.region.grid
    background = panned.key.background(grid)
    wall = GROUND[:, 8 * 24 : 8 * 24 + SIZE[1]]
    there, elsewhere = (lab(grid.colours_of(PreparedFrame(image))) for image in (wall, wall[:, ::-1].copy()))
    later = background.known & ~background.on_key
    differences = [np.abs(background.colours[later].astype(int) - each[later]).mean() for each in (there, elsewhere)]
    assert differences[0] < 0.6 * differences[1]


def test_there_are_no_more_views_than_are_kept() -> None:
    assert len(after(24, 8, views=2).key.later) == 2


def test_a_view_knows_nothing_of_what_covers_the_object() -> None:
    post = np.array([[200.0, 0.0], [220.0, 0.0], [220.0, 160.0], [200.0, 160.0]])
    views = after(12, 8, (post,)).key.later
    assert views
    for view in views:
        corner, opposite = view.grid.to_grid(np.array([[203.0, 60.0], [217.0, 100.0]])).round().astype(int)
        assert not view.known[corner[1] : opposite[1], corner[0] : opposite[0]].any()
