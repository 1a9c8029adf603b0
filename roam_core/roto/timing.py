"""Edit verbs in time: keys of several shapes at once, moved, copied, deleted, interpolated; marks on frames.

A key that goes to another frame stays where it lies in its layer: with one that moves, as by a planar track, it goes
along.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import replace
from functools import partial

from roam_core.arrays import Array
from roam_core.roto import edit
from roam_core.roto.animated import Interpolation
from roam_core.roto.control_points import settled
from roam_core.roto.keyframe import Keyframe, Origin
from roam_core.roto.keying import reshape
from roam_core.roto.project import Mark, Project
from roam_core.roto.shape import Outline, RotoShape, unplaced

Place = tuple[str, int]
"""Where a key lies: (shape id, frame)."""
NO_POINTS: Mapping[str, frozenset[int]] = {}


def artist_places(project: Project) -> frozenset[Place]:
    """Where the artist's keys of all shapes lie."""
    return frozenset((shape.id, frame) for shape in project.shapes for frame in shape.artist_frames)


def move_keys(project: Project, places: Iterable[Place], offset: int) -> Project:
    """The project with the artist's keys at `places` shifted by `offset` frames.

    A key that lay where one arrives gives way to it, as the hand that put it there wanted. The engine's keys stay where
    they are: those that depend on a key that moved bear another stamp than they should, and so are shown as stale.
    """
    return _each_held(project, places, partial(_moved, offset=offset))


def retime_keys(project: Project, places: Iterable[Place], goes: Mapping[int, int]) -> Project:
    """The project with the artist's keys at `places` on the frames that `goes` tells, by theirs, as of `stretched`.

    What lies where they arrive gives way, and the engine's keys stay, as with `move_keys`.
    """
    return _each_held(project, places, partial(_retimed, goes=goes))


def stretched(frames: Iterable[int], first: int, last: int) -> dict[int, int]:
    """Where frames go that are stretched or pressed together to lie from `first` to `last`, evenly, by where they were.

    They keep their order, and each has a frame of its own: `last` lies so far at least that there is room for all.
    """
    own = sorted(set(frames))
    if len(own) < 2:
        return dict.fromkeys(own, first)
    last = max(last, first + len(own) - 1)
    pace = (last - first) / (own[-1] - own[0])
    goes: list[int] = []
    for index, frame in enumerate(own):
        least = goes[-1] + 1 if goes else first
        most = last - (len(own) - 1 - index)
        goes.append(min(max(round(first + pace * (frame - own[0])), least), most))
    return dict(zip(own, goes, strict=True))


def shift_keys(
    project: Project, places: Iterable[Place], offset: Array, points: Mapping[str, frozenset[int]] = NO_POINTS
) -> Project:
    """The project with control points moved by `offset (2,)` pixels on the artist's keys at `places`.

    `points` are those of a shape that move, by its id; of a shape that is not among them all do.
    """

    def shifted(shape: RotoShape, frames: set[int]) -> RotoShape:
        own = sorted(points.get(shape.id, range(shape.point_count)))

        def change(outline: Outline) -> Outline:
            moved = outline.points.copy()
            moved[own] += offset
            return replace(outline, points=moved)

        for frame in frames & set(shape.artist_frames):
            shape = reshape(shape, frame, change)
        return shape

    return _each_shape(project, places, shifted)


def copy_keys(project: Project, places: Iterable[Place], offset: int) -> Project:
    """The project with copies of the artist's keys at `places`, `offset` frames on; what lies there gives way."""
    return _each_held(project, places, partial(_with_copies, offset=offset))


def paste_keys(
    project: Project, keys: Mapping[str, Iterable[Keyframe]], offset: int = 0, own: Collection[str] = ()
) -> Project:
    """The project with keys, in plate space, put into its shapes, `offset` frames on, as the artist's.

    What lies there gives way. Shapes that are gone, and keys of another number of points than their shape has, are left
    out. A B-spline takes the key of a Bezier as the nearest B-spline. Shapes whose `own` keys these are, by their ids,
    take them where they lie in their layers, others where they are seen.
    """
    for shape_id, copied in keys.items():
        if project.has(shape_id):
            shape = project.shape(shape_id)
            fitting = [
                replace(key, points=settled(key.points, shape))
                for key in copied
                if len(key.points) == shape.point_count
            ]
            if shape.placement and shape_id in own and fitting:
                inside = unplaced(replace(shape, keys=tuple(fitting))).keys
                project = project.map_item(shape_id, partial(_with_shifted, inside, offset))
            else:
                project = project.with_shape(shape.with_keys(_shifted(fitting, offset)))
    return project


