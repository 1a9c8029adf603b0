"""Shapes that follow a track: a layer around them takes its motion, and everything of the artist's stays in place."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from functools import partial
from itertools import takewhile

import numpy as np

from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.geometry import projective
from roam_core.geometry.plane_motion import PlaneMotion, fit
from roam_core.roto.baking import baked
from roam_core.roto.edit import remove_items
from roam_core.roto.imported import IMPORT, stamped
from roam_core.roto.keyframe import Keyframe, Origin
from roam_core.roto.layers import grouped
from roam_core.roto.placement import LayerTransform, Placement, matrix_at
from roam_core.roto.project import Layer, Project
from roam_core.roto.shape import RotoShape
from roam_core.translatable import sentence

LAYER_NAME = "Planar"
"""Of a layer that is made for a track; the first one is numbered 1."""


def with_moving_layer(project: Project, shape_ids: Collection[str], frame: int) -> tuple[Project, str]:
    """A layer around shapes that a track can move, and its id: the one that holds just these, or a new one.

    A layer that moves already is taken up again where it holds exactly these shapes; so a track can be gone on with, in
    either direction. So is the innermost one that holds just these and stands still, as all in it does: a layer of the
    artist's, or one whose motion was removed. Otherwise a new one named "Planar 1", "Planar 2", ... comes around them.
    What begins to move stands still on `frame`.

    No shape moves by that, on no frame: what a layer moved out of which a shape is taken is told by engine keys of the
    shape then, which a track replaces. Moving layers that hold nothing any more fall away.
    """
    if (there := moving_layer(project, shape_ids)) is not None:
        return project, there.id
    begun = replace(LayerTransform.of({frame: projective.IDENTITY}), adjusted=(frame,))
    if (there := _still_layer(project, shape_ids)) is not None:
        return _with_transform(project, there.id, begun), there.id
    after, layer = grouped(project, set(shape_ids), project.free_name(LAYER_NAME))
    for shape_id in shape_ids:
        if _moved_by(project, shape_id) != _moved_by(after, shape_id):
            after = after.with_shape(_baked_for_track(project.shape(shape_id)))
    emptied = [each.id for each in _layers(project) if each.transform is not None and any(each.shapes())]
    after = remove_items(after, [each.id for each in _layers(after) if each.id in emptied and not any(each.shapes())])
    return _with_transform(after, layer.id, begun), layer.id


def moving_layer(project: Project, shape_ids: Collection[str]) -> Layer | None:
    """The layer that moves and holds just these shapes."""
    return next((layer for layer in _layers_of(project, shape_ids) if layer.transform is not None), None)


def followed(
    project: Project, layer_id: str, start: int, frame: int, motion: Array, confidence: float | None = None
) -> Project:
    """The project with a layer on `frame` where `motion (3, 3)` carries the picture that it has on frame `start`.

    No key of the artist moves, on no frame: what a key says in the layer's own space is changed so that it is seen
    where it was (exact but for rounding). Engine keys on `frame` give way to the track, unless it is a shape's only
    key; those on other frames stay where they are seen. An adjust key on `frame` stays as the artist pinned it: by what
    the track misses it, the frames since `start` are drawn to it, the more the nearer they are.
    """
    layer = _layer(project, layer_id)
    own = layer.transform or LayerTransform.of({start: projective.IDENTITY})
    if start not in own.frames:  # a run that begins beside the others: what it was matched to must not move with it
        own = own.with_matrices({start: own.at(start)}, dict(own.confidence))
    outside = _inverse(_above(project, layer_id, frame)) @ motion @ _above(project, layer_id, start)
    told = {} if confidence is None else {frame: confidence}
    after = own.with_matrices({frame: outside @ own.at(start)}, told)
    if frame in own.adjusted and frame != start:
        there = projective.apply(_inverse(after.at(frame)) @ own.at(frame), surface_of(layer))
        after = _spread(after, surface_of(layer), there, frame, (min(start, frame), max(start, frame)))
    return _with_transform(project, layer_id, after, (start, frame))


def surface_at(project: Project, layer_id: str, frame: int) -> Array:
    """The four corners `(4, 2)` by which a moving layer's surface is pinned, as they are seen on a frame."""
    layer = _layer(project, layer_id)
    assert layer.transform is not None
    return projective.apply(_above(project, layer_id, frame) @ layer.transform.at(frame), surface_of(layer))


