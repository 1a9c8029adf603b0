"""How much a project may hold, so that it opens in seconds; the same for what is written and what is read."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.roto.animated import frames_of
from roam_core.roto.project import Layer, Project
from roam_core.roto.shape import RotoShape
from roam_core.translatable import N_, said_by, sentence

MAX_DEPTH = 210
"""Layers in layers: what other programs nest 200 deep comes in, with the layer that it is put in."""
MAX_ITEMS = 50_000
"""Layers and shapes."""
MAX_KEYS = 1_000_000
"""Keys over all shapes."""
MAX_POINTS = 100_000
"""Points of a shape."""
MAX_SAMPLES = 1024
"""Moments of motion blur."""
MAX_SPAN = 1_000_000
"""Frames from the first to the last of a clip, or of a shape's keys."""
FARTHEST = 1e7
"""Pixels: a coordinate beyond this is a defect of the project, and single precision would not hold it to a pixel."""


class Count:
    """Counts the parts of a project as they are met, and refuses those too many.

    Raises
    ------
    ValueError
        from each method, when a bound is passed.
    """

    def __init__(self) -> None:
        self._items = self._keys = 0

    def layer(self, layer: Layer, depth: int) -> None:
        """A layer that lies in `depth` others."""
        require(depth, MAX_DEPTH, N_("layers in layers"))
        self._span(frames_of(layer.opacity), layer.name)
        self._item()

    def keys(self, number: int) -> None:
        """So many keys more."""
        self._keys += number
        require(self._keys, MAX_KEYS, N_("keys"))

    def shape(self, shape: RotoShape) -> None:
        """A shape; its keys are counted apart, before they are made."""
        self._item()
        require(shape.point_count, MAX_POINTS, N_("points in the shape {name!r}"), shape.name)
        for frames in (shape.frames, frames_of(shape.opacity), frames_of(shape.feather)):
            self._span(frames, shape.name)
        if shape.motion_blur is not None:
            require(shape.motion_blur.samples, MAX_SAMPLES, N_("samples of motion blur"))

    def _span(self, frames: tuple[int, ...], name: str) -> None:
        if frames:
            require(frames[-1] - frames[0] + 1, MAX_SPAN, N_("frames between the keys of {name!r}"), name)

    def _item(self) -> None:
        self._items += 1
        require(self._items, MAX_ITEMS, N_("layers and shapes"))


def require(count: int, most: int, what: str, name: str = "") -> None:
    """Refuse a count beyond its bound: of `what`, a template marked by `N_`, of what is called `name`."""
    if count > most:
        counted = sentence(what, name=name[:60])
        raise ValueError(sentence("it has more {what} than {most}", what=counted, most=most))


def is_near(points: Array) -> bool:
    """Whether all of an outline, or its feather, are numbers no farther from the picture than makes sense."""
    return bool((np.abs(points) < FARTHEST).all())  # written so that NaN fails too


def require_near(shape: RotoShape, frame: int, points: Array) -> None:
    """Refuse to work on the outline `points` of a shape on a frame: what follows it would take memory for the distance.

    Raises
    ------
    RoamError
        when one of them is not finite or lies absurdly far away.
    """
    if not is_near(points):
        raise RoamError(
            sentence(
                "The shape {name!r} has a point on frame {frame} that lies nowhere near the image; "
                "correct or delete it first.",
                name=shape.name,
                frame=frame,
            )
        )


def require_bounds(project: Project) -> None:
    """Refuse a project that could not be read again, before anything is written.

    Raises
    ------
    RoamError
        when it holds more than it may.
    """
    count = Count()
    waiting: list[tuple[Layer, int]] = [(project.root, 0)]
    try:
        while waiting:
            layer, depth = waiting.pop()
            count.layer(layer, depth)
            count.keys(len(frames_of(layer.opacity)))
            for child in layer.children:
                if isinstance(child, Layer):
                    waiting.append((child, depth + 1))
                else:
                    count.keys(len(child.keys) + len(frames_of(child.opacity)) + len(frames_of(child.feather)))
                    count.shape(child)
    except ValueError as error:
        raise RoamError(
            sentence("The project cannot be saved: {reason}; take some away.", reason=said_by(error))
        ) from None
