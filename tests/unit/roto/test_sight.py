"""Shapes that an engine closed because it did not see them."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from roam_core.geometry.bezier import ANCHOR, polygon_points
from roam_core.roto import Keyframe, Origin, RotoShape
from roam_core.roto.animated import Animated, ValueKey, value_at
from roam_core.roto.sight import (
    POINT,
    SHUT,
    in_sight,
    is_out_of_sight,
    is_point,
    is_shut,
    moving_in_sight,
    opened,
)

DRAWN = polygon_points([(0.0, 0.0), (40.0, 0.0), (40.0, 10.0), (0.0, 10.0)])


def test_an_outline_is_shut_from_a_share_of_its_size_as_drawn() -> None:
    assert is_shut(SHUT * DRAWN + 70.0, DRAWN)
    assert not is_shut(1.02 * SHUT * DRAWN + 70.0, DRAWN)
    assert not is_shut(DRAWN, DRAWN)


def test_it_opens_as_drawn_around_where_it_closed() -> None:
    shut = 0.01 * DRAWN + (70.0, 30.0)
    again = opened(shut, DRAWN)
    np.testing.assert_allclose(again[:, ANCHOR].mean(axis=0), shut[:, ANCHOR].mean(axis=0))
    np.testing.assert_allclose(np.diff(again[:, ANCHOR], axis=0), np.diff(DRAWN[:, ANCHOR], axis=0))


def test_a_point_is_one_with_its_handles() -> None:
    point = 0.9 * POINT / 40.0 * DRAWN + 70.0
    assert is_point(point)
    assert not is_point(DRAWN)
    loop = point.copy()
    loop[0, 1] += 30.0  # a curve that encloses something though its anchors lie together
    assert not is_point(loop)


def test_sight_has_keys_where_it_changes_only() -> None:
    def shape(*outlines: np.ndarray, origin: Origin = Origin.ENGINE) -> RotoShape:
        keys = (Keyframe(frame, points, origin=origin) for frame, points in enumerate(outlines))
        return RotoShape("a", "a", tuple(keys))

    point = 1e-4 * DRAWN
    assert in_sight(shape(DRAWN, DRAWN)) == 1.0
    assert in_sight(shape(point)) == 0.0
    assert in_sight(shape(DRAWN, point, origin=Origin.ARTIST)) == 1.0
    seen = in_sight(shape(DRAWN, DRAWN, point, point, point, DRAWN, DRAWN))
    assert seen == Animated(tuple(ValueKey(frame, value) for frame, value in ((1, 1.0), (2, 0.0), (4, 0.0), (5, 1.0))))


def test_out_of_sight_lasts_between_closed_keys_and_beyond_the_last() -> None:
    point = 1e-4 * DRAWN
    outlines = {0: DRAWN, 2: point, 6: point, 8: DRAWN, 10: point}
    shape = RotoShape("a", "a", tuple(Keyframe(f, points, origin=Origin.ENGINE) for f, points in outlines.items()))
    seen = [frame for frame in (-1, 0, 1, 2, 3.5, 4, 6, 7, 8, 9, 10, 12) if not is_out_of_sight(shape, frame)]
    assert seen == [-1, 0, 1, 7, 8, 9]


@pytest.mark.parametrize("closed", list(product((False, True), repeat=4)))
def test_sight_is_none_exactly_where_a_shape_with_gaps_between_keys_is_out_of_it(closed: tuple[bool, ...]) -> None:
    keys = (
        Keyframe(frame, 1e-4 * DRAWN if is_closed else DRAWN, origin=Origin.ENGINE)
        for frame, is_closed in zip((0, 1, 4, 9), closed, strict=True)
    )
    shape = RotoShape("a", "a", tuple(keys))
    seen = in_sight(shape)
    for frame in range(-2, 12):
        assert value_at(seen, frame) == (0.0 if is_out_of_sight(shape, frame) else 1.0)


def test_motion_ends_where_an_outline_closes_and_begins_where_it_has_opened() -> None:
    point = 1e-4 * DRAWN
    outlines = {0: DRAWN, 1: DRAWN, 2: DRAWN, 3: point, 4: point, 6: DRAWN, 7: DRAWN}
    shape = RotoShape("a", "a", tuple(Keyframe(f, points, origin=Origin.ENGINE) for f, points in outlines.items()))
    expected = {
        0: (-1.5, 1.5),
        1: (-0.5, 2),
        1.75: (0.25, 2),
        2: (0.5, 2),
        2.5: (1.0, 4.0),  # on the way: it is seen closing
        5: (3.5, 6.5),
        6: (6, 7.5),
        7: (6, 8.5),
    }
    assert {at: moving_in_sight(shape, at, at - 1.5, at + 1.5) for at in expected} == expected
    drawn = RotoShape("a", "a", tuple(Keyframe(f, points) for f, points in outlines.items()))
    assert moving_in_sight(drawn, 2, 1.5, 2.5) == (1.5, 2.5)