def surface_of(layer: Layer) -> Array:
    """The same corners in layer space: those that are kept, else the box around its shapes where its motion began."""
    assert layer.transform is not None
    if layer.transform.surface:
        return np.array(layer.transform.surface)
    frame = (*layer.transform.anchors, layer.transform.frames[0])[0]
    shapes = replace(layer, transform=None).in_plate_space().shapes()
    places = np.concatenate([shape.at(frame).points.reshape(-1, 2) for shape in shapes])
    (left, top), (right, bottom) = places.min(axis=0), places.max(axis=0)
    return np.array([(left, top), (right, top), (right, bottom), (left, bottom)])


def matrix_of(project: Project, layer_id: str, frame: int) -> Array:
    """From a moving layer's space to the plate on a frame, `(3, 3)`."""
    own = _layer(project, layer_id).transform
    assert own is not None
    return np.asarray(_above(project, layer_id, frame) @ own.at(frame))


def motion_between(project: Project, layer_id: str, start: int, frame: int) -> Array:
    """How what lies in a moving layer goes from one frame's picture to another's, `(3, 3)`."""
    return np.asarray(matrix_of(project, layer_id, frame) @ _inverse(matrix_of(project, layer_id, start)))


def with_points(project: Project, layer_id: str, frame: int, places: Array, areas: tuple[float, float]) -> Project:
    """The project with the points that a moving layer's track follows: at `places (N, 2)` of the plate on a frame.

    `areas` are half the sides of their patterns and search areas, pixels. The motion stays as it is.
    """
    own = _layer(project, layer_id).transform
    assert own is not None
    inside = projective.apply(_inverse(matrix_of(project, layer_id, frame)), places)
    points = tuple((float(x), float(y)) for x, y in inside)
    told = replace(own, points=points, areas=areas if points else ())
    return project.map_item(layer_id, lambda layer: replace(layer, transform=told))


def pinned(project: Project, layer_id: str, frame: int, corners: Array) -> Project:
    """The project with an adjust key: on `frame` the surface's corners lie at `corners (4, 2)`, as the artist says.

    What that changes is spread evenly to the adjust keys before and after it, where it ends; beyond the last one it
    holds. The frame's confidence goes, for the artist's word is there. No key of the artist's shapes moves.

    Raises
    ------
    RoamError
        where the corners do not go around in one direction: they would fold the surface.
    """
    layer = _layer(project, layer_id)
    own = layer.transform
    if own is None or not _is_convex(np.asarray(corners)):
        raise RoamError(
            sentence("The four corners must stay corners of one surface: none of them may cross its sides.")
        )
    surface = surface_of(layer)
    own = own.with_matrices({frame: own.at(frame)}, dict(own.confidence)) if frame not in own.frames else own
    there = projective.apply(_inverse(_above(project, layer_id, frame) @ own.at(frame)), corners)
    before = [key for key in own.anchors if key < frame]
    later = [key for key in own.anchors if key > frame]
    span = max(before, default=own.frames[0] - 1), min(later, default=own.frames[-1] + 1)
    after = _spread(own, surface, there, frame, span, bool(before), bool(later))
    keys = {*own.anchors, frame}
    kept = replace(
        after,
        confidence=tuple(pair for pair in after.confidence if pair[0] != frame),
        adjusted=tuple(keys),
        surface=tuple((float(x), float(y)) for x, y in surface),
    )
    return _with_transform(project, layer_id, kept)


def unpinned(project: Project, layer_id: str, frame: int) -> Project:
    """The project without an adjust key; the motion stays as it is until it is tracked anew."""
    own = _layer(project, layer_id).transform
    if own is None:
        return project
    return _with_transform(project, layer_id, replace(own, adjusted=tuple(k for k in own.adjusted if k != frame)))


def still(project: Project, layer_id: str) -> Project:
    """The project with a layer that moves no more; every key stays where it is seen, on its own frame."""
    return _with_transform(project, layer_id, None)


def _spread(
    own: LayerTransform,
    surface: Array,
    there: Array,
    frame: int,
    span: tuple[int, int],
    fades_before: bool = True,
    fades_after: bool = True,
) -> LayerTransform:
    """The motion changed so that on `frame` the corners `surface (4, 2)` go where `there (4, 2)` went.

    The change fades to nothing at both ends of `span`, or holds up to them.
    """
    matrices: dict[int, Array] = {}
    for each in own.frames:
        if each != frame and not span[0] < each < span[1]:
            continue
        end, fades = (span[0], fades_before) if each < frame else (span[1], fades_after)
        weight = (each - end) / (frame - end) if fades and each != frame else 1.0
        change = fit(PlaneMotion.HOMOGRAPHY, surface, surface + weight * (there - surface))
        if change is not None:
            matrices[each] = own.at(each) @ change
    return own.with_matrices(matrices, dict(own.confidence))


