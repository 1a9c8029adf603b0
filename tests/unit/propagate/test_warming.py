"""Warming up: nothing stays of it but compiled kernels, and it comes to those that a figure in parts needs."""

from __future__ import annotations

from typing import Any

import pytest

from roam_core.arrays import Array
from roam_core.kernels.posing import Samples, View, refined
from roam_core.motion import pose
from roam_core.params import CONFIGS
from roam_core.propagate import warm_up, warm_up_parts


@pytest.mark.parametrize("config", list(CONFIGS))
def test_it_leaves_nothing_behind(config: str) -> None:
    before = dict(CONFIGS)
    warm_up(config)
    warm_up_parts(config)
    assert before == CONFIGS


def test_parts_move_each_by_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    """The figure moved as one piece: no pose was solved, and the first track of parts compiled for long."""
    solved: list[int] = []

    def counted(view: View, samples: Samples, bones: Array, *others: Any) -> tuple[Array, float]:
        solved.append(len(bones))
        return refined(view, samples, bones, *others)

    monkeypatch.setattr(pose, "refined", counted)
    warm_up_parts()
    assert solved
