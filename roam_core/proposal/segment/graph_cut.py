"""The exact minimum of a segmentation cost: log-ratios and contrast-dependent smoothing on a grid, by maximum flow.

The paper's instrumental energy ("Allowing topology changes"; Boykov and Jolly, ICCV 2001) for x_p in {0, 1}

    - sum_p ratio_p x_p + sum_(p, q) w_pq |x_p - x_q|

over neighbours p, q, ratio_p = ln p_f / p_b in nats. It only proposes; the curve's own energy decides.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array
from scipy.sparse.csgraph import breadth_first_order, maximum_flow

from roam_core.arrays import Bools, Float32, Int32, UInt8

OFFSETS = ((0, 1), (1, 0), (1, 1), (1, -1))
"""(rows, columns) from a cell to the neighbours that it is joined to; the first two alone make 4 neighbours."""

PER_NAT = 1000
"""Integer costs a nat: flows are integers, and the minimum is exact for costs rounded to a thousandth."""

MOST = 1e3
"""Nats to which ratios and weights are bounded, so that no sum around a cell leaves 32 bits."""

SWEEPS = 6
"""Rounds in which cells that their surroundings cannot sway are decided before the flow is sought."""


@dataclass(frozen=True, eq=False)
class Cut:
    """`inside (rows, columns)` at the minimum and its `cost` in nats, all cells counted, the held ones too."""

    inside: Bools
    cost: float


def contrast_weights(colours: NDArray[Any], strength: float, contrast: float, neighbours: int = 8) -> Float32:
    """`w_pq = strength exp(-|colour_p - colour_q|^2 / (2 contrast^2)) / |p - q|`, in nats.

    Parameters
    ----------
    colours : (rows, columns, 3) Lab. contrast : Lab units. strength : nats for neighbours of one colour.
    neighbours : 4 or 8.

    Returns
    -------
    (2 or 4, rows, columns): entry `[k, r, c]` joins cell `[r, c]` to the one `OFFSETS[k]` away; 0 off the grid.
    """
    if neighbours not in (4, 8):
        raise ValueError(f"cells have 4 or 8 neighbours, not {neighbours}")
    weights = np.zeros((neighbours // 2, *colours.shape[:2]), dtype=np.float32)
    lab = colours.astype(np.float32)
    for weight, offset in zip(weights, OFFSETS, strict=False):
        here, there = _ends(colours.shape[:2], offset)
        step = lab[here] - lab[there]
        away = strength / np.hypot(*offset)
        weight[here] = np.float32(away) * np.exp(np.einsum("rcl,rcl->rc", step, step) / np.float32(-2.0 * contrast**2))
    return weights


def minimum_cut(ratio: Float32, weights: Float32, free: Bools, held: Bools) -> Cut:
    """The labelling of least cost among those equal to `held` wherever a cell is not `free`.

    Exact for costs rounded to 1 / `PER_NAT`. Among several minima it is the one with the fewest cells inside (minimal
    cuts are closed under intersection), so the answer depends on the costs alone. Cells that no labelling of their
    neighbours can sway are decided first, round after round: the flow sees only what is in doubt.

    Parameters
    ----------
    ratio : (rows, columns) nats, positive where a cell is better inside.
    weights : (2 or 4, rows, columns) as `contrast_weights` gives them, not negative.
    free, held : (rows, columns) the cells to be labelled, and the labels of the others.
    """
    costs, links = _integers(ratio, weights)
    pull, label = _decided(costs, links, free, held)
    doubtful = label == UNDECIDED
    inside = label == INSIDE
    if doubtful.any():
        inside[doubtful] = _source_side(doubtful, pull[doubtful], links)
    return Cut(inside, _cost(inside, costs, links))


OUTSIDE, INSIDE, UNDECIDED = 0, 1, 2


def _ends(shape: tuple[int, int], offset: tuple[int, int]) -> tuple[tuple[slice, slice], tuple[slice, slice]]:
    """The cells that have a neighbour `offset` away, and those neighbours, as slices."""
    rows, columns = shape
    down, right = offset
    here = slice(0, rows - down), slice(max(-right, 0), columns - max(right, 0))
    there = slice(down, rows), slice(max(right, 0), columns + min(right, 0))
    return here, there


def _integers(ratio: Float32, weights: Float32) -> tuple[Int32, Int32]:
    if weights.ndim != 3 or weights.shape[0] not in (2, 4) or weights.shape[1:] != ratio.shape:
        raise ValueError(f"weights {weights.shape} do not join the neighbours of a grid {ratio.shape}")
    costs = np.rint(PER_NAT * np.clip(ratio, -MOST, MOST)).astype(np.int32)
    links = np.rint(PER_NAT * np.clip(weights, 0.0, MOST)).astype(np.int32)
    for link, offset in zip(links, OFFSETS, strict=False):
        here, _ = _ends(ratio.shape, offset)
        beyond = np.ones(ratio.shape, dtype=bool)
        beyond[here] = False
        link[beyond] = 0
    return costs, links


def _cost(inside: Bools, costs: Int32, links: Int32) -> float:
    total = -int(costs[inside].sum(dtype=np.int64))
    for link, offset in zip(links, OFFSETS, strict=False):
        here, there = _ends(inside.shape, offset)
        total += int(link[here][inside[here] != inside[there]].sum(dtype=np.int64))
    return total / PER_NAT


def _decided(costs: Int32, links: Int32, free: Bools, held: Bools) -> tuple[Int32, UInt8]:
    """What pulls each cell inside, decided neighbours included, and the labels so far.

    A cell whose pull exceeds all that its undecided neighbours weigh is inside in every minimum; one whose pull does
    not even match their weight against it is outside in the least.
    """
    label = np.where(free, UNDECIDED, np.where(held, INSIDE, OUTSIDE)).astype(np.uint8)
    pull, slack = costs.copy(), np.zeros_like(costs)
    for sweep in range(SWEEPS):
        sign = np.array([-1, 1, 0], dtype=np.int32)[label]
        open_ = (label == UNDECIDED).astype(np.int32)
        pull[...], slack[...] = costs, 0
        for link, offset in zip(links, OFFSETS, strict=False):
            here, there = _ends(label.shape, offset)
            weight = link[here]
            pull[here] += weight * sign[there]
            pull[there] += weight * sign[here]
            slack[here] += weight * open_[there]
            slack[there] += weight * open_[here]
        undecided = label == UNDECIDED
        up, down = undecided & (pull > slack), undecided & (pull <= -slack)
        if sweep == SWEEPS - 1 or not (up.any() or down.any()):
            break
        label[up], label[down] = INSIDE, OUTSIDE
    return pull, label


def _source_side(doubtful: Bools, pull: Int32, links: Int32) -> Bools:
    """Which of the doubtful cells `(n,)`, in row order, the minimal minimum cut leaves with the source: inside."""
    count = len(pull)
    source, sink = count, count + 1
    number = np.full(doubtful.shape, -1, dtype=np.int32)
    number[doubtful] = np.arange(count, dtype=np.int32)
    tails, heads, capacities = [], [], []
    for link, offset in zip(links, OFFSETS, strict=False):
        here, there = _ends(doubtful.shape, offset)
        joined = (number[here] >= 0) & (number[there] >= 0)
        tails.append(number[here][joined])
        heads.append(number[there][joined])
        capacities.append(link[here][joined])
    cells = np.arange(count, dtype=np.int32)
    a = np.concatenate([*tails, np.where(pull > 0, source, cells)])
    b = np.concatenate([*heads, np.where(pull > 0, cells, sink)])
    forth = np.concatenate([*capacities, np.abs(pull)])
    back = np.concatenate([*capacities, np.zeros_like(pull)])
    graph = csr_array(
        (np.concatenate([forth, back]), (np.concatenate([a, b]), np.concatenate([b, a]))), shape=(count + 2, count + 2)
    )
    flow = maximum_flow(graph, source, sink).flow
    residual = graph - flow
    residual.eliminate_zeros()
    reached = breadth_first_order(residual, source, return_predecessors=False)
    inside = np.zeros(count + 2, dtype=bool)
    inside[reached] = True
    return inside[:count]