def delete_keys(project: Project, places: Iterable[Place]) -> Project:
    """The project without the artist's keys at `places`; raises `RoamError` where a shape would have no key left."""
    return _each_shape(
        project, places, lambda shape, frames: edit.delete_keys(shape, [k.frame for k in _artist_keys(shape, frames)])
    )


def set_interpolation(project: Project, places: Iterable[Place], interpolation: Interpolation) -> Project:
    """The project with another way to move on from the keys at `places`."""
    return _each_shape(
        project, places, lambda shape, frames: edit.set_interpolation(shape, frames & set(shape.frames), interpolation)
    )


def _each_shape(project: Project, places: Iterable[Place], verb: Callable[[RotoShape, set[int]], RotoShape]) -> Project:
    return project.with_shapes(verb(project.shape(shape_id), own) for shape_id, own in _by_shape(project, places))


def _each_held(project: Project, places: Iterable[Place], verb: Callable[..., RotoShape]) -> Project:
    """As `_each_shape`, of the shapes as they lie in their layers."""
    found = [(project.find(shape_id), own) for shape_id, own in _by_shape(project, places)]
    return project.with_held(verb(shape, frames=own) for shape, own in found if isinstance(shape, RotoShape))


def _by_shape(project: Project, places: Iterable[Place]) -> list[tuple[str, set[int]]]:
    """The frames of each of the shapes that are there."""
    frames: dict[str, set[int]] = {}
    for shape_id, frame in places:
        frames.setdefault(shape_id, set()).add(frame)
    return [(shape_id, own) for shape_id, own in sorted(frames.items()) if project.has(shape_id)]


def _with_shifted(keys: Iterable[Keyframe], offset: int, shape: RotoShape) -> RotoShape:
    return shape.with_keys(_shifted(keys, offset))


def _moved(shape: RotoShape, frames: set[int], offset: int) -> RotoShape:
    return edit.move_keys(shape, [key.frame for key in _artist_keys(shape, frames)], offset)


def _retimed(shape: RotoShape, frames: set[int], goes: Mapping[int, int]) -> RotoShape:
    moving = [key.frame for key in _artist_keys(shape, frames)]
    return edit.retime_keys(shape, {frame: goes[frame] for frame in moving if frame in goes})


def _with_copies(shape: RotoShape, frames: set[int], offset: int) -> RotoShape:
    return shape.with_keys(_shifted(_artist_keys(shape, frames), offset))


def _artist_keys(shape: RotoShape, frames: set[int]) -> list[Keyframe]:
    return [key for key in shape.keys if key.origin is Origin.ARTIST and key.frame in frames]


def _shifted(keys: Iterable[Keyframe], offset: int) -> list[Keyframe]:
    """Copies on other frames, as the artist's: an engine's word on how far to trust them is not theirs."""
    return [
        replace(
            key,
            frame=key.frame + offset,
            origin=Origin.ARTIST,
            confidence=None,
            vertex_confidence=None,
            inputs="",
        )
        for key in keys
    ]


# ---- marks of the timeline -------------------------------------------------------------------------------------------


def mark_at(project: Project, frame: int) -> Mark | None:
    """The artist's mark on a frame, or None."""
    return next((mark for mark in project.marks if mark.frame == frame), None)


def set_mark(project: Project, frame: int, text: str = "") -> Project:
    """The project with a mark on a frame, in place of one that was there."""
    return _with_mark(project, replace(mark_at(project, frame) or Mark(frame), text=text))


def remove_mark(project: Project, frame: int) -> Project:
    """The project without the mark on a frame."""
    return replace(project, marks=tuple(mark for mark in project.marks if mark.frame != frame))


def move_mark(project: Project, frame: int, target: int) -> Project:
    """The project with the mark of one frame on another; with one that lay there it becomes one mark, of both notes."""
    mark = mark_at(project, frame)
    if mark is None:
        return project
    project = remove_mark(project, frame)
    there = mark_at(project, target)
    notes = [each.text for each in (there, mark) if each is not None and each.text]
    return _with_mark(project, replace(mark, frame=target, text="\n".join(notes)))


def _with_mark(project: Project, mark: Mark) -> Project:
    rest = remove_mark(project, mark.frame).marks
    return replace(project, marks=tuple(sorted([*rest, mark], key=lambda each: each.frame)))
