"""The optimum of straight keys is that of trying every choice of frames."""

from __future__ import annotations

from itertools import combinations, pairwise

import numpy as np

from benchmarks.key_optimum import _places, is_good, optimum
from roam_core.geometry import bezier
from roam_core.interchange.keys.reduction import reduced
from roam_core.roto import Keyframe, Origin, RotoShape

SQUARE = bezier.polygon_points([(0.0, 0.0), (40.0, 0.0), (40.0, 30.0), (0.0, 30.0)])
TOLERANCE = 1.0


def wandering(artist: tuple[int, ...] = (0,)) -> RotoShape:
    """A square that wanders and shivers for nine frames."""
    steps = np.random.default_rng(3).normal(0.0, 0.9, (9, 1, 1, 2)).cumsum(axis=0)
    keys = tuple(
        Keyframe(frame, SQUARE + step, origin=Origin.ARTIST if frame in artist else Origin.ENGINE)
        for frame, step in enumerate(steps)
    )
    return RotoShape("shape-1", "Square", keys)


def by_every_choice(shape: RotoShape) -> int:
    outlines = np.stack([_places(shape, frame) for frame in shape.frames])
    inner = shape.frames[1:-1]
    for count in range(len(inner) + 1):
        for chosen in combinations(inner, count):
            keys = (shape.frames[0], *chosen, shape.frames[-1])
            spans = [outlines[start : stop + 1] for start, stop in pairwise(keys)]
            if set(shape.artist_frames) <= set(keys) and all(is_good(span, True, TOLERANCE) for span in spans):
                return len(keys)
    raise AssertionError("every frame is a key at the latest")


def test_the_optimum_is_that_of_every_choice_and_the_programs() -> None:
    for artist in ((0,), (0, 4)):
        shape = wandering(artist)
        fewest = optimum(shape, TOLERANCE)
        assert 2 < fewest == by_every_choice(shape) < 9
        assert len(reduced(shape, TOLERANCE).shape.keys) == fewest


def test_a_shape_that_moves_straight_needs_its_ends() -> None:
    keys = (Keyframe(1, SQUARE), Keyframe(30, SQUARE + 50.0, origin=Origin.ENGINE))
    assert optimum(RotoShape("shape-1", "Straight", keys), TOLERANCE) == 2
