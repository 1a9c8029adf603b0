"""Where a run began that goes on from a frame: the last artist keys on its way, whichever way it goes."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.geometry.bezier import polygon_points
from roam_core.params import DEFAULT_CONFIG
from roam_core.propagate.group import GroupTracker
from roam_core.propagate.memory import Beginning, TrackMemory, begins
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.roto import Keyframe, RotoShape

SQUARE = polygon_points([(0, 0), (40, 0), (40, 40), (0, 40)])


def keyed(name: str, frames: tuple[int, ...], at: float = 0.0) -> RotoShape:
    return RotoShape(name, name, tuple(Keyframe(frame, SQUARE + at) for frame in frames))


@pytest.mark.parametrize(
    ("frame", "forward", "begun"),
    [(9, True, 5), (1, False, 3), (5, True, 5), (3, False, 3)],
    ids=["forward past several keys", "backward past several keys", "forward on one", "backward on one"],
)
def test_a_run_goes_on_from_the_nearest_keys_that_all_its_shapes_have(frame: int, forward: bool, begun: int) -> None:
    """On a frame where the artist keyed one of two shapes, nothing is known of how the other came there."""
    stamps = Stamps([keyed("mine", (1, 3, 5, 9)), keyed("near", (3, 5), at=20.0)], "", (480, 640))
    assert stamps.objects[0] == (0, 1)
    assert begins(stamps, 0, frame, DEFAULT_CONFIG, forward=forward) == Beginning(begun, (0, 1))


def test_keys_on_the_other_side_are_not_on_the_way() -> None:
    stamps = Stamps([keyed("mine", (1, 9)), keyed("near", (1, 20), at=20.0)], "", (480, 640))
    assert begins(stamps, 0, 9, DEFAULT_CONFIG, forward=True) == Beginning(1, (0, 1))
    later = Stamps([keyed("mine", (1, 9)), keyed("near", (0, 9), at=20.0)], "", (480, 640))
    assert begins(later, 0, 1, DEFAULT_CONFIG, forward=False) == Beginning(9, (0, 1))


def test_a_key_on_a_frame_that_shows_nothing_begins_no_run_where_an_earlier_one_does() -> None:
    stamps = Stamps([keyed("mine", (1, 5, 9))], "", (480, 640))

    def begun(frame: int, *blank: int, forward: bool = True) -> int:
        return begins(stamps, 0, frame, DEFAULT_CONFIG, forward=forward, shows=lambda each: each not in blank).frame

    assert begun(9, 9) == 5
    assert begun(9, 9, 5) == 1
    assert begun(1, 1, forward=False) == 5
    assert begun(9, 9, 5, 1) == 9  # nothing was ever seen


def test_of_however_many_objects_all_states_on_the_last_frame_are_kept() -> None:
    """Else going on by one frame solves the others of them again from their keys."""
    memory, picture = TrackMemory(entries=2), np.zeros((60, 80, 3), np.uint8)
    for frame in (1, 2):
        for name in "abc":
            tracker = GroupTracker("lean")
            tracker.start(picture, [keyed(name, (frame,))], frame)
            memory.keep(tracker.standing, name)
    assert all(memory.recall(2, name) is not None for name in "abc")
    assert not any(memory.recall(1, name) for name in "abc")
