"""Values as text inside of programs that other programs run: names stay data, whatever they hold."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from typing import Any


def javascript_literal(value: Any) -> str:
    """A plain value (strings, numbers, lists, mappings) as ASCII that JavaScript of any age reads as the same value."""
    return json.dumps(value, ensure_ascii=True, allow_nan=False, separators=(",", ":"))


class Literal(str):
    """Text that is a JavaScript literal already."""

    __slots__ = ()


def javascript_pieces(value: Any) -> Iterator[str]:
    """The text of `javascript_literal` piece by piece; what is a `Literal` anywhere inside stands as it is."""
    if isinstance(value, Literal):
        yield value
    elif isinstance(value, dict):
        yield "{"
        for number, (name, held) in enumerate(value.items()):
            yield f"{',' if number else ''}{javascript_literal(name)}:"
            yield from javascript_pieces(held)
        yield "}"
    elif isinstance(value, list):
        yield "["
        for number, held in enumerate(value):
            if number:
                yield ","
            yield from javascript_pieces(held)
        yield "]"
    else:
        yield javascript_literal(value)


def python_literal(value: Any) -> str:
    """A plain value as one line of ASCII: a Python string from which `json.loads` makes the same value."""
    return repr(javascript_literal(value))


def lua_literal(text: str) -> str:
    """`text` as a Lua string on one line."""
    return '"' + re.sub(r'[\x00-\x1f\x7f"\\]', lambda found: f"\\{ord(found.group()):03d}", whole(text)) + '"'


def whole(text: str) -> str:
    """`text` with every lone surrogate, which UTF-8 cannot hold, replaced by U+FFFD."""
    return text.encode("utf-16-le", "surrogatepass").decode("utf-16-le", "replace")
