"""Parameters of how steadily outlines stand."""

from __future__ import annotations

from dataclasses import dataclass


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
    inset: float = 3.0
    cells: float = 1.0
    margin: float = 24.0
    along: int = 12
    most: float = 20.0


RESIDUAL = ResidualParams()
