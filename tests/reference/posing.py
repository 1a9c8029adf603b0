"""An articulated template laid on a picture, one sample after the other."""

from __future__ import annotations

import numpy as np
from scipy.linalg import expm

from roam_core.arrays import Array, Float32
from roam_core.kernels.posing import ANGLE, PARENT, PIVOT_X, Costs, Prior, Samples, Ties, View


def ref_affines(bones: Array, pose: Array) -> Array:
    """`kernels.posing.affines`, the strain as the exponential of its matrix."""
    count = len(bones)
    along, across, shear = pose[2 + count :]
    strain = expm(np.array([[along, shear], [shear, across]]))
    result = np.empty((count, 2, 3))
    for k, bone in enumerate(bones):
        axes, pivot = _turn(bone[ANGLE]), bone[PIVOT_X : PIVOT_X + 2]
        linear = _turn(pose[2 + k]) @ axes @ strain @ axes.T
        parent = int(bone[PARENT])
        there = pivot + pose[:2] if parent < 0 else result[parent] @ [*pivot, 1.0]
        result[k] = np.column_stack([linear, there - linear @ pivot])
    return result


def ref_carried(bones: Array, pose: Array, places: Array, skin: Array) -> Array:
    """Places `(n, 2)` under a pose, by the shares `(n, K)` of the bones in them."""
    each = [places @ matrix[:, :2].T + matrix[:, 2] for matrix in ref_affines(bones, pose)]
    return np.asarray(sum(skin[:, k, None] * moved for k, moved in enumerate(each)))


def ref_energy(
    view: View, samples: Samples, bones: Array, pose: Array, costs: Costs, prior: Prior, ties: Ties, rim: float = 0.0
) -> float:
    """What one pose costs (`kernels.posing.energies`); closer to the border than `rim` nothing is seen."""
    total = ref_prior(bones, pose, prior) + ref_ties(bones, pose, ties)
    rows, columns = view.image.shape[:2]
    there = ref_carried(bones, pose, samples.places, samples.skin)
    cells = (there - (view.left, view.top)) * (view.scale_x, view.scale_y) - 0.5
    for (x, y), colour, weight in zip(cells, samples.colours, samples.weights, strict=True):
        own = max(weight, 0.0)
        if not (rim <= x < columns - 1 - rim and rim <= y < rows - 1 - rim):
            total += own * costs.beyond
            continue
        place = int(np.floor(y + 0.5)), int(np.floor(x + 0.5))
        if view.hidden[place]:
            total += own * costs.hidden
            continue
        apart, need = float(((_bilinear(view.image, x, y) - colour) ** 2).sum()), float(view.needs[place])
        if weight > 0:
            total += weight * (apart / (apart + costs.like**2) + costs.needless * (1.0 - need))
        else:
            total += costs.needed * need - weight * np.exp(-apart / (2.0 * costs.beside**2))
    return total


def ref_prior(bones: Array, pose: Array, prior: Prior) -> float:
    """What a pose costs for being unexpected, unlike the key or bent."""
    total = 0.5 * float(prior.firmness @ (pose - prior.expected) ** 2 + prior.rest @ pose**2)
    turns, expected = pose[2 : 2 + len(bones)], prior.expected[2 : 2 + len(bones)]
    for k, parent in enumerate(bones[:, PARENT].astype(int)):
        if parent >= 0:
            bent, usual = turns[k] - turns[parent], expected[k] - expected[parent]
            total += 0.5 * (prior.bend * (bent - usual) ** 2 + prior.straight * bent**2)
    return float(total)


def ref_ties(bones: Array, pose: Array, ties: Ties) -> float:
    """What the springs cost."""
    if len(ties.places) == 0:
        return 0.0
    away = ((ref_carried(bones, pose, ties.places, ties.skin) - ties.targets) ** 2).sum(axis=1)
    return float(ties.weights @ (away / (away + ties.reach**2)))


def _turn(angle: float) -> Array:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s], [s, c]])


def _bilinear(image: Float32, x: float, y: float) -> Array:
    column, row = int(x), int(y)
    u, v = x - column, y - row
    patch = image[row : row + 2, column : column + 2].astype(np.float64)
    return np.asarray(
        (1 - v) * ((1 - u) * patch[0, 0] + u * patch[0, 1]) + v * ((1 - u) * patch[1, 0] + u * patch[1, 1])
    )
