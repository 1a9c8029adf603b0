"""Parameters of an object in parts, and of shapes that go by their poses."""

from __future__ import annotations

from dataclasses import dataclass, field

from roam_core.params.pose import JOINTS, JointParams, PoseParams
from roam_core.params.stamped import later


@dataclass(frozen=True)
class FreeEdgesParams:
    """Parameters of free edges that go to the border of the union (`propagate.frame.free_edges`).

    Attributes
    ----------
    reach : pixels of a 480-line image by which an outline may miss the border of the region and still be meant to
        be it.
    outside : pixels of a 480-line image beyond an outline at which it is asked what lies there.
    places : of half a segment of an outline that are asked.
    facing : cosine of the angle up to which two borders run alike.
    least : share of the places around a point that must be free for the point to be moved.
    """

    reach: float = 2.5
    outside: float = 3.0
    places: int = 8
    facing: float = 0.7
    least: float = 0.5


@dataclass(frozen=True)
class EdgesParams:
    """Parameters of what an outline is told to be at each place: free, a seam or hidden (`propagate.parts.edges`).

    Attributes
    ----------
    margin : pixels of a 480-line image around the outlines that are looked at.
    changes : contrast from which the picture changes across an edge; from there `motion.template` counts no seam.
    step : pixels of a 480-line image between the samples of an outline.
    around : neighbouring samples whose median contrast counts: grain and small spots make no edge.
    depths : shares of the distance from the edge at which the inside is looked at: the greatest that lies inside.
    free : what makes an edge free in tracking. pose : what is looked at beside an outline.
    """

    margin: float = 12.0
    changes: float = 0.5
    step: float = 2.0
    around: int = 5
    depths: tuple[float, ...] = (0.2, 0.5, 1.0)
    free: FreeEdgesParams = field(default_factory=FreeEdgesParams)
    pose: PoseParams = field(default_factory=PoseParams)


EDGES = EdgesParams()


@dataclass(frozen=True)
class FigureParams:
    """Parameters of an object in parts (`propagate.parts.figure`).

    Attributes
    ----------
    margin : pixels of a 480-line image around what is looked at.
    nats : nats of a region's evidence that change the odds of being needed by a factor e.
    smooth : cells over which needs are smoothed.
    trusted : expected overlap of the object's region from which its border is believed.
    blind : confidence in a part that is carried along without being seen.
    unfit : difference of colour to the key, Lab units, that three quarters of what is seen of a part exceed where its
        pose does not fit. covered : overlap of all parts with the object's region under which such a part goes along
        with the whole (`propagate.parts.along`). shrunk : share of its area, as it grew with the whole, under which
        the whole has lost it. against : what its colours may say against that, of all that they say, for it to go on.
        along_near : pixels of a 480-line image within which what is known of the whole is heard most.
        along_places : places a segment of its outline that are.
    free_edges : of those that go to the border of the union. joints : of where parts hang on each other.
    """

    margin: float = 12.0
    nats: float = 1.5
    smooth: float = 1.5
    trusted: float = 0.5
    blind: float = 0.3
    unfit: float = later(3.0)
    covered: float = later(0.85)
    shrunk: float = later(0.5)
    against: float = later(0.5)
    along_near: float = later(2.0)
    along_places: int = later(6)
    free_edges: FreeEdgesParams = later(FreeEdgesParams())
    joints: JointParams = later(JOINTS)
