"""Finished keys steadied, on bodies whose motion, and trembling, is known."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.cancel import Cancelled, CancelToken
from roam_core.geometry import bezier
from roam_core.geometry.simple import crossing_segments
from roam_core.media.source import MissingFrame
from roam_core.params.steadiness import RESIDUAL, STEADINESS
from roam_core.propagate import track
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.propagate.steadiness.boil import boil
from roam_core.propagate.steadiness.steadied import steadied
from roam_core.propagate.steadiness.steadying import steadying, told
from roam_core.roto import BlendMode, Keyframe, Layer, LayerTransform, Origin, Project, RotoShape, Spline
from tests.golden.shots import Shot, blob, gliding, outline_distance

FRAMES = range(1001, 1011)
ARTIST = (1001, 1006)
RADII = np.array([34.0, 30.0, 27.0, 31.0, 35.0, 29.0, 32.0, 28.0])


@pytest.fixture(scope="module")
def shot() -> Shot:
    return gliding(blob(RADII), len(FRAMES), (60.0, 60.0), (2.3, 0.7), drift=(-0.6, 0.4))


def pushed(points: Array, outwards: Array | float) -> Array:
    """The outline with each point, and its handles, so far from the middle."""
    away = points[:, 0] - points[:, 0].mean(axis=0)
    return np.asarray(
        points + (np.broadcast_to(outwards, len(points)) / np.hypot(*away.T))[:, None, None] * away[:, None]
    )


def drawn(shot: Shot, off: dict[int, Array | float], artist: tuple[int, ...] = ARTIST) -> RotoShape:
    """The truth on the artist's frames; on others the engine's, so far off."""
    keys = [
        Keyframe(frame, shot.truth(frame))
        if frame in artist
        else Keyframe(frame, pushed(shot.truth(frame), off.get(frame, 0.0)), origin=Origin.ENGINE, inputs=f"of {frame}")
        for frame in FRAMES
    ]
    return RotoShape("body", "Body", tuple(keys))


@pytest.fixture(scope="module")
def trembling(shot: Shot) -> RotoShape:
    rng = np.random.default_rng(5)
    return drawn(shot, {frame: rng.normal(0.0, 0.8, len(RADII)) for frame in FRAMES})


def run(shot: Shot, shape: RotoShape, strength: float = 1.0, frames: range = FRAMES) -> RotoShape:
    (found,) = steadied(shot.read, [shape], frames, strength, STEADINESS)
    return found


def off(shot: Shot, shape: RotoShape) -> float:
    """Pixels of the engine's keys from the truth, in the mean."""
    return float(np.mean([outline_distance(key.points, shot.truth(key.frame)) for key in engine(shape)]))


def engine(shape: RotoShape) -> list[Keyframe]:
    return [key for key in shape.keys if key.origin is Origin.ENGINE]


def trembles(shot: Shot, shape: RotoShape) -> float:
    return float(np.mean([each.pixels for each in boil(shot.read, [shape], FRAMES, RESIDUAL).values()]))


def test_trembling_is_taken_off_and_the_outline_is_nearer_to_the_truth(shot: Shot, trembling: RotoShape) -> None:
    found = run(shot, trembling)
    assert trembles(shot, found) < 0.6 * trembles(shot, trembling)
    assert off(shot, found) < 0.8 * off(shot, trembling)


def test_half_of_it_does_less(shot: Shot, trembling: RotoShape) -> None:
    boils = [trembles(shot, run(shot, trembling, strength)) for strength in (0.02, 0.2, 1.0)]
    assert trembles(shot, trembling) > boils[0] > boils[1] > boils[2]


def test_the_artists_keys_and_all_else_that_keys_hold_stay_as_they_are(shot: Shot, trembling: RotoShape) -> None:
    found = run(shot, trembling)
    assert found.artist_keys == trembling.artist_keys
    assert [replace(key, points=trembling.key_at(key.frame).points) for key in found.keys] == list(trembling.keys)
    assert all(key != trembling.key_at(key.frame) for key in engine(found))


def test_at_nothing_the_shapes_are_the_very_same_and_no_picture_is_read(trembling: RotoShape) -> None:
    def read(_: int) -> Array:
        raise AssertionError("nothing is to be read")

    (found,) = steadied(read, [trembling], FRAMES, 0.0, STEADINESS)
    assert found is trembling


@pytest.mark.parametrize("strength", [-0.1, 1.1, float("nan")])
def test_another_strength_is_refused(shot: Shot, trembling: RotoShape, strength: float) -> None:
    with pytest.raises(ValueError, match="strength is in"):
        run(shot, trembling, strength)


def test_what_moves_by_many_pixels_from_frame_to_frame_is_not_flattened(shot: Shot) -> None:
    """Two points beat by seven pixels, which the flow of a rigid body does not see; the others do not."""
    beat = np.where(np.arange(len(RADII)) < 2, 7.0, 0.0)
    shape = drawn(shot, {frame: beat * (-1.0) ** frame for frame in FRAMES}, artist=(1001,))
    found = run(shot, shape)
    for key in engine(shape):
        now = found.key_at(key.frame)
        assert now is not None
        assert np.hypot(*(now.points - key.points)[:2, 0].T).max() < 0.7


