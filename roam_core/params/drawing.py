"""Parameters of tools that draw by the picture: no run of the engine reads them, so no configuration has them."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class CutOutParams:
    """Parameters of the object in a box, or under a click (`proposal.assist.cut_out`).

    Attributes
    ----------
    most_cells : cells on the longer side of the copy that is cut.
    margin : how much of the box's size is looked at on each side of it: the background that the object differs from.
    around, nearby : the box around a click's region goes so many of its sizes beyond it, and at least this share of
        the picture's.
    swell, along : A later mark's region is background where it is so much larger than those before it and has this
        share of the border.
    mark : cells around a mark that are held on its side.
    growths : times that the box around a click is cut, and made larger where the object runs against its side.
    rounds : rounds of learning colours and cutting.
    least_share : share of what was thought to be inside at first that must be left; a cut that leaves less has
        collapsed.
    least_box : pixels on the shorter side of the smallest box.
    tolerance : cells by which the shape may stray from the cut.
    local : cells on a side of the square in which the colours on both sides of the border are learned for its
        cells.
    least_contrast : grey values between the two sides, all channels together, at which a mixed cell tells how much
        is covered.
    smoothing : cells of the Gaussian before it is cut: grain is no edge.
    softness : cells of the Gaussian that takes the stairs off the cut before its outline is fitted.
    """

    most_cells: int = 360
    margin: float = 0.3
    around: float = 1.0
    nearby: float = 0.15
    swell: float = 3.0
    along: float = 0.05
    mark: int = 2
    growths: int = 3
    rounds: int = 5
    least_share: float = 0.08
    least_box: float = 6.0
    tolerance: float = 1.0
    local: int = 11
    least_contrast: float = 24.0
    smoothing: float = 0.8
    softness: float = 1.2


@dataclass(frozen=True)
class GrowingParams:
    """Parameters of the region of like colour around a place (`proposal.assist.growing`).

    Attributes
    ----------
    steps : lab distances from the colour that was clicked at which its region is grown.
    leak : A region that grows by more than this from one distance to the next has run out into its surroundings.
    enough : times the smallest region that one must have before it counts as what was there before a leak.
    smoothing : spread of colours, grey values, and of places, cells, over which grain is smoothed before.
    largest, smallest : shares of the picture: a region outside of these is no object that was clicked on.
    """

    steps: tuple[float, float, float, float, float, float, float, float] = (3.0, 4.5, 6.0, 8.0, 10.0, 13.0, 17.0, 22.0)
    leak: float = 2.5
    enough: float = 8.0
    smoothing: tuple[float, float] = (30.0, 5.0)
    largest: float = 0.4
    smallest: float = 0.0004


@dataclass(frozen=True)
class LiveWireParams:
    """Parameters of paths along edges (`proposal.assist.livewire`).

    Attributes
    ----------
    canny : thresholds of the edge detector, 8-bit grey values a pixel: low to go on along an edge, high to begin
        one.
    strongest : gradients above this count alike, so that one hard edge does not outshine all softer ones.
    smoothing : cells of the Gaussian before edges are looked for: grain is no edge.
    weakest : grey values a pixel: a weaker gradient is no edge to snap to.
    nearer : grey values a pixel by which an edge must be stronger for each pixel that it is farther away.
    fewest : cells on a side of the smallest piece of a picture that has edges.
    """

    canny: tuple[int, int] = (32, 100)
    strongest: float = 200.0
    smoothing: float = 1.0
    weakest: float = 4.0
    nearer: float = 0.25
    fewest: int = 4


CUT_OUT = CutOutParams()
GROWING = GrowingParams()
LIVE_WIRE = LiveWireParams()
