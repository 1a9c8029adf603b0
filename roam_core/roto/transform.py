"""Transforming points: affine maps of an outline, each point following by its weight, and how weights fall off."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import affine
from roam_core.roto.keying import Change
from roam_core.roto.shape import Outline


def transformed(outline: Outline, weights: Array, matrix: Array) -> Outline:
    """The outline with its points carried by `matrix (2, 3)`, each as far as its weight in `weights (P,)` says.

    Weight 1 carries a point, with its handles, wholly; 0 leaves it bit by bit. Feather offsets turn and scale with it.
    """
    points = _weighted(outline.points, affine.apply(matrix, outline.points), weights)
    if outline.feather is None:
        return replace(outline, points=points)
    feather = _weighted(outline.feather, outline.feather @ matrix[:, :2].T, weights)
    return replace(outline, points=points, feather=feather)


def transform_like(start: Outline, weights: Array, matrix: Array) -> Change:
    """The change that does on any key what `matrix (2, 3)` does to the outline `start`.

    The place about which it turns and scales goes with the shape: it lies on every key as it lies on `start` to the
    weighted middle of the anchors.
    """
    middle = centre(start, weights)

    def change(outline: Outline) -> Outline:
        return transformed(outline, weights, affine.shifted(matrix, centre(outline, weights) - middle))

    return change


def centre(outline: Outline, weights: Array) -> Array:
    """The weighted middle `(2,)` of the anchors; of all alike where no weight is above 0."""
    total = float(weights.sum())
    return np.asarray(weights @ outline.anchors / total if total > 0.0 else outline.anchors.mean(axis=0))


def falloff(anchors: Array, chosen: Iterable[int], radius: float) -> Array:
    """Weights `(P,)` of soft selection: 1 on the `chosen` points, falling smoothly to 0 `radius` pixels from them."""
    indices = sorted(set(chosen))
    if not indices:
        return np.zeros(len(anchors))
    gaps = np.linalg.norm(anchors[:, None] - anchors[None, indices], axis=2).min(axis=1)
    weights = bell(gaps / max(radius, 1e-9))
    weights[indices] = 1.0
    return weights


def bell(distance: Array) -> Array:
    """1 at distance 0, 0 from distance 1 on, smooth between: how much a place follows a pull."""
    near = 1.0 - np.clip(distance, 0.0, 1.0)
    return np.asarray(near * near * (3.0 - 2.0 * near))


def _weighted(before: Array, after: Array, weights: Array) -> Array:
    if weights.all() and weights.min() == 1.0:
        return after
    w = weights[:, None, None]
    # The ends are exact: a point that follows wholly lands where the map says, one that does not is untouched.
    return np.where(w == 1.0, after, np.where(w == 0.0, before, before + w * (after - before)))
