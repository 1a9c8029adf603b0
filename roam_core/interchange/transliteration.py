"""Names in ASCII that can still be read, for formats and channels that hold no other letters."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Collection

SMALL = "ßæøœłđðþıабвгдежзийклмнопрстуфхцчшщъыьэюяієґαβγδεζηθικλμνξοπρσςτυφχψω"
SPELLED = (
    "ss ae o oe l d d th i a b v g d e zh z i y k l m n o p r s t u f kh ts ch sh shch - y - e yu ya i ye g "
    "a b g d e z e th i k l m n x o p r s s t y f ch ps o"
)
LETTERS = dict(zip(SMALL, SPELLED.split(" "), strict=True))
"""Small letters that no decomposition takes to ASCII, spelled; `-` is none at all."""

PUNCTUATION = str.maketrans("\u2013\u2014\u2018\u2019\u201c\u201d\u2044", "--''\"\"/", "\u200d\ufeff")


def transliterated(text: str) -> str:
    """The text in printable ASCII: accents taken off, other letters spelled out, white space as single spaces.

    `Größe` gives `Grosse`, a Cyrillic or Greek name its letters, a sign its own name, and a Chinese character its
    number (`u9AEA`); what has none of these becomes `_`.
    """
    spelled = "".join(map(_spelled, unicodedata.normalize("NFC", text.translate(PUNCTUATION))))
    return re.sub(r"\s+", " ", spelled)


def distinct(name: str, taken: Collection[str]) -> str:
    """The name, or the name and the first number from 2 on that none of `taken` is called."""
    number, free = 1, name
    while free in taken:
        number += 1
        free = f"{name} {number}"
    return free


def _spelled(character: str) -> str:
    if character.isascii() and character.isprintable():
        return character
    if character.isspace() or unicodedata.category(character) == "Cc":
        return " "
    if " SYLLABLE " in unicodedata.name(character, ""):
        return _named(character)
    decomposed = unicodedata.normalize("NFKD", character).translate(PUNCTUATION)
    parts = (part for part in decomposed if not unicodedata.combining(part))
    return "".join(part if part.isascii() else _letter(part) for part in parts)


def _letter(character: str) -> str:
    small = LETTERS.get(character.lower())
    if small is None:
        return _named(character)
    plain = small.replace("-", "")
    return plain.capitalize() if character.isupper() else plain


def _named(character: str) -> str:
    """By the character's name in Unicode: the last word of a letter's or syllable's, all of a sign's."""
    name = unicodedata.name(character, "")
    if "IDEOGRAPH" in name:
        return f"u{ord(character):X}"
    if " LETTER " in name or " SYLLABLE " in name:
        return re.sub(r"[^a-z]", "", name.rpartition(" ")[2].lower())
    return re.sub(r"[^a-z0-9]+", "-", name.lower()) or "_"
