"""What an edit of points and feathers brings with it on other keys, once it is made: not while it is dragged."""

from __future__ import annotations

from collections.abc import Iterable

from roam_core.propagate.shapes.known_stamps import stamps_of
from roam_core.propagate.shapes.restamping import restamped
from roam_core.roto import Project, RotoShape, feather
from roam_core.roto.keying import Keying, is_same
from roam_core.roto.lifetimes import LAST_FRAME


def settled(before: Project, after: Project, shape_ids: Iterable[str], frame: int, keying: Keying) -> Project:
    """The project `after` an edit at `frame` of these shapes, with what follows from it.

    Tracked frames go along with a feather that was set on a key of the artist's; in the range of a ripple they took the
    change themselves, as all keys did. What a ripple changed alike with all that it was tracked from is not stale.
    """
    ids = [shape_id for shape_id in shape_ids if after.shape(shape_id) is not before.shape(shape_id)]
    is_rippled = keying.ripple is not None and frame in keying.ripple
    if not is_rippled:
        after = after.with_shapes(
            feather.carried_on(after.shape(shape_id), frame)
            for shape_id in ids
            if not is_same(before.shape(shape_id).at(frame).feather, after.shape(shape_id).at(frame).feather)
        )
    return after if keying.ripple is None else restamped(before, after, ids, keying.ripple)


def with_same_outline(before: Project, after: RotoShape) -> Project:
    """The project with a shape whose outline is on every key as it was `before`, told by other points.

    No tracked frame of it, or of the others of its object, is stale for that.
    """
    return with_same_outlines(before, before.with_shape(after), [after.id])


def with_same_outlines(before: Project, after: Project, shape_ids: Iterable[str]) -> Project:
    """The project `after` in which the outlines of these shapes are told otherwise, and are on every key as `before`.

    No tracked frame of them, or of the others of their objects, is stale for that.
    """
    stamps = stamps_of(before)
    together = {shape.id for shape_id in shape_ids for shape in stamps.together(before.shape(shape_id))}
    return restamped(
        before, after, [shape.id for shape in before.shapes if shape.id in together], range(-LAST_FRAME, LAST_FRAME + 1)
    )
