"""The edit verbs: pure functions from a value to a new one. Every change of a project, by hand or by engine, is one."""

from __future__ import annotations

import bisect
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import fields, replace
from itertools import count
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from roam_core.arrays import Array, Bools
from roam_core.errors import RoamError
from roam_core.geometry import bezier, bspline, merging
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.roto import control_points as controls
from roam_core.roto.animated import Interpolation
from roam_core.roto.keyframe import Keyframe, Origin
from roam_core.roto.linking import fresh_compounds, fresh_links
from roam_core.roto.plain_fields import plain
from roam_core.roto.project import Layer, Project
from roam_core.roto.shape import NO_COLOUR, Outline, RotoShape, Spline
from roam_core.translatable import sentence

Part = tuple[int, int]
"""A grabbed part of a shape: (point index, `ANCHOR` | `IN` | `OUT`)."""

MIN_POINTS_CLOSED = 3
MIN_POINTS_OPEN = 2


# ---- shapes and layers of a project ----------------------------------------------------------------------------------


def add_shape(project: Project, shape: RotoShape, layer_id: str = "root") -> Project:
    """The project with `shape`, in plate space, put on top of a layer; without a colour it takes the next in turn.

    An id that is taken is refused; shapes of several masks, whose ids are the same, come in by `add_items`.
    """
    if project.has(shape.id):
        raise ValueError(f"the id {shape.id!r} is taken; edit.add_items gives shapes ids that are free")
    stored = project.stored(_coloured(project, shape), layer_id)
    return project.map_item(layer_id, lambda layer: replace(layer, children=(*layer.children, stored)))


def new_shape(
    project: Project,
    control_points: ArrayLike,
    frame: int,
    *,
    name: str = "",
    closed: bool = True,
    layer_id: str = "root",
    spline: Spline = Spline.BEZIER,
) -> tuple[Project, RotoShape]:
    """Add a shape with one artist key at `frame`; its id, name and colour are the next free ones.

    `control_points (P, 3, 2)` are its points, or the control points of a B-spline (`roam_core.roto.control_points`).
    """
    shape = RotoShape(
        id=project.free_id("shape"),
        name=name or project.free_name("Shape"),
        keys=(Keyframe(frame, controls.points_of(control_points, spline, closed)),),
        closed=closed,
        spline=spline,
        colour=project.free_colour(),
    )
    return add_shape(project, shape, layer_id), shape


def add_layer(project: Project, name: str = "", parent_id: str = "root") -> tuple[Project, Layer]:
    """Add an empty layer on top of another."""
    layer = Layer(project.free_id("layer"), name or project.free_name("Layer"))
    return project.map_item(parent_id, lambda parent: replace(parent, children=(*parent.children, layer))), layer


def add_items(
    project: Project, items: Iterable[Layer | RotoShape], layer_id: str = "root"
) -> tuple[Project, list[str]]:
    """Put copies of layers, with what lies in them, and of shapes in plate space on top of a layer.

    Returns the project and the ids of the copies (not of what lies in them). Ids, links and compounds that are taken
    are replaced by free ones; names stay, and colours where there are any.
    """
    items = tuple(items)
    joining = [shape for item in items for shape in _shapes_of(item)]
    links, compounds = fresh_links(project, joining), fresh_compounds(project, joining)
    taken = {project.root.id} | {item.id for item in project.root.items()}
    numbers = {kind: count(1) for kind in ("layer", "shape")}
    added = count()

    def copied(item: Layer | RotoShape) -> Layer | RotoShape:
        kind = "layer" if isinstance(item, Layer) else "shape"
        item_id = item.id
        while item_id in taken:
            item_id = f"{kind}-{next(numbers[kind])}"
        taken.add(item_id)
        if isinstance(item, Layer):
            return replace(item, id=item_id, children=tuple(copied(child) for child in item.children))
        link, compound = links.get(item.link, item.link), compounds.get(item.compound, item.compound)
        return replace(_coloured(project, item, next(added)), id=item_id, link=link, compound=compound)

    copies = tuple(copy if isinstance(copy, Layer) else project.stored(copy, layer_id) for copy in map(copied, items))
    grown = project.map_item(layer_id, lambda layer: replace(layer, children=(*layer.children, *copies)))
    return grown, [item.id for item in copies]


