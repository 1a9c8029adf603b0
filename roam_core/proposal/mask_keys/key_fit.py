"""One shape fitted to one outline, however far away: its own points in correspondence, the curve on the outline."""

from __future__ import annotations

import numpy as np
from scipy.sparse import csr_array, eye_array, vstack
from scipy.sparse.linalg import spsolve

from roam_core.arrays import Array, Indices
from roam_core.geometry import bezier, polyline
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.geometry.simple import crossing_segments
from roam_core.params import KEY_FIT
from roam_core.proposal.mask_keys.anchors import spread
from roam_core.proposal.mask_keys.outline_match import matched
from roam_core.proposal.outline.refine import beside, bounded, places_between, tangents, tree_of
from roam_core.roto.edit import is_smooth


def fitted(points: Array, ring: Array, poses: list[Array], scale: float = 1.0) -> Array:
    """The closed spline `points (P, 3, 2)` fitted to the closed polyline `ring (K, 2)`, its points in correspondence.

    `poses` are similarities `(2, 3)` that may carry the spline to where the outline is. The curve is matched to the
    outline and then fitted by least squares, alternating with the places of the outline's samples on it.
    """
    match = matched(points, ring, poses, scale)
    anchors = spread(points, match.samples, match.anchors, KEY_FIT.spreads, scale)
    prior = _carried(points, match.samples[anchors])
    fit = _Fit(points, prior, match.samples)
    places = places_between(anchors, match.samples)
    result = fit.solve(places, prior)
    for _ in range(KEY_FIT.rounds):
        places = fit.projected(result, places)
        result = fit.solve(places, result)
    return _untangled(bezier.aligned(result, fit.smooth), match.samples[anchors], scale)


def _untangled(points: Array, anchors: Array, scale: float) -> Array:
    """The spline without crossings, where little has to change for it.

    Segments that cross get shorter handles, then straight ones, then their ends go back to `anchors (P, 2)` on the
    outline, and at last their neighbours with them. A crossing that outlives this stays: a curve that follows its
    outline and crosses itself somewhere is nearer to what the artist wants than one that does neither.
    """
    result = points.copy()
    for mend in (_shorter, _shorter, _straight, _straight):
        guilty = crossing_segments(result, scale)
        if len(guilty) == 0:
            return result
        result = _mended(result, mend(result), guilty)
    for width in (0, 0, 1, 1):
        guilty = crossing_segments(result, scale)
        if len(guilty) == 0:
            return result
        near = (guilty[:, None] + np.arange(-width, width + 2)).ravel() % len(points)
        result[near] += (anchors - result[:, ANCHOR])[near, None]
        result = _mended(result, _straight(result), np.unique((near[:, None] - np.arange(2)).ravel() % len(points)))
    return result if len(crossing_segments(result, scale)) == 0 else points


def _mended(points: Array, other: Array, segments: Indices) -> Array:
    """The spline with the handles of some segments as `other` has them."""
    result, following = points.copy(), (segments + 1) % len(points)
    result[segments, OUT], result[following, IN] = other[segments, OUT], other[following, IN]
    return result


def _shorter(points: Array) -> Array:
    """The spline with handles at half their length."""
    return np.asarray(points[:, :1] + 0.5 * (points - points[:, :1]))


def _straight(points: Array) -> Array:
    """The polygon through the anchors, handles at thirds of its sides except those that lie on their anchors."""
    anchors = points[:, ANCHOR]
    ahead = (np.roll(anchors, -1, axis=0) - anchors) / 3.0
    result = np.stack([anchors, anchors - np.roll(ahead, 1, axis=0), anchors + ahead], axis=1)
    corner = (points == points[:, :1]).all(axis=2)
    return np.where(corner[..., None], result[:, :1], result)


def _carried(points: Array, anchors: Array) -> Array:
    """The spline with its anchors put at `anchors (P, 2)`; each handle turns and grows with its segment's chord."""
    result = np.empty_like(points)
    result[:, ANCHOR] = anchors
    for part, step in ((OUT, -1), (IN, 1)):
        old = points[:, ANCHOR] @ [1, 1j], points[:, part] @ [1, 1j]
        new = anchors @ [1, 1j]
        before, after = np.roll(old[0], step) - old[0], np.roll(new, step) - new
        usable = np.abs(before) > 1e-6
        turn = np.where(usable, after / np.where(usable, before, 1.0), 1.0)
        handle = new + (old[1] - old[0]) * turn
        result[:, part] = np.stack([handle.real, handle.imag], axis=1)
    return result


