"""An object that was lost is found where it comes into sight again, and nowhere else."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest

from roam_core import shapes_from_mask, track
from roam_core.appearance.global_model import GlobalModel
from roam_core.arrays import Array, Bools, Float32, UInt8
from roam_core.features import PreparedFrame
from roam_core.features.grid import Grid, Region
from roam_core.geometry import bezier
from roam_core.matte.compose import render_matte
from roam_core.motion.keypoints import Keypoints
from roam_core.params import CONFIGS, RedetectionParams, RegionParams, TextureParams
from roam_core.params.evidence import BackgroundParams
from roam_core.params.redetection import KeypointParams
from roam_core.propagate.curves import step as outline
from roam_core.propagate.explain import explain
from roam_core.propagate.frame.confidence import PoseFeatures
from roam_core.propagate.frame.redetection import AppearanceTemplate, LastSeen, Watch, is_better, middle_of
from roam_core.propagate.frame.result import Part
from roam_core.propagate.whole.observation import behind
from roam_core.propagate.whole.region import step
from roam_core.propagate.whole.state import begin
from roam_core.proposal.cues.evidence import Field, KeyMemory
from tests.unit.propagate.figures import card_that_comes_out

PARAMS = RedetectionParams()
SIZE = (140, 260)
RADIUS = 15
ROW = 70
FIRST, STEP = 40, 7
"""Column of the ball on frame 0, and columns a frame."""
POST = slice(95, 150)
"""Columns that hide what is behind them."""

REGION = RegionParams()


def meadow() -> UInt8:
    noise = np.random.default_rng(5).normal(0.0, 6.0, (*SIZE, 3))
    return np.clip(np.array([70, 120, 60]) + cv2.GaussianBlur(noise, (0, 0), 1.0), 0, 255).astype(np.uint8)


def disc(column: float, row: float = ROW, radius: float = RADIUS) -> Bools:
    y, x = np.mgrid[: SIZE[0], : SIZE[1]] + 0.5
    return np.asarray(np.hypot(x - column, y - row) < radius)


def picture(*columns: float, post: bool = False, radius: float = RADIUS, striped: bool = False) -> UInt8:
    """The meadow with discs, and what hides them; `striped` discs have a texture."""
    image = meadow()
    for column in columns:
        image[disc(column, radius=radius)] = (225, 120, 40)
        if striped:
            stripe = (np.arange(SIZE[1]) - round(column)) // 3 % 2 == 0
            image[disc(column, radius=radius) & stripe] = (200, 95, 25)
    if post:
        image[:, POST] = (110, 100, 105)
    return image


def appearance(column: float = 60.0, striped: bool = False) -> tuple[AppearanceTemplate, LastSeen]:
    whole = Grid.over(Region(0, 0, SIZE[1], SIZE[0]), 0.5)
    cover = whole.of(disc(column).astype(np.float32))
    region = Field(whole, (8.0 * (cover - 0.5)).astype(np.float32))
    area = np.pi * RADIUS**2
    last_seen = LastSeen(np.eye(3), area, np.array([column, ROW]), PARAMS, since=12)
    return AppearanceTemplate(PreparedFrame(picture(column, striped=striped)), region, PARAMS, 2e-5), last_seen


@pytest.mark.parametrize("column", [30.0, 61.0, 148.5, 220.0])
def test_it_is_seen_where_it_is(column: float) -> None:
    eye, last_seen = appearance()
    placed = eye.found(PreparedFrame(picture(column)), last_seen)
    assert placed is not None
    middle = placed[:2, :2] @ (60.0, ROW) + placed[:2, 2]
    assert np.hypot(*(middle - (column, ROW))) < 3.0


def test_it_is_seen_though_it_has_grown() -> None:
    eye, last_seen = appearance()
    placed = eye.found(PreparedFrame(picture(150.0, radius=1.25 * RADIUS)), last_seen)
    assert placed is not None
    assert np.sqrt(np.linalg.det(placed[:2, :2])) == pytest.approx(1.25)


def test_it_is_looked_for_at_each_size_that_it_has_had() -> None:
    """As it went behind something, it seemed to shrink."""
    eye, last_seen = appearance()
    shrunk = replace(last_seen, carried=np.diag([0.5, 0.5, 1.0]), area=0.25 * last_seen.area)
    known = replace(shrunk, largest=last_seen.area)
    frame = PreparedFrame(picture(90.0))
    assert eye.found(frame, shrunk) is None
    placed = eye.found(frame, known)
    assert placed is not None
    assert np.sqrt(np.linalg.det(placed[:2, :2])) == pytest.approx(1.0, rel=0.13)
    assert np.hypot(*(placed[:2] @ (60.0, ROW, 1.0) - (90.0, ROW))) < 3.0
    assert known.reach == last_seen.reach > shrunk.reach


def test_it_is_looked_for_at_the_size_that_the_camera_gives_it() -> None:
    """While it was hidden the camera pulled out, and what lay around it is seen at half its size."""
    eye, last_seen = appearance()
    frame, half = PreparedFrame(picture(90.0, radius=0.5 * RADIUS)), np.diag([0.5, 0.5, 1.0])
    assert eye.found(frame, last_seen) is None
    assert eye.found(frame, last_seen, surroundings=np.eye(3)) is None
    placed = eye.found(frame, last_seen, surroundings=half)
    assert placed is not None
    assert np.sqrt(np.linalg.det(placed[:2, :2])) == pytest.approx(0.5, rel=0.13)
    assert eye.found(frame, replace(last_seen, surroundings=half), surroundings=half) is None


def test_sizes_within_an_octave_are_looked_for_in_the_same_cells() -> None:
    eye, last_seen = appearance()
    asked: list[Grid] = []

    def nothing(grid: Grid) -> Float32:
        asked.append(grid)
        return np.zeros(grid.shape, np.float32)

    eye.found(PreparedFrame(picture(90.0)), last_seen, nothing)
    usual = asked.copy()
    assert len(usual) == 1
    eye.found(PreparedFrame(picture(90.0)), last_seen, nothing, surroundings=np.diag([0.3, 0.3, 1.0]))
    finer, *again = asked[1:]
    assert finer.factor.mean() > usual[0].factor.mean()
    assert again == usual


@pytest.mark.parametrize("zoom", [1e-6, 1e6])
def test_surroundings_that_were_followed_wrongly_do_no_harm(zoom: float) -> None:
    """Larger than the picture nothing is looked for: it would take the memory of all machines."""
    eye, last_seen = appearance()
    wrong = np.diag([zoom, zoom, 1.0])
    placed = eye.found(PreparedFrame(picture(90.0)), last_seen, surroundings=wrong)
    assert placed is not None
    assert np.sqrt(np.linalg.det(placed[:2, :2])) == pytest.approx(1.0, rel=0.3)
    assert eye.found(PreparedFrame(picture(90.0)), replace(last_seen, carried=1e6 * np.eye(3))) is None


def test_the_largest_size_is_that_of_a_sure_frame_or_of_the_key() -> None:
    eye, last_seen = appearance()

    def seen(before: LastSeen, size: float) -> LastSeen:
        way = np.diag([size, size, 1.0])
        way[:2, 2] = (1.0 - size) * np.array([60.0, ROW])
        region = Field(eye.region.grid, eye.region.on(eye.region.grid, way) - np.float32(0.5))
        return before.after(KeyMemory(eye.frame, eye.region, eye.colours, way, np.eye(3)), region)

    grown = seen(last_seen, 1.4)
    after = seen(grown, 0.7)
    assert last_seen.sizes() == list(PARAMS.sizes)
    assert grown.largest == grown.area == after.largest
    assert seen(last_seen, 0.7).largest == pytest.approx(last_seen.area)
    assert after.sizes() == pytest.approx([*PARAMS.sizes, *(PARAMS.sizes[-1] ** power for power in (2, 3))])


def test_nothing_is_seen_where_nothing_is() -> None:
    eye, last_seen = appearance()
    assert eye.found(PreparedFrame(picture()), last_seen) is None


def test_of_two_alike_none_is_taken() -> None:
    eye, last_seen = appearance()
    assert eye.found(PreparedFrame(picture(40.0, 160.0)), last_seen) is None


def test_of_two_alike_that_which_the_key_shows_beside_the_object_is_background() -> None:
    drawn, now = disc(60.0), PreparedFrame(picture(160.0, 210.0, striped=True))
    parts = tuple(Part(shape.at(0).points) for shape in shapes_from_mask(drawn))
    frame = PreparedFrame(picture(60.0, 210.0, striped=True))
    key = begin(frame, parts, replace(REGION, background=BackgroundParams())).key
    eye, last_seen = appearance(striped=True)
    assert eye.found(now, last_seen) is None
    placed = eye.found(now, last_seen, behind(key, now, replace(REGION, background=BackgroundParams())))
    assert placed is not None
    assert np.hypot(*(placed[:2] @ (60.0, ROW, 1.0) - (160.0, ROW))) < 3.0


def test_without_a_background_nothing_is_said_of_it() -> None:
    key = begin(PreparedFrame(picture(60.0)), (Part(shapes_from_mask(disc(60.0))[0].at(0).points),), REGION).key
    assert behind(key, PreparedFrame(picture(60.0)), REGION) is None


def test_it_is_not_looked_for_farther_than_it_can_have_gone() -> None:
    eye, last_seen = appearance()
    frame = PreparedFrame(picture(230.0))
    assert eye.found(frame, last_seen) is not None
    assert eye.found(frame, replace(last_seen, since=0)) is None


def test_a_place_beyond_the_picture_shows_nothing() -> None:
    eye, last_seen = appearance()
    beyond = replace(last_seen, middle=np.array([9000.0, 9000.0]))
    assert eye.found(PreparedFrame(picture(60.0)), beyond) is None


def test_what_is_long_gone_is_looked_for_now_and_then() -> None:
    _, last_seen = appearance()
    looks = [frames for frames in range(25) if replace(last_seen, since=frames).is_worth_a_look]
    assert looks == [*range(PARAMS.long_gone + 1), 12, 16, 20, 24]


def test_what_is_found_is_left_where_too_little_is_to_be_expected_of_it() -> None:
    columns = [FIRST + STEP * k for k in range(24)]
    frames = [PreparedFrame(picture(column, post=True)) for column in columns]
    parts = tuple(Part(shape.at(0).points) for shape in shapes_from_mask(disc(columns[0])))

    def last_seen_at(believed: float) -> list[int]:
        params = RegionParams(believed=believed)
        state, found = begin(frames[0], parts, params), []
        for number, frame in enumerate(frames[1:], 1):
            stepped = step(state, frame, params)
            if stepped.redetected:
                found.append(number)
            state = stepped.state
        return found

    assert last_seen_at(0.5)
    assert not last_seen_at(1.0)


@pytest.mark.parametrize(("distinct", "posed", "is_found"), [(2.0, 0.8, True), (2.0, 0.0, False), (9.0, 0.8, False)])
def test_what_lost_its_pose_is_found_without_it_where_its_colours_are_its_own(
    distinct: float, posed: float, is_found: bool
) -> None:
    """As a limb it would be held to where it was: something may hide it."""
    region = CONFIGS["best"].region
    assert region is not None
    params = replace(region, redetection=replace(region.redetection, distinct=distinct, posed=posed))
    parts = tuple(Part(shape.at(0).points) for shape in shapes_from_mask(disc(60.0)))
    state = begin(PreparedFrame(picture(60.0)), parts, params)
    assert state.pose is not None
    lost = replace(state.pose, template=replace(state.pose.template, densest_seam=1.0), is_gone=True)
    held = replace(state, pose=lost, features=PoseFeatures(unlike=0.9, beside=0.0, hidden=0.0))
    stepped = step(held, PreparedFrame(picture(110.0)), params)
    assert stepped.redetected is is_found
    assert stepped.state.is_posed is not is_found
    assert (stepped.state.pose is None) is is_found
    assert np.hypot(*(stepped.results[0].points[:, 0].mean(axis=0) - (110.0 if is_found else 60.0, ROW))) < 20.0


@pytest.mark.parametrize(("distinct", "hopeless", "is_found"), [(2.0, 0.0, True), (9.0, 0.0, False), (9.0, 0.8, True)])
def test_what_its_colours_do_not_tell_is_looked_for_where_nothing_is_left(
    distinct: float, hopeless: float, is_found: bool
) -> None:
    by_colours = replace(PARAMS, distinct=distinct, keypoints=KeypointParams(fewest=1000))
    params = replace(REGION, hopeless=hopeless, redetection=by_colours)
    parts = tuple(Part(shape.at(0).points) for shape in shapes_from_mask(disc(60.0)))
    stepped = step(begin(PreparedFrame(picture(60.0)), parts, params), PreparedFrame(picture(112.0)), params)
    assert stepped.redetected is is_found


def test_what_is_found_must_promise_enough_by_itself_and_more_beside_what_was_carried_on() -> None:
    little, enough, more = REGION.believed, REGION.believed + 0.1, 0.1 + REGION.better
    assert is_better(enough, more + 0.01, 0.1, REGION)
    assert not is_better(little, 1.0, 0.1, REGION)
    assert not is_better(1.0, more, 0.1, REGION)


def ring_of(column: float, radius: float = RADIUS) -> Array:
    angles = np.linspace(0.0, 2.0 * np.pi, 40, endpoint=False)
    return np.stack([column + radius * np.cos(angles), ROW + radius * np.sin(angles)], axis=1)


def test_what_lies_inside_resembles_the_object_as_far_as_it_is_the_object() -> None:
    eye, _ = appearance()
    frame = PreparedFrame(picture(150.0))
    alike = [eye.resemblance(frame, ring_of(150.0 + off)) for off in (0.0, 8.0, 16.0, 60.0)]
    assert alike[0] > 0.95
    assert alike == sorted(alike, reverse=True)
    assert alike[2] < 0.5
    assert alike[3] == pytest.approx(0.0, abs=1e-3)


@pytest.mark.parametrize("line", [ring_of(9000.0), ring_of(60.0, 0.1)], ids=["beyond the picture", "nothing left"])
def test_nothing_resembles_nothing(line: Array) -> None:
    assert appearance()[0].resemblance(PreparedFrame(picture(60.0)), line) == 0.0


def test_only_what_can_be_told_from_its_surroundings_is_watched() -> None:
    eye, _ = appearance()
    drawn = np.zeros((4, 3, 2))
    assert Watch.begun(drawn, eye.frame, eye.region, RegionParams()) is not None
    assert Watch.begun(drawn, PreparedFrame(meadow()), eye.region, RegionParams()) is None


def test_size_and_turn_are_taken_over_from_where_they_are_sure() -> None:
    eye, last_seen = appearance()
    grown = np.diag([1.5, 1.5, 1.0])
    key = KeyMemory(eye.frame, eye.region, eye.colours, grown, np.eye(3))
    region = Field(eye.region.grid, eye.region.on(eye.region.grid, grown) - np.float32(0.5))
    sure, doubtful = last_seen.after(key, region), last_seen.after(key, region, resemblance=0.7)
    assert sure.since == doubtful.since == 0
    np.testing.assert_array_equal(sure.middle, doubtful.middle)
    np.testing.assert_array_equal(sure.carried, grown)
    np.testing.assert_array_equal(doubtful.carried, last_seen.carried)
    assert last_seen.missed().since == last_seen.since + 1


def textured(column: float, hidden: int = 0, radius: float = RADIUS) -> UInt8:
    """A ball with spots of its own; its left edge and so many columns of it behind a grey board."""
    noise = cv2.GaussianBlur(np.random.default_rng(8).normal(size=(64, 64, 3)), (0, 0), 1.5)
    spots = np.clip([225, 120, 40] + 50.0 * noise / noise.std(), 0, 255).astype(np.uint8)
    size = radius / 32.0
    way = np.array([[size, 0.0, column - 32.0 * size - 0.5 + 0.5 * size], [0.0, size, ROW - radius - 0.5 + 0.5 * size]])
    image = np.where(disc(column, radius=radius)[..., None], cv2.warpAffine(spots, way, SIZE[::-1]), meadow())
    image[:, int(column - radius) - 30 : int(column - radius) + hidden] = (110, 100, 105)
    return np.asarray(image, np.uint8)


LARGE = 32.0
"""Radius of a ball with spots."""


def spotted() -> tuple[AppearanceTemplate, LastSeen]:
    grid = Grid.over(Region(0, 0, SIZE[1], SIZE[0]), 0.5)
    cover = grid.of(disc(60.0, radius=LARGE).astype(np.float32))
    region = Field(grid, (8.0 * (cover - 0.5)).astype(np.float32))
    last_seen = LastSeen(np.eye(3), np.pi * LARGE**2, np.array([60.0, ROW]), PARAMS, since=3)
    return AppearanceTemplate(PreparedFrame(textured(60.0, radius=LARGE)), region, PARAMS, 2e-5), last_seen


@pytest.mark.parametrize("hidden", [0, 32])
def test_what_is_seen_in_part_is_as_large_as_its_keypoints_say(hidden: int) -> None:
    eye, last_seen = spotted()
    placed = eye.found_by_keypoints(PreparedFrame(textured(170.0, hidden, radius=LARGE)), last_seen)
    assert placed is not None
    assert np.sqrt(np.linalg.det(placed[:2, :2])) == pytest.approx(1.0, abs=0.05)
    assert np.hypot(*(placed[:2] @ (60.0, ROW, 1.0) - (170.0, ROW))) < 2.0


def test_by_its_keypoints_nothing_is_known_that_is_not_there_or_not_its_size() -> None:
    eye, last_seen = spotted()
    there = PreparedFrame(textured(170.0, radius=LARGE))
    assert eye.found_by_keypoints(PreparedFrame(meadow()), last_seen) is None
    assert eye.found_by_keypoints(there, replace(last_seen, carried=np.diag([2.5, 2.5, 1.0]))) is None
    assert eye.found_by_keypoints(there, replace(last_seen, carried=np.diag([0.4, 0.4, 1.0]))) is None
    assert eye.found_by_keypoints(there, replace(last_seen, middle=np.array([9000.0, 9000.0]))) is None


def test_what_has_other_colours_is_not_known_by_its_keypoints() -> None:
    """The same spots on a grey ball: its keypoints are alike, for they are of the luma alone."""
    eye, last_seen = spotted()
    there = textured(170.0, radius=LARGE)
    grey = cv2.cvtColor(cv2.cvtColor(there, cv2.COLOR_RGB2GRAY), cv2.COLOR_GRAY2RGB)
    alike = Keypoints.of(PreparedFrame(grey), Grid.over(Region(0, 0, SIZE[1], SIZE[0]), 1.0))
    assert eye.keypoints.similarity_to(alike, 4.0, PARAMS.keypoints) is not None
    assert eye.found_by_keypoints(PreparedFrame(there), last_seen) is not None
    assert eye.found_by_keypoints(PreparedFrame(grey), last_seen) is None


def test_what_has_no_keypoints_is_not_known_by_them() -> None:
    eye, last_seen = spotted()
    plain = replace(eye, frame=PreparedFrame(np.full((*SIZE, 3), 120, np.uint8)))
    assert plain.found_by_keypoints(PreparedFrame(textured(170.0, radius=LARGE)), last_seen) is None
    assert plain.found_by_keypoints(plain.frame, last_seen) is None


def test_what_has_come_back_is_looked_for_by_its_keypoints_for_a_while() -> None:
    eye, last_seen = appearance()
    key = KeyMemory(eye.frame, eye.region, eye.colours, np.eye(3), np.eye(3))
    after = last_seen.missed()
    left = []
    for _ in range(PARAMS.long_gone + 2):
        left.append(after.returning)
        after = after.after(key, eye.region)
    assert left == [*range(PARAMS.long_gone, 0, -1), 0, 0]
    assert last_seen.after(key, eye.region).returning == 0


@pytest.mark.parametrize(("fewest", "is_whole"), [(5, True), (400, False)])
def test_what_is_half_out_is_taken_up_beyond_what_is_seen_of_it(fewest: int, is_whole: bool) -> None:
    """The board ends at 190, the card begins at 156: by its colours no more than what is in sight was taken up."""
    pictures, masks = card_that_comes_out(11)
    config = f"best+region.redetection.keypoints.fewest={fewest}"
    *_, last = track(pictures.__getitem__, shapes_from_mask(masks[0]), range(11), config)
    anchors = last.results[0].shape.at(10).anchors
    np.testing.assert_allclose(anchors.max(axis=0), (224.0, 162.0), atol=2.5)
    assert (anchors[:, 0].min() < 175.0) == is_whole


def test_landmarks_of_what_was_found_again_are_new_ones() -> None:
    params = CONFIGS["full"]
    key = PreparedFrame(picture(60.0))
    points = shapes_from_mask(disc(60.0))[0].at(0).points
    state = outline.begin(key, points, params)
    assert state.watch is not None
    assert state.landmarks is not None
    frame = PreparedFrame(picture(220.0))
    last_seen = replace(state.watch.last_seen, since=PARAMS.long_gone - 1)
    away = replace(state, watch=replace(state.watch, last_seen=last_seen))
    stepped = outline.step(away, frame, params)
    found = stepped.begun
    assert found is not away
    assert found.landmarks is not None
    assert len(found.landmarks.pool.ids) > 0
    assert not set(found.landmarks.pool.ids) & set(state.landmarks.pool.ids)
    after, result = stepped.state, stepped.result
    assert after.promise > 0.9
    assert np.hypot(*(result.points[:, bezier.ANCHOR].mean(axis=0) - (220.0, ROW))) < 3.0


def test_of_what_was_found_again_its_region_has_the_colours_of_the_key() -> None:
    """Whatever was learned since: here the background's colours for the object's."""
    key = PreparedFrame(picture(60.0))
    state = begin(key, (Part(shapes_from_mask(disc(60.0))[0].at(0).points),), replace(REGION, texture=TextureParams()))
    misled = GlobalModel(state.colours.outside, state.colours.inside)
    assert state.texture is not None
    wrong = replace(state.texture, since=state.texture.key[::-1])
    away = replace(state, colours=misled, texture=wrong, last_seen=replace(state.last_seen, since=PARAMS.long_gone - 1))
    stepped = step(away, PreparedFrame(picture(200.0)), REGION)
    found, after = stepped.begun, stepped.state
    assert stepped.redetected
    np.testing.assert_array_equal(found.colours.inside, state.key.colours.inside)
    np.testing.assert_array_equal(found.colours.outside, state.key.colours.outside)
    assert found.texture is not None
    assert not found.texture.since.any()
    assert np.hypot(*(middle_of(after.region) - (200.0, ROW))) < 3.0


def test_of_what_was_found_again_the_edges_learn_anew_from_the_key() -> None:
    params = CONFIGS["full"]
    key = PreparedFrame(picture(60.0))
    state = outline.begin(key, shapes_from_mask(disc(60.0))[0].at(0).points, params)
    assert state.watch is not None
    assert state.models is not None
    edges = state.models.edges
    misled = replace(state.models, edges=replace(edges, inside=edges.outside, outside=edges.inside))
    watch = replace(state.watch, last_seen=replace(state.watch.last_seen, since=PARAMS.long_gone - 1))
    away = replace(state, models=misled, watch=watch)
    found = outline.step(away, PreparedFrame(picture(200.0)), params).begun
    assert found is not away
    assert found.models is not None
    learned = found.models.edges
    np.testing.assert_array_equal(learned.inside.mean, learned.key_inside.mean)
    np.testing.assert_allclose(learned.inside.mean.mean(axis=(0, 1)), edges.key_inside.mean.mean(axis=(0, 1)), atol=5.0)


def test_a_frame_on_which_little_is_left_of_the_object_teaches_its_region_no_colours() -> None:
    """The post hides most of the ball within one frame: what is left is not taken for the object as it looks now."""
    params = replace(REGION, hopeless=0.0)

    def learned(before: float, now: float) -> bool:
        shown = disc(before)
        shown[:, POST] = False
        state = begin(
            PreparedFrame(picture(before, post=True)), (Part(shapes_from_mask(shown)[0].at(0).points),), params
        )
        after = step(state, PreparedFrame(picture(now, post=True)), params).state
        assert after.region.inside.any()
        return not np.array_equal(after.colours.inside, state.colours.inside)

    assert learned(60.0, 62.0)
    assert not learned(90.0, 106.0)


def test_a_hole_is_not_looked_for() -> None:
    points = shapes_from_mask(disc(60.0))[0].at(0).points
    state = outline.begin(PreparedFrame(picture(60.0)), points, CONFIGS["full"], is_hole=True)
    assert state.watch is None
    assert state.promise == 1.0


@pytest.mark.parametrize("config", ["full", "best"])
def test_a_ball_that_went_behind_a_post_is_carried_on_behind_it(config: str) -> None:
    columns = [FIRST + STEP * k for k in range(24)]
    frames = [picture(column, post=True) for column in columns]
    hidden = [not (disc(column)[:, : POST.start].any() or disc(column)[:, POST.stop :].any()) for column in columns]
    assert sum(hidden) >= 3
    shapes = shapes_from_mask(disc(columns[0]))
    results = list(track(lambda frame: frames[frame], shapes, range(len(frames)), config))
    for result in results[-4:]:
        matte = render_matte([each.shape for each in result.results], result.frame, SIZE) > 0.5
        true = disc(columns[result.frame])
        assert (matte & true).sum() / (matte | true).sum() > 0.8
    lost = [each for each in results if hidden[each.frame]]
    assert all(each.results[0].confidence < 0.5 for each in lost[1:])


def test_a_frame_on_which_it_was_found_again_is_explained_from_there() -> None:
    columns = [FIRST + STEP * k for k in range(24)]
    frames = [picture(column, post=True) for column in columns]
    shapes = shapes_from_mask(disc(columns[0]))
    results = [each.results[0] for each in track(lambda frame: frames[frame], shapes, range(len(frames)), "full")]
    middles = [each.shape.at(each.frame).points.mean(axis=(0, 1))[0] for each in results]
    leap = int(np.argmax(np.diff(middles))) + 1
    assert middles[leap] - middles[leap - 1] > RADIUS
    result = results[leap]
    (told,) = explain(lambda frame: PreparedFrame(frames[frame]), [result.shape], result.frame, None)
    assert told.apart == 0.0
    assert told.account.total.sum() + told.account.landmark_total.sum() == pytest.approx(
        result.energies["total"], abs=1e-6
    )


@pytest.mark.parametrize(("background", "is_taken"), [(None, True), (BackgroundParams(), False)])
def test_what_the_key_shows_beside_the_object_is_not_taken_for_it_when_it_has_left(
    background: BackgroundParams | None, is_taken: bool
) -> None:
    region = CONFIGS["best"].region
    assert region is not None
    params = replace(region, background=background)
    columns = [40.0 - 12.0 * k for k in range(8)]
    parts = tuple(Part(shape.at(0).points) for shape in shapes_from_mask(disc(columns[0])))
    state, found = begin(PreparedFrame(picture(columns[0], 90.0)), parts, params), []
    for column in columns[1:]:
        stepped = step(state, PreparedFrame(picture(column, 90.0)), params)
        found.append(stepped.redetected)
        state = stepped.state
    assert any(found) is is_taken
    assert (state.region.on(Grid(Region(0, 0, SIZE[1], SIZE[0]), *SIZE)) > 0.5).any() == is_taken


@pytest.mark.parametrize(("gone", "hopeless", "is_left"), [(0.0, 0.1, True), (400.0, 0.1, False), (0.0, 0.65, False)])
def test_a_scrap_is_let_go_once_the_key_has_left_the_picture_or_nothing_is_to_be_expected_of_it(
    gone: float, hopeless: float, is_left: bool
) -> None:
    """What is left of the object where it was, when all of its key went `gone` pixels away."""
    never_found = replace(PARAMS, alike=9.0)
    params = replace(REGION, believed=0.7, doubted=0.7, hopeless=hopeless, redetection=never_found)
    parts = tuple(Part(shape.at(0).points) for shape in shapes_from_mask(disc(60.0)))
    state = begin(PreparedFrame(picture(60.0)), parts, params)
    away = np.array([[1.0, 0.0, gone], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    scrap = picture()
    scrap[disc(60.0, radius=6.0)] = (225, 120, 40)
    stepped = step(replace(state, key=replace(state.key, to_now=away)), PreparedFrame(scrap), params)
    assert stepped.state.trust < params.believed
    assert stepped.state.region.inside.any() == is_left
    assert (np.ptp(stepped.results[0].points[:, 0], axis=0).max() > 1.0) == is_left
