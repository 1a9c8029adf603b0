"""E^J, the interaction of curve and landmarks (equations 8 and 9): vertices keep their shift from landmarks nearby."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from roam_core.arrays import Array, Bools, Indices


@dataclass(frozen=True, eq=False)
class Pairs:
    """The pairs n ~ m: `node (Q,)`, `leaf (Q,)`, and `shift (Q, 2)`: mu_nm, from landmark to vertex, in pixels."""

    node: Indices
    leaf: Indices
    shift: Array

    def turned(self, transform: Array) -> Pairs:
        """The pairs after a similarity `(2, 3)`.

        In the paper mu_nm stays what it was in the first image. Objects turn and come closer, so the shifts follow the
        rotation and the scale of the pre-warp: beyond the paper.
        """
        return replace(self, shift=self.shift @ transform[:, :2].T)

    def followed(self, nodes: Array, leaves: Array, rate: float) -> Pairs:
        """The pairs with shifts that have gone by `rate` in [0, 1] of the way to those of a solved frame.

        At 0 they stay those of the first image, as in the paper: the outline is held to the key's form. An object that
        deforms takes on other forms for good; with a small rate only what is sudden is held back: beyond the paper.
        """
        now = nodes[self.node] - leaves[self.leaf]
        return replace(self, shift=self.shift + rate * (now - self.shift))

    def of(self, wanted: Bools) -> Pairs:
        """The pairs of the leaves that are `wanted (M,)`; numbers stay as they are."""
        keep = wanted[self.leaf]
        return Pairs(self.node[keep], self.leaf[keep], self.shift[keep])

    def between(self, leaves: Indices) -> Pairs:
        """The pairs of some of the leaves, which are numbered as they stand in `leaves (K,)`; the others fall away."""
        place = np.full(int(max(self.leaf.max(initial=-1), leaves.max(initial=-1))) + 1, -1, dtype=np.intp)
        place[leaves] = np.arange(len(leaves))
        keep = place[self.leaf] >= 0
        return Pairs(self.node[keep], place[self.leaf[keep]], self.shift[keep])


def paired(nodes: Array, leaves: Array, neighbours: int) -> Pairs:
    """Each of `nodes (N, 2)` with its nearest `leaves (M, 2)`, as many as `neighbours`; shifts as they are now."""
    distance = ((nodes[:, None] - leaves[None]) ** 2).sum(axis=2)
    nearest = np.argsort(distance, axis=1, kind="stable")[:, :neighbours]
    node = np.repeat(np.arange(len(nodes), dtype=np.intp), nearest.shape[1])
    leaf = nearest.ravel()
    return Pairs(node, leaf, nodes[node] - leaves[leaf])


def completed(pairs: Pairs, nodes: Array, leaves: Array, neighbours: int) -> Pairs:
    """The pairs, and for nodes that have lost some, new ones with the nearest leaves, their shifts as they are now.

    A pair that lives keeps its shift: it remembers the frame in which it was made.
    """
    count = np.bincount(pairs.node, minlength=len(nodes))
    distance = ((nodes[:, None] - leaves[None]) ** 2).sum(axis=2)
    distance[pairs.node, pairs.leaf] = np.inf
    order = np.argsort(distance, axis=1, kind="stable")[:, :neighbours]
    wanted = (np.arange(order.shape[1]) < neighbours - count[:, None]) & np.isfinite(
        np.take_along_axis(distance, order, axis=1)
    )
    node, rank = np.nonzero(wanted)
    leaf = order[node, rank]
    return Pairs(
        np.concatenate([pairs.node, node]),
        np.concatenate([pairs.leaf, leaf]),
        np.vstack([pairs.shift, nodes[node] - leaves[leaf]]),
    )


def unary_joint_nodes(nodes: Array, moves: Array, leaves: Array, pairs: Pairs) -> Array:
    """Equation 9 seen from the curve: sum over m ~ n of 1/2 |x_n + move - y_m - mu_nm|^2, `(N, D)`, pixels squared."""
    miss = nodes[pairs.node] - leaves[pairs.leaf] - pairs.shift
    each = 0.5 * ((miss[:, None] + moves[None]) ** 2).sum(axis=2)
    table = np.zeros((len(nodes), len(moves)))
    np.add.at(table, pairs.node, each)
    return table


def unary_joint_leaves(nodes: Array, leaves: Array, moves: Array, pairs: Pairs) -> Array:
    """Equation 9 seen from the landmarks: sum over n ~ m of 1/2 |x_n - y_m - move - mu_nm|^2, `(M, S)`.

    All the pairs of a landmark pull it to one place, their mean: with K of them the sum is K/2 |y_m - mean|^2 and a
    constant, so the table costs no more for many pairs.
    """
    count = len(leaves)
    wanted = nodes[pairs.node] - pairs.shift - leaves[pairs.leaf]
    members = np.bincount(pairs.leaf, minlength=count).astype(np.float64)
    total = np.stack([np.bincount(pairs.leaf, wanted[:, k], count) for k in (0, 1)], axis=1)
    square = np.bincount(pairs.leaf, (wanted**2).sum(axis=1), count)
    lengths = (moves**2).sum(axis=1)
    return np.asarray(0.5 * (members[:, None] * lengths - 2.0 * total @ moves.T + square[:, None]))


def joint_energy(nodes: Array, leaves: Array, pairs: Pairs) -> float:
    """E^J of equation 8, unweighted, evaluated directly."""
    return float(0.5 * ((nodes[pairs.node] - leaves[pairs.leaf] - pairs.shift) ** 2).sum())