def _shapes_of(item: Layer | RotoShape) -> Iterable[RotoShape]:
    """A shape, or those in a layer and in its layers."""
    return item.shapes() if isinstance(item, Layer) else (item,)


def _coloured(project: Project, shape: RotoShape, after: int = 0) -> RotoShape:
    """The shape with a colour: its own, or the one in turn in a project to which `after` shapes more were added."""
    return replace(shape, colour=project.free_colour(after)) if shape.colour == NO_COLOUR else shape


def remove_items(project: Project, item_ids: Iterable[str]) -> Project:
    """The project without these layers and shapes (and what lies in them)."""
    gone = set(item_ids)

    def pruned(layer: Layer) -> Layer:
        kept = (child for child in layer.children if child.id not in gone)
        return replace(layer, children=tuple(pruned(c) if isinstance(c, Layer) else c for c in kept))

    return replace(project, root=pruned(project.root))


def set_properties(project: Project, item_id: str, **values: Any) -> Project:
    """Change plain fields of a layer or shape: name, colour, visible, locked, opacity, blend, feather, ...

    Raises
    ------
    KeyError
        when no layer or shape has this id.
    ValueError
        when it has no such field, or the field cannot have that value.
    """
    item = project.find(item_id)
    known = [field.name for field in fields(item)]
    if wrong := [name for name in values if name not in known]:
        kind = "layer" if isinstance(item, Layer) else "shape"
        raise ValueError(f"a {kind} has no {wrong[0]!r}; it has: {', '.join(known)}")
    held = {name: plain(name, value, item.name) for name, value in values.items()}
    renamed = held.get("id", item_id)
    if renamed != item_id and (renamed == project.root.id or project.has(renamed)):
        raise ValueError(f"the id {renamed!r} is taken")
    return project.map_item(item_id, lambda item: replace(item, **held))


# ---- keys of a shape -------------------------------------------------------------------------------------------------


def set_key(shape: RotoShape, frame: int, points: ArrayLike, feather: ArrayLike | None = None) -> RotoShape:
    """The shape with an artist key at `frame`; what a key there held beside its points (interpolation) is kept."""
    old = shape.key_at(frame)
    key = Keyframe(
        frame=frame,
        points=np.asarray(points, dtype=np.float64),
        feather=np.asarray(feather, dtype=np.float64) if feather is not None else shape.at(frame).feather,
        interpolation=old.interpolation if old else Interpolation.LINEAR,
        extra=old.extra if old else {},
    )
    return shape.with_key(key)


def set_control_points(shape: RotoShape, frame: int, control_points: ArrayLike) -> RotoShape:
    """The shape with an artist key at `frame` whose `control_points (P, 3, 2)` (`Outline.control_points`) lie there."""
    points = controls.points_of(control_points, shape.spline, shape.closed)
    return _held_on(shape, frame, set_key(shape, frame, points))


def key_points(shape: RotoShape, frame: int, indices: Iterable[int]) -> RotoShape:
    """Make these points of the shape, as they are at `frame`, the artist's there, beside those that are already.

    The others stay what a run may derive anew. On a key whose points are all the artist's nothing changes; one whose
    last points become the artist's is such a key.
    """
    key = shape.key_at(frame)
    is_drawn = key is not None and key.origin is Origin.ARTIST
    if is_drawn and key is not None and not key.set_points:
        return shape
    before = key.set_points if is_drawn and key is not None else ()
    chosen = tuple(sorted({*before, *indices}))
    if not chosen:
        return shape
    keyed = shape if is_drawn else key_here(shape, frame)
    own = keyed.key_at(frame)
    assert own is not None
    return keyed.with_key(replace(own, set_points=() if len(chosen) == shape.point_count else chosen))


