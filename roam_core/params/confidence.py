"""Parameters of how far a tracked frame is trusted."""

from __future__ import annotations

from dataclasses import dataclass

from roam_core.params.stamped import later


@dataclass(frozen=True)
class ConfidenceParams:
    """Parameters of the confidence in a frame and in its vertices (`propagate.frame.confidence`).

    Attributes
    ----------
    reach : pixels to both sides of the outline that are searched for a stronger edge than the one it lies on.
    near : pixels of a 480-line image to both sides in which an edge counts as the outline's own.
    faint : strength of the strongest edge, in [0, 1], below which it is grain and supports nothing.
    steep : how far the log-ratio has to fall across an outline for its full support, in units of what counts as sure.
    whole : share of the area that an object should have from which a curve holds all of it.
    least : overlap below which all is lost.
    far_apart : overlap with both passes below which a filled frame is no worse for being farther from them.
    features : the constant of the logistic model, and the weight of each of the features of a region in their order.
    pose_features : the same of those of a pose; fitted to rendered figures and to real legs, both weighing the same.
    span_features : the same of those of a filled frame.
    vertex : constant of the logistic model of anchors, weight of their support, weight of the frame's log-odds.
    """

    reach: int = 8
    least: float = 0.02
    far_apart: float = 0.5
    features: tuple[float, ...] = (4.34, 1.44, 5.87, 0.93, 0.27, 1.13, 0.13, 0.5)
    pose_features: tuple[float, ...] = (3.96, 5.91, 1.88, 0.54)
    span_features: tuple[float, ...] = (3.48, 1.29, 3.23, 0.52)
    vertex: tuple[float, float, float] = (-1.33, 1.72, 0.79)
    near: float = later(1.5)
    faint: float = later(0.15)
    steep: float = later(1.2)
    whole: float = later(0.5)


CONFIDENCE = ConfidenceParams()
