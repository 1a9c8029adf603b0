"""Pictures for review: the outline lies where the shape does, the cut-out shows what is inside, text what is asked."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.geometry import bezier
from roam_core.review.lettering import ELLIPSIS, box_height, lines_in
from roam_core.review.look import Burn, Ground, ReviewLook, ReviewView
from roam_core.review.picture import (
    BLACK,
    CHECKERS,
    GREY,
    MISSING,
    _write_note,
    confidence_at,
    letters_for,
    review_picture,
)
from roam_core.roto import Keyframe, Project, timing
from tests.unit.review.conftest import FIRST, PLATE, body, project_of, read

PLAIN = ReviewLook(burns=frozenset())
PLAIN4 = ReviewLook(burns=frozenset(), scale=4.0)


def test_the_outline_lies_on_the_plate_in_the_colour_of_its_shape(project: Project) -> None:
    pixels = review_picture(read(FIRST), project, FIRST, PLAIN)
    assert pixels.shape == (90, 160, 3)
    differs = (pixels != PLATE).any(axis=2)
    rows, columns = np.nonzero(differs)
    assert (columns.min(), columns.max(), rows.min(), rows.max()) == pytest.approx((39, 80, 24, 65), abs=2)
    assert not differs[30:60, 45:75].any(), "nothing is drawn inside"
    left = pixels[45, 36:44].astype(int)
    assert (left[:, 0] - left[:, 2]).max() > 150, "red"
    assert left.sum(axis=1).min() < sum(PLATE) / 2, "with a dark rim"


def test_hidden_shapes_and_those_that_do_not_exist_are_not_drawn() -> None:
    for gone in (replace(body([0.0] * 10), visible=False), replace(body([0.0] * 10), lifetime=(FIRST + 5, FIRST + 6))):
        pixels = review_picture(read(FIRST), project_of(gone), FIRST, PLAIN)
        assert (pixels == PLATE).all()


@pytest.mark.parametrize("far", [1e5, 1e7, 1e9, 1e12])
def test_an_outline_that_reaches_far_out_of_the_picture_goes_there(far: float) -> None:
    """What a layer's perspective puts beyond its horizon lies so far away; integers of 32 bits turned it around."""
    corners = np.array([(60.0, 30.0), (far, 30.0), (far, 60.0), (60.0, 60.0)])
    shape = replace(body([0.0]), keys=(Keyframe(FIRST, bezier.polygon_points(corners)),))
    differs = (review_picture(read(FIRST), project_of(shape), FIRST, PLAIN) != PLATE).any(axis=2)
    assert differs[28:32, 62:].any(axis=0).all()
    assert differs[58:62, 62:].any(axis=0).all()
    assert not differs[:, :56].any()


@pytest.mark.parametrize(
    ("ground", "outside"),
    [(Ground.GREY, {GREY}), (Ground.BLACK, {BLACK}), (Ground.CHECKER, set(CHECKERS))],
)
def test_a_cut_out_shows_the_plate_inside_and_the_ground_outside(
    project: Project, ground: Ground, outside: set[int]
) -> None:
    look = replace(PLAIN, view=ReviewView.CUTOUT, ground=ground)
    pixels = review_picture(read(FIRST), project, FIRST, look)
    assert (pixels[30:60, 45:75] == PLATE).all()
    assert set(np.unique(pixels[:, :36]).tolist()) == outside


def test_floating_point_pictures_are_shown_like_those_of_bytes(project: Project) -> None:
    bright = (read(FIRST) / np.float32(255.0)).astype(np.float32)
    assert (review_picture(bright, project, FIRST, PLAIN) == review_picture(read(FIRST), project, FIRST, PLAIN)).all()


def test_a_frame_without_a_picture_says_so(project: Project) -> None:
    silent = review_picture(None, project, FIRST, PLAIN)
    assert (silent[0] == MISSING).all()
    assert (silent[-8:, :60] != MISSING).any(), "words at the bottom"


@pytest.mark.parametrize(
    ("burn", "frame", "rows", "columns"),
    [
        (Burn.FRAME, FIRST, slice(-14, None), slice(0, 40)),
        (Burn.NOTE, FIRST + 1, slice(0, 14), slice(0, 60)),
        (Burn.CONFIDENCE, FIRST + 1, slice(-14, None), slice(-40, None)),
    ],
)
def test_what_is_asked_for_is_written_in_its_corner_and_nothing_else(
    project: Project, burn: Burn, frame: int, rows: slice, columns: slice
) -> None:
    bare = review_picture(read(frame), project, frame, PLAIN)
    written = review_picture(read(frame), project, frame, replace(PLAIN, burns=frozenset({burn})))
    differs = (bare != written).any(axis=2)
    assert differs[rows, columns].any()
    differs[rows, columns] = False
    assert not differs[:, 45:75][20:70].any(), "the middle stays free"
    assert written[rows, columns].max() > 200, "bright letters"


def test_nothing_is_written_where_there_is_nothing_to_say(project: Project) -> None:
    look = replace(PLAIN, burns=frozenset({Burn.NOTE, Burn.CONFIDENCE}))
    assert (
        review_picture(read(FIRST), project, FIRST, look) == review_picture(read(FIRST), project, FIRST, PLAIN)
    ).all()


def test_confidence_is_that_of_the_whole_frame(project: Project) -> None:
    assert confidence_at(project, FIRST) is None
    assert confidence_at(project, FIRST + 1) == pytest.approx(0.9)


def test_sizes_are_even_and_pixels_square() -> None:
    assert ReviewLook(scale=0.5).size((961, 541)) == (480, 270)
    assert ReviewLook().size((720, 576), 1.0940) == (788, 576)
    assert ReviewLook(scale=0.05).size((4, 4)) == (2, 2)


def test_a_scaled_picture_has_its_outline_at_the_scaled_place(project: Project) -> None:
    pixels = review_picture(read(FIRST), project, FIRST, replace(PLAIN, scale=2.0))
    columns = np.nonzero((pixels != PLATE).any(axis=2))[1]
    assert (columns.min(), columns.max()) == pytest.approx((79, 160), abs=3)


def test_a_scale_beyond_reason_is_refused() -> None:
    with pytest.raises(RoamError, match=r"scaled by 0\.05 to 4, not by 9"):
        ReviewLook(scale=9.0)


def test_a_long_note_is_written_smaller_and_wider_above_the_frame_number() -> None:
    look = replace(PLAIN, burns=frozenset({Burn.NOTE}), scale=4.0)
    for words, rows in (("look here", 0.1), ("look here " * 60, 0.95)):
        project = timing.set_mark(project_of(body([0.0])), FIRST, words.strip())
        veiled = review_picture(read(FIRST), project, FIRST, look) != review_picture(
            read(FIRST), project, FIRST, PLAIN4
        )
        inside = np.flatnonzero(veiled.any(axis=(1, 2)))
        assert inside.min() == 0
        assert inside.max() < rows * 360
        assert not veiled[-box_height(1, letters_for(360)) :].any()


def test_of_a_note_that_never_fits_the_picture_there_is_an_ellipsis() -> None:
    written: list[list[str]] = []
    pixels = np.zeros((90, 160, 3), dtype=np.uint8)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("roam_core.review.picture.write_boxed", lambda _, lines, *rest: written.append(lines))
        _write_note(pixels, "look here " * 60, 11, "")
    assert 1 < len(written[0]) <= lines_in(90, 11) - 1
    assert written[0][-1].endswith(ELLIPSIS)
