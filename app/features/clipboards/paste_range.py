"""PasteRangeDialog: through which frames the copied key is held, and where it gets keys."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog, QWidget

from ... import style
from ...translation import tr
from ...widgets.asking import lay_out
from ...widgets.controls import FRAME_LIMIT, dense_form, form_label, weak_label
from ...widgets.number_boxes import WholeBox


class PasteRangeDialog(QDialog):
    """From, to (the in/out range to begin with, inside the clip's `frames`), and how often. Deleted when it closes."""

    def __init__(self, play_range: tuple[int, int], frames: range | None = None, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Paste key to range"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        lowest, highest = (frames[0], frames[-1]) if frames else (-FRAME_LIMIT, FRAME_LIMIT)
        self.first = _field(play_range[0], lowest, highest)
        self.last = _field(play_range[1] - 1, lowest, highest)
        self.step = _field(0, 0, FRAME_LIMIT)
        self.step.setSpecialValueText(tr("at both ends"))
        self.step.setPrefix(tr("every "))
        self.step.setToolTip(tr("A key on each so many frames; 0: at both ends of the range alone"))
        form = dense_form()
        for title, field in ((tr("From frame"), self.first), (tr("To frame"), self.last), (tr("Keys"), self.step)):
            form.addRow(form_label(title), field)
        explained = weak_label(tr("The shape stands still there: other keys in the range give way."))
        lay_out(self, form, tr("Paste"), explained)
        self.first.valueChanged.connect(self.last.setMinimum)
        self.last.setMinimum(self.first.value())
        self.first.selectAll()

    @property
    def frames(self) -> range:
        """The frames of the range."""
        return range(self.first.value(), self.last.value() + 1)

    @property
    def every(self) -> int:
        """A key on each so many frames; 0 for both ends alone."""
        return self.step.value()


def _field(value: int, lowest: int, highest: int) -> WholeBox:
    field = WholeBox()
    field.setRange(lowest, highest)
    field.setValue(value)
    field.setAlignment(Qt.AlignmentFlag.AlignRight)
    field.setMinimumHeight(style.ROW_HEIGHT)
    return field
