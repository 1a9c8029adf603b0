"""Shapes that follow a track: a layer around them takes its motion, and everything of the artist's stays in place."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import replace

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import projective
from roam_core.roto.layers import grouped
from roam_core.roto.placement import LayerTransform, matrix_at
from roam_core.roto.project import Layer, Project
from roam_core.roto.shape import Origin, RotoShape


def with_moving_layer(project: Project, shape_ids: Collection[str], frame: int, name: str) -> tuple[Project, str]:
    """A layer around shapes that a track can move, and its id: the one that holds just these, or a new one.

    A layer that moves already is taken up again where it holds exactly these shapes; so a track can be gone on with, in
    either direction. Otherwise a new one named `name 1`, `name 2`, ... stands still on `frame`.
    """
    chosen = set(shape_ids)
    for item in project.root.items():
        if isinstance(item, Layer) and item.transform is not None and {s.id for s in item.shapes()} == chosen:
            return project, item.id
    project, layer = grouped(project, chosen, project.free_name(name))
    return _with_transform(project, layer.id, LayerTransform.of({frame: projective.IDENTITY})), layer.id


def followed(project: Project, layer_id: str, start: int, frame: int, motion: Array) -> Project:
    """The project with a layer on `frame` where `motion (3, 3)` carries the picture that it has on frame `start`.

    No key of the artist moves, on no frame: what a key says in the layer's own space is changed so that it is seen
    where it was (exact but for rounding). Engine keys on `frame` give way to the track, unless it is a shape's only
    key; those on other frames stay where they are seen.
    """
    layer = _layer(project, layer_id)
    above = tuple(each.transform for each in project.layers_above(layer_id) if each.transform is not None)
    own = layer.transform or LayerTransform.of({start: projective.IDENTITY})
    outside = np.linalg.inv(matrix_at(above, frame)) @ motion @ matrix_at(above, start)
    return _with_transform(project, layer_id, own.with_matrices({frame: outside @ own.at(start)}), frame)


def still(project: Project, layer_id: str) -> Project:
    """The project with a layer that moves no more; every key stays where it is seen, on its own frame."""
    return _with_transform(project, layer_id, None)


def _with_transform(
    project: Project, layer_id: str, transform: LayerTransform | None, tracked: int | None = None
) -> Project:
    seen = [project.shape(shape.id) for shape in _layer(project, layer_id).shapes()]
    project = project.map_item(layer_id, lambda layer: replace(layer, transform=transform))
    for shape in _without_engine_key(seen, tracked):
        project = project.with_shape(shape)
    return project


def _without_engine_key(shapes: Iterable[RotoShape], frame: int | None) -> Iterable[RotoShape]:
    for shape in shapes:
        kept = tuple(key for key in shape.keys if key.frame != frame or key.origin is Origin.ARTIST)
        yield replace(shape, keys=kept or shape.keys)


def _layer(project: Project, layer_id: str) -> Layer:
    layer = project.find(layer_id)
    if not isinstance(layer, Layer):
        raise ValueError(f"{layer_id!r} is no layer")
    return layer
