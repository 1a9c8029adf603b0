"""The walker: ten parts in the picture, stacked as they are told to be, and the picture where the truth says it is."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from resources import walker
from resources.walker import FIRST, LAST, ORDER, Walker
from roam_core.geometry.polyline import is_simple

SEEDS = (0, 1, 2, 3)
SMALL = (480, 270)


@pytest.fixture(scope="module")
def small() -> Walker:
    return Walker(1, SMALL)


def test_there_are_ten_parts_the_near_arm_on_top() -> None:
    assert len(set(ORDER)) == 10
    assert ORDER[-1] == "near upper arm"
    for kind in ("upper arm", "lower arm", "upper leg", "lower leg"):
        assert ORDER.index(f"far {kind}") < ORDER.index("torso")
        assert ORDER.index(f"far {kind}") < ORDER.index(f"near {kind}")


@pytest.mark.parametrize("seed", SEEDS)
def test_outlines_are_simple_and_in_the_picture(seed: int) -> None:
    walk = Walker(seed)
    for frame in range(FIRST, LAST + 1):
        for part in ORDER:
            line = walk.line(part, frame)
            assert line.min() > 5.0, (part, frame)
            assert (line < np.array(walk.size) - 5.0).all(), (part, frame)
    assert all(is_simple(walk.line(part, FIRST)) for part in ORDER)


@pytest.mark.parametrize("seed", SEEDS)
def test_every_part_can_be_drawn_on_the_first_frame(seed: int) -> None:
    walk = Walker(seed)
    assert all(walk.seen(part, FIRST).sum() > 0.5 * walk.mask(part, FIRST).sum() for part in ORDER)


def test_what_is_seen_makes_up_the_figure_once(small: Walker) -> None:
    count = np.sum([small.seen(part, 1015) for part in ORDER], axis=0)
    np.testing.assert_array_equal(count == 1, small.figure(1015))
    assert count.max() == 1


def test_outlines_move_by_the_affine_motion(small: Walker) -> None:
    """And so do their points: the truth of a slide."""
    for part in ORDER:
        before, after = (np.vstack([small.affine(part, frame), [0, 0, 1]]) for frame in (FIRST, 1020))
        motion = after @ np.linalg.inv(before)
        carried = small.points(part, FIRST) @ motion[:2, :2].T + motion[:2, 2]
        np.testing.assert_allclose(carried, small.points(part, 1020), atol=1e-8)


def test_limbs_hang_together(small: Walker) -> None:
    for frame in range(FIRST, LAST + 1, 5):
        for lower, upper in (
            ("near lower arm", "near upper arm"),
            ("far lower leg", "far upper leg"),
            ("head", "torso"),
        ):
            joint = small.affine(lower, frame)[:, 2]
            inside = cv2.pointPolygonTest(small.line(upper, frame).astype(np.float32), joint.tolist(), True)
            assert inside > 0.0, (lower, frame)


def test_the_same_seed_gives_the_same_bits_and_another_one_does_not(small: Walker) -> None:
    picture = small.render(1007)
    assert picture.shape == (SMALL[1], SMALL[0], 3)
    assert picture.dtype == np.uint8
    np.testing.assert_array_equal(Walker(1, SMALL).render(1007), picture)
    assert (Walker(2, SMALL).render(1007) != picture).mean() > 0.5


def test_the_picture_lies_where_the_truth_says(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without shutter and grain, what a part covers changes when it is left out, and nothing else does."""
    monkeypatch.setattr(walker.shot, "SHUTTER", 0.0)
    monkeypatch.setattr(walker.shot, "GRAIN", 0.0)
    walk = Walker(3, SMALL)
    whole = walk.render(1010).astype(int)
    part, rest = "near lower arm", [part for part in ORDER if part != "near lower arm"]
    monkeypatch.setattr(walker.shot, "ORDER", rest)
    changed = np.abs(walk.render(1010).astype(int) - whole).max(axis=2) > 24
    monkeypatch.setattr(walker.shot, "ORDER", ORDER)
    seen = walk.seen(part, 1010)
    kernel = np.ones((3, 3), np.uint8)
    near = cv2.dilate(seen.astype(np.uint8), kernel) > 0
    core = cv2.erode(seen.astype(np.uint8), kernel) > 0
    assert not (changed & ~near).any()
    assert (changed & core).sum() > 0.6 * core.sum()


@pytest.mark.parametrize("frame", [FIRST - 1, LAST + 1])
def test_a_frame_outside_the_walk_is_refused(small: Walker, frame: int) -> None:
    with pytest.raises(ValueError, match="1001 to 1036"):
        small.render(frame)


def test_frames_are_written_under_their_numbers(small: Walker, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(walker.shot, "LAST", FIRST + 1)
    walker.write_frames(tmp_path / "walker", small)
    names = sorted(path.name for path in (tmp_path / "walker").iterdir())
    assert names == ["walker.1001.png", "walker.1002.png"]
    image = cv2.imread(str(tmp_path / "walker" / names[1]))
    np.testing.assert_array_equal(image[..., ::-1], small.render(1002))
