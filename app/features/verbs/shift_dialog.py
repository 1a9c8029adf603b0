"""ShiftDialog: by how many frames, and whether everything or what is selected."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QDialog, QWidget

from roam_core.roto import Clip

from ... import style
from ...translation import tr
from ...widgets.asking import lay_out
from ...widgets.controls import FRAME_LIMIT, dense_form, form_label, weak_label
from ...widgets.number_boxes import WholeBox

EVERYTHING, SELECTED = range(2)


class ShiftDialog(QDialog):
    """Asks for the `offset`. Deleted when it closes.

    Where no key lies on the clip it begins with the offset that brings the first one onto the clip's first frame.

    Parameters
    ----------
    held : the frames on which the project has keys or notes, in order. selected : those of what is selected; empty
        where nothing is, and then everything is shifted.
    """

    def __init__(
        self, held: Sequence[int], selected: Sequence[int], clip: Clip | None, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Shift in time"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._held, self._selected = held, selected
        self.what = QComboBox()
        self.what.addItem(tr("The whole project, what is locked and notes too"), EVERYTHING)
        if selected:
            self.what.addItem(tr("What is selected"), SELECTED)
        self.by = WholeBox()
        self.by.setRange(-FRAME_LIMIT, FRAME_LIMIT)
        self.by.setSuffix(tr(" frames"))
        self.by.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.by.setMinimumHeight(style.ROW_HEIGHT)
        self.by.setValue(_missed_by(held, clip))
        self.now, self.then = weak_label(""), weak_label("")
        form = dense_form()
        form.addRow(form_label(tr("Shift")), self.what)
        form.addRow(form_label(tr("By")), self.by)
        form.addRow(form_label(tr("Now")), self.now)
        form.addRow(form_label(tr("Then")), self.then)
        explained = tr(
            "Keys, lifetimes, opacity and feather, depth and the motion of layers go along; the clip stays. "
            "Earlier is below zero."
        )
        self.explained = weak_label(explained)
        self.explained.setWordWrap(True)
        self.ok = lay_out(self, form, tr("Shift"), self.explained)
        self.by.valueChanged.connect(self._pull)
        self.what.currentIndexChanged.connect(self._pull)
        self._pull()
        self.by.setFocus()
        self.by.selectAll()

    @property
    def offset(self) -> int:
        """By how many frames; earlier is below zero."""
        return self.by.value()

    @property
    def is_selected_alone(self) -> bool:
        """Whether only what is selected is to be shifted."""
        return bool(self.what.currentData() == SELECTED)

    def _pull(self) -> None:
        frames = self._selected if self.is_selected_alone else self._held
        self.now.setText(_told(frames, 0))
        self.then.setText(_told(frames, self.offset))
        self.ok.setEnabled(self.offset != 0)


def _told(frames: Sequence[int], offset: int) -> str:
    return tr("frames {first} to {last}", first=frames[0] + offset, last=frames[-1] + offset)


def _missed_by(held: Sequence[int], clip: Clip | None) -> int:
    """The offset that brings what lies wholly beside the clip onto it; 0 where something lies on it."""
    if clip is None or any(frame in clip.frame_range for frame in held):
        return 0
    return clip.first - held[0]
