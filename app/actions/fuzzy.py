"""Fuzzy search: how well a few typed letters fit a title, where letters may be left out but not change places."""

from __future__ import annotations

FIRST, ADJACENT, WORD_START, LETTER = 3.5, 3.2, 3.0, 1.0
"""What a letter of the query is worth: at the start of the text, next to the one before it, at the start of a word,
anywhere. A word that is typed is meant as a whole: its letters are not looked for in several words."""
LENGTH_COST = 0.02
"""Taken off for each letter of the text: of two texts that fit alike the shorter is meant."""

_NONE = float("-inf")


def fuzzy_score(query: str, text: str) -> float | None:
    """How well `query` fits `text` as a subsequence of its letters, whatever their case; higher is better.

    Spaces in the query are left out. None where it does not fit; an empty query fits everything.
    """
    wanted, letters = query.casefold().replace(" ", ""), text.casefold()
    if not is_subsequence(wanted, letters):
        return None
    cost = LENGTH_COST * len(letters)
    if not wanted:
        return -cost
    worths = [LETTER + _worth_of_place(letters, place) for place in range(len(letters))]
    # best[j]: the most that the letters so far are worth, the last of them lying at j.
    best = [worth if letter == wanted[0] else _NONE for worth, letter in zip(worths, letters, strict=True)]
    for letter in wanted[1:]:
        before, so_far, best = best, _NONE, []
        for place, worth in enumerate(worths):
            adjacent = before[place - 1] + ADJACENT if place else _NONE
            best.append(max(so_far, adjacent) + worth if letters[place] == letter else _NONE)
            so_far = max(so_far, before[place])
    return max(best) - cost


def is_subsequence(wanted: str, letters: str) -> bool:
    """True where `wanted` comes out of `letters` by leaving letters out."""
    rest = iter(letters)
    return all(letter in rest for letter in wanted)


def words_begin(query: str, text: str) -> bool:
    """True where every word of the query begins a word of the text, whatever their case."""
    words = text.casefold().split()
    return all(any(word.startswith(wanted) for word in words) for wanted in query.casefold().split())


def _worth_of_place(letters: str, place: int) -> float:
    if place == 0:
        return FIRST
    return 0.0 if letters[place - 1].isalnum() else WORD_START
