"""Frame numbers in file names, and the files that make up a sequence."""

from __future__ import annotations

from pathlib import Path

import pytest

from roam_core.errors import RoamError
from roam_core.media.numbering import (
    NamePattern,
    file_names,
    find_pattern,
    find_sequences,
    parse_pattern,
    split_number,
    varying_pattern,
)


@pytest.mark.parametrize(
    ("stem", "parts"),
    [
        ("shot_v002.1001", ("shot_v002.", "1001", "")),
        ("00000", ("", "00000", "")),
        ("frame_0012_left", ("frame_", "0012", "_left")),
        ("shot-01", ("shot-", "01", "")),
        ("plate.-0005", ("plate.", "-0005", "")),
        ("-5", ("", "-5", "")),
        ("reference", None),
        ("IMG_20231105123456", None),
        ("٣", None),
    ],
)
def test_the_last_digits_of_a_stem_are_its_number(stem: str, parts: tuple[str, str, str] | None) -> None:
    assert split_number(stem) == parts


@pytest.mark.parametrize(
    ("name", "pattern"),
    [
        ("plate.%04d.exr", NamePattern("plate.", 4, ".exr")),
        ("plate.####.exr", NamePattern("plate.", 4, ".exr")),
        ("plate.$F4.exr", NamePattern("plate.", 4, ".exr")),
        ("plate.$F.exr", NamePattern("plate.", 0, ".exr")),
        ("plate.${F4}.exr", NamePattern("plate.", 4, ".exr")),
        ("plate.[1001-1100].exr", NamePattern("plate.", 4, ".exr")),
        ("plate.*.exr", NamePattern("plate.", 0, ".exr")),
        ("a[1-2].%04d.exr", NamePattern("a[1-2].", 4, ".exr")),
        ("$FILM.exr", None),
        ("plate.%d.exr", NamePattern("plate.", 0, ".exr")),
        ("plate.#.exr", NamePattern("plate.", 0, ".exr")),
        ("plate.@@@@.exr", NamePattern("plate.", 4, ".exr")),
        ("plate.@.exr", NamePattern("plate.", 0, ".exr")),
        ("take#3_##.png", NamePattern("take#3_", 2, ".png")),
        ("50%_%04d.png", NamePattern("50%_", 4, ".png")),
        ("a%04d_b#.png", NamePattern("a", 4, "_b#.png")),
        ("plate.1001.exr", None),
    ],
)
def test_patterns(name: str, pattern: NamePattern | None) -> None:
    assert parse_pattern(name) == pattern


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("0007", 7),
        ("10000", 10000),
        ("007", None),
        ("7", None),
        ("-0007", -7),
        ("-007", -7),
        ("00007", None),
        ("", None),
    ],
)
def test_a_width_is_the_least_number_of_digits(text: str, number: int | None) -> None:
    assert NamePattern("a.", 4, ".png").number_of(f"a.{text}.png") == number


@pytest.mark.parametrize("frame", [-12, 0, 7, 1001, 123456])
@pytest.mark.parametrize("width", [0, 1, 4])
def test_a_name_gives_its_number_back(frame: int, width: int) -> None:
    pattern = NamePattern("a.", width, "_l.png")
    assert pattern.number_of(pattern.name(frame)) == frame


def test_prefix_and_suffix_do_not_share_letters() -> None:
    assert NamePattern("ab", 0, "b1").number_of("ab1") is None


def test_sequences_of_a_folder_longest_first(tmp_path: Path) -> None:
    for name in ("a.0001.png", "a.0002.png", "b.5.png", "b.10.png", "b.100.png", "still.png", ".a.0003.png", "a.txt"):
        (tmp_path / name).touch()
    (tmp_path / "a.0004.png").mkdir()
    found = find_sequences(tmp_path, {".png"})
    assert [sequence.path.name for sequence in found] == ["b.%d.png", "a.%04d.png", "still.png"]
    assert [dict(sequence.names) for sequence in found] == [
        {5: "b.5.png", 10: "b.10.png", 100: "b.100.png"},
        {1: "a.0001.png", 2: "a.0002.png"},
        {1: "still.png"},
    ]
    assert found[1].label == "a.%04d.png (2 frames, 1 to 2)"
    assert found[2].label == "still.png (one image)"


