"""The palette of outline colours as a row of small squares, and a square for any other colour."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QButtonGroup, QColorDialog, QHBoxLayout, QToolButton, QWidget

from roam_core.roto.project import PALETTE

from .. import style
from ..translation import tr

Colour = tuple[float, float, float]

OTHER = len(PALETTE)
"""Index of the square for a colour that is not in the palette."""


class ColourRow(QWidget):
    """The palette, and a last square that asks for any colour; the shape's own is framed.

    Signals
    -------
    picked(colour) : the user chose `(r, g, b)` in [0, 1].
    """

    picked = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._shown: Colour = PALETTE[0]
        self._framed: Colour | None = PALETTE[0]
        self.group = QButtonGroup(self)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(0)
        for index, colour in enumerate(PALETTE):
            self._add(row, index).setIcon(style.swatch(colour, 12))
            self.group.button(index).setAccessibleName(tr("Colour {number}", number=index + 1))
        other = self._add(row, OTHER)
        other.setToolTip(tr("Another colour…"))
        other.setAccessibleName(tr("Another colour…"))
        other.setText("…")
        row.addStretch(1)
        self.group.idClicked.connect(self._choose)

    def _add(self, row: QHBoxLayout, index: int) -> QToolButton:
        button = QToolButton()
        button.setCheckable(True)
        button.setFixedSize(19, 20)
        button.setIconSize(QSize(12, 12))
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.group.addButton(button, index)
        row.addWidget(button)
        return button

    def show_colour(self, colour: Colour | None) -> None:
        """Frame the square of this colour; none where colours differ (None)."""
        self.group.setExclusive(False)
        for index, known in enumerate(PALETTE):
            self.group.button(index).setChecked(known == colour)
        other = self.group.button(OTHER)
        is_other = colour is not None and colour not in PALETTE
        other.setChecked(is_other)
        if is_other and colour is not None:
            other.setIcon(style.swatch(colour, 12))
        self.group.setExclusive(True)
        self._shown, self._framed = colour or self._shown, colour

    def _choose(self, index: int) -> None:
        if index != OTHER:
            self.picked.emit(PALETTE[index])
            return
        self.show_colour(self._framed)  # nothing is chosen yet
        dialog = QColorDialog(QColor.fromRgbF(*self._shown), self)
        dialog.setWindowTitle(tr("Colour of the outline"))
        dialog.setOption(QColorDialog.ColorDialogOption.DontUseNativeDialog)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.colorSelected.connect(lambda colour: self.picked.emit(rounded(colour)))
        dialog.open()


def rounded(colour: QColor) -> Colour:
    """A colour as shapes keep it: `(r, g, b)` in [0, 1], to three digits, so that files read well."""
    return round(colour.redF(), 3), round(colour.greenF(), 3), round(colour.blueF(), 3)
