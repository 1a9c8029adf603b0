"""The small controls that all panels are made of: flat buttons, number fields, labels, dense forms."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import (
    QAbstractSpinBox,
    QComboBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QLayout,
    QLineEdit,
    QProgressBar,
    QToolButton,
    QWidget,
)

from roam_core.roto.lifetimes import LAST_FRAME

from .. import style
from ..actions.actions import Actions
from .number_boxes import DecimalBox, WholeBox

FRAME_LIMIT = LAST_FRAME
LABEL_WIDTH = 68
MEASURE_WIDTH = 110


def tool_button(actions: Actions, action_id: str, *, size: int = 24, name: str = "flat") -> QToolButton:
    """A button for an action: its icon, its tooltip with the keys; it takes the keyboard by Tab alone.

    `name` is the style sheet's word for its look: `flat` in bars, `raised` among the fields of a form.
    """
    button = QToolButton()
    button.setDefaultAction(actions[action_id])
    button.setObjectName(name)
    button.setIconSize(style.ICON_SIZE)
    button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonIconOnly)
    button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    button.setFixedHeight(size)
    button.setMinimumWidth(size)
    return button


def icon_button(icon: str, tip: str, *, size: int = 24) -> QToolButton:
    """A flat button that is no action of the window's; it takes the keyboard by Tab alone."""
    button = QToolButton()
    button.setObjectName("flat")
    button.setIcon(style.icon(icon))
    button.setIconSize(style.ICON_SIZE)
    button.setFixedSize(size, size)
    button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    button.setToolTip(tip)
    button.setAccessibleName(tip)
    return button


def is_being_typed(line: QLineEdit) -> bool:
    """Whether something is being typed there: it is the artist's until they are done, whatever changes meanwhile."""
    return line.isModified() and line.hasFocus()


FRAME_WIDTH, FRAME_ASIDE = 58, 18
"""Of a field for a frame number, in pixels; what of it is beside the digits."""


class FrameField(WholeBox):
    """A field for a frame number, as wide as it asks for. The wheel, turned on the way past, changes nothing: only with
    the keyboard in it.
    """

    def __init__(self) -> None:
        super().__init__()
        self.textChanged.connect(self._make_room)
        self.editingFinished.connect(lambda: self.lineEdit().setModified(False))

    def show_frame(self, frame: int, low: int, high: int) -> None:
        """Show a frame out of those from `low` to `high`; what is being typed stays, and is taken as usual."""
        line = self.lineEdit()
        typed, cursor, is_typed = line.text(), line.cursorPosition(), is_being_typed(line)
        with QSignalBlocker(self):
            self.setRange(low, high)
            self.setValue(frame)
            self._make_room(line.text())
            if is_typed:
                line.setText(typed)
                line.setCursorPosition(cursor)
                line.setModified(True)

    def _make_room(self, text: str) -> None:
        """Plates that are numbered by time code have seven digits and more."""
        wanted = self.fontMetrics().horizontalAdvance(text) + FRAME_ASIDE
        if wanted > self.minimumWidth() == self.maximumWidth():
            self.setFixedWidth(wanted)

    def take_back(self) -> None:
        """Show the frame that holds in place of what is being typed."""
        with QSignalBlocker(self):
            self.setValue(self.value())
        self.lineEdit().setModified(False)

    def wheelEvent(self, event: QWheelEvent) -> None:
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()


def number_field(tip: str) -> FrameField:
    """A field for a frame number: typed, or changed by the wheel; one change when it is done."""
    field = FrameField()
    field.setRange(-FRAME_LIMIT, FRAME_LIMIT)
    field.setKeyboardTracking(False)
    field.setAlignment(Qt.AlignmentFlag.AlignRight)
    field.setFixedWidth(FRAME_WIDTH)
    field.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
    field.setToolTip(tip)
    field.setAccessibleName(tip)
    return field


