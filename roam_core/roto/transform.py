"""Transforming points: maps of an outline, each point following by its weight, and how weights fall off."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.geometry import affine, projective
from roam_core.geometry.bezier import ANCHOR
from roam_core.roto.keying import Change
from roam_core.roto.shape import Outline
from roam_core.translatable import sentence


def transformed(outline: Outline, weights: Array, matrix: Array) -> Outline:
    """The outline with its points carried by `matrix`, each as far as its weight in `weights (P,)` says.

    Weight 1 carries a point, with its handles, wholly; 0 leaves it bit by bit. Feather offsets turn and scale with it.
    The map is affine, `(2, 3)`, or projective, `(3, 3)`, with the points before it in a positive depth: then handles
    and feather offsets go as its derivative at their point says, so that tangents stay tangents.

    Raises
    ------
    RoamError
        where a projective map sends a point beyond its horizon.
    """
    carried, arms = _affinely(outline, matrix) if len(matrix) == 2 else _in_perspective(outline, weights, matrix)
    points = _weighted(outline.points, carried, weights)
    if outline.feather is None or arms is None:
        return replace(outline, points=points)
    return replace(outline, points=points, feather=_weighted(outline.feather, arms, weights))


def _affinely(outline: Outline, matrix: Array) -> tuple[Array, Array | None]:
    """Points and feather offsets under an affine map."""
    feather = None if outline.feather is None else outline.feather @ matrix[:, :2].T
    return affine.apply(matrix, outline.points), feather


def _in_perspective(outline: Outline, weights: Array, matrix: Array) -> tuple[Array, Array | None]:
    """Points and feather offsets under a projective map."""
    anchors = outline.points[:, ANCHOR, None]
    if (projective.depth(matrix, outline.anchors[weights > 0.0]) <= projective.HORIZON).any():
        raise RoamError(
            sentence("On another key points would go beyond the horizon of this perspective; pull the corner less far.")
        )
    arms = projective.apply_to_arms(matrix, anchors, outline.points - anchors)
    feather = None if outline.feather is None else projective.apply_to_arms(matrix, anchors, outline.feather)
    return projective.apply(matrix, anchors) + arms, feather


def transform_like(start: Outline, weights: Array, matrix: Array) -> Change:
    """The change that does on any key what `matrix`, `(2, 3)` or `(3, 3)`, does to the outline `start`.

    The place about which it turns and scales goes with the shape: it lies on every key as it lies on `start` to the
    weighted middle of the anchors.
    """
    middle = centre(start, weights)
    shifted = affine.shifted if len(matrix) == 2 else projective.shifted

    def change(outline: Outline) -> Outline:
        return transformed(outline, weights, shifted(matrix, centre(outline, weights) - middle))

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
