"""Slow, obvious twins of `roam_core.kernels.coverage`."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array, Indices


def ref_coverage(line: Array, size: tuple[int, int], samples: int = 16) -> Array:
    """Coverage `(h, w)` by counting the `samples` x `samples` points of each pixel that the polyline winds around."""
    height, width = size
    grid = (np.arange(max(height, width) * samples) + 0.5) / samples
    y, x = np.meshgrid(grid[: height * samples], grid[: width * samples], indexing="ij")
    inside = winding(line, x, y) != 0
    return inside.reshape(height, samples, width, samples).mean(axis=(1, 3))


def winding(line: Array, x: Array, y: Array) -> Indices:
    """How often the closed polyline winds around each point, by crossings of the ray to the left."""
    total = np.zeros(x.shape, dtype=np.intp)
    for (ax, ay), (bx, by) in zip(line, np.roll(line, -1, axis=0), strict=True):
        if ay == by:
            continue
        crossing = (y >= min(ay, by)) & (y < max(ay, by))
        at = ax + (y - ay) * (bx - ax) / (by - ay)
        total += np.where(crossing & (at < x), 1 if by > ay else -1, 0)
    return total


def comp_coverage(line: Array, size: tuple[int, int]) -> Array:
    """Coverage `(h, w)` of a simple polygon: clip it to each pixel's square, take the area of what is left."""
    height, width = size
    result = np.zeros((height, width))
    for row in range(height):
        for column in range(width):
            part = [(float(x), float(y)) for x, y in line]
            for axis, bound, keep in ((0, column, 1), (0, column + 1, -1), (1, row, 1), (1, row + 1, -1)):
                part = _clip(part, axis, bound, keep)
            result[row, column] = abs(_area(part))
    return result


def ref_swept_coverage(start: Array, end: Array, size: tuple[int, int], steps: int) -> Array:
    """Mean coverage `(h, w)` of the polygons at the middles of equal parts of the way from `start` to `end`."""
    shares = (np.arange(steps) + 0.5) / steps
    return np.mean([comp_coverage_by_rows((1 - u) * start + u * end, size) for u in shares], axis=0)


def comp_coverage_by_rows(line: Array, size: tuple[int, int]) -> Array:
    """Coverage `(h, w)` of a simple polygon, each pixel from the polygon clipped to its row before its column."""
    height, width = size
    result = np.zeros((height, width))
    whole = [(float(x), float(y)) for x, y in line]
    for row in range(height):
        strip = _clip(_clip(whole, 1, row, 1), 1, row + 1, -1)
        for column in range(width if strip else 0):
            result[row, column] = abs(_area(_clip(_clip(strip, 0, column, 1), 0, column + 1, -1)))
    return result


def _clip(polygon: list[tuple[float, float]], axis: int, bound: float, keep: int) -> list[tuple[float, float]]:
    """The polygon on one side of an upright or level line (Sutherland and Hodgman)."""
    result: list[tuple[float, float]] = []
    for a, b in zip(polygon, polygon[1:] + polygon[:1], strict=True):
        da, db = keep * (a[axis] - bound), keep * (b[axis] - bound)
        if da >= 0:
            result.append(a)
        if da * db < 0:
            t = da / (da - db)
            result.append((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])))
    return result


def _area(polygon: list[tuple[float, float]]) -> float:
    return 0.5 * sum(ax * by - bx * ay for (ax, ay), (bx, by) in zip(polygon, polygon[1:] + polygon[:1], strict=True))


def ref_distance(line: Array, size: tuple[int, int]) -> Array:
    """Distance `(h, w)` of every pixel's centre to the closed polyline, edge by edge."""
    height, width = size
    centres = np.stack(np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5), axis=-1)
    least = np.full((height, width), np.inf)
    for a, b in zip(line, np.roll(line, -1, axis=0), strict=True):
        along = b - a
        norm = along @ along
        t = np.clip(((centres - a) @ along) / norm, 0.0, 1.0) if norm else np.zeros((height, width))
        least = np.minimum(least, np.linalg.norm(centres - a - t[..., None] * along, axis=-1))
    return least
