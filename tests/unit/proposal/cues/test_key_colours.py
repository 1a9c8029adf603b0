"""What both keys' colours say about a frame: the key that knows a place is heard, the one that hides it is not."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roam_core.arrays import Bools, Float32, UInt8
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.params import KeyColoursParams
from roam_core.proposal.cues.key_colours import key_colours
from roam_core.proposal.cues.key_view import KeyView

SIZE = (90, 140)
GRID = Grid.over(Region(0, 0, SIZE[1], SIZE[0]), 0.5)
CARD = slice(20, 70), slice(30, 100)
POST = slice(0, 90), slice(60, 76)
ALL = np.ones(GRID.shape, dtype=bool)


def noise(seed: int, colour: tuple[int, int, int]) -> UInt8:
    rough = cv2.GaussianBlur(np.random.default_rng(seed).normal(0.0, 40.0, (*SIZE, 3)), (0, 0), 2.0)
    return np.clip(np.asarray(colour) + rough, 0, 255).astype(np.uint8)


def picture(post: bool, shift: int = 0) -> PreparedFrame:
    image = noise(1, (70, 120, 60))
    image[CARD] = noise(2, (200, 120, 40))[CARD]
    if post:
        image[POST] = noise(3, (60, 60, 150))[POST]
    return PreparedFrame(np.roll(image, shift, axis=1))


def said_of(frame: PreparedFrame, keys: list[tuple[KeyView, float]], wanted: Bools = ALL) -> Float32:
    return key_colours(GRID.of(frame.image), keys, wanted, KeyColoursParams())


def view(post: bool, shift: int = 0) -> KeyView:
    inside = np.zeros(SIZE, dtype=np.float32)
    inside[CARD] = 1.0
    if post:
        inside[POST] = 0.0
    carried = np.eye(3)
    carried[0, 2] = shift
    coverage = np.roll(GRID.of(inside), shift // 2, axis=1)
    return KeyView(picture(post), carried, GRID, coverage)


def cells(rows: slice, columns: slice) -> tuple[slice, slice]:
    return slice(rows.start // 2 + 2, rows.stop // 2 - 2), slice(columns.start // 2 + 2, columns.stop // 2 - 2)


BEHIND = cells(CARD[0], POST[1])


@pytest.mark.parametrize("views", [(False, True), (True, False)])
def test_what_one_key_hides_is_told_by_the_other(views: tuple[bool, bool]) -> None:
    keys = [(view(post), 0.5) for post in views]
    assert np.median(said_of(picture(post=False), keys)[BEHIND]) == KeyColoursParams().clip
    assert np.median(said_of(picture(post=True), keys)[BEHIND]) == -KeyColoursParams().clip


def test_of_what_no_key_has_anything_like_nothing_is_said() -> None:
    strange = picture(post=False).image.copy()
    strange[POST] = (255, 255, 255)
    said = said_of(PreparedFrame(strange), [(view(True), 0.5), (view(False), 0.5)])
    assert not said[BEHIND].any()


def test_a_key_is_seen_where_its_object_came_to() -> None:
    moved = view(False, shift=12)
    said = said_of(picture(post=False, shift=12), [(moved, 0.5)])
    inside = np.roll(view(False).coverage, 6, axis=1) > 0.5
    assert np.mean(said[:, 8:][inside[:, 8:]] > 0) > 0.95
    assert np.mean(said[:, 8:][~inside[:, 8:]] < 0) > 0.95


def test_only_wanted_cells_are_rated() -> None:
    wanted = np.zeros(GRID.shape, dtype=bool)
    wanted[10:20, 10:20] = True
    said = said_of(picture(post=False), [(view(False), 0.5)], wanted)
    assert not said[~wanted].any()
    assert said[wanted].any()


def test_the_nearer_key_counts_more() -> None:
    # Alike on both keys but for the label: the cell goes with the key that is nearer.
    card = view(False)
    empty = KeyView(card.picture, card.carried, GRID, np.zeros_like(card.coverage))
    frame = PreparedFrame(cv2.convertScaleAbs(picture(post=False).image, alpha=1.0, beta=3))
    middle = cells(*CARD)
    assert np.median(said_of(frame, [(card, 0.1), (empty, 0.9)])[middle]) > 0
    assert np.median(said_of(frame, [(card, 0.9), (empty, 0.1)])[middle]) < 0
