"""The peers on a motion that each of them can follow, and the engine through the same doors."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest

from benchmarks import placement, shots, true_keys
from benchmarks.artist import method_of
from benchmarks.methods import PEERS, ContourFlow, Engine, GrabCut, Hold, Method, Planar
from benchmarks.methods.correlation import BoxTracker
from benchmarks.shots import Shot

MOVING: tuple[Method, ...] = (
    Planar("similarity"),
    Planar("affine"),
    Planar("homography"),
    ContourFlow(),
    GrabCut(),
    Engine("baseline"),
)


def name_of(method: Method) -> str:
    return method.name


def overlaps(method: Method, shot: Shot, frames: range) -> list[float]:
    carried = method.carry(shot, true_keys.of(shot).on(frames[0]), frames)
    return [shots.overlap(mask, shot.mask(frame)) for frame, mask in zip(frames[1:], carried, strict=True)]


@pytest.mark.parametrize("method", MOVING, ids=name_of)
def test_a_pure_translation_is_followed_both_ways(method: Method, gliding: Shot) -> None:
    # Flow on the very border is half the background's: points fall behind, and blending both ways makes up for it.
    least = 0.75 if isinstance(method, ContourFlow) else 0.9
    for frames in (gliding.frames, gliding.frames[::-1]):
        assert min(overlaps(method, gliding, frames)) > least
    filled = placement.between(method, gliding, gliding.first, gliding.last)
    assert len(filled) == len(gliding.frames) - 2
    assert min(filled) > 0.9


def test_holding_falls_behind(gliding: Shot) -> None:
    assert overlaps(Hold(), gliding, gliding.frames)[-1] < 0.6


@pytest.mark.parametrize("method", MOVING, ids=name_of)
def test_a_shape_that_has_ended_is_not_carried(method: Method, gliding: Shot) -> None:
    ended = [replace(shape, lifetime=(0, gliding.first)) for shape in true_keys.of(gliding).on(gliding.first)]
    for mask in method.carry(gliding, ended, gliding.frames[:3]):
        assert not mask.any()


@pytest.mark.parametrize("method", [*PEERS, *MOVING], ids=name_of)
def test_a_shape_without_a_key_at_the_far_end_is_filled_from_the_near_one(method: Method, gliding: Shot) -> None:
    stop = gliding.first + 3
    lone = [replace(shape, lifetime=(0, stop)) for shape in true_keys.of(gliding).on(gliding.first)]
    masks = method.fill(gliding, lone, gliding.first, stop)
    assert len(masks) == 2
    if not isinstance(method, GrabCut):  # it knows masks alone, and the far one is empty
        assert all(mask.any() for mask in masks)


@pytest.mark.parametrize("method", [*PEERS, Engine("baseline")], ids=name_of)
def test_neighbouring_keys_leave_nothing_to_fill(method: Method, gliding: Shot) -> None:
    shapes = true_keys.of(gliding).over([gliding.first, gliding.first + 1])
    assert method.fill(gliding, shapes, gliding.first, gliding.first + 1) == []


def test_methods_are_known_by_their_short_names() -> None:
    assert method_of("affine").name == "planar, affine"
    assert method_of("best").name == "`best`"


def test_the_box_tracker_finds_a_shift() -> None:
    rng = np.random.default_rng(3)
    background = 3.0 * cv2.GaussianBlur(rng.uniform(0.0, 40.0, (90, 120)).astype(np.float32), (0, 0), 2.0)
    thing = 3.0 * cv2.GaussianBlur(rng.uniform(40.0, 80.0, (24, 30)).astype(np.float32), (0, 0), 2.0)
    before, after = background.copy(), background.copy()
    before[30:54, 40:70], after[34:58, 46:76] = thing, thing
    tracker = BoxTracker(before, (40.0, 30.0, 70.0, 54.0))
    assert np.allclose(tracker.step(after), (6.0, 4.0), atol=1.0)
    assert np.allclose(tracker.box, (46.0, 34.0, 76.0, 58.0), atol=1.0)
