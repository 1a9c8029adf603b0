"""The benchmark of objects that come into the picture: where its runs begin, and that it runs."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks import coming_in, shots
from benchmarks.shots import Shot


def test_a_run_begins_where_a_part_of_the_object_is_seen_and_more_comes_in() -> None:
    coming, going = np.linspace(0.0, 1.0, 21), np.linspace(1.0, 0.0, 21)
    assert coming_in.begun(coming) == [3]
    assert coming_in.begun(going) == []
    assert coming_in.begun(np.full(21, 0.4)) == []
    assert coming_in.begun(np.concatenate([coming, going, coming])) == [3, 13, 45]
    back_again = np.where(np.arange(21) == 5, 0.0, np.linspace(0.2, 1.0, 21))
    assert all(k > 5 for k in coming_in.begun(back_again))


def test_windows_are_halves_of_the_picture() -> None:
    picture = np.zeros((120, 200))
    assert {coming_in.Window.of(window, picture).size for window in coming_in.windows((120, 200))} == {12000}


def test_a_shot_is_scored_in_its_windows(monkeypatch: pytest.MonkeyPatch, gliding: Shot) -> None:
    monkeypatch.setattr(shots, "load", {gliding.name: gliding}.__getitem__)
    monkeypatch.setattr(coming_in, "LENGTH", 3)
    monkeypatch.setattr(coming_in, "LEAST", 2)
    monkeypatch.setattr(coming_in, "CUT_OFF", (0.05, 0.95))
    monkeypatch.setattr(coming_in, "GAINED", 0.01)
    found = coming_in.measured((gliding.name, "best"))
    assert found
    for first, iou, confidence in found:
        assert 0.5 < first <= 1.0
        assert 0.5 < iou <= 1.0
        assert 0.0 < confidence <= 1.0
