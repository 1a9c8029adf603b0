"""Nodes that settle on a ring, by dense algebra, one round after the other."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array, Int64
from roam_core.geometry import polyline


def ref_settled(
    nodes: Array, samples: Array, at: Int64, expected: Array, prices: tuple[float, float], rounds: int
) -> Array:
    """`kernels.settling.settled` without a bound on how far places may move."""
    near, stretch = prices
    count, total = len(nodes), len(samples)
    place = at.astype(float)
    for _ in range(rounds):
        along = (polyline.at(samples, place + 1.5) - polyline.at(samples, place - 1.5)) / 3.0
        rows, rest = [], []
        for k in range(count):
            row = np.zeros(count)
            row[k] = np.sqrt(near) * np.hypot(*along[k])
            direction = along[k] / max(np.hypot(*along[k]), 1e-12)
            rows.append(row)
            rest.append(np.sqrt(near) * direction @ (nodes[k] - polyline.at(samples, place[k : k + 1])[0]))
        for k in range(count):
            row = np.zeros(count)
            following = (k + 1) % count
            row[following] += np.sqrt(stretch) / expected[k]
            row[k] -= np.sqrt(stretch) / expected[k]
            rows.append(row)
            rest.append(np.sqrt(stretch) / expected[k] * (expected[k] - (place[following] - place[k]) % total))
        place = place + np.linalg.lstsq(np.array(rows), np.array(rest), rcond=None)[0]
    return place
