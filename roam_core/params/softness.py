"""Parameters of how soft a plate's edge is: no run of the engine reads them, so no configuration has them."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class SoftnessParams:
    """Parameters of matching the plate's edge (`matte.edge_profile`, `matte.softness`).

    Attributes
    ----------
    reach : pixels that are looked at on either side of an outline.
    step : pixels between two samples across it.
    near : pixels from the outline at which a sample counts about half; what lies farther off is texture.
    widths : pixels across which coverage falls from 1 to 0, that an edge is tried with; the first is a hard one.
    astray : pixels by which the outline may miss the edge, either way.
    every : pixels between two places along the outline.
    most_places : places between two points of a curve at most.
    spread : pixels, standard deviation, by which a plate spreads every edge: one no softer than that is hard.
    grain : grey values, standard deviation, by which samples differ from any edge.
    chroma : what a difference of colour counts beside one of brightness: most plates keep colour at half the detail.
    samples : independent samples in one place: what lies side by side in a picture is alike.
    doubt : most that one place may say against a width, in the logarithm of its likelihood.
    apart : pixels of the outline's surroundings in which another shape makes it no edge of the whole.
    bend : what one step along the widths costs between neighbouring points.
    soft : what each pixel costs at a point by which its edge is wider or narrower than the one all have in common.
    leap : what that costs at most: a point with much to say is heard.
    in_time : share of a frame's neighbours, each, in what its points say.
    shutters : frames that a shutter is tried with; the first is none.
    least_shutter : frames below which motion blur is left out: nobody sees it.
    least_gain : what a shutter must say more than none, a place.
    heard : places of one point that count, at most: what lies close together says the same.
    least_said : what a point must say between the best and the worst of the widths to count as read.
    least_width : pixels of feather below which an edge is left hard.
    """

    reach: float = 9.0
    step: float = 0.5
    near: float = 4.0
    widths: tuple[float, ...] = (0.0, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.5, 8.0, 10.0, 12.5)
    astray: float = 2.0
    every: float = 3.0
    most_places: int = 12
    spread: float = 0.6
    grain: float = 2.5
    chroma: float = 0.5
    samples: float = 6.0
    doubt: float = 3.0
    apart: float = 4.0
    bend: float = 2.0
    soft: float = 2.0
    leap: float = 4.0
    in_time: float = 0.5
    shutters: tuple[float, ...] = (0.0, 0.1, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.55, 0.6, 0.7, 0.8, 0.9, 1.0)
    least_shutter: float = 0.1
    least_gain: float = 0.005
    heard: int = 4
    least_said: float = 0.5
    least_width: float = 3.0


SOFTNESS = SoftnessParams()
