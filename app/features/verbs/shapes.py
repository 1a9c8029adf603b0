"""What menus, keys and panels do to whole shapes and their keys: each one edit of the document, one undo step."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from roam_core.errors import RoamError
from roam_core.roto import Layer, Project, RotoShape, edit
from roam_core.roto.copies import duplicated
from roam_core.roto.layers import top_items

from ...model.document import Document
from ...model.reasons import LOCKED_STAYS, does_not_exist, outdated_by
from ...model.shown import editable_shapes
from ...model.view_state import ViewState, selected_shapes
from ...translation import N_, sentence_of, tr

NOTHING_SELECTED = N_("Select a shape first: click it in the viewer or in the list.")
ALL_LOCKED = N_("What is selected is locked; unlock it first (<shape.lock>).")


class ShapeVerbs:
    """The verbs on the selected shapes. What cannot be done is said in the status bar."""

    def __init__(self, document: Document, view_state: ViewState) -> None:
        self._document, self._view = document, view_state

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "shape.select_all": self.select_all,
            "shape.select_none": self.select_none,
            "shape.duplicate": self.duplicate,
            "shape.delete": lambda: delete(
                self._document, self._view, rows_in_hand(self._document.project, self._view)
            ),
            "shape.lock": self.toggle_lock,
            "shape.hide": self.hide,
            "shape.show_all": self.show_all,
            "key.set": self.set_key,
            "key.set_points": self.set_key_of_points,
            "key.delete": self.delete_key,
            "track.delete_engine_keys": self.delete_engine_keys,
        }

    def select_all(self) -> None:
        """Select the shapes in sight on this frame that are not locked."""
        shapes = editable_shapes(self._view.solo.seen(self._document.project), self._view.frame)
        self._view.select(frozenset(shape.id for shape in shapes))
        if not shapes:
            self._view.say_here(tr("No shape is in sight here that could be selected; show or unlock some."))

    def select_none(self) -> None:
        """Let go of all shapes, points and layers."""
        self._view.select(frozenset(), layers=frozenset())

    def set_key(self) -> None:
        """Make the selected shapes, as they are on this frame, artist keys; those that do not exist there get none."""
        frame = self._view.frame
        if self._is_any_there():
            self._edit_each(
                tr("Set key"), lambda shape: edit.key_here(shape, frame) if shape.exists_at(frame) else shape
            )

    def set_key_of_points(self) -> None:
        """Make the selected points, as they are on this frame, the artist's; a run may derive the others anew."""
        frame, points, selected = self._view.frame, self._view.selection.points, self._selected()
        if not points and (not selected or self._free(selected)):
            self._view.say(tr("Select the points that are right here first; a run then derives the others anew."))
            return
        if not self._is_any_there():
            return

        def keyed(shape: RotoShape) -> RotoShape:
            if not shape.exists_at(frame):
                return shape
            return edit.key_points(shape, frame, [index for shape_id, index in points if shape_id == shape.id])

        self._edit_each(tr("Set key for points"), keyed)

    def delete_key(self) -> None:
        """Delete the selected shapes' keys on this frame."""
        frame, project, selected = self._view.frame, self._document.project, self._selected()
        if selected and not any(project.shape(shape_id).key_at(frame) for shape_id in selected):
            self._view.say_here(tr("There is no key on frame {frame} to delete.", frame=frame))
            return
        self._edit_each(tr("Delete key"), lambda shape: edit.delete_keys(shape, [frame]))

    def delete_engine_keys(self) -> None:
        """Delete the tracked frames of the selected shapes: all, or those between in and out where these are set."""
        project, (first, stop) = self._document.project, self._view.play_range
        is_whole = project.clip is None or (first, stop) == (project.clip.first, project.clip.last + 1)
        frames = None if is_whole else range(first, stop)
        free = [project.shape(shape_id) for shape_id in self._free(self._selected())]
        gone = sum(len(shape.keys) - len(edit.delete_engine_keys(shape, frames).keys) for shape in free)
        if gone:
            self._edit_each(tr("Delete tracked frames"), lambda shape: edit.delete_engine_keys(shape, frames))
            between = tr("Deleted %n tracked frame(s) from {first} to {last}.", "", gone, first=first, last=stop - 1)
            told = tr("Deleted %n tracked frame(s).", "", gone) if is_whole else between
            self._view.say(f"{told} {tr(LOCKED_STAYS)}" if len(free) < len(self._selected()) else told)
        elif free:
            none = tr("Between in and out, {first} to {last}, no frame is tracked.", first=first, last=stop - 1)
            self._view.say_here(tr("No frame is tracked yet.") if is_whole else none)

    def delete(self) -> None:
        delete(self._document, self._view, self._selected())

    def duplicate(self) -> None:
        """Copies of the selected layers and shapes on top of what holds them, selected in their place."""
        if rows := self._rows():
            project, copies = duplicated(self._document.project, rows)
            outdated = outdated_by(self._document.project, project)
            self._document.apply(tr("Duplicate"), project)
            select_items(self._document, self._view, copies)
            if told := f"{outdated} {told_of_locked(project, copies)}".strip():
                self._view.say(told)

    def toggle_lock(self) -> None:
        """Lock or unlock the selected layers and shapes; of one that a layer around it keeps locked, that is said."""
        rows = self._rows()
        toggle(self._document, "locked", rows)
        project = self._document.project
        for item in map(project.find, rows):
            around = next((layer for layer in project.layers_above(item.id) if layer.locked), None)
            if around is not None:
                told = tr(
                    "{name!r} lies in {layer!r}, which is locked: unlock that layer in the list.",
                    name=item.name,
                    layer=around.name,
                )
                self._view.say_here(told)
                return

    def hide(self) -> None:
        project = self._document.project
        for item_id in self._rows():
            project = edit.set_properties(project, item_id, visible=False)
        self._document.apply(tr("Hide"), project)

    def show_all(self) -> None:
        project = self._document.project
        for item in project.root.items():
            project = edit.set_properties(project, item.id, visible=True)
        self._document.apply(tr("Show all"), project)

    def _edit_each(self, text: str, verb: Callable[[RotoShape], RotoShape]) -> None:
        """Do it with each of the selected shapes that are not locked; says of the first why it cannot be done, or that
        some are locked.
        """
        project, refused, edited = self._document.project, "", list[RotoShape]()
        selected = self._selected()
        free = self._free(selected)
        for shape_id in free:
            try:
                edited.append(verb(project.shape(shape_id)))
            except RoamError as error:
                refused = refused or sentence_of(error)
        self._document.apply(text, project.with_shapes(edited))
        if refused or 0 < len(free) < len(selected):
            self._view.say(refused or tr(LOCKED_STAYS))

    def _is_any_there(self) -> bool:
        """Whether one of the selected shapes exists on this frame, or none is selected; says so where they do not."""
        shapes, frame = selected_shapes(self._document.project, self._view.selection), self._view.frame
        if not shapes or any(shape.exists_at(frame) for shape in shapes):
            return True
        self._view.say_here(does_not_exist(shapes[0], frame))
        return False

    def _free(self, selected: list[str]) -> list[str]:
        """Those of the selected shapes that are not locked; says so when all are."""
        free = [shape_id for shape_id in selected if not self._document.project.is_locked(shape_id)]
        if selected and not free:
            self._view.say_here(tr(ALL_LOCKED))
        return free

    def _rows(self) -> list[str]:
        """The selected layers, and the selected shapes that lie in none of them; says so when there is none."""
        return rows_in_hand(self._document.project, self._view) or self._selected()

    def _selected(self) -> list[str]:
        """The selected shapes in the order of stacking; says so when there is none."""
        ids = [shape.id for shape in selected_shapes(self._document.project, self._view.selection)]
        if not ids:
            self._view.say_here(tr(NOTHING_SELECTED))
        return ids


