"""Artist keys fitted to a mask: `keys_from_mask`, the door for a painted or rendered matte of one frame."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from numpy.typing import NDArray

from roam_core.arguments import frame_number, pixels_of
from roam_core.arrays import Array
from roam_core.geometry import bezier
from roam_core.matte.vectorise import compound_of, outlines, require_image, spline_around, tolerance_for
from roam_core.params import scale_for
from roam_core.proposal.mask_keys.key_fit import fitted
from roam_core.proposal.mask_keys.pairing import covered, paired, poses
from roam_core.roto import BlendMode, Keyframe, RotoShape, edit
from roam_core.roto.control_points import settled
from roam_core.roto.given import shapes_of
from roam_core.roto.lifetimes import lifetime_of
from roam_core.roto.project import PALETTE
from roam_core.roto.sight import is_shut, opened


def keys_from_mask(shapes: Sequence[RotoShape], mask: NDArray[Any], frame: int) -> list[RotoShape]:
    """Each shape with an artist key on `frame`, fitted to a mask: the same points, in correspondence with its keys.

    Every shape is expected where `RotoShape.at` puts it: between its keys, or on the nearest one, or on an ENGINE key
    of that frame. One that an engine closed there, as it was out of sight, is expected as on the artist's nearest key,
    and takes a part of its own or ends. Outer contours of the mask are paired with shapes that add, holes with shapes
    that subtract (`proposal.mask_keys.pairing`); shapes that overlapped, or that are of like size, divide a part into
    which they have grown together. A part without a partner begins on `frame` as a new shape, above the others (a hole
    just above the shapes that it is cut out of). It is of the compound of the shapes that take part where they share
    one, else of the mask's, and so is then a lone outline beside which it begins. A shape without a part ends before
    `frame`, or is gone where it began there; one with keys after `frame` too goes on behind it as a twin with those
    keys. A hole that another shape of its part now covers ends too, and a new one begins above; so may a shape that was
    a speck and has too few points for what it would become. No key of the artist's on another frame is changed or
    deleted.

    Shapes that are open or invisible, do not exist on `frame`, or join by INTERSECT or DIFFERENCE take no part. Locked
    ones keep their part of the mask and stay as they are.

    Parameters
    ----------
    shapes : in the order of compositing.
    mask : (h, w) or (h, w, c); bool, integer or float; white inside. A grey antialiased edge is met at half intensity.
    frame : the plate's frame number. A key that is there is replaced.

    Returns
    -------
    All shapes, in their order, with those that begin, each under its own id, also where two of them have the same. The
    ids of new shapes are free among `shapes`.

    Raises
    ------
    ValueError
        when an argument is not what it should be.
    RoamError
        when the mask has no pixels or is no image.
    """
    mask, shapes, frame = pixels_of(mask), shapes_of(shapes), frame_number(frame)
    require_image(mask)
    own = _apart(shapes)
    shapes = [shape if own[name] == name else replace(shape, id=name) for shape, name in zip(shapes, own, strict=True)]
    result = list(shapes)
    parts = _parts(mask)
    pose = None
    taking_part = [shape for shape in shapes if _takes_part(shape, frame)]
    compound = _shared_compound(taking_part) or compound_of(mask, frame)
    for holes in (False, True):
        members = [shape for shape in taking_part if _subtracts(shape) == holes]
        wanted = [part for part in parts if part.is_hole == holes]
        pose = _keyed(result, members, wanted, mask.shape[:2], frame, pose)
        for new in (part for part in wanted if not part.owners):
            _begin(result, new, mask.shape[:2], frame, compound)
            if len(taking_part) == 1 and any(shape.id == taking_part[0].id for shape in result):
                place = _place(result, taking_part[0].id)
                result[place] = replace(result[place], compound=compound)
    return [shape if own.get(shape.id, shape.id) == shape.id else replace(shape, id=own[shape.id]) for shape in result]


def _apart(shapes: Sequence[RotoShape]) -> dict[str, str]:
    """The ids of the shapes, in their order, by names of which no two are alike: masks made apart give equal ids."""
    own, ids = dict[str, str](), {shape.id for shape in shapes}
    for shape in shapes:
        own[shape.id if shape.id not in own else _free_id(ids | own.keys())] = shape.id
    return own


def _shared_compound(shapes: Sequence[RotoShape]) -> str:
    """The compound that all shapes are of; "" where they are of several, or one is of none."""
    names = {shape.compound for shape in shapes}
    return names.pop() if len(names) == 1 else ""


@dataclass(eq=False)
class _Part:
    """An outer contour of the mask, or a hole of `parent`; `owners` are the ids of the shapes that it became."""

    ring: Array
    parent: _Part | None = None
    owners: tuple[str, ...] = ()

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


def _keyed(
    result: list[RotoShape],
    members: list[RotoShape],
    parts: list[_Part],
    size: tuple[int, int],
    frame: int,
    common: Array | None,
) -> Array | None:
    """Key or end `members` in `result`; by which similarity all of them moved, None where there was none to see."""
    expected, hidden = [shape.at(frame).points for shape in members], set[int]()
    for number, shape in enumerate(members):
        drawn = _drawn(shape, frame)
        if drawn is not None and is_shut(expected[number], drawn):
            expected[number] = opened(expected[number], drawn)
            hidden.add(number)
    smallest = [min(bezier.area(key.points) for key in shape.artist_keys or shape.keys) for shape in members]
    pairing = paired(expected, [part.ring for part in parts], size, common, hidden, smallest)
    for number, owners in pairing.sharing.items():
        if any(_is_covered(result, members[i], parts[number], frame) for i in owners):
            for i in owners:
                pairing.rings[i] = None
        else:
            parts[number].owners = tuple(members[i].id for i in owners)
    for shape, points, ring in zip(members, expected, pairing.rings, strict=True):
        if shape.locked:
            continue
        place = _place(result, shape.id)
        if ring is None:
            result[place : place + 1] = _ended(shape, frame, {each.id for each in result})
        else:
            fresh = fitted(points, ring, [pairing.pose, *poses([points], [ring])], scale_for(size))
            result[place] = edit.set_key(shape, frame, settled(fresh, shape))
    return pairing.pose if pairing.owners else None


def _is_covered(result: list[RotoShape], shape: RotoShape, part: _Part, frame: int) -> bool:
    """Whether most of a hole of the mask is covered by a shape of its parent that lies above the hole's shape."""
    if part.parent is None or shape.locked:
        return False
    above = result[_place(result, shape.id) + 1 :]
    coverers = (each.at(frame).points for each in above if each.id in part.parent.owners)
    return any(covered(part.ring, points) > 0.5 for points in coverers)


