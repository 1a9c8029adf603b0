"""Values inside of programs: any text is one literal, and reads back as itself."""

from __future__ import annotations

import ast
import json

import lupa
from hypothesis import given
from hypothesis import strategies as st

from roam_core.interchange.literals import (
    Literal,
    javascript_literal,
    javascript_pieces,
    lua_literal,
    python_literal,
    whole,
)

texts = st.text() | st.text("{}[]\"'`\\\n\r\0</>$%#\u2028\ud800", max_size=20)


@given(st.recursive(texts | st.integers(-9, 9) | st.booleans(), lambda inner: st.lists(inner, max_size=3)))
def test_values_are_ascii_on_one_line_and_come_back(value: object) -> None:
    for text in (javascript_literal(value), python_literal(value)):
        assert text.isascii()
        assert text.isprintable()
    assert json.loads(javascript_literal(value)) == value
    tree = ast.parse(python_literal(value), mode="eval")
    assert isinstance(tree.body, ast.Constant)
    assert json.loads(tree.body.value) == value


@given(
    st.recursive(
        texts | st.integers(-9, 9) | st.booleans() | st.none(),
        lambda inner: st.lists(inner, max_size=3) | st.dictionaries(texts, inner, max_size=3),
    )
)
def test_pieces_are_the_literal_whatever_of_it_is_text_already(value: object) -> None:
    assert "".join(javascript_pieces(value)) == javascript_literal(value)
    held = {"a": [Literal(javascript_literal(value)), 1], "b": Literal(javascript_literal(value))}
    assert "".join(javascript_pieces(held)) == javascript_literal({"a": [value, 1], "b": value})


@given(texts)
def test_texts_come_back_from_lua(text: str) -> None:
    literal = lua_literal(text)
    assert len(literal.split("\n")) == 1
    assert lupa.LuaRuntime(register_eval=False).eval(literal) == whole(text)


def test_whole_texts_stay_and_halves_are_replaced() -> None:
    assert whole("\U0001f44b ä") == "\U0001f44b ä"
    assert whole("a\ud83d") == "a\ufffd"
