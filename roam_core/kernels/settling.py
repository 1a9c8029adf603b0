"""Nodes on a ring that settle between its samples, each near its own place and evenly from the next."""

from __future__ import annotations

import numpy as np
from numba import njit

from roam_core.arrays import Array, Int64


def settled(
    nodes: Array,
    samples: Array,
    at: Int64,
    expected: Array,
    prices: tuple[float, float],
    rounds: int,
    loose: float,
) -> Array:
    """The places on a ring, near the samples `at`, where distance and stretching together cost least.

    The price is near |node - place|^2 for each node, and stretch ((step - expected) / expected)^2 for each step from a
    node's place to the next. It is minimised by Gauss and Newton: the ring is a straight line on each round, and the
    cyclic tridiagonal system is solved by Sherman and Morrison.

    Parameters
    ----------
    nodes : (N, 2) with N >= 2. samples : (M, 2), the ring. at : (N,) in order along it. expected : (N,) samples from
        each node's place to the next. prices : (near, stretch).
    rounds : of Gauss and Newton. loose : how many samples, at most, a place ends up from its own in `at`.

    Returns
    -------
    (N,) places: 1.5 is midway between the second and the third sample.
    """
    near, stretch = prices
    own, ring, steps = (np.ascontiguousarray(each, dtype=np.float64) for each in (nodes, samples, expected))
    return np.asarray(_settled(own, ring, steps, np.ascontiguousarray(at), near, stretch, rounds, loose))


@njit(nogil=True, cache=True)
def _settled(nodes, samples, expected, at, near, stretch, rounds, loose):  # type: ignore[no-untyped-def]
    count, total = len(nodes), len(samples)
    stiff = stretch / expected**2
    place = at.astype(np.float64)
    diagonal, right = np.empty(count), np.empty(count)
    lacking = np.empty(count)
    for _ in range(rounds):
        for k in range(count):
            lacking[k] = stiff[k] * (expected[k] - (place[(k + 1) % count] - place[k]) % total)
        for k in range(count):
            x, y = _on_ring(samples, place[k])
            behind_x, behind_y = _on_ring(samples, place[k] - 1.5)
            ahead_x, ahead_y = _on_ring(samples, place[k] + 1.5)
            along_x, along_y = (ahead_x - behind_x) / 3.0, (ahead_y - behind_y) / 3.0
            diagonal[k] = near * (along_x**2 + along_y**2) + stiff[k] + stiff[k - 1] + 1e-9
            pull = along_x * (nodes[k, 0] - x) + along_y * (nodes[k, 1] - y)
            right[k] = near * pull + lacking[k - 1] - lacking[k]
        moves = _cyclic(diagonal, -stiff, right)
        for k in range(count):
            place[k] = min(max(place[k] + moves[k], at[k] - loose), at[k] + loose)
    return place


@njit(nogil=True, cache=True)
def _on_ring(samples, place):  # type: ignore[no-untyped-def]
    before = int(np.floor(place))
    share = place - before
    a, b = before % len(samples), (before + 1) % len(samples)
    x = (1.0 - share) * samples[a, 0] + share * samples[b, 0]
    y = (1.0 - share) * samples[a, 1] + share * samples[b, 1]
    return x, y


@njit(nogil=True, cache=True)
def _cyclic(diagonal, beside, right):  # type: ignore[no-untyped-def]
    """Solves a symmetric cyclic tridiagonal system; `beside[k]` couples k with k + 1, the last with the first."""
    count = len(diagonal)
    corner = beside[count - 1]
    first = -diagonal[0]
    main = diagonal.copy()
    main[0] -= first
    main[count - 1] -= corner * corner / first
    two = np.zeros((count, 2))
    two[:, 0] = right
    two[0, 1], two[count - 1, 1] = first, two[count - 1, 1] + corner
    for k in range(1, count):
        share = beside[k - 1] / main[k - 1]
        main[k] -= share * beside[k - 1]
        two[k] -= share * two[k - 1]
    two[count - 1] /= main[count - 1]
    for k in range(count - 2, -1, -1):
        two[k] = (two[k] - beside[k] * two[k + 1]) / main[k]
    x, z = two[:, 0], two[:, 1]
    share = (x[0] + corner * x[count - 1] / first) / (1.0 + z[0] + corner * z[count - 1] / first)
    return x - share * z
