"""How far an outline is to move on each frame, place by place, to go with the motion of the picture: least squares."""

from __future__ import annotations

import numpy as np
from scipy.linalg import solveh_banded

from roam_core.arrays import Array, Bools
from roam_core.params.steadiness import SteadinessParams


def settled(steps: Array, trust: Array, fixed: Bools, strength: float, params: SteadinessParams, scale: float) -> Array:
    """How far outwards each place `(T, N)` of an outline is to move on each of `T` frames: pixels.

    The displacements `d` minimise, for every place by itself, `|d|^2` and, times `strength`,
    `step |e_t|^2 + turn |e_t - e_(t-1)|^2`, where `e_t = steps_t + d_(t+1) - d_t` is what the outline then does from
    frame `t` to the next beyond the motion of the picture. Each counts as far as the flow is to be trusted and as what
    is left is no larger than boil.

    Parameters
    ----------
    steps : (T - 1, N) what the outline does beyond the motion of the picture (`residual`).
    trust : (T - 1, N) in [0, 1]; 0 where nothing is known.
    fixed : (T,) frames on which nothing may move. strength : in [0, 1].
    """
    found = np.zeros((len(steps) + 1, steps.shape[1]))
    alike = params.alike * scale
    for _ in range(params.rounds):
        left = steps + np.diff(found, axis=0)
        step = strength * params.step * trust * _heard(left, alike)
        both = np.minimum(trust[1:], trust[:-1])
        turn = strength * params.turn * both * _heard(0.5 * np.diff(left, axis=0), alike)
        found = _solved(steps, step, turn, fixed)
    return found


def _heard(left: Array, alike: float) -> Array:
    return np.asarray(np.exp(-((left / alike) ** 2)))


def _solved(steps: Array, step: Array, turn: Array, fixed: Bools) -> Array:
    """The displacements for given weights: one banded system, place after place."""
    frames, count = len(steps) + 1, steps.shape[1]
    # A frame is tied to the two after it: a symmetric matrix of five diagonals, of which the upper three are told.
    bands, right = np.zeros((3, frames, count)), np.zeros((frames, count))
    further, next_one, own = bands
    own += 1.0
    for weight, by, stencil in ((step, steps, (-1.0, 1.0)), (turn, np.diff(steps, axis=0), (1.0, -2.0, 1.0))):
        rows = len(weight)
        for a, first in enumerate(stencil):
            right[a : a + rows] -= first * weight * by
            own[a : a + rows] += first * first * weight
            for b in range(a + 1, len(stencil)):
                band = next_one if b - a == 1 else further
                band[b : b + rows] += first * stencil[b] * weight
    # A frame that is fixed stands in no other's equation: its displacement is nothing.
    held = np.flatnonzero(fixed)
    for band, apart in ((next_one, 1), (further, 2)):
        band[held] = 0.0
        band[held[held + apart < frames] + apart] = 0.0
    own[held], right[held] = 1.0, 0.0
    in_a_row = bands.transpose(0, 2, 1).reshape(len(bands), -1)
    return np.asarray(solveh_banded(in_a_row, right.T.reshape(-1)).reshape(count, frames).T)
