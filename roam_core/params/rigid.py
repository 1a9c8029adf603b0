"""Parameters of the motion of a plane: a plane by its corners, and objects that are carried as one piece."""

from __future__ import annotations

from dataclasses import dataclass

from roam_core.params.stamped import later


@dataclass(frozen=True)
class PlanarParams:
    """Parameters of a plane by its corners (`motion.planar`).

    Attributes
    ----------
    corners : corners that are followed.
    side : most pixels of a side of the region that is looked at; a greater one is reduced.
    window, window_closely : pixels of the windows that are compared with the last picture, and with the reference
        warped to nearly the same; a small one takes in less of what lies beside the plane.
    returned : pixels of the reduced picture by which a corner that is followed there and back again may miss its
        place.
    agree, agree_closely : pixels of the reduced picture by which a corner may disagree with the motion from the
        last picture, and with the one from the reference. Two surfaces that go apart by twice as much are told
        apart; grain moves a corner by far less.
    enough : times as many corners must agree as fix the motion.
    far : sizes of the picture beyond which no outline is carried: a homography can throw points over the horizon.
    travel : pixels of a 480-line image by which the plane may move between two frames and still be found.
    """

    corners: int = 500
    side: int = 1280
    window: int = 21
    window_closely: int = 11
    returned: float = 0.5
    agree: float = 1.0
    agree_closely: float = 0.6
    enough: int = 3
    far: float = 3.0
    travel: float = 48.0


PLANAR = PlanarParams()


@dataclass(frozen=True)
class RigidityParams:
    """Parameters of an object that is carried as one piece (`propagate.whole.rigid`).

    Attributes
    ----------
    corners : corners of the key that are looked for.
    tolerance : pixels of a 480-line image by which a corner may disagree.
    as_one : share of the corners that are found at all that must agree: of what is hidden or blurred nothing is
        found, what moves otherwise is found elsewhere.
    simpler : factor by which a simpler motion may miss the agreeing corners more (root mean square) to be taken all
        the same: few corners bend a plane.
    fewest : corners that must agree: fewer tell too little of what lies between and around them.
    least_seen : share of the corners that must be in the picture.
    still : factor on the least share while the object was one piece on the frame before: what was so mostly stays
        so.
    given_up : frames in a row without a match after which the object is no longer asked to be rigid.
    resized : factor by which the area may differ from the one that the motion since the last frame lets one expect.
    nearest : corners around a place that speak for it.
    cut : distance from the edge of the key's picture within which an outline runs there because the picture ends.
        This and the next in pixels of a 480-line image.
    opened : how far into the picture such a stretch may come before what it cut off must be in sight; by a pose, too
        (`propagate.whole.cut_off`).
    planar : of matching the key's picture.
    """

    corners: int = 250
    tolerance: float = 1.2
    as_one: float = 0.88
    simpler: float = 1.15
    fewest: int = 20
    least_seen: float = 0.4
    still: float = 0.75
    given_up: int = 6
    resized: float = 1.3
    nearest: int = 12
    cut: float = 2.0
    opened: float = 6.0
    planar: PlanarParams = later(PLANAR)
