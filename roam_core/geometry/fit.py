"""Few-point Bezier splines fitted to dense polylines: corners kept, tangents continuous elsewhere."""

from __future__ import annotations

import math

import numpy as np

from roam_core.arrays import Array, Indices
from roam_core.geometry import polyline
from roam_core.geometry.bezier import bernstein
from roam_core.params import CURVE_FIT


def fit_closed(line: Array, tolerance: float = 1.0) -> Array:
    """A closed spline `(P, 3, 2)` of few points within about `tolerance` pixels of the closed polyline `line (K, 2)`.

    The outline is cut at its corners (`roam_core.params.CurveFitParams`); each piece is fitted by least squares with
    reparametrisation and halved where it strays most, with a common tangent at the cut (Schneider, "An Algorithm for
    Automatically Fitting Digitized Curves", Graphics Gems, 1990). A piece from corner to corner that is straight within
    half the tolerance becomes straight: the tangents that pixels show at a corner would bend it.
    """
    perimeter = max(polyline.length(line), float(np.finfo(np.float64).tiny))
    count = max(16, round(perimeter / CURVE_FIT.step))
    dense = polyline.resample(line, count)
    step = perimeter / count
    cuts = corners(dense, max(2, round(min(CURVE_FIT.reach, perimeter / 12) / step)), np.radians(CURVE_FIT.corner))
    sharp = len(cuts) > 0
    if not sharp:
        cuts = np.array([int(np.argmax(((dense - dense.mean(axis=0)) ** 2).sum(axis=1)))])
    sigma = min(CURVE_FIT.softness / step, float(count))  # over all of a ring, however small, and not around it again
    smooth = _smoothed(dense, cuts if sharp else np.empty(0, dtype=int), sigma)
    pieces: list[Array] = []
    for k, start in enumerate(cuts):
        stop = cuts[(k + 1) % len(cuts)]
        index = np.arange(start, stop + 1 if stop > start else stop + count + 1) % count
        run = smooth[index]
        if sharp and off_chord(run) <= tolerance / 2.0:
            pieces.append(straight(run[0], run[-1]))
            continue
        if sharp:
            ends = end_tangent(run), -end_tangent(run[::-1])
        else:
            tangent = centre_tangent(np.vstack([run[-6:-1], run[:6]]), 5)
            ends = tangent, tangent
        pieces.extend(fit_run(run, ends[0], ends[1], tolerance))
    return joined(pieces)


def chained(pieces: list[Array]) -> Array:
    """Cubic pieces `(4, 2)` one after the other as spline points; the handles beyond the ends lie on the anchors."""
    points = np.empty((len(pieces) + 1, 3, 2))
    points[0, :2], points[-1, [0, 2]] = pieces[0][0], pieces[-1][3]
    for k, piece in enumerate(pieces):
        points[k, 0], points[k, 2], points[k + 1, 1] = piece[0], piece[1], piece[2]
    return points


def smoothed_open(line: Array, sigma: float) -> Array:
    """A Gaussian of `sigma` samples along an open line, whose ends stay: beyond them it goes on point-symmetrically."""
    if len(line) < 3:
        return line
    radius = min(int(np.ceil(3 * sigma)), len(line) - 1)
    kernel = np.exp(-0.5 * (np.arange(-radius, radius + 1) / sigma) ** 2)
    before, after = 2.0 * line[0] - line[radius:0:-1], 2.0 * line[-1] - line[-2 : -radius - 2 : -1]
    padded = np.concatenate([before, line, after])
    weights = kernel / kernel.sum()
    soft = np.stack([np.convolve(padded[:, axis], weights, mode="valid") for axis in range(2)], axis=1)
    soft[0], soft[-1] = line[0], line[-1]
    return soft


def off_chord(run: Array) -> float:
    """The furthest that a run strays from the straight line between its ends."""
    chord = run[-1] - run[0]
    along = _unit(chord)
    foot = np.clip((run - run[0]) @ along, 0.0, np.hypot(*chord))
    return float(np.hypot(*(run - run[0] - foot[:, None] * along).T).max())


def straight(start: Array, end: Array) -> Array:
    """The straight cubic `(4, 2)` from one place to another."""
    return start + np.linspace(0.0, 1.0, 4)[:, None] * (end - start)


def joined(pieces: list[Array]) -> Array:
    """Cubic pieces `(4, 2)` in a ring as spline points; a ring of fewer than three is halved until it has three."""
    while len(pieces) < 3:
        pieces = [half for piece in pieces for half in _halves(piece)]
    points = np.empty((len(pieces), 3, 2))
    for k, piece in enumerate(pieces):
        points[k, 0], points[k, 2] = piece[0], piece[1]
        points[(k + 1) % len(pieces), 1] = piece[2]
    return points


def _halves(piece: Array) -> tuple[Array, Array]:
    a, b, c, d = piece
    ab, bc, cd = (a + b) / 2, (b + c) / 2, (c + d) / 2
    abc, bcd = (ab + bc) / 2, (bc + cd) / 2
    middle = (abc + bcd) / 2
    return np.stack([a, ab, abc, middle]), np.stack([middle, bcd, cd, d])


