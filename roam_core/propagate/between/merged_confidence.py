"""How far what was merged between two keys is trusted."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import bezier
from roam_core.propagate.between.endpoint_consistency import Span, grid_over
from roam_core.propagate.between.moment import Moment
from roam_core.propagate.frame.confidence import SpanFeatures, overlap
from roam_core.propagate.frame.contour_fit import enclosed
from roam_core.propagate.frame.result import Part


def features_together(moment: Moment, known: list[int], outlines: list[Part]) -> SpanFeatures | None:
    """What speaks against the merged outlines; None where a pass did not arrive, and nothing can be compared."""
    span = moment.span
    if not known or span.residuals is None or moment.onwards is None or moment.back is None:
        return None
    onwards, back, _, _ = span.residuals
    return features(moment, known, outlines, 0.5 * (onwards.loss + back.loss))


def features_of_one(moment: Moment, k: int, points: Array) -> SpanFeatures | None:
    """What speaks against one outline that was carried by its pose; None where only one pass knows of it."""
    if k not in moment.span.losses or k not in moment.there or k not in moment.here:
        return None
    return features(moment, [k], [Part(points)], moment.span.losses[k])


def features(moment: Moment, known: list[int], outlines: list[Part], missed: float) -> SpanFeatures:
    """What speaks against outlines, beside what each pass says of them; `missed` is by how much the keys were."""
    span = moment.span
    ends = ((moment.onwards, span.first, moment.there), (moment.back, span.last, moment.here))
    sides, trusts = [], []
    for stop, key, points in ends:
        ours = [k for k in known if k in points]
        if stop is not None and ours:
            sides.append([Part(points[k], span.subtracts(k)) for k in ours])
            trusts.append(float(np.mean([stop.confidence[key.members.index(k)] for k in ours])))
    splines = [part.points for side in (outlines, *sides) for part in side]
    grid = grid_over(splines, span.size, span.params.span.endpoint_consistency.look, span.scale)
    merged, *theirs = (enclosed(side, grid) > 0.5 for side in (outlines, *sides))
    overlaps = [overlap(merged, each) for each in theirs]
    nearer = int(np.argmax(overlaps))
    return SpanFeatures.of(missed, overlaps[nearer], trusts[nearer], span.params.confidence)


def alone(moment: Moment) -> float:
    """Where one pass only speaks: what it was trusted there."""
    stops = [stop.confidence for stop in (moment.onwards, moment.back) if stop is not None]
    return float(np.mean(np.concatenate(stops))) if stops else 0.0


def support(by_passes: Sequence[Array], span: Span) -> Array:
    """For each point of an outline, in [0, 1]: how near the points of the two passes are to each other.

    `by_passes` are those `(P, 3, 2)` of the passes that know of it; where only one does, nothing tells.
    """
    if len(by_passes) < 2:
        return np.full(len(by_passes[0]), 0.5)
    there, here = by_passes
    apart = np.hypot(*(there - here)[:, bezier.ANCHOR].T) / span.scale
    return np.asarray(1.0 / (1.0 + apart / span.params.span.apart))
