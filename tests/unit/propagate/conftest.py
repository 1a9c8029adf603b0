"""Shots to be tracked, drawn once for all tests of this folder."""

from __future__ import annotations

import pytest

from tests.golden.shots import Shot, blob, gliding, pose, square


@pytest.fixture(scope="session")
def box_shot() -> Shot:
    """A square of 40 pixels that glides by fractions of a pixel, eight frames from 1001 on."""
    return gliding(square(40.0), 8, (60.0, 58.0), (1.3, -0.7))


@pytest.fixture(scope="session")
def blob_shot() -> Shot:
    """A smooth shape that glides, turns and grows over a background that glides otherwise, six frames from 1001 on."""
    poses = tuple(pose(70.0 + 2.2 * k, 60.0 - 0.6 * k, 3.0 * k, 1.0 + 0.01 * k) for k in range(6))
    return Shot(blob([30.0, 24.0, 20.0, 26.0, 32.0, 22.0]), poses, drift=(-0.5, 0.3))
