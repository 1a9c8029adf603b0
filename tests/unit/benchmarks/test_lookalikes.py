"""The benchmark of lookalikes: where the copy lies, and that it runs."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks import lookalikes, shots
from benchmarks.lookalikes import Run, measured, with_copy
from benchmarks.shots import Shot


@pytest.mark.parametrize("dtype", [np.uint8, np.float32])
def test_a_copy_lies_behind_its_object(dtype: type) -> None:
    mask = np.zeros((60, 120), dtype=bool)
    mask[20:40, 30:60] = True
    picture = np.where(mask[..., None], 200, 40).repeat(3, axis=2).astype(dtype)
    picture[20:40, 30:60, 0] = 10 + np.arange(30)
    mixed = with_copy(picture, mask, 20)
    assert mixed.dtype == dtype
    np.testing.assert_array_equal(mixed[mask], picture[mask])
    np.testing.assert_allclose(mixed[24:36, 64:76], picture[24:36, 44:56], atol=1)
    np.testing.assert_allclose(mixed[:, 90:], picture[:, 90:], atol=1)
    np.testing.assert_allclose(with_copy(picture, mask, -40)[24:36, 4:16], picture[24:36, 44:56], atol=1)


@pytest.mark.parametrize(("left", "side"), [(10, 1), (80, -1)])
def test_a_copy_lies_where_there_is_more_room(left: int, side: int) -> None:
    mask = np.zeros((60, 120), dtype=bool)
    mask[20:40, left : left + 30] = True
    assert lookalikes._offset(mask, 1.5) == side * 45


def test_a_copy_that_comes_near_ends_beside_the_object() -> None:
    away = lookalikes.AWAY["comes near"]
    assert away(0) == lookalikes.FAR
    assert away(lookalikes.LENGTH) == pytest.approx(lookalikes.NEAR)


@pytest.mark.parametrize("copy", [None, *lookalikes.AWAY])
def test_a_shot_is_scored_beside_its_copy(copy: str | None, monkeypatch: pytest.MonkeyPatch, gliding: Shot) -> None:
    monkeypatch.setattr(shots, "load", {gliding.name: gliding}.__getitem__)
    monkeypatch.setattr(lookalikes, "LENGTH", 3)
    assert 0.5 < measured((Run(gliding.name, 0, copy), "best")) <= 1.0
