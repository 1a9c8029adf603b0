"""Parameters of fitting the points of a shape to an outline."""

from __future__ import annotations

from dataclasses import dataclass

from roam_core.params.stamped import later


@dataclass(frozen=True)
class UntyingParams:
    """Parameters of taking self-intersections out of a spline (`geometry.simple`).

    Attributes
    ----------
    tolerance : pixels of a 480-line image by which the polyline that is looked at may stray from the spline.
    straightenings : times that crossing segments are straightened before more is done about them.
    """

    tolerance: float = 0.02
    straightenings: int = 4


UNTYING = UntyingParams()


@dataclass(frozen=True)
class InvariantsParams:
    """Parameters of which places of an outline are tips and which are bays (`proposal.outline.invariants`).

    Attributes
    ----------
    radii : neighbourhoods that are looked at, as shares of the square root of the area.
    cells : cells along that root.
    reach : standard deviations at which a neighbourhood ends.
    most : cells of a side; an outline that is all length and no area is looked at more coarsely.
    """

    radii: tuple[float, float] = (0.1, 0.2)
    cells: float = 32.0
    reach: float = 3.0
    most: int = 1000


INVARIANTS = InvariantsParams()


@dataclass(frozen=True)
class RefineParams:
    """Parameters of the least squares that draw a spline closer to an outline (`proposal.outline.refine`).

    Attributes
    ----------
    fine : vertices a segment at which a sample's nearest place is looked for.
    window : vertices to both sides that are looked at.
    turn : price, in squared pixels, of a place whose outline runs at a right angle.
    stay : weight, against the samples of one segment, that holds an anchor to its matched place along the outline
        from frame to frame.
    hold : weight, against the samples of one segment, that holds handles to their anchors as they were.
    astray : steps of the samples that an anchor may lie off the outline.
    line : weight, against one sample, of a smooth point's handle off the common line.
    """

    fine: int = 12
    window: int = 20
    turn: float = 9.0
    stay: float = 0.3
    hold: float = 0.002
    line: float = 1.0
    astray: float = later(4.0)


@dataclass(frozen=True)
class ContourFitParams:
    """Parameters of fitting a shape's points to an outline (`proposal.outline.contour`).

    Attributes
    ----------
    stretch : price of a piece of outline that grows to twice its share of the whole.
    near : pixels of a 480-line image at which a node that lies so far from where it was expected has a price of 1.
    farthest : the most that distance costs: what is lost is lost.
    turn : price of a node whose outline runs the opposite way.
    bulge : price of a node that was all tip on the key and now is all bay (`proposal.outline.invariants`).
    spacing : pixels of a 480-line image between the nodes that are matched.
    most : nodes of an outline, and a third of the places where they may come to lie; a longer one is looked at more
        coarsely.
    chords : chords by which the length from node to node is told.
    step : pixels of a 480-line image between the places where a node may come to lie.
    finer : samples of the outline for each such place, for the fit of the handles.
    rounds : rounds of least squares over the whole spline.
    starts : samples tried for the node that is surest of its place.
    settling : rounds in which the matched nodes settle between the samples.
    loose : samples by which they may do so; none overtakes its neighbour.
    straight, straight_each : weights that draw the handles of a segment to a straight line, against one sample, and
        against each of its samples.
    tips, refine : of the shape of an outline, and of the last fit. untying : of taking crossings out.
    """

    stretch: float = 6.0
    near: float = 12.0
    turn: float = 1.0
    bulge: float = 240.0
    spacing: float = 9.0
    chords: int = 4
    step: float = 3.0
    finer: int = 2
    rounds: int = 2
    starts: int = 3
    settling: int = 3
    loose: float = 0.95
    farthest: float = later(9.0)
    most: int = later(2000)
    straight: float = later(0.005)
    straight_each: float = later(0.002)
    tips: InvariantsParams = later(INVARIANTS)
    refine: RefineParams = later(RefineParams())
    untying: UntyingParams = later(UNTYING)
