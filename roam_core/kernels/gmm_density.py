"""Many small Gaussian mixtures at once: the density of each pixel under a mixture of its own, and EM steps."""

from __future__ import annotations

import numpy as np
from numba import njit

from roam_core.arrays import Array, Float32, Int32


def log_densities(colours: Float32, index: Int32, packed: Float32, floor: float, *, summed: bool) -> Float32:
    """ln p(colour) under the mixture that `index` names for it, never below `floor`.

    Parameters
    ----------
    colours : (S, 3). index : (S,) number of the mixture, negative for a colour that is not asked for (it gets `floor`).
    packed : (N, K, 7) of N mixtures: mean, half inverse variance, constant (`gmm.Mixtures.packed`).
    floor : nats.
    summed : the mixture's density; else its greatest component alone, which costs no exponential and lies at most
        ln K below.

    Returns
    -------
    (S,).
    """
    values = np.full(len(colours), np.float32(floor), dtype=np.float32)
    _log_densities(colours, index, packed, np.float32(floor), summed, values)
    return values


def em_steps(
    colours: Array,
    starts: Int32,
    spread: int,
    mixtures: tuple[Array, Array, Array],
    floor: float,
    steps: int,
) -> None:
    """`steps` steps of expectation maximisation of N diagonal mixtures in place, each on a share of the colours.

    Parameters
    ----------
    colours : (S, 3) sorted by their edge. starts : (N + 1,): edge n owns `colours[starts[n]:starts[n + 1]]`.
    spread : edges to both sides, cyclically, whose colours a mixture learns from too.
    mixtures : weight (N, K), mean (N, K, 3), variance (N, K, 3). Where there are no colours they stay as they are.
    floor : least variance.
    """
    _em_steps(colours, starts, spread, *mixtures, floor, steps)


@njit(nogil=True, cache=True)
def _log_densities(colours, index, packed, floor, summed, values):  # type: ignore[no-untyped-def]
    kinds = packed.shape[1]
    terms = np.empty(kinds, dtype=np.float32)
    for s in range(len(colours)):
        n = index[s]
        if n < 0:
            continue
        c0, c1, c2 = colours[s, 0], colours[s, 1], colours[s, 2]
        best = np.float32(-np.inf)
        for k in range(kinds):
            d0, d1, d2 = c0 - packed[n, k, 0], c1 - packed[n, k, 1], c2 - packed[n, k, 2]
            terms[k] = packed[n, k, 6] - (
                d0 * d0 * packed[n, k, 3] + d1 * d1 * packed[n, k, 4] + d2 * d2 * packed[n, k, 5]
            )
            best = max(best, terms[k])
        if summed and best > np.float32(-1e30):
            total = np.float32(0.0)
            for k in range(kinds):
                total += np.exp(terms[k] - best)
            best += np.log(total)
        values[s] = max(best, floor)


@njit(nogil=True, cache=True)
def _em_steps(colours, starts, spread, weight, mean, variance, floor, steps):  # type: ignore[no-untyped-def]
    count, kinds = weight.shape
    terms, gain = np.empty(kinds), np.empty((kinds, 7))
    reach = min(spread, (count - 1) // 2)  # no edge is counted twice
    for n in range(count):
        for _ in range(steps):
            gain[:] = 0.0
            constant = _constants(weight[n], variance[n])
            for neighbour in range(n - reach, n + reach + 1):
                edge = neighbour % count
                for s in range(starts[edge], starts[edge + 1]):
                    best = -np.inf
                    for k in range(kinds):
                        terms[k] = constant[k]
                        for c in range(3):
                            terms[k] -= 0.5 * (colours[s, c] - mean[n, k, c]) ** 2 / variance[n, k, c]
                        best = max(best, terms[k])
                    total = 0.0
                    for k in range(kinds):
                        terms[k] = np.exp(terms[k] - best)
                        total += terms[k]
                    for k in range(kinds):
                        share = terms[k] / total
                        gain[k, 6] += share
                        for c in range(3):
                            gain[k, c] += share * colours[s, c]
                            gain[k, 3 + c] += share * colours[s, c] ** 2
            total = gain[:, 6].sum()
            if total == 0.0:
                break
            for k in range(kinds):
                weight[n, k] = gain[k, 6] / total
                if gain[k, 6] < 1e-9:  # a component that explains nothing keeps its place
                    continue
                for c in range(3):
                    mean[n, k, c] = gain[k, c] / gain[k, 6]
                    square = gain[k, 3 + c] / gain[k, 6] - mean[n, k, c] ** 2
                    variance[n, k, c] = max(square, floor)


@njit(nogil=True, cache=True)
def _constants(weight, variance):  # type: ignore[no-untyped-def]
    """ln w - ln sqrt((2 pi)^3 |Sigma|) of each component."""
    result = np.empty(len(weight))
    for k in range(len(weight)):
        result[k] = np.log(max(weight[k], 1e-300)) - 1.5 * np.log(2.0 * np.pi)
        for c in range(3):
            result[k] -= 0.5 * np.log(variance[k, c])
    return result


def matches(colours: Array, starts: Int32, spread: int, mixtures: tuple[Array, Array, Array], bound: float) -> Array:
    """Which component each colour matches, as sums: (N, K + 1, 7), over its colours, of colour, its square, and 1.

    A colour matches the likeliest component within `bound` standard deviations (root mean square over the channels);
    what matches none is in the last row. Arguments as in `em_steps`; only components of positive weight count.
    """
    count, kinds = mixtures[0].shape
    sums = np.zeros((count, kinds + 1, 7))
    _matches(colours, starts, spread, *mixtures, bound, sums)
    return sums


@njit(nogil=True, cache=True)
def _matches(colours, starts, spread, weight, mean, variance, bound, sums):  # type: ignore[no-untyped-def]
    count, kinds = weight.shape
    reach = min(spread, (count - 1) // 2)
    for n in range(count):
        constant = _constants(weight[n], variance[n])
        for neighbour in range(n - reach, n + reach + 1):
            edge = neighbour % count
            for s in range(starts[edge], starts[edge + 1]):
                best, matched = -np.inf, kinds
                for k in range(kinds):
                    square = 0.0
                    for c in range(3):
                        square += (colours[s, c] - mean[n, k, c]) ** 2 / variance[n, k, c]
                    if weight[n, k] > 0.0 and square <= 3.0 * bound * bound and constant[k] - 0.5 * square > best:
                        best, matched = constant[k] - 0.5 * square, k
                for c in range(3):
                    sums[n, matched, c] += colours[s, c]
                    sums[n, matched, 3 + c] += colours[s, c] ** 2
                sums[n, matched, 6] += 1.0
