"""Parameters of fitting artist keys to masks: no run of the engine reads them, so no configuration has them."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class PairingParams:
    """Parameters of which shape becomes which part of a mask (`proposal.mask_keys.pairing`).

    Attributes
    ----------
    strange : price of a part of the mask, or of a shape, that stays without a partner, half of it each.
    overlap, away, grown : price of a pair that does not overlap at all, lies its own size apart, or differs in size
        by a factor of e (as much again where the shape has outgrown its points by that factor).
    spots : places inside a shape that are looked up in the mask.
    stays : how much better the shapes have to lie on the mask before they count as moved together.
    inside : share of a shape without a partner that has to lie in another one's part before they divide it, if ...
    joined : ... this much of it overlaps the other, or ...
    considerable : ... it is at least this large beside it.
    cells : of a side in which it is looked up whether two overlap, at most.
    """

    strange: float = 1.3
    overlap: float = 0.6
    away: float = 0.5
    grown: float = 0.25
    spots: int = 400
    stays: float = 0.05
    inside: float = 0.5
    joined: float = 0.05
    considerable: float = 0.2
    cells: float = 8192.0


@dataclass(frozen=True)
class OutlineMatchParams:
    """Parameters of which place of one outline became which of another (`proposal.mask_keys.outline_match`).

    Attributes
    ----------
    spacing : pixels of a 480-line image between the nodes that are matched.
    step : pixels of a 480-line image between the samples of the outline.
    near : pixels of a 480-line image, a round of matching, by which a node may miss its expected place at a price
        of 1.
    reach : pixels of a 480-line image along the outline over which displacements are smoothed between two rounds of
        matching.
    stretch : price of a piece of outline that grows to twice its share of the whole.
    farthest : the most that distance costs: what is lost is lost.
    turn : price of a node whose outline runs the opposite way.
    bulge : price of a node that is all tip on a sample that is all bay (`proposal.outline.invariants`).
    starts : samples tried for the node that is surest of its place.
    doubt : price a node that says nothing for or against a pose.
    turned : A pose that turns by a right angle has to match better by this factor plus one: round shapes do not
        spin.
    fewest : nodes of a short outline.
    most : nodes of a long outline, and a third of its samples; it is looked at more coarsely.
    harmonics : points of an outline that is turned to find how it lies best on another.
    coarse : how much wider nodes and samples are spaced while poses are compared.
    settle : times that a pose is matched, each time the one that fits what was matched before.
    poses : poses tried that were found by turning.
    """

    spacing: float = 7.0
    step: float = 2.0
    near: tuple[float, float, float] = (24.0, 16.0, 8.0)
    reach: tuple[float, float] = (60.0, 25.0)
    stretch: float = 2.0
    farthest: float = 9.0
    turn: float = 1.5
    bulge: float = 12.0
    starts: int = 5
    doubt: float = 0.01
    turned: float = 4.0
    fewest: float = 16.0
    most: int = 2000
    harmonics: int = 128
    coarse: float = 3.0
    settle: int = 2
    poses: int = 3


@dataclass(frozen=True)
class AnchorParams:
    """Parameters of where on an outline the anchors lie best (`proposal.mask_keys.anchors`).

    Attributes
    ----------
    free : pixels of a 480-line image that an anchor may move for the price of ...
    prices : ... this much error, square pixels times pixels: the highest of these with which the curve follows well
        enough.
    most : it grows with the square, up to this many times.
    worse : how many times as large as with the lowest price the error may be, ...
    exact : ... or mean square pixels of a 480-line image that are no error: the outline of a mask is as coarse.
    looked_at : samples of a piece at which its error is measured, at most.
    hold : weight, against one sample, that draws handles to the straight line: a piece of few samples makes no loops.
    choices : samples by which an anchor may move along the outline in one round, either way.
    """

    free: float = 6.0
    prices: tuple[float, float, float, float, float] = (25.0, 5.0, 1.0, 0.2, 0.04)
    most: float = 20.0
    worse: float = 1.5
    exact: float = 0.1
    looked_at: int = 12
    hold: float = 0.02
    choices: tuple[int, ...] = (1, 2, 3, 4, 6, 8, 11, 15, 20, 27, 36)


@dataclass(frozen=True)
class KeyFitParams:
    """Parameters of fitting one shape to one outline (`proposal.mask_keys.key_fit`).

    Attributes
    ----------
    spreads : rounds in which anchors move along the outline.
    rounds : rounds of refinement: samples to their nearest place on the curve, curve to its samples.
    window : places to both sides in which a sample's nearest place is looked for.
    slide : weight, against one sample of the outline, that holds an anchor to its matched place along the outline.
    smooth : weight of a smooth point's handles leaving their common line.
    hold : weight of handles against those matched first. stay : weight of all points against those.
    astray : steps of the outline's samples by which an anchor may leave it.
    fine : places a segment at which a sample's nearest one is looked for.
    turn : price, in squared pixels, of a place whose outline runs at a right angle.
    straight : degrees by which the handles of a smooth point may miss their common line.
    """

    spreads: int = 6
    rounds: int = 8
    window: int = 20
    slide: float = 0.05
    smooth: float = 1.0
    hold: float = 0.002
    stay: float = 1e-6
    astray: float = 4.0
    fine: int = 12
    turn: float = 9.0
    straight: float = 12.0


PAIRING = PairingParams()
OUTLINE_MATCH = OutlineMatchParams()
ANCHORS = AnchorParams()
KEY_FIT = KeyFitParams()
