"""E(X, Y) of equation 1: the weighted sum of the curve's, the landmarks' and their joint terms, and the oracle."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from roam_core.arrays import Array, Float32, Indices
from roam_core.energy import joint, landmark, total
from roam_core.energy.joint import Pairs
from roam_core.energy.total import CurveContext
from roam_core.landmarks.star import Star
from roam_core.params import LandmarkParams, RoamParams


@dataclass(frozen=True, eq=False)
class LandmarkContext:
    """What the landmarks' terms look at on one frame.

    Attributes
    ----------
    rest : the star as expected: the paper's y^_0 and y^_m, pre-warped.
    response : (M, n, n) the filters' answers on a lattice around each expected leaf, its middle; n is odd.
    cell : pixels between neighbours of the lattice; the root's place lies on one like it.
    pairs : the pairs n ~ m with their shifts mu_nm.
    scale : pixels to one of a 480-line image, in which the weights count.
    """

    rest: Star
    response: Float32
    cell: float
    pairs: Pairs
    scale: float

    @property
    def reach(self) -> int:
        """Cells from the middle of a lattice to its border."""
        return int(self.response.shape[1]) // 2

    def moves(self) -> Array:
        """The S displacements `(S, 2)` of a lattice in pixels, row by row."""
        ticks = self.cell * np.arange(-self.reach, self.reach + 1)
        columns, rows = np.meshgrid(ticks, ticks)
        return np.stack([columns.ravel(), rows.ravel()], axis=1)


@dataclass(frozen=True, eq=False)
class Placing:
    """Y as places on the lattices: row and column of each leaf `(M, 2)` and of the root `(2,)`."""

    leaves: Indices
    root: Indices

    @classmethod
    def expected(cls, context: LandmarkContext) -> Placing:
        """All in the middle: where the pre-warp puts them."""
        middle = np.full((len(context.response) + 1, 2), context.reach, dtype=np.intp)
        return cls(middle[1:], middle[0])

    def star(self, context: LandmarkContext) -> Star:
        """Y in pixels."""
        leaves = (self.leaves - context.reach)[:, ::-1] * context.cell
        root = (self.root - context.reach)[::-1] * context.cell
        return Star(context.rest.leaves + leaves, context.rest.root + root)


def energies(
    nodes: Array, placing: Placing, curve: CurveContext, context: LandmarkContext, params: RoamParams
) -> Mapping[str, float]:
    """The oracle: each term's weighted share at X = `nodes (N, 2)` and Y = `placing`, and their sum as "total".

    Beside the curve's terms: "landmarks" and "star" (equations 6 and 7), "joint" (equations 8 and 9).
    """
    assert params.landmarks is not None
    shares = {name: share for name, share in total.energies(nodes, curve, params).items() if name != "total"}
    shares |= landmark_energies(nodes, placing, context, params.landmarks)
    return shares | {"total": sum(shares.values())}


def landmark_energies(
    nodes: Array, placing: Placing, context: LandmarkContext, params: LandmarkParams
) -> dict[str, float]:
    """E^L and E^J alone, by term, evaluated directly."""
    star, square = placing.star(context), context.scale**2
    row, column = placing.leaves.T
    seen = landmark.unary_landmark(context.response[np.arange(len(row)), row, column])
    springs = landmark.pairwise_star(star.leaves, star.root, context.rest.leaves, context.rest.root)
    return {
        "landmarks": params.weight * float(seen.sum()),
        "star": params.star / square * float(springs.sum()),
        "joint": params.joint / square * joint.joint_energy(nodes, star.leaves, context.pairs),
    }


def leaf_table(nodes: Array, context: LandmarkContext, params: LandmarkParams) -> Array:
    """`(M, n, n)`: all of E^L + E^J that depends on one landmark alone, at each of its places, with the curve fixed."""
    pull = joint.unary_joint_leaves(nodes, context.rest.leaves, context.moves(), context.pairs)
    seen = params.weight * landmark.unary_landmark(context.response)
    return np.asarray(seen + params.joint / context.scale**2 * pull.reshape(seen.shape))


def node_table(nodes: Array, moves: Array, star: Star, context: LandmarkContext, params: LandmarkParams) -> Array:
    """`(N, D)`: E^J at each of the nodes' moves, with the landmarks fixed."""
    pull = joint.unary_joint_nodes(nodes, moves, star.leaves, context.pairs)
    return np.asarray(params.joint / context.scale**2 * pull)
