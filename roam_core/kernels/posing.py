"""An articulated template laid on a picture: what each pose costs, and the pose near another one that costs least.

A template is a set of places with the colours that they had on the key. Bones carry them (linear blend skinning): bone
k turns about its pivot, which its parent carries, and all of them stretch alike. A pose is the vector

    (move x, move y, turn of each bone ..., stretch along the bones, stretch across, shear)

of 5 + K numbers; turns in radians, the last three the logarithms of a strain (Hencky). It costs the mean, over the
template, of d^2 / (d^2 + T^2), with d the difference of colours (Geman and McClure, 1987), and, over the places beside
the outline whose colour differed from the inside on the key, the mean of exp(-d^2 / (2 tau^2)), with d the difference
from the inside: the outline has not reached an edge there, or gone beyond it. What a nearer part hides, and what lies
outside the picture, costs a constant. Where it is known which places of the picture need the part, because they belong
to the object and to no other part, the template is drawn there. Ties are springs to places of other parts; a stretched
one gives way. Minimised by Levenberg and Marquardt.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numba import njit

from roam_core.arrays import Array, Float32, UInt8
from roam_core.kernels.small_systems import solve_positive

PIVOT_X, PIVOT_Y, PARENT, ANGLE = 0, 1, 2, 3
"""Columns of the bones `(K, 4)`, parents first: a pivot, the parent's row or -1, the direction of the axis."""
RIM = 1.0
"""Cells inside a picture's border where nothing is seen while a pose is refined: a slope needs what lies beside it."""


class View(NamedTuple):
    """A picture `(h, w, C)` float32, its cells a pixel along x and y, where its corner lies in the whole picture
    (pixels); what is `hidden` in it `(h, w)`: not zero where a nearer part lies; and what `needs` the part `(h, w)`, in
    [0, 1].
    """

    image: Float32
    scale_x: float
    scale_y: float
    left: float
    top: float
    hidden: UInt8
    needs: Float32


class Samples(NamedTuple):
    """Places `(n, 2)` on the key, their colours `(n, C)`, weights `(n,)`, and the shares `(n, K)` of the bones in them.

    Weights above zero are the template's own and add up to one. Those below zero belong to places beside the outline,
    whose colours here are those inside.
    """

    places: Array
    colours: Array
    weights: Array
    skin: Array


class Costs(NamedTuple):
    """T, tau (differences of colour), and what a sample costs that is hidden, or outside the picture.

    A sample of the template's own costs `needless` where nothing needs it, each one beside it `needed` where it is.
    """

    like: float
    beside: float
    hidden: float
    beyond: float
    needless: float = 0.0
    needed: float = 0.0


class Prior(NamedTuple):
    """The pose that is `expected (P,)`; how firmly `(P,)`; how firmly each number is drawn to zero, `rest (P,)`; and
    the same two for the difference between each bone's turn and its parent's.
    """

    expected: Array
    firmness: Array
    rest: Array
    bend: float
    straight: float


class Ties(NamedTuple):
    """Springs from places `(m, 2)` of the key, with the bones' shares `(m, K)`, to where they should lie, `(m, 2)`.

    Each costs its weight `(m,)` times d^2 / (d^2 + reach^2), d the distance in pixels.
    """

    places: Array
    skin: Array
    targets: Array
    weights: Array
    reach: float


def affines(bones: Array, pose: Array) -> Array:
    """The affine map `(K, 2, 3)` of each bone, key to picture."""
    result = np.empty((len(bones), 2, 3))
    _affines(bones, np.ascontiguousarray(pose), result)
    return result


def energies(view: View, samples: Samples, bones: Array, poses: Array, costs: Costs, prior: Prior, ties: Ties) -> Array:
    """What each of `poses (m, P)` costs, `(m,)`, prior and ties included."""
    result = np.empty(len(poses))
    samples, ties = _packed(samples, ties)
    _energies(*view, *samples, bones, np.ascontiguousarray(poses), *costs, *prior, *ties, result)
    return result


def refined(
    view: View, samples: Samples, bones: Array, start: Array, costs: Costs, prior: Prior, ties: Ties, rounds: int
) -> tuple[Array, float]:
    """The pose `(P,)` that `rounds` of Levenberg and Marquardt lead to from `start (P,)`, and what it costs."""
    samples, ties = _packed(samples, ties)
    pose, energy = _refined(*view, *samples, bones, np.ascontiguousarray(start), *costs, *prior, *ties, rounds)
    return np.asarray(pose), float(energy)


