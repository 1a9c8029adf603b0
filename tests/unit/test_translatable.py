"""Sentences that the window translates keep their templates on every way that they go."""

from __future__ import annotations

import copy

from roam_core.errors import RoamError
from roam_core.translatable import Sentence, listed, sentence


def test_an_error_of_a_worker_keeps_its_sentence() -> None:
    raised = RoamError(sentence("{name!r} loses {lost}.", name="Arm", lost=listed(["a", "b"])))
    # As pickling does, by which it goes to another process.
    said = copy.deepcopy(raised).args[0]
    assert isinstance(said, Sentence)
    assert (str(said), said.template) == ("'Arm' loses a and b.", "{name!r} loses {lost}.")
    assert isinstance(said.values["lost"], Sentence)
