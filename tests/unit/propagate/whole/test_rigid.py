"""The rigid mode: what moves as one piece keeps the outline that was drawn, what bends or is hidden is left alone."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest

from roam_core import fill_span, track
from roam_core.arrays import Array, Float32, UInt8
from roam_core.cli.explain import text_of
from roam_core.features import PreparedFrame
from roam_core.geometry import projective, similarity
from roam_core.geometry.bezier import ANCHOR, polygon_points
from roam_core.motion.planar import Match
from roam_core.params import RigidityParams, RoamParams, params_for
from roam_core.propagate.explain import explain
from roam_core.propagate.frame.result import Part
from roam_core.propagate.whole.rigid import PlanePose, Rigidity
from roam_core.roto import Keyframe, RotoShape

SIZE = (200, 300)
HULL = polygon_points([(60, 110), (100, 110), (101, 50), (103, 50), (104, 110), (180, 110), (165, 150), (75, 150)])
"""A ship with a mast two pixels wide."""
TO_OPENCV = np.array([[1.0, 0.0, -0.5], [0.0, 1.0, -0.5], [0.0, 0.0, 1.0]])
COUNT = 10
LEAST = 0.6


def noise(seed: int, low: float, high: float) -> Float32:
    rough = np.random.default_rng(seed).uniform(0.0, 1.0, (*SIZE, 3)).astype(np.float32)
    soft = cv2.GaussianBlur(rough, (0, 0), 1.5)
    return np.asarray(low + (high - low) * (soft - soft.min()) / (soft.max() - soft.min()), dtype=np.float32)


SEA, PAINT = noise(1, 20.0, 150.0), noise(2, 40.0, 240.0)


def pose(frame: int) -> Array:
    """The true motion `(3, 3)` of the ship from frame 0: it glides, turns, grows, and is seen from another side."""
    middle = np.array([[1.0, 0.0, -120.0], [0.0, 1.0, -120.0], [0.0, 0.0, 1.0]])
    angle, size = np.radians(0.8 * frame), 1.0 + 0.012 * frame
    motion = np.eye(3)
    motion[:2, :2] = size * np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    motion[:2, 2] = 3.0 * frame, -0.7 * frame
    motion[2, :2] = 5e-5 * frame, -3e-5 * frame
    return projective.normalised(np.linalg.inv(middle) @ motion @ middle)


def picture(frame: int, post: tuple[int, int] | None = None) -> UInt8:
    """The ship on the sea, which stands still; `post` are columns that hide what is behind them."""
    return drawn([(pose(frame), HULL)], post)


def drawn(components: list[tuple[Array, Array]], post: tuple[int, int] | None = None) -> UInt8:
    image = SEA.copy()
    for motion, points in components:
        moved = cv2.warpPerspective(PAINT, TO_OPENCV @ motion @ np.linalg.inv(TO_OPENCV), SIZE[::-1])
        mask = np.zeros(SIZE, np.uint8)
        corners = projective.apply(motion, points[:, ANCHOR])
        cv2.fillPoly(mask, [np.round((corners - 0.5) * 16).astype(np.int32)], 255, shift=4)
        image[mask > 0] = moved[mask > 0]
    if post is not None:
        image[:, slice(*post)] = (90, 95, 100)
    return np.asarray(image, dtype=np.uint8)


def ship() -> RotoShape:
    return RotoShape("ship", "Ship", (Keyframe(0, HULL),))


def strayed(config: str | RoamParams) -> list[tuple[float, bool]]:
    """By frame: how far the worst point of the ship lies from its true place, and whether it moved as one piece."""
    solved = track(picture, [ship()], range(COUNT), config)
    return [
        (
            float(np.hypot(*(each.results[0].shape.at(each.frame).points - true).T).max()),
            "rigid" in each.results[0].energies,
        )
        for each in solved
        for true in [projective.apply(pose(each.frame), HULL)]
    ]


def test_a_ship_keeps_its_mast() -> None:
    assert all(held and away < 2.0 for away, held in strayed("best"))


def test_without_the_rigid_mode_its_points_stray() -> None:
    best = params_for("best")
    assert best.region is not None
    found = strayed(replace(best, region=replace(best.region, rigid=1.1, pose=None, patches=None, background=None)))
    assert not any(held for _, held in found)
    assert max(away for away, _ in found) > 2.0


def test_two_halves_that_go_apart_are_no_piece() -> None:
    left, right = (polygon_points([(x, 60), (x + 50, 60), (x + 50, 140), (x, 140)]) for x in (60, 110))
    whole = polygon_points([(60, 60), (160, 60), (160, 140), (60, 140)])

    def read(frame: int) -> UInt8:
        apart = np.eye(3)
        apart[1, 2] = 4.0 * frame
        return drawn([(np.eye(3), left), (apart, right)])

    shape = RotoShape("pair", "Pair", (Keyframe(0, whole),))
    results = [each.results[0] for each in track(read, [shape], range(5), "best")]
    assert not any("rigid" in result.energies for result in results)


def test_what_is_hidden_is_left_to_the_region() -> None:
    hidden = (130, 220)
    results = [
        each.results[0]
        for each in track(lambda frame: picture(frame, hidden if frame in (4, 5) else None), [ship()], range(9), "best")
    ]
    held = ["rigid" in result.energies for result in results]
    assert held[:3] == [True] * 3
    assert not any(held[3:5])
    assert held[-1]


def test_between_two_keys_it_keeps_its_mast() -> None:
    last = COUNT - 1
    shape = RotoShape("ship", "Ship", tuple(Keyframe(k, projective.apply(pose(k), HULL)) for k in (0, last)))
    (filled,) = fill_span({frame: picture(frame) for frame in range(COUNT)}, [shape], 0, last)
    for frame in range(1, last):
        true = projective.apply(pose(frame), HULL)
        assert float(np.hypot(*(filled.at(frame).points - true).T).max()) < 1.5


def test_an_explanation_tells_it() -> None:
    *_, last = track(picture, [ship()], range(4), "best")
    (told,) = explain(lambda frame: PreparedFrame(picture(frame)), [last.results[0].shape], 3, None)
    assert told.apart == 0.0
    assert told.account.as_one_piece is not None
    assert told.account.as_one_piece == pytest.approx(1.0 - last.results[0].energies["rigid"])
    assert "as one piece" in "\n".join(text_of(told))


def learned() -> Rigidity:
    return Rigidity.learned(PreparedFrame(picture(0)), (Part(HULL),), RigidityParams())


def test_it_is_believed_where_the_corners_are_and_not_where_the_picture_is_another() -> None:
    eye, moved = learned(), pose(1)
    after, found = eye.step(PreparedFrame(picture(1)), np.eye(3), LEAST)
    assert found is not None
    assert found.match.agreement > 0.9
    np.testing.assert_allclose(found.matrix[:2, 2], moved[:2, 2], atol=1.0)
    assert after.held
    assert after.missed == 0
    other = PreparedFrame(np.asarray(noise(9, 0.0, 255.0), dtype=np.uint8))
    after, lost = after.step(other, np.eye(3), LEAST)
    assert lost is None
    assert (after.held, after.missed) == (False, 1)


def test_it_is_given_up_in_the_end() -> None:
    eye, blank = learned(), PreparedFrame(np.zeros((*SIZE, 3), np.uint8))
    for _ in range(RigidityParams().given_up):
        eye, found = eye.step(blank, np.eye(3), LEAST)
        assert found is None
    again, found = eye.step(PreparedFrame(picture(0)), np.eye(3), LEAST)
    assert found is None
    assert again is eye
    assert eye.at(np.eye(3)).step(PreparedFrame(picture(0)), np.eye(3), LEAST)[1] is not None


def test_an_object_that_shrank_to_nothing_is_given_up() -> None:
    after, found = learned().step(PreparedFrame(picture(0)), np.diag([1e-9, 1e-9, 1.0]), LEAST)
    assert found is None
    assert after.missed == RigidityParams().given_up


def test_few_corners_are_not_believed() -> None:
    small = polygon_points([(90, 112), (97, 112), (97, 119), (90, 119)])
    eye = Rigidity.learned(PreparedFrame(picture(0)), (Part(small),), RigidityParams())
    assert eye.step(PreparedFrame(picture(0)), np.eye(3), LEAST)[1] is None


def test_what_the_picture_cut_off_is_no_piece_once_it_comes_into_sight() -> None:
    cut = polygon_points([(60, 110), (0, 110), (0, 150), (75, 150), (165, 150), (180, 110)])
    eye, still = Rigidity.learned(PreparedFrame(picture(0)), (Part(cut),), RigidityParams()), np.eye(3)
    assert eye.step(PreparedFrame(picture(0)), still, LEAST)[1] is not None
    for x, is_one_piece in ((-8.0, True), (3.0, True), (8.0, False)):
        glide = np.array([[1.0, 0.0, x], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
        moved = cv2.warpPerspective(picture(0), glide, SIZE[::-1], borderMode=cv2.BORDER_REFLECT)
        assert (eye.step(PreparedFrame(moved), glide, LEAST)[1] is not None) is is_one_piece


def test_holes_alone_are_cut_off_nowhere() -> None:
    eye = Rigidity.learned(PreparedFrame(picture(0)), (Part(HULL, subtracts=True),), RigidityParams())
    assert eye.cut_off.places.shape == (0, 2)
    eye.step(PreparedFrame(picture(0)), np.eye(3), LEAST)


def test_a_motion_without_perspective_is_found_without_it() -> None:
    glide = np.array([[1.0, 0.0, 5.0], [0.0, 1.0, -3.0], [0.0, 0.0, 1.0]])
    _, found = learned().step(PreparedFrame(drawn([(glide, HULL)])), np.eye(3), LEAST)
    assert found is not None
    assert found.matrix[0, 0] == found.matrix[1, 1]
    assert found.matrix[0, 1] == -found.matrix[1, 0]
    np.testing.assert_array_equal(found.matrix[2], [0.0, 0.0, 1.0])
    np.testing.assert_allclose(found.similarity, found.matrix, atol=1e-2)


def test_a_vertex_is_supported_by_the_corners_around_it() -> None:
    rng = np.random.default_rng(3)
    sought = rng.uniform(0.0, 100.0, (200, 2))
    agreeing = sought[sought[:, 0] < 50.0]
    part = Part(polygon_points([(0, 0), (100, 0), (100, 100), (0, 100)]))
    support = PlanePose(np.eye(3), Match(np.eye(3), sought, agreeing, agreeing, 200), RigidityParams()).support(part)
    np.testing.assert_allclose(support[[0, 3]], 1.0, atol=0.05)
    np.testing.assert_allclose(support[[1, 2]], 0.0, atol=0.05)


@pytest.mark.parametrize("scale", [0.5, 2.0])
def test_a_motion_that_would_blow_the_object_up_is_not_believed(scale: float) -> None:
    grown = np.vstack([similarity.fit(HULL[:, ANCHOR], scale * HULL[:, ANCHOR]), [0.0, 0.0, 1.0]])
    eye = learned().at(grown)
    after, found = eye.step(PreparedFrame(picture(0)), np.eye(3), LEAST)
    assert found is None
    assert after.missed == 1
