"""Parameters of finding where an object went that moves fast."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class FastMotionParams:
    """Parameters of the flow of an object that moves fast (`motion.fast`). Lengths are pixels of a 480-line image.

    Attributes
    ----------
    window : around the object, in which it is looked for. factor : cells a pixel there.
    speed : of what moves fast. share : of the object that must, for it to be looked for where it went.
    margin : around the object within which its own flow is found. least : by which the flow of its surroundings must
        miss that place for it to be.
    square : side of the square over which the luma of two flows is compared.
    """

    window: float = 132.0
    factor: float = 0.25
    speed: float = 20.0
    share: float = 0.05
    margin: int = 24
    least: float = 4.0
    square: int = 9
