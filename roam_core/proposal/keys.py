"""Artist keys fitted to a mask: `keys_from_mask`, the door for a painted or rendered matte of one frame."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from roam_core.geometry import bezier, fit, similarity
from roam_core.geometry.simple import simplified
from roam_core.matte.vectorise import outlines
from roam_core.params import scale_for
from roam_core.proposal.key_fit import fitted
from roam_core.roto import BlendMode, Keyframe, RotoShape, edit
from roam_core.roto.project import PALETTE

Array = NDArray[np.float64]

OPEN = 1_000_000
"""Frame that stands for "always" at an open end of a lifetime."""
STRANGE = 1.0
"""Price of a part of the mask, or of a shape, that stays without a partner."""


def keys_from_mask(shapes: Sequence[RotoShape], mask: NDArray[Any], frame: int) -> list[RotoShape]:
    """Each shape with an artist key on `frame`, fitted to a mask: the same points, in correspondence with its keys.

    Parts of the mask and shapes are paired, and so are holes and shapes that subtract. A part without a partner begins
    on `frame` as a new shape, above the others (a hole above the shape that it is cut out of); a shape without one ends
    before `frame`. Nothing of the artist's is deleted. Shapes that are open, that do not exist on `frame` or that join
    in another way than by adding or subtracting are left as they are.

    Parameters
    ----------
    shapes : in the order of compositing.
    mask : (h, w) or (h, w, c); bool, integer or float; white inside.
    frame : the plate's frame number. A key that is there is replaced; an ENGINE key serves as the expectation.

    Returns
    -------
    All shapes, in their order.
    """
    scale = scale_for(mask.shape[:2])
    result = list(shapes)
    parts = _parts(mask)
    for holes in (False, True):
        members = [shape for shape in shapes if _takes_part(shape, frame) and _subtracts(shape) == holes]
        wanted = [part for part in parts if part.is_hole == holes]
        expected = [shape.at(frame).points for shape in members]
        poses = _poses(expected, [part.ring for part in wanted])
        pairs = _assigned([similarity.apply(poses[0], points) for points in expected], wanted)
        for number, shape in enumerate(members):
            part = pairs.get(number)
            place = next(k for k, each in enumerate(result) if each.id == shape.id)
            if part is None:
                result[place] = _ended(shape, frame)
                continue
            own = [*poses, *_poses([expected[number]], [part.ring]), similarity.IDENTITY]
            points = fitted(expected[number], part.ring, own, scale)
            result[place] = edit.set_key(shape, frame, points)
            part.owner = shape.id
        for new in (part for part in wanted if part.owner == ""):
            _begin(result, new, frame)
    return result


@dataclass(eq=False)
class _Part:
    """An outer contour of the mask, or a hole of `parent`; `owner` is the id of the shape that it became."""

    ring: Array
    parent: _Part | None = None
    owner: str = ""

    @property
    def is_hole(self) -> bool:
        return self.parent is not None


def _parts(mask: NDArray[Any]) -> list[_Part]:
    parts = []
    for outer, *holes in outlines(mask):
        parent = _Part(outer)
        parts.extend([parent, *(_Part(hole, parent) for hole in holes)])
    return parts


def _subtracts(shape: RotoShape) -> bool:
    return shape.blend is BlendMode.SUBTRACT


def _takes_part(shape: RotoShape, frame: int) -> bool:
    joins = shape.blend in (BlendMode.ADD, BlendMode.MAX, BlendMode.SUBTRACT)
    return joins and shape.closed and shape.point_count >= 2 and shape.visible and shape.exists_at(frame)


def _centre(rings: list[Array]) -> tuple[Array, float]:
    """The centroid `(2,)` of all rings together, and their area."""
    area, moment = 0.0, np.zeros(2)
    for ring in rings:
        (x, y), (to_x, to_y) = ring.T, np.roll(ring, -1, axis=0).T
        cross = x * to_y - to_x * y
        side = float(np.sign(cross.sum()))
        area += 0.5 * side * float(cross.sum())
        moment += side * np.array([float(((x + to_x) * cross).sum()), float(((y + to_y) * cross).sum())]) / 6.0
    return moment / max(area, 1e-9), area


def _poses(splines: list[Array], rings: list[Array]) -> list[Array]:
    """Similarities `(2, 3)` that may carry the splines to the rings: by their centres, and by centres and areas."""
    if not splines or not rings:
        return [similarity.IDENTITY]
    here, area = _centre([bezier.flatten(points) for points in splines])
    there, wanted = _centre(rings)
    grown = float(np.sqrt(wanted / max(area, 1e-9)))
    return [np.column_stack([factor * np.eye(2), there - factor * here]) for factor in (1.0, grown)]


def _assigned(expected: list[Array], parts: list[_Part]) -> dict[int, _Part]:
    """Which part each spline takes."""
    n, m = len(expected), len(parts)
    if not n or not m:
        return {}
    cost = np.full((n + m, n + m), STRANGE)
    centres = [_centre([part.ring]) for part in parts]
    for i, points in enumerate(expected):
        here, area = _centre([bezier.flatten(points)])
        for j, (there, wanted) in enumerate(centres):
            away = float(np.hypot(*(here - there))) / np.sqrt(area + wanted)
            cost[i, j] = 0.7 * away + 0.3 * abs(np.log(max(area, 1e-9) / wanted))
    cost[n:, m:] = 0.0
    rows, columns = linear_sum_assignment(cost)
    return {int(i): parts[j] for i, j in zip(rows, columns, strict=True) if i < n and j < m}


def _ended(shape: RotoShape, frame: int) -> RotoShape:
    start = -OPEN if shape.lifetime is None else shape.lifetime[0]
    return replace(shape, lifetime=(start, frame))


def _begin(result: list[RotoShape], part: _Part, frame: int) -> None:
    """Add a shape for a part of the mask that has none."""
    taken = {shape.id for shape in result}
    number = next(n for n in range(len(result) + 1, 2 * len(result) + 2) if f"shape-{n}" not in taken)
    points = fit.fit_closed(part.ring)
    part.owner = f"shape-{number}"
    shape = RotoShape(
        id=part.owner,
        name=f"Shape {number} hole" if part.is_hole else f"Shape {number}",
        keys=(Keyframe(frame, simplified(points, points)),),
        colour=PALETTE[len(result) % len(PALETTE)],
        blend=BlendMode.SUBTRACT if part.is_hole else BlendMode.ADD,
        lifetime=(frame, OPEN),
    )
    place = len(result)
    if part.parent is not None:
        place = next(k for k, each in enumerate(result) if each.id == part.parent.owner) + 1
    result.insert(place, shape)
