"""What the key's background says: against the object where it is seen again, for it where something else is seen."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import numpy.testing as npt
import pytest

from roam_core.arrays import Array, Bools, Float32, UInt8
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.params.evidence import BackgroundParams
from roam_core.proposal.cues.background import Background, LaterView, correction
from roam_core.proposal.cues.key_view import KeyView, lab

SIDE = 120
GRID = Grid(Region(0, 0, SIDE, SIDE), SIDE, SIDE)
PARAMS = BackgroundParams()
RED = (200, 40, 40)


def meadow(seed: int = 3) -> UInt8:
    """Coarse texture `(SIDE, SIDE, 3)`, greenish."""
    noise = np.random.default_rng(seed).integers(0, 60, (SIDE // 4, SIDE // 4, 3))
    return np.uint8(np.kron(noise, np.ones((4, 4, 1))) + np.array((60, 120, 60)))


def square(x: int, y: int, side: int = 20) -> Bools:
    inside = np.zeros((SIDE, SIDE), bool)
    inside[y : y + side, x : x + side] = True
    return inside


def painted(ground: UInt8, inside: Bools, colour: tuple[int, int, int] = RED) -> UInt8:
    picture = ground.copy()
    picture[inside] = colour
    return picture


def shifted(x: float, y: float) -> Array:
    return np.array([[1.0, 0.0, x], [0.0, 1.0, y], [0.0, 0.0, 1.0]])


def view_of(picture: UInt8, inside: Bools, carried: Array) -> KeyView:
    return KeyView(PreparedFrame(picture), carried, GRID, GRID.warped(inside.astype(np.float32), carried))


def told(ground: UInt8, key: Bools, now: UInt8, outside: Bools, carried: Array | None = None) -> Float32:
    view = view_of(painted(ground, key), key, np.eye(3) if carried is None else carried)
    return Background.of(view).log_ratio(lab(now), outside, PARAMS)


def middle(inside: Bools) -> Bools:
    """Its cells without those at its border."""
    rows, columns = np.nonzero(inside)
    within = inside.copy()
    within[: rows.min() + 4] = within[rows.max() - 3 :] = False
    within[:, : columns.min() + 4] = within[:, columns.max() - 3 :] = False
    return within


def test_what_is_seen_again_is_background_and_what_hides_it_is_not() -> None:
    ground, key, now = meadow(), square(10, 40), square(70, 40)
    ratio = told(ground, key, painted(ground, now), ~(square(7, 37, 26) | square(67, 37, 26)))
    assert ratio[middle(now)].min() == pytest.approx(PARAMS.other, abs=0.1)
    elsewhere = middle(square(45, 80))
    assert np.median(ratio[elsewhere]) < -0.9 * PARAMS.same
    npt.assert_array_equal(ratio[middle(key)], 0.0)  # what lay behind the object is not known


def test_it_goes_with_the_surroundings() -> None:
    ground, key = meadow(), square(10, 40)
    pan = shifted(7.0, -4.0)
    now, there = GRID.warped(ground, pan), middle(square(60, 60))
    assert np.median(told(ground, key, now, ~square(10, 30), pan)[there]) < -0.9 * PARAMS.same
    assert np.median(told(ground, key, now, ~square(10, 30))[there]) > -0.2 * PARAMS.same


def test_a_shadow_is_no_object() -> None:
    ground, key, shade = np.full((SIDE, SIDE, 3), 170, np.uint8), square(10, 40), square(70, 40)
    outside = ~(square(7, 37, 26) | square(67, 37, 26))
    darker = told(ground, key, painted(ground, shade, (135, 135, 135)), outside)
    brighter = told(ground, key, painted(ground, shade, (205, 205, 205)), outside)
    npt.assert_array_equal(darker[middle(shade)], 0.0)
    assert brighter[middle(shade)].min() > 0.3 * PARAMS.other


def test_what_has_changed_all_around_says_nothing_of_the_object() -> None:
    ground, key, now = meadow(), square(10, 40), square(70, 40)
    other = painted(255 - meadow(7), now)
    assert told(ground, key, other, ~(square(7, 37, 26) | square(67, 37, 26))).max() == 0.0


def test_without_texture_nothing_is_recognised() -> None:
    flat = np.full((SIDE, SIDE, 3), 120, np.uint8)
    ratio = told(flat, square(10, 40), flat, ~square(10, 40))
    npt.assert_array_equal(ratio, 0.0)


def test_what_covered_the_object_is_not_its_background() -> None:
    ground, key = meadow(), square(10, 40)
    post = np.array([[60.0, 0.0], [70.0, 0.0], [70.0, 120.0], [60.0, 120.0]])
    known = Background.of(view_of(ground, key, np.eye(3)), [post]).known
    assert not known[:, 60:70].any()
    assert known[:, 72:].all()
    moved = Background.of(view_of(ground, key, shifted(10.0, 0.0)), [post]).known
    assert not moved[:, 70:80].any()
    assert moved[:, 60:70][square(0, 0, SIDE)[:, 60:70] & ~square(20, 40)[:, 60:70]].all()


def test_the_key_is_drawn_to_the_picture() -> None:
    ground, key = meadow(), square(10, 40)
    pan, guess = shifted(6.0, 3.0), shifted(4.5, 4.0)
    now = painted(GRID.warped(ground, pan), square(60, 50))
    grey = GRID.grey_of(PreparedFrame(now))
    view = view_of(painted(ground, key), key, guess)
    found = correction(view, (), grey, square(55, 45, 30), PARAMS) @ guess
    npt.assert_allclose(found[:2] @ (60.0, 60.0, 1.0), pan[:2] @ (60.0, 60.0, 1.0), atol=0.75)  # cells; it was 1.8 off


def test_it_stays_where_nothing_agrees_or_nothing_is_known() -> None:
    guess = shifted(2.0, 0.0)
    grey = GRID.grey_of(PreparedFrame(meadow(11)))
    nowhere, everywhere = square(0, 0, 1), square(0, 0, SIDE)
    npt.assert_array_equal(
        correction(view_of(meadow(), nowhere, guess), (), grey, nowhere, replace(PARAMS, agreed=0.9)), np.eye(3)
    )
    npt.assert_array_equal(
        correction(view_of(meadow(), everywhere, guess), (), grey, nowhere, replace(PARAMS, agreed=0.1)), np.eye(3)
    )


PAN = shifted(-60.0, 0.0)
"""Half the picture has gone since the key, and as much has come into sight."""
RIGHT = square(0, 0, SIDE) & (np.arange(SIDE) >= SIDE // 2)


def later_view(picture: UInt8, clear: Bools, carried: Array | None = None) -> LaterView:
    return LaterView(GRID, picture, np.uint8(255) * clear, np.eye(3) if carried is None else carried)


def test_what_came_into_sight_later_is_known_where_the_key_shows_nothing() -> None:
    ground, now = meadow(), meadow(5)
    key = view_of(ground, square(10, 40), PAN)
    known = Background.of(key, (), [later_view(now, RIGHT)])
    npt.assert_array_equal(known.on_key, Background.of(key).known)
    npt.assert_array_equal(known.known, known.on_key | RIGHT)
    npt.assert_array_equal(known.colours[known.known & ~known.on_key], lab(now)[known.known & ~known.on_key])
    npt.assert_array_equal(known.colours[known.on_key], Background.of(key).colours[known.on_key])


def test_a_later_view_goes_with_the_surroundings() -> None:
    now, pan = meadow(5), shifted(-7.0, 4.0)
    key = view_of(meadow(), square(10, 40), pan @ PAN)
    clear = ~square(80, 50, 12)
    later = [later_view(now, clear, pan)]
    ratio = Background.of(key, (), later).log_ratio(lab(GRID.warped(now, pan)), ~square(0, 0, 1), PARAMS)
    assert np.median(ratio[30:100, 65:108]) < -0.9 * PARAMS.same
    npt.assert_array_equal(ratio[60:62, 77:81], 0.0)  # not clear of the object there


def test_what_hides_a_later_view_may_have_been_left_out_of_the_object() -> None:
    now, thing = meadow(5), square(80, 40)
    key = view_of(meadow(), square(10, 40), PAN)
    ratio = Background.of(key, (), [later_view(now, RIGHT)]).log_ratio(lab(painted(now, thing)), ~thing, PARAMS)
    npt.assert_array_equal(ratio[middle(thing)], 0.0)


def test_later_views_are_drawn_to_the_picture_once_the_key_is_out_of_sight() -> None:
    ground, gone, pan = meadow(5), shifted(-3.0 * SIDE, 0.0), shifted(3.0, 2.0)
    now, nowhere = GRID.grey_of(PreparedFrame(GRID.warped(ground, pan))), square(0, 0, 1)
    key = view_of(meadow(), square(10, 40), gone)
    found = correction(key, [later_view(ground, ~nowhere, shifted(1.5, 2.5))], now, nowhere, PARAMS)
    npt.assert_allclose((found @ shifted(1.5, 2.5))[:2] @ (60.0, 60.0, 1.0), pan[:2] @ (60.0, 60.0, 1.0), atol=0.75)
    npt.assert_array_equal(correction(key, (), now, nowhere, PARAMS), np.eye(3))
