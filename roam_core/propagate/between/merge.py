"""Two passes made one: the outlines of a span on one frame between its keys."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import bezier
from roam_core.geometry.simple import simplified
from roam_core.propagate.between.along_union import along_union
from roam_core.propagate.between.endpoint_consistency import Span
from roam_core.propagate.between.expected import expected
from roam_core.propagate.between.merged_confidence import alone, features_of_one, features_together, support
from roam_core.propagate.between.merged_region import Colours, merged_region
from roam_core.propagate.between.moment import Moment, are_apart
from roam_core.propagate.frame.confidence import SpanFeatures, expected_overlap, vertex_confidence
from roam_core.propagate.frame.contour_fit import fitted, spline_coverage
from roam_core.propagate.frame.result import Part
from roam_core.proposal.cues.evidence import Field


@dataclass(frozen=True, eq=False)
class Merged:
    """One outline on one frame: its points `(P, 3, 2)`, confidence in [0, 1], and the same for each point `(P,)`.

    `features` is what speaks against the frame; None where a single pass knows of it.
    """

    points: Array
    confidence: float
    vertex_confidence: Array
    features: SpanFeatures | None = None

    @property
    def unseen(self) -> Merged:
        """The same where the picture shows nothing: whatever was found there is not to be trusted."""
        return replace(self, confidence=0.0, vertex_confidence=np.zeros_like(self.vertex_confidence))


def merged(
    span: Span, frame: int, alive: Collection[int] | None = None, colours: Colours | None = None
) -> list[Merged | None]:
    """Every outline of the span on a frame between the keys; None for one that neither pass brought there.

    `alive` are those that there are on the frame; None: all. What the others enclosed on a key belongs to the object
    all the same, and goes to these. `colours` make the frame's picture speak; None: what was drawn and carried does.
    """
    moment = Moment.of(span, frame)
    wanted = range(len(span.first.parts)) if alive is None else sorted(alive)
    known = [k for k in wanted if k in moment.there or k in moment.here]
    result: list[Merged | None] = [None] * len(span.first.parts)
    if not known:
        return result
    parts = tuple(Part(expected(moment, k), span.subtracts(k)) for k in known)
    outlines = _along_region(moment, dict(zip(known, parts, strict=True)), colours)
    along = along_union(moment, outlines, colours)
    together = [k for k in known if not moment.is_posed(k)]
    of_all = features_together(moment, together, [outlines[k] for k in together])
    for k, part in outlines.items():
        points, by_passes = part.points, moment.by_passes(k)
        if k in along:
            points, by_passes, features = along[k].points, along[k].by_passes, along[k].features
        else:
            features = features_of_one(moment, k, points) if moment.is_posed(k) else of_all
        trust = span.params.confidence
        confidence = alone(moment) if features is None else expected_overlap(features, params=trust)
        vertices = vertex_confidence(support(by_passes, span), confidence, trust)
        result[k] = Merged(points, confidence, vertices, features)
    return result


def _along_region(moment: Moment, parts: Mapping[int, Part], colours: Colours | None) -> dict[int, Part]:
    """The outlines, simple; those of the object's region fitted to the one that the estimates agree on."""
    span, ours = moment.span, [k for k in parts if k in moment.of_region]
    covers = [bezier.flatten(part.points) for k, part in parts.items() if k not in ours]
    region = None
    if ours and not span.is_planar and not moment.is_one_piece:
        region = merged_region(moment, tuple(parts[k] for k in ours), covers, colours)
    begun = dict(parts)
    points = {k: part.points for k, part in parts.items()}
    if region is not None:
        begun |= {k: _where_more_is(moment, k, parts[k], region) for k in ours}
        constraints = [span.constraints(k, moment.u) for k in ours]
        placed = fitted(tuple(begun[k] for k in ours), constraints, region, span.scale, span.params)
        points |= {k: each for k, (each, _) in zip(ours, placed, strict=True)}
    untying = span.params.contour_fit.untying
    return {
        k: replace(part, points=simplified(points[k], part.points, span.scale, untying)) for k, part in begun.items()
    }


def _where_more_is(moment: Moment, k: int, part: Part, region: Field) -> Part:
    """An outline that the passes took to different components of an object goes to the greater of them."""
    places = [points[k] for points in (moment.there, moment.here) if k in points]
    if len(places) < 2 or not are_apart(places[0], places[1], moment.span.params.span.apart_by):
        return part
    shares = [float(spline_coverage(points, region.grid)[region.inside].sum()) for points in places]
    return replace(part, points=places[int(np.argmax(shares))])