def _packed(samples: Samples, ties: Ties) -> tuple[Samples, Ties]:
    """The same with contiguous arrays: a kernel is compiled again for every other layout."""
    places, skin, targets, weights = map(np.ascontiguousarray, (ties.places, ties.skin, ties.targets, ties.weights))
    return Samples(*map(np.ascontiguousarray, samples)), Ties(places, skin, targets, weights, ties.reach)


@njit(nogil=True, cache=True)
def _affines(bones, pose, result):  # type: ignore[no-untyped-def]
    count = len(bones)
    along, across, shear = pose[2 + count], pose[3 + count], pose[4 + count]
    # exp of the symmetric matrix [[along, shear], [shear, across]]
    middle, half = 0.5 * (along + across), 0.5 * (along - across)
    radius = np.sqrt(half * half + shear * shear)
    grown, ratio = np.exp(middle), 1.0
    if radius > 1e-9:
        ratio = np.sinh(radius) / radius
    x11 = grown * (np.cosh(radius) + ratio * half)
    x22 = grown * (np.cosh(radius) - ratio * half)
    x12 = grown * ratio * shear
    for k in range(count):
        parent = int(bones[k, PARENT])
        c, s = np.cos(bones[k, ANGLE]), np.sin(bones[k, ANGLE])
        a = c * c * x11 - 2.0 * c * s * x12 + s * s * x22
        b = c * s * x11 + (c * c - s * s) * x12 - c * s * x22
        d = s * s * x11 + 2.0 * c * s * x12 + c * c * x22
        turned_c, turned_s = np.cos(pose[2 + k]), np.sin(pose[2 + k])
        x, y = bones[k, PIVOT_X], bones[k, PIVOT_Y]
        if parent < 0:
            there_x, there_y = x + pose[0], y + pose[1]
        else:
            there_x = result[parent, 0, 0] * x + result[parent, 0, 1] * y + result[parent, 0, 2]
            there_y = result[parent, 1, 0] * x + result[parent, 1, 1] * y + result[parent, 1, 2]
        result[k, 0, 0], result[k, 0, 1] = turned_c * a - turned_s * b, turned_c * b - turned_s * d
        result[k, 1, 0], result[k, 1, 1] = turned_s * a + turned_c * b, turned_s * b + turned_c * d
        result[k, 0, 2] = there_x - result[k, 0, 0] * x - result[k, 0, 1] * y
        result[k, 1, 2] = there_y - result[k, 1, 0] * x - result[k, 1, 1] * y


@njit(nogil=True, cache=True, inline="always")
def _between(image, row, column, channel, u, v):  # type: ignore[no-untyped-def]
    """What lies `u`, `v` of a cell beyond the centre of a cell."""
    above = image[row, column, channel] * (1.0 - u) + image[row, column + 1, channel] * u
    below = image[row + 1, column, channel] * (1.0 - u) + image[row + 1, column + 1, channel] * u
    return above * (1.0 - v) + below * v


@njit(nogil=True, cache=True, inline="always")
def _unseen(hidden, x, y, rim, behind, beyond):  # type: ignore[no-untyped-def]
    """What a sample costs that is not seen at `x`, `y` (cells), or within `rim` of the border; else below zero."""
    rows, columns = hidden.shape
    if x < rim or y < rim or x >= columns - 1 - rim or y >= rows - 1 - rim:
        return beyond
    return behind if hidden[int(y + 0.5), int(x + 0.5)] > 0 else -1.0


@njit(nogil=True, cache=True, inline="always")
def _compared(image, x, y, colours, i, errors):  # type: ignore[no-untyped-def]
    """The squared difference of colours between the picture at `x`, `y` and sample `i`; `errors (C,)` are made it."""
    column, row = int(x), int(y)
    apart = 0.0
    for channel in range(len(errors)):
        errors[channel] = _between(image, row, column, channel, x - column, y - row) - colours[i, channel]
        apart += errors[channel] ** 2
    return apart