def test_points_do_not_slide_along_the_outline(shot: Shot, trembling: RotoShape) -> None:
    found = run(shot, trembling)
    for key in engine(found):
        before = trembling.key_at(key.frame)
        assert before is not None
        where = np.arange(len(RADII)), np.zeros(len(RADII))
        along = bezier.derivative(before.points, *where)
        along /= np.hypot(*along.T)[:, None]
        moves = (key.points - before.points)[:, 0]
        assert np.abs((moves * along).sum(axis=1)).mean() < 0.25 * np.hypot(*moves.T).mean() + 0.02


def test_frames_without_a_picture_are_passed_over(shot: Shot, trembling: RotoShape) -> None:
    asked: list[int] = []

    def read(frame: int) -> Array:
        asked.append(frame)
        if frame in (1004, 1009) or frame not in FRAMES:
            raise MissingFrame("gone")
        return shot.read(frame)

    (found,) = steadied(read, [trembling], FRAMES, 1.0, STEADINESS)
    moved = {key.frame for key in engine(found) if key != trembling.key_at(key.frame)}
    assert asked == list(FRAMES)
    # Of 1010 no frame beside it has a picture; 1005 goes by the artist's 1006.
    assert moved == {1002, 1003, 1005, 1007, 1008}


def test_a_key_without_one_beside_it_stays(shot: Shot, trembling: RotoShape) -> None:
    alone = replace(trembling, keys=tuple(key for key in trembling.keys if key.frame in (1001, 1002, 1004, 1008)))
    found = run(shot, alone)
    assert {key.frame for key in found.keys if key != alone.key_at(key.frame)} == {1002}


def test_the_order_of_the_shapes_changes_nothing(shot: Shot, trembling: RotoShape) -> None:
    rng = np.random.default_rng(9)
    other = replace(drawn(shot, {frame: rng.normal(0.0, 0.8, len(RADII)) for frame in FRAMES}), id="other")
    there = steadied(shot.read, [trembling, other], FRAMES, 1.0, STEADINESS)
    back = steadied(shot.read, [other, trembling], FRAMES, 1.0, STEADINESS)
    assert there == back[::-1] == steadied(shot.read, [trembling, other], FRAMES, 1.0, STEADINESS)
    alike = steadied(shot.read, [trembling, replace(other, id=trembling.id)], FRAMES, 1.0, STEADINESS)
    assert [shape.keys for shape in alike] == [shape.keys for shape in there]


def test_a_part_of_the_frames_is_held_to_those_around_it(shot: Shot, trembling: RotoShape) -> None:
    asked: list[int] = []

    def read(frame: int) -> Array:
        asked.append(frame)
        return shot.read(frame)

    part = range(1003, 1005)
    (found,) = steadied(read, [trembling], part, 1.0, STEADINESS)
    assert asked == list(range(1001, 1007))
    assert {key.frame for key in found.keys if key != trembling.key_at(key.frame)} == set(part)
    assert trembles(shot, found) < trembles(shot, trembling)


def test_a_hole_goes_with_what_lies_around_it(shot: Shot) -> None:
    """On a plate of one texture, where inside and outside move alike, a hole is steadied as a shape is."""
    even = gliding(blob(np.full(8, 70.0)), len(FRAMES), (75.0, 60.0), (1.3, 0.7))
    small = gliding(blob(np.full(8, 24.0)), len(FRAMES), (75.0, 60.0), (1.3, 0.7))
    rng = np.random.default_rng(2)
    shape = drawn(small, {frame: rng.normal(0.0, 0.8, 8) for frame in FRAMES})
    hole = replace(shape, blend=BlendMode.SUBTRACT)
    found = run(even, hole)
    assert off(small, found) < 0.75 * off(small, hole)


def test_a_b_spline_stays_one(shot: Shot) -> None:
    from roam_core.roto.control_points import settled, with_spline

    shape = with_spline(drawn(shot, {frame: 0.8 * (-1.0) ** frame for frame in FRAMES}), Spline.BSPLINE)
    found = run(shot, shape)
    assert found.spline is Spline.BSPLINE
    for key in engine(found):
        assert key.points == pytest.approx(settled(key.points, found), abs=1e-6)
    assert trembles(shot, found) < trembles(shot, shape)


def test_no_outline_comes_to_cross_itself(shot: Shot) -> None:
    """A neck of a pixel, whose two sides tremble against each other."""
    points = bezier.polygon_points([(-30, -20), (-1, -0.5), (30, -20), (30, 20), (-1, 0.5), (-30, 20)])
    rng = np.random.default_rng(3)
    keys = []
    for frame in FRAMES:
        there = points + shot.poses[frame - FRAMES.start][:, 2]
        tremble = np.zeros((6, 1, 2))
        tremble[[1, 4], 0, 1] = (0.45 * rng.uniform(-1, 1), 0.45 * rng.uniform(-1, 1))
        keys.append(Keyframe(frame, there + tremble, origin=Origin.ENGINE))
    shape = RotoShape("neck", "Neck", tuple(keys))
    assert not any(len(crossing_segments(key.points)) for key in shape.keys)
    found = run(shot, shape)
    assert found != shape
    assert not any(len(crossing_segments(key.points)) for key in found.keys)


