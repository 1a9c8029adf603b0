"""Closed polylines on the pixel grid: the exact area they cover of every pixel, and the distance to them."""

from __future__ import annotations

import math

import numpy as np
from numba import njit

from roam_core.arrays import Array, Bools, Float32

SWEEP_STEP, MOST_STEPS = 0.125, 1024
"""Pixels from one filled outline of a sweep to the next, and how many of them at most: the mean over a step strays from
the exact ramp by an eighth of the step at its ends and nowhere else."""

DUST = 1e-9
"""Coverage below this is the rounding error of a sum that is zero."""


def coverage(line: Array, size: tuple[int, int]) -> Float32:
    """The fraction of every pixel that a closed polyline covers.

    The signed area under each edge is summed pixel by pixel; running totals along the rows turn the sums into the
    winding number averaged over each pixel. Its magnitude, clamped to 1, is the coverage: for a simple polygon the
    exact area in either orientation, and where a polyline overlaps itself with equal orientation the overlap is
    covered once, not cut out. Parts outside the image count as they should: what lies beyond the left edge still winds
    around the pixels to its right.

    Parameters
    ----------
    line : (K, 2) vertices (x, y) in pixels, the centre of pixel [row, col] being (col + .5, row + .5); the last vertex
        is joined to the first.
    size : (h, w) of the image.

    Returns
    -------
    (h, w) float32 in [0, 1].
    """
    line = _checked(line)
    height, width = size
    result = np.zeros((height, width), dtype=np.float32)
    box = _box(line, size, 0.0)
    if box is None or len(line) < 3:
        return result
    top, bottom, left, right = box
    sums = np.zeros((bottom - top, right - left + 1))
    _sum_areas(line - (float(left), float(top)), sums)
    _wind(sums, result[top:bottom, left:right])
    return result


def swept_coverage(start: Array, end: Array, size: tuple[int, int]) -> Float32:
    """The mean coverage of a closed polyline whose vertices move evenly from `start` to `end`.

    The signed areas are averaged over `SWEEP_STEP` and finer steps before they are wound up: the edge of a simple
    polygon leaves its exact ramp. Where the polyline overlaps itself in a part of the move only, that is the coverage
    of the mean winding number.

    Parameters
    ----------
    start, end : (K, 2) vertices in pixels, as for `coverage`.
    size : (h, w) of the image.

    Returns
    -------
    (h, w) float32 in [0, 1].
    """
    start, end = _checked(start), _checked(end)
    if start.shape != end.shape:
        raise ValueError(f"a polyline of {len(start)} vertices cannot move to one of {len(end)}")
    height, width = size
    result = np.zeros((height, width), dtype=np.float32)
    box = _box(np.concatenate([start, end]), size, 0.0)
    if box is None or len(start) < 3:
        return result
    top, bottom, left, right = box
    corner = np.array([left, top], dtype=np.float64)
    farthest = float(np.hypot(*(end - start).T).max())
    steps = int(np.clip(np.ceil(farthest / SWEEP_STEP), 1, MOST_STEPS))
    sums = np.zeros((bottom - top, right - left + 1))
    _sum_sweep(start - corner, end - corner, steps, sums)
    _wind(sums, result[top:bottom, left:right])
    return result


def holds_centres(line: Array, size: tuple[int, int]) -> Bools:
    """Which pixels have their centre inside of a closed polyline: where its winding number is not 0.

    Parameters
    ----------
    line : (K, 2) vertices in pixels, as for `coverage`.
    size : (h, w) of the image.

    Returns
    -------
    (h, w) bool.
    """
    line = _checked(line)
    result = np.zeros(size, dtype=np.bool_)
    box = _box(line, size, 0.0)
    if box is None or len(line) < 3:
        return result
    top, bottom, left, right = box
    turns = np.zeros((bottom - top, right - left + 1), dtype=np.int32)
    _sum_crossings(line - (float(left), float(top)), turns)
    np.not_equal(np.cumsum(turns[:, :-1], axis=1), 0, out=result[top:bottom, left:right])
    return result