@njit(nogil=True, cache=True)
def _carried(matrices, skin, i, x, y):  # type: ignore[no-untyped-def]
    there_x, there_y = 0.0, 0.0
    for k in range(len(matrices)):
        share = skin[i, k]
        if share > 0.0:
            there_x += share * (matrices[k, 0, 0] * x + matrices[k, 0, 1] * y + matrices[k, 0, 2])
            there_y += share * (matrices[k, 1, 0] * x + matrices[k, 1, 1] * y + matrices[k, 1, 2])
    return there_x, there_y


@njit(nogil=True, cache=True)
def _prior_cost(bones, pose, expected, firmness, rest, bend, straight):  # type: ignore[no-untyped-def]
    cost = 0.0
    for a in range(len(pose)):
        cost += 0.5 * (firmness[a] * (pose[a] - expected[a]) ** 2 + rest[a] * pose[a] ** 2)
    for k in range(len(bones)):
        parent = int(bones[k, PARENT])
        if parent >= 0:
            bent = pose[2 + k] - pose[2 + parent]
            cost += 0.5 * (bend * (bent - expected[2 + k] + expected[2 + parent]) ** 2 + straight * bent * bent)
    return cost


@njit(nogil=True, cache=True)
def _tie_cost(matrices, tied, tied_skin, targets, springs, reach):  # type: ignore[no-untyped-def]
    cost = 0.0
    for m in range(len(tied)):
        x, y = _carried(matrices, tied_skin, m, tied[m, 0], tied[m, 1])
        away = (x - targets[m, 0]) ** 2 + (y - targets[m, 1]) ** 2
        cost += springs[m] * away / (away + reach * reach)
    return cost


@njit(nogil=True, cache=True)
def _energies(  # type: ignore[no-untyped-def]
    image, scale_x, scale_y, left, top, hidden, needs, places, colours, weights, skin, bones, poses, like, beside,
    behind, beyond, needless, needed, expected, firmness, rest, bend, straight, tied, tied_skin, targets, springs,
    reach, result,
):  # fmt: skip
    matrices, errors = np.empty((len(bones), 2, 3)), np.empty(image.shape[2])
    like2, beside2 = like * like, 2.0 * beside * beside
    for j in range(len(poses)):
        _affines(bones, poses[j], matrices)
        cost = _prior_cost(bones, poses[j], expected, firmness, rest, bend, straight)
        cost += _tie_cost(matrices, tied, tied_skin, targets, springs, reach)
        for i in range(len(places)):
            weight = weights[i]
            x, y = _carried(matrices, skin, i, places[i, 0], places[i, 1])
            x, y = (x - left) * scale_x - 0.5, (y - top) * scale_y - 0.5
            unseen = _unseen(hidden, x, y, 0.0, behind, beyond)
            if unseen >= 0.0:
                cost += max(weight, 0.0) * unseen
                continue
            apart = _compared(image, x, y, colours, i, errors)
            need = needs[int(y + 0.5), int(x + 0.5)]
            if weight > 0.0:
                cost += weight * (apart / (apart + like2) + needless * (1.0 - need))
            else:
                cost += needed * need - weight * np.exp(-apart / beside2)
        result[j] = cost


@njit(nogil=True, cache=True)
def _axes(bones, pose, axes):  # type: ignore[no-untyped-def]
    """The directions `(K, 2)` of the bones' axes under a pose."""
    for k in range(len(bones)):
        angle = bones[k, ANGLE] + pose[2 + k]
        axes[k, 0], axes[k, 1] = np.cos(angle), np.sin(angle)


@njit(nogil=True, cache=True)
def _slopes(matrices, axes, bones, skin, i, place_x, place_y, slopes):  # type: ignore[no-untyped-def]
    """Where place `i` is carried, and the derivatives `(2, P)` of that by the pose."""
    count = len(bones)
    slopes[:] = 0.0
    slopes[0, 0], slopes[1, 1] = 1.0, 1.0
    there_x, there_y = 0.0, 0.0
    for k in range(count):
        share = skin[i, k]
        if share <= 0.0:
            continue
        there_x += share * (matrices[k, 0, 0] * place_x + matrices[k, 0, 1] * place_y + matrices[k, 0, 2])
        there_y += share * (matrices[k, 1, 0] * place_x + matrices[k, 1, 1] * place_y + matrices[k, 1, 2])
        x, y, m = place_x, place_y, k
        while m >= 0:  # the bone's own part of the way, and what each of its ancestors adds
            away_x, away_y = x - bones[m, PIVOT_X], y - bones[m, PIVOT_Y]
            u = matrices[m, 0, 0] * away_x + matrices[m, 0, 1] * away_y
            v = matrices[m, 1, 0] * away_x + matrices[m, 1, 1] * away_y
            slopes[0, 2 + m] -= share * v
            slopes[1, 2 + m] += share * u
            c, s = axes[m, 0], axes[m, 1]
            ahead, aside = c * u + s * v, c * v - s * u
            slopes[0, 2 + count] += share * c * ahead
            slopes[1, 2 + count] += share * s * ahead
            slopes[0, 3 + count] -= share * s * aside
            slopes[1, 3 + count] += share * c * aside
            slopes[0, 4 + count] += share * (c * aside - s * ahead)
            slopes[1, 4 + count] += share * (s * aside + c * ahead)
            x, y, m = bones[m, PIVOT_X], bones[m, PIVOT_Y], int(bones[m, PARENT])
    return there_x, there_y


