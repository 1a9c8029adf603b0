"""Polylines `(K, 2)`: length, area, resampling, normals, self-intersection."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array, Indices


def following(ring: Array) -> Array:
    """Each vertex's successor on a closed polyline `(K, ...)`: `numpy.roll` by -1, without its cost on short arrays."""
    return np.concatenate([ring[1:], ring[:1]])


def preceding(ring: Array) -> Array:
    """Each vertex's predecessor on a closed polyline `(K, ...)`."""
    return np.concatenate([ring[-1:], ring[:-1]])


def length(line: Array, closed: bool = True) -> float:
    """Length in pixels."""
    ends = following(line) if closed else line[1:]
    return float(np.hypot(*(ends - line[: len(ends)]).T).sum())


def signed_area(line: Array) -> float:
    """Area of a closed polyline; positive when it runs clockwise on screen (y down)."""
    x, y = line.T
    return float(0.5 * (x * following(y) - following(x) * y).sum())


def resample(line: Array, count: int, closed: bool = True) -> Array:
    """`count` points at equal arc length, the first at `line[0]`."""
    whole = np.vstack([line, line[:1]]) if closed else line
    s = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(whole, axis=0).T))])
    targets = np.linspace(0.0, s[-1], count, endpoint=not closed)
    return np.stack([np.interp(targets, s, whole[:, 0]), np.interp(targets, s, whole[:, 1])], axis=1)


def at(ring: Array, places: Array) -> Array:
    """Positions on a closed ring `(K, 2)` at `places (N,)`: 1.5 is midway between the second and the third vertex."""
    before = np.floor(places).astype(np.intp)
    share = (places - before)[:, None]
    return np.asarray((1.0 - share) * ring[before % len(ring)] + share * ring[(before + 1) % len(ring)])


def outward_normals(line: Array) -> Array:
    """Unit normals `(K, 2)` at the vertices of a closed polyline, pointing out of it; zero where it is degenerate."""
    return outward_normals_of(following(line) - preceding(line), line)


def outward_normals_of(tangents: Array, line: Array) -> Array:
    """Unit normals `(K, 2)` to `tangents (K, 2)` along a closed polyline, pointing out of it; zero where those are."""
    norm = np.hypot(*tangents.T)[:, None]
    tangent = np.divide(tangents, norm, out=np.zeros_like(tangents), where=norm > 0)
    side = 1.0 if signed_area(line) > 0 else -1.0
    return side * np.stack([tangent[:, 1], -tangent[:, 0]], axis=1)


def is_simple(line: Array, closed: bool = True) -> bool:
    """True when no two edges that are not neighbours properly cross; touching is allowed."""
    return len(crossings(line, closed)) == 0


def crossings(line: Array, closed: bool = True) -> Indices:
    """Pairs `(C, 2)` of indices of edges, not neighbours, that properly cross each other (touching does not count)."""
    from roam_core.kernels.crossing import crossing_edges  # numba: telling stamps of keys must not wait for it

    return np.asarray(crossing_edges(line, closed), dtype=np.intp)
