"""Names of files and in ASCII: the frame's number in a pattern, and a shape's name in letters that others take."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Collection, Iterable
from pathlib import Path

LONGEST = 80
"""Characters of a file's name that come from a shape's."""

RESERVED = {"con", "prn", "aux", "nul", *(f"{port}{digit}" for port in ("com", "lpt") for digit in range(1, 10))}
"""Names that Windows keeps for devices."""
PICTURE = {"rgba", "rgb", "alpha"}
"""What programs call a picture's own channels: as a layer's name, such a word would stand for the joint matte there."""


def numbering(pattern: str, offset: int = 0) -> Callable[[int], str]:
    """How a pattern such as `m.####.png`, `m.@@@@.png`, `m.%04d.png`, `m.$F4.png` or plain `m.png` names a frame.

    `%d`, `$F` and a single `#` give the number as it is; a single `@` is a letter of the name. Where the pattern says
    nothing of a number, four digits stand before the suffix.
    """
    marked = _MARK.fullmatch(pattern)
    if marked is None:
        stem, suffix = Path(pattern).stem, Path(pattern).suffix
        return lambda frame: f"{stem}.{frame + offset:04d}{suffix}"
    before, marks, digits, houdini, braced, after = marked.groups()
    width = len(marks) if marks[0] in "#@" else int(digits or houdini or braced or 1)
    return lambda frame: f"{before}{frame + offset:0{width}d}{after}"


def is_numbered(pattern: str) -> bool:
    """True when the pattern says where a frame's number goes."""
    return _MARK.fullmatch(pattern) is not None


_MARK = re.compile(
    r"(.*?)(%(?:0?(\d))?d(?!.*%0?\d?d)|(?:#+|@@+)(?!.*(?:#|@@|%0?\d?d))"
    r"|(?:\$F(?:([1-9])|(?![A-Za-z0-9]))|\$\{F([1-9]?)\})"
    r"(?!.*(?:#|@@|%0?\d?d|\$F(?:[1-9]|(?![A-Za-z0-9]))|\$\{F[1-9]?\})))(.*)",
    flags=re.DOTALL,
)


def ascii_name(text: str) -> str:
    """A name in printable ASCII that still reads like it; a name that is printable ASCII already comes back as it is.

    Accents fall (`é` becomes `e`); Latin letters with strokes and hooks, ligatures, Cyrillic, Greek, kana, Hangul and
    the digits of every script are written with Latin letters; letters of other scripts and signs by their names in
    Unicode (`shin`, `grinning-face`); every space and line break is a space; what has no name of that kind, such as a
    Chinese character, is `u` and its code point. Not empty unless `text` is.
    """
    if text.isascii() and text.isprintable():
        return text
    whole = "".join(_latin(character) for character in unicodedata.normalize("NFKC", text))
    return whole if whole.strip() else "".join(f"u{ord(character):04X}" for character in text)


def distinct(name: str, taken: Collection[str]) -> str:
    """The name, or the name and the first number from 2 on that none of `taken` is called."""
    number, free = 1, name
    while free in taken:
        number += 1
        free = f"{name} {number}"
    return free


def file_words(names: Iterable[str]) -> list[str]:
    """For each name a word for files and channels: letters, digits, `-` and `_`, unlike every other also in lower case.

    The letters are those of `ascii_name`; what else it holds becomes `_`. A second word of the same letters gets a
    number.
    """
    words: list[str] = []
    taken: set[str] = set()
    for name in names:
        stem = re.sub(r"[^A-Za-z0-9_-]+", "_", ascii_name(name))[:LONGEST].strip("_-") or "shape"
        if stem.lower() in RESERVED | PICTURE:
            stem = f"{stem}_"
        word, number = stem, 1
        while word.lower() in taken:
            number += 1
            word = f"{stem}_{number}"
        taken.add(word.lower())
        words.append(word)
    return words


def _latin(character: str) -> str:
    """What stands for one character of a composed text in printable ASCII; nothing for marks that change others."""
    if character.isascii():
        return character if character.isprintable() else " " if character.isspace() else ""
    small = character.lower()
    if small in _SPELLED:
        return _cased(_SPELLED[small], character)
    category = unicodedata.category(character)
    if category in ("Mn", "Me", "Cf"):
        return ""
    if category[0] == "Z":
        return " "
    if (digit := unicodedata.decimal(character, None)) is not None:
        return str(digit)
    named = _SOUNDED.fullmatch(unicodedata.name(character, ""))
    if named is not None:
        return _cased((named["latin"] or named["syllable"]).lower(), character)
    base = unicodedata.normalize("NFKD", character)[0]
    return _named(character) if base == character else _latin(base)


def _named(character: str) -> str:
    """By the character's name in Unicode: the last word of a letter's, all of a sign's; or by its number."""
    if unicodedata.category(character) == "Cs":  # half of a character, without the other
        return "_"
    name = unicodedata.name(character, "").lower()
    if "ideograph" not in name:
        words = name.rpartition(" ")[2] if unicodedata.category(character)[0] in "LM" else name
        if spelled := re.sub(r"[^a-z0-9]+", "-", words).strip("-"):
            return spelled
    return f"u{ord(character):04X}"


def _cased(letters: str, character: str) -> str:
    """The letters, with a capital in front where the character is one."""
    return letters.capitalize() if character.isupper() else letters


_SOUNDED = re.compile(
    r"LATIN (?:SMALL |CAPITAL )?(?:LETTER|LIGATURE) (?P<latin>[A-Z]{1,2})(?: WITH .*)?"
    r"|(?:HIRAGANA LETTER|KATAKANA LETTER|HANGUL SYLLABLE) (?:SMALL )?(?P<syllable>[A-Z]+)"
)
"""Names in the Unicode standard that say which Latin letters a character is or sounds like."""


def _table(characters: str, letters: str) -> dict[str, str]:
    """Each character with its letters; `_` stands for none."""
    return {one: "" if other == "_" else other for one, other in zip(characters.split(), letters.split(), strict=True)}


_SPELLED = {
    **_table("ß þ ð ı ŋ ə ĸ", "ss th d i ng e k"),
    **_table(
        "а б в г д е ё ж з и й к л м н о п р с т у ф х ц ч ш щ ъ ы ь э ю я",
        "a b v g d e e zh z i y k l m n o p r s t u f kh ts ch sh shch _ y _ e yu ya",
    ),
    **_table("і ї є ґ ў ђ ј љ њ ћ џ ѓ ќ ѕ", "i yi ye g u dj j lj nj c dz g k dz"),
    **_table(
        "α β γ δ ε ζ η θ ι κ λ μ ν ξ ο π ρ σ ς τ υ φ χ ψ ω",
        "a b g d e z i th i k l m n x o p r s s t y f ch ps o",
    ),
    **_table("‐ ‑ ‒ – — ― − ⁄ × · • → ←", "- - - - - - - / x . * -> <-"),
    **_table("‘ ’ ‚ ʼ “ ” „ « » ° € £ © ® ー", '\' \' \' \' " " " " " deg EUR GBP (c) (r) _'),
}
"""Small letters and signs whose names and parts do not tell how they are written in ASCII."""
