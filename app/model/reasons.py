"""Why nothing is edited, or seen to move: sentences for the status bar."""

from __future__ import annotations

from collections.abc import Iterable

from roam_core.roto import Clip, Project, RotoShape

from ..translation import N_, tr
from .shown import editable_shapes
from .view_state import ViewState, selected_shapes

NOTHING_SELECTED = N_("Select a shape or some of its points first.")


def why_not(project: Project, view: ViewState) -> str:
    """What keeps the first of the selected shapes that may not be edited here, or that none is selected."""
    free = {shape.id for shape in editable_shapes(project, view.frame)}
    kept = next((shape for shape in selected_shapes(project, view.selection) if shape.id not in free), None)
    if kept is None:
        return tr(NOTHING_SELECTED)
    if not kept.exists_at(view.frame):
        return tr(
            "{name!r} does not exist on frame {frame}: its lifetime is in the Shape panel.",
            name=kept.name,
            frame=view.frame,
        )
    return tr("{name!r} is locked or hidden; unlock and show it to edit it.", name=kept.name)


def keys_beside(shapes: Iterable[RotoShape], clip: Clip) -> str:
    """A sentence where shapes have keys, but none on the clip: they came from another shot, and never move here."""
    frames = [frame for shape in shapes for frame in shape.frames]
    if not frames or any(frame in clip.frame_range for frame in frames):
        return ""
    return tr(
        "The keys lie on frames {low} to {high}, none of them on the clip's {first} to {last}.",
        low=min(frames),
        high=max(frames),
        first=clip.first,
        last=clip.last,
    )
