"""Nuke's scripts as text: nodes, knobs and nested lists by Tcl's rules, of which nothing is run."""

from __future__ import annotations

import re
import struct
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Union

from roam_core.errors import RoamError
from roam_core.interchange.reading import MAX_NUMBER, ShapeReader
from roam_core.translatable import sentence

MAX_SCRIPT, MAX_LISTS = 24 << 20, 3_000_000
"""Bytes and lists of a script that is read; each about four seconds of work."""

PER_WORD = 2
"""Parts that a word counts for: it takes twice as long as an element of XML."""

GROUPS = ("Group", "Gizmo", "LiveGroup")
"""Classes of nodes that hold others."""

Nested = list[Union[str, "Nested"]]
"""A list of words and lists."""


@dataclass(frozen=True)
class Word:
    """A word of a script: `text[start:end]` without what encloses it.

    Attributes
    ----------
    is_braced : whether it stood in braces; it may then be read as a list.
    is_whole : False when the script ended before the braces did.
    """

    script: Script
    start: int
    end: int
    is_braced: bool = False
    is_whole: bool = True

    @property
    def raw(self) -> str:
        """As it stands in the script."""
        return self.script.text[self.start : self.end]

    @property
    def value(self) -> str:
        """What Tcl takes it for: in braces everything is itself, elsewhere backslashes stand for characters."""
        if self.is_braced:
            return self.raw
        text = _ESCAPE.sub(_unescaped, self.raw)
        return text.encode("utf-16-le", "surrogatepass").decode("utf-16-le", "replace")

    def words(self) -> list[Word]:
        """The word as a list."""
        return list(self.script.elements(self.start, self.end))

    def knobs(self) -> dict[str, Word]:
        """The word as the body of a node: the value of each knob by its name."""
        commands = self.script.commands(self.start, self.end)
        return {command[0].value: command[1] for command in commands if len(command) > 1}

    def nested(self) -> Nested:
        """The word as lists of lists at once, for those in which no name can stand."""
        root: Nested = []
        stack = [root]
        for token in _TOKENS.findall(self.raw):
            if token == "{":
                inner: Nested = []
                stack[-1].append(inner)
                stack.append(inner)
            elif token != "}":
                stack[-1].append(token)
            elif len(stack) > 1:
                stack.pop()
        return root


class Script:
    """A text in which braces are matched once; its words are found one level at a time.

    Attributes
    ----------
    cut : what the node is called within which the script ends, if it does; known once its nodes were gone through.
    """

    def __init__(self, reader: ShapeReader) -> None:
        self.text = reader.text(MAX_SCRIPT)
        if self.text.count("{") > MAX_LISTS:
            raise RoamError(
                sentence(
                    "{path} holds more than {most} lists; split it into several files.",
                    path=reader.called,
                    most=MAX_LISTS,
                )
            )
        self._reader = reader
        self._closing: dict[int, int] = {}
        self.cut: str | None = None

    def nodes(self) -> Iterator[tuple[str, dict[str, Word], tuple[dict[str, Word], ...]]]:
        """Class and knobs of every node, in the order of the script, and the knobs of the groups around it.

        The first of several clones is written as `clone node1f0a|Roto|31 Roto {...}`; the others repeat no curves.
        What is in a group follows it, up to `end_group`.
        """
        around: tuple[dict[str, Word], ...] = ()
        for command in self.commands(0, len(self.text)):
            if command[0].raw == "clone":
                command = command[-2:]
            if len(command) > 1 and command[1].is_braced:
                species, knobs = command[0].value, command[1].knobs()
                if not command[1].is_whole:
                    self.cut = knobs["name"].value if "name" in knobs else species
                yield species, knobs, around
                if species in GROUPS:
                    around = (*around, knobs)
            elif command[0].raw == "end_group":
                around = around[:-1]

    def commands(self, start: int, end: int) -> Iterator[list[Word]]:
        """The words of each line (or part of one up to a semicolon) that is not empty; comments are passed over."""
        line: list[Word] = []
        position = start
        while position < end:
            space = _match(_SPACE_OF_COMMANDS, self.text, position, end)
            if line and any(mark in space for mark in "\n;"):
                yield line
                line = []
            position += len(space)
            if not line and self.text.startswith("#", position, end):
                position += len(_match(_LINE, self.text, position, end))
            elif position < end:
                word, position = self._word(position, end, _BARE_OF_COMMANDS)
                line.append(word)
        if line:
            yield line

    def elements(self, start: int, end: int) -> Iterator[Word]:
        """The elements of a list."""
        position = start + len(_match(_SPACE, self.text, start, end))
        while position < end:
            word, position = self._word(position, end, _BARE)
            yield word
            position += len(_match(_SPACE, self.text, position, end))

    def _word(self, position: int, end: int, bare: re.Pattern[str]) -> tuple[Word, int]:
        self._reader.check_parts(PER_WORD)
        first = self.text[position]
        if first == "{":
            if position not in self._closing:
                self._match(position)
            closing = min(self._closing[position], end)
            return Word(self, position + 1, closing, True, self._closing[position] < len(self.text)), closing + 1
        if first == '"':
            quoted = _QUOTED.match(self.text, position, end)
            if quoted is not None:
                return Word(self, position + 1, quoted.end() - 1), quoted.end()
        stop = position + (len(_match(bare, self.text, position, end)) or 1)
        return Word(self, position, stop), stop

    def _match(self, position: int) -> None:
        """Find the closing braces of this one and of all within it; those that the script lacks close at its end."""
        opened: list[int] = []
        for found in _BRACE.finditer(self.text, position):
            mark = found.group()
            if mark == "{":
                opened.append(found.start())
                self._reader.check_depth(len(opened))
            elif mark == "}":
                self._closing[opened.pop()] = found.start()
                if not opened:
                    return
        for start in opened:
            self._closing[start] = len(self.text)


