"""Tiny shots whose right answers are known."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks.shots import Shot
from tests.golden import shots as drawn

SIDE = 20


@pytest.fixture(scope="session")
def sliding() -> Shot:
    """A square of 20 pixels that moves by one pixel a frame, for 13 frames."""
    masks = []
    for frame in range(13):
        mask = np.zeros((48, 64), dtype=bool)
        mask[14 : 14 + SIDE, 10 + frame : 10 + frame + SIDE] = True
        masks.append(mask)
    pictures = [np.where(mask[..., None], np.uint8(200), np.uint8(40)).repeat(3, axis=2) for mask in masks]
    return Shot("sliding", 101, pictures, masks)


@pytest.fixture(scope="session")
def gliding() -> Shot:
    """A textured blob that glides over a textured background for 8 frames."""
    blob = drawn.blob([30.0, 24.0, 20.0, 26.0, 32.0, 22.0])
    shot = drawn.gliding(blob, 8, (55.0, 50.0), (3.3, 1.7))
    return Shot("gliding", shot.first, shot.pictures, [shot.matte(frame) > 0.5 for frame in shot.frames])
