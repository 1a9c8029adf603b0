"""Keys that an edit changed alike with all that they were computed from: they are as fresh as they were before."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence

from roam_core.propagate.shapes.known_stamps import stamps_of
from roam_core.propagate.shapes.provenance import FILL, Stamp, Stamps, known_params
from roam_core.roto import Clip, Keyframe, Origin, Project, RotoShape
from roam_core.roto.imported import import_stamp, is_import
from roam_core.roto.shifting import shifted


def restamped(before: Project, after: Project, shape_ids: Iterable[str], frames: range) -> Project:
    """The project `after` an edit that changed all keys of these shapes on `frames` alike.

    ENGINE keys that held `before`, and whose knowledge begins and ends on these frames, get the stamp that fits the
    artist's keys as they are now. What reaches beyond the frames, or was stale, keeps its stamp.
    """
    held, now = stamps_of(before), stamps_of(after)
    place = {shape.id: k for k, shape in enumerate(after.shapes)}
    fresh_shapes: list[RotoShape] = []
    for shape_id in shape_ids:
        was, shape = before.shape(shape_id), after.shape(shape_id)
        held_runs = (run for run in held.alike(was) if _lies_on(run[0], frames) and not held.is_stale(was, run[0]))
        kept = {key.frame for run in held_runs for key in run if key.frame in frames}
        fresh = [key for run in now.alike(shape) for key in _stamped(now, place[shape_id], shape, run, kept)]
        fresh_shapes.append(shape.with_keys(fresh))
    return after.with_shapes(fresh_shapes)


def renumbered(project: Project, before: Clip) -> Project:
    """The project with everything shifted to the frames of its clip: the pictures of the clip `before`, numbered anew.

    No picture has changed under its keys, and no number counts in what the engine makes of one: ENGINE keys that held
    with the clip `before` hold, those that were stale are.
    """
    offset = project.require_clip().first - before.first
    after = shifted(project, offset)
    held, now = Stamps.of(project.shapes, before), Stamps.of(after.shapes, after.clip)
    fresh_shapes: list[RotoShape] = []
    for k, (was, shape) in enumerate(zip(project.shapes, after.shapes, strict=True)):
        fresh = [
            new.but(inputs=_stamp(now, k, new))
            for old, new in zip(was.keys, shape.keys, strict=True)
            if old.origin is Origin.ENGINE and not is_import(old) and not held.is_stale(was, old)
        ]
        fresh_shapes.append(shape.with_keys(fresh))
    return after.with_shapes(fresh_shapes)


def _stamped(
    now: Stamps, k: int, shape: RotoShape, run: Sequence[Keyframe], kept: Collection[int]
) -> Iterator[Keyframe]:
    """Of keys of the shape with this index that are stamped alike those on the frames `kept`, with their stamp now.

    Those that have it already are left out.
    """
    told = [key for key in run if key.frame in kept]
    if told:
        first = told[0]
        inputs = import_stamp(shape, first.frame) if is_import(first) else _stamp(now, k, first)
        if inputs != first.inputs:
            yield from (key.but(inputs=inputs) for key in told)


def _lies_on(key: Keyframe, frames: range) -> bool:
    """Whether the frames on which the run of an ENGINE key began and ended lie on these."""
    made = Stamp.read(key.inputs)
    return all(end is None or end in frames for end in (made.begun, made.until))


def _stamp(stamps: Stamps, k: int, key: Keyframe) -> str:
    """What the run that made a key would stamp it with now."""
    made = Stamp.read(key.inputs)
    params = known_params(made.config)
    if params is None or made.begun is None:
        return key.inputs
    if made.direction == FILL:
        return key.inputs if made.gap is None else stamps.filled(k, made.gap, params, made.alone, made.asked_beyond)
    return stamps.tracked(k, key.frame, made.begun, params, made.forward, made.alone)
