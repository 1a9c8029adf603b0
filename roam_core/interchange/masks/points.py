"""Few points for all frames of a part together: where corners are, and where one cubic no longer does on some frame."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from roam_core.arrays import Array, Bools, Int64
from roam_core.geometry import polyline
from roam_core.kernels.mask_fit import best_cubic, runs_beyond

FINE = 3
"""Samples of a ring for each of its nodes."""
CORNER = np.radians(50.0)
"""An outline that turns by as much within ..."""
REACH = 4
"""... so many samples to both sides ..."""
OFTEN = 0.5
"""... on this share of the frames has a corner there."""
LONGEST = 120
"""Samples of a segment at most."""
HALVINGS = 6
"""Rounds in which the segments between two corners are evened out."""


def dense(rings: list[Array], places: list[Array]) -> Array:
    """The same samples `(F, FINE N, 2)` of the rings of all frames, the stairs of pixels taken off a little."""
    found = []
    for ring, at in zip(rings, places, strict=True):
        ahead = np.append(at[1:], at[0] + len(ring)) - at
        fine = (at[:, None] + ahead[:, None] * (np.arange(FINE) / FINE)).ravel()
        line = polyline.at(ring, fine)
        found.append((polyline.preceding(line) + 2.0 * line + polyline.following(line)) / 4.0)
    return np.stack(found)


def chosen(samples: Array, tolerance: float, share: float, checked: Callable[[], None]) -> tuple[Int64, Bools]:
    """The samples `(P,)`, rising, at which points stand, and which of them are smooth.

    Each segment between two of them is within `tolerance` of a cubic on all frames but a `share` of them.
    """
    corners = _corners(samples)
    seldom = int(share * len(samples))
    total = samples.shape[1]
    cuts = corners if len(corners) else np.array([_farthest_out(samples)])
    found: list[int] = []
    for k, start in enumerate(cuts):
        checked()
        length = int((cuts[(k + 1) % len(cuts)] - start - 1) % total + 1)
        found.extend((start + step) % total for step in _evened(samples, int(start), length, tolerance, seldom))
    at = np.unique(found)
    while len(at) < 4:
        gaps = np.diff(np.append(at, at[0] + total))
        widest = int(np.argmax(gaps))
        at = np.unique(np.append(at, (at[widest] + gaps[widest] // 2) % total))
    return at.astype(np.int64), ~np.isin(at, corners)


def curves(samples: Array, at: Int64) -> Array:
    """Splines `(F, P, 3, 2)` through the samples at `at (P,)`, each segment fitted by itself."""
    frames, total = samples.shape[:2]
    points = np.empty((frames, len(at), 3, 2))
    control = np.empty((4, 2))
    for k, start in enumerate(at):
        following = (k + 1) % len(at)
        index = (start + np.arange((at[following] - start - 1) % total + 2)) % total
        for frame in range(frames):
            best_cubic(np.ascontiguousarray(samples[frame, index]), control)
            points[frame, k, 0], points[frame, k, 2], points[frame, following, 1] = control[:3]
    return points


def _corners(samples: Array) -> Int64:
    back, ahead = samples - np.roll(samples, REACH, axis=1), np.roll(samples, -REACH, axis=1) - samples
    cross = back[..., 0] * ahead[..., 1] - back[..., 1] * ahead[..., 0]
    turn = np.abs(np.arctan2(cross, (back * ahead).sum(axis=2)))
    near = np.max([np.roll(turn, k, axis=1) for k in (-1, 0, 1)], axis=0)
    often = (near > CORNER).mean(axis=0) + 1e-3 * near.mean(axis=0)
    around = np.max([np.roll(often, k) for k in range(-REACH, REACH + 1)], axis=0)
    found = np.flatnonzero((often >= around) & (often > OFTEN))
    return found[np.diff(np.append(found, found[:1] + len(often))) > REACH // 2] if len(found) > 1 else found


def _farthest_out(samples: Array) -> int:
    """The sample that lies farthest from the middle on the average frame."""
    away = samples - samples.mean(axis=1, keepdims=True)
    return int(np.argmax(np.hypot(away[..., 0], away[..., 1]).mean(axis=0)))


def _evened(samples: Array, start: int, length: int, tolerance: float, seldom: int) -> list[int]:
    """Steps from `start` at which segments begin: as few as the tolerance asks for, none worse than it has to be."""
    best = _greedy(samples, start, length, tolerance, seldom)
    low, high = 0.0, tolerance
    for _ in range(HALVINGS if len(best) > 1 else 0):
        middle = 0.5 * (low + high)
        found = _greedy(samples, start, length, middle, seldom, len(best))
        if len(found) > len(best):
            low = middle
        else:
            best, high = found, middle
    return best


def _greedy(samples: Array, start: int, length: int, tolerance: float, seldom: int, most: int = 1 << 30) -> list[int]:
    """Segments as long as they can be, one after the other; given up when there are more than `most`."""
    steps, at = [0], 0
    while True:
        good, bad = 1, min(length - at, LONGEST) + 1
        while bad - good > 1:
            middle = (good + bad) // 2
            if runs_beyond(samples, start + at, middle, tolerance, seldom) <= seldom:
                good = middle
            else:
                bad = middle
        at += good
        if at >= length:
            return steps
        steps.append(at)
        if len(steps) > most:
            return steps
