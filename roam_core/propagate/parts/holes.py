"""Holes of a whole object: those that show what lies behind it, and those that are cut out of its own surface.

The region of an object has a hole where its surroundings show through. Where an artist cuts out what looks as the
object does all around, a print or a part that gets a matte of its own, the region would close, and the hole with it.
Such a hole is carried by itself, as an occluder is (`propagate.parts.figure`): it goes by what lies in it.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from roam_core.appearance.global_model import GlobalModel
from roam_core.features import PreparedFrame
from roam_core.geometry import bezier
from roam_core.params import RegionParams, scale_for
from roam_core.propagate.frame.contour_fit import enclosed, spline_coverage
from roam_core.propagate.frame.covering import sure_sides
from roam_core.propagate.frame.result import Part
from roam_core.propagate.shapes.objects import Role, Unit
from roam_core.propagate.whole import posed
from roam_core.propagate.whole.interest import grid_around
from roam_core.proposal.cues.evidence import Field


def set_apart(
    made: Sequence[Unit], picture: PreparedFrame, parts: Sequence[Part], params: RegionParams
) -> tuple[Unit, ...]:
    """The units of an object, with holes that are cut out of the surface of a whole one as units of their own.

    `parts` are the outlines on the `picture` of the key. A hole too small to be known by its look stays one.
    """
    found = [each for unit in made for each in _divided(unit, picture, parts, params)]
    return tuple(sorted(found, key=lambda unit: unit.members[0]))


def _divided(unit: Unit, picture: PreparedFrame, parts: Sequence[Part], params: RegionParams) -> list[Unit]:
    own = set() if unit.role is not Role.WHOLE else _cut_out(unit.members, picture, parts, params)
    if not own:
        return [unit]
    rest = tuple(k for k in unit.members if k not in own)
    return [Unit(unit.role, rest), *(Unit(Role.OCCLUDER, (k,)) for k in own)]


def _cut_out(members: Sequence[int], picture: PreparedFrame, parts: Sequence[Part], params: RegionParams) -> set[int]:
    """Which of the `members` are holes in whose place the picture shows the object itself.

    There its colours are, in the mean, more those of the object around its holes than those of its surroundings, by
    `RegionParams.hole_own`.
    """
    pose, holes = params.part, [k for k in members if parts[k].subtracts]
    if pose is None or not holes:
        return set()
    outlines = [parts[k] for k in members]
    spots = np.vstack([part.points.reshape(-1, 2) for part in outlines])
    grid = grid_around(spots, picture.size, params, scale_for(picture.size))
    inside, _ = sure_sides(Field.of_coverage(grid, enclosed(outlines, grid)), ())
    filled = enclosed([part for part in outlines if not part.subtracts], grid)
    _, outside = sure_sides(Field.of_coverage(grid, filled), ())
    if not inside.any() or not outside.any():
        return set()
    colours = grid.colours_of(picture)
    ratio = GlobalModel.learned(colours, inside, outside).log_ratio(colours, params.clip, params.unseen)

    def is_cut_out(k: int) -> bool:
        there = (spline_coverage(parts[k].points, grid) > 0.5) & (filled > 0.5)
        if not there.any() or ratio[there].mean() <= params.hole_own:
            return False
        return posed.learned(picture, bezier.flatten(parts[k].points), pose, ()) is not None

    return {k for k in holes if is_cut_out(k)}
