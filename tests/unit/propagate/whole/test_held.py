"""A large shape that lies by its pose while it looks as on its key, and by its region as if it never had after that."""

from __future__ import annotations

import numpy as np

from roam_core import track
from roam_core.arrays import Array, UInt8
from roam_core.roto import RotoShape
from tests.unit.propagate.figures import Figure, body_and_sleeve

NEVER = "best+region.pose_steady=0.02"
"""No shape is as like its key as that."""
CHANGED = 3
"""The frame on which the picture is another one."""


def tracked(figure: Figure, config: str, changed: int | None = None) -> RotoShape:
    """The body on its own; on frame `changed` all of the picture is darker."""

    def read(frame: int) -> UInt8:
        picture = figure.read(frame)
        return np.asarray(0.6 * picture, dtype=np.uint8) if frame == changed else picture

    *_, last = track(read, figure.shapes()[:1], figure.frames, config)
    return last.results[0].shape


def slides(figure: Figure, shape: RotoShape) -> Array:
    """How far the points lie from where the body's motion takes them, the mean of each frame, pixels."""
    (body, *_), frames = figure.parts, figure.frames[1:]
    return np.array([np.hypot(*(shape.at(k).anchors - body.truth(k)[:, 0]).T).mean() for k in frames])


def test_a_body_of_one_cloth_with_a_sleeve_before_it_keeps_its_points() -> None:
    figure = body_and_sleeve()
    held, by_region = (slides(figure, tracked(figure, config)) for config in ("best", NEVER))
    assert held.max() < 0.5
    assert (by_region > 2.0 * held).all()


def test_once_it_has_changed_it_lies_as_if_its_pose_had_never_been_asked() -> None:
    figure = body_and_sleeve()
    held, by_region = (tracked(figure, config, CHANGED) for config in ("best", NEVER))
    for frame in figure.frames[1:]:
        is_same = np.array_equal(held.at(frame).points, by_region.at(frame).points)
        assert is_same is (frame >= CHANGED), f"frame {frame}"
