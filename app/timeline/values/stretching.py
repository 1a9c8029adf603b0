"""Stretch keys: the chosen keys are to lie between two frames, which are typed; what the brackets beside them drag."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog, QWidget

from roam_core.roto import timing
from roam_core.roto.timing import stretched

from ...model.document import Document
from ...model.view_state import ViewState
from ...translation import N_, tr
from ...widgets.asking import ask, lay_out
from ...widgets.controls import dense_form, form_label, number_field, weak_label
from ..keys.selection import KeySelection
from ..keys.stretch import told
from ..keys.verbs import count_of, unlocked
from .selection import ValueSelection
from .verbs import ValueVerbs
from .verbs import unlocked as unlocked_values

TOO_FEW = N_("Choose keys on two frames at least, in the timeline or the curve editor.")
ALL_LOCKED = N_("What the chosen keys belong to is locked; unlock it to stretch them.")


class Stretching:
    """The verb on the chosen keys of shapes, or of values and curves; what is asked is asked above `parent`."""

    def __init__(
        self,
        parent: QWidget,
        document: Document,
        view_state: ViewState,
        keys: KeySelection,
        values: ValueSelection,
        value_verbs: ValueVerbs,
    ) -> None:
        self._parent, self._document, self._view = parent, document, view_state
        self._keys, self._values, self._value_verbs = keys, values, value_verbs

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"key.stretch": self.ask}

    def ask(self) -> None:
        """Ask between which frames the chosen keys are to lie; says so where there are too few of them."""
        frames, clip = self._frames(), self._document.project.clip
        if len(frames) < 2:
            is_locked = not frames and bool(self._keys.places or self._values.places)
            self._view.say(tr(ALL_LOCKED if is_locked else TOO_FEW))
            return
        within = range(frames[0], frames[-1] + 1) if clip is None else clip.frame_range
        dialog = StretchDialog(frames, within, self._parent)
        ask(dialog, lambda: self.stretch(dialog.first.value(), dialog.last.value()), self._document.replaced)

    def stretch(self, first: int, last: int) -> None:
        """Have the chosen keys, but for those of what is locked, lie between two frames, as one undo step."""
        project, frames = self._document.project, self._frames()
        if len(frames) < 2:
            self._view.say(tr(TOO_FEW))
            return
        goes = stretched(frames, first, last)
        if keys := unlocked(project, self._keys.places):
            self._document.apply(tr("Stretch keys"), timing.retime_keys(project, keys, goes))
            self._keys.select(frozenset((shape_id, goes[frame]) for shape_id, frame in keys))
            self._view.say(told(count_of(keys), goes))
        else:
            values = unlocked_values(project, self._values.places)
            self._document.apply(tr("Stretch keys"), self._value_verbs.retimed(project, values, goes))
            self._values.select(frozenset((item_id, kind, goes[frame]) for item_id, kind, frame in values))
            self._view.say(told(count_of(values), goes))

    def _frames(self) -> list[int]:
        """The frames of the chosen keys that may be changed, in order."""
        project = self._document.project
        keys, values = unlocked(project, self._keys.places), unlocked_values(project, self._values.places)
        return sorted({frame for _, frame in keys} or {frame for _, _, frame in values})


class StretchDialog(QDialog):
    """Asks for the `first` frame and the `last`. Deleted when it closes.

    Parameters
    ----------
    frames : those of the chosen keys, in order. clip : the frames that exist; what lies beside them already may stay.
    """

    def __init__(self, frames: Sequence[int], clip: range, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Stretch keys"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._frames = frames
        self.first, self.last = number_field(tr("Frame of the first key")), number_field(tr("Frame of the last key"))
        for field, now in ((self.first, frames[0]), (self.last, frames[-1])):
            field.setKeyboardTracking(True)  # the button says at once whether it has a use
            field.setRange(min(clip.start, frames[0]), max(clip.stop - 1, frames[-1]))
            field.setValue(now)
        form = dense_form()
        form.addRow(form_label(tr("Now")), weak_label(tr("frames {first} to {last}", first=frames[0], last=frames[-1])))
        form.addRow(form_label(tr("First frame")), self.first)
        form.addRow(form_label(tr("Last frame")), self.last)
        self.room = weak_label("")
        self.room.setWordWrap(True)
        self.ok = lay_out(self, form, tr("Stretch"), self.room)
        for field in (self.first, self.last):
            field.valueChanged.connect(self._pull)
        self._pull()
        self.last.setFocus()
        self.last.selectAll()

    def _pull(self) -> None:
        first, last, frames = self.first.value(), self.last.value(), self._frames
        has_room = last - first >= len(frames) - 1
        need = tr("Each key has a frame of its own: %n frame(s) at least.", "", len(frames))
        self.room.setText(tr("Each key keeps its place among them.") if has_room else need)
        self.ok.setEnabled(has_room and (first, last) != (frames[0], frames[-1]))
