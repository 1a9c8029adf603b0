"""A run through a key of some points: what the artist set stays, the rest is solved, and it goes on from there."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.geometry.bezier import ANCHOR
from roam_core.propagate import run
from roam_core.propagate.shapes.provenance import Stamp, is_stale
from roam_core.roto import Origin, RotoShape, edit
from tests.golden.shots import Shot

MIDDLE, SET = 3, 1


@pytest.mark.parametrize("config", ["lean", "best"])
def test_what_was_set_stays_and_the_rest_is_derived_anew(config: str, blob_shot: Shot) -> None:
    frames = list(blob_shot.frames)
    middle = frames[MIDDLE]
    true = blob_shot.truth(middle)
    given = true + 9.0  # the others lie far off, as if they were of a track that went wrong
    given[SET] = true[SET] + (1.5, -1.0)
    shape = edit.set_key(blob_shot.shape(), middle, given)
    key = shape.key_at(middle)
    assert key is not None
    shape = shape.with_key(replace(key, set_points=(SET,)))
    tracked = shape
    for result in run.track(blob_shot.read, [shape], range(frames[0], frames[-1] + 1), config):
        (each,) = result.results
        tracked = each.shape
    found = tracked.key_at(middle)
    assert found is not None
    assert (found.origin, found.set_points) == (Origin.ARTIST, (SET,))
    np.testing.assert_array_equal(found.points[SET], given[SET])
    others = [index for index in range(len(true)) if index != SET]
    off = np.hypot(*(found.points[others, ANCHOR] - true[others, ANCHOR]).T)
    assert off.max() < 4.0  # of the 13 that they were off; along the outline nothing holds the points of `lean`
    after = tracked.key_at(middle + 1)
    assert after is not None
    assert Stamp.read(after.inputs).begun == middle
    assert not any(is_stale(tracked, each, None) for each in tracked.keys)
    assert again(blob_shot, tracked, middle, config) == after.points.tobytes()


def again(shot: Shot, shape: RotoShape, frame: int, config: str) -> bytes:
    """What a run that begins on a frame gives on the next one."""
    (result,) = run.track(shot.read, [shape], range(frame, frame + 2), config)
    key = result.results[0].key
    assert key is not None
    return key.points.tobytes()