def corners(line: Array, reach: int, angle: float) -> Indices:
    """Indices where the outline turns by more than `angle` between the chords of `reach` samples on both sides."""
    back, ahead = line - np.roll(line, reach, axis=0), np.roll(line, -reach, axis=0) - line
    cross = back[:, 0] * ahead[:, 1] - back[:, 1] * ahead[:, 0]
    turn = np.abs(np.arctan2(cross, (back * ahead).sum(axis=1)))
    neighbourhood = np.stack([np.roll(turn, k) for k in range(-reach, reach + 1)])
    peak = (turn >= neighbourhood.max(axis=0)) & (turn > angle)
    found = np.flatnonzero(peak)
    if len(found) < 2:
        return found
    return found[np.diff(np.append(found, found[0] + len(line))) > reach // 2]


def _smoothed(line: Array, corners: Indices, sigma: float) -> Array:
    """A Gaussian of `sigma` samples along the outline takes the pixel stairs off; near corners it fades out."""
    radius = int(np.ceil(3 * sigma))
    offsets = np.arange(-radius, radius + 1)
    kernel = np.exp(-0.5 * (offsets / sigma) ** 2)
    kernel /= kernel.sum()
    soft = sum(w * np.roll(line, -k, axis=0) for k, w in zip(offsets, kernel, strict=True))
    if len(corners) == 0:
        return np.asarray(soft)
    index = np.arange(len(line))
    gap = np.abs(index[:, None] - corners[None])
    distance = np.minimum(gap, len(line) - gap).min(axis=1)
    fade = np.clip(distance / (2.0 * radius), 0.0, 1.0)[:, None]
    return np.asarray(fade * soft + (1.0 - fade) * line)


def end_tangent(run: Array) -> Array:
    """The unit direction in which a run begins."""
    span = min(len(run) - 1, 6)
    return _unit(run[span] - run[0])


def centre_tangent(run: Array, index: int) -> Array:
    """The unit direction of a run at one of its samples, by those on both sides."""
    span = min(5, index, len(run) - 1 - index)
    return _unit(run[index + span] - run[index - span])


def _unit(vector: Array) -> Array:
    return np.asarray(vector / max(float(np.hypot(*vector)), 1e-12))


def fit_run(run: Array, start: Array, end: Array, tolerance: float, depth: int = 0) -> list[Array]:
    """Cubics along `run (K, 2)` that leave along `start` and arrive along `end`."""
    chord = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(run, axis=0).T))])
    if len(run) < 4 or chord[-1] < 1.5:
        third = chord[-1] / 3.0
        return [np.stack([run[0], run[0] + start * third, run[-1] - end * third, run[-1]])]
    t, arc = chord / chord[-1], float(chord[-1])
    weights = bernstein(t)
    piece = _fit_cubic(run, weights, start, end, arc)
    error, worst = _stray(run, weights, piece)
    for _ in range(6):
        if error <= tolerance or error > 16 * tolerance:
            break
        t = _reparametrised(run, t, weights, piece)
        weights = bernstein(t)
        piece = _fit_cubic(run, weights, start, end, arc)
        error, worst = _stray(run, weights, piece)
    if error <= tolerance or depth > 24:
        return [piece]
    middle = int(np.clip(worst, 2, len(run) - 3)) if len(run) > 5 else len(run) // 2
    tangent = centre_tangent(run, middle)
    return [
        *fit_run(run[: middle + 1], start, tangent, tolerance, depth + 1),
        *fit_run(run[middle:], tangent, end, tolerance, depth + 1),
    ]


def _fit_cubic(run: Array, weights: Array, start: Array, end: Array, arc: float) -> Array:
    """Least squares for the two handle lengths along the given unit tangents; `arc` is the run's length."""
    first, last = weights[:, 1], weights[:, 2]
    rest = run - np.outer(weights[:, 0] + first, run[0]) - np.outer(last + weights[:, 3], run[-1])
    aa, bb, ab = float(first @ first), float(last @ last), -float(first @ last) * float(start @ end)
    ra, rb = float(first @ rest @ start), -float(last @ rest @ end)
    determinant = aa * bb - ab * ab
    chord = run[-1] - run[0]
    length = math.hypot(chord[0], chord[1])
    if determinant > 1e-12:
        alpha, beta = (ra * bb - rb * ab) / determinant, (aa * rb - ab * ra) / determinant
    else:
        alpha = beta = 0.0
    if not (0.02 * length < alpha <= arc and 0.02 * length < beta <= arc):
        alpha = beta = min(length, arc) / 3.0
    return np.stack([run[0], run[0] + alpha * start, run[-1] - beta * end, run[-1]])


def _stray(run: Array, weights: Array, piece: Array) -> tuple[float, int]:
    off = weights @ piece - run
    distance = np.einsum("kc,kc->k", off, off)
    worst = int(np.argmax(distance))
    return math.sqrt(float(distance[worst])), worst


def _reparametrised(run: Array, t: Array, weights: Array, piece: Array) -> Array:
    """One Newton step of every sample's parameter towards the nearest point of the cubic."""
    s = 1.0 - t
    legs = piece[1:] - piece[:-1]
    bends = legs[1:] - legs[:-1]
    d1 = np.outer(3 * s * s, legs[0]) + np.outer(6 * s * t, legs[1]) + np.outer(3 * t * t, legs[2])
    d2 = np.outer(6 * s, bends[0]) + np.outer(6 * t, bends[1])
    off = weights @ piece - run
    slope = np.einsum("kc,kc->k", d1, d1) + np.einsum("kc,kc->k", off, d2)
    step = np.divide(np.einsum("kc,kc->k", off, d1), slope, out=np.zeros_like(t), where=np.abs(slope) > 1e-9)
    moved = np.minimum(np.maximum(t - step, 0.0), 1.0)
    moved[0], moved[-1] = 0.0, 1.0
    return np.maximum.accumulate(moved)
