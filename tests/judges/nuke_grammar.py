"""A tokenizer and a reader of Nuke's Roto nodes, written from the vendor's grammar alone, as a judge of `.nk` files.

The grammar stands in the NDK developer guide, "Roto serialisation format": strings are ASCII, those with a space, a
quote, a backslash or a brace in double quotes, with the last four kinds behind a backslash. What it does not allow is
an error here, whatever Tcl would make of it. Nothing of `roam_core` is used.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Union

STEP, LINEAR, CUBIC = range(3)
OPEN, RENDERABLE, LOCKED, RELATIVE = 1 << 5, 1 << 9, 1 << 10, 1 << 13


class GrammarError(ValueError):
    """A text that the grammar does not allow."""


@dataclass(frozen=True)
class Text:
    """A string of the grammar: what it says."""

    value: str


Tree = Union[Text, list["Tree"]]  # noqa: UP007

_QUOTED = re.compile(r'"((?:[ !#-&(-\[\]-z|~]|\\["\'\\{}])*)"')
_UNQUOTED = re.compile(r"[!#-&(-\[\]-z|~]+")
_SPACE = re.compile(r"[ \n]+")


def tokens(text: str) -> Iterator[str | Text]:
    """Braces and strings of a curve tree."""
    position = 0
    while position < len(text):
        if text[position] in "{}":
            yield text[position]
            position += 1
        elif found := _SPACE.match(text, position):
            position = found.end()
        elif found := _QUOTED.match(text, position):
            yield Text(re.sub(r"\\(.)", r"\1", found.group(1)))
            position = found.end()
        elif found := _UNQUOTED.match(text, position):
            yield Text(found.group())
            position = found.end()
        else:
            raise GrammarError(f"{text[position : position + 20]!r} begins no token")


def tree(text: str) -> list[Tree]:
    """The lists of a curve tree."""
    root: list[Tree] = []
    stack = [root]
    for token in tokens(text):
        if token == "{":
            inner: list[Tree] = []
            stack[-1].append(inner)
            stack.append(inner)
        elif token == "}":
            if len(stack) == 1:
                raise GrammarError("a brace closes what was not opened")
            stack.pop()
        else:
            assert isinstance(token, Text)
            stack[-1].append(token)
    if len(stack) > 1:
        raise GrammarError("a brace is not closed")
    return root


@dataclass(frozen=True)
class Key:
    """A key of a curve: slopes per frame on either side, and how it goes on."""

    time: float
    value: float
    left: float = 0.0
    right: float = 0.0
    kind: int = CUBIC


Curve = list[Key]


def at(curve: Curve, frame: float) -> float:
    """The value of a curve: constant beyond its ends, between two keys a cubic, a straight line or a step."""
    if frame <= curve[0].time:
        return curve[0].value
    for a, b in pairwise(curve):
        if frame < b.time:
            span = b.time - a.time
            u = (frame - a.time) / span
            if a.kind == STEP:
                return a.value
            if a.kind == LINEAR:
                return a.value + u * (b.value - a.value)
            h = u * u * (3.0 - 2.0 * u)
            bend = u * (1.0 - u) * ((1.0 - u) * a.right - u * b.left) * span
            return a.value + h * (b.value - a.value) + bend
    return curve[-1].value


@dataclass
class Shape:
    """A `curvegroup`: curves of the outline and of the feather, x and y of each entry in turn."""

    name: str
    flags: int
    curve_flags: int
    attributes: dict[str, Curve]
    outline: list[Curve]
    feather: list[Curve] | None

    @property
    def closed(self) -> bool:
        return not self.curve_flags & OPEN

    @property
    def times(self) -> list[float]:
        """Of all keys of the outline."""
        return sorted({key.time for curve in self.outline for key in curve})

    def value(self, name: str, frame: float, default: float) -> float:
        """An attribute on a frame."""
        return at(self.attributes[name], frame) if name in self.attributes else default

    def triples(self, frame: float) -> list[list[tuple[float, float]]]:
        """For each point incoming handle, anchor and outgoing handle, absolute, y up."""
        return _absolute(_pairs(self.outline, frame))

    def feather_triples(self, frame: float) -> list[list[tuple[float, float]]]:
        """The same of the feather curve; the outline's where there is none."""
        outline = _pairs(self.outline, frame)
        if self.feather is None:
            return _absolute(outline)
        soft = _pairs(self.feather, frame)
        for k in range(1, len(soft), 3):
            soft[k] = (soft[k][0] + outline[k][0], soft[k][1] + outline[k][1])
        return _absolute(soft)


