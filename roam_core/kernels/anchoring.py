"""Where on an outline the anchors of a spline follow it best: dynamic programming over the error of each piece."""

from __future__ import annotations

import numpy as np
from numba import njit

from roam_core.arrays import Array, Bools, Int64


def anchored(
    samples: Array, places: Int64, price: Array, straight: Bools, looked_at: int, hold: float
) -> tuple[Int64, float]:
    """One of C places for each anchor, in order, that minimise the pieces' errors and the prices of the places.

    The error of a piece is the integral, over its length, of the squared distance to the cubic that follows it best by
    chord length; of a `straight` piece, to its chord. Exact, the first anchor staying on the first of its places.

    Parameters
    ----------
    samples : (M, 2) the outline at equal steps, pixels.
    places : (P, C) for each anchor the samples it may lie on; they run on past M instead of starting again.
    price : (P, C) what each place costs, in the error's unit, px^3.
    straight : (P,) which pieces, from each anchor to the next, have no handles.
    looked_at : samples of a piece at which its error is measured, at most.
    hold : weight, against one sample, that draws handles to the straight line.

    Returns
    -------
    (P,) sample indices, rising, the last less than M beyond the first; and the minimum, infinite where no choice of
    places keeps the order.
    """
    if places.shape != price.shape or len(places) != len(straight):
        raise ValueError(f"{places.shape} places, {price.shape} prices and {len(straight)} pieces do not match")
    step = float(np.hypot(*(samples[1] - samples[0])))
    chosen = np.zeros(len(places), dtype=np.int64)
    least = _anchored(
        np.ascontiguousarray(samples, dtype=np.float64),
        np.ascontiguousarray(places, dtype=np.int64),
        np.ascontiguousarray(price, dtype=np.float64),
        np.ascontiguousarray(straight),
        step,
        looked_at,
        hold,
        chosen,
    )
    return np.take_along_axis(places, chosen[:, None], axis=1)[:, 0], float(least)


@njit(nogil=True, cache=True)
def _error(samples, first, last, straight, step, looked_at, hold):  # type: ignore[no-untyped-def]
    """Integral of the squared distance of a piece of the outline to its cubic, as the mean over a few samples."""
    total, steps = len(samples), last - first
    ax, ay = samples[first % total]
    dx, dy = samples[last % total][0] - ax, samples[last % total][1] - ay
    count = min(steps - 1, looked_at)
    if count <= 0:
        return 0.0
    uu = uv = vv = ux = uy = vx = vy = rr = 0.0
    for k in range(count):
        offset = (k + 1) * steps // (count + 1)
        t = offset / steps
        x, y = samples[(first + offset) % total]
        s = 1.0 - t
        u, v = 3.0 * s * s * t, 3.0 * s * t * t
        # From the straight cubic, whose handles lie at thirds of the chord.
        rx, ry = x - ax - t * dx, y - ay - t * dy
        rr += rx * rx + ry * ry
        uu += u * u
        uv += u * v
        vv += v * v
        ux += u * rx
        uy += u * ry
        vx += v * rx
        vy += v * ry
    if straight:
        return rr / count * steps * step
    uu, vv = uu + hold, vv + hold
    determinant = uu * vv - uv * uv
    px, py = (ux * vv - vx * uv) / determinant, (uy * vv - vy * uv) / determinant
    qx, qy = (vx * uu - ux * uv) / determinant, (vy * uu - uy * uv) / determinant
    rest = rr - px * ux - py * uy - qx * vx - qy * vy
    return max(rest, 0.0) / count * steps * step


@njit(nogil=True, cache=True)
def _anchored(samples, places, price, straight, step, looked_at, hold, chosen):  # type: ignore[no-untyped-def]
    count, choices = places.shape
    start = places[0, 0]
    reach, following = np.full(choices, np.inf), np.empty(choices)
    parents = np.zeros((count, choices), dtype=np.int32)
    reach[0] = price[0, 0]
    for n in range(1, count):
        for c in range(choices):
            following[c] = np.inf
            here = places[n, c]
            if here <= start or here >= start + len(samples):
                continue
            for b in range(choices):
                if reach[b] + price[n, c] >= following[c] or places[n - 1, b] >= here:
                    continue
                error = _error(samples, places[n - 1, b], here, straight[n - 1], step, looked_at, hold)
                value = reach[b] + price[n, c] + error
                if value < following[c]:
                    following[c] = value
                    parents[n, c] = b
        reach[:] = following
    least, end = np.inf, 0
    for c in range(choices):
        if reach[c] == np.inf:
            continue
        last = places[count - 1, c]
        value = reach[c] + _error(samples, last, start + len(samples), straight[count - 1], step, looked_at, hold)
        if value < least:
            least, end = value, c
    for n in range(count - 1, -1, -1):
        chosen[n] = end
        end = parents[n, end]
    return least
