"""Which engine an object gets."""

from __future__ import annotations

from collections.abc import Sequence

from roam_core.features import PreparedFrame
from roam_core.params import RoamParams
from roam_core.propagate.engines.by_curves import CurveEngine
from roam_core.propagate.engines.by_parts import PartsEngine
from roam_core.propagate.engines.by_regions import RegionEngine
from roam_core.propagate.engines.protocol import Engine
from roam_core.propagate.frame.result import Part
from roam_core.propagate.parts.holes import set_apart
from roam_core.propagate.shapes.objects import Role, Unit


def begin(
    picture: PreparedFrame, parts: tuple[Part, ...], params: RoamParams, made: Sequence[Unit], order: Sequence[int]
) -> Engine:
    """An object on a frame whose outlines are given.

    `made` tells what they are in their object (`objects.units`), but for holes that the picture shows to be cut out of
    the object itself; `order` their indices as they are stacked on the frame, the farthest first.
    """
    if params.region is None:
        return CurveEngine.begun(picture, parts, params)
    if params.region.part is None:
        return RegionEngine.begun(picture, parts, params)
    made = set_apart(made, picture, parts, params.region)
    if len(made) == 1 and made[0].role is Role.WHOLE:
        return RegionEngine.begun(picture, parts, params)
    return PartsEngine.begun(picture, parts, params, made, order)
