"""Parameters of the patches of a key that are followed one by one."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class PatchParams:
    """Parameters of a key's patches (`motion.patches`). Lengths are pixels of a 480-line image, differences of colour
    those of 8-bit RGB.

    Attributes
    ----------
    spacing : between the centres of neighbouring patches; more where there would be more than `most`.
    reach : radius of a patch, and how far it speaks of what lies around it, in spacings.
    inner : how deep the centre of a patch may lie, in radii: what lies deeper says nothing of the outline.
    places : of a patch at which colours are compared. least : share of a square of one spacing that must be inside.
    rim : distance from the outline under which nothing is learned: the edge is mixed with what lies behind.
    coarse, fine : blur (sigma) of the pictures that are compared first and last.
    rounds : of Gauss and Newton, at most, on each.
    like_least, like_most : bounds on the difference of colour beyond which a place says less and less: twice the
        median.
    like : the same where places are compared, and patches rated.
    shift : by which a patch may have become brighter or darker.
    move, strain : how far a patch may lie from where those around it expect it, and its linear part.
    independent : share of the places that tell something new.
    step, step_strain : by which one round changes place and linear part at most: from farther away slopes tell nothing.
    own : how much a patch itself is heard beside its neighbours, each at most once. beyond : what a place outside the
        picture costs, in [0, 1].
    parted : distance from where a neighbour expects a patch at which that neighbour is heard half.
    asked : one of so many places of a patch is asked where the flow takes it, and whether it lies on the object.
    neighbours : that are heard.
    believed : how well a patch must match to say anything. open_by : what its texture may leave open of its place where
        it is believed half.
    alike : difference of colour at which a cell is half taken for the one of the key. ramp : distance from the outline
        from which a patch is as sure of a side as it can be.
    """

    spacing: float = 16.0
    reach: float = 1.35
    most: int = 100
    inner: float = 0.7
    places: int = 64
    least: float = 0.12
    rim: float = 1.5
    coarse: float = 2.0
    fine: float = 0.7
    rounds: int = 5
    like_least: float = 5.0
    like_most: float = 15.0
    like: float = 14.0
    shift: float = 15.0
    move: float = 4.0
    strain: float = 0.15
    independent: float = 0.22
    parted: float = 4.0
    step: float = 4.0
    step_strain: float = 0.25
    own: float = 0.3
    beyond: float = 0.6
    asked: int = 4
    neighbours: int = 8
    believed: float = 0.5
    open_by: float = 0.7
    alike: float = 8.0
    ramp: float = 3.0
