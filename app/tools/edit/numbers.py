"""NumbersDialog: a transform by numbers: move, turn, scale, shear. Numbers that stand for nothing are its beginning."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QDialog, QGridLayout, QWidget

from roam_core.arrays import Array
from roam_core.geometry import affine

from ... import style
from ...translation import tr
from ...widgets.asking import lay_out
from ...widgets.controls import form_label, weak_label
from ...widgets.number_boxes import DecimalBox

FURTHEST = 100_000.0


@dataclass(frozen=True)
class Numbers:
    """A transform: `move` in pixels, `turn` in degrees clockwise, `scale` and `shear` in percent, along x and y."""

    move: tuple[float, float] = (0.0, 0.0)
    turn: float = 0.0
    scale: tuple[float, float] = (100.0, 100.0)
    shear: tuple[float, float] = (0.0, 0.0)


def matrix_of(numbers: Numbers, middle: tuple[float, float], pixel_aspect: float = 1.0) -> Array:
    """The map `(2, 3)` that scales, shears and turns about `middle`, in this order, and then moves.

    Where pixels are not square a turn and a shear are those of the picture as it is shown, not squeezed.
    """
    scaled = affine.scaling(numbers.scale[0] / 100.0, numbers.scale[1] / 100.0, middle)
    sheared = affine.chained(scaled, affine.shear(numbers.shear[0] / 100.0, numbers.shear[1] / 100.0, middle))
    turned = affine.chained(sheared, affine.rotation(numbers.turn, middle))
    shown = affine.about(turned[:, :2] * [[1.0, 1.0 / pixel_aspect], [pixel_aspect, 1.0]], middle)
    return affine.chained(shown, affine.translation(numbers.move))


class NumbersDialog(QDialog):
    """Fields for `Numbers`. Deleted when it closes.

    Signals
    -------
    changed() : a number is another one.
    """

    changed = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Transform"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.move_x, self.move_y = _field(0.0, " px", FURTHEST), _field(0.0, " px", FURTHEST)
        self.turn = _field(0.0, "°", 3600.0)
        self.scale_x, self.scale_y = _field(100.0, " %", FURTHEST), _field(100.0, " %", FURTHEST)
        self.shear_x, self.shear_y = _field(0.0, " %", FURTHEST), _field(0.0, " %", FURTHEST)
        grid = QGridLayout()
        grid.setHorizontalSpacing(style.MARGIN)
        grid.setVerticalSpacing(6)
        rows = (
            (tr("Move x, y"), (self.move_x, self.move_y)),
            (tr("Rotate"), (self.turn,)),
            (tr("Scale x, y"), (self.scale_x, self.scale_y)),
            (tr("Shear x, y"), (self.shear_x, self.shear_y)),
        )
        for index, (title, fields) in enumerate(rows):
            grid.addWidget(form_label(title), index, 0)
            for column, field in enumerate(fields, start=1):
                field.valueChanged.connect(self.changed)
                field.setAccessibleName(f"{title}: {'xy'[column - 1]}" if len(fields) > 1 else title)
                grid.addWidget(field, index, column)
        lay_out(self, grid, tr("Transform"), weak_label(tr("About the middle of what is selected.")))
        self.move_x.selectAll()

    @property
    def numbers(self) -> Numbers:
        """What the fields say."""
        return Numbers(
            (self.move_x.value(), self.move_y.value()),
            self.turn.value(),
            (self.scale_x.value(), self.scale_y.value()),
            (self.shear_x.value(), self.shear_y.value()),
        )


def _field(value: float, suffix: str, furthest: float) -> DecimalBox:
    field = DecimalBox()
    field.setRange(-furthest, furthest)
    field.setDecimals(3)
    field.setSuffix(suffix)
    field.setValue(value)
    field.setAlignment(Qt.AlignmentFlag.AlignRight)
    field.setMinimumHeight(style.ROW_HEIGHT)
    field.setMinimumWidth(96)
    return field
