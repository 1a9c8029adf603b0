"""Parameters of how steadily outlines stand."""

from __future__ import annotations

from dataclasses import dataclass

from roam_core.params.stamped import later


@dataclass(frozen=True)
class ResidualParams:
    """Parameters of what an outline does beyond the motion of the picture beside it (`propagate.steadiness.residual`).

    Attributes
    ----------
    spacing : pixels of a 480-line image between two places along the outline, about.
    least_places, most_places : places between two points of a curve.
    inset : pixels of a 480-line image inside the outline at which the picture's motion is read: at an edge itself it is
        that of either side.
    cells : cells a pixel of a 480-line image at which it is worked out.
    margin : pixels of a 480-line image around the outlines that are looked at for it.
    along : places to either side among which the nearest of the outline carried along is looked for.
    most : pixels of a 480-line image beyond which an outline counts as no farther off: it was lost, which is no boil.
    """

    spacing: float = 4.0
    least_places: int = 2
    most_places: int = 24
    inset: float = 6.0
    cells: float = 1.0
    margin: float = 24.0
    along: int = 12
    most: float = 20.0


@dataclass(frozen=True)
class SteadinessParams:
    """Parameters of outlines drawn to where those of the frames beside have them (`propagate.steadiness.settle`).

    Attributes
    ----------
    weight : what the outline of a neighbouring frame counts beside the frame's own; 0: each stays where it was found.
    reach : frames to either side that are asked.
    fades : frames, standard deviation, by which a neighbour counts less the farther off it is.
    alike : pixels of a 480-line image from where most agree at which an outline counts a third at a place: what is
        farther off has another reason than trembling. rounds : times that this is looked at.
    rigidity : weight, per control point, that holds the fitted spline where it was.
    residual : of what outlines do beyond the motion of the picture.
    """

    weight: float = 0.25
    reach: int = 2
    fades: float = 1.5
    alike: float = 3.0
    rounds: int = 3
    rigidity: float = 0.02
    residual: ResidualParams = later(ResidualParams())


RESIDUAL = ResidualParams()
