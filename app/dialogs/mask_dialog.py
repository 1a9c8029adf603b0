"""The dialog before masks come in: how near curves must lie, with how many keys, and what is too small to follow."""

from __future__ import annotations

from PySide6.QtWidgets import QComboBox, QDialog, QWidget

from roam_core.interchange import KeyChoice, MaskOptions

from ..translation import N_, tr
from ..widgets.asking import lay_out
from ..widgets.controls import dense_form, form_label, measure_field, weak_label

KEYS = {KeyChoice.REDUCED: N_("As few as hold the outline"), KeyChoice.EVERY: N_("One on every frame")}
STRAYING = N_(
    "How far a curve may stray from its mask's outline on any frame, in pixels of the masks; "
    "of masks that tremble, a fifth of the outline may stray farther"
)
SPECKS = N_("Parts and holes that are never larger are left out")


class MaskDialog(QDialog):
    """Asks how the masks of a folder become shapes; `options` are what was chosen, for masks of `size` or unknown."""

    def __init__(self, folder: str, size: tuple[int, int] | None, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Import masks"))
        asked = MaskOptions()
        self.keys = QComboBox()
        for choice, words in KEYS.items():
            self.keys.addItem(tr(words), choice.value)
        self.tolerance = measure_field(tr(" px"), asked.tolerance, 0.05, 100.0, 0.25, tr(STRAYING))
        self.speckle = measure_field(tr(" px²"), asked.speckle_for(size or (480, 480)), 0.0, 1e6, 16.0, tr(SPECKS))
        self.speckle.setDecimals(0)
        self.speckle.setPrefix(tr("below "))
        self.speckle.setSpecialValueText(tr("Follow all"))
        form = dense_form()
        form.addRow(form_label(tr("From")), weak_label(folder))
        form.addRow(form_label(tr("Keys")), self.keys)
        form.addRow(form_label(tr("Within")), self.tolerance)
        form.addRow(form_label(tr("Specks")), self.speckle)
        lay_out(self, form, tr("Import"))

    @property
    def options(self) -> MaskOptions:
        """The options as they stand in the fields."""
        return MaskOptions(self.tolerance.value(), KeyChoice(self.keys.currentData()), self.speckle.value())