def _is_convex(corners: Array) -> bool:
    """Whether four corners go around in one direction."""
    sides = np.roll(corners, -1, axis=0) - corners
    after = np.roll(sides, -1, axis=0)
    turns = np.sign(sides[:, 0] * after[:, 1] - sides[:, 1] * after[:, 0])
    return bool(abs(turns.sum()) == len(corners))


def _layers(project: Project) -> list[Layer]:
    """The layers of a project, parents before children."""
    return [item for item in project.root.items() if isinstance(item, Layer)]


def _layers_of(project: Project, shape_ids: Collection[str]) -> list[Layer]:
    """The layers that hold just these shapes, the outermost first."""
    chosen = set(shape_ids)
    return [layer for layer in _layers(project) if {shape.id for shape in layer.shapes()} == chosen]


def _still_layer(project: Project, shape_ids: Collection[str]) -> Layer | None:
    """The innermost layer that holds just these shapes, where nothing in it moves."""
    around = _layers_of(project, shape_ids)
    if not around or any(isinstance(item, Layer) and item.transform is not None for item in around[0].items()):
        return None
    return around[-1]


def _moved_by(project: Project, shape_id: str) -> Placement:
    return project.placement_in(project.layers_above(shape_id)[-1].id)


def _baked_for_track(shape: RotoShape) -> RotoShape:
    """A placed shape with keys in place of what moves it; those are no artist's keys, so that a track replaces them."""
    own = set(shape.frames)
    plain = baked(shape)
    told = (key if key.frame in own else replace(key, origin=Origin.ENGINE, inputs=IMPORT) for key in plain.keys)
    return _with_stamps(replace(plain, keys=tuple(told)))


def _with_stamps(shape: RotoShape) -> RotoShape:
    """A shape in plate space whose engine keys of ours tell between which of the artist's they stand."""
    item = stamped(shape)
    assert isinstance(item, RotoShape)
    return item


def _inverse(matrix: Array) -> Array:
    return np.asarray(np.linalg.inv(matrix), dtype=np.float64)


def _above(project: Project, layer_id: str, frame: int) -> Array:
    """From the space around a layer to the plate on a frame."""
    layers = project.layers_above(layer_id)
    return matrix_at(tuple(each.transform for each in layers if each.transform is not None), frame)


def _with_transform(
    project: Project, layer_id: str, transform: LayerTransform | None, tracked: tuple[int, int] | None = None
) -> Project:
    """The project with another motion of a layer, its keys as they are seen.

    `tracked` are the frames from which and to which a track has come: engine keys between give way.
    """
    seen = [project.shape(shape.id) for shape in _layer(project, layer_id).shapes()]
    project = project.map_item(layer_id, lambda layer: replace(layer, transform=transform))
    if tracked is None:
        return project.with_shapes(seen)
    project = project.with_shapes(_without_engine_keys(shape, *tracked) for shape in seen)
    for shape in seen:
        led = project.map_item(shape.id, partial(_led_to, start=tracked[0], frame=tracked[1]))
        if led.find(shape.id) is not project.find(shape.id):
            project = led.with_shape(_with_stamps(led.shape(shape.id)))
    return project


def _without_engine_keys(shape: RotoShape, start: int, frame: int) -> RotoShape:
    """The shape without engine keys after `start` up to `frame`, unless it has no other key."""
    gone = range(frame, start, 1 if frame < start else -1) or (frame,)
    kept = tuple(key for key in shape.keys if key.frame not in gone or key.origin is Origin.ARTIST)
    return replace(shape, keys=kept or shape.keys)


def _led_to(held: RotoShape, start: int, frame: int) -> RotoShape:
    """A shape, as its layer holds it, that on `frame` is where it were without the engine keys beyond.

    They stay where they are seen, while the layer's motion ends: without a key before them all tracked frames would be
    drawn to the first of them.
    """
    step = 1 if frame > start else -1
    beyond = sorted((key for key in held.keys if (key.frame - frame) * step > 0), key=lambda key: key.frame * step)
    engines = {key.frame for key in takewhile(lambda key: key.origin is Origin.ENGINE, beyond)}
    bare = tuple(key for key in held.keys if key.frame not in engines)
    if not engines or not bare or held.key_at(frame) is not None:
        return held
    outline = replace(held, keys=bare).at(frame)
    made = Keyframe(frame, outline.points, outline.feather, Origin.ENGINE, inputs=IMPORT)
    return held.with_keys([made])


def _layer(project: Project, layer_id: str) -> Layer:
    layer = project.find(layer_id)
    if not isinstance(layer, Layer):
        raise ValueError(f"{layer_id!r} is no layer")
    return layer
