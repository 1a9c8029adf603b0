"""Cubic segments as polylines: how many equal parameter steps each needs, and the vertices at them."""

from __future__ import annotations

import numpy as np
from numba import njit

from roam_core.arrays import Array, Indices

MOST = 4096
"""Steps of one segment, however far its handles reach."""


def step_counts(control: Array, tolerance: float) -> Indices:
    """Equal parameter steps `(S,)` that keep each segment of `control (S, 4, 2)` within `tolerance` pixels.

    From the bound on the second difference of the control polygon (Wang's formula). A segment whose handles lie on its
    anchors is straight, however unevenly it runs: one step.
    """
    counts = np.empty(len(control), dtype=np.intp)
    _step_counts(np.ascontiguousarray(control), float(tolerance), counts)
    return counts


def vertices(control: Array, counts: Indices) -> Array:
    """The vertices `(sum of counts, 2)` of segments `control (S, 4, 2)` in `counts (S,)` steps; not the last one."""
    line = np.empty((int(counts.sum()), 2))
    _vertices(np.ascontiguousarray(control), counts, line)
    return line


@njit(nogil=True, cache=True)
def _step_counts(control, tolerance, counts):  # type: ignore[no-untyped-def]
    for s in range(len(control)):
        c = control[s]
        if (c[0] == c[1]).all() and (c[2] == c[3]).all():
            counts[s] = 1
            continue
        bend = 0.0
        for k in range(2):
            x = c[k, 0] - 2.0 * c[k + 1, 0] + c[k + 2, 0]
            y = c[k, 1] - 2.0 * c[k + 1, 1] + c[k + 2, 1]
            bend = max(bend, x * x + y * y)
        steps = np.ceil(np.sqrt(0.75 * np.sqrt(bend) / tolerance))
        counts[s] = int(min(max(steps, 1.0), float(MOST)))


@njit(nogil=True, cache=True)
def _vertices(control, counts, line):  # type: ignore[no-untyped-def]
    n = 0
    for s in range(len(control)):
        for k in range(counts[s]):
            t = k / counts[s]
            u = 1.0 - t
            a, b, c, d = u * u * u, 3.0 * u * u * t, 3.0 * u * t * t, t * t * t
            for axis in range(2):
                line[n, axis] = a * control[s, 0, axis] + b * control[s, 1, axis] + c * control[s, 2, axis]
                line[n, axis] += d * control[s, 3, axis]
            n += 1
