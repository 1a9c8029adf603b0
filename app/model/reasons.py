"""Why nothing is edited, or seen to move, or is out of date all at once: sentences for the status bar."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import islice

from roam_core.propagate.shapes.known_stamps import stamps_of
from roam_core.roto import Clip, Origin, Project, RotoShape

from ..translation import N_, tr
from .shown import editable_in
from .solo import Solo
from .view_state import ViewState, selected_shapes

MOST_NAMES = 3
"""Shapes that a sentence names."""
NOTHING_SELECTED = N_("Select a shape or some of its points first.")
LOCKED_STAYS = N_("What is locked stays; unlock it first (<shape.lock>).")


def why_not(project: Project, view: ViewState) -> str:
    """What keeps the first of the selected shapes that may not be edited here, or that none is selected."""
    here = range(view.frame, view.frame + 1)
    return why_kept(project, selected_shapes(project, view.selection), here, view.solo) or tr(NOTHING_SELECTED)


def why_kept(project: Project, shapes: Iterable[RotoShape], frames: range, solo: Solo | None = None) -> str:
    """What keeps the first of these shapes that may not be edited on any of these frames; empty where all may.

    With `solo` those that it leaves out of sight may not, either.
    """
    free = {shape.id for shape in editable_in(project if solo is None else solo.seen(project), frames)}
    kept = next((shape for shape in shapes if shape.id not in free), None)
    if kept is None:
        return ""
    if not any(kept.exists_at(frame) for frame in frames):
        return does_not_exist(kept, frames[0])
    if kept.id in {shape.id for shape in editable_in(project, frames)}:
        return tr("{name!r} is not shown while others are soloed; <shape.solo> shows all.", name=kept.name)
    above = project.layers_above(kept.id) if kept.visible and not kept.locked else ()
    around = next((layer for layer in above if layer.locked or not layer.visible), None)
    if around is not None:
        return tr(
            "{name!r} lies in {layer!r}, which is locked or hidden; unlock and show that layer to edit it.",
            name=kept.name,
            layer=around.name,
        )
    return tr("{name!r} is locked or hidden; unlock and show it to edit it.", name=kept.name)


def does_not_exist(shape: RotoShape, frame: int) -> str:
    """That a frame lies outside of a shape's lifetime, and where that is changed."""
    return tr(
        "{name!r} does not exist on frame {frame}: its lifetime is in the Shape panel.", name=shape.name, frame=frame
    )


def keys_beside(shapes: Iterable[RotoShape], clip: Clip, before: Clip | None = None) -> str:
    """A sentence where shapes have keys, but none on the clip: they came from another shot, and never move here.

    Also where some lie beside it that lay on the clip `before`, of which this one has taken the place.
    """
    frames = [frame for shape in shapes for frame in shape.frames]
    lost = [frame for frame in frames if before and frame in before.frame_range and frame not in clip.frame_range]
    if frames and not any(frame in clip.frame_range for frame in frames):
        return tr(
            "The keys lie on frames {low} to {high}, none of them on the clip's {first} to {last}; "
            "<key.shift> moves them.",
            low=min(frames),
            high=max(frames),
            first=clip.first,
            last=clip.last,
        )
    if not lost:
        return ""
    return tr(
        "Keys on frames {low} to {high} lie beside the clip now, which has {first} to {last}; <key.shift> shifts keys.",
        low=min(lost),
        high=max(lost),
        first=clip.first,
        last=clip.last,
    )


def outdated_by(before: Project, after: Project) -> str:
    """A sentence where an edit made tracked frames of shapes stale that it left alone: it added or deleted parts of
    their objects, or stacked them otherwise.

    Empty where no shape that the edit left alone has tracked frames that held `before` and do not `after`.
    """
    there = {shape.id: shape for shape in after.shapes}
    left = [shape for shape in before.shapes if there.get(shape.id) is shape and _is_tracked(shape)]
    if not left:
        return ""
    held, now = stamps_of(before), stamps_of(after)
    joined = [shape for shape in left if now.together(shape) != held.together(shape)]  # to compare all keys takes long
    names = _first(s.name for s in joined if not set(now.stale_frames(s)) <= set(held.stale_frames(s)))
    if not names:
        return ""
    told = _listed(names)
    ids = {shape.id for shape in before.shapes}
    if there.keys() == ids:
        return tr(
            "Tracked frames of {names} are out of date: what hides what goes by the order in the list.", names=told
        )
    if there.keys() <= ids:
        return tr("Tracked frames of {names} are out of date: what is gone was a part of its object.", names=told)
    return tr(
        "Tracked frames of {names} are out of date: what is new lies on it and counts as a part of its object. Move it "
        "away, or solve it by itself: <object.apart>.",
        names=told,
    )


def outdated_by_blend(before: Project, after: Project) -> str:
    """A sentence where shapes that join others in another way now, or that are joined so, have frames that were tracked
    as before; empty where none has.
    """
    pairs = list(zip(before.shapes, after.shapes, strict=True))
    if all(old.blend is new.blend for old, new in pairs):
        return ""
    held, now = stamps_of(before), stamps_of(after)
    changed = {old.id for old, new in pairs if old.blend is not new.blend}
    joined = [  # to compare all keys takes long
        (old, new)
        for old, new in pairs
        if not changed.isdisjoint(each.id for each in (*held.together(old), *now.together(new)))
    ]
    names = _first(
        old.name
        for old, new in joined
        if _is_tracked(old) and not set(now.stale_frames(new)) <= set(held.stale_frames(old))
    )
    if not names:
        return ""
    return tr("Tracked frames of {names} are out of date: shapes join otherwise now.", names=_listed(names))


def _first(names: Iterable[str]) -> list[str]:
    """As many names as are told, and one more that says whether there are others: no more shapes are asked."""
    return list(islice(names, MOST_NAMES + 1))


def _listed(names: Sequence[str]) -> str:
    """The first few names; a mark tells that there are more."""
    return ", ".join(names[:MOST_NAMES]) + (" …" if len(names) > MOST_NAMES else "")


def _is_tracked(shape: RotoShape) -> bool:
    return any(key.origin is Origin.ENGINE for key in shape.keys)
