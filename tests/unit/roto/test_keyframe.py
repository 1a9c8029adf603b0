"""Keyframe: many are made from others without being looked at again, and each is one object to Python."""

from __future__ import annotations

import pickle
from copy import deepcopy
from dataclasses import fields, replace
from typing import Any

import numpy as np
import pytest

from roam_core.roto import Interpolation, Keyframe, Origin

POINTS = np.arange(24.0).reshape(4, 3, 2)
OTHERS: dict[str, Any] = {
    "frame": 9,
    "points": POINTS + 1.0,
    "feather": POINTS * 2.0,
    "origin": Origin.ARTIST,
    "interpolation": Interpolation.HOLD,
    "confidence": 0.25,
    "vertex_confidence": np.linspace(0.0, 1.0, 4),
    "inputs": "forward:best:0:from=1",
    "set_points": (1, 3),
    "extra": {"later": 1},
}


def whole() -> Keyframe:
    return Keyframe(
        3, POINTS, POINTS / 3.0, Origin.ENGINE, Interpolation.SMOOTH, 0.5, np.ones(4), "x", (0,), {"other": 2}
    )


@pytest.mark.parametrize("name", [field.name for field in fields(Keyframe)])
def test_a_key_with_another_value_is_as_replace_gives_it(name: str) -> None:
    one = whole()
    value = OTHERS[name]
    if isinstance(value, np.ndarray):
        value.setflags(write=False)
    changed = one.but(**{name: value})
    assert changed == replace(one, **{name: value})
    assert changed != one == whole()
    assert all(getattr(changed, field.name) is getattr(one, field.name) for field in fields(one) if field.name != name)


def test_points_that_are_given_can_be_written_no_more() -> None:
    points, feather = POINTS.copy(), POINTS.copy()
    key = whole().with_points(points, feather, confidence=None)
    points[:], feather[:] = 0.0, 0.0
    assert key == replace(whole(), points=POINTS, feather=POINTS, confidence=None)
    assert key.feather is not None
    assert not key.points.flags.writeable
    assert not key.feather.flags.writeable


def test_a_key_is_one_object_and_comes_back_from_another_process() -> None:
    """With a dictionary of its own each key cost the collector twice, and hundreds of bytes: there are 150 000."""
    key = whole()
    assert not hasattr(key, "__dict__")
    assert pickle.loads(pickle.dumps(key)) == key == deepcopy(key)  # noqa: S301 - its own
