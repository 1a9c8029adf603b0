"""Objects cut out of a box, or found under a click."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roam_core.arrays import Array, Bools, UInt8
from roam_core.cancel import Cancelled, CancelToken
from roam_core.errors import RoamError
from roam_core.kernels.coverage import coverage
from roam_core.proposal.assist import cut_out
from roam_core.proposal.assist.cut_out import Marks, cut_box, cut_click
from roam_core.roto import BlendMode, RotoShape

SIZE = (180, 240)


def background() -> Array:
    noise = np.random.default_rng(8).normal(0.0, 14.0, (*SIZE, 3))
    return 70.0 + cv2.GaussianBlur(noise, (0, 0), 1.0) + np.linspace(0.0, 25.0, SIZE[1])[None, :, None]


def bean(hole: bool = False) -> tuple[UInt8, Bools]:
    """A picture of an ellipse with a bite taken out, and the mask of it; with `hole` the background shows through."""
    y, x = np.mgrid[: SIZE[0], : SIZE[1]] + 0.5
    mask = ((x - 120.0) / 70.0) ** 2 + ((y - 90.0) / 45.0) ** 2 < 1.0
    mask &= np.hypot(x - 120.0, y - 30.0) > 30.0
    if hole:
        mask &= np.hypot(x - 150.0, y - 95.0) > 16.0
    picture = background()
    picture[mask] = (190.0, 140.0, 60.0) + picture[mask] * 0.2
    return np.clip(cv2.GaussianBlur(picture, (0, 0), 0.8), 0, 255).astype(np.uint8), mask


def covered(shapes: list[RotoShape]) -> Bools:
    inside = np.zeros(SIZE, dtype=bool)
    for shape in shapes:
        part = coverage(shape.at(7).flatten(), SIZE) > 0.5
        inside = inside & ~part if shape.blend is BlendMode.SUBTRACT else inside | part
    return inside


def overlap(shapes: list[RotoShape], mask: Bools) -> float:
    inside = covered(shapes)
    return float((inside & mask).sum() / (inside | mask).sum())


def test_a_box_gives_the_object_inside() -> None:
    picture, mask = bean()
    shapes = cut_box(picture, (46.0, 40.0), (194.0, 138.0), 7)
    assert [shape.frames for shape in shapes] == [(7,)]
    assert overlap(shapes, mask) > 0.975
    assert shapes[0].point_count < 25


def test_a_hole_is_a_subtracting_shape() -> None:
    picture, mask = bean(hole=True)
    shapes = cut_box(picture, (46.0, 40.0), (194.0, 138.0), 7)
    assert [shape.blend for shape in shapes] == [BlendMode.ADD, BlendMode.SUBTRACT]
    assert overlap(shapes, mask) > 0.96


def test_a_click_gives_the_object_around_it() -> None:
    picture, mask = bean()
    assert overlap(cut_click(picture, 7, Marks(((90.0, 100.0),))), mask) > 0.95


def test_an_object_that_outgrows_its_first_box_is_found_whole(monkeypatch: pytest.MonkeyPatch) -> None:
    """What the click grew is a small part of the object: its box does not hold all of it."""
    picture, mask = bean()
    small = np.zeros(SIZE, dtype=bool)
    small[85:115, 70:120] = True
    monkeypatch.setattr(cut_out, "grown", lambda *_: small.copy())
    assert overlap(cut_click(picture, 7, Marks(((90.0, 100.0),))), mask) > 0.95


def two_coloured() -> tuple[UInt8, Bools]:
    """The bean, its right half in another colour altogether."""
    picture, mask = bean()
    picture = picture.copy()
    right = mask & (np.arange(SIZE[1])[None] > 125)
    picture[right] = picture[right] // 4 + np.array((30, 60, 150), dtype=np.uint8)
    return picture, mask


def test_a_second_mark_brings_the_part_of_another_colour() -> None:
    picture, mask = two_coloured()
    left, right = (90.0, 100.0), (160.0, 100.0)
    assert overlap(cut_click(picture, 7, Marks((left,))), mask) < 0.7
    assert overlap(cut_click(picture, 7, Marks((left, right))), mask) > 0.95


def test_a_mark_beside_the_object_takes_a_part_away() -> None:
    picture, mask = two_coloured()
    left = mask & (np.arange(SIZE[1])[None] <= 125)
    box = (46.0, 40.0), (194.0, 138.0)
    assert overlap(cut_box(picture, *box, 7), mask) > 0.95
    marks = Marks(((90.0, 100.0),), tuple((x, y) for x in (135.0, 160.0, 180.0) for y in (75.0, 100.0, 120.0)))
    assert overlap(cut_box(picture, *box, 7, marks), left) > 0.9


def test_background_that_shows_through_a_later_mark_is_not_taken_for_the_object() -> None:
    """The second click is a slip onto the nearer half of the background, which runs out of the picture."""
    picture = np.full((*SIZE, 3), 60, dtype=np.uint8)
    picture[:, 90:] = 120
    picture[80:110, 30:60] = 200
    whole = cut_out._Piece.of(picture, np.zeros(2), np.array(SIZE[::-1], dtype=np.float64))
    region = cut_out._marked_region(whole, Marks(((45.0, 95.0), (20.0, 40.0))))
    assert region[40, 20]
    assert region.sum() < 1.3 * 30 * 30


def test_marks_on_two_objects_give_a_shape_for_each() -> None:
    picture = background()
    mask = np.zeros(SIZE, dtype=bool)
    mask[40:140, 30:90] = mask[40:140, 150:210] = True
    picture[mask] = (190.0, 140.0, 60.0)
    shapes = cut_click(picture.astype(np.uint8), 7, Marks(((60.0, 90.0), (180.0, 90.0))))
    assert len(shapes) == 2
    assert overlap(shapes, mask) > 0.95


def test_a_cut_that_collapses_is_taken_back(monkeypatch: pytest.MonkeyPatch) -> None:
    """Colours learned on mostly background may leave nothing of a thin object: the round before is kept then."""
    picture, mask = bean()
    rounds, real = [0], cv2.grabCut

    def collapsing(colours: object, labels: UInt8, *rest: object) -> None:
        real(colours, labels, *rest)  # type: ignore[call-overload]
        rounds[0] += 1
        if rounds[0] == 3:
            labels[:] = cv2.GC_PR_BGD

    monkeypatch.setattr(cv2, "grabCut", collapsing)
    assert overlap(cut_box(picture, (46.0, 40.0), (194.0, 138.0), 7), mask) > 0.95
    assert rounds == [3]


def test_the_same_box_gives_the_same_shape() -> None:
    picture, _ = bean()
    once, again = (cut_box(picture, (46.0, 40.0), (194.0, 138.0), 7)[0] for _ in range(2))
    assert once == again


def test_a_small_copy_of_a_large_picture_is_cut() -> None:
    picture, mask = bean()
    large = cv2.resize(picture, None, fx=8.0, fy=8.0, interpolation=cv2.INTER_CUBIC)
    (shape,) = cut_box(large, (368.0, 320.0), (1552.0, 1104.0), 7)
    small = [shape.map_points(lambda points: points / 8.0)]
    assert overlap(small, mask) > 0.975


@pytest.mark.parametrize(
    ("low", "high", "sentence"),
    [
        ((50.0, 50.0), (53.0, 90.0), "box is too small"),
        ((-90.0, -50.0), (-20.0, -10.0), "box is too small"),
        ((-5.0, -5.0), (245.0, 185.0), "leaves no background"),
    ],
)
def test_boxes_that_cannot_be_cut_are_refused(low: tuple[float, float], high: tuple[float, float], sentence: str):
    with pytest.raises(RoamError, match=sentence):
        cut_box(bean()[0], low, high, 7)


def test_a_click_beside_the_picture_is_refused() -> None:
    with pytest.raises(RoamError, match="inside of the picture"):
        cut_click(bean()[0], 7, Marks(((300.0, 20.0),)))


def test_a_click_on_endless_background_is_refused() -> None:
    with pytest.raises(RoamError, match="No object ends around that place"):
        cut_click(np.full((*SIZE, 3), 90, dtype=np.uint8), 7, Marks(((60.0, 60.0),)))


def test_it_stops_when_told_and_says_how_far_it_is() -> None:
    picture, _ = bean()
    told: list[float] = []
    cut_box(picture, (46.0, 40.0), (194.0, 138.0), 7, progress=lambda share, _text: told.append(share))
    assert told == sorted(told)
    assert told[-1] == 1.0
    token = CancelToken()
    token.cancel()
    with pytest.raises(Cancelled):
        cut_click(picture, 7, Marks(((90.0, 100.0),)), token)
