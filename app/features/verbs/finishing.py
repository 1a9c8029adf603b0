"""What ends every drawing tool: the shape goes into the document, is selected, and the select tool takes over."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtGui import QColor

from roam_core.arrays import Array
from roam_core.roto import Layer, Project, RotoShape, Spline, edit
from roam_core.roto.found import add_found
from roam_core.roto.layers import home_for_new
from roam_core.roto.project import ROOT

from ...model.document import Document
from ...model.reasons import outdated_by
from ...model.view_state import ViewState
from ...translation import tr
from ..navigation import clip_frames
from ..tracking import last_to_track


def next_colour(project: Project) -> QColor:
    """The colour that the next new shape will have."""
    return QColor.fromRgbF(*project.free_colour())


def finish_shape(
    document: Document,
    view_state: ViewState,
    tool: str,
    control_points: Array,
    frame: int,
    *,
    closed: bool = True,
    spline: Spline = Spline.BEZIER,
) -> None:
    """Make `control_points (P, 3, 2)` a new shape with an artist key at `frame`, as one undo step.

    Where `tool`, which drew it, is still in the hand, the select tool takes its place to adjust the shape.
    """
    home = home_in_hand(document.project, view_state)
    project, shape = edit.new_shape(
        document.project, control_points, frame, closed=closed, spline=spline, layer_id=home.id
    )
    outdated = outdated_by(document.project, project)
    document.apply(tr("Draw shape"), project)
    hand_over(view_state, tool, frozenset({shape.id}))
    name = _named(shape.name, home)
    said = tr("{name} is drawn: drag its points to adjust it.", name=name)
    said_open = tr(
        "{name} is drawn: drag its points to adjust it, it is open, <points.toggle_closed> closes it.", name=name
    )
    _tell(view_state, outdated, f"{said} {_tracks(document, view_state)}" if closed else said_open)


def put_in(document: Document, view_state: ViewState, tool: str, shapes: Sequence[RotoShape], text: str) -> None:
    """Make `shapes` that were found in a picture or a mask part of the project, as one undo step `text`.

    What the artist draws or drags by now goes on: then they are not selected, and the tool stays in the hand.
    """
    home = home_in_hand(document.project, view_state)
    project, ids = add_found(document.project, shapes, home_id=home.id)
    outdated = outdated_by(document.project, project)
    document.apply(text, project)
    if not view_state.is_in_use:
        hand_over(view_state, tool, frozenset(ids))
    name = _named(project.shape(ids[0]).name, home)
    one, tracks = tr("{name} is fitted: drag the points to adjust.", name=name), _tracks(document, view_state)
    all_ = tr("{count} shapes are fitted: drag the points to adjust.", count=len(ids))
    _tell(view_state, outdated, f"{one if len(ids) == 1 else all_} {tracks}")


def home_in_hand(project: Project, view_state: ViewState) -> Layer:
    """The layer that takes what is drawn: the selected one, or the one of the selected shapes."""
    return home_for_new(project, view_state.layers | view_state.selection.shapes)


def _named(name: str, home: Layer) -> str:
    return name if home.id == ROOT.id else tr("{name} in {layer}", name=name, layer=home.name)


def hand_over(view_state: ViewState, tool: str, shape_ids: frozenset[str]) -> None:
    """Select the new shapes, and take the select tool where `tool` is still in the hand."""
    view_state.select(shape_ids)
    if view_state.tool == tool:
        view_state.set_tool("select")


def _tracks(document: Document, view_state: ViewState) -> str:
    """Which key tracks on from the frame that is shown: back where no frame follows; empty where there is no other."""
    clip, frame = clip_frames(document.project, view_state.frame), view_state.frame
    if last_to_track(view_state, clip, 1) > frame:
        return tr("<track.forward> tracks forward.")
    return tr("<track.backward> tracks back.") if last_to_track(view_state, clip, -1) < frame else ""


def _tell(view_state: ViewState, outdated: str, advice: str) -> None:
    """What the new shape made out of date; else what to do with it."""
    if outdated:
        view_state.say(outdated)
    else:
        view_state.advise(advice.rstrip())
