"""Names of files: numbers of frames in patterns, words made of names."""

from __future__ import annotations

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from roam_core.interchange.naming import LONGEST, ascii_name, distinct, file_words, is_numbered, numbering
from roam_core.media.numbering import parse_pattern


@pytest.mark.parametrize(
    ("pattern", "name"),
    [
        ("m.####.png", "m.0007.png"),
        ("m.#.png", "m.7.png"),
        ("m%06d.exr", "m000007.exr"),
        ("m.%d.exr", "m.7.exr"),
        ("m.png", "m.0007.png"),
        ("{name}.##.tif", "{name}.07.tif"),
        ("m.@@@@.png", "m.0007.png"),
        ("m@@.png", "m07.png"),
        ("m.$F4.png", "m.0007.png"),
        ("m.$F.png", "m.7.png"),
        ("m_${F3}.png", "m_007.png"),
        ("m.%4d.png", "m.0007.png"),
        ("m@2x.####.png", "m@2x.0007.png"),
    ],
)
def test_a_pattern_names_a_frame(pattern: str, name: str) -> None:
    assert numbering(pattern)(7) == name
    assert numbering(pattern, offset=-3)(10) == name
    assert is_numbered(pattern) is (pattern != "m.png")


@pytest.mark.parametrize(
    "pattern",
    ["x#1.####.png", "x#1.%04d.png", "v##_m.%d.png", "@@.####.png", "a@@_b.@@@@.png", "@@@.%03d.exr", "a%d.####.png"],
)
@pytest.mark.parametrize("frame", [7, 12345])
def test_what_is_written_by_a_pattern_is_read_by_it(pattern: str, frame: int) -> None:
    """The first of several marks was the number, and a plate or a clip was opened by the last of them."""
    read = parse_pattern(pattern)
    assert read is not None
    assert numbering(pattern)(frame) == read.name(frame)


def test_names_that_look_alike_stay_apart() -> None:
    assert file_words(["Arm", "arm", "A/m", "A m", "", "..", "CON", "Ärm", "手", "足"]) == [
        "Arm",
        "arm_2",
        "A_m",
        "A_m_2",
        "shape",
        "shape_2",
        "CON_",
        "Arm_3",
        "u624B",
        "u8DB3",
    ]


def test_no_layer_is_called_as_the_pictures_own_channels() -> None:
    assert file_words(["rgba", "RGB", "alpha", "alpha_"]) == ["rgba_", "RGB_", "alpha_", "alpha__2"]


@pytest.mark.parametrize(
    ("name", "plain"),
    [
        ("Arm 1 {left}", "Arm 1 {left}"),
        ("Ärmel é", "Armel e"),
        ("e\N{COMBINING ACUTE ACCENT}", "e"),
        ("Straße ẞ Øre łódź Æther", "Strasse Ss Ore lodz Aether"),
        ("Рука Щука объём", "Ruka Shchuka obem"),
        ("Χέρι Ψυχή", "Cheri Psychi"),
        ("さくら カメラ 한글", "sakura kamera hangeul"),
        ("ｆｕｌｌ ﬁn ① ٣", "full fin 1 3"),
        ("a\tb\u00a0c\u2003d\x07e", "a b c de"),
        ("“left” – ‘arm’…", "\"left\" - 'arm'..."),
        ("手 1", "u624B 1"),
        ("hair \N{HAIRCUT} \N{GRINNING FACE}", "hair haircut grinning-face"),
        ("שלום \N{ALEF SYMBOL}", "shinlamedvavmem alef"),
        ("half \ud83d", "half _"),
        ("ь", "u044C"),
        ("", ""),
    ],
)
def test_a_name_is_written_in_ascii_that_reads_like_it(name: str, plain: str) -> None:
    assert ascii_name(name) == plain


@given(st.text(st.characters(exclude_categories=()), max_size=20))
def test_any_name_in_ascii_is_printable_and_not_empty(name: str) -> None:
    plain = ascii_name(name)
    assert plain.isascii()
    assert plain.isprintable()
    assert bool(plain.strip()) >= bool(name.strip())
    assert ascii_name(plain) == plain


def test_names_that_are_taken_get_a_number() -> None:
    assert [distinct("a", taken) for taken in ([], ["a"], ["a", "a 2"])] == ["a", "a 2", "a 3"]


@given(st.lists(st.text(max_size=120), max_size=8))
def test_any_names_become_plain_words_unlike_each_other(names: list[str]) -> None:
    words = file_words(names)
    assert len({word.lower() for word in words}) == len(names)
    assert all(re.fullmatch(rf"[A-Za-z0-9_-]{{1,{LONGEST + 6}}}", word) for word in words)
