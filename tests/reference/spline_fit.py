"""Slow, obvious twins of `roam_core.kernels.spline_fit`."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array, Bools
from roam_core.geometry import bezier


def ref_fitted(
    samples: Array,
    places: Array,
    prior: Array,
    tangents: Array,
    smooth: Bools,
    weights: tuple[float, float, float],
) -> Array:
    """Control points `(P, 3, 2)`, none tied, by dense least squares with one row for each residual."""
    count = len(prior)
    rows, wanted = [], []

    def row(terms: list[tuple[int, int, int, float]], value: float, weight: float) -> None:
        line = np.zeros((count, 3, 2))
        for point, part, axis, factor in terms:
            line[point, part, axis] += factor
        rows.append(np.sqrt(weight) * line.ravel())
        wanted.append(np.sqrt(weight) * value)

    for sample, place in zip(samples, places, strict=True):
        segment = min(int(place), count - 1)
        following = (segment + 1) % count
        b = bezier.bernstein(np.array([place - segment]))[0]
        control = [(segment, 0), (segment, 2), (following, 1), (following, 0)]
        for axis in range(2):
            row([(p, part, axis, b[k]) for k, (p, part) in enumerate(control)], sample[axis], 1.0)
    stay, hold, line_weight = weights
    for p in range(count):
        tx, ty = tangents[p]
        row([(p, 0, 0, tx), (p, 0, 1, ty)], float(tangents[p] @ prior[p, 0]), stay)
        for part in (1, 2):
            for axis in range(2):
                row([(p, part, axis, 1.0), (p, 0, axis, -1.0)], prior[p, part, axis] - prior[p, 0, axis], hold)
            if smooth[p]:
                row([(p, part, 0, -ty), (p, part, 1, tx), (p, 0, 0, ty), (p, 0, 1, -tx)], 0.0, line_weight)
    solution = np.linalg.lstsq(np.array(rows), np.array(wanted), rcond=None)[0]
    return np.asarray(solution.reshape(count, 3, 2))


def ref_nearest(line: Array, sample: Array) -> tuple[float, Array]:
    """Distance to, and position of, the nearest point of a closed polyline."""
    best, where = np.inf, line[0]
    for a, b in zip(line, np.roll(line, -1, axis=0), strict=True):
        t = np.clip((sample - a) @ (b - a) / max(float((b - a) @ (b - a)), 1e-12), 0.0, 1.0)
        foot = a + t * (b - a)
        if np.hypot(*(foot - sample)) < best:
            best, where = float(np.hypot(*(foot - sample))), foot
    return best, where
