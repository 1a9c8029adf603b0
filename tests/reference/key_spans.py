"""The errors of spans between two keys, slow and obvious: fit, interpolate, measure every place both ways."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array
from roam_core.kernels.key_spans import REACH


def ref_span_error(samples: Array, closed: bool, start: int, stop: int, *, cubic: bool) -> float:
    """Largest distance between the outlines `samples (F, C, S, 2)` inside a span and the interpolated ones.

    A cubic is looked at on every quarter of a frame, between the outlines of the two frames about it.
    """
    if stop - start < 2:
        return 0.0
    span = samples[start : stop + 1]
    at = np.arange(0.25 if cubic else 1.0, stop - start, 0.25 if cubic else 1.0)
    truth = np.stack([(1 - m % 1) * span[int(m)] + m % 1 * span[int(np.ceil(m))] for m in at])
    between = ref_interpolated(span, at, cubic=cubic)
    distances = [ref_distances(truth, between, closed), ref_distances(between, truth, closed)]
    return float(np.max(distances))


def ref_interpolated(samples: Array, at: Array, *, cubic: bool) -> Array:
    """A span at the moments `at`, frames from its begin, by the two frames at its ends, and by slopes fitted to all."""
    last = len(samples) - 1
    if not cubic:
        return _straight(samples, at / last)
    u = np.arange(last + 1) / last
    strays = (samples - _straight(samples, u)).reshape(last + 1, -1)
    slopes = np.linalg.lstsq(_hermite(u), strays, rcond=1e-6)[0]
    return _straight(samples, at / last) + (_hermite(at / last) @ slopes).reshape(len(at), *samples.shape[1:])


def _straight(samples: Array, u: Array) -> Array:
    return np.asarray((1 - u)[:, None, None, None] * samples[0] + u[:, None, None, None] * samples[-1])


def _hermite(u: Array) -> Array:
    return np.stack([u * (1 - u) ** 2, -(u**2) * (1 - u)], axis=1)


def ref_distances(places: Array, others: Array, closed: bool) -> Array:
    """Distance from each of `places (F, C, S, 2)` to the edges of `others` about the same place."""
    result = np.empty(places.shape[:3])
    count = places.shape[2]
    reach = min(REACH, count // 2)
    for f, c, s in np.ndindex(*result.shape):
        line, place = others[f, c], places[f, c, s]
        candidates = [np.hypot(*(line[s] - place))]
        for edge in range(s - reach, s + reach):
            if closed or 0 <= edge < count - 1:
                candidates.append(_to_segment(place, line[edge % count], line[(edge + 1) % count]))
        result[f, c, s] = min(candidates)
    return result


def _to_segment(place: Array, a: Array, b: Array) -> float:
    along = b - a
    t = 0.0 if not along.any() else float(np.clip((place - a) @ along / (along @ along), 0.0, 1.0))
    return float(np.hypot(*(a + t * along - place)))
