"""Shapes whose mattes are known by heart."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from roam_core.geometry import bezier
from roam_core.roto import Keyframe, RotoShape

MakeShape = Callable[..., RotoShape]


def rectangle(left: float, top: float, right: float, bottom: float, frame: int = 1, **values: Any) -> RotoShape:
    """A rectangle with straight sides, one key."""
    points = bezier.polygon_points([(left, top), (right, top), (right, bottom), (left, bottom)])
    return RotoShape(id="shape-1", name="Rectangle", keys=(Keyframe(frame, points),), **values)


@pytest.fixture
def square() -> RotoShape:
    """Ten pixels wide, its corner at (5, 5)."""
    return rectangle(5.0, 5.0, 15.0, 15.0)