def _drawn(shape: RotoShape, frame: int) -> Array | None:
    """The artist's key `(P, 3, 2)` that is nearest to a frame; None of a shape without any."""
    keys = shape.artist_keys
    return min(keys, key=lambda key: abs(key.frame - frame)).points if keys else None


def _place(shapes: list[RotoShape], shape_id: str) -> int:
    return next(k for k, shape in enumerate(shapes) if shape.id == shape_id)


def _ended(shape: RotoShape, frame: int, taken: set[str]) -> list[RotoShape]:
    """The shape without `frame` in its lifetime: it ends before, begins after, or is two, one for each side.

    One that began on `frame` and has no other key is none any more.
    """
    start, stop = shape.lifetime or (None, None)
    goes_on = stop is None or stop > frame + 1
    after = tuple(key for key in shape.keys if key.frame > frame) if goes_on else ()
    if start is not None and start >= frame:
        if after:
            return [replace(shape, lifetime=lifetime_of(frame + 1, stop))]
        if shape.frames == (frame,):
            return []
    if not after:
        return [replace(shape, lifetime=lifetime_of(start, frame))]
    if len(after) == len(shape.keys):
        return [replace(shape, lifetime=lifetime_of(frame + 1, stop))]
    twin = replace(shape, id=_free_id(taken), keys=after, lifetime=lifetime_of(frame + 1, stop))
    return [replace(shape, lifetime=lifetime_of(start, frame)), twin]


def _begin(result: list[RotoShape], part: _Part, size: tuple[int, int], frame: int, compound: str) -> None:
    """Add a shape for a part of a mask of `size` (h, w) that has none, as `shapes_from_mask` makes it."""
    new_id = _free_id({shape.id for shape in result})
    number = new_id.rpartition("-")[2]
    shape = RotoShape(
        id=new_id,
        name=f"Shape {number} hole" if part.is_hole else f"Shape {number}",
        keys=(Keyframe(frame, spline_around(part.ring, tolerance_for(size))),),
        colour=PALETTE[len(result) % len(PALETTE)],
        blend=BlendMode.SUBTRACT if part.is_hole else BlendMode.ADD,
        lifetime=lifetime_of(frame, None),
        compound=compound,
    )
    below = part.parent.owners if part.parent is not None else ()
    result.insert(max((_place(result, owner) + 1 for owner in below), default=len(result)), shape)
    part.owners = (new_id,)


def _free_id(taken: set[str]) -> str:
    return next(name for n in range(len(taken) + 1, 2 * len(taken) + 2) if (name := f"shape-{n}") not in taken)
