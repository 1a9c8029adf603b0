"""Pictures of few lines are enlarged for the engine of regions, those of little contrast stretched.

What comes out is told in their own pixels.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core import fill_span, render_matte, shapes_from_mask, track
from roam_core.arrays import Array, Bools, UInt8
from roam_core.features import PreparedFrame, Region
from roam_core.params import RoamParams, params_for
from roam_core.propagate.engines.begin import begin
from roam_core.propagate.engines.view import EngineView
from roam_core.propagate.explain import explain
from roam_core.propagate.group import parts_at
from roam_core.propagate.shapes.objects import near, units
from roam_core.roto import Keyframe, RotoShape
from tests.golden.shots import Shot, blob, outline_distance, overlap, pose
from tests.unit.propagate.dimmed import dimmed_body

LEVELLED = "best+region.rigid=1.1+region.pose=none"
"""The region is asked, though these bodies move as one piece."""
CONFIG = f"{LEVELLED}+region.levels=none"
BEST, BEST_LEVELLED = params_for(CONFIG), params_for(LEVELLED)
SHOT = Shot(blob([12.0, 4.0, 12.0, 4.0, 12.0, 4.0]), tuple(pose(50.0 + 2.2 * k, 60.0 - k, 3.0 * k) for k in range(5)))
LARGE = (240, 320)


def enlarged(frame: int) -> UInt8:
    return np.asarray(cv2.resize(SHOT.read(frame), LARGE[::-1], interpolation=cv2.INTER_CUBIC), dtype=np.uint8)


def twice(shape: RotoShape) -> RotoShape:
    return replace(shape, keys=tuple(replace(key, points=2.0 * key.points) for key in shape.keys))


def by_hand(
    read: Callable[[int], UInt8], shapes: Sequence[RotoShape], frames: range, params: RoamParams, size: tuple[int, int]
) -> list[Array]:
    """The points of an object on the last frame, found by an engine that is begun and stepped on pictures as they are.

    `size` is that of the pictures that the shapes were drawn on.
    """
    order = tuple(range(len(shapes)))
    parts, made = parts_at(shapes, frames[0]), units(shapes, near(size))
    engine = begin(PreparedFrame(read(frames[0])), parts, params, made, order)
    for frame in frames[1:]:
        step = engine.step(PreparedFrame(read(frame)), order)
        engine = step.after
    return [each.points for each in step.results]


@pytest.mark.parametrize(
    ("size", "seen"),
    [
        ((240, 320), (480, 640)),
        ((352, 288), (587, 480)),
        ((120, 160), (240, 320)),
        ((480, 854), (480, 854)),
        ((1080, 1920), (1080, 1920)),
        ((1, 400), (2, 800)),
    ],
)
def test_small_pictures_are_seen_at_most_twice_as_large(size: tuple[int, int], seen: tuple[int, int]) -> None:
    view = EngineView.of_key(PreparedFrame(np.full((*size, 3), 128, np.uint8)), BEST)
    assert view.seen == seen
    corner = np.array([float(size[1]), float(size[0])])
    np.testing.assert_allclose(view.points(corner), seen[::-1], rtol=1e-12)
    np.testing.assert_allclose(view.back(view.points(corner)), corner, rtol=1e-12)


def test_engines_of_curves_see_them_as_they_are() -> None:
    picture = PreparedFrame(SHOT.read(SHOT.first))
    view = EngineView.of_key(picture, params_for("full"))
    assert view == EngineView(SHOT.size, Region(0, 0, *SHOT.size[::-1]), SHOT.size)
    assert picture.resized(picture.size) is picture


def test_what_is_tracked_is_what_an_engine_finds_on_the_enlarged_pictures() -> None:
    *_, last = track(SHOT.read, [SHOT.shape()], SHOT.frames, BEST)
    (points,) = by_hand(enlarged, [twice(SHOT.shape())], SHOT.frames, BEST, SHOT.size)
    np.testing.assert_array_equal(2.0 * last.results[0].shape.at(last.frame).points, points)


def test_within_bars_an_object_is_tracked_as_on_the_cropped_picture() -> None:
    """What the bars hide of it is out of the picture, not a thing that stands still."""
    beside, above = 44, 6
    corner = np.array([beside, above])

    def barred(frame: int) -> UInt8:
        picture = SHOT.read(frame).copy()
        picture[:above] = picture[:, :beside] = 0
        return picture

    def cropped(frame: int) -> UInt8:
        return SHOT.read(frame)[above:, beside:].copy()

    def through(read: Callable[[int], UInt8], shape: RotoShape) -> Array:
        *_, last = track(read, [shape], SHOT.frames, BEST_LEVELLED)
        return np.asarray(last.results[0].shape.at(last.frame).points)

    shape = SHOT.shape()
    moved = shape.map_points(lambda points: points - corner)
    np.testing.assert_allclose(through(barred, shape), through(cropped, moved) + corner, atol=1e-6)


@pytest.mark.shared
def test_a_small_picture_loses_less_than_one_that_is_seen_as_it_is(shared: Path) -> None:
    """What is thin on photographs of 192 lines: the wheels and the legs of a woman with a pram."""
    folder = shared / "data" / "davis2016-train"

    def small(kind: str, name: str) -> UInt8:
        image = cv2.imread(str(folder / kind / "stroller" / name))
        assert image is not None
        return np.asarray(cv2.resize(image, (342, 192), interpolation=cv2.INTER_AREA), dtype=np.uint8)

    def read(frame: int) -> UInt8:
        return np.ascontiguousarray(small("JPEGImages", f"{frame:05d}.jpg")[..., ::-1])

    def mask(frame: int) -> Bools:
        return np.asarray(small("Annotations", f"{frame:05d}.png")[..., 0] > 127)

    params, frames = params_for("best"), range(9)
    shapes = shapes_from_mask(mask(0))
    *_, last = track(read, shapes, frames, params)
    as_it_is = [
        RotoShape(shape.id, shape.name, (Keyframe(last.frame, points),), blend=shape.blend)
        for shape, points in zip(shapes, by_hand(read, shapes, frames, params, (192, 342)), strict=True)
    ]
    ours, theirs = (
        overlap(render_matte(each, last.frame, (192, 342)) > 0.5, mask(last.frame))
        for each in ([result.shape for result in last.results], as_it_is)
    )
    assert ours > theirs + 0.03


def test_a_fill_and_an_explanation_are_told_in_pixels_of_the_picture() -> None:
    first, stop = SHOT.frames[0], SHOT.frames[-1]
    shape = SHOT.shape().with_key(Keyframe(stop, SHOT.truth(stop)))
    (filled,) = fill_span({frame: SHOT.read(frame) for frame in SHOT.frames}, [shape], first, stop, BEST)
    for frame in range(first + 1, stop):
        assert outline_distance(filled.at(frame).points, SHOT.truth(frame)) < 0.7
    *_, last = track(SHOT.read, [SHOT.shape()], SHOT.frames[:3], CONFIG)
    tracked = last.results[0].shape
    (told,) = explain(lambda frame: PreparedFrame(SHOT.read(frame)), [tracked], last.frame, None)
    assert told.apart == 0.0
    assert len(told.account.terms) > 1
    assert _farthest(told.account.nodes, SHOT.truth(last.frame)) < 4.0


def _farthest(nodes: Array, true: Array) -> float:
    return float(np.abs(nodes.mean(axis=0) - true[:, 0].mean(axis=0)).max())


def test_a_mask_of_few_lines_gets_as_many_points_as_one_of_twice_as_many() -> None:
    small = SHOT.matte(SHOT.first)
    large = cv2.resize(small, LARGE[::-1], interpolation=cv2.INTER_CUBIC)
    (ours,), (theirs,), (coarse,) = (
        shapes_from_mask(small),
        shapes_from_mask(large, tolerance=1.0),
        shapes_from_mask(small, tolerance=1.0),
    )
    assert abs(ours.point_count - theirs.point_count) <= 2
    assert coarse.point_count < ours.point_count


def faded(frame: int) -> UInt8:
    """The shot with a sixth of its contrast, as in haze."""
    return np.asarray(np.round(150.0 + (SHOT.read(frame) - 128.0) / 6.0), dtype=np.uint8)


def test_a_picture_of_little_contrast_is_seen_by_the_levels_of_its_key() -> None:
    key, later = (PreparedFrame(faded(frame)) for frame in (1001, 1003))
    view = EngineView.of_key(key, BEST_LEVELLED)
    assert view.levels is not None
    assert view.picture(later).size == view.seen
    assert view.picture(later).image.std() > 3.0 * later.image.std()
    assert EngineView.of_key(key, params_for("full")).levels is None


@pytest.mark.parametrize(("config", "is_followed"), [("best", True), ("best+region.levels=none", False)])
def test_a_body_in_haze_is_followed_by_the_levels_alone(config: str, is_followed: bool) -> None:
    pictures, masks = dimmed_body(10, 0.0)
    hazy = [np.asarray(np.round(150.0 + (picture - 128.0) / 6.0), dtype=np.uint8) for picture in pictures]
    *_, last = track(lambda frame: hazy[frame], shapes_from_mask(masks[0]), range(10), config)
    found = render_matte([result.shape for result in last.results], 9, masks[9].shape) > 0.5
    assert (overlap(found, masks[9] > 127) > 0.95) is is_followed


def test_both_passes_of_a_fill_go_by_the_levels_of_its_first_key() -> None:
    shape, last = SHOT.shape(), SHOT.frames[-1]
    keyed = shape.with_key(Keyframe(last, SHOT.truth(last)))
    (filled,) = fill_span(
        {frame: faded(frame) for frame in SHOT.frames}, [keyed], SHOT.first, last, f"{LEVELLED}+region.exposure=none"
    )
    levels = EngineView.of_key(PreparedFrame(faded(SHOT.first)), BEST_LEVELLED).levels
    assert levels is not None
    stretched = {frame: levels.table[faded(frame)] for frame in SHOT.frames}
    (twin,) = fill_span(stretched, [keyed], SHOT.first, last, f"{CONFIG}+region.exposure=none")
    apart = [np.abs(filled.at(frame).points - twin.at(frame).points).max() for frame in SHOT.frames]
    assert max(apart) < 0.3  # steadied by the flow of the picture as it is
