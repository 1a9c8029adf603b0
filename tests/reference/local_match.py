"""Slow, obvious twins of the region kernels."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from roam_core.arrays import Array


def ref_local_match(
    colours: NDArray[Any], memory: NDArray[Any], labels: NDArray[Any], shift: NDArray[Any], radius: int, sigma: float,
    spread: float, clip: float,
) -> Array:  # fmt: skip
    """The log-ratio of every pixel, by looking through the window with no trick."""
    rows, columns = labels.shape
    ratio = np.zeros((rows, columns))
    for y, x in product(range(rows), range(columns)):
        cx, cy = int(np.round(x + shift[y, x, 0])), int(np.round(y + shift[y, x, 1]))
        nearest = {0: np.inf, 1: np.inf}
        for v, u in product(range(rows), range(columns)):
            if abs(v - cy) > radius or abs(u - cx) > radius or labels[v, u] == 2:
                continue
            distance = ((colours[y, x] - memory[v, u]) ** 2).sum() + spread * ((v - cy) ** 2 + (u - cx) ** 2)
            nearest[int(labels[v, u])] = min(nearest[int(labels[v, u])], float(distance))
        if np.isinf(nearest[0]) and np.isinf(nearest[1]):
            continue
        enough = 4 * sigma**2 * clip
        value = (min(nearest[0], enough) - min(nearest[1], enough)) / (2 * sigma**2)
        ratio[y, x] = np.clip(value, -clip, clip)
    return ratio


def smoothing_energy(
    x: NDArray[Any], field: NDArray[Any], colours: NDArray[Any], strength: float, contrast: float
) -> float:
    """What `diffuse` lowers, summed directly."""
    total = float(((x - field) ** 2).sum())
    for axis in (0, 1):
        weight = strength * np.exp(-(np.diff(colours, axis=axis) ** 2).sum(axis=2) / (2 * contrast**2))
        total += float((weight * np.diff(x, axis=axis) ** 2).sum())
    return total


def ref_align(cost: NDArray[Any], expected: NDArray[Any], stretch: float, starts: list[int]) -> float:
    """The least cost of going once around, over all step sequences; for a handful of nodes."""
    count, samples = cost.shape
    best = np.inf
    for start in starts:
        for steps in product(range(1, samples), repeat=count - 1):
            last = samples - sum(steps)
            if last < 1 or any(step > np.ceil(4 * e) + 1 for step, e in zip(steps, expected, strict=False)):
                continue
            places = (start + np.concatenate([[0], np.cumsum(steps)])) % samples
            ratios = np.array([*steps, last]) / expected - 1.0
            best = min(best, float(cost[np.arange(count), places].sum() + stretch * (ratios**2).sum()))
    return best
