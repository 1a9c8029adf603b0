"""Regions of like colour: as large as they get before they leak out."""

from __future__ import annotations

import numpy as np

from roam_core.proposal.assist.growing import grown


def squares(inner: int, outer: int) -> np.ndarray:
    """A square of 40 x 40 on background, grey values; with a little grain."""
    picture = np.full((100, 140, 3), outer, dtype=np.int64)
    picture[30:70, 50:90] = inner
    picture += np.random.default_rng(2).integers(-2, 3, (100, 140, 1))
    return picture.astype(np.uint8)


def test_a_square_is_grown_whole() -> None:
    region = grown(squares(160, 60), (60, 40))
    assert region is not None
    assert region[30:70, 50:90].mean() > 0.98
    assert region.sum() < 1.1 * 40 * 40


def test_a_faint_square_does_not_leak() -> None:
    """Within the larger distances the background looks alike."""
    region = grown(squares(120, 90), (60, 40))
    assert region is not None
    assert region.sum() < 1.1 * 40 * 40


def test_endless_background_has_no_region() -> None:
    assert grown(np.full((100, 140, 3), 80, dtype=np.uint8), (60, 40)) is None
