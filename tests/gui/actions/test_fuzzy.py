"""Fuzzy search: what fits, what does not, and what is meant first."""

from __future__ import annotations

import pytest

from app.actions.fuzzy import fuzzy_score, words_begin


@pytest.mark.parametrize("query", ["", "tf", "track", "TRK fwd", "kfo", "track forward"])
def test_letters_may_be_left_out(query: str) -> None:
    assert fuzzy_score(query, "Track forward") is not None


@pytest.mark.parametrize("query", ["ft", "trackk", "track forwards", "q"])
def test_letters_may_not_change_places_nor_be_added(query: str) -> None:
    assert fuzzy_score(query, "Track forward") is None


@pytest.mark.parametrize(
    ("query", "meant", "other"),
    [
        ("tf", "Track forward", "Track one frame forward"),  # both begin words; the shorter is meant
        ("sa", "Save as…", "Import shapes…"),  # beginnings of words before letters inside of them
        ("set", "Set key", "Smooth the tangents"),  # letters in a row before scattered ones
        ("track", "Track forward", "Track to the next key"),  # a word is meant as a whole: no k out of "key"
        ("track", "Track forward", "Float: Track"),  # what begins so before what ends so
    ],
)
def test_the_better_fit_scores_higher(query: str, meant: str, other: str) -> None:
    scores = [fuzzy_score(query, text) for text in (meant, other)]
    assert scores[0] is not None
    assert scores[1] is not None
    assert scores[0] > scores[1]


def test_the_best_of_several_ways_to_fit_counts() -> None:
    # The first s of "Reset set" lies inside a word; the one that begins a word is worth more.
    assert (fuzzy_score("set", "Reset set") or 0) > (fuzzy_score("set", "Reset aet") or 0)


def test_every_word_of_the_query_begins_a_word() -> None:
    assert words_begin("prop for", "Track forward propagate")
    assert not words_begin("prop back", "Track forward propagate")
    assert not words_begin("agate", "propagate")
