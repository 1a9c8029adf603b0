"""The tables of Fusion's settings, taken apart: a small part of Lua's syntax, of which nothing runs."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

from roam_core.errors import RoamError
from roam_core.interchange.reading import MAX_NUMBER, ShapeReader, brief
from roam_core.translatable import sentence

VALUE, TABLE, POINT = 2, 5, 3
"""What a value, a table and a point, which is taken in one go, count of the parts that a file may hold: about as their
times."""

POINT_TEXT = re.compile(r"\{ ?(?:[A-Z]{1,2} = -?[0-9][0-9.]{0,30}(?:[eE][-+]?[0-9]{1,3})?(?:, |,| )?){2,7}\}")
"""A point as Fusion and ROAM write it; others are read as any table."""
PART = re.compile(r"([A-Z]{1,2}) = ([-0-9.eE+]+)")

TOKEN = re.compile(
    r"""(?P<number>-?(?:0[xX][0-9a-fA-F]{1,12}|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?))"""
    r"""|(?P<name>[A-Za-z_]\w*)"""
    r"""|(?P<string>"(?:[^"\\\n]|\\(?s:.))*"|'(?:[^'\\\n]|\\(?s:.))*')"""
    r"""|(?P<mark>[{}\[\]=,;()])"""
)
SPACE = re.compile(r"\s+")
ESCAPE = re.compile(r"\\(\d{1,3}|x[0-9a-fA-F]{2}|(?s:.))")
ESCAPES = {"n": "\n", "r": "\r", "t": "\t", "a": "\a", "b": "\b", "f": "\f", "v": "\v"}
WORDS: dict[str, Any] = {"true": True, "false": False, "nil": None}


@dataclass
class Table:
    """A table of a setting: what made it (`Input`, `PolylineMask`; nothing of a plain one), and its fields in order."""

    kind: str = ""
    named: dict[str | float, Any] = field(default_factory=dict)
    listed: list[Any] = field(default_factory=list)

    def table(self, name: str) -> Table:
        """The table of that name, or an empty one."""
        value = self.named.get(name)
        return value if isinstance(value, Table) else Table()

    def number(self, name: str, standard: float) -> float:
        """The number of that name, or `standard`; a `ValueError` for what is none."""
        value = self.named.get(name, standard)
        if isinstance(value, bool) or not isinstance(value, float | int):
            raise ValueError(sentence("its {name} is no number", name=name))
        return float(value)


def parsed(reader: ShapeReader, text: str) -> Table:
    """The table that a setting is; a `RoamError` for what is none, or goes beyond what a file may hold."""
    return _Parser(reader, text).whole()


@dataclass
class _Parser:
    reader: ShapeReader
    text: str

    def __post_init__(self) -> None:
        self.tokens = self._tokens()
        self.kind, self.word = next(self.tokens)

    def whole(self) -> Table:
        if self.kind == "name" and self.word == "return":
            self._advance()
        value = self._value(0)
        if not isinstance(value, Table) or self.kind:
            raise self._trouble()
        return value

    def _tokens(self) -> Iterator[tuple[str, str]]:
        text, place = self.text, 0
        while place < len(text):
            if found := SPACE.match(text, place):
                place = found.end()
            elif text.startswith("--[[", place) or text.startswith("[[", place):
                stop = text.find("]]", place)
                if stop < 0:
                    raise self._trouble()
                if text[place] == "[":
                    yield "long", text[place + 2 : stop]
                place = stop + 2
            elif text.startswith("--", place):
                stop = text.find("\n", place)
                place = len(text) if stop < 0 else stop
            elif text[place] == "{" and (found := POINT_TEXT.match(text, place)):
                place = found.end()
                yield "point", found.group()
            elif found := TOKEN.match(text, place):
                place = found.end()
                yield found.lastgroup or "", found.group()
            else:
                raise self._trouble()
        yield "", ""

    def _advance(self) -> str:
        word = self.word
        self.kind, self.word = next(self.tokens)
        return word

    def _expect(self, mark: str) -> None:
        if self.kind != "mark" or self.word != mark:
            raise self._trouble()
        self._advance()

    def _value(self, depth: int) -> Any:
        self.reader.check_parts(VALUE)
        match self.kind:
            case "number":
                return self._number(self._advance())
            case "point":
                return self._point(self._advance())
            case "string":
                return _unquoted(self._advance()[1:-1])
            case "long":
                return self._advance()
            case "name":
                return self._made(depth)
        return self._table("", depth)

    def _made(self, depth: int) -> Any:
        name = self._advance()
        if name in WORDS:
            return WORDS[name]
        if self.word == "(":
            self._advance()
            self._expect(")")
        return self._table(name, depth)

    def _table(self, kind: str, depth: int) -> Table:
        self.reader.check_depth(depth)
        if self.kind == "point":
            point = self._point(self._advance())
            return Table(kind, point.named)
        self.reader.check_parts(TABLE)
        table = Table(kind)
        self._expect("{")
        while self.word != "}" or self.kind != "mark":
            self._field(table, depth + 1)
            if self.kind == "mark" and self.word in ",;":
                self._advance()
            elif self.word != "}":
                raise self._trouble()
        self._advance()
        return table

    def _field(self, table: Table, depth: int) -> None:
        if self.kind == "mark" and self.word == "[":
            self._advance()
            key = self._value(depth)
            self._expect("]")
            self._expect("=")
            if not isinstance(key, str | float) or isinstance(key, bool):
                raise self._trouble()
            table.named[key] = self._value(depth)
        elif self.kind == "name" and self.word not in WORDS:
            name = self._advance()
            if self.kind == "mark" and self.word == "=":
                self._advance()
                table.named[name] = self._value(depth)
                return
            if self.word == "(":
                self._advance()
                self._expect(")")
            table.listed.append(self._table(name, depth))
        else:
            table.listed.append(self._value(depth))

    def _point(self, text: str) -> Table:
        self.reader.check_parts(POINT)
        return Table("", {name: self._number(word) for name, word in PART.findall(text)})

    def _number(self, word: str) -> float:
        try:
            value = float(int(word, 16)) if "x" in word.lower() else float(word)
        except ValueError:
            raise self._trouble() from None
        if not abs(value) <= MAX_NUMBER:
            raise RoamError(
                sentence(
                    "{path} holds the number {word}; no picture is that large.",
                    path=self.reader.called,
                    word=brief(word),
                )
            )
        return value

    def _trouble(self) -> RoamError:
        path = self.reader.called
        if not getattr(self, "word", ""):
            return RoamError(sentence("{path} is no setting of Fusion's, or it is cut off.", path=path))
        return RoamError(
            sentence(
                "{path} is no setting of Fusion's, or it is cut off (at {word}).", path=path, word=brief(self.word)
            )
        )


def _unquoted(text: str) -> str:
    """What a quoted Lua string says; numbers of bytes beyond ASCII are UTF-8."""
    if "\\" not in text:
        return text

    def byte(found: re.Match[str]) -> str:
        word = found.group(1)
        if word.isdigit():
            return chr(0xDC00 + int(word)) if 127 < int(word) < 256 else chr(min(int(word), 127))
        if len(word) == 3:
            value = int(word[1:], 16)
            return chr(0xDC00 + value) if value > 127 else chr(value)
        return ESCAPES.get(word, word)

    return ESCAPE.sub(byte, text).encode("utf-8", "surrogateescape").decode("utf-8", "replace")
