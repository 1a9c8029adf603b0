"""A hole that ends within a run, and what is left of its keys there: what the body gets is told by its stamps."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from roam_core.arrays import Array, Bools, UInt8
from roam_core.geometry import similarity
from roam_core.matte import shape_matte
from roam_core.propagate import run
from roam_core.propagate.between.span import fill_span
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.roto import BlendMode, Keyframe, Origin, RotoShape
from tests.golden.shots import blob, inverse, pose, texture

FRAMES, CORRECTED = range(8), 4
SIZE = (120, 160)
BODY, HOLE = blob([30.0, 26.0, 24.0, 28.0, 30.0, 26.0]), blob([16.0, 14.0, 15.0, 16.0])


def motion(frame: int) -> Array:
    return pose(45.0 + 7.0 * frame, 56.0, 2.0 * frame)


def truth(rest: Array, frame: int) -> Array:
    """It grows taller from frame to frame, as no pose does: so it is fitted to its region."""
    points = similarity.apply(motion(frame), rest).copy()
    points[..., 1] = 56.0 + (points[..., 1] - 56.0) * (1.0 + 0.06 * frame)
    return points


@cache
def read(frame: int) -> UInt8:
    centres = np.stack(np.meshgrid(np.arange(SIZE[1]) + 0.5, np.arange(SIZE[0]) + 0.5), axis=-1)
    body = texture(7, 0.6, 1.0).at(similarity.apply(inverse(motion(frame)), centres))
    behind = texture(8, 0.0, 0.4).at(centres)
    solid, gap = (shape_matte(shape_of("it", rest, frame), frame, SIZE) for rest in (BODY, HOLE))
    coverage = np.clip(solid - gap, 0.0, 1.0)[..., None]
    return np.asarray(np.round(255.0 * (coverage * body + (1.0 - coverage) * behind)), dtype=np.uint8)


def shape_of(name: str, rest: Array, *frames: int) -> RotoShape:
    return RotoShape(name, name, tuple(Keyframe(frame, truth(rest, frame)) for frame in frames))


def drawn(first: int) -> list[RotoShape]:
    hole = replace(shape_of("hole", HOLE, first), blend=BlendMode.SUBTRACT)
    return [shape_of("body", BODY, first, CORRECTED), hole]


def tracked(shapes: Sequence[RotoShape], frames: range) -> list[RotoShape]:
    *_, last = run.track(read, shapes, frames, "best")
    return [result.shape for result in last.results]


def stale(shapes: Sequence[RotoShape]) -> set[tuple[str, int]]:
    stamps = Stamps(shapes, size=SIZE)
    return {(shape.id, key.frame) for shape in shapes for key in shape.keys if stamps.is_stale(shape, key)}


def are_alike(one: RotoShape, other: RotoShape) -> Bools:
    pairs = zip(one.keys, other.keys, strict=True)
    return np.array([a.inputs == b.inputs and np.array_equal(a.points, b.points) for a, b in pairs])


@pytest.mark.parametrize(("frames", "lifetime"), [(FRAMES, (0, 2)), (FRAMES[::-1], (6, 9))])
def test_keys_after_a_correction_go_by_where_the_hole_ends_and_not_by_what_is_left_beside_it(
    frames: range, lifetime: tuple[int, int]
) -> None:
    body, hole = drawn(frames[0])
    before = tracked([body, hole], frames)
    assert stale(before) == set()
    shortened = [before[0], replace(before[1], lifetime=lifetime)]
    beyond = set(frames[frames.index(CORRECTED) + 1 :])
    assert {frame for name, frame in stale(shortened) if name == "body"} == beyond
    fresh = tracked([body, replace(hole, lifetime=lifetime)], frames)
    assert stale(fresh) == set()
    assert are_alike(tracked(shortened, frames)[0], fresh[0]).all()


@pytest.mark.parametrize("frames", [FRAMES, FRAMES[::-1]])
def test_keys_of_others_on_a_frame_that_was_set_in_part_are_not_stale(frames: range) -> None:
    body, hole = drawn(frames[0])
    key = body.key_at(CORRECTED)
    assert key is not None
    given = key.points + np.array([3.0, 0.0])
    body = body.with_key(replace(key, points=given, set_points=(0,)))
    once = tracked([body, hole], frames)
    found = once[0].key_at(CORRECTED)
    assert found is not None
    assert not np.array_equal(found.points, given)  # what was not set is derived anew
    assert stale(once) == set()
    again = tracked(once, frames)
    assert all(are_alike(*pair).all() for pair in zip(once, again, strict=True))


def test_a_key_of_the_engine_at_the_end_of_a_gap_does_not_hold_what_is_filled_there() -> None:
    body = shape_of("body", BODY, 3, 7)
    hole = replace(shape_of("hole", HOLE, 7), blend=BlendMode.SUBTRACT, lifetime=(0, 6))
    left = hole.with_key(Keyframe(3, truth(HOLE, 3) + 2.0, origin=Origin.ENGINE, confidence=0.9))
    clean, beside = (fill_span(read, [body, each], 3, 7, "best")[1] for each in (hole, left))
    assert are_alike(clean, replace(beside, keys=tuple(key for key in beside.keys if key.frame != 3))).all()
    assert len(clean.keys) > 1
