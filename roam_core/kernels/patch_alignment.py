"""Patches of a key aligned with a picture, each by an affine motion: Gauss and Newton with the key's own gradients.

A patch is a set of places with the colours that they had on the key. Its motion takes the place k to
q + L (k - c), with c its centre: six numbers `(q_x, q_y, L_xx, L_xy, L_yx, L_yy)`, always from the key, so that nothing
adds up from frame to frame. The gradients are the template's (inverse compositional alignment: Baker and Matthews,
"Lucas-Kanade 20 years on", IJCV 2004); residuals weigh by Geman and McClure, less one shift of brightness a channel.
Each patch is drawn to where those around it expect it, as firmly as its own texture leaves it open.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numba import njit

from roam_core.arrays import Array, Bools, Float32, Int32, UInt8
from roam_core.kernels.small_systems import solve_positive
from roam_core.threads import in_halves


class Templates(NamedTuple):
    """Of each of M patches: its centre `(M, 2)`, its places `(M, N, 2)`, pixels of the image, and at each, on several
    levels from coarse to fine, the colour `(levels, M, N, 3)` and its slopes a pixel along x and y
    `(levels, M, N, 3, 2)`; and those beside it `(M, K)`, -1 where there are fewer, with how much they are heard.
    """

    centres: Array
    places: Array
    colours: Float32
    slopes: Float32
    neighbours: Int32
    nearness: Array


class Picture(NamedTuple):
    """Part of a picture on one level: `image (h, w, 3)`, its cells a pixel, and the pixel where its corner lies."""

    image: UInt8
    factor_x: float
    factor_y: float
    left: float
    top: float


class Alignment(NamedTuple):
    """How patches are aligned; lengths in pixels of the image.

    rounds on each level; T of the residuals: twice their median, within `like_least` and `like_most`; `like`: T of the
    cost by which places are compared and patches rated; `shift`: of brightness, at most; how far a patch may lie from
    where it is expected, `move`, and its L, `strain`; `independent`: share of the places that tell something new;
    `parted`: distance from where a neighbour expects a patch at which it is heard half; `step`, `step_strain`: by which
    one round changes a motion at most; `own`: how much a patch itself is heard beside its neighbours; `beyond`: what a
    place outside the picture costs.
    """

    rounds: int
    like_least: float
    like_most: float
    like: float
    shift: float
    move: float
    strain: float
    independent: float
    parted: float
    step: float
    step_strain: float
    own: float
    beyond: float


def aligned(
    templates: Templates, coarse: Picture, fine: Picture, carried: Array, last: Array, likeness: Array, how: Alignment
) -> tuple[Array, Array, Array]:
    """The motion of each patch `(M, 6)`, how well it matches there `(M,)`, in [0, 1], and what its own texture leaves
    open of its place `(M,)`, pixels.

    Parameters
    ----------
    carried : (M, 6) where the flow takes the patches. last : (M, 6) where they lay on the frame before, and with what
        `likeness (M,)`: those that matched there are heard by their neighbours.
    """
    result = carried.copy(), likeness.copy(), np.empty(len(carried))
    known, places = (carried, last, likeness), np.ones(templates.places.shape[:2], np.bool_)

    def swept(before: Array, is_first: bool) -> None:
        def some(first: int, stop: int) -> None:
            _sweep(templates, coarse, fine, before, *known, is_first, how, first, stop, *result)

        in_halves(some, places)

    swept(carried, True)
    swept(result[0].copy(), False)
    return result


@njit(nogil=True, cache=True, error_model="numpy")
def _sweep(  # type: ignore[no-untyped-def]
    templates, coarse, fine, before, carried, last, likeness, is_first, how, first, stop, found, matched, open_by
):  # fmt: skip
    """The patches from `first` to `stop` drawn to where those around them lay `before` expect them."""
    places = templates.places.shape[1]
    residuals, seen = np.empty((places, 3)), np.empty(places, np.bool_)
    expected, start = np.empty(6), np.empty(6)
    for k in range(first, stop):
        _expected(templates, before, likeness, k, how, expected)
        least = 2.0
        for choice in range(3 if is_first else 2):
            start[:] = before[k] if choice == 0 else expected if choice == 1 else last[k]
            _compare(templates, 0, k, coarse, start, how, residuals, seen)
            price = _price(residuals, seen, how)
            if price < least:
                least = price
                found[k] = start
        if is_first:
            _refine(templates, 0, k, coarse, found[k], expected, 2.0, how, residuals, seen)
        open_by[k] = _refine(templates, 1, k, fine, found[k], expected, 1.0, how, residuals, seen)
        if not is_sound(found[k]):
            found[k] = carried[k]
        _compare(templates, 1, k, fine, found[k], how, residuals, seen)
        matched[k] = 1.0 - _price(residuals, seen, how)


@njit(nogil=True, cache=True, error_model="numpy")
def is_sound(motion: Array) -> bool:
    """Whether a motion leaves a patch an area: between a tenth of the key's and ten times that."""
    return bool(0.1 < motion[2] * motion[5] - motion[3] * motion[4] < 10.0)


