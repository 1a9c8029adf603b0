"""KeyDrag: chosen keys under the hand, in time and value: previewed as they move, one undo step on release."""

from __future__ import annotations

from collections.abc import Mapping

from roam_core.roto import Project

from ...model.document import Document
from ...translation import tr
from ..axis import TimeAxis
from ..keys.stretch import Stretch, told
from ..keys.verbs import count_of
from .selection import ValueSelection
from .verbs import LOCKED, ValueVerbs, unlocked


class KeyDrag:
    """The chosen keys between press and release. `verbs` makes the projects that are previewed."""

    def __init__(self, document: Document, axis: TimeAxis, chosen: ValueSelection, verbs: ValueVerbs) -> None:
        self._document, self._axis, self._chosen, self._verbs = document, axis, chosen, verbs
        self._places = unlocked(document.project, chosen.places)
        self._asked: tuple[int, float, bool] = (0, 0.0, False)
        self._stretch: tuple[Stretch, float] | None = None
        self._goes: Mapping[int, int] = {}
        self._made: tuple[Project, object] | None = None
        """What the preview was made of: within a frame the pointer moves often, and nothing with it."""
        self.frames = 0
        """By how many frames the chosen keys are shifted where they are shown."""
        if not self._places:
            axis.view_state.say(tr(LOCKED))

    def to(self, frames: int, amount: float, *, copies: bool = False) -> None:
        """Preview the keys, or copies of them, shifted by whole frames, none out of the clip, and keys by an amount."""
        self._asked = frames, amount, copies
        self._preview()

    def stretch(self, stretch: Stretch, x: float) -> None:
        """Preview the keys stretched in time by a bracket that is at the pixel `x`."""
        self._stretch = stretch, x
        self._preview()
        if self._places:
            self._axis.view_state.say(told(count_of(self._places), self._goes))

    def frame_of(self, frame: int) -> int:
        """Where a chosen key of a frame is shown."""
        return self._goes.get(frame, frame + self.frames)

    def finish(self) -> None:
        """Make what was previewed an edit."""
        self._preview()
        preview, (_, amount, copies) = self._axis.view_state.preview, self._asked
        self._axis.view_state.set_preview(None)
        if preview is not None:
            moving = tr("Change keys") if amount else tr("Move keys") if self._stretch is None else tr("Stretch keys")
            self._document.apply(tr("Copy keys") if copies else moving, preview)
            self._chosen.select(
                frozenset((item_id, name, self.frame_of(frame)) for item_id, name, frame in self._places)
            )

    def cancel(self) -> None:
        """Leave everything as it was before the press."""
        self._axis.view_state.set_preview(None)

    def _preview(self) -> None:
        """Show what was asked for, of the project as it is now: frames tracked meanwhile stay."""
        project, (asked, amount, copies) = self._document.project, self._asked
        self._places &= unlocked(project, self._chosen.places)
        if self._stretch is not None:
            self._preview_stretched(*self._stretch)
            return
        frames = self._inside(asked)
        if self._made == (project, (frames, amount, copies)):
            return
        self._made, self.frames, preview = (project, (frames, amount, copies)), frames, None
        if frames and copies and self._places:
            there = [(item_id, name, frame + frames) for item_id, name, frame in self._places]
            preview = self._verbs.moved(self._verbs.copied(project, self._places, frames), there, 0, amount)
        elif not copies and (frames or amount) and self._places:
            preview = self._verbs.moved(project, self._places, frames, amount)
        self._axis.view_state.set_preview(preview)

    def _preview_stretched(self, stretch: Stretch, x: float) -> None:
        project, goes = self._document.project, stretch.goes({frame for _, _, frame in self._places}, x)
        if self._made == (project, goes):
            return
        self._made, self._goes = (project, goes), goes
        is_moved = any(frame != to for frame, to in goes.items())
        self._axis.view_state.set_preview(self._verbs.retimed(project, self._places, goes) if is_moved else None)

    def _inside(self, frames: int) -> int:
        own = [frame for _, _, frame in self._places]
        first, stop = self._axis.scale.clip
        if not own:
            return 0
        return max(min(frames, max(stop - 1 - max(own), 0)), min(first - min(own), 0))
