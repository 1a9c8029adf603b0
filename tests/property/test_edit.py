"""The edit verbs on whatever shape: outlines that stay, keys that are sacred, frames on which a shape is its key."""

from __future__ import annotations

import numpy as np
from hypothesis import assume, given
from hypothesis import strategies as st

from roam_core.arrays import Array
from roam_core.geometry import bezier
from roam_core.roto import Interpolation, Keyframe, Origin, RotoShape, edit
from roam_core.roto.keying import Keying, held_at, reshape
from roam_core.roto.transform import transform_like
from tests.property.strategies import keyframes, point_arrays, roto_shapes


@given(roto_shapes(interpolation=Interpolation.LINEAR), st.data(), st.floats(0.05, 0.95), st.floats(-60.0, 2010.0))
def test_inserting_changes_no_outline_on_and_between_keys(
    shape: RotoShape, data: st.DataObject, t: float, between: float
) -> None:
    segment = data.draw(st.integers(0, bezier.segment_count(shape.point_count, shape.closed) - 1))
    assume(any(is_curved(key.points, segment, shape.closed) for key in shape.keys))
    after = edit.insert_point(shape, segment, t)
    u = np.linspace(0.0, 1.0, 9)
    halves = np.where(u <= t, segment, segment + 1), np.where(u <= t, u / t, (u - t) / (1.0 - t))
    for frame in (*shape.frames, between):
        old, new = shape.at(frame).points, after.at(frame).points
        before = bezier.evaluate(old, np.full(9, segment), u, shape.closed)
        np.testing.assert_allclose(bezier.evaluate(new, *halves, shape.closed), before, atol=1e-8)
    assert after.frames == shape.frames
    assert after.artist_frames == shape.artist_frames


@given(point_arrays(least=3), st.data(), st.floats(0.05, 0.95))
def test_inserting_into_a_polygon_puts_a_corner_on_its_side(points: Array, data: st.DataObject, t: float) -> None:
    anchors = points[:, bezier.ANCHOR]
    polygon = RotoShape("a", "A", (Keyframe(1, bezier.polygon_points(anchors)),))
    segment = data.draw(st.integers(0, len(anchors) - 1))
    after = edit.insert_point(polygon, segment, t).keys[0].points
    made = after[segment + 1, bezier.ANCHOR]
    np.testing.assert_array_equal(after, bezier.polygon_points(np.insert(anchors, segment + 1, made, axis=0)))
    side = np.stack([anchors[segment], made, anchors[(segment + 1) % len(anchors)]])
    np.testing.assert_allclose(np.hypot(*np.diff(side, axis=0).T).sum(), np.hypot(*(side[2] - side[0])), atol=1e-8)


@given(roto_shapes(), st.data())
def test_the_engine_leaves_artist_keys_bit_by_bit(shape: RotoShape, data: st.DataObject) -> None:
    frames = data.draw(st.lists(st.sampled_from([*shape.frames, 3000, 3001]), min_size=1, unique=True))
    made = [data.draw(keyframes(frame, shape.point_count, Origin.ENGINE)) for frame in frames]
    after = edit.set_engine_keys(shape, made)
    for key in shape.keys:
        if key.origin is Origin.ARTIST:
            assert after.key_at(key.frame) is key
    for key in made:
        assert after.key_at(key.frame) in (key, shape.key_at(key.frame))


@given(roto_shapes(), st.integers(-100, 2100))
def test_a_key_here_shows_the_same_outline(shape: RotoShape, frame: int) -> None:
    after = edit.key_here(shape, frame)
    before = shape.at(frame)
    assert after.at(frame).points.tobytes() == before.points.tobytes()
    key = after.key_at(frame)
    assert key is not None
    assert key.origin is Origin.ARTIST
    assert key.feather is None if before.feather is None else np.array_equal(key.feather, before.feather)


@given(roto_shapes(), st.integers(1, 400))
def test_moving_keys_there_and_back_is_nothing(shape: RotoShape, offset: int) -> None:
    there = edit.move_keys(shape, shape.frames, offset)
    assert there.frames == tuple(frame + offset for frame in shape.frames)
    assert edit.move_keys(there, there.frames, -offset) == shape


def is_curved(points: Array, segment: int, closed: bool) -> bool:
    """True when a handle of the segment lies off its anchor: such a segment keeps its parametrisation when split."""
    a, b, c, d = bezier.segments(points, closed)[segment]
    return not (np.array_equal(a, b) and np.array_equal(c, d))


def changes() -> st.SearchStrategy[Array]:
    """Affine maps that can be undone."""
    numbers = st.floats(-0.4, 0.4)
    linear = st.tuples(numbers, numbers, numbers, numbers).map(lambda n: np.eye(2) + np.reshape(n, (2, 2)))
    moves = st.tuples(st.floats(-50.0, 50.0), st.floats(-50.0, 50.0))
    return st.builds(lambda a, b: np.column_stack([a, b]), linear.filter(lambda a: np.linalg.det(a) > 0.2), moves)


RANGES = st.none() | st.just(range(0, 1000))


@given(roto_shapes(), st.integers(-60, 2020), changes(), st.booleans(), RANGES)
def test_an_edit_leaves_the_keys_that_it_does_not_reach(
    shape: RotoShape, frame: int, matrix: Array, auto: bool, ripple: range | None
) -> None:
    change = transform_like(held_at(shape, frame), np.ones(shape.point_count), matrix)
    after = reshape(shape, frame, change, Keying(auto, ripple))
    assert set(shape.artist_frames) <= set(after.artist_frames)
    assert set(after.frames) - set(shape.frames) <= ({frame} if auto else set())
    first = max((f for f in shape.artist_frames if f <= frame), default=-(10**6))
    last = min((f for f in shape.artist_frames if f >= frame), default=10**6)
    for key in shape.keys:
        in_ripple = ripple is not None and key.frame in ripple
        if not in_ripple and key.frame != frame and (auto or not first <= key.frame <= last):
            assert after.key_at(key.frame) is key


@given(roto_shapes(), changes())
def test_a_ripple_and_the_opposite_one_bring_every_key_back(shape: RotoShape, matrix: Array) -> None:
    frame, every = shape.frames[0], np.ones(shape.point_count)
    whole = Keying(ripple=range(-10_000, 10_000))
    there = reshape(shape, frame, transform_like(held_at(shape, frame), every, matrix), whole)
    back = np.linalg.inv(matrix[:, :2])
    inverse = np.column_stack([back, -back @ matrix[:, 2]])
    again = reshape(there, frame, transform_like(held_at(there, frame), every, inverse), whole)
    for key in shape.keys:
        np.testing.assert_allclose(again.at(key.frame).points, key.points, atol=1e-6)