def test_open_shapes_and_shapes_out_of_the_picture_stay(shot: Shot, trembling: RotoShape) -> None:
    line = replace(trembling, closed=False)
    assert run(shot, line) is line
    away = replace(trembling, keys=tuple(replace(key, points=key.points + 5000.0) for key in trembling.keys))
    assert run(shot, away) == away


def test_it_stops_when_it_is_told_to(shot: Shot, trembling: RotoShape) -> None:
    token = CancelToken()
    told_of: list[float] = []

    def progress(fraction: float, _: str) -> None:
        told_of.append(fraction)
        if len(told_of) == 4:
            token.cancel()

    with pytest.raises(Cancelled):
        steadied(shot.read, [trembling], FRAMES, 1.0, STEADINESS, token, progress)
    assert len(told_of) == 4


def test_it_stops_between_the_keys_that_it_moves(shot: Shot, trembling: RotoShape) -> None:
    """Of many shapes most of the time goes there: nothing was told then, and Ctrl-C not heard."""
    token = CancelToken()
    told_of: list[float] = []

    def progress(fraction: float, _: str) -> None:
        told_of.append(fraction)
        if len(told_of) == len(FRAMES) + 2:
            token.cancel()

    shapes = [replace(trembling, id=name) for name in "abc"]
    with pytest.raises(Cancelled):
        steadied(shot.read, shapes, FRAMES, 1.0, STEADINESS, token, progress)
    assert told_of == sorted(told_of)
    assert told_of[len(FRAMES) :] == [0.5, 0.5 + 0.5 / 3]


def test_what_was_done_is_told(shot: Shot, trembling: RotoShape) -> None:
    fractions: list[float] = []
    found = steadying(
        shot.read, [trembling], FRAMES, 1.0, STEADINESS, RESIDUAL, progress=lambda done, _: fractions.append(done)
    )
    assert set(found.moved) == {("body", key.frame) for key in engine(trembling)}
    assert set(found.boil) == {spot for spot in found.moved if spot[1] != FRAMES[-1]}
    before, after = (np.mean([pair[k] for pair in found.boil.values()]) for k in (0, 1))
    measured = boil(shot.read, [trembling], FRAMES, RESIDUAL)
    assert before == pytest.approx(np.mean([measured[spot].pixels for spot in found.boil]), abs=0.1)
    assert (
        told(found) == f"{len(found.moved)} keys moved; boil by the picture {before:.2f} px before, {after:.2f} px now."
    )
    assert fractions == sorted(fractions)
    assert 0.5 < fractions[-1] <= 1.0
    nothing = steadying(shot.read, [trembling], FRAMES, 0.0, STEADINESS, RESIDUAL)
    assert told(nothing) == "No tracked key could be steadied; nothing was changed."


def test_what_was_moved_is_not_out_of_date_and_tracking_goes_on_as_from_what_was_there(shot: Shot) -> None:
    *_, last = track(shot.read, [shot.shape()], FRAMES)
    tracked = last.results[0].shape
    half = replace(tracked, keys=tracked.keys[:5])
    found = run(shot, half)
    assert {key.frame for key in found.keys if key != half.key_at(key.frame)} == {1002, 1003, 1004, 1005}
    stamps = Stamps([found], "", shot.size)
    assert not any(stamps.is_stale(found, key) for key in found.keys)
    *_, last = track(shot.read, [found], FRAMES[4:])
    assert last.results[0].shape.keys == (*found.keys, *tracked.keys[5:])
    *_, again = track(shot.read, [found], FRAMES)
    assert again.results[0].shape == tracked


def test_in_a_layer_that_moves_the_artists_keys_stay_bit_by_bit(shot: Shot, trembling: RotoShape) -> None:
    glides = np.tile(np.eye(3), (len(FRAMES), 1, 1))
    glides[:, 0, 2], glides[:, 1, 2] = np.linspace(0.0, 7.3, len(FRAMES)), np.linspace(0.0, 2.1, len(FRAMES))
    layer = Layer("layer", "Layer", transform=LayerTransform(tuple(FRAMES), glides))
    empty = Project(root=replace(Project().root, children=(layer,)))
    in_layer = empty.stored(trembling, "layer")
    project = empty.map_item("layer", lambda held: replace(held, children=(in_layer,)))
    (shape,) = project.shapes
    found = project.with_shape(run(shot, shape))
    (stored,) = found.root.shapes()
    assert stored.artist_keys == in_layer.artist_keys
    assert all(key != in_layer.key_at(key.frame) for key in engine(stored))
    assert off(shot, found.shapes[0]) < 0.8 * off(shot, trembling)
