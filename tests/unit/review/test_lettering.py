"""Text on pictures: it is as wide as it says, breaks where it must, and never writes outside."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.arrays import UInt8
from roam_core.errors import RoamError
from roam_core.review.lettering import require_font, text_width, wrapped, write, write_boxed


def black(width: int = 200, height: int = 40) -> UInt8:
    return np.zeros((height, width, 3), dtype=np.uint8)


def test_letters_stand_where_they_are_put_and_are_as_wide_as_they_say() -> None:
    pixels = black()
    write(pixels, "1017", (20, 5), 20)
    rows, columns = np.nonzero(pixels.any(axis=2))
    assert columns.min() >= 20
    assert columns.max() == pytest.approx(20 + text_width("1017", 20), abs=2)
    assert rows.min() >= 5
    assert rows.max() <= 5 + 26


def test_other_texts_are_other_pixels_and_the_colour_is_that_which_is_asked_for() -> None:
    one, other = black(), black()
    write(one, "1017", (0, 0), 20, (255, 0, 0))
    write(other, "1018", (0, 0), 20, (255, 0, 0))
    assert (one != other).any()
    assert one[..., 0].max() == 255
    assert not one[..., 1:].any()


@pytest.mark.parametrize("at", [(-10, 0), (190, 10), (0, -12), (0, 30), (500, 500), (-500, 0)])
def test_what_lies_outside_is_lost(at: tuple[int, int]) -> None:
    pixels = black()
    write(pixels, "elbow", at, 20)
    assert pixels.shape == (40, 200, 3)


def test_lines_break_at_spaces_and_inside_words_that_are_too_long() -> None:
    text = "the elbow slips\nDonaudampfschifffahrtsgesellschaft"
    lines = wrapped(text, 90, 14)
    assert lines[:2] == ["the elbow", "slips"]
    assert "".join(lines[2:]) == "Donaudampfschifffahrtsgesellschaft"
    assert all(text_width(line, 14) <= 90 for line in lines)


def test_of_a_long_note_the_first_lines_are_left_and_that_there_is_more() -> None:
    lines = wrapped("look " * 50, 100, 14, most=2)
    assert len(lines) == 2
    assert lines[1].endswith("...")
    assert text_width(lines[1], 14) <= 100


def test_a_box_darkens_what_lies_behind_its_letters_and_keeps_to_its_corner() -> None:
    pixels = np.full((60, 200, 3), 200, dtype=np.uint8)
    write_boxed(pixels, ["12"], ("right", "bottom"), 14)
    assert (pixels[:30] == 200).all()
    assert (pixels[:, :100] == 200).all()
    assert (pixels[-3, -3] < 100).all()
    assert pixels[40:, 160:].max() > 230


def test_a_character_that_the_font_lacks_is_a_question_mark() -> None:
    unknown, asked = black(), black()
    write(unknown, "a\U0001f600", (0, 0), 20)
    write(asked, "a?", (0, 0), 20)
    assert (unknown == asked).all()


def test_a_font_that_is_not_there_is_told() -> None:
    require_font("")
    with pytest.raises(RoamError, match="There is no font 'Nowhere Sans'"):
        require_font("Nowhere Sans")
