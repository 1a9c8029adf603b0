"""Parameters of fitting curves to lines and to each other. No configuration has them: no key of a run comes of them."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class CurveFitParams:
    """Parameters of fitting a spline of few points to a line (`geometry.fit`).

    Attributes
    ----------
    step : pixels between the samples of the outline that a curve is fitted to.
    corner, reach : degrees by which an outline turns at a corner, at least, over `reach` pixels on either side of it.
    softness : pixels of the Gaussian that takes the stairs of pixels off before tangents are measured.
    min_stroke : pixels: a shorter open line is one straight segment.
    hand_corner, hand_softness, hand_reach, hand_step : degrees and pixels of `geometry.stroke` for lines that a hand
        drew: its stroke has no finer detail than its tremor.
    hand_span : pixels of such a line that are fitted by themselves where it has no corners.
    """

    step: float = 0.5
    corner: float = 50.0
    reach: float = 5.0
    softness: float = 1.2
    min_stroke: float = 2.0
    hand_corner: float = 55.0
    hand_softness: float = 2.5
    hand_reach: float = 9.0
    hand_step: float = 2.0
    hand_span: float = 120.0


@dataclass(frozen=True)
class MergingParams:
    """Parameters of taking points out of a spline (`geometry.merging`).

    Attributes
    ----------
    samples : places on each old segment at which the new one is fitted to it.
    rounds : how often places on the new segment are moved to where they lie nearest to the old ones.
    least_handle : the shortest handle of a smooth point that the fit may choose, as a part of the run's length.
    straight : degrees within which the handles of a smooth point are opposite; it stays so.
    """

    samples: int = 16
    rounds: int = 4
    least_handle: float = 0.02
    straight: float = 2.0


@dataclass(frozen=True)
class ControlPolygonParams:
    """Parameters of control polygons fitted to curves (`geometry.bspline`).

    Attributes
    ----------
    samples : places on each segment at which a control polygon is fitted to a curve.
    reach : control points on either side that move along when one is inserted or taken out.
    """

    samples: int = 4
    reach: int = 2


CURVE_FIT = CurveFitParams()
MERGING = MergingParams()
CONTROL_POLYGON = ControlPolygonParams()
