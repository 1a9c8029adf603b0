"""How far a solved frame can be trusted: the overlap with what the artist wants that its features let one expect.

Confidence is an expected IoU: of the frames that are given 0.8, the outlines overlap the true ones by 0.8 in the mean.
It is a logistic model of a few features, none of which can speak for a frame, with weights fitted to the shared shots
and tried on each with that shot left out (`benchmarks/confidence.py` does both, and prints the weights).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import astuple, dataclass, replace

import cv2
import numpy as np

from roam_core.arrays import Array, Bools, Float32
from roam_core.energy.total import CurveContext
from roam_core.geometry import polyline
from roam_core.motion.klt import Warp
from roam_core.motion.pose import Pose
from roam_core.params import CONFIDENCE, ConfidenceParams
from roam_core.propagate.frame.contour_fit import enclosed
from roam_core.propagate.frame.result import Part
from roam_core.proposal.cues.evidence import SURE, Expectation, Field


@dataclass(frozen=True)
class ConfidenceFeatures:
    """What speaks against one frame of an object carried by regions; zero where all is well.

    Attributes
    ----------
    unenclosed : -ln of the overlap of what the curves enclose with the region that they were fitted to.
    flat : how little the log-ratio rises beside the border of the region: 1 where it says nothing, 0 where it is sure.
    new : the share of the region that lies outside the key's, carried all the way.
    missing : what of the key's, so carried, the region has not, per cell of the region.
    thin : cells beside the border per cell of the region: the same error along it weighs more on what is thin.
    age : ln of the frames since the key. Errors add up, and what was lost seldom comes back.
    disagreeing : where the curves moved as one piece, with none of the above but `thin` and `age`, the share of the
        key's corners that are not found where they should be.
    """

    unenclosed: float
    flat: float
    new: float
    missing: float
    thin: float
    age: float
    disagreeing: float = 0.0

    @classmethod
    def of_one_piece(cls, disagreeing: float, inside: Bools, frames: int) -> ConfidenceFeatures:
        """Of an object that moved as one piece, so many frames after the key, to the cells `inside (rows, columns)`."""
        thin = int(np.count_nonzero(beside_border(inside))) / max(int(np.count_nonzero(inside)), 1)
        return cls(0.0, 0.0, 0.0, 0.0, thin, float(np.log(frames)), disagreeing)

    @classmethod
    def of(
        cls,
        parts: Sequence[Part],
        found: Field,
        expected: Expectation,
        frames: int,
        params: ConfidenceParams = CONFIDENCE,
    ) -> ConfidenceFeatures:
        """Of the outlines fitted to the region `found`, so many frames after the key."""
        inside, remembered = found.inside, expected.remembered > 0.5
        cells = max(int(np.count_nonzero(inside)), 1)
        near = beside_border(inside)
        nats = np.abs(np.clip(found.values, -SURE, SURE))
        return cls(
            unenclosed=-float(np.log(max(overlap(enclosed(parts, found.grid) > 0.5, inside), params.least))),
            flat=1.0 - float(nats[near].mean()) / SURE if near.any() else 1.0,
            new=int(np.count_nonzero(inside & ~remembered)) / cells,
            missing=int(np.count_nonzero(remembered & ~inside)) / cells,
            thin=int(np.count_nonzero(near)) / cells,
            age=float(np.log(frames)),
        )

    def over_the_key_as(self, other: ConfidenceFeatures) -> ConfidenceFeatures:
        """With as much new and missing as another region of the same frame has.

        A region that was looked for as it is on the key lies over the key as a matter of course. That is no reason to
        prefer it to one that was carried.
        """
        return replace(self, new=other.new, missing=other.missing)


@dataclass(frozen=True)
class PoseFeatures:
    """What speaks against one frame of a part that lies as on its key, but for its pose; zero where all is well.

    Attributes
    ----------
    unlike : mean share by which what is seen of it is unlike its key: it is not there, or another part is before it.
    beside : the same for the outside of its outline, by how much it is like the inside though it was not on the key:
        the outline lies within its edge, or beyond it.
    hidden : the share of it that nearer parts hide, or that lies outside the picture.
    """

    unlike: float
    beside: float
    hidden: float

    @classmethod
    def of(cls, pose: Pose) -> PoseFeatures:
        """Of a pose that was found on a frame."""
        return cls(pose.unlike, 0.0 if pose.look is None else pose.look.beside, 1.0 - pose.seen)


def expected_overlap(
    features: ConfidenceFeatures | PoseFeatures | SpanFeatures,
    params: ConfidenceParams = CONFIDENCE,
) -> float:
    """The IoU with the artist's wish, in [0, 1], to be expected on a frame with these features.

    A logistic function of the weighted features. All weights are at least zero, so that none can speak for a frame.
    """
    fitted = {
        ConfidenceFeatures: params.features,
        PoseFeatures: params.pose_features,
        SpanFeatures: params.span_features,
    }
    constant, *slopes = fitted[type(features)]
    return float(0.5 + 0.5 * np.tanh(0.5 * (constant - np.dot(slopes, astuple(features)))))


@dataclass(frozen=True)
class SpanFeatures:
    """What speaks against one filled frame between two keys; zero where all is well.

    Attributes
    ----------
    missed : share of both regions in which the object, carried from one key all the way, differs from the other key.
    apart : -ln of the overlap of the outlines with the nearer of what the two keys, each carried, say on this frame; at
        most that of `ConfidenceParams.far_apart`: what comes out from behind something is on neither.
    doubted : by how much the log-odds of that nearer pass lie under those of a pass in no doubt.
    """

    missed: float
    apart: float
    doubted: float

    @classmethod
    def of(cls, missed: float, nearer: float, confidence: float, params: ConfidenceParams = CONFIDENCE) -> SpanFeatures:
        """From the miss at the keys, the overlap with the `nearer` pass, and the confidence of that."""
        doubted = log_odds(1.0, params) - log_odds(confidence, params)
        return cls(missed, -float(np.log(max(nearer, params.far_apart))), doubted)


def vertex_confidence(support: Array, confidence: float, params: ConfidenceParams = CONFIDENCE) -> Array:
    """For each anchor, the probability that the outline runs within 4 px (of a 480-line image) of the true one there.

    Parameters
    ----------
    support : (P,) `edge_support` of the anchors. confidence : that of the frame.
    """
    constant, own, whole = params.vertex
    logit = constant + own * support + whole * log_odds(confidence, params)
    return np.asarray(1.0 / (1.0 + np.exp(-logit)))


def log_odds(confidence: float, params: ConfidenceParams = CONFIDENCE) -> float:
    """ln(p / (1 - p)), finite for the surest and for what is lost."""
    return float(np.log(max(confidence, params.least) / max(1.0 - confidence, params.least)))


def edge_support(anchors: Array, found: Field, params: ConfidenceParams) -> Array:
    """For each anchor, in [0, 1]: how steeply the log-ratio falls from two cells inside to two cells outside."""
    here = found.grid.to_grid(anchors)
    normals = polyline.outward_normals(here)
    rows, columns = found.grid.shape
    sides = []
    for offset in (-2.0, 2.0):
        cell = np.floor(here + offset * normals).astype(np.intp)
        x, y = np.clip(cell[:, 0], 0, columns - 1), np.clip(cell[:, 1], 0, rows - 1)
        sides.append(found.values[y, x].astype(np.float64))
    return np.asarray(np.clip((sides[0] - sides[1]) / (params.steep * SURE), 0.0, 1.0))


def beside_border(inside: Bools) -> Bools:
    """The cells within three of the border of a region `(rows, columns)`, on either side of it."""
    rim = cv2.morphologyEx(inside.astype(np.uint8), cv2.MORPH_GRADIENT, np.ones((3, 3), np.uint8))
    return np.asarray(cv2.dilate(rim, np.ones((5, 5), np.uint8)) > 0)


def overlap(a: Bools, b: Bools) -> float:
    """Intersection over union of two regions `(rows, columns)`; 0 for two empty ones."""
    union = int(np.count_nonzero(a | b))
    return int(np.count_nonzero(a & b)) / union if union else 0.0


def node_support(nodes: Array, context: CurveContext, scale: float, params: ConfidenceParams) -> Array:
    """For each node, in [0, 1]: the edge under the outline against the strongest edge near it along the normal.

    One where the outline sits on the strongest edge around, near zero where it crosses a flat area beside an edge or
    lies where there is no edge at all.
    """
    here = context.local(nodes)
    normals = polyline.outward_normals(here)
    offsets = np.arange(-params.reach, params.reach + 1) * scale
    positions = here[:, None] + offsets[None, :, None] * normals[:, None]
    strength = np.sqrt(_lookup(context.squared_gradient, positions))
    near = np.abs(offsets) <= params.near * scale
    return np.asarray(strength[:, near].max(axis=1) / np.maximum(strength.max(axis=1), params.faint))


def frame_confidence(support: Array, warp: Warp) -> float:
    """Trust of the paper's engine in a frame, in [0, 1], as it gates what its models learn: it is not calibrated.

    The mean support of the nodes, less where the followed points disagree.
    """
    motion = 0.5 + 0.5 * warp.agreement if warp.points >= 3 else 0.5
    return float(np.clip(support.mean() * motion, 0.0, 1.0))


def wholeness(line: Array, extent: float, params: ConfidenceParams) -> float:
    """How much of an object a closed polyline `(N, 2)` holds, in [0, 1]: 1 from a share of `extent` (square pixels)
    on, `ConfidenceParams.whole`.

    A curve that has shrunk to a sliver may lie on a strong edge and rest there: its edges alone do not tell.
    """
    return float(np.clip(abs(polyline.signed_area(line)) / max(params.whole * extent, 1e-9), 0.0, 1.0))


def _lookup(field: Float32, positions: Array) -> Array:
    """Values of `field` under `positions (..., 2)`; zero outside."""
    height, width = field.shape
    column, row = (np.floor(positions[..., k]).astype(np.intp) for k in (0, 1))
    inside = (column >= 0) & (column < width) & (row >= 0) & (row < height)
    values = np.zeros(positions.shape[:-1])
    values[inside] = field[row[inside], column[inside]]
    return values
