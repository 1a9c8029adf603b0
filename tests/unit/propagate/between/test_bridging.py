"""What neither pass sees: where an outline lies between those."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.geometry import bezier, similarity
from roam_core.geometry.bezier import polygon_points
from roam_core.propagate.between.bridging import between

LIMB = polygon_points([(20, 20), (60, 20), (100, 22), (100, 38), (60, 40), (20, 40)])


def moved(share: float) -> Array:
    """The similarity by which the limb goes: a turn of 60 degrees, a growth by a fifth, and a move of its middle."""
    angle, growth = share * np.pi / 3.0, 1.2**share
    c, s = growth * np.cos(angle), growth * np.sin(angle)
    linear = np.array([[c, -s], [s, c]])
    middle = bezier.flatten(LIMB).mean(axis=0)
    return np.column_stack([linear, middle + share * np.array([30.0, -14.0]) - linear @ middle])


def apart(a: Array, b: Array) -> float:
    """How far the points of one outline lie from the nearest of another, pixels, at most."""
    one, other = bezier.flatten(a), bezier.flatten(b)
    return float(np.hypot(*(one[:, None] - other[None]).transpose(2, 0, 1)).min(axis=1).max())


@pytest.mark.parametrize("share", [0.0, 0.25, 0.5, 0.75, 1.0])
@pytest.mark.parametrize("slid", [0, 1])
def test_an_outline_moves_turns_and_grows_evenly_though_its_points_have_slid(share: float, slid: int) -> None:
    last = np.roll(similarity.apply(moved(1.0), LIMB), slid, axis=0)
    assert apart(between(LIMB, last, share, 64), similarity.apply(moved(share), LIMB)) < 2.5