@njit(nogil=True, cache=True, error_model="numpy")
def _expected(templates: Templates, found: Array, likeness: Array, k: int, how: Alignment, expected: Array) -> None:
    """Where its neighbours, each as far as it matched and agrees, and the patch itself expect it."""
    centres, total = templates.centres, how.own
    expected[:] = how.own * found[k]
    for j, near in zip(templates.neighbours[k], templates.nearness[k]):  # noqa: B905 - numba knows no `strict`
        if j < 0:
            continue
        x, y = centres[k, 0] - centres[j, 0], centres[k, 1] - centres[j, 1]
        to_x = found[j, 0] + found[j, 2] * x + found[j, 3] * y
        to_y = found[j, 1] + found[j, 4] * x + found[j, 5] * y
        apart = (to_x - found[k, 0]) ** 2 + (to_y - found[k, 1]) ** 2
        weight = near * (likeness[j] + 0.05) / (1.0 + apart / how.parted**2)
        total += weight
        expected[0] += weight * to_x
        expected[1] += weight * to_y
        for a in range(2, 6):
            expected[a] += weight * found[j, a]
    expected /= total


@njit(nogil=True, cache=True, error_model="numpy")
def _compare(
    templates: Templates, level: int, k: int, picture: Picture, motion: Array, how: Alignment, residuals: Array,
    seen: Bools,
) -> None:  # fmt: skip
    """The differences of colour `(N, 3)` between picture and patch, less their common shift; which are `seen (N,)`."""
    image, places, colours = picture.image, templates.places[k], templates.colours[level, k]
    height, width = image.shape[:2]
    centre_x, centre_y = templates.centres[k, 0], templates.centres[k, 1]
    q_x, q_y, xx, xy, yx, yy = motion[0], motion[1], motion[2], motion[3], motion[4], motion[5]
    soft = 1.5 * how.shift
    total, weights = np.zeros(3), np.zeros(3)
    for n in range(len(seen)):
        x, y = places[n, 0] - centre_x, places[n, 1] - centre_y
        u = (q_x + xx * x + xy * y - picture.left) * picture.factor_x - 0.5
        v = (q_y + yx * x + yy * y - picture.top) * picture.factor_y - 0.5
        seen[n] = 0.0 <= u < width - 1 and 0.0 <= v < height - 1
        if not seen[n]:
            continue
        column, row = np.uintp(u), np.uintp(v)  # unsigned: no index counts from the end
        right, below = column + np.uintp(1), row + np.uintp(1)
        u -= column
        v -= row
        for c in range(3):
            colour = (1.0 - v) * ((1.0 - u) * image[row, column, c] + u * image[row, right, c])
            colour += v * ((1.0 - u) * image[below, column, c] + u * image[below, right, c])
            off = colour - colours[n, c]
            residuals[n, c] = off
            weight = 1.0 / (1.0 + (off / soft) ** 2)
            total[c] += weight * off
            weights[c] += weight
    for c in range(3):
        if weights[c] > 0.0:
            shift = min(max(total[c] / weights[c], -how.shift), how.shift)
            for n in range(len(seen)):
                residuals[n, c] -= shift


@njit(nogil=True, cache=True, error_model="numpy")
def _price(residuals: Array, seen: Bools, how: Alignment) -> float:
    """The mean cost of the places, in [0, 1]."""
    total = 0.0
    for n in range(len(seen)):
        if seen[n]:
            square = (residuals[n, 0] ** 2 + residuals[n, 1] ** 2 + residuals[n, 2] ** 2) / (3.0 * how.like**2)
            total += square / (1.0 + square)
        else:
            total += how.beyond
    return total / len(seen)


@njit(nogil=True, cache=True, error_model="numpy")
def _like(residuals: Array, seen: Bools, how: Alignment) -> float:
    """T of the residuals at hand: twice the median of their size, within bounds."""
    sizes, count, small, large = np.empty(len(seen)), 0, 0, 0
    for n in range(len(seen)):
        if seen[n]:
            size = 2.0 * (abs(residuals[n, 0]) + abs(residuals[n, 1]) + abs(residuals[n, 2])) / 3.0
            small += size <= how.like_least
            large += size >= how.like_most
            sizes[count] = size
            count += 1
    if 2 * large > count or count == 0:
        return how.like_most
    if 2 * small > count:
        return how.like_least
    return min(max(np.median(sizes[:count]), how.like_least), how.like_most)


