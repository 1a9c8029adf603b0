"""Names of files: numbers of frames in patterns, words made of names."""

from __future__ import annotations

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from roam_core.interchange.naming import LONGEST, file_words, is_numbered, numbering


@pytest.mark.parametrize(
    ("pattern", "name"),
    [
        ("m.####.png", "m.0007.png"),
        ("m.#.png", "m.7.png"),
        ("m%06d.exr", "m000007.exr"),
        ("m.%d.exr", "m.7.exr"),
        ("m.png", "m.0007.png"),
        ("{name}.##.tif", "{name}.07.tif"),
    ],
)
def test_a_pattern_names_a_frame(pattern: str, name: str) -> None:
    assert numbering(pattern)(7) == name
    assert numbering(pattern, offset=-3)(10) == name
    assert is_numbered(pattern) is (pattern != "m.png")


def test_names_that_look_alike_stay_apart() -> None:
    assert file_words(["Arm", "arm", "A/m", "A m", "", "..", "CON", "Ärm"]) == [
        "Arm",
        "arm_2",
        "A_m",
        "A_m_2",
        "shape",
        "shape_2",
        "CON_",
        "rm",
    ]


@given(st.lists(st.text(max_size=120), max_size=8))
def test_any_names_become_plain_words_unlike_each_other(names: list[str]) -> None:
    words = file_words(names)
    assert len({word.lower() for word in words}) == len(names)
    assert all(re.fullmatch(rf"[A-Za-z0-9_-]{{1,{LONGEST + 6}}}", word) for word in words)
