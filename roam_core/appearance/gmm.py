"""Mixtures: many small Gaussian mixtures of colours with diagonal covariances, learned and asked together."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np

from roam_core.arrays import Array, Bools, Float32, Int32
from roam_core.kernels.gmm_density import em_steps, log_densities

Density = Literal["sum", "maximum"]
"""A mixture's density, or its greatest component alone: within ln K of it, and without exponentials."""

FLOOR = float(np.log(2e-6))
"""Log density, per Lab unit cubed, of a colour that a mixture does not explain: about that of any colour at all."""


@dataclass(frozen=True, eq=False)
class Samples:
    """Colours `(S, 3)` sorted by the edge they belong to; edge n owns `colours[starts[n]:starts[n + 1]]`."""

    colours: Array
    starts: Int32

    @classmethod
    def of(cls, colours: Array, index: Int32, count: int) -> Samples:
        """From colours `(S, 3)` and the edge `(S,)`, in [0, count), of each."""
        order = np.argsort(index, kind="stable")
        starts = np.searchsorted(index[order], np.arange(count + 1)).astype(np.int32)
        return cls(np.ascontiguousarray(colours[order], dtype=np.float64), starts)

    def pool(self, edge: int, spread: int) -> Array:
        """The colours of an edge and of `spread` edges to both sides of it, cyclically; no edge counts twice."""
        count = len(self.starts) - 1
        reach = min(spread, (count - 1) // 2)
        edges = np.arange(edge - reach, edge + reach + 1) % count
        return np.concatenate([self.colours[self.starts[e] : self.starts[e + 1]] for e in edges])


@dataclass(frozen=True, eq=False)
class Mixtures:
    """N mixtures of K components: `weight (N, K)`, `mean (N, K, 3)` and `variance (N, K, 3)` in Lab units.

    A mixture whose weights are all zero knows nothing: its density is the floor everywhere.
    """

    weight: Array
    mean: Array
    variance: Array

    def __len__(self) -> int:
        return len(self.weight)

    @cached_property
    def packed(self) -> Float32:
        """`(N, K, 7)`, a mixture's numbers side by side: mean, half inverse variance, constant (ln w and the norm)."""
        with np.errstate(divide="ignore"):
            constant = np.log(self.weight) - 0.5 * np.log(2.0 * np.pi * self.variance).sum(axis=2)
        parts = [self.mean, 0.5 / self.variance, constant[:, :, None]]
        return np.ascontiguousarray(np.concatenate(parts, axis=2), dtype=np.float32)

    def log_density(self, colours: Float32, index: Int32, density: Density = "sum") -> Float32:
        """ln p of each colour `(..., 3)` under the mixture that `index (...)` names; `FLOOR` where it is negative."""
        flat = np.ascontiguousarray(colours.reshape(-1, 3), dtype=np.float32)
        values = log_densities(flat, np.ravel(index), self.packed, FLOOR, summed=density == "sum")
        return values.reshape(index.shape)

    def joined(self, other: Mixtures, share: float) -> Mixtures:
        """Mixtures whose densities are `1 - share` parts of these and `share` parts of the others."""
        return Mixtures(
            np.concatenate([(1.0 - share) * self.weight, share * other.weight], axis=1),
            np.concatenate([self.mean, other.mean], axis=1),
            np.concatenate([self.variance, other.variance], axis=1),
        )

    @property
    def is_unknown(self) -> Bools:
        """Which mixtures `(N,)` know nothing."""
        return np.asarray(self.weight.sum(axis=1) == 0.0)

    def without(self, unknown: Bools) -> Mixtures:
        """The mixtures with those marked `(N,)` knowing nothing."""
        return Mixtures(np.where(unknown[:, None], 0.0, self.weight), self.mean, self.variance)


def known_on_both_sides(inside: Mixtures, outside: Mixtures) -> tuple[Mixtures, Mixtures]:
    """Models of both sides of the same edges, each without what the other side knows nothing of.

    Half a model is none: where one side cannot be seen, the other would always win.
    """
    unknown = inside.is_unknown | outside.is_unknown
    return inside.without(unknown), outside.without(unknown)


def learned(samples: Samples, components: int, floor: float, spread: int = 0, steps: int = 10) -> Mixtures:
    """One mixture an edge by expectation maximisation, from its colours and those of `spread` edges to both sides.

    The start is drawn from no dice: each edge's colours are put in order along the channel that varies most and cut
    into `components` equal parts. `floor` is the least variance. An edge with too few colours gets a mixture that knows
    nothing.
    """
    count = len(samples.starts) - 1
    weight = np.zeros((count, components))
    mean = np.zeros((count, components, 3))
    variance = np.ones((count, components, 3))
    for edge in range(count):
        pool = samples.pool(edge, spread)
        if len(pool) < 2 * components:
            continue
        spreads = pool.var(axis=0)
        order = np.argsort(pool[:, int(np.argmax(spreads))], kind="stable")
        for k, part in enumerate(np.array_split(pool[order], components)):
            mean[edge, k] = part.mean(axis=0)
            variance[edge, k] = np.maximum(part.var(axis=0), floor)
        weight[edge] = 1.0 / components
    unknown = weight.sum(axis=1) == 0.0
    em_steps(samples.colours, samples.starts, spread, (weight, mean, variance), floor, steps)
    return Mixtures(weight, mean, variance).without(unknown)
