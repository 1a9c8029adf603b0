"""The dialog before outlines are steadied: how much, and on which frames."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog, QWidget

from roam_core.params.steadiness import STEADINESS

from ...translation import N_, tr
from ...widgets.asking import lay_out
from ...widgets.controls import dense_form, form_label, measure_field, weak_label

EFFECT = N_(
    "How strongly tracked edges are drawn to the motion of the picture. At 50 % they boil less by a tenth on rendered "
    "figures and by a twentieth on filmed shots, about a third of what tracking adds there to a drawn mask's own; "
    "at 100 % hardly less still. At 0 % nothing moves"
)
"""What the dial does, with its effect as measured (docs/ENGINE-NOTES.md)."""


class SteadyDialog(QDialog):
    """Asks for the steadiness; `shapes` and `frames` (the in/out range, half open) are told. Deleted when it closes."""

    def __init__(self, shapes: int, frames: tuple[int, int], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Steady the outline"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.steadiness = measure_field(tr(" %"), 100.0 * STEADINESS.strength, 0.0, 100.0, 10.0, tr(EFFECT))
        self.steadiness.setDecimals(0)
        form = dense_form()
        form.addRow(form_label(tr("Steadiness")), self.steadiness)
        form.addRow(
            form_label(tr("On")),
            weak_label(
                tr(
                    "{shapes}, tracked keys of frames {first} to {last}",
                    shapes=tr("%n shape(s)", "", shapes),
                    first=frames[0],
                    last=frames[1] - 1,
                )
            ),
        )
        explained = weak_label(tr("Your keys stay as they are; tracking again replaces what is moved."))
        lay_out(self, form, tr("Steady"), explained)
        self.steadiness.selectAll()  # what is typed at once replaces the number

    @property
    def strength(self) -> float:
        """The steadiness as a share, in [0, 1]."""
        return self.steadiness.value() / 100.0