def decoded(word: str) -> float:
    """A number: `x` and eight hexadecimal digits of a single-precision one, or a decimal.

    Raises `ValueError` for anything else, for what is not finite or absurdly large.
    """
    try:
        number: float = struct.unpack(">f", bytes.fromhex(word[1:]))[0] if word.startswith("x") else float(word)
    except (ValueError, struct.error):
        raise ValueError(sentence("{text!r} is no number", text=word[:20])) from None
    if not abs(number) <= MAX_NUMBER:
        raise ValueError(sentence("{text!r} is no sensible number", text=word[:20]))
    return number


# Possessive repeats: nothing is kept to go back to, however long a run is.
_SPACE = re.compile(r"(?:[ \t\r\f\v\n]++|\\\r?\n)*+")
_SPACE_OF_COMMANDS = re.compile(r"(?:[ \t\r\f\v\n;]++|\\\r?\n)*+")
_LINE = re.compile(r"[^\n]*")
_QUOTED = re.compile(r'"(?:[^"\\]++|\\.)*+"', re.DOTALL)
_BARE = re.compile(r"(?:[^ \t\r\f\v\n\\]++|\\.)*+", re.DOTALL)
_BARE_OF_COMMANDS = re.compile(r"(?:[^ \t\r\f\v\n;\\]++|\\.)*+", re.DOTALL)
_BRACE = re.compile(r"\\.|[{}]", re.DOTALL)
_TOKENS = re.compile(r"[{}]|[^\s{}]+")
_ESCAPE = re.compile(
    r"\\(?:x([0-9a-fA-F]{1,2})|u([0-9a-fA-F]{1,4})|U([0-9a-fA-F]{1,8})|([0-7]{1,3})|(\r?\n)[ \t]*|(.))", re.DOTALL
)
_NAMED = {"n": "\n", "t": "\t", "r": "\r", "a": "\a", "b": "\b", "f": "\f", "v": "\v"}


def _match(pattern: re.Pattern[str], text: str, start: int, end: int) -> str:
    found = pattern.match(text, start, end)
    return "" if found is None else found.group()


def _unescaped(match: re.Match[str]) -> str:
    byte, short, long, octal, line, character = match.groups()
    if line is not None:
        return " "
    if character is not None:
        return _NAMED.get(character, character)
    code = int(octal, 8) if octal is not None else int(byte or short or long, 16)
    return chr(code) if code <= 0x10FFFF else "\ufffd"
