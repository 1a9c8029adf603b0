"""Moving layers made motion of their shapes for formats, with the keys that only a layer asks for told apart."""

from __future__ import annotations

from dataclasses import replace

from roam_core.roto import Layer, Origin, Project, RotoShape
from roam_core.roto.baking import without_transforms

BY_LAYER = "layer"
"""What keys that only a layer's motion asks for were computed from, where engine keys bear a stamp.

They are nobody's work: reducing keys may leave them out, but keeping the artist's keys alone may not.
"""


def bake_layers(project: Project) -> Project:
    """The project with every layer standing still and its motion in the shapes, as engine keys that are `BY_LAYER`."""
    if project.plate_root is project.root:
        return project
    own = {shape.id: set(shape.frames) for shape in project.root.shapes()}

    def marked(item: Layer | RotoShape) -> Layer | RotoShape:
        if isinstance(item, Layer):
            return replace(item, children=tuple(marked(child) for child in item.children))
        keys = (
            key if key.frame in own[item.id] else replace(key, origin=Origin.ENGINE, inputs=BY_LAYER)
            for key in item.keys
        )
        return replace(item, keys=tuple(keys))

    root = marked(without_transforms(project).root)
    assert isinstance(root, Layer)
    return replace(project, root=root)
