"""What a right click in the viewer means: the point, shape or empty background under it, which it selects."""

from __future__ import annotations

from roam_core.roto import Project

from ..actions.context import Place
from ..model.view_state import ViewState
from .hit_test import PointHit, hit, shape_around
from .tool import Pointer


def taken_up(view: ViewState, project: Project, pointer: Pointer) -> Place:
    """Select what lies under the pointer, unless it is selected already, and tell what it is.

    Inside of a selected shape that shape is meant; elsewhere the selection stays as it is.
    """
    selection, project = view.selection, view.solo.seen(project)
    found = hit(project, view.frame, selection, pointer.position, pointer.pixel)
    if found is None:
        inside = shape_around(project, view.frame, selection, pointer.position)
        return Place.BACKGROUND if inside is None else Place.SHAPE
    if isinstance(found, PointHit):
        point = found.shape_id, found.index
        if point not in selection.points:
            view.select(selection.shapes, frozenset({point}))
        return Place.POINT
    if found.shape_id not in selection.shapes or selection.points:
        kept = selection.shapes if found.shape_id in selection.shapes else frozenset({found.shape_id})
        view.select(kept)
    return Place.SHAPE
