"""An outline drawn to where those of the frames beside have it, place by place along the motion of the picture."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import takewhile

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry.simple import untied
from roam_core.params import SteadinessParams, UntyingParams
from roam_core.propagate.frame.nodes import displaced
from roam_core.propagate.steadiness.residual import Places


def settled(
    points: Array,
    places: Places,
    before: Sequence[Array],
    after: Sequence[Array],
    params: SteadinessParams,
    untying: UntyingParams,
    scale: float,
) -> Array:
    """The control points `(P, 3, 2)` of a closed spline, drawn across itself to where most frames around have it.

    A neighbour's outline lies at a place where what was done since (or until) beyond the motion of the picture adds up
    to. All are averaged place by place, each the less the farther off it lies in time, and from where most of them
    agree: where the outline was elsewhere from some frame on, and not only trembled, one side is not heard.

    Parameters
    ----------
    before : `residual (N,)` of the step to this frame, of the one before that, and so on backwards.
    after : of the step from this frame to the next, and so on.
    """
    away, heard = [np.zeros(len(places.t))], [1.0]
    for sign, steps in ((-1.0, before), (1.0, after)):
        there = np.zeros(len(places.t))
        for number, step in enumerate(steps[: params.reach], start=1):
            there = there + sign * step
            away.append(there)
            heard.append(params.weight * float(np.exp(-0.5 * (number / params.fades) ** 2)))
    offsets, weights = np.stack(away), np.array(heard)[:, None]
    middle = _median(offsets, weights)
    for _ in range(params.rounds):
        near = weights * np.exp(-(((offsets - middle) / (params.alike * scale)) ** 2))
        middle = (near * offsets).sum(axis=0) / near.sum(axis=0)
    _, outward = places.on(points)
    moved = displaced(points, places.segment, places.t, middle[:, None] * outward, params.rigidity)
    return untied(moved, points, scale, untying)


def _median(values: Array, weights: Array) -> Array:
    """The weighted median `(N,)` of each column of `values (K, N)`; `weights (K, 1)`."""
    order = np.argsort(values, axis=0, kind="stable")
    summed = np.cumsum(np.take_along_axis(np.broadcast_to(weights, values.shape), order, axis=0), axis=0)
    half = (summed >= 0.5 * summed[-1]).argmax(axis=0)
    return np.asarray(np.take_along_axis(np.take_along_axis(values, order, axis=0), half[None], axis=0)[0])


def known_steps(steps: Sequence[Array | None]) -> list[Array]:
    """The steps up to the first of which nothing is known."""
    return [step for step in takewhile(lambda step: step is not None, steps) if step is not None]
