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
        self._asked: tuple[int, float, bool] = (0, 0.0, False)
        self._made: tuple[Project, tuple[int, float, bool]] | None = None
        """What the preview was made of: within a frame the pointer moves often, and nothing with it."""
        self.frames = 0
        """By how many frames the chosen keys are shifted where they are shown."""
        if not self._places:
            axis.view_state.say(tr(LOCKED))

    def to(self, frames: int, amount: float, *, copies: bool = False) -> None:
        """Preview the keys, or copies of them, shifted by whole frames, none out of the clip, and keys by an amount."""
        self._asked = frames, amount, copies
        self._preview()

    def finish(self) -> None:
        """Make what was previewed an edit."""
        self._preview()
        preview, (_, amount, copies), frames = self._axis.view_state.preview, self._asked, self.frames
        self._axis.view_state.set_preview(None)
        if preview is not None:
            moving = tr("Change keys") if amount else tr("Move keys")
            self._document.apply(tr("Copy keys") if copies else moving, preview)
            moved = frozenset((item_id, name, frame + frames) for item_id, name, frame in self._places)
            self._chosen.select(moved)

    def cancel(self) -> None:
        """Leave everything as it was before the press."""
        self._axis.view_state.set_preview(None)

    def _preview(self) -> None:
        """Show what was asked for, of the project as it is now: frames tracked meanwhile stay."""
        project, (asked, amount, copies) = self._document.project, self._asked
        self._places &= unlocked(project, self._chosen.places)
        frames = self._inside(asked)
        if self._made == (project, (frames, amount, copies)):
            return
        self._made, self.frames, preview = (project, (frames, amount, copies)), frames, None
        if frames and copies and self._places:
            preview = self._copied(project, self._places, frames)
        elif not copies and (frames or amount) and self._places:
            preview = self._moved(project, self._places, frames, amount)
        self._axis.view_state.set_preview(preview)

    def _inside(self, frames: int) -> int:
        own = [frame for _, _, frame in self._places]
        first, stop = self._axis.scale.clip
        if not own:
            return 0
        return max(min(frames, max(stop - 1 - max(own), 0)), min(first - min(own), 0))
