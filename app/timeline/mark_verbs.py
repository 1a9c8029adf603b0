"""What keys and menus do to the marks on frames: set, name, remove, go to the next one."""

from __future__ import annotations

from collections.abc import Callable

from roam_core.roto import Mark, timing

from ..model.document import Document
from ..model.view_state import ViewState
from ..translation import N_, tr

NONE_AFTER = N_("There is no mark after this frame.")
NONE_BEFORE = N_("There is no mark before this frame.")
NO_CLIP = N_("Open a clip first: marks lie on its frames.")


class MarkVerbs:
    """The verbs behind the mark keys. `name` opens the field in which the mark of a frame is named."""

    def __init__(self, document: Document, view_state: ViewState, name: Callable[[int], None]) -> None:
        self._document, self._view, self._name = document, view_state, name

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "mark.toggle": self.toggle,
            "mark.name": self.name,
            "time.previous_mark": lambda: self._go(-1),
            "time.next_mark": lambda: self._go(1),
        }

    def toggle(self) -> None:
        """Mark the playhead's frame, or take its mark away."""
        project, frame = self._document.project, self._view.frame
        if project.clip is None:
            self._view.say(tr(NO_CLIP))
        elif (mark := timing.mark_at(project, frame)) is None:
            self._document.apply(tr("Mark frame"), timing.set_mark(project, frame))
            self._view.say(tr("Frame {frame} is marked; double-click the mark to write a note.", frame=frame))
        else:
            remove(self._document, self._view, mark)

    def name(self) -> None:
        """Name the mark of the playhead's frame, which is set if it is not there."""
        if self._document.project.clip is None:
            self._view.say(tr(NO_CLIP))
            return
        if timing.mark_at(self._document.project, self._view.frame) is None:
            self.toggle()
        self._name(self._view.frame)

    def _go(self, step: int) -> None:
        here, project = self._view.frame, self._document.project
        shown = None if project.clip is None else project.clip.frame_range
        frames = [mark.frame for mark in project.marks if shown is None or mark.frame in shown]
        beyond = [frame for frame in frames if (frame - here) * step > 0]
        if beyond:
            self._view.set_frame(min(beyond) if step > 0 else max(beyond))
        else:
            self._view.say_here(tr(NONE_AFTER if step > 0 else NONE_BEFORE))


def remove(document: Document, view: ViewState, mark: Mark) -> None:
    """Take a mark away, as one undo step; says so where its note goes with it."""
    text = tr("Remove note") if mark.text else tr("Remove mark")
    document.apply(text, timing.remove_mark(document.project, mark.frame))
    if mark.text:
        view.say(tr("The note of frame {frame} went with its mark; <edit.undo> brings it back.", frame=mark.frame))
