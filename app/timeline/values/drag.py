"""KeyDrag: chosen keys under the hand, in time and value: previewed as they move, one undo step on release."""

from __future__ import annotations

from collections.abc import Callable

from roam_core.roto import Project
from roam_core.roto.value_curves import ValuePlace

from ...model.document import Document
from ...translation import tr
from ..axis import TimeAxis
from .selection import ValueSelection
from .verbs import LOCKED, unlocked

Moved = Callable[[Project, frozenset[ValuePlace], int, float], Project]
Copied = Callable[[Project, frozenset[ValuePlace], int], Project]


class KeyDrag:
    """The chosen keys between press and release.

    `moved` gives the project with keys shifted in time and value, `copied` with copies of them shifted in time.
    """

    def __init__(
        self, document: Document, axis: TimeAxis, chosen: ValueSelection, moved: Moved, copied: Copied
    ) -> None:
        self._document, self._axis, self._chosen, self._moved, self._copied = document, axis, chosen, moved, copied
        self._places = unlocked(document.project, chosen.places)
        self._shown: tuple[int, float, bool] = (0, 0.0, False)
        self.frames = 0
        """By how many frames the chosen keys are shifted where they are shown."""
        if not self._places:
            axis.view_state.say(tr(LOCKED))

    def to(self, frames: int, amount: float, *, copies: bool = False) -> None:
        """Preview the keys, or copies of them, shifted by whole frames, none out of the clip, and keys by an amount."""
        frames = self._inside(frames)
        if (frames, amount, copies) == self._shown or not self._places:
            return
        self._shown, self.frames = (frames, amount, copies), frames
        project, preview = self._document.project, None
        if frames and copies:
            preview = self._copied(project, self._places, frames)
        elif not copies and (frames or amount):
            preview = self._moved(project, self._places, frames, amount)
        self._axis.view_state.set_preview(preview)

    def finish(self) -> None:
        """Make what was previewed an edit."""
        preview, (frames, amount, copies) = self._axis.view_state.preview, self._shown
        self._axis.view_state.set_preview(None)
        if preview is not None:
            moving = tr("Change keys") if amount else tr("Move keys")
            self._document.apply(tr("Copy keys") if copies else moving, preview)
            moved = frozenset((item_id, name, frame + frames) for item_id, name, frame in self._places)
            self._chosen.select(moved)

    def cancel(self) -> None:
        """Leave everything as it was before the press."""
        self._axis.view_state.set_preview(None)

    def _inside(self, frames: int) -> int:
        own = [frame for _, _, frame in self._places]
        first, stop = self._axis.scale.clip
        if not own:
            return 0
        return max(min(frames, max(stop - 1 - max(own), 0)), min(first - min(own), 0))
