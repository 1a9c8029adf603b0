"""Sentences that the window translates keep their templates on every way that they go."""

from __future__ import annotations

import copy

from roam_core.errors import RoamError
from roam_core.translatable import Sentence, enumerated, listed, said_by, sentence


def test_an_error_of_a_worker_keeps_its_sentence() -> None:
    raised = RoamError(sentence("{name!r} loses {lost}.", name="Arm", lost=listed(["a", "b"])))
    # As pickling does, by which it goes to another process.
    said = copy.deepcopy(raised).args[0]
    assert isinstance(said, Sentence)
    assert (str(said), said.template) == ("'Arm' loses a and b.", "{name!r} loses {lost}.")
    assert isinstance(said.values["lost"], Sentence)


def test_what_an_error_says_stays_a_sentence_within_another() -> None:
    said = said_by(ValueError(sentence("{count} too many", count=2)))
    assert isinstance(said, Sentence)
    assert said == "2 too many"
    assert said_by(OSError(2, "gone")) == "[Errno 2] gone"
    assert said_by(KeyError("a")) == "'a'"


def test_names_are_enumerated_and_the_most_of_them_counted() -> None:
    assert enumerated(["a", "b"]) == enumerated(["a", "b"], 2) == "a, b"
    assert enumerated(["a", "b", "c"], 1) == "a and 2 more"
    told = enumerated([sentence("{name} (one image)", name="a"), "b", "c"], 2)
    assert told == "a (one image), b and 1 more"
    assert isinstance(told, Sentence)
    assert isinstance(told.values["names"], Sentence)
