"""How the manta moves: a bending surface in time, from its rest pose to the plate, and back again.

The rest pose lies flat: `u` runs along the body (head positive), `v` across it (right wing positive), in units of
half the wing span. A surface point is bent (wing beat, sweep of the tips, curve of the body), turned in space (heading,
bank, pitch) and seen in perspective.
"""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from . import camera
from .timing import FIRST, Array, progress

HALF_SPAN = 170.0
"""Half the wing span on the plate in pixels, at scale 1."""

BEAT = 42.0
"""Frames of one wing beat."""

DISTANCE = 6.5
"""From camera to manta, in half spans: how strong its perspective is."""

COURSE = np.array([[352.0, 324.0], [418.0, 344.0], [500.0, 318.0], [556.0, 258.0]])
"""Cubic Bezier course of the body on the plate over the whole shot, without the camera's sway."""

REST_LIMIT = 1.45
GRID_STEP = 8
"""Pixels between the nodes of the coarse grids. A power of two: OpenCV interpolates at multiples of 1/32 of a cell."""


def surface(rest: Array, frame: float) -> Array:
    """Plate positions and height of surface points.

    Parameters
    ----------
    rest : (..., 2) positions in the rest pose.
    frame : the moment; fractions are for motion blur.

    Returns
    -------
    (..., 3) x and y in plate pixels, z towards the camera in pixels.
    """
    x, y, z = _bent(rest, frame)
    along, across, up = _turned(x, y, z, frame)
    scale = HALF_SPAN * _scale(frame)
    magnified = scale * DISTANCE / (DISTANCE - up)
    centre = _centre(frame)
    return np.stack([centre[0] + magnified * along, centre[1] + magnified * across, scale * up], axis=-1)


def jacobian(rest: Array, frame: float) -> Array:
    """Derivatives `(..., 3, 2)` of `surface` with respect to the rest position, by central differences."""
    step = 1e-4
    columns = [
        (surface(rest + offset, frame) - surface(rest - offset, frame)) / (2.0 * step)
        for offset in (np.array([step, 0.0]), np.array([0.0, step]))
    ]
    return np.stack(columns, axis=-1)


