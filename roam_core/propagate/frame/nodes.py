"""Between the artist's control points and the engine's nodes: fixed curve parameters, one linear fit back."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csc_array
from scipy.sparse.linalg import SuperLU, splu

from roam_core.arrays import Array, Bools, Indices
from roam_core.geometry import bezier
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.params import RoamParams
from roam_core.roto.edit import is_smooth


@dataclass(frozen=True, eq=False)
class NodeMap:
    """The nodes x_n of the paper as fixed pairs `(segment, t)` on a spline, and the linear way back.

    Attributes
    ----------
    segment, t : (N,) where on the spline each node lies.
    sample : (N, 3 P) control points to nodes.
    back : (3 P, N) node displacements to control point displacements: regularised least squares.
    smooth : (P,) points whose two handles stay on one line.
    """

    segment: Indices
    t: Array
    sample: Array
    back: Array
    smooth: Bools

    @classmethod
    def of(cls, points: Array, params: RoamParams, scale: float) -> NodeMap:
        """Choose N and the pairs for a closed spline `points (P, 3, 2)` and prepare the fit back.

        Every anchor is a node where the count allows it, so that corners stay corners; between anchors the nodes lie
        about `node_spacing * scale` pixels apart.
        """
        segment, t = _pairs(points, params, scale)
        sample = bezier.design_matrix(len(points), segment, t)
        return cls(segment, t, sample, _way_back(points, sample, params.fit_rigidity), smooth_points(points))

    def __len__(self) -> int:
        return len(self.t)

    def nodes(self, points: Array) -> Array:
        """The nodes `(N, 2)` of a spline."""
        return np.asarray(self.sample @ points.reshape(-1, 2))

    def points(self, nodes: Array, prior: Array) -> Array:
        """The spline `(P, 3, 2)` that best follows `nodes (N, 2)`, held to `prior` where the nodes say little."""
        moved = prior.reshape(-1, 2) + self.back @ (nodes - self.nodes(prior))
        return bezier.aligned(moved.reshape(-1, 3, 2), self.smooth)


def _pairs(points: Array, params: RoamParams, scale: float) -> tuple[Indices, Array]:
    control = bezier.segments(points)
    fine = np.linspace(0.0, 1.0, 17)
    lines = np.einsum("tk,skc->stc", bezier.bernstein(fine), control)
    steps = np.hypot(*np.moveaxis(np.diff(lines, axis=1), 2, 0))
    lengths = steps.sum(axis=1)
    wanted = np.clip(lengths.sum() / (params.node_spacing * scale), params.min_nodes, params.max_nodes)
    if len(points) > wanted:
        return bezier.arc_length_pairs(points, int(wanted))
    spacing = max(lengths.sum() / wanted, 1e-9)
    counts = np.maximum(1, np.round(lengths / spacing)).astype(np.intp)
    segment, t = [], []
    for index, count in enumerate(counts):
        along = np.concatenate([[0.0], np.cumsum(steps[index])])
        targets = np.arange(count) / count * along[-1]
        t.append(np.interp(targets, along, fine) if along[-1] > 0 else np.arange(count) / count)
        segment.append(np.full(count, index, dtype=np.intp))
    return np.concatenate(segment), np.concatenate(t)


def _way_back(points: Array, sample: Array, rigidity: float) -> Array:
    """`(3 P, N)`: displacements `d` of the control points that minimise
    `|B d - r|^2 + rigidity * (sum |d_handle - d_anchor|^2 + 0.05 sum |d_anchor|^2)` for node displacements `r`.

    A handle that lies on its anchor stays there: corners and polygons keep their kind.
    """
    tie, design, equations = _equations(points, sample, rigidity)
    return np.asarray(csc_array(tie) @ equations.solve(np.ascontiguousarray(design.T)))


def displaced(points: Array, segment: Indices, t: Array, by: Array, rigidity: float) -> Array:
    """A closed spline `(P, 3, 2)` whose places at the pairs `(segment, t)` go by about `by (N, 2)`.

    Least squares, as in a `NodeMap`; smooth points stay smooth.
    """
    sample = bezier.design_matrix(len(points), segment, t)
    tie, design, equations = _equations(points, sample, rigidity)
    moved = points.reshape(-1, 2) + csc_array(tie) @ equations.solve(csc_array(design).T @ by)
    return bezier.aligned(moved.reshape(-1, 3, 2), smooth_points(points))


def _equations(points: Array, sample: Array, rigidity: float) -> tuple[Array, Array, SuperLU]:
    """The normal equations of `_way_back`: free numbers `(F,)` to control points, to places, and their factors."""
    count = len(points)
    tie = np.eye(3 * count)
    for index in range(count):
        for part in (IN, OUT):
            if np.array_equal(points[index, part], points[index, ANCHOR]):
                tie[3 * index + part] = tie[3 * index + ANCHOR]
    free = np.flatnonzero(tie.any(axis=0))
    tie = tie[:, free]
    relative = np.zeros((2 * count, 3 * count))
    rows = np.arange(count)
    for offset, part in ((0, IN), (count, OUT)):
        relative[offset + rows, 3 * rows + part] = 1.0
        relative[offset + rows, 3 * rows + ANCHOR] = -1.0
    anchors = np.zeros((count, 3 * count))
    anchors[rows, 3 * rows + ANCHOR] = np.sqrt(0.05)
    hold, design = np.vstack([relative, anchors]), sample
    if len(free) < 3 * count:  # else these products change no bit, and of many points they take most of the time
        hold, design = hold @ tie, design @ tie
    # Per control point: a spline of many nodes is not held less than one of few.
    weight = rigidity * len(sample) / count
    # Sparse, because dense LAPACK rounds otherwise with another number of threads.
    rows, held = csc_array(design), csc_array(hold)
    normal = (rows.T @ rows + weight * (held.T @ held)).tocsc()
    return tie, design, splu(normal)


def smooth_points(points: Array) -> Bools:
    """Which points `(P,)` of a spline are to stay smooth: those whose handles are opposite within twelve degrees."""
    return np.array([is_smooth(point, degrees=12.0) for point in points], dtype=bool)