def _pairs(curves: list[Curve], frame: float) -> list[tuple[float, float]]:
    values = [at(curve, frame) for curve in curves]
    return list(zip(values[::2], values[1::2], strict=True))


def _absolute(pairs: list[tuple[float, float]]) -> list[list[tuple[float, float]]]:
    result = []
    for k in range(0, len(pairs), 3):
        (lx, ly), (x, y), (rx, ry) = pairs[k : k + 3]
        result.append([(x + lx, y + ly), (x, y), (x + rx, y + ry)])
    return result


@dataclass
class Layer:
    """A `layer` with what lies in it, top first."""

    name: str
    flags: int
    attributes: dict[str, Curve]
    children: list[Layer | Shape] = field(default_factory=list)

    def shapes(self) -> Iterator[Shape]:
        """All shapes below, top first."""
        for child in self.children:
            if isinstance(child, Shape):
                yield child
            else:
                yield from child.shapes()

    def value(self, name: str, frame: float, default: float) -> float:
        """An attribute on a frame."""
        return at(self.attributes[name], frame) if name in self.attributes else default


@dataclass
class Node:
    """A node of a script: its class, its knobs as they are written, and the root of its curves if it has any."""

    species: str
    knobs: dict[str, str]
    root: Layer | None


def nodes(script: str) -> list[Node]:
    """The nodes of a script; commands that are none are passed over."""
    found = []
    for command in _commands(script):
        if len(command) == 2 and command[1].startswith("{"):
            lines = [line for line in _commands(command[1][1:-1]) if line[0] != "addUserKnob"]
            knobs = {line[0]: line[1] for line in lines if len(line) == 2}
            found.append(Node(command[0], knobs, root_of(knobs["curves"]) if "curves" in knobs else None))
    return found


def shapes(script: str) -> list[Shape]:
    """All shapes of a script, each node's top first."""
    return [shape for node in nodes(script) if node.root is not None for shape in node.root.shapes()]


def _commands(text: str) -> Iterator[list[str]]:
    """The words of each line, as they are written: a word in braces or quotes may go on over lines."""
    line: list[str] = []
    position = 0
    while position < len(text):
        character = text[position]
        if character == "\n":
            if line:
                yield line
            line, position = [], position + 1
        elif character == " ":
            position += 1
        elif character == "#" and not line:
            position = text.find("\n", position) % (len(text) + 1)
        else:
            end = _word_end(text, position)
            line.append(text[position:end])
            position = end
    if line:
        yield line


def _word_end(text: str, start: int) -> int:
    if text[start] == '"':
        found = re.compile(r'"(?:[^"\\]|\\.)*"', re.DOTALL).match(text, start)
        if found is None:
            raise GrammarError("a quote is not closed")
        return found.end()
    if text[start] != "{":
        found = re.compile(r"(?:[^\s\\]|\\.)+", re.DOTALL).match(text, start)
        assert found is not None
        return found.end()
    depth = 0
    for mark in re.compile(r"\\.|[{}]", re.DOTALL).finditer(text, start):
        depth += {"{": 1, "}": -1}.get(mark.group(), 0)
        if depth == 0:
            return mark.end()
    raise GrammarError("a brace is not closed")


# ---- the curve tree --------------------------------------------------------------------------------------------------


def root_of(knob: str) -> Layer:
    """The root layer of a `curves` knob, as it is written."""
    ((document,),) = (_list(item) for item in tree(knob))
    heads = {_string(_list(item)[0]): _list(item)[1:] for item in _list(document)}
    if set(heads) != {"v", "f", "n"}:
        raise GrammarError(f"a document has {sorted(heads)}")
    (root,) = heads["n"]
    return _layer(_list(root))


def _layer(items: list[Tree]) -> Layer:
    word, name, *rest = items
    if _string(word) != "layer":
        raise GrammarError(f"{_string(word)!r} is no layer")
    layer = Layer(_string(name), 0, {})
    for item in map(_list, rest):
        head = _string(item[0])
        if head == "f":
            layer.flags = _int(item[1])
        elif head == "a":
            layer.attributes = _attributes(item)
        elif head == "layer":
            layer.children.append(_layer(item))
        elif head == "curvegroup":
            layer.children.append(_shape(item))
        elif head not in ("t", "tx"):
            raise GrammarError(f"a layer holds {head!r}")
    return layer


