"""Parameters of the poses of parts: templates on bones, and how they hang together."""

from __future__ import annotations

import math
from dataclasses import dataclass

from roam_core.params.stamped import later


@dataclass(frozen=True)
class PyramidParams:
    """Parameters of a picture at ever coarser levels (`features.pyramid`).

    Attributes
    ----------
    levels : each half as fine as the one before it; at least two.
    soft, softer : Gaussians, in cells, on the finest level and before each halving.
    """

    levels: int = 3
    soft: float = 0.8
    softer: float = 1.0


@dataclass(frozen=True)
class BonesParams:
    """Parameters of the bones along a shape (`geometry.skinning`).

    Attributes
    ----------
    across : cells along the root of a shape's area in which the way along it is measured.
    most : cells of a side; a shape that is all length is measured more coarsely.
    long : length of a shape over its width from which it has joints.
    slice : share of the length over which the middle of the shape is taken where two bones meet.
    joint : share of a bone's length over which it gives way to the next.
    """

    across: float = 32.0
    most: int = 400
    long: float = 3.0
    slice: float = 0.08
    joint: float = 0.4


BONES = BonesParams()


@dataclass(frozen=True)
class JointParams:
    """Parameters of where shapes hang on each other (`geometry.joints`).

    Attributes
    ----------
    gap : pixels of a 480-line image between shapes that still meet.
    least : square pixels of a 480-line image in which they must do so.
    long : length of a shape over its width from which it has ends.
    tip : share of the length at which the width of an end is taken.
    most : share of a shape without ends that another may cover for there to be a place at which it hangs on it.
    """

    gap: float = 3.0
    least: float = 12.0
    long: float = 1.5
    tip: float = 0.25
    most: float = 0.4


JOINTS = JointParams()


@dataclass(frozen=True)
class PoseParams:
    """Parameters of the pose of a part (`motion.pose`). Lengths are pixels of a 480-line image, turns radians,
    differences of colour units of Lab (L from 0 to 100), strains natural logarithms of a stretch.

    Attributes
    ----------
    samples : places of a part that are compared with its key.
    joints : places at which a long part may bend.
    like : difference of colour at which a sample is half unlike the key, the least and the most. like_times : it
        follows so many times the median of what was seen; not that of a lone shape while its pose is in doubt.
        like_roughly : the least in the search from afar.
    beside, beside_at, beside_like : weight of the places beside the outline that may not look like the inside, how far
        from it they lie, and the difference of colour up to which they do.
    unseen : what a sample costs that is hidden or lies outside the picture.
    needless, needed : what a sample costs where the object is not, or another part is; what a place beside the outline
        costs where the object is and no other part. tie, tie_reach : weight of a joint, and pixels at which it gives.
    search_move, search_step, search_turn, search_turns : how far around the expected pose, in which steps, and through
        which turns in how many steps, poses are tried. glanced_at : one of so many samples tells them apart at first.
        looked_at, candidates : of how many of the best how many, apart from each other, are followed up.
    rounds : of the descent on each level.
    followed : of these, and of two from the last frame, how many beyond the coarsest level. sure : cost up to which
        the pose near the last one is taken without a search.
    momentum : share of the last frame's motion that is expected to go on.
    expect_move, expect_turn, expect_strain : standard deviations from what is expected; most_strain : those from the
        key (along the part, across, shear). prior : weight of all that, in units of a sample's cost.
    bend, straight : standard deviations of how a joint's angle changes in a frame, and of the angle itself.
    lost : cost from which a pose is in doubt. gone, clear : difference of colour to the key that three quarters of a
        lone shape's samples exceed where it is not to be seen, and that a quarter stays under where it is, clearly.
        recent : frames within which it must have been seen so to be hidden, not changed. along : pixels of a 480-line
        image around it whose motion it then goes along with.
        glimpse : share of a part in doubt that must be seen, and clearly, for it to be found. astray, turned : times
        its own length that it may have gone unseen, and how far it may have turned.
    widened : times that the search grows by further such frames, at most.
    apart_step, apart_turn : steps of the search, and turns of it, from which two poses are two candidates.
    least_samples : sample places that a part must have to be matched at all.
    around : sample places around a point by which it is judged.
    taps : moments at which the template is looked at while the shutter is open. shutter : share of a frame for which it
        is taken to be open, on frames that look blurred.
    margin : pixels of a 480-line image around a part, and around where it is searched. narrow : pixels across a
        picture, or what is left of it, that shows nothing.
    stretch : share of an outline within which its seam is counted where it is densest.
    alike : share of a part that must look the same on both keys of a span for the rest to be taken for what hides it
        there. It does up to a difference of `like_roughly`. places : on each segment of the two outlines, by
        which they are laid on each other.
    pyramid : of the levels on which it is looked for. bones : of those along the part.
    """

    samples: int = 600
    joints: int = 1
    like: tuple[float, float] = (5.0, 15.0)
    like_times: float = 3.0
    like_roughly: float = 10.0
    beside: float = 0.4
    beside_at: float = 4.0
    beside_like: float = 10.0
    unseen: float = 0.55
    needless: float = 0.3
    needed: float = 0.1
    tie: float = 0.1
    tie_reach: float = 8.0
    search_move: float = 24.0
    search_step: float = 4.0
    search_turn: float = 0.35
    search_turns: int = 9
    glanced_at: int = later(4)
    looked_at: int = 200
    candidates: int = 6
    followed: int = 6
    sure: float = 0.3
    rounds: int = 12
    momentum: float = 0.6
    expect_move: float = 10.0
    expect_turn: float = 0.16
    expect_strain: tuple[float, float, float] = (0.1, 0.07, 0.07)
    most_strain: tuple[float, float, float] = (0.25, 0.15, 0.15)
    prior: float = 0.02
    bend: float = 0.1
    straight: float = 1.0
    lost: float = 0.4
    gone: float = 4.5
    clear: float = 2.0
    widened: float = 2.5
    apart_step: float = later(1.25)
    apart_turn: float = later(1.8)
    least_samples: int = later(30)
    around: int = later(24)
    taps: int = later(5)
    shutter: float = later(0.5)
    margin: float = later(20.0)
    recent: int = later(2)
    along: int = later(30)
    narrow: int = later(8)
    stretch: float = later(0.2)
    alike: float = later(0.4)
    places: int = later(4)
    glimpse: float = later(0.25)
    astray: float = later(1.5)
    turned: float = later(math.pi)
    pyramid: PyramidParams = later(PyramidParams())
    bones: BonesParams = later(BONES)