class ChoiceBox(QComboBox):
    """A list to choose from in a panel.

    A click never gives it the keyboard, Tab does: keys pressed after a click choose nothing. Nor does the wheel choose:
    over it the panel scrolls, and a choice that is changed by the way is not noticed.
    """

    def __init__(self, tip: str = "") -> None:
        super().__init__()
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setToolTip(tip)
        self.setAccessibleDescription(tip)

    def wheelEvent(self, event: QWheelEvent) -> None:
        event.ignore()


def measure_field(unit: str, value: float, least: float, most: float, step: float, tip: str) -> DecimalBox:
    """A dialog's field for a length or an area."""
    field = DecimalBox()
    field.setRange(least, most)
    field.setSingleStep(step)
    field.setValue(value)
    field.setSuffix(unit)
    field.setToolTip(tip)
    field.setAccessibleDescription(tip)
    field.setFixedWidth(MEASURE_WIDTH)
    field.setAlignment(Qt.AlignmentFlag.AlignRight)
    return field


def side_by_side(*parts: QWidget | None) -> QHBoxLayout:
    """Widgets in a row, fields and bars as wide as there is room; None is a stretch."""
    row = QHBoxLayout()
    row.setSpacing(6)
    for part in parts:
        if part is None:
            row.addStretch(1)
        else:
            row.addWidget(part, 1 if isinstance(part, QLineEdit | QProgressBar) else 0)
    return row


def weak_label(text: str) -> QLabel:
    """A quiet label."""
    label = QLabel(text)
    label.setObjectName("weak")
    return label


class _NamedForm(QFormLayout):
    """A form whose labels name their fields for screen readers."""

    def addRow(self, *row: Any) -> None:
        super().addRow(*row)
        label, field = row if len(row) == 2 else (None, None)
        if isinstance(label, QLabel) and label.text():
            for control in _controls_in(field):
                if not control.accessibleName():
                    control.setAccessibleName(label.text())


def _controls_in(field: QWidget | QLayout | None) -> list[QWidget]:
    """What is worked with in a row of a form: the field, or the fields and buttons beside each other in it."""
    if isinstance(field, QLayout):
        widgets = [item.widget() for index in range(field.count()) if (item := field.itemAt(index)) is not None]
        return [control for widget in widgets for control in _controls_in(widget)]
    if isinstance(field, QAbstractSpinBox | QComboBox | QLineEdit | QToolButton | QLabel):
        return [field]
    return [] if field is None else [each for child in field.findChildren(QWidget) for each in _fields_among(child)]


def _fields_among(widget: QWidget) -> list[QWidget]:
    is_part = isinstance(widget.parentWidget(), QAbstractSpinBox | QComboBox)
    return [widget] if isinstance(widget, QAbstractSpinBox | QComboBox | QToolButton) and not is_part else []


def dense_form() -> QFormLayout:
    """A form with the house's spacing and labels on the left."""
    form = _NamedForm()
    form.setContentsMargins(0, 0, 0, 0)
    form.setHorizontalSpacing(style.MARGIN)
    form.setVerticalSpacing(6)
    form.setLabelAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
    form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
    return form


def align_labels(*forms: QFormLayout) -> None:
    """Let the fields of forms that lie below each other begin at one place, also where a word is long."""
    items = [form.itemAt(row, QFormLayout.ItemRole.LabelRole) for form in forms for row in range(form.rowCount())]
    labels = [label for item in items if item is not None and (label := item.widget()) is not None]
    widest = max((label.sizeHint().width() for label in labels), default=LABEL_WIDTH)
    for label in labels:
        label.setMinimumWidth(max(label.minimumWidth(), widest))


def form_label(text: str) -> QLabel:
    """A form's label: weak, of one width in all panels but where a word of another language is longer."""
    label = weak_label(text)
    label.setMinimumWidth(LABEL_WIDTH)
    label.setMinimumHeight(style.ROW_HEIGHT)
    return label
