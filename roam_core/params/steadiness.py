"""Parameters of how steadily outlines stand."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass(frozen=True)
class ResidualParams:
    """Parameters of what an outline does beyond the motion of the picture beside it (`propagate.steadiness.residual`).

    Attributes
    ----------
    spacing : pixels of a 480-line image between two places along the outline, about.
    least_places, most_places : places between two points of a curve.
    inset : pixels of a 480-line image inside the outline at which the picture's motion is read: at an edge itself it is
        that of either side.
    cells : cells a pixel of a 480-line image at which it is worked out. finest : level of the pyramid at which it ends;
        0 is the cells themselves.
    margin : pixels of a 480-line image around the outlines that are looked at for it.
    along : places to either side among which the nearest of the outline carried along is looked for.
    most : pixels of a 480-line image beyond which an outline counts as no farther off: it was lost, which is no boil.
    """

    spacing: float = 4.0
    least_places: int = 2
    most_places: int = 24
    inset: float = 3.0
    cells: float = 1.0
    finest: int = 1
    margin: float = 24.0
    along: int = 12
    most: float = 20.0


@dataclass(frozen=True)
class SteadinessParams:
    """Parameters of steadying outlines (`propagate.steadiness.settle`, `propagate.steadiness.steadied`).

    Attributes
    ----------
    residual : what outlines do beyond the motion of the picture, finer than boil is measured by it.
    strength : of the pass where nobody says another.
    step : what an outline that leaves the motion of the picture from one frame to the next counts, beside one that is
        moved by as much; at full strength.
    turn : the same of one that leaves it otherwise than a frame ago: an even drift of the flow does not count.
    alike : pixels of a 480-line image beyond which what an outline does counts as its own motion, not as boil.
    unsure : pixels of a 480-line image by which the motion there and back may differ to be believed by a third.
    rounds : of weighing both anew after outlines were moved.
    rigidity : what control points that move apart count, as in `RoamParams.fit_rigidity`.
    reach : frames on either side of a range that its outlines are still held to.
    """

    residual: ResidualParams = field(default_factory=lambda: ResidualParams(inset=5.0, finest=0))
    strength: float = 0.5
    step: float = 2.0
    turn: float = 2.0
    alike: float = 3.0
    unsure: float = 1.0
    rounds: int = 4
    rigidity: float = 0.02
    reach: int = 2


RESIDUAL = ResidualParams()
STEADINESS = SteadinessParams()