def distance(line: Array, size: tuple[int, int], reach: float) -> Float32:
    """The distance of every pixel's centre to a closed polyline, where it is less than `reach`.

    Parameters
    ----------
    line : (K, 2) vertices in pixels; the last one is joined to the first.
    size : (h, w) of the image.
    reach : pixels; only a band of this width on both sides is visited, so that the cost follows the outline's length.

    Returns
    -------
    (h, w) float32 pixels; `reach` where the polyline is as far away as that, or farther.
    """
    line = _checked(line)
    height, width = size
    result = np.full((height, width), reach * reach, dtype=np.float32)
    box = _box(line, size, reach)
    if box is None or reach <= 0.0:
        return np.sqrt(result)
    top, bottom, left, right = box
    region = result[top:bottom, left:right]
    _least_squares(line - np.array([left, top], dtype=np.float64), float(reach), region)
    np.sqrt(result, out=result)
    return result


def _checked(line: Array) -> Array:
    line = np.ascontiguousarray(line, dtype=np.float64)
    if line.ndim != 2 or line.shape[1] != 2:
        raise ValueError(f"a polyline has shape {line.shape}, not (K, 2)")
    if not math.isfinite(line.sum()) and not np.isfinite(line).all():
        raise ValueError("a polyline has a vertex that is not finite")
    return line


def _box(line: Array, size: tuple[int, int], margin: float) -> tuple[int, int, int, int] | None:
    """Rows and columns (top, bottom, left, right; half open) that the polyline reaches inside the image, or None."""
    if len(line) == 0:
        return None
    (left, top), (right, bottom) = _corners(line)
    height, width = size
    rows = max(math.floor(top - margin), 0), min(math.ceil(bottom + margin), height)
    columns = max(math.floor(left - margin), 0), min(math.ceil(right + margin), width)
    return (*rows, *columns) if rows[0] < rows[1] and columns[0] < columns[1] else None


@njit(nogil=True, cache=True)
def _corners(line):  # type: ignore[no-untyped-def]
    """The least and the greatest x and y of a polyline with at least one vertex."""
    left, top = line[0]
    right, bottom = left, top
    for k in range(1, len(line)):
        x, y = line[k]
        left, right = min(left, x), max(right, x)
        top, bottom = min(top, y), max(bottom, y)
    return (left, top), (right, bottom)


@njit(nogil=True, cache=True, inline="always")
def _edge(line, k):  # type: ignore[no-untyped-def]
    """The edge from vertex `k` on: 1 where y grows along it, else -1, and its ends, that of the lesser y first."""
    x0, y0 = line[k, 0], line[k, 1]
    x1, y1 = line[(k + 1) % len(line), 0], line[(k + 1) % len(line), 1]
    if y0 > y1:
        return -1, x1, y1, x0, y0
    return 1, x0, y0, x1, y1


@njit(nogil=True, cache=True)
def _sum_areas(line, sums):  # type: ignore[no-untyped-def]
    """Add every edge's signed area to `sums (h, w + 1)`: the row-wise running total is the mean winding number.

    An edge that crosses a row adds its signed height to all pixels on its right, and the part of it that lies to the
    right of the edge to the pixels that it crosses. A height that is added in one column counts for all columns after
    it, so each column gets the share of the pixel and the next column the rest of the height.
    """
    height, width = sums.shape[0], sums.shape[1] - 1
    for k in range(len(line)):
        sign, x0, y0, x1, y1 = _edge(line, k)
        if y0 == y1 or y1 <= 0.0 or y0 >= height:
            continue
        slope = (x1 - x0) / (y1 - y0)
        low, high = min(x0, x1), max(x0, x1)
        for row in range(int(max(y0, 0.0)), int(min(np.ceil(y1), height))):
            ya, yb = max(y0, float(row)), min(y1, row + 1.0)
            # Clamped, because rounding may carry a point of the edge beyond its ends.
            xa = min(max(x0 + (ya - y0) * slope, low), high)
            xb = min(max(x0 + (yb - y0) * slope, low), high)
            rise = sign * (yb - ya)
            left, right = min(xa, xb), max(xa, xb)
            if left >= width:
                continue
            if right <= 0.0:
                sums[row, 0] += rise
                continue
            span = right - left
            if left < 0.0:  # what lies beyond the image's left edge winds around the whole row
                sums[row, 0] += rise * (-left / span)
                left = 0.0
            right = min(right, float(width))
            if right == left:  # upright
                column = int(left)
                sums[row, column] += rise * (column + 1.0 - left)
                sums[row, column + 1] += rise * (left - column)
                continue
            for column in range(int(left), int(np.ceil(right))):
                a, b = max(left, float(column)), min(right, column + 1.0)
                part = rise * ((b - a) / span)
                share = 0.5 * (a + b) - column
                sums[row, column] += part * (1.0 - share)
                sums[row, column + 1] += part * share


