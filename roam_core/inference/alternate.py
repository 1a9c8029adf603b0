"""Alternating inference: the exact best landmarks for a fixed curve, then the best moves for fixed landmarks."""

from __future__ import annotations

from dataclasses import dataclass

from roam_core.arrays import Array
from roam_core.cancel import CancelToken
from roam_core.energy import joint_total
from roam_core.energy.joint_total import LandmarkContext, Placing
from roam_core.energy.total import CurveContext, TableMemory
from roam_core.geometry import polyline
from roam_core.inference.contour_dp import best_moves, square_moves, untangled
from roam_core.inference.landmark_dp import best_star
from roam_core.params import LandmarkParams, RoamParams

ENOUGH = 1e-9
"""Relative fall of the joint energy under which a round counts as none."""


@dataclass(frozen=True, eq=False)
class JointSolution:
    """`nodes (N, 2)` and `placing` at the end, the joint energy after every step, and whether it stopped falling."""

    nodes: Array
    placing: Placing
    trace: tuple[float, ...]
    converged: bool


def alternate(
    nodes: Array,
    curve: CurveContext,
    landmarks: LandmarkContext,
    params: RoamParams,
    token: CancelToken | None = None,
) -> JointSolution:
    """Minimise the joint energy by its two exact steps in turn, coarse moves first, until it stops falling.

    Each step minimises over all that it may change, staying included, so the joint energy never rises; where a step
    gains only by rounding or by a curve that crosses itself (`untangled`), it is not taken. Every round is one step of
    the landmarks and one of the curve, at most `RoamParams.max_iterations` rounds for each of `RoamParams.steps`.
    """
    assert params.landmarks is not None

    def energy_of(nodes: Array, placing: Placing) -> float:
        return joint_total.energies(nodes, placing, curve, landmarks, params)["total"]

    placing, converged = Placing.expected(landmarks), True
    energy = energy_of(nodes, placing)
    trace, memory = [energy], TableMemory()
    for step in params.steps:
        moves = square_moves(params.window, step * landmarks.scale)
        for _ in range(params.max_iterations):
            if token is not None:
                token.check()
            before = energy
            placed, _ = best_landmarks(nodes, landmarks, params.landmarks)
            if (reached := energy_of(nodes, placed)) < energy:
                placing, energy = placed, reached
            trace.append(energy)
            moved = _best_curve(nodes, placing, moves, curve, landmarks, params, memory)
            if (reached := energy_of(moved, placing)) < energy:
                nodes, energy = moved, reached
            trace.append(energy)
            converged = before - energy <= ENOUGH * max(1.0, abs(energy))
            if converged:
                break
    return JointSolution(nodes, placing, tuple(trace), converged)


def best_landmarks(nodes: Array, context: LandmarkContext, params: LandmarkParams) -> tuple[Placing, float]:
    """The landmarks' step: the exact minimum of E^L + E^J over root and leaves with the curve fixed, and its energy."""
    spring = 0.5 * params.star * context.cell**2 / context.scale**2
    leaves, root, energy = best_star(joint_total.leaf_table(nodes, context, params), spring)
    return Placing(leaves, root), energy


def _best_curve(
    nodes: Array,
    placing: Placing,
    moves: Array,
    curve: CurveContext,
    landmarks: LandmarkContext,
    params: RoamParams,
    memory: TableMemory,
) -> Array:
    """The curve's step: the exact best moves of all nodes with the landmarks fixed, its loops taken back."""
    star, weights = placing.star(landmarks), params.landmarks
    assert weights is not None

    def pull(nodes: Array, moves: Array) -> Array:
        return joint_total.node_table(nodes, moves, star, landmarks, weights)

    moved, _ = best_moves(nodes, moves, curve, params, pull, memory)
    if polyline.is_simple(moved) or not polyline.is_simple(nodes):
        return moved
    return untangled(nodes, moved, params.untangling)
