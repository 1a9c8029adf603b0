"""The words of Nuke's scripts: names that run nothing, single-precision numbers, the bits of flags."""

from __future__ import annotations

import re
from collections.abc import Iterable

import numpy as np

from roam_core.arrays import Array
from roam_core.interchange.authorship import MARK
from roam_core.interchange.nuke.keys import value_curve
from roam_core.interchange.timing import straight_keys, value_moments
from roam_core.roto.animated import Animatable, Animated

HEAD = f"# {MARK}\nversion 9.0 v1\n"
"""How a script begins."""
ROOT_FLAGS = 1 << 21
OPEN, RENDERABLE, LOCKED, RELATIVE_TANGENTS = 1 << 5, 1 << 9, 1 << 10, 1 << 13
"""Bits of a flag word, of which the shape's and layer's are RENDERABLE and LOCKED, the curve's the other two."""


def tcl_word(text: str) -> str:
    """`text` as one word of a Tcl list, which reads back as the same text and runs nothing.

    Whatever Tcl might take for syntax gets a backslash, white space and control characters become escapes: such a word
    keeps braces balanced however deep the lists around it are. A lone surrogate, which UTF-8 cannot hold, becomes
    U+FFFD.
    """
    return _SPECIAL.sub(_escaped, text.encode("utf-16-le", "surrogatepass").decode("utf-16-le", "replace")) or "{}"


_SPECIAL = re.compile(r"""[\x00-\x20\x7f-\x9f\u2028\u2029{}\[\]$"\\;#]""")


def _escaped(match: re.Match[str]) -> str:
    character = match.group()
    if character.isprintable() and character != " ":
        return "\\" + character
    return {" ": "\\ ", "\n": "\\n", "\t": "\\t", "\r": "\\r"}.get(character, f"\\u{ord(character):04x}")


def attribute_list(values: Iterable[tuple[str, Animatable]], frame_offset: int) -> str:
    """Names and values as the list of a layer's or shape's attributes."""
    return "{" + " ".join(["a", *(f"{name} {_attribute(value, frame_offset)}" for name, value in values)]) + "}"


def _attribute(value: Animatable, frame_offset: int) -> str:
    """A number; or keys, each with its time, its value, and slope and length on either side."""
    if not isinstance(value, Animated):
        return number(value)
    curve = value_curve(value, frame_offset)
    table = np.array([curve.times, curve.values, curve.left, curve.right])
    words = (numbers(column) for column in table.T)
    return "{" + " ".join(f"{{{time} {at} {left} 1 {right} 1}}" for time, at, left, right in words) + "}"


def knob_curve(value: Animatable, frame_offset: int) -> str:
    """A number as the value of a node's knob: itself, or an animation curve of straight spans."""
    if not isinstance(value, Animated):
        return repr(value)
    keys = " ".join(f"x{time:.10g} {at!r}" for time, at in value_moments(straight_keys(value), frame_offset))
    return f"{{{{curve L {keys}}}}}"


def number(value: float) -> str:
    """One number in Nuke's notation."""
    return numbers(np.array([value], dtype=np.float64))[0]


def numbers(values: Array) -> list[str]:
    """Single-precision numbers in Nuke's notation: 0 and 1 as they are, others as `x` and eight hexadecimal digits."""
    digits = (values.astype(">f4") + np.float32(0.0)).astype(">f4").tobytes().hex()  # adding zero takes -0 to 0
    return [_PLAIN.get(word, f"x{word}") for word in (digits[i : i + 8] for i in range(0, len(digits), 8))]


_PLAIN = {"00000000": "0", "3f800000": "1"}