def key_here(shape: RotoShape, frame: int) -> RotoShape:
    """Make the shape as it is at `frame` an artist key."""
    return _held_on(shape, frame, set_key(shape, frame, shape.at(frame).points))


def _held_on(shape: RotoShape, frame: int, keyed: RotoShape) -> RotoShape:
    """The shape `keyed` at `frame`; a key that is new in a span that was held holds on, as the one before it."""
    before = [key for key in shape.keys if key.frame < frame][-1:]
    if shape.key_at(frame) is not None or not before or before[0].interpolation is not Interpolation.HOLD:
        return keyed
    return set_interpolation(keyed, [frame], Interpolation.HOLD)


def set_engine_keys(shape: RotoShape, keys: Iterable[Keyframe]) -> RotoShape:
    """Put the engine's keys on their frames. A frame that holds an artist key keeps it untouched.

    Of a key that the artist set some points of, those stay, and the others become the engine's: the key stays the
    artist's. On a B-spline shape each key becomes the nearest B-spline, so that its control points stay the artist's to
    drag.
    """
    drawn = {key.frame: key for key in shape.artist_keys}
    made = [key for key in keys if key.frame not in drawn or drawn[key.frame].set_points]
    if any(key.origin is not Origin.ENGINE and key.frame not in drawn for key in made):
        raise ValueError("set_engine_keys was given a key that the engine did not make")
    if shape.spline is Spline.BSPLINE:
        made = [replace(key, points=controls.settled(key.points, shape)) for key in made]
    return shape.with_keys(_around_set_points(shape, drawn[k.frame], k) if k.frame in drawn else k for k in made)


def _around_set_points(shape: RotoShape, drawn: Keyframe, made: Keyframe) -> Keyframe:
    """The artist's key with the points that the artist did not set as the engine made them."""
    held, solved = (Outline(key.points, None, shape.closed, shape.spline).control_points for key in (drawn, made))
    joined, chosen = solved.copy(), list(drawn.set_points)
    joined[chosen] = held[chosen]
    return replace(drawn, points=controls.points_of(joined, shape.spline, shape.closed))


def delete_keys(shape: RotoShape, frames: Iterable[int]) -> RotoShape:
    """The shape without its keys on these frames; the last key of all cannot be deleted."""
    gone = set(frames)
    kept = tuple(key for key in shape.keys if key.frame not in gone)
    if not kept:
        raise RoamError(sentence("{name!r} needs at least one key; delete the shape instead.", name=shape.name))
    return replace(shape, keys=kept)


def delete_engine_keys(shape: RotoShape, frames: range | None = None) -> RotoShape:
    """The shape without the engine's keys (in a range); the artist's stay, and if there is none nothing changes."""
    if not shape.artist_frames:
        return shape
    gone = [k.frame for k in shape.keys if k.origin is Origin.ENGINE and (frames is None or k.frame in frames)]
    return delete_keys(shape, gone)


def move_keys(shape: RotoShape, frames: Iterable[int], offset: int) -> RotoShape:
    """Shift keys in time; a key that lay where one arrives gives way to it."""
    return retime_keys(shape, {frame: frame + offset for frame in frames})


def retime_keys(shape: RotoShape, goes: Mapping[int, int]) -> RotoShape:
    """Put keys on other frames, told by theirs; a key that lay where one arrives gives way to it."""
    moved = [replace(key, frame=goes[key.frame]) for key in shape.keys if key.frame in goes]
    rest = {key.frame: key for key in shape.keys if key.frame not in goes}
    return replace(shape, keys=tuple((rest | {key.frame: key for key in moved}).values()))


def set_interpolation(shape: RotoShape, frames: Iterable[int], interpolation: Interpolation) -> RotoShape:
    """Set how the shape moves on from its keys at `frames`."""
    chosen = set(frames)
    return shape.with_keys(replace(k, interpolation=interpolation) for k in shape.keys if k.frame in chosen)


