"""Splines fitted to outlines of masks through time: normal equations of many frames at once, and honest distances."""

from __future__ import annotations

import numpy as np
from numba import njit

AROUND = 24
"""Edges that are looked at for the nearest one of a place when one near enough is among them."""

FINE = 8
"""Vertices of a segment at which the curve is compared with an outline."""


@njit(nogil=True, cache=True)
def drawn(points):  # type: ignore[no-untyped-def]
    """The closed spline `points (P, 3, 2)` as `(FINE P, 2)` vertices."""
    count = len(points)
    line = np.empty((FINE * count, 2))
    for i in range(count):
        j = (i + 1) % count
        for k in range(FINE):
            t = k / FINE
            s = 1.0 - t
            a, b, c, d = s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t
            for axis in range(2):
                line[FINE * i + k, axis] = (
                    a * points[i, 0, axis] + b * points[i, 2, axis] + c * points[j, 1, axis] + d * points[j, 0, axis]
                )
    return line


@njit(nogil=True, cache=True)
def _to_edge(x, y, ax, ay, bx, by):  # type: ignore[no-untyped-def]
    """Squared distance from (x, y) to an edge, and where along it the foot lies."""
    dx, dy = bx - ax, by - ay
    square = dx * dx + dy * dy
    t = 0.0
    if square > 0.0:
        t = min(max(((x - ax) * dx + (y - ay) * dy) / square, 0.0), 1.0)
    return (ax + t * dx - x) ** 2 + (ay + t * dy - y) ** 2, t


@njit(nogil=True, cache=True)
def _unit_tangent(line, k):  # type: ignore[no-untyped-def]
    total = len(line)
    dx, dy = line[(k + 1) % total, 0] - line[k, 0], line[(k + 1) % total, 1] - line[k, 1]
    norm = max(np.sqrt(dx * dx + dy * dy), 1e-12)
    return dx / norm, dy / norm


@njit(nogil=True, cache=True)
def put_on(line, samples, tangents, places, window, turn, squares):  # type: ignore[no-untyped-def]
    """Move the `places (M,)` of `samples (M, 2)` on the closed `line (L, 2)` to the nearest edges that run their way.

    Places are counted in vertices; `window` of them are looked at on both sides. `squares (M,)` receives the squared
    distances.
    """
    total = len(line)
    for m in range(len(samples)):
        x, y = samples[m, 0], samples[m, 1]
        middle = int(np.floor(places[m]))
        least, best, found = np.inf, places[m], 0.0
        for step in range(-window, window + 1):
            k = (middle + step) % total
            ax, ay, bx, by = line[k, 0], line[k, 1], line[(k + 1) % total, 0], line[(k + 1) % total, 1]
            square, t = _to_edge(x, y, ax, ay, bx, by)
            if square >= least:
                continue
            tx, ty = _unit_tangent(line, k)
            price = square + turn * (1.0 - tx * tangents[m, 0] - ty * tangents[m, 1])
            if price < least:
                least, best, found = price, (k + t) % total, square
        places[m], squares[m] = best, found


@njit(nogil=True, cache=True)
def segment_sums(samples, tangents, places, weights, count, along, matrices, vectors):  # type: ignore[no-untyped-def]
    """Normal equations of samples against the segments that they lie on, each an 8 x 8 block over its control points.

    The distance across the outline counts fully, along it `along`. `matrices (P, 8, 8)` and `vectors (P, 8)` are
    overwritten; unknowns are x and y of anchor, out-handle, next in-handle, next anchor.
    """
    matrices[:] = 0.0
    vectors[:] = 0.0
    basis = np.empty(4)
    for m in range(len(samples)):
        place = places[m] / FINE
        segment = min(int(place), count - 1)
        t = place - segment
        s = 1.0 - t
        basis[0], basis[1], basis[2], basis[3] = s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t
        tx, ty = tangents[m, 0], tangents[m, 1]
        w = weights[m]
        xx, yy = w * (ty * ty + along * tx * tx), w * (tx * tx + along * ty * ty)
        xy = w * (along - 1.0) * tx * ty
        rx, ry = xx * samples[m, 0] + xy * samples[m, 1], xy * samples[m, 0] + yy * samples[m, 1]
        for i in range(4):
            vectors[segment, 2 * i] += basis[i] * rx
            vectors[segment, 2 * i + 1] += basis[i] * ry
            for j in range(4):
                product = basis[i] * basis[j]
                matrices[segment, 2 * i, 2 * j] += product * xx
                matrices[segment, 2 * i, 2 * j + 1] += product * xy
                matrices[segment, 2 * i + 1, 2 * j] += product * xy
                matrices[segment, 2 * i + 1, 2 * j + 1] += product * yy


