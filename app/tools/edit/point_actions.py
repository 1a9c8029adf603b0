"""PointActions: what keys and menus do to the selected points. Each action is one undo step."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace

from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.roto import Project, RotoShape, Spline, edit
from roam_core.roto.keying import Change, reshape

from ...features.verbs.shapes import delete, rows_in_hand
from ...model.document import Document
from ...model.reasons import outdated_by, why_kept, why_not
from ...model.shown import editable_shapes
from ...model.view_state import Selection, ViewState, selected_shapes
from ...translation import N_, sentence_of, tr
from ..reshape import grab_selection, grabbed_indices, pixel_aspect, selected_indices, smoothed
from ..settling import settled

OPENED = N_("{name} is open now and has no matte; <points.toggle_closed> closes it.")
CLOSED = N_("{name} is closed now.")


class PointActions:
    """Actions on the selection of the view state, for menus and keys.

    Where shapes are selected but no point of any, an action takes all their points. Locked and hidden shapes are left
    alone; what cannot be done is said in the status bar.
    """

    def __init__(self, document: Document, view_state: ViewState) -> None:
        self._document, self._view = document, view_state

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "points.delete": self.delete,
            "points.smooth": self.smooth,
            "points.cusp": self.cusp,
            "points.toggle_closed": self.toggle_closed,
            "points.select_all": self.select_all,
            "points.next": lambda: self.cycle(1),
            "points.previous": lambda: self.cycle(-1),
        }

    def delete(self) -> None:
        """Delete the selected points; a shape goes whole when all its points are selected, or no point at all is.

        So does a selected layer, with what lies in it.
        """
        project, view = self._document.project, self._view
        selected = view.selection
        if not view.selection.points and any(project.has(layer_id) for layer_id in view.layers):
            delete(self._document, view, rows_in_hand(project, view))
            view.select(frozenset(shape.id for shape in selected_shapes(self._document.project, view.selection)))
            return
        shapes = self._shapes()
        if not shapes:
            self._say_why()
            return
        whole = [s for s in shapes if self._point_count(s) in (0, s.point_count)]
        after, removed, refused = edit.remove_items(project, [shape.id for shape in whole]), 0, ""
        for shape in shapes:
            if shape not in whole:
                indices = selected_indices(shape, view.selection)
                try:
                    after = after.with_shape(edit.delete_points(shape, indices))
                    removed += len(indices)
                except RoamError as error:  # the others have enough left
                    refused = refused or sentence_of(error)
        gone = {shape.id for shape in whole}
        self._document.apply(_deleted(removed, len(whole)), after)
        if after != project:
            # The points that stay have other numbers: none of them is selected.
            view.select(frozenset(shape_id for shape_id in view.selection.shapes if shape_id not in gone))
        if told := refused or self._why_kept(project, selected) or (outdated_by(project, after) if whole else ""):
            view.say(told)

    def smooth(self) -> None:
        """Give the points tangents along the chord of their neighbours."""
        aspect = pixel_aspect(self._document.project)
        self._reshape(
            lambda count: tr("Smooth %n point(s)", "", count),
            lambda shape, points, chosen: smoothed(points, chosen, shape.closed, aspect),
        )

    def cusp(self) -> None:
        """Draw the points' handles in, so that the outline has corners there."""
        self._reshape(
            lambda count: tr("Cusp %n point(s)", "", count),
            lambda _shape, points, chosen: edit.cusp_points(points, chosen),
        )

    def nudge(self, dx: float, dy: float, merge_key: str = "") -> None:
        """Move the points by image pixels. Nudges with one `merge_key` (a held key) are one undo step."""
        project = self._document.project
        grab = grab_selection(project, self._view)
        if not grab.weights:
            self._say_why()
            return
        moved = grab.settled(project, grab.moved(project, (dx, dy)))
        self._document.apply(tr("Nudge %n point(s)", "", grab.point_count), moved, merge_key)
        if kept := self._why_kept(project, self._view.selection):
            self._view.say(kept)

    def cycle(self, step: int) -> None:
        """Select the point `step` further along the shape (backwards when negative)."""
        shapes = self._shapes()
        if not shapes:
            self._say_why()
            return
        shape = next((s for s in shapes if selected_indices(s, self._view.selection)), shapes[0])
        chosen = selected_indices(shape, self._view.selection)
        here = (chosen[-1] if step > 0 else chosen[0]) if chosen else (-1 if step > 0 else 0)
        index = (here + step) % shape.point_count
        self._view.select(self._view.selection.shapes, frozenset({(shape.id, index)}))

    def toggle_closed(self) -> None:
        """Close the open selected shapes and open the closed ones, and say so; of one that cannot be closed, why."""
        project, refused, changed = self._document.project, "", list[RotoShape]()
        for shape in self._shapes():
            try:
                project = project.with_shape(edit.toggle_closed(shape))
            except RoamError as error:
                refused = refused or sentence_of(error)
            else:
                changed.append(shape)
        if len(changed) == 1:
            self._view.say(tr(OPENED if changed[0].closed else CLOSED, name=changed[0].name))
        elif changed:
            self._view.say(tr("%n shape(s) is/are opened or closed now.", "", len(changed)))
        self._apply(tr("Open or close shape"), project)
        if refused:
            self._view.say(refused)

    def select_all(self) -> None:
        """Select all points of the selected shapes, or of every shape where none is selected."""
        is_any_selected = bool(self._view.selection.shapes)
        shapes = self._shapes() if is_any_selected else self._in_sight()
        if is_any_selected and not shapes:
            self._say_why()
            return
        points = frozenset((shape.id, index) for shape in shapes for index in range(shape.point_count))
        self._view.select(self._view.selection.shapes, points)

    def _reshape(
        self, told: Callable[[int], str], function: Callable[[RotoShape, Array, Iterable[int]], Array]
    ) -> None:
        """Apply `function(shape, points, indices)` to the selected points, on the keys that edits reach.

        `told` names the step by the number of points.
        """
        project, view = self._document.project, self._view
        keying = view.editing.keying(view.play_range)
        chosen, count = grabbed_indices(view.solo.seen(project), view.frame, view.selection), 0
        for shape_id, indices in chosen.items():
            shape = project.shape(shape_id)
            if shape.spline is Spline.BSPLINE:
                view.say(
                    tr(
                        "{name!r} is a B-spline, which is smooth everywhere; make it Bezier for corners.",
                        name=shape.name,
                    )
                )
                continue
            change = _change(shape, indices, function)
            project = project.with_shape(reshape(shape, view.frame, change, keying))
            count += len(indices)
        project = settled(self._document.project, project, chosen, view.frame, keying)
        self._apply(told(count), project)

    def _apply(self, text: str, project: Project) -> None:
        if not self._shapes():
            self._say_why()
            return
        self._document.apply(text, project)
        if kept := self._why_kept(self._document.project, self._view.selection):
            self._view.say(kept)

    def _shapes(self) -> list[RotoShape]:
        """The selected shapes that may be edited; those with selected points where any point is selected."""
        selection = self._view.selection
        shapes = [s for s in self._in_sight() if s.id in selection.shapes]
        return [s for s in shapes if self._point_count(s)] if selection.points else shapes

    def _in_sight(self) -> list[RotoShape]:
        """The shapes that may be edited here."""
        return editable_shapes(self._view.solo.seen(self._document.project), self._view.frame)

    def _point_count(self, shape: RotoShape) -> int:
        return len(selected_indices(shape, self._view.selection))

    def _why_kept(self, project: Project, selection: Selection) -> str:
        """What kept the first of the shapes whose points are selected (all, where none is); empty where nothing did."""
        owners = {shape_id for shape_id, _ in selection.points} or selection.shapes
        chosen = [shape for shape in project.shapes if shape.id in owners]
        return why_kept(project, chosen, range(self._view.frame, self._view.frame + 1), self._view.solo)

    def _say_why(self) -> None:
        """Say why nothing happened."""
        self._view.say_here(why_not(self._document.project, self._view))


def _deleted(points: int, shapes: int) -> str:
    """What a step is called that deletes so many points, and shapes as a whole."""
    words = (tr("Delete %n point(s)", "", points), points), (tr("Delete %n shape(s)", "", shapes), shapes)
    return ", ".join(text for text, number in words if number)


def _change(
    shape: RotoShape, indices: list[int], function: Callable[[RotoShape, Array, Iterable[int]], Array]
) -> Change:
    """`function` on the points `indices` of any key."""
    return lambda outline: replace(outline, points=function(shape, outline.points, indices))
