"""The benchmark of objects in two pieces: how they are cut, and that it runs."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from benchmarks import pieces, shots
from benchmarks.shots import Shot


@pytest.mark.parametrize("share", pieces.CUTS)
@pytest.mark.parametrize("turned", [False, True])
def test_pieces_overlap_by_a_tenth_of_the_length_and_make_the_whole(share: float, turned: bool) -> None:
    inside = np.zeros((60, 240), dtype=bool)
    inside[20:40, 20:220] = True
    inside = inside.T if turned else inside
    first, second = pieces.cut(inside, share, pieces.long_axis(inside))
    assert ((first | second) == inside).all()
    assert (first & second).sum() == pytest.approx(0.1 * inside.sum(), rel=0.06)
    assert first.sum() == pytest.approx((share + 0.05) * inside.sum(), rel=0.06)


def test_the_axis_keeps_its_sense_from_mask_to_mask() -> None:
    rows, columns = np.mgrid[:120, :120] - 60
    axes = []
    for degrees in range(0, 360, 15):
        turn = np.deg2rad(degrees)
        along, across = columns * np.cos(turn) + rows * np.sin(turn), rows * np.cos(turn) - columns * np.sin(turn)
        axes.append(pieces.long_axis((abs(along) < 50) & (abs(across) < 10), axes[-1] if axes else None))
    assert all(before @ after > 0.9 for before, after in pairwise(axes))


def test_a_shot_is_scored_in_one_outline_and_in_pieces(monkeypatch: pytest.MonkeyPatch, gliding: Shot) -> None:
    monkeypatch.setattr(shots, "load", {gliding.name: gliding}.__getitem__)
    monkeypatch.setattr(pieces, "START", 0)
    monkeypatch.setattr(pieces, "LENGTH", 3)
    monkeypatch.setattr(pieces, "APART", 3)
    found = pieces.measured((gliding.name, "best"))
    assert len(found) == 1 + len(pieces.CUTS)
    for tracked, confidence, filled, sure in found:
        assert 0.8 < tracked <= 1.0
        assert 0.8 < filled <= 1.0
        assert 0.0 < confidence <= 1.0
        assert 0.0 < sure <= 1.0
