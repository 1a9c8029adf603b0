"""Shapes that an engine closed because it did not see them."""

from __future__ import annotations

import numpy as np

from roam_core.geometry.bezier import ANCHOR, polygon_points
from roam_core.roto.sight import SHUT, is_shut, opened

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