class _Fit:
    """Least squares for the control points of a spline, given where on it the samples of an outline lie."""

    def __init__(self, points: Array, prior: Array, samples: Array) -> None:
        self.count = len(points)
        self.samples, self.tree = samples, tree_of(samples)
        self.prior = prior
        self.smooth = np.array([is_smooth(point, degrees=KEY_FIT.straight) for point in points], dtype=bool)
        self.tie = _ties(points)
        self.tangent = tangents(prior)

    def solve(self, places: Array, points: Array) -> Array:
        """Control points for samples at `places (M,)`, starting from `points`."""
        segment = np.minimum(places.astype(np.intp), self.count - 1)
        design = _design(self.count, segment, places - segment)
        both = _both(design)
        rows = [both, self._slide(), self._common_lines(points), self._hold(), self._stay()]
        prior = self.prior.ravel()
        wanted = [
            self.samples.ravel(), rows[1] @ prior, np.zeros(rows[2].shape[0]), rows[3] @ prior, rows[4] @ prior
        ]  # fmt: skip
        matrix = (vstack(rows) @ self.tie).tocsc()
        solution = spsolve(matrix.T @ matrix, matrix.T @ np.concatenate(wanted))
        found = beside(np.asarray((self.tie @ solution).reshape(-1, 3, 2)), self.samples, self.tree, KEY_FIT.astray)
        return bounded(found, places, self.samples)

    def _slide(self) -> csr_array:
        rows = np.arange(self.count)
        weight = np.sqrt(KEY_FIT.slide * len(self.samples) / self.count)
        return _rows(self.count, [(rows, ANCHOR, weight * self.tangent)])

    def _stay(self) -> csr_array:
        """Where no sample lies beside an anchor nothing else says where it is."""
        weight = np.sqrt(KEY_FIT.stay * len(self.samples) / self.count)
        return csr_array(weight * eye_array(6 * self.count))

    def _hold(self) -> csr_array:
        rows = np.arange(self.count)
        weight = np.sqrt(KEY_FIT.hold * len(self.samples) / self.count)
        parts = []
        for axis in (0, 1):
            unit = np.zeros((self.count, 2))
            unit[:, axis] = weight
            for part in (IN, OUT):
                parts.append(_rows(self.count, [(rows, part, unit), (rows, ANCHOR, -unit)]))
        return vstack(parts)

    def _common_lines(self, points: Array) -> csr_array:
        rows = np.flatnonzero(self.smooth)
        tangent = tangents(points)[rows]
        normal = np.sqrt(KEY_FIT.smooth) * np.stack([-tangent[:, 1], tangent[:, 0]], axis=1)
        parts = [_rows(self.count, [(rows, part, normal), (rows, ANCHOR, -normal)]) for part in (IN, OUT)]
        return vstack(parts)

    def projected(self, points: Array, places: Array) -> Array:
        """The places of the samples moved to the nearest ones on the spline, in order."""
        fine = KEY_FIT.fine
        line = bezier.evaluate(points, *bezier.even_pairs(np.full(self.count, fine)))
        total = len(line)
        index = np.round(places * fine).astype(np.intp)[:, None] + np.arange(-KEY_FIT.window, KEY_FIT.window + 1)
        away = ((line[index % total] - self.samples[:, None]) ** 2).sum(axis=2)
        facing = polyline.outward_normals(line)[index % total] @ polyline.outward_normals(self.samples)[:, :, None]
        cost = away + KEY_FIT.turn * (1.0 - facing[..., 0])
        best = np.argmin(cost, axis=1)
        rows = np.arange(len(best))
        nearest = index[rows, best]
        a, b = line[nearest % total], line[(nearest + 1) % total]
        c = line[(nearest - 1) % total]
        ahead = _foot(a, b, self.samples) - _foot(a, c, self.samples)
        moved = (nearest + np.clip(ahead, -1.0, 1.0)) / fine
        start = int(np.argmin(places))
        order = (start + np.arange(len(places))) % len(places)
        run = np.maximum.accumulate(moved[order])
        run = np.clip(run, run[0], run[0] + self.count)
        result = np.empty_like(run)
        result[order] = run % self.count
        return result


def _foot(a: Array, b: Array, position: Array) -> Array:
    along = b - a
    return np.asarray(
        np.clip(((position - a) * along).sum(axis=1) / np.maximum((along**2).sum(axis=1), 1e-12), 0.0, 1.0)
    )


def _design(count: int, segment: Indices, t: Array) -> csr_array:
    following = (segment + 1) % count
    columns = np.stack([3 * segment + ANCHOR, 3 * segment + OUT, 3 * following + IN, 3 * following + ANCHOR], axis=1)
    rows = np.repeat(np.arange(len(segment)), 4)
    return csr_array((bezier.bernstein(t).ravel(), (rows, columns.ravel())), shape=(len(segment), 3 * count))


def _both(design: csr_array) -> csr_array:
    """The same rows for x and for y, interleaved."""
    found = design.tocoo()
    rows = np.concatenate([2 * found.row, 2 * found.row + 1])
    columns = np.concatenate([2 * found.col, 2 * found.col + 1])
    shape = 2 * design.shape[0], 2 * design.shape[1]
    return csr_array((np.tile(found.data, 2), (rows, columns)), shape=shape)


def _rows(count: int, terms: list[tuple[Indices, int, Array]]) -> csr_array:
    """One row a point: the sum over `terms` of `vector . control point (index, part)`."""
    values, rows, columns = [], [], []
    for index, part, vector in terms:
        for axis in (0, 1):
            values.append(vector[:, axis])
            rows.append(np.arange(len(index)))
            columns.append(2 * (3 * index + part) + axis)
    shape = len(terms[0][0]), 6 * count
    return csr_array((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), shape=shape)


def _ties(points: Array) -> csr_array:
    """The linear map from free coordinates to all: a handle that lies on its anchor stays there."""
    count = len(points)
    owner = np.arange(3 * count)
    for part in (IN, OUT):
        corner = (points[:, part] == points[:, ANCHOR]).all(axis=1)
        owner[3 * np.flatnonzero(corner) + part] = 3 * np.flatnonzero(corner) + ANCHOR
    free, column = np.unique(owner, return_inverse=True)
    single = csr_array((np.ones(3 * count), (np.arange(3 * count), column)), shape=(3 * count, len(free)))
    return _both(single)