def toggle_closed(shape: RotoShape) -> RotoShape:
    """The open shape closed, or the closed one opened; raises `RoamError` where it has too few points to be closed."""
    if not shape.closed and shape.point_count < MIN_POINTS_CLOSED:
        raise RoamError(
            sentence(
                "{name!r} needs at least {least} points to be closed; add one.",
                name=shape.name,
                least=MIN_POINTS_CLOSED,
            )
        )
    return controls.opened_or_closed(shape)


# ---- points of a shape -----------------------------------------------------------------------------------------------


def drag_handle(points: Array, index: int, part: int, position: ArrayLike, *, keep_smooth: bool = True) -> Array:
    """Points with one handle put at `position`; where the point is smooth the other handle turns with it.

    A point counts as smooth when its handles are opposite within two degrees; the other handle keeps its length.
    """
    result = points.copy()
    other = IN if part == OUT else OUT
    anchor = points[index, ANCHOR]
    smooth = is_smooth(points[index])
    result[index, part] = position
    direction = result[index, part] - anchor
    reach = np.hypot(*direction)
    if keep_smooth and smooth and reach > 1e-9:
        result[index, other] = anchor - direction / reach * np.hypot(*(points[index, other] - anchor))
    return result


def equal_handles(points: Array, index: int, part: int, position: ArrayLike) -> Array:
    """Points with one handle put at `position` and the other opposite to it, equally long: a smooth point."""
    result = points.copy()
    result[index, part] = position
    result[index, IN if part == OUT else OUT] = 2.0 * result[index, ANCHOR] - result[index, part]
    return result


def is_smooth(point: Array, degrees: float = 2.0) -> bool:
    """True when both handles of a `point (3, 2)` have a length and point in opposite directions."""
    return bool(are_smooth(point[None], degrees)[0])


def are_smooth(points: Array, degrees: float = 2.0) -> Bools:
    """Which of `points (P, 3, 2)` are smooth `(P,)`."""
    a, b = points[:, IN] - points[:, ANCHOR], points[:, OUT] - points[:, ANCHOR]
    lengths = np.hypot(*a.T) * np.hypot(*b.T)
    against = -(a * b).sum(axis=1) / np.maximum(lengths, 1e-9)
    return np.asarray((lengths > 1e-9) & (against > np.cos(np.radians(degrees))))


def smooth_points(points: Array, indices: Iterable[int], closed: bool = True) -> Array:
    """Points with tangents along the chord of their neighbours, handles a third of the way to each."""
    result, count = points.copy(), len(points)
    for index in indices:
        before = points[(index - 1) % count if closed else max(index - 1, 0), ANCHOR]
        after = points[(index + 1) % count if closed else min(index + 1, count - 1), ANCHOR]
        here = points[index, ANCHOR]
        chord = after - before
        reach = np.hypot(*chord)
        if reach < 1e-9:
            continue
        chord = chord / reach
        result[index, IN] = here - chord * np.hypot(*(here - before)) / 3.0
        result[index, OUT] = here + chord * np.hypot(*(after - here)) / 3.0
    return result


def cusp_points(points: Array, indices: Iterable[int]) -> Array:
    """Points with their handles drawn in, so that the outline has a corner there."""
    result = points.copy()
    for index in indices:
        result[index, IN] = result[index, OUT] = points[index, ANCHOR]
    return result