@njit(nogil=True, cache=True, error_model="numpy")
def _refine(
    templates: Templates, level: int, k: int, picture: Picture, motion: Array, expected: Array, loose: float,
    how: Alignment, residuals: Array, seen: Bools,
) -> float:  # fmt: skip
    """Rounds of Gauss and Newton on one patch; `motion (6,)` is moved. What its texture leaves open, pixels.

    The prior on place and L is `loose` times as wide as it is told.
    """
    centre_x, centre_y = templates.centres[k, 0], templates.centres[k, 1]
    hessian, slope, step, along = np.empty((6, 6)), np.empty(6), np.empty(6), np.empty(3)
    firm_place, firm_strain = 1.0 / (loose * how.move) ** 2, 1.0 / (loose * how.strain) ** 2
    open_by = 0.0
    for _ in range(how.rounds):
        _compare(templates, level, k, picture, motion, how, residuals, seen)
        like = _like(residuals, seen, how)
        hessian[:] = 0.0
        slope[:] = 0.0
        for n in range(len(seen)):
            if not seen[n]:
                continue
            square = (residuals[n, 0] ** 2 + residuals[n, 1] ** 2 + residuals[n, 2] ** 2) / (3.0 * like * like)
            weight = 1.0 / (1.0 + square) ** 2
            x, y = templates.places[k, n, 0] - centre_x, templates.places[k, n, 1] - centre_y
            xx = xy = yy = x_off = y_off = 0.0
            for c in range(3):
                gx, gy = templates.slopes[level, k, n, c, 0], templates.slopes[level, k, n, c, 1]
                xx += gx * gx
                xy += gx * gy
                yy += gy * gy
                x_off += gx * residuals[n, c]
                y_off += gy * residuals[n, c]
            along[0], along[1], along[2] = 1.0, x, y  # each slope once by itself, once by x, once by y
            for a in range(3):
                slope[2 * a] += weight * along[a] * x_off
                slope[2 * a + 1] += weight * along[a] * y_off
                for b in range(a, 3):
                    shared = weight * along[a] * along[b]
                    hessian[2 * a, 2 * b] += shared * xx
                    hessian[2 * a, 2 * b + 1] += shared * xy
                    hessian[2 * a + 1, 2 * b] += shared * xy
                    hessian[2 * a + 1, 2 * b + 1] += shared * yy
        told = how.independent * 4.0 / (3.0 * like * like)
        slope *= told
        for a in range(6):
            for b in range(a, 6):
                hessian[a, b] *= told
                hessian[b, a] = hessian[a, b]
        for a in range(2, 6):
            hessian[a, a] += firm_strain
        # The prior, as the template has it: what the motion lacks to the one that is expected.
        det = motion[2] * motion[5] - motion[3] * motion[4]
        xx, xy, yx, yy = motion[5] / det, -motion[3] / det, -motion[4] / det, motion[2] / det
        x, y = expected[0] - motion[0], expected[1] - motion[1]
        slope[0] -= firm_place * (xx * x + xy * y)
        slope[1] -= firm_place * (yx * x + yy * y)
        slope[2] -= firm_strain * (xx * expected[2] + xy * expected[4] - 1.0)
        slope[3] -= firm_strain * (yx * expected[2] + yy * expected[4])
        slope[4] -= firm_strain * (xx * expected[3] + xy * expected[5])
        slope[5] -= firm_strain * (yx * expected[3] + yy * expected[5] - 1.0)
        open_by = _solved(hessian, slope, firm_place, step)
        if _composed(motion, step, how):
            break
    return open_by


@njit(nogil=True, cache=True, error_model="numpy")
def _solved(hessian: Array, slope: Array, firm_place: float, step: Array) -> float:
    """The `step (6,)` of Gauss and Newton, where the prior on the place is still to be added to the hessian.

    Returns the standard deviation of the place without that prior along the direction that the texture tells least of,
    pixels. For it the strains are eliminated first, which is half of the way to the step.
    """
    strains, right = np.empty((4, 4)), np.empty((4, 3))
    for a in range(4):
        strains[a] = hessian[2 + a, 2:]
        right[a, 0], right[a, 1], right[a, 2] = hessian[2 + a, 0], hessian[2 + a, 1], slope[2 + a]
    solve_positive(strains, right)
    xx, xy, yy, x, y = hessian[0, 0], hessian[0, 1], hessian[1, 1], slope[0], slope[1]
    for a in range(4):
        xx -= hessian[0, 2 + a] * right[a, 0]
        xy -= hessian[0, 2 + a] * right[a, 1]
        yy -= hessian[1, 2 + a] * right[a, 1]
        x -= hessian[0, 2 + a] * right[a, 2]
        y -= hessian[1, 2 + a] * right[a, 2]
    half, det = 0.5 * (xx + yy), xx * yy - xy * xy
    open_by = 1.0 / np.sqrt(max(half - np.sqrt(max(half * half - det, 0.0)), 1e-6))
    xx += firm_place
    yy += firm_place
    det = xx * yy - xy * xy
    step[0], step[1] = (yy * x - xy * y) / det, (xx * y - xy * x) / det
    for a in range(4):
        step[2 + a] = right[a, 2] - right[a, 0] * step[0] - right[a, 1] * step[1]
    return float(open_by)


