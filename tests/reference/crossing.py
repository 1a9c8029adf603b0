"""Slow, obvious twin of the crossing kernel."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray


def ref_crossing_edges(line: NDArray[Any], closed: bool) -> list[list[int]]:
    """All pairs of edges, not neighbours, whose ends lie strictly on both sides of each other."""
    ends = np.roll(line, -1, axis=0) if closed else line[1:]
    edges = list(zip(line, ends, strict=False))
    found = []
    for i, (a, b) in enumerate(edges):
        for j, (c, d) in enumerate(edges):
            if j < i + 2 or (closed and i == 0 and j == len(edges) - 1):
                continue
            if _side(a, b, c) * _side(a, b, d) < 0 and _side(c, d, a) * _side(c, d, b) < 0:
                found.append([i, j])
    return found


def _side(a: NDArray[Any], b: NDArray[Any], p: NDArray[Any]) -> float:
    return float((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]))
