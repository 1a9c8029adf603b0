"""The stopwatch for whole frames: what it counts, not how long it takes."""

from __future__ import annotations

from benchmarks import shots, speed
from benchmarks.shots import Shot


def test_every_frame_is_timed_and_the_first_apart(gliding: Shot) -> None:
    found = speed.timed(gliding, shots.first_shapes(gliding), "baseline")
    assert len(found.clock) == len(found.processor) == len(gliding.frames) - 2
    assert len(found.flow) == len(gliding.frames) - 1
    assert min((*found.clock, *found.flow, found.first)) > 0.0


def test_the_ratio_is_that_of_medians() -> None:
    assert speed.Timed((10.0, 30.0, 20.0), (), (4.0, 5.0, 90.0), 0.1).ratio == 4.0
