"""The manta's true outline: a closed cubic Bezier spline of constant points, known at every moment of the shot."""

from __future__ import annotations

import numpy as np

from . import body
from .timing import Array

STEPS = 20
"""Polyline vertices per Bezier segment when the outline is drawn."""

# One row for each control point of the right side, from the head to the tail, in the rest pose (see `body`):
# anchor u, v; direction of the outline there in degrees (0 = forward, 90 = towards the right wing tip); lengths of the
# in- and out-handle. The first and the last row lie on the axis, the others are mirrored.
_SIDE = np.array(
    [
        [0.420, 0.000, 90.0, 0.050, 0.050],  # the mouth, between the lobes
        [0.535, 0.150, 96.0, 0.050, 0.050],  # cephalic lobe
        [0.375, 0.240, 118.0, 0.070, 0.110],  # where the wing begins
        [0.215, 0.560, 113.0, 0.130, 0.170],  # leading edge
        [-0.200, 1.000, 166.0, 0.150, 0.070],  # wing tip
        [-0.260, 0.560, -84.0, 0.150, 0.130],  # trailing edge
        [-0.475, 0.180, -140.0, 0.120, 0.060],  # pelvic fin
        [-0.570, 0.050, 178.0, 0.055, 0.090],  # root of the tail
        [-0.860, 0.000, -90.0, 0.020, 0.020],  # end of the tail
    ]
)


def rest_points() -> Array:
    """The outline in the rest pose, `(16, 3, 2)`: anchor, in-handle, out-handle."""
    anchor, angle = _SIDE[:, :2], np.radians(_SIDE[:, 2])
    tangent = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    right = np.stack([anchor, anchor - _SIDE[:, 3:4] * tangent, anchor + _SIDE[:, 4:5] * tangent], axis=1)
    # The left side runs the other way: from tail to head, its in-handles are the right side's out-handles.
    left = right[-2:0:-1, [0, 2, 1]] * (1.0, -1.0)
    return np.concatenate([right, left])


def true_points(frame: float) -> Array:
    """The true outline `(16, 3, 2)` at `frame`: anchor, in- and out-handle of each point, in plate pixels, y down.

    A whole frame is the middle of its shutter; fractions lie between. Anchors ride on the moving surface and handles
    are carried by its derivative there, so that a smooth point stays smooth.
    """
    rest = rest_points()
    anchors = rest[:, 0]
    position = body.surface(anchors, frame)[:, :2]
    tangents = body.jacobian(anchors, frame)[:, :2]
    offsets = np.einsum("pij,phj->phi", tangents, rest - anchors[:, None])
    return np.asarray(position[:, None] + offsets)


def polyline(points: Array) -> Array:
    """A closed outline `(P, 3, 2)` as polyline `(P * STEPS, 2)`; its first vertex is the first anchor."""
    following = np.roll(points, -1, axis=0)
    control = np.stack([points[:, 0], points[:, 2], following[:, 1], following[:, 0]], axis=1)
    t = np.arange(STEPS) / STEPS
    s = 1.0 - t
    weights = np.stack([s**3, 3 * s * s * t, 3 * s * t * t, t**3], axis=1)
    return np.asarray(np.einsum("tk,pkc->ptc", weights, control).reshape(-1, 2))
