"""Names in ASCII."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from roam_core.interchange.transliteration import distinct, transliterated


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("Shape 1", "Shape 1"),
        ("Größe Æon Øre Łódź", "Grosse Aeon Ore Lodz"),
        ("ручка Щука Ъ", "ruchka Shchuka "),
        ("Ελλάδα", "Ellada"),
        ("髪", "u9AEA"),
        ("가나 カナ", "gana kana"),
        ("hair \N{HAIRCUT}", "hair haircut"),
        ("½ ﬁ ①", "1/2 fi 1"),
        ("\u201cx\u201d \u2013 y\u2026", '"x" - y...'),
        ("line\nbreak\ttab\0", "line break tab "),
        ("half \ud83d", "half _"),
    ],
)
def test_names_can_still_be_read(text: str, plain: str) -> None:
    assert transliterated(text) == plain


@given(st.text(st.characters(exclude_categories=())))
def test_any_text_becomes_printable_ascii(text: str) -> None:
    plain = transliterated(text)
    assert plain.isascii()
    assert plain.isprintable()
    if text.isascii() and text.isprintable() and "  " not in text:
        assert plain == text


def test_names_that_are_taken_get_a_number() -> None:
    assert [distinct("a", taken) for taken in ([], ["a"], ["a", "a 2"])] == ["a", "a 2", "a 3"]
