"""A plain project for review: two shapes, one of them tracked, on a plate that needs no files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from roam_core.arrays import UInt8
from roam_core.media import MissingFrame
from roam_core.roto import Clip, Keyframe, Layer, Origin, Project, RotoShape, timing
from tests.golden.shots import square

SIZE = (160, 90)
FIRST, LAST = 1001, 1010
MISSING = 1007
PLATE = (40, 90, 160)
"""The one colour of the plate."""
NOTE = "the elbow slips"


def body(steps: list[float], confidence: float = 0.9, name: str = "Body") -> RotoShape:
    """A tracked square that lies, frame by frame, `steps` pixels to the right of its place."""
    keys = tuple(
        Keyframe(
            FIRST + k,
            square(40.0) + np.array([60.0 + step, 45.0]),
            origin=Origin.ENGINE if k else Origin.ARTIST,
            confidence=confidence if k else None,
        )
        for k, step in enumerate(steps)
    )
    return RotoShape("shape-1", name, keys, colour=(1.0, 0.0, 0.0))


def project_of(*shapes: RotoShape) -> Project:
    """The shapes on the plate, with a note on its second frame."""
    project = Project(Clip(Path("/plates/body"), FIRST, LAST, SIZE), Layer("root", "Root", shapes))
    return timing.set_mark(project, FIRST + 1, NOTE)


def read(frame: int) -> UInt8:
    """The working picture of a frame; one is missing."""
    if frame == MISSING:
        raise MissingFrame(f"Frame {frame} is missing.")
    return np.full((SIZE[1], SIZE[0], 3), PLATE, dtype=np.uint8)


@pytest.fixture
def project() -> Project:
    return project_of(body([0.0] * 10))