@njit(nogil=True, cache=True)
def _sum_crossings(line, turns):  # type: ignore[no-untyped-def]
    """Add every edge's sign to `turns (h, w + 1)` where it crosses a row of pixels' centres: at the first after it."""
    height, width = turns.shape[0], turns.shape[1] - 1
    for k in range(len(line)):
        sign, x0, y0, x1, y1 = _edge(line, k)
        if y0 == y1:
            continue
        # Rows whose centre lies in [y0, y1): a vertex on a centre counts for one of its two edges.
        first = int(np.ceil(min(max(y0 - 0.5, 0.0), float(height))))
        last = int(np.ceil(min(max(y1 - 0.5, 0.0), float(height))))
        slope = (x1 - x0) / (y1 - y0)
        for row in range(first, last):
            x = min(max(x0 + (row + 0.5 - y0) * slope, min(x0, x1)), max(x0, x1))
            turns[row, int(np.ceil(min(max(x - 0.5, 0.0), float(width))))] += sign


@njit(nogil=True, cache=True)
def _sum_sweep(start, end, steps, sums):  # type: ignore[no-untyped-def]
    """The mean of `_sum_areas` over the middles of `steps` equal parts of the way from `start` to `end`."""
    line = np.empty_like(start)
    for step in range(steps):
        share = (step + 0.5) / steps
        for k in range(len(start)):
            line[k, 0] = (1.0 - share) * start[k, 0] + share * end[k, 0]
            line[k, 1] = (1.0 - share) * start[k, 1] + share * end[k, 1]
        _sum_areas(line, sums)
    sums /= steps


@njit(nogil=True, cache=True)
def _wind(sums, result):  # type: ignore[no-untyped-def]
    """Running totals of `sums (h, w + 1)` along the rows, as magnitudes clamped to 1, into `result (h, w)`."""
    for row in range(result.shape[0]):
        total = 0.0
        for column in range(result.shape[1]):
            total += sums[row, column]
            covered = min(abs(total), 1.0)
            result[row, column] = covered if covered > DUST else 0.0


@njit(nogil=True, cache=True)
def _least_squares(line, reach, squares):  # type: ignore[no-untyped-def]
    """Lower `squares (h, w)` to the squared distance between pixel centres and the edges nearer than `reach`."""
    height, width = squares.shape
    count = line.shape[0]
    for k in range(count):
        ax, ay = line[k, 0], line[k, 1]
        bx, by = line[(k + 1) % count, 0], line[(k + 1) % count, 1]
        dx, dy = bx - ax, by - ay
        norm = dx * dx + dy * dy
        top, bottom = max(min(ay, by) - reach, 0.0), min(max(ay, by) + reach, float(height))
        left, right = max(min(ax, bx) - reach, 0.0), min(max(ax, bx) + reach, float(width))
        for row in range(int(top), int(np.ceil(bottom))):
            py = row + 0.5 - ay
            for column in range(int(left), int(np.ceil(right))):
                px = column + 0.5 - ax
                t = 0.0
                if norm > 0.0:
                    t = min(max((px * dx + py * dy) / norm, 0.0), 1.0)
                ex, ey = px - t * dx, py - t * dy
                square = ex * ex + ey * ey
                if square < squares[row, column]:
                    squares[row, column] = square