@njit(nogil=True, cache=True)
def _system(  # type: ignore[no-untyped-def]
    image, scale_x, scale_y, left, top, hidden, needs, places, colours, weights, skin, bones, pose, like, beside,
    behind, beyond, needless, needed, normal, right,
):  # fmt: skip
    """The cost without prior and ties; `normal (P, P)` and `right (P,)` are made those of Gauss and Newton."""
    rows, columns, channels = image.shape
    size = len(pose)
    matrices, axes = np.empty((len(bones), 2, 3)), np.empty((len(bones), 2))
    slopes, errors = np.empty((2, size)), np.empty(channels)
    _affines(bones, pose, matrices)
    _axes(bones, pose, axes)
    normal[:] = 0.0
    right[:] = 0.0
    like2, beside2 = like * like, 2.0 * beside * beside
    cost = 0.0
    for i in range(len(places)):
        weight = weights[i]
        x, y = _slopes(matrices, axes, bones, skin, i, places[i, 0], places[i, 1], slopes)
        x, y = (x - left) * scale_x - 0.5, (y - top) * scale_y - 0.5
        unseen = _unseen(hidden, x, y, RIM, behind, beyond)
        if unseen >= 0.0:
            cost += max(weight, 0.0) * unseen
            continue
        apart = _compared(image, x, y, colours, i, errors)
        column, row = int(x + 0.5), int(y + 0.5)
        cost += weight * needless * (1.0 - needs[row, column]) if weight > 0.0 else needed * needs[row, column]
        pull = weight * needless if weight > 0.0 else -needed
        if pull != 0.0 and column >= 2 and row >= 2 and column < columns - 2 and row < rows - 2:
            dx = 0.25 * scale_x * (needs[row, column + 2] - needs[row, column - 2])
            dy = 0.25 * scale_y * (needs[row + 2, column] - needs[row - 2, column])
            for a in range(size):
                right[a] += pull * (dx * slopes[0, a] + dy * slopes[1, a])
        if weight > 0.0:
            cost += weight * apart / (apart + like2)
            share = 2.0 * weight * like2 / (apart + like2) ** 2
            if share * like2 < 2e-3 * weight:
                continue
        else:
            alike = -weight * np.exp(-apart / beside2)
            cost += alike
            share = -2.0 * alike / beside2
        column, row = int(x), int(y)
        u, v = x - column, y - row
        xx, xy, yy, error_x, error_y = 0.0, 0.0, 0.0, 0.0, 0.0
        for channel in range(channels):
            ahead = _between(image, row, column + 1, channel, u, v)
            dx = 0.5 * scale_x * (ahead - _between(image, row, column - 1, channel, u, v))
            below = _between(image, row + 1, column, channel, u, v)
            dy = 0.5 * scale_y * (below - _between(image, row - 1, column, channel, u, v))
            xx, xy, yy = xx + dx * dx, xy + dx * dy, yy + dy * dy
            error_x, error_y = error_x + dx * errors[channel], error_y + dy * errors[channel]
        for a in range(size):
            right[a] -= share * (slopes[0, a] * error_x + slopes[1, a] * error_y)
        if weight > 0.0:  # what repels has no curvature that could be used
            for a in range(size):
                along = share * (slopes[0, a] * xx + slopes[1, a] * xy)
                across = share * (slopes[0, a] * xy + slopes[1, a] * yy)
                for b in range(a, size):
                    normal[a, b] += along * slopes[0, b] + across * slopes[1, b]
    for a in range(size):
        for b in range(a):
            normal[a, b] = normal[b, a]
    return cost