def rest_positions(left: int, top: int, width: int, height: int, frame: float) -> Array:
    """Rest positions `(rows, columns, 2)` of a coarse grid of plate points: `surface` inverted by Newton's method.

    The grid has a node each `GRID_STEP` pixels from the centre of the window's first pixel and reaches past its end.
    Far outside the manta, where the bent surface folds, the answer is only kept finite: nothing is drawn there.
    """
    columns = left + 0.5 + GRID_STEP * np.arange(width // GRID_STEP + 2)
    rows = top + 0.5 + GRID_STEP * np.arange(height // GRID_STEP + 2)
    target = np.stack(np.meshgrid(columns, rows), axis=-1)
    origin = np.zeros(2)
    start = np.linalg.inv(jacobian(origin, frame)[:2])
    rest = np.clip((target - surface(origin, frame)[:2]) @ start.T, -REST_LIMIT, REST_LIMIT)
    for _ in range(4):
        error = target - surface(rest, frame)[..., :2]
        j = jacobian(rest, frame)[..., :2, :]
        determinant = j[..., 0, 0] * j[..., 1, 1] - j[..., 0, 1] * j[..., 1, 0]
        determinant = np.where(np.abs(determinant) < 400.0, 400.0, determinant)
        du = (j[..., 1, 1] * error[..., 0] - j[..., 0, 1] * error[..., 1]) / determinant
        dv = (j[..., 0, 0] * error[..., 1] - j[..., 1, 0] * error[..., 0]) / determinant
        rest = np.clip(rest + np.clip(np.stack([du, dv], axis=-1), -0.4, 0.4), -REST_LIMIT, REST_LIMIT)
    return rest


def spread(grid: Array, width: int, height: int) -> NDArray[np.float32]:
    """A coarse grid `(rows, columns, C)`, C up to 4, laid out as by `rest_positions`, on all pixels of its window."""
    matrix = np.array([[1.0 / GRID_STEP, 0.0, 0.0], [0.0, 1.0 / GRID_STEP, 0.0]])
    flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    source = np.ascontiguousarray(grid, dtype=np.float32)
    return np.asarray(cv2.warpAffine(source, matrix, (width, height), flags=flags), dtype=np.float32)


def height_above_ground(frame: float) -> float:
    """How far the body swims above the sand, in pixels: the length of its shadow's throw."""
    return float(62.0 + 34.0 * progress(frame))


# ---- the movements ---------------------------------------------------------------------------------------------------


def _bent(rest: Array, frame: float) -> tuple[Array, Array, Array]:
    """The surface in the manta's own space: wings curl on circular arcs, the tips sweep, the body curves in plane."""
    u, v = rest[..., 0], rest[..., 1]
    phase = 2.0 * np.pi * (frame - FIRST) / BEAT
    p = float(progress(frame))
    side = np.tanh(2.5 * v)

    # The beat runs outwards and backwards: tips and trailing edge follow late. In a turn the inner wing beats less.
    curl = 0.20 + 0.54 * np.sin(phase - 0.6 * side * side + 0.8 * u) + 0.16 * np.sin(np.pi * p) * side
    curl = np.where(np.abs(curl) < 1e-6, 1e-6, curl)
    across = np.sin(curl * v) / curl
    up = (1.0 - np.cos(curl * v)) / curl

    reach = v * v
    sweep = -0.09 * np.sin(phase - 1.9) - 0.04 + (0.10 * np.sin(1.2 * np.pi * p) - 0.03) * side
    along = u + sweep * reach

    # Curve of the body: bend the long axis to a circle, rows across it stay straight.
    bend = 0.05 - 0.30 * np.sin(np.pi * (1.35 * p - 0.18)) + 0.08 * np.sin(phase)
    bend = bend if abs(bend) > 1e-6 else 1e-6
    angle = bend * along
    x = np.sin(angle) / bend - across * np.sin(angle)
    y = (1.0 - np.cos(angle)) / bend + across * np.cos(angle)
    return x, y, up


def _turned(x: Array, y: Array, z: Array, frame: float) -> tuple[Array, Array, Array]:
    """Bank about the long axis, pitch about the cross axis, then heading in the plane of the plate."""
    p = float(progress(frame))
    phase = 2.0 * np.pi * (frame - FIRST) / BEAT
    bank = np.radians(4.0 + 13.0 * np.sin(np.pi * p) ** 2)
    pitch = np.radians(6.0 * np.sin(phase + 0.6))
    y, z = y * np.cos(bank) - z * np.sin(bank), y * np.sin(bank) + z * np.cos(bank)
    x, z = x * np.cos(pitch) - z * np.sin(pitch), x * np.sin(pitch) + z * np.cos(pitch)
    heading = _heading(frame)
    c, s = np.cos(heading), np.sin(heading)
    return x * c - y * s, x * s + y * c, z


def _heading(frame: float) -> float:
    """Direction of swimming over the ground, that of course and camera together: radians, clockwise on screen."""
    p = float(progress(frame))
    a, b, c, d = COURSE
    velocity = 3.0 * ((1 - p) ** 2 * (b - a) + 2 * (1 - p) * p * (c - b) + p**2 * (d - c)) + camera.PAN
    return float(np.arctan2(velocity[1], velocity[0]))


def _centre(frame: float) -> Array:
    """Where the body is on the plate; each down stroke pushes it a little forward."""
    p = float(progress(frame))
    a, b, c, d = COURSE
    s = 1.0 - p
    course = s**3 * a + 3 * s * s * p * b + 3 * s * p * p * c + p**3 * d
    phase = 2.0 * np.pi * (frame - FIRST) / BEAT
    heading = _heading(frame)
    surge = 2.0 * np.sin(phase + 2.4) * np.array([np.cos(heading), np.sin(heading)])
    return np.asarray(course + surge - 1.4 * camera.sway(frame))


def _scale(frame: float) -> float:
    """The manta climbs towards the camera while it swims."""
    return float(0.90 + 0.12 * progress(frame))
