"""Why nothing of what is selected is edited on this frame: a sentence for the status bar."""

from __future__ import annotations

from roam_core.roto import Project

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
