"""Shapes found in a picture or a mask become the project's: with free names and colours, holes kept to themselves."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from roam_core.roto import edit
from roam_core.roto.linking import relinked
from roam_core.roto.project import Project
from roam_core.roto.shape import BlendMode, RotoShape


def add_found(project: Project, shapes: Sequence[RotoShape], home_id: str = "root") -> tuple[Project, tuple[str, ...]]:
    """Put `shapes` on top of a layer; the next free ids, names and colours take the place of theirs.

    So do free names of compounds that are taken.

    Parameters
    ----------
    shapes : outlines, each followed by its holes as subtracting shapes.
    home_id : the layer that takes all of them; the root by default. An outline with holes goes into a layer of its
        own in it, so that the holes cut nothing but their own object.

    Returns
    -------
    The project, and the ids of the new shapes.
    """
    ids: list[str] = []
    for region in _regions(relinked(project, shapes)):
        layer_id = home_id
        if len(region) > 1:
            project, layer = edit.add_layer(project, project.free_name("Object"), home_id)
            layer_id = layer.id
        for shape in region:
            is_hole = shape.blend is BlendMode.SUBTRACT
            new = replace(
                shape,
                id=project.free_id("shape"),
                name=project.free_name("Hole" if is_hole else "Shape"),
                colour=project.free_colour(),
            )
            project = edit.add_shape(project, new, layer_id)
            ids.append(new.id)
    return project, tuple(ids)


def _regions(shapes: Sequence[RotoShape]) -> list[list[RotoShape]]:
    """Each outline with its holes."""
    regions: list[list[RotoShape]] = []
    for shape in shapes:
        if shape.blend is BlendMode.SUBTRACT and regions:
            regions[-1].append(shape)
        else:
            regions.append([shape])
    return regions