def test_numbers_that_grow_past_their_padding_stay_one_sequence(tmp_path: Path) -> None:
    for name in ("a.-02.png", "a.98.png", "a.99.png", "a.100.png"):
        (tmp_path / name).touch()
    (sequence,) = find_sequences(tmp_path, {".png"})
    assert sorted(sequence.names) == [-2, 98, 99, 100]
    assert sequence.path.name == "a.%02d.png"


def test_the_pattern_of_a_sequence_finds_it_again(tmp_path: Path) -> None:
    for name in ("a#1.-3.png", "a#1.2.png", "a#1.010.png"):
        (tmp_path / name).touch()
    (sequence,) = find_sequences(tmp_path, {".png"})
    pattern = parse_pattern(sequence.path.name)
    assert pattern is not None
    assert find_pattern(tmp_path, pattern) == sequence


def test_two_files_with_one_number_are_refused_until_the_width_tells_them_apart(tmp_path: Path) -> None:
    for name in ("a.1.png", "a.01.png"):
        (tmp_path / name).touch()
    (sequence,) = find_sequences(tmp_path, {".png"})
    assert sequence.holds("a.1.png")
    assert sequence.holds("a.01.png")
    with pytest.raises(RoamError, match=r"a\.01\.png and a\.1\.png in .* same frame number"):
        sequence.checked()
    two_digits = find_pattern(tmp_path, NamePattern("a.", 2, ".png"))
    assert two_digits is not None
    assert two_digits.checked().names == {1: "a.01.png"}


def test_extensions_in_other_letters_are_one_sequence(tmp_path: Path) -> None:
    for name in ("a.1.png", "a.2.PNG", "a.3.png", "a.4.Png"):
        (tmp_path / name).touch()
    (sequence,) = find_sequences(tmp_path, {".png"})
    assert sequence.names == {1: "a.1.png", 2: "a.2.PNG", 3: "a.3.png", 4: "a.4.Png"}
    assert sequence.pattern is not None
    assert find_pattern(tmp_path, sequence.pattern) == sequence
    (tmp_path / "a.2.png").touch()
    assert [other.path.name for other in find_sequences(tmp_path, {".png"})] == ["a.%d.png", "a.%d.PNG", "a.%d.Png"]
    beside = find_pattern(tmp_path, NamePattern("a.", 0, ".png"))
    assert beside is not None
    assert beside.checked().names[2] == "a.2.png"


@pytest.mark.parametrize(
    ("names", "pattern"),
    [
        (("shot_0001_v002.png", "shot_0002_v002.png", "shot_0003_v002.png"), "shot_%04d_v002.png"),
        (("a1_9.png", "a1_10.png", "b2_10.png"), "a1_%d.png"),
        (("a.1.png", "b.1.png", "IMG_20231105123456.png"), "None"),
        ((), "None"),
    ],
)
def test_the_pattern_of_what_varies(names: tuple[str, ...], pattern: str) -> None:
    assert str(varying_pattern(names)) == pattern


def test_numbers_far_apart_are_no_frames(tmp_path: Path) -> None:
    for name in ("a.1.png", "a.999999999.png"):
        (tmp_path / name).touch()
    (sequence,) = find_sequences(tmp_path, {".png"})
    with pytest.raises(RoamError, match="from 1 to 999999999"):
        sequence.checked()


def test_a_folder_that_is_not_there_or_no_folder_is_told(tmp_path: Path) -> None:
    with pytest.raises(RoamError, match="nowhere does not exist"):
        file_names(tmp_path / "nowhere")
    (tmp_path / "file").touch()
    with pytest.raises(RoamError, match="cannot be read"):
        file_names(tmp_path / "file")