def rows_in_hand(project: Project, view: ViewState) -> list[str]:
    """The selected layers, and the selected shapes that lie in none of them, bottom first."""
    return top_items(project, view.layers | view.selection.shapes)


def told_of_locked(project: Project, copies: Iterable[str]) -> str:
    """That copies are locked, as what they were made of; empty where none is."""
    is_any = any(project.holds_locked(item_id) for item_id in copies)
    return tr("What is locked gives locked copies; <shape.lock> unlocks them.") if is_any else ""


def select_items(document: Document, view: ViewState, item_ids: Iterable[str]) -> None:
    """Select layers, with the shapes in them, and shapes."""
    items = [document.project.find(item_id) for item_id in item_ids]
    layers = [item for item in items if isinstance(item, Layer)]
    shapes = {item.id for item in items} - {layer.id for layer in layers}
    shapes |= {shape.id for layer in layers for shape in layer.shapes()}
    view.select(frozenset(shapes), layers=frozenset(layer.id for layer in layers))


def delete(document: Document, view: ViewState, item_ids: Iterable[str], text: str = "") -> None:
    """Delete layers and shapes, but for what is locked or holds what is; `text` names the step.

    Says so where there is nothing to delete.
    """
    ids = list(item_ids)
    if not ids:
        view.say_here(tr(NOTHING_SELECTED))
        return
    free = [item_id for item_id in ids if not document.project.holds_locked(item_id)]
    before = document.project
    if free:
        document.apply(text or tr("Delete"), edit.remove_items(before, free))
    if len(free) < len(ids):
        view.say(tr(LOCKED_STAYS))
    elif outdated := outdated_by(before, document.project):
        view.say(outdated)


def toggle(document: Document, switch: str, item_ids: Iterable[str]) -> None:
    """Turn `visible` or `locked` of layers and shapes: all to the opposite of the first one's."""
    project, ids = document.project, list(item_ids)
    if ids:
        value = not getattr(project.find(ids[0]), switch)
        for item_id in ids:
            project = edit.set_properties(project, item_id, **{switch: value})
        names = {"visible": (tr("Hide"), tr("Show")), "locked": (tr("Unlock"), tr("Lock"))}
        document.apply(names[switch][value], project)
