"""The demo shot's picture: deterministic frames with grain, an edge to see, changing light and a short occlusion."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from resources import demo
from resources.demo import film
from resources.demo.outline import polyline
from roam_core.geometry.polyline import outward_normals, resample

FRAMES = range(demo.FIRST, demo.LAST + 1)


@pytest.fixture(scope="module")
def first() -> np.ndarray:
    return demo.render_frame(demo.FIRST)


def test_frame_has_the_format_of_the_plate(first: np.ndarray) -> None:
    assert first.shape == (540, 960, 3)
    assert first.dtype == np.uint8
    assert first.std() > 20
    clipped = (first == 0) | (first == 255)
    assert clipped.mean() < 0.01


def test_same_frame_has_the_same_bits(first: np.ndarray) -> None:
    again = demo.render_frame(demo.FIRST)
    assert again is not first
    np.testing.assert_array_equal(again, first)


@pytest.mark.parametrize("frame", [demo.FIRST - 1, demo.LAST + 1])
def test_frame_outside_the_shot_is_refused_with_its_range(frame: int) -> None:
    for door in (demo.render_frame, demo.true_mask, demo.occlusion):
        with pytest.raises(ValueError, match="1001 to 1048"):
            door(frame)


def test_grain_differs_from_frame_to_frame(first: np.ndarray) -> None:
    """The fine residue of two frames is as uncorrelated as noise, and there is about as much of it."""
    a, b = (_fine(image) for image in (first, demo.render_frame(demo.FIRST + 1)))
    assert 1.0 < a.std() < 8.0
    assert b.std() == pytest.approx(a.std(), rel=0.15)
    assert abs(np.corrcoef(a.ravel(), b.ravel())[0, 1]) < 0.2


def test_grain_is_strongest_in_the_middle_tones() -> None:
    def spread(light: float) -> float:
        card = np.full((demo.SIZE[1], demo.SIZE[0], 3), light, dtype=np.float32)
        middle = film.develop(card, np.ones(3), 1001)[240:300, 440:520]
        assert 5 < middle.mean() < 250
        return float(middle.std())

    assert spread(0.12) > 1.3 * spread(0.003)
    assert spread(0.12) > 1.3 * spread(2.5)


def _fine(image: np.ndarray) -> np.ndarray:
    green = image[..., 1].astype(np.float32)
    return green - cv2.GaussianBlur(green, (0, 0), 0.8)


def test_light_changes_gradually(first: np.ndarray) -> None:
    last = demo.render_frame(demo.LAST)
    before, after = first.mean(axis=(0, 1)), last.mean(axis=(0, 1))
    assert after.sum() < 0.92 * before.sum()
    assert after[0] / after[2] < before[0] / before[2]  # warmer at the beginning


def test_mask_is_the_inside_of_the_curve() -> None:
    mask = demo.true_mask(1015)
    assert mask.shape == (540, 960)
    assert mask.dtype == np.uint8
    assert set(np.unique(mask)) == {0, 255}
    line = polyline(demo.true_points(1015))
    for row, column in ((250, 400), (330, 330), (300, 700), (100, 100)):
        distance = cv2.pointPolygonTest(line.astype(np.float32), (column + 0.5, row + 0.5), True)
        assert abs(distance) > 1.0
        assert (mask[row, column] == 255) == (distance > 0)
    normals = outward_normals(line)
    for offset, value in ((-1.0, 255), (1.0, 0)):
        column, row = np.floor(line + offset * normals).astype(int).T
        assert (mask[row, column] == value).mean() > 0.97


def test_edge_can_be_seen_along_most_of_the_outline_but_not_everywhere() -> None:
    """Colours just inside and just outside differ, with lookalikes on part of the edge."""
    for frame in (1001, 1016, 1036, 1048):
        contrast = _edge_contrast(frame)
        assert (contrast > 8.0).mean() > 0.85, frame
        assert (contrast < 18.0).mean() > 0.05, frame


def _edge_contrast(frame: int) -> np.ndarray:
    """Distance in 8-bit RGB between both sides of the outline, after a blur that takes most of the grain."""
    image = cv2.GaussianBlur(demo.render_frame(frame).astype(np.float32), (0, 0), 1.2)
    line = resample(polyline(demo.true_points(frame)), 240)
    normals = outward_normals(line)
    inside, outside = (
        sum(_sampled(image, line + sign * reach * normals) for reach in (3.0, 5.0)) / 2.0 for sign in (-1.0, 1.0)
    )
    return np.linalg.norm(inside - outside, axis=1)


def _sampled(image: np.ndarray, positions: np.ndarray) -> np.ndarray:
    at = (positions - 0.5).astype(np.float32)[None]
    return cv2.remap(image, at, None, cv2.INTER_LINEAR)[0]


def test_fish_pass_in_front_for_some_frames() -> None:
    covered = {frame: demo.occlusion(frame) for frame in FRAMES}
    window = [frame for frame, share in covered.items() if share > 0.01]
    assert 6 <= len(window) <= 8
    assert window == list(range(window[0], window[-1] + 1))
    assert 0.20 < max(covered.values()) < 0.34
    assert covered[demo.FIRST] == covered[demo.LAST] == 0.0
