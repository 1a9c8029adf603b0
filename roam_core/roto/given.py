"""The shapes that a call of the library is given."""

from __future__ import annotations

from collections.abc import Iterable

from roam_core.arguments import shown
from roam_core.roto.shape import RotoShape


def shapes_of(shapes: RotoShape | Iterable[RotoShape]) -> tuple[RotoShape, ...]:
    """The shapes that a call of the library is given; one alone may be given as it is.

    Raises
    ------
    ValueError
        when one of them is no shape.
    """
    several = (shapes,) if isinstance(shapes, RotoShape) or not isinstance(shapes, Iterable) else tuple(shapes)
    for shape in several:
        if not isinstance(shape, RotoShape):
            raise ValueError(
                f"a shape is a RotoShape, as shapes_from_mask and load_project give them, not {shown(shape)}"
            )
    return several