@njit(nogil=True, cache=True)
def _tie_system(bones, pose, tied, tied_skin, targets, springs, reach, normal, right):  # type: ignore[no-untyped-def]
    """The cost of the ties; they are added to `normal (P, P)` and `right (P,)`."""
    size, cost = len(pose), 0.0
    if len(tied) == 0:
        return cost
    matrices, axes, slopes = np.empty((len(bones), 2, 3)), np.empty((len(bones), 2)), np.empty((2, size))
    _affines(bones, pose, matrices)
    _axes(bones, pose, axes)
    for m in range(len(tied)):
        x, y = _slopes(matrices, axes, bones, tied_skin, m, tied[m, 0], tied[m, 1], slopes)
        x, y = x - targets[m, 0], y - targets[m, 1]
        away, bound = x * x + y * y, reach * reach
        cost += springs[m] * away / (away + bound)
        share = 2.0 * springs[m] * bound / (away + bound) ** 2
        for a in range(size):
            right[a] -= share * (slopes[0, a] * x + slopes[1, a] * y)
            for b in range(size):
                normal[a, b] += share * (slopes[0, a] * slopes[0, b] + slopes[1, a] * slopes[1, b])
    return cost


@njit(nogil=True, cache=True)
def _refined(  # type: ignore[no-untyped-def]
    image, scale_x, scale_y, left, top, hidden, needs, places, colours, weights, skin, bones, start, like, beside,
    behind, beyond, needless, needed, expected, firmness, rest, bend, straight, tied, tied_skin, targets, springs,
    reach, rounds,
):  # fmt: skip
    size, count = len(start), len(bones)
    normal, right = np.empty((size, size)), np.empty(size)
    stiffness = np.zeros((size, size))
    for a in range(size):
        stiffness[a, a] = firmness[a] + rest[a]
    for k in range(count):
        parent = int(bones[k, PARENT])
        if parent >= 0:
            stiffness[2 + k, 2 + k] += bend + straight
            stiffness[2 + parent, 2 + parent] += bend + straight
            stiffness[2 + k, 2 + parent] -= bend + straight
            stiffness[2 + parent, 2 + k] -= bend + straight
    best, trial = start.copy(), start.copy()
    best_cost, damping = np.inf, 1e-3
    best_normal, best_right = normal.copy(), right.copy()
    for _ in range(rounds):
        cost = _system(
            image, scale_x, scale_y, left, top, hidden, needs, places, colours, weights, skin, bones, trial, like,
            beside, behind, beyond, needless, needed, normal, right,
        )  # fmt: skip
        cost += _prior_cost(bones, trial, expected, firmness, rest, bend, straight)
        cost += _tie_system(bones, trial, tied, tied_skin, targets, springs, reach, normal, right)
        if cost < best_cost:
            gain = best_cost - cost
            best_cost = cost
            best[:] = trial
            best_normal[:], best_right[:] = normal + stiffness, right
            for a in range(size):
                best_right[a] -= firmness[a] * (trial[a] - expected[a]) + rest[a] * trial[a]
            for k in range(count):
                parent = int(bones[k, PARENT])
                if parent >= 0:
                    bent = trial[2 + k] - trial[2 + parent]
                    back = bend * (bent - expected[2 + k] + expected[2 + parent]) + straight * bent
                    best_right[2 + k] -= back
                    best_right[2 + parent] += back
            damping = max(0.3 * damping, 1e-6)
            if gain < 1e-5:
                break
        else:
            damping *= 8.0
            if damping > 1e3:
                break
        for a in range(size):
            normal[a, :] = best_normal[a, :]
            normal[a, a] = best_normal[a, a] * (1.0 + damping) + 1e-12
        step = best_right.copy()
        solve_positive(normal, step.reshape(size, 1))
        longest = max(abs(step[0]), abs(step[1])) * scale_x / 2.5
        for a in range(2, size):
            longest = max(longest, abs(step[a]) / (0.12 if a < 2 + count else 0.06))
        trial = best + step / max(longest, 1.0)
        if max(abs(step[0]), abs(step[1])) * scale_x < 0.02 and np.abs(step[2:]).max() < 0.0008:
            break
    return best, best_cost