@njit(nogil=True, cache=True, error_model="numpy")
def _composed(motion: Array, step: Array, how: Alignment) -> bool:
    """Compose `motion (6,)` with the inverse of a step `(move x, y, columns of a strain)`; whether that is done."""
    place, strain = max(abs(step[0]), abs(step[1])), np.abs(step[2:]).max()
    if place > how.step:
        step *= how.step / place
    if strain > how.step_strain:
        step *= how.step_strain / strain
    a, b, c, d = 1.0 + step[2], step[4], step[3], 1.0 + step[5]
    det = a * d - b * c
    xx, xy = (motion[2] * d - motion[3] * c) / det, (motion[3] * a - motion[2] * b) / det
    yx, yy = (motion[4] * d - motion[5] * c) / det, (motion[5] * a - motion[4] * b) / det
    motion[0] -= xx * step[0] + xy * step[1]
    motion[1] -= yx * step[0] + yy * step[1]
    motion[2], motion[3], motion[4], motion[5] = xx, xy, yx, yy
    return bool(place < 0.05 and strain < 0.005)


def sides(
    centres: Array, motions: Array, weights: Array, reach: float, key: Picture, depth: Float32, now: Picture,
    like: float, ramp: float,
) -> tuple[Float32, Float32]:  # fmt: skip
    """How surely patches put each cell of `now` inside the key's outlines, and outside, `(h, w)` each, in [0, 1].

    A patch of `weights (M,)` speaks within `reach` pixels of its centre, the less the farther from it and the nearer to
    the outline: in full from `ramp` cells of `depth` on. That a cell is inside counts as far as it looks as on the key
    (T: `like`); the surest patch is heard. `depth (h, w)`: signed distance from the key's outline, cells of `key`.
    """
    size = now.image.shape[:2]
    inside, outside = np.zeros(size, np.float32), np.zeros(size, np.float32)

    def rows(first: int, stop: int) -> None:
        _sides(centres, motions, weights, reach, key, depth, now, like, ramp, first, stop, inside, outside)

    in_halves(rows, np.ones(size, np.bool_))
    return inside, outside


@njit(nogil=True, cache=True, error_model="numpy")
def _sides(  # type: ignore[no-untyped-def]
    centres, motions, weights, reach, key, depth, now, like, ramp, top, bottom, inside, outside
):  # fmt: skip
    """The rows from `top` to `bottom` of what `sides` tells."""
    columns = now.image.shape[1]
    for k in range(len(centres)):
        motion = motions[k]
        if weights[k] <= 0.0 or not is_sound(motion):
            continue
        det = motion[2] * motion[5] - motion[3] * motion[4]
        xx, xy, yx, yy = motion[5] / det, -motion[3] / det, -motion[4] / det, motion[2] / det
        wide, high = reach * np.hypot(motion[2], motion[3]), reach * np.hypot(motion[4], motion[5])
        first, stop = (motion[1] - high - now.top) * now.factor_y, (motion[1] + high - now.top) * now.factor_y
        left, right = (motion[0] - wide - now.left) * now.factor_x, (motion[0] + wide - now.left) * now.factor_x
        for row in range(max(top, int(first)), min(bottom, int(stop) + 1)):
            for column in range(max(0, int(left)), min(columns, int(right) + 1)):
                x = (column + 0.5) / now.factor_x + now.left - motion[0]
                y = (row + 0.5) / now.factor_y + now.top - motion[1]
                on_x, on_y = xx * x + xy * y, yx * x + yy * y
                away = (on_x * on_x + on_y * on_y) / (reach * reach)
                if away >= 1.0:
                    continue
                i = int(np.floor((on_y + centres[k, 1] - key.top) * key.factor_y))
                j = int(np.floor((on_x + centres[k, 0] - key.left) * key.factor_x))
                if not (0 <= i < depth.shape[0] and 0 <= j < depth.shape[1]):
                    continue
                said = weights[k] * (1.0 - away) * min(abs(depth[i, j]) / ramp, 1.0)
                if depth[i, j] > 0.0:
                    off = 0.0
                    for c in range(3):
                        off += abs(np.float64(key.image[i, j, c]) - np.float64(now.image[row, column, c]))
                    said /= 1.0 + (off / (3.0 * like)) ** 2
                    inside[row, column] = max(inside[row, column], said)
                else:
                    outside[row, column] = max(outside[row, column], said)
