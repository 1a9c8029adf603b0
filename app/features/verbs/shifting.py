"""Shift in time: everything of the project, or what is selected, so many frames later or earlier."""

from __future__ import annotations

from collections.abc import Callable, Collection

from PySide6.QtWidgets import QWidget

from roam_core.errors import RoamError
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.propagate.shapes.restamping import renumbered
from roam_core.roto import Clip, Project
from roam_core.roto.layers import only
from roam_core.roto.shifting import frames_held, shifted

from ...model.document import Document
from ...model.reasons import LOCKED_STAYS
from ...model.view_state import ViewState
from ...translation import sentence_of, tr
from ...widgets.asking import ask
from .shapes import ALL_LOCKED, rows_in_hand
from .shift_dialog import ShiftDialog


class Shifting:
    """The verb on the whole project or on the selected layers and shapes; what is asked is asked above `window`."""

    def __init__(self, window: QWidget, document: Document, view_state: ViewState) -> None:
        self._window, self._document, self._view = window, document, view_state

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"key.shift": self.ask}

    def ask(self) -> None:
        """Ask by how many frames, and whether all of the project or what is selected; says so if there is nothing."""
        project, rows = self._document.project, rows_in_hand(self._document.project, self._view)
        held = frames_held(project)
        if not held:
            self._view.say(tr("There is nothing to shift: the project has neither keys nor notes."))
            return
        selected = frames_held(project, rows) if rows else []
        dialog = ShiftDialog(held, selected, project.clip, self._window)
        ask(
            dialog,
            lambda: self.shift(dialog.offset, rows if dialog.is_selected_alone else None),
            self._document.replaced,
        )

    def shift(self, offset: int, item_ids: Collection[str] | None = None) -> None:
        """Shift these layers and shapes but for the locked ones, or with None everything, as one undo step."""
        project = self._document.project
        chosen = item_ids
        if item_ids is not None:
            chosen = [item_id for item_id in item_ids if project.has(item_id) and not project.holds_locked(item_id)]
            if not chosen:
                self._view.say(tr(ALL_LOCKED))
                return
        try:
            after = shifted(project, offset, chosen)
        except RoamError as error:
            self._view.say(sentence_of(error))
            return
        self._document.apply(tr("Shift in time"), after)
        stale = tr("Tracked frames are out of date: they were solved on other pictures.")
        is_kept = chosen is not None and len(chosen) < sum(map(project.has, item_ids or ()))
        told = (_told(offset), stale if _has_stale(after, chosen) else "", tr(LOCKED_STAYS) if is_kept else "")
        self._view.say(" ".join(filter(None, told)))


def follow_numbers(document: Document, view_state: ViewState, before: Clip) -> None:
    """Shift everything to the numbers that the pictures of the clip `before` have now, as one undo step.

    Tracked frames are as up to date as they were.
    """
    clip = document.project.require_clip()
    offset = clip.first - before.first
    document.apply(tr("Shift to the new numbers"), renumbered(document.project, before))
    view_state.say(f"{_told(offset)} {tr('Tracked frames are as up to date as they were.')}")


def _told(offset: int) -> str:
    later, earlier = (
        tr("Shifted %n frame(s) later.", "", offset),
        tr("Shifted %n frame(s) earlier.", "", -offset),
    )
    return later if offset > 0 else earlier


def _has_stale(project: Project, item_ids: Collection[str] | None) -> bool:
    """Whether shapes among these layers and shapes, or all, have tracked keys that are out of date."""
    stamps = Stamps.of(project.shapes, project.clip)
    return any(stamps.is_stale(shape, key) for shape in only(project, item_ids).shapes for key in shape.keys)