def insert_point(shape: RotoShape, segment: int, t: float) -> RotoShape:
    """A new point at `(segment, t)` in every key: the outline changes on no key, nor between linear keys.

    On a segment that is straight in every key the new point is a corner without handles: a polygon stays one. A
    B-spline has no exact insertion: its new control point and the nearest ones are fitted to the old curve.
    """
    if not 0.0 < t < 1.0:
        raise ValueError(f"t = {t} lies outside (0, 1)")
    if shape.spline is Spline.BSPLINE:
        inserted = controls.with_control(
            shape,
            lambda control: bspline.inserted(control, segment, t, shape.closed),
            lambda feather: bezier.split(feather, segment, t, shape.closed),
        )
        return _renumbered(inserted, lambda index: index + (index > segment))
    arrays = [array for key in shape.keys for array in (key.points, key.feather) if array is not None]
    straight = all(_is_straight(array, segment, shape.closed) for array in arrays)

    def with_point(array: Array) -> Array:
        result = bezier.split(array, segment, t, shape.closed)
        if straight:
            around = (segment, OUT), (segment + 1, IN), (segment + 1, OUT), ((segment + 2) % len(result), IN)
            for index, handle in around:
                result[index, handle] = result[index, ANCHOR]
        return result

    return _renumbered(shape.map_points(with_point), lambda index: index + (index > segment))


def _renumbered(shape: RotoShape, number: Callable[[int], int | None]) -> RotoShape:
    """The shape whose points have other numbers, or none, on keys of which the artist set some.

    A key that none of these is left of is no word of the artist's any more: it becomes the engine's, to be derived
    anew. One whose points are all left of them is the artist's as a whole.
    """

    def renumbered(key: Keyframe) -> Keyframe:
        left = tuple(new for index in key.set_points if (new := number(index)) is not None)
        if not left:
            return replace(key, set_points=(), origin=Origin.ENGINE)
        return replace(key, set_points=() if len(left) == shape.point_count else left)

    return shape.with_keys(renumbered(key) for key in shape.keys if key.set_points)


def _is_straight(array: Array, segment: int, closed: bool) -> bool:
    """True when both handles of a segment lie on their anchors."""
    a, b, c, d = bezier.segments(array, closed)[segment]
    return np.array_equal(a, b) and np.array_equal(c, d)


def delete_points(shape: RotoShape, indices: Sequence[int]) -> RotoShape:
    """The shape without these points, on every key; the neighbours' handles are refitted to the old outline.

    Neighbours that are smooth stay smooth. The feather curve is refitted in the same way.
    """
    gone = sorted(set(indices))
    least = MIN_POINTS_CLOSED if shape.closed else MIN_POINTS_OPEN
    if shape.point_count - len(gone) < least:
        raise RoamError(
            sentence("{name!r} needs at least {least} points; delete the shape instead.", name=shape.name, least=least)
        )
    if shape.spline is Spline.BSPLINE:
        without = controls.with_control(
            shape, lambda control: _without_control(control, gone, shape.closed), lambda each: np.delete(each, gone, 0)
        )
        return _renumbered(without, lambda index: None if index in gone else index - bisect.bisect(gone, index))
    points = merging.without_points(np.stack([key.points for key in shape.keys]), gone, shape.closed)
    feather = _feather_without(shape, gone, points)
    keys = tuple(
        replace(key, points=points[index], feather=feather.get(index), vertex_confidence=None)
        for index, key in enumerate(shape.keys)
    )
    without = replace(shape, keys=keys)
    return _renumbered(without, lambda index: None if index in gone else index - bisect.bisect(gone, index))


def _feather_without(shape: RotoShape, gone: Sequence[int], points: Array) -> dict[int, Array]:
    """The feather offsets of keys that have any, by the key's index; `points` are those that each key is left with."""
    curves = {i: key.points + key.feather for i, key in enumerate(shape.keys) if key.feather is not None}
    if not curves:
        return {}
    # The feather curve as it is seen is fitted, not its distance from the outline.
    fitted = merging.without_points(np.stack(list(curves.values())), gone, shape.closed)
    return {index: curve - points[index] for index, curve in zip(curves, fitted, strict=True)}


def _without_control(control: Array, gone: Sequence[int], closed: bool) -> Array:
    for index in reversed(gone):
        control = bspline.removed(control, index, closed)
    return control