@njit(nogil=True, cache=True)
def _slot(order, keys, point, part, key, axis):  # type: ignore[no-untyped-def]
    return ((order[point] * keys + key) * 3 + part) * 2 + axis


@njit(nogil=True, cache=True)
def add_segments(matrices, vectors, left, right, share, fixed, order, keys, band, side):  # type: ignore[no-untyped-def]
    """Add a frame's blocks to the lower band of all keys' equations.

    The frame lies `share` of the way from key `left` to key `right`; numbers below 0 stand for keys that are fixed,
    whose points are `fixed (2, P, 3, 2)`. `order (P,)` is the place of each point among the unknowns.
    """
    count = len(matrices)
    part = np.array([0, 2, 1, 0])
    key, factor = np.array([left, right]), np.array([1.0 - share, share])
    for i in range(count):
        point = np.array([i, i, (i + 1) % count, (i + 1) % count])
        for one in range(2):
            if key[one] < 0 or factor[one] == 0.0:
                continue
            for a in range(8):
                row = _slot(order, keys, point[a // 2], part[a // 2], key[one], a % 2)
                side[row] += factor[one] * vectors[i, a]
                for other in range(2):
                    if factor[other] == 0.0:
                        continue
                    scale = factor[one] * factor[other]
                    for b in range(8):
                        value = scale * matrices[i, a, b]
                        if key[other] < 0:
                            side[row] -= value * fixed[other, point[b // 2], part[b // 2], b % 2]
                            continue
                        column = _slot(order, keys, point[b // 2], part[b // 2], key[other], b % 2)
                        if row >= column:
                            band[row - column, column] += value


@njit(nogil=True, cache=True)
def add_points(points, smooth, key, weights, order, keys, band, side):  # type: ignore[no-untyped-def]
    """Add what ties the points of one key `(P, 3, 2)` themselves.

    `weights` are (line, third, stay): handles of `smooth (P,)` points off their common line; handles longer or shorter
    than a third of their segments; all control points off where they are.
    """
    line, third, stay = weights
    count = len(points)
    index, value = np.empty(4, dtype=np.int64), np.empty(4)
    for p in range(count):
        for axis in range(2):
            for part in range(3):
                k = _slot(order, keys, p, part, key, axis)
                band[0, k] += stay
                side[k] += stay * points[p, part, axis]
        dx, dy = points[p, 2, 0] - points[p, 1, 0], points[p, 2, 1] - points[p, 1, 1]
        norm = np.sqrt(dx * dx + dy * dy)
        for part in (1, 2):
            hx, hy = points[p, part, 0] - points[p, 0, 0], points[p, part, 1] - points[p, 0, 1]
            reach = np.sqrt(hx * hx + hy * hy)
            other = (p + 1) % count if part == 2 else (p - 1 + count) % count
            cx, cy = points[other, 0, 0] - points[p, 0, 0], points[other, 0, 1] - points[p, 0, 1]
            chord = np.sqrt(cx * cx + cy * cy)
            for axis in range(2):
                index[axis] = _slot(order, keys, p, part, key, axis)
                index[2 + axis] = _slot(order, keys, p, 0, key, axis)
            if reach > 1e-6:
                ux, uy = hx / reach, hy / reach
            elif chord > 1e-6:
                ux, uy = cx / chord, cy / chord
            else:
                continue
            value[0], value[1], value[2], value[3] = ux, uy, -ux, -uy
            _add(index, value, chord / 3.0, third, band, side)
            if smooth[p] and norm > 1e-6:
                nx, ny = -dy / norm, dx / norm
                value[0], value[1], value[2], value[3] = nx, ny, -nx, -ny
                _add(index, value, 0.0, line, band, side)


@njit(nogil=True, cache=True)
def add_anchors(targets, tangents, weight, left, right, share, fixed, order, keys, band, side):  # type: ignore[no-untyped-def]
    """Hold the anchors of a frame between two keys to `targets (P, 2)`, along `tangents (P, 2)` of the outline."""
    key, factor = np.array([left, right]), np.array([1.0 - share, share])
    for p in range(len(targets)):
        wanted = tangents[p, 0] * targets[p, 0] + tangents[p, 1] * targets[p, 1]
        for one in range(2):
            if key[one] < 0:
                wanted -= factor[one] * (tangents[p, 0] * fixed[one, p, 0, 0] + tangents[p, 1] * fixed[one, p, 0, 1])
        for one in range(2):
            if key[one] < 0 or factor[one] == 0.0:
                continue
            for a in range(2):
                row = _slot(order, keys, p, 0, key[one], a)
                mine = weight * factor[one] * tangents[p, a]
                side[row] += mine * wanted
                for other in range(2):
                    if key[other] < 0 or factor[other] == 0.0:
                        continue
                    for b in range(2):
                        column = _slot(order, keys, p, 0, key[other], b)
                        if row >= column:
                            band[row - column, column] += mine * factor[other] * tangents[p, b]


@njit(nogil=True, cache=True)
def _add(index, value, wanted, weight, band, side):  # type: ignore[no-untyped-def]
    for i in range(4):
        side[index[i]] += weight * value[i] * wanted
        for j in range(4):
            if index[i] >= index[j]:
                band[index[i] - index[j], index[j]] += weight * value[i] * value[j]


@njit(nogil=True, cache=True)
def best_cubic(run, control):  # type: ignore[no-untyped-def]
    """The cubic `control (4, 2)` from end to end of `run (L, 2)` with free handles; how far the run strays from it."""
    count = len(run)
    control[0], control[3] = run[0], run[count - 1]
    t = np.empty(count)
    t[0] = 0.0
    for m in range(1, count):
        t[m] = t[m - 1] + np.sqrt((run[m, 0] - run[m - 1, 0]) ** 2 + (run[m, 1] - run[m - 1, 1]) ** 2)
    total = max(t[count - 1], 1e-9)
    for m in range(count):
        t[m] /= total
    worst = 0.0
    for _ in range(4):
        aa, ab, bb = 1e-6, 0.0, 1e-6
        ra, rb = np.zeros(2), np.zeros(2)
        for axis in range(2):  # a weak pull to thirds of the chord
            ra[axis] = 1e-6 * (2.0 * control[0, axis] + control[3, axis]) / 3.0
            rb[axis] = 1e-6 * (control[0, axis] + 2.0 * control[3, axis]) / 3.0
        for m in range(count):
            u = t[m]
            s = 1.0 - u
            first, last = 3.0 * s * s * u, 3.0 * s * u * u
            aa += first * first
            ab += first * last
            bb += last * last
            for axis in range(2):
                rest = run[m, axis] - s * s * s * control[0, axis] - u * u * u * control[3, axis]
                ra[axis] += first * rest
                rb[axis] += last * rest
        determinant = aa * bb - ab * ab
        for axis in range(2):
            if determinant > 1e-14:
                control[1, axis] = (bb * ra[axis] - ab * rb[axis]) / determinant
                control[2, axis] = (aa * rb[axis] - ab * ra[axis]) / determinant
            else:
                control[1, axis] = (2.0 * control[0, axis] + control[3, axis]) / 3.0
                control[2, axis] = (control[0, axis] + 2.0 * control[3, axis]) / 3.0
        worst = 0.0
        for m in range(count):
            u = t[m]
            s = 1.0 - u
            off, slope, bend = np.empty(2), np.empty(2), np.empty(2)
            for axis in range(2):
                a, b, c, d = control[0, axis], control[1, axis], control[2, axis], control[3, axis]
                off[axis] = s * s * s * a + 3.0 * s * s * u * b + 3.0 * s * u * u * c + u * u * u * d - run[m, axis]
                slope[axis] = 3.0 * (s * s * (b - a) + 2.0 * s * u * (c - b) + u * u * (d - c))
                bend[axis] = 6.0 * (s * (c - 2.0 * b + a) + u * (d - 2.0 * c + b))
            worst = max(worst, off[0] ** 2 + off[1] ** 2)
            steep = slope[0] ** 2 + slope[1] ** 2 + off[0] * bend[0] + off[1] * bend[1]
            if 0 < m < count - 1 and steep > 1e-9:
                u -= (off[0] * slope[0] + off[1] * slope[1]) / steep
                t[m] = min(max(u, t[m - 1]), 1.0)
    return np.sqrt(worst)


@njit(nogil=True, cache=True)
def runs_beyond(dense, start, length, tolerance, enough):  # type: ignore[no-untyped-def]
    """On how many of the rings `dense (F, M, 2)` the run of `length` samples from `start` strays farther than
    `tolerance` from a cubic; counted no further than beyond `enough`."""
    frames, total = dense.shape[:2]
    run, control, beyond = np.empty((length + 1, 2)), np.empty((4, 2)), 0
    for frame in range(frames):
        for k in range(length + 1):
            run[k] = dense[frame, (start + k) % total]
        if best_cubic(run, control) > tolerance:
            beyond += 1
            if beyond > enough:
                break
    return beyond


@njit(nogil=True, cache=True, fastmath=True)
def _dot(a, from_a, b, from_b, count):  # type: ignore[no-untyped-def]
    total = 0.0
    for k in range(count):
        total += a[from_a + k] * b[from_b + k]
    return total


@njit(nogil=True, cache=True)
def solved_band(band, side):  # type: ignore[no-untyped-def]
    """Solve a positive definite system in lower banded form by Cholesky; both arguments are overwritten.

    False where it is not definite. (LAPACK's threads cost more than they give at these sizes.)
    """
    width, size = band.shape
    rows = np.zeros((size, width))  # row i holds L[i, i - width + 1 .. i]
    for i in range(size):
        low = max(i - width + 1, 0)
        for j in range(low, i + 1):
            total = band[i - j, j]
            start = max(low, j - width + 1)
            a, b = rows[i], rows[j]
            shift_a, shift_b = width - 1 - i, width - 1 - j
            total -= _dot(a, start + shift_a, b, start + shift_b, j - start)
            if i == j:
                if not total > 0.0:
                    return False
                rows[i, width - 1] = np.sqrt(total)
            else:
                rows[i, j + shift_a] = total / rows[j, width - 1]
    for i in range(size):
        total = side[i]
        for k in range(max(i - width + 1, 0), i):
            total -= rows[i, k + width - 1 - i] * side[k]
        side[i] = total / rows[i, width - 1]
    for i in range(size - 1, -1, -1):
        total = side[i] / rows[i, width - 1]
        side[i] = total
        for k in range(max(i - width + 1, 0), i):
            side[k] -= rows[i, k + width - 1 - i] * total
    return True


@njit(nogil=True, cache=True)
def distances(places, line, near):  # type: ignore[no-untyped-def]
    """Distance `(K,)` from each of `places (K, 2)` to the closed `line (L, 2)`.

    Up to `near` it is that to the `AROUND` edges about the nearest one of the place before: never too little.
    """
    total, hint = len(line), 0
    result = np.empty(len(places))
    for m in range(len(places)):
        x, y = places[m, 0], places[m, 1]
        least, nearest = np.inf, hint
        for step in range(total):  # from the last nearest edge on
            k = hint + ((step + 1) // 2 if step % 2 else -(step // 2))
            if k < 0:
                k += total
            elif k >= total:
                k -= total
            n = k + 1 if k + 1 < total else 0
            square, _ = _to_edge(x, y, line[k, 0], line[k, 1], line[n, 0], line[n, 1])
            if square < least:
                least, nearest = square, k
            if step >= AROUND and least <= near * near:
                break
        hint = nearest
        result[m] = np.sqrt(least)
    return result


@njit(nogil=True, cache=True)
def judged(away, line, tolerance, free, reach, scrap, gone):  # type: ignore[no-untyped-def]
    """How far a closed line whose vertices are `away (K,)` from another strays, to be held against the tolerance.

    The greatest of: the distance that all of its length but the share `free` is within; one and a half times the mean
    distance; where `free` is 0 the greatest distance; else that of any stretch beyond `reach` tolerances, divided by
    `reach`, unless what lies beyond there, summed along it, is at most `scrap` square pixels. `gone (K,)` receives
    which vertices lie in the share that is let go.
    """
    count = len(away)
    length = np.empty(count)
    total, mean = 0.0, 0.0
    for k in range(count):
        a, b = line[k - 1], line[(k + 1) % count]
        length[k] = np.sqrt((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2) + 1e-12
        total += length[k]
        mean += away[k] * length[k]
    gone[:] = False
    if free <= 0.0:
        return max(away.max(), 1.5 * mean / total)
    left = free * total
    worst = 0.0
    for k in np.argsort(-away):
        if length[k] > left:
            worst = away[k]
            break
        left -= length[k]
        gone[k] = True
    return max(worst, 1.5 * mean / total, _farthest(away, length, reach * tolerance, scrap) / reach)


@njit(nogil=True, cache=True)
def _farthest(away, length, far, scrap):  # type: ignore[no-untyped-def]
    """The greatest distance on the stretches beyond `far` that are more than scraps; else 0. `length` counts twice."""
    count = len(away)
    first = -1
    for k in range(count):
        if away[k] <= far:
            first = k
            break
    if first < 0:
        return away.max()
    worst, beyond, most = 0.0, 0.0, 0.0
    for step in range(1, count + 1):
        k = (first + step) % count
        if away[k] > far:
            beyond += (away[k] - far) * 0.5 * length[k]
            most = max(most, away[k])
        else:
            if beyond > scrap:
                worst = max(worst, most)
            beyond, most = 0.0, 0.0
    return worst
