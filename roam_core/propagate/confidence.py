"""How far a solved frame can be trusted."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from roam_core.energy.total import CurveContext
from roam_core.geometry import polyline
from roam_core.motion.klt import Warp

Array = NDArray[np.float64]

REACH = 8
"""Pixels to both sides of the outline that are searched for a stronger edge than the one it lies on."""


def node_support(nodes: Array, context: CurveContext, scale: float) -> Array:
    """For each node, in [0, 1]: the edge under the outline against the strongest edge near it along the normal.

    One where the outline sits on the strongest edge around, near zero where it crosses a flat area beside an edge or
    lies where there is no edge at all.
    """
    here = context.local(nodes)
    normals = polyline.outward_normals(here)
    offsets = np.arange(-REACH, REACH + 1) * scale
    positions = here[:, None] + offsets[None, :, None] * normals[:, None]
    strength = np.sqrt(_lookup(context.squared_gradient, positions))
    weak = 0.15  # an edge as faint as grain supports nothing
    near = np.abs(offsets) <= 1.5 * scale
    return np.asarray(strength[:, near].max(axis=1) / np.maximum(strength.max(axis=1), weak))


def frame_confidence(support: Array, warp: Warp) -> float:
    """Trust in a frame, in [0, 1]: mean support of the nodes, less where the followed points disagree."""
    motion = 0.5 + 0.5 * warp.agreement if warp.points >= 3 else 0.5
    return float(np.clip(support.mean() * motion, 0.0, 1.0))


def _lookup(field: NDArray[np.float32], positions: Array) -> Array:
    """Values of `field` under `positions (..., 2)`; zero outside."""
    height, width = field.shape
    column, row = (np.floor(positions[..., k]).astype(np.intp) for k in (0, 1))
    inside = (column >= 0) & (column < width) & (row >= 0) & (row < height)
    values = np.zeros(positions.shape[:-1])
    values[inside] = field[row[inside], column[inside]]
    return values
