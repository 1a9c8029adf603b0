"""What a planar track looks at: outlines on the surface, holes in it, what lies before it, and its frames in legs."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from enum import StrEnum
from itertools import pairwise

from roam_core.arrays import Array
from roam_core.roto.following import moving_layer
from roam_core.roto.project import Project
from roam_core.roto.shape import BlendMode, RotoShape


class LeaveOut(StrEnum):
    """Which other shapes lie before a tracked surface, so that the track does not look at what they cover."""

    NOTHING = "nothing"
    ABOVE = "above"
    OTHERS = "others"
    CHOSEN = "chosen"


def covering(
    project: Project, shape_ids: Collection[str], frame: int, which: LeaveOut, chosen: Collection[str] = ()
) -> list[RotoShape]:
    """The closed shapes that lie before those of a planar track: above all of them, all others, or the `chosen` ones.

    What is brought before or behind all counts as such on the frame on which the track begins. Hidden shapes count
    where they are chosen by their ids.
    """
    tracked, shapes = set(shape_ids), project.shapes
    others = [shape for shape in shapes if shape.id not in tracked and shape.closed]
    if which is LeaveOut.CHOSEN:
        return [shape for shape in others if shape.id in set(chosen)]
    if which is LeaveOut.NOTHING:
        return []
    places = {shape.id: (shape.depth_at(frame), index) for index, shape in enumerate(shapes)}
    top = max((places[shape_id] for shape_id in tracked), default=(0, 0))
    seen = [shape for shape in others if shape.visible]
    return [shape for shape in seen if which is LeaveOut.OTHERS or places[shape.id] > top]


def legs_of(frames: range, adjusted: Collection[int]) -> tuple[range, ...]:
    """The frames in pieces that begin and end on adjust keys, one where there are none."""
    inner = [frame for frame in frames[1:-1] if frame in set(adjusted)]
    ends = [frames[0], *inner, frames[-1]]
    return tuple(range(a, b + frames.step, frames.step) for a, b in pairwise(ends))


def adjusted_frames(project: Project, shape_ids: Sequence[str]) -> tuple[int, ...]:
    """The adjust keys of the layer that moves these shapes."""
    layer = moving_layer(project, shape_ids)
    return () if layer is None or layer.transform is None else layer.transform.adjusted


def outlines_at(shapes: Sequence[RotoShape], frame: int) -> tuple[list[Array], list[Array]]:
    """The closed outlines `(P, 3, 2)` of shapes that are there on a frame, and those of shapes that subtract."""
    there = [shape for shape in shapes if shape.closed and shape.exists_at(frame)]
    outlines = [shape.at(frame).points for shape in there if shape.blend is not BlendMode.SUBTRACT]
    return outlines, [shape.at(frame).points for shape in there if shape.blend is BlendMode.SUBTRACT]


def covers_at(shapes: Sequence[RotoShape], frame: int) -> list[Array]:
    """The outlines `(P, 3, 2)` of those of these shapes that are there on a frame."""
    return [shape.at(frame).points for shape in shapes if shape.closed and shape.exists_at(frame)]
