"""Parameters of the points that are followed from frame to frame inside an outline."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class KltParams:
    """Parameters of corners and of KLT on the reduced region (`motion.klt`). Lengths are pixels of it.

    Attributes
    ----------
    quality : share of the strongest corner's strength below which nothing is a corner.
    block : side of the square over which a corner's gradients are summed.
    apart : how far from each other corners lie, as a share of the side of the square that each has of the object.
    window : side of the square that is compared. levels : halvings of the picture besides itself.
    steps, still : steps of the search on a level, at most, and the step below which it ends.
    returned : how far from where it was a point may come to lie when it is followed there and back again.
    """

    quality: float = 0.003
    block: int = 5
    apart: float = 0.6
    window: int = 15
    levels: int = 3
    steps: int = 20
    still: float = 0.02
    returned: float = 0.5


KLT = KltParams()
