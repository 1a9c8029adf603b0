"""The curves of an object fitted to its region, points in correspondence; what finds no place of its own closes."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import cv2
import numpy as np

from roam_core.arrays import Array, Bools, Float32
from roam_core.features.grid import Grid
from roam_core.geometry import bezier, polyline
from roam_core.geometry.simple import simplified
from roam_core.kernels.coverage import coverage
from roam_core.params import RegionParams
from roam_core.propagate.frame.result import Part
from roam_core.proposal.cues.evidence import Field
from roam_core.proposal.outline.contour import KeyConstraints, follow
from roam_core.proposal.segment.components import ring_around, shares


def spline_coverage(points: Array, grid: Grid) -> Float32:
    """The share of each cell `(rows, columns)` that a closed spline `(P, 3, 2)` covers."""
    return coverage(grid.to_grid(bezier.flatten(points)), grid.shape)


def enclosed(parts: Sequence[Part], grid: Grid) -> Float32:
    """The share of each cell `(rows, columns)` that the outlines enclose together: holes cut what comes before them."""
    share = np.zeros(grid.shape, dtype=np.float32)
    for part in parts:
        cover = spline_coverage(part.points, grid)
        share = share * (1.0 - cover) if part.subtracts else np.maximum(share, cover)
    return share


def enclosed_by_any(objects: Iterable[Sequence[Part]], grid: Grid) -> Float32:
    """The share of each cell that any of several objects encloses, each given by its outlines."""
    inside = np.zeros(grid.shape, np.float32)
    for parts in objects:
        inside = np.maximum(inside, enclosed(parts, grid))
    return inside


def fitted(
    parts: Sequence[Part],
    constraints: Sequence[KeyConstraints],
    found: Field,
    scale: float,
    params: RegionParams,
    expected: Sequence[Array] | None = None,
    likely: Bools | None = None,
) -> list[tuple[Array, bool]]:
    """Each shape's points `(P, 3, 2)` along the outline that it claims, and whether it found one.

    `parts` lie where they were carried, and do not cross themselves: where no shape claims the region all stay there.
    `expected` tells where along the outline their points should come to lie, if not just there; `constraints` are what
    they keep of their key. Components of the region are joined by bridges, and bays that closed are opened by slits, up
    to `RegionParams.longest_bridge`, or, at 0, not at all; `likely` is where components belong to the object that no
    shape claims, everywhere if it is None. A shape that finds nothing while others do, and lies mostly outside the
    region, is out of sight and closes to almost nothing, as does a hole that the region fills. Where there is no region
    the whole object is out of sight, and closes.
    """
    inside = found.inside
    if not inside.any():
        return [(_shut(part.points, params.closed), False) for part in parts]
    hanging = likely if likely is not None else np.ones_like(inside)
    solid = [k for k, part in enumerate(parts) if not part.subtracts]
    holes = [k for k, part in enumerate(parts) if part.subtracts]
    wanted = [part.points for part in parts] if expected is None else expected
    placed: list[tuple[Array, bool]] = [(part.points, False) for part in parts]
    covers = [spline_coverage(part.points, found.grid) for part in parts]
    for members, field in ((solid, found), (holes, Field(found.grid, -found.values))):
        if not members:
            continue
        area = inside if field is found else _enclosed(~inside)
        strays = hanging if field is found and params.longest_bridge > 0 else np.zeros_like(inside)
        for k, mine in zip(members, shares(area, [covers[k] for k in members], strays, params.components), strict=True):
            ring = ring_around(field, mine, covers[k], params.longest_bridge, params.components)
            if ring is not None:
                points = follow(wanted[k], ring, constraints[k], scale)
                placed[k] = simplified(points, parts[k].points, scale, params.contour_fit.untying), True
    is_in_sight = any(placed[k][1] for k in solid)
    for k, (points, seen) in enumerate(placed):
        if seen:
            continue
        within, outside = float(covers[k][inside].sum()), float(covers[k][~inside].sum())
        is_out_of_place = within > 0 if parts[k].subtracts else is_in_sight and within <= outside
        if is_out_of_place:
            placed[k] = _shut(points, params.closed), False
    return placed


def _shut(points: Array, radius: float) -> Array:
    """The spline `(P, 3, 2)` closed to a point in its place: a polygon that cannot cross itself, in the same sense."""
    sense = np.copysign(2.0 * np.pi / len(points), polyline.signed_area(bezier.flatten(points)))
    turns = sense * np.arange(len(points))
    middle = points[:, bezier.ANCHOR].mean(axis=0)
    return bezier.polygon_points(middle + radius * np.stack([np.cos(turns), np.sin(turns)], axis=1))


def _enclosed(outside: Bools) -> Bools:
    """The parts of the outside that do not reach the border of the grid: holes."""
    _, labels = cv2.connectedComponents(outside.astype(np.uint8), connectivity=4)
    border = np.unique(np.concatenate([labels[0], labels[-1], labels[:, 0], labels[:, -1]]))
    return np.asarray(outside & ~np.isin(labels, border))


def trusts_of(drawn: Sequence[Part], seen: Sequence[bool], confidence: float) -> list[float]:
    """How far each shape is trusted, where the object is trusted as far as `confidence`.

    A hole that closed is no reason to doubt. A shape out of sight is one by the share of the object, as it was `drawn`,
    that would be missing if it should be there.
    """
    solid = np.array([not part.subtracts for part in drawn])
    out = solid & ~np.array(seen)
    if not out.any():
        return [confidence] * len(out)
    areas = solid * [part.area for part in drawn]
    missing = out * (areas / max(float(areas.sum()), 1e-9)) if (solid & ~out).any() else out
    return [confidence * (1.0 - float(share)) for share in missing]
