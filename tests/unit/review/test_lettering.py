"""Text on pictures: it is as wide as it says, breaks where it must, and never writes outside."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from roam_core.arrays import UInt8
from roam_core.errors import RoamError
from roam_core.review import fonts
from roam_core.review.lettering import _letters, required_font, text_width, wrapped, write, write_boxed
from tests.unit.review.tiny_font import write_font


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


@pytest.fixture
def machine(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[list[str]]:
    """The fonts of a machine, none at first."""
    installed: list[str] = []
    monkeypatch.setattr(fonts, "machine_fonts", lambda: installed)
    forget()
    yield installed
    forget()


def forget() -> None:
    for kept in (fonts.runs, fonts.font_of, text_width, _letters):
        kept.cache_clear()


def test_a_character_that_no_font_has_is_a_question_mark(machine: list[str]) -> None:
    unknown, asked = black(), black()
    write(unknown, "a\u624b", (0, 0), 20)
    write(asked, "a?", (0, 0), 20)
    assert (unknown == asked).all()
    assert fonts.lacking("a\u624b\u304c\u624b b", "") == "\u624b\u304c"


def test_what_the_font_lacks_is_drawn_by_one_of_the_machine(machine: list[str], tmp_path: Path) -> None:
    machine += [str(write_font(tmp_path / f"{name}.ttf", has)) for name, has in (("kana", "\u304c"), ("han", "\u624b"))]
    text = "ac \u624b\u304c ca"
    assert [Path(run.font).stem for run in fonts.runs(text, "")] == ["", "han", "kana", ""]
    assert fonts.lacking(text, "") == ""
    pixels, plain = black(), black()
    write(pixels, text, (0, 0), 20)
    write(plain, "ac", (0, 0), 20)
    filled = np.flatnonzero((pixels[6:20] == 255).all(axis=(0, 2)))  # the columns of two filled squares
    assert text_width("ac", 20) < filled.min() <= filled.max() < text_width(text, 20)
    assert 28 <= len(filled) <= 34
    assert (pixels[:, : text_width("ac", 20)] == plain[:, : text_width("ac", 20)]).all()
    assert pixels[:, filled.max() + 3 :].any()
    assert np.flatnonzero(pixels.any(axis=(0, 2))).max() == pytest.approx(text_width(text, 20), abs=2)


def test_lines_without_spaces_break_where_the_box_ends(machine: list[str], tmp_path: Path) -> None:
    machine.append(str(write_font(tmp_path / "han.ttf", "\u624b\u90e8")))
    lines = wrapped("\u624b\u90e8" * 20, 90, 14)
    assert "".join(lines) == "\u624b\u90e8" * 20
    assert all(50 < text_width(line, 14) <= 90 for line in lines[:-1])


def test_a_font_that_draws_boxes_for_what_it_lacks_does_not_have_it(tmp_path: Path) -> None:
    font = str(write_font(tmp_path / "han.ttf", "\u624b"))
    assert [fonts.has(char, font) for char in "\u624ba\u90e8 "] == [True, False, False, False]


def test_a_font_that_is_not_there_is_told(machine: list[str]) -> None:
    assert required_font("") == ""
    with pytest.raises(RoamError, match="There is no font 'Nowhere Sans'"):
        required_font("Nowhere Sans")


def test_a_font_of_the_machine_is_found_by_its_name(machine: list[str], tmp_path: Path) -> None:
    """Debian's lie two folders deep, where OpenImageIO does not look: none of them could be named."""
    folder = tmp_path / "truetype" / "tiny"
    folder.mkdir(parents=True)
    names = ("TinySans-Bold.ttf", "TinySans-Regular.ttf", "TinySerif.ttf")
    bold, plain, serif = (str(write_font(folder / name, "0")) for name in names)
    machine += [plain, serif, bold]
    asked = ("Tiny Sans", "tinysans", "Tiny Sans Bold", "TinySans-Bold.ttf", "Tiny Serif", serif)
    assert [required_font(name) for name in asked] == [plain, plain, bold, bold, serif, serif]
    with pytest.raises(RoamError, match="There is no font 'Tiny'"):
        required_font("Tiny")