def _shape(items: list[Tree]) -> Shape:
    _, name, flags, species, curves, transform, attributes = items
    if _string(species) != "bezier":
        raise GrammarError(f"a shape is a {_string(species)!r}")
    form, *numbers = _list(transform)
    if len(numbers) > 3 + (_string(form) == "tx"):
        raise GrammarError("a shape is moved by its transform: no case of this judge")
    outline, feather = _list(curves)
    curve_flags, main = _control_curve(_list(outline))
    soft = None
    if not isinstance(feather, Text):
        soft = _control_curve(_list(feather))[1]
    elif feather.value != "idem":
        raise GrammarError(f"{feather.value!r} is no feather")
    return Shape(_string(name), _int(flags), curve_flags, _attributes(_list(attributes)), main, soft)


def _control_curve(items: list[Tree]) -> tuple[int, list[Curve]]:
    """Flags, and a curve for x and y of each entry."""
    word, flags, points = items
    if _string(word) != "cc" or _string(_list(flags)[0]) != "f":
        raise GrammarError("a control curve begins otherwise")
    form, stamps, *entries = _list(points)
    if _string(form) != "px" or len(entries) % 3:
        raise GrammarError("points are no triples with times")
    times = [_number(stamp) for stamp in (stamps if isinstance(stamps, list) else [stamps])]
    if times != sorted(set(times)):
        raise GrammarError("times do not rise")
    return _int(_list(flags)[1]), [_curve(part, times) for entry in entries for part in _two(_list(entry))]


def _two(entry: list[Tree]) -> list[Tree]:
    if len(entry) != 2:
        raise GrammarError("an entry is no pair")
    return entry


def _curve(item: Tree, times: list[float] | None) -> Curve:
    """A number, or keys: at the shared `times`, or each with its own."""
    if isinstance(item, Text):
        return [Key(0.0, _number(item))]
    own = [_key([Text("0"), *_list(key)] if times is not None else _list(key)) for key in item]
    if times is None or len(own) == 1:
        return own
    if len(own) != len(times):
        raise GrammarError(f"{len(own)} keys stand for {len(times)} times")
    return [Key(time, key.value, key.left, key.right, key.kind) for time, key in zip(times, own, strict=True)]


def _key(parts: list[Tree]) -> Key:
    """Time and value; then `-`, or slope and length on either side; then the number of an interpolation."""
    time, value, *rest = parts
    words = [_string(part) for part in rest]
    if words in ([], ["-"]):
        return Key(_number(time), _number(value))
    kind = CUBIC if len(words) == 4 else int(words[4]) & 255
    left, left_length, right, right_length = (_number(Text(word)) for word in words[:4])
    if (left_length, right_length) != (1.0, 1.0):
        raise GrammarError("handles of other lengths: no case of this judge")
    return Key(_number(time), _number(value), left, right, kind)


def _attributes(items: list[Tree]) -> dict[str, Curve]:
    if _string(items[0]) != "a" or len(items) % 2 == 0:
        raise GrammarError("attributes are no pairs")
    return {_string(name): _curve(value, None) for name, value in zip(items[1::2], items[2::2], strict=True)}


def _list(item: Tree) -> list[Tree]:
    if isinstance(item, Text):
        raise GrammarError(f"{item.value!r} stands where a list belongs")
    return item


def _string(item: Tree) -> str:
    if not isinstance(item, Text):
        raise GrammarError("a list stands where a string belongs")
    return item.value


def _int(item: Tree) -> int:
    return int(_string(item))


def _number(item: Tree) -> float:
    """A decimal, or `x` and eight hexadecimal digits (the page says `0x`; Nuke's own files leave the zero out)."""
    word = _string(item)
    if re.fullmatch(r"(?:0x|x)[0-9a-f]{8}", word):
        return float(struct.unpack(">f", bytes.fromhex(word.rpartition("x")[2]))[0])
    if not re.fullmatch(r"-?\d+(?:\.\d+)?", word):
        raise GrammarError(f"{word!r} is no number")
    return float(word)
