"""Parameters of which shapes are one object."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class ObjectParams:
    """Parameters of which shapes are solved together (`propagate.shapes.objects`). No configuration changes them: a
    project's shapes are one object whichever engine is asked.

    Attributes
    ----------
    near : pixels of a 480-line image between outlines of one compound that still belong to one object, and around
        what a subtracting shape may come to cut.
    enclosed : share of a subtracting shape that lies within an outline whose hole it is.
    overlap : share of the smaller of two shapes that both enclose, from which they overlap rather than touch.
    touch : pixels of a 480-line image, along a side of the smaller one, that outlines share when fitted to one
        edge.
    abut : pixels of a 480-line image up to which a border runs along another one.
    along : share of the shorter of two outlines that runs along the other one where they abut.
    cells : cells across the smaller of two shapes when they are compared.
    """

    near: float = 20.0
    enclosed: float = 0.97
    overlap: float = 0.02
    touch: float = 1.0
    abut: float = 2.0
    along: float = 0.06
    cells: int = 48


OBJECTS = ObjectParams()
