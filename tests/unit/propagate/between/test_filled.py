"""Whether a gap is filled: by keys that a fill would make again, but where a fill makes none."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from roam_core.arrays import Image
from roam_core.geometry.bezier import polygon_points
from roam_core.media import DamagedFrame
from roam_core.params import CONFIGS
from roam_core.propagate.between.filled import is_bridged, is_filled
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.roto import Clip, Keyframe, Origin, Project, RotoShape, edit

SQUARE = polygon_points([(10, 10), (30, 10), (30, 30), (10, 30)])
SIZE, GAP, PARAMS = (48, 64), (1, 6), CONFIGS["best"]


def filled(*frames: int) -> tuple[Stamps, RotoShape]:
    """A shape with artist keys at both ends of the gap and a fill's keys on these frames."""
    project, shape = edit.new_shape(Project(Clip(Path("shot"), 1, 6, SIZE[::-1])), SQUARE, GAP[0])
    shape = edit.set_key(shape, GAP[1], SQUARE + 3.0)
    inputs = Stamps.of([shape], project.clip).filled(0, GAP, PARAMS, False)
    keys = [Keyframe(frame, SQUARE, origin=Origin.ENGINE, confidence=0.9, inputs=inputs) for frame in frames]
    shape = edit.set_engine_keys(shape, keys)
    return Stamps.of([shape], project.clip), shape


@pytest.mark.parametrize(
    ("frames", "bridged", "expected", "looked_at"),
    [
        ((2, 3, 4, 5), (), True, []),
        ((2, 3, 5), (4,), True, [4]),
        ((2, 3, 5), (), False, [4]),
        ((), (2, 3, 4, 5), False, []),  # nothing was made: no picture is looked at
    ],
)
def test_a_frame_without_a_key_is_asked_about_where_there_are_others(
    frames: tuple[int, ...], bridged: tuple[int, ...], expected: bool, looked_at: list[int]
) -> None:
    asked: list[int] = []

    def bridges(frame: int) -> bool:
        asked.append(frame)
        return frame in bridged

    stamps, shape = filled(*frames)
    assert is_filled(stamps, shape, GAP, PARAMS, bridges) is expected
    assert asked == looked_at


def test_keys_of_other_settings_are_no_fill() -> None:
    stamps, shape = filled(2, 3, 4, 5)
    assert not is_filled(stamps, shape, GAP, CONFIGS["baseline"], lambda _: True)


def test_what_has_no_picture_or_one_that_shows_nothing_is_bridged() -> None:
    _, shape = filled()
    pictures = {2: np.zeros((*SIZE, 3), np.uint8), 3: np.full((*SIZE, 3), 255, np.uint8)}
    pictures[4] = np.random.default_rng(1).integers(0, 255, (*SIZE, 3)).astype(np.uint8)
    pictures[4][:, :32] = 0

    def read(frame: int) -> Image:
        if frame not in pictures:
            raise DamagedFrame(f"Frame {frame} is damaged.")
        return pictures[frame]

    assert [is_bridged(read, shape, PARAMS, frame) for frame in range(2, 6)] == [True, True, False, True]
