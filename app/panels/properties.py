"""The shape panel: the plain fields of the selected shapes, each a pair of lines between document and widget."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import (
    QButtonGroup,
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QStackedLayout,
    QToolButton,
    QWidget,
)

from app import style
from app.document import Document
from app.panels.controls import dense_form, form_label
from app.view_state import ViewState, selected_shapes
from roam_core.roto import BlendMode, RotoShape, edit
from roam_core.roto.edit import MIN_POINTS_CLOSED
from roam_core.roto.project import PALETTE

NOTHING = "Select a shape to see its properties."


@dataclass(frozen=True)
class Field:
    """One control: how it shows a shape's value. Writing goes through `PropertiesPanel.push`."""

    widget: QWidget
    show: Callable[[RotoShape], None]


class PropertiesPanel(QWidget):
    """Shows the first of the selected shapes and edits all of them."""

    def __init__(self, document: Document, view_state: ViewState, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document, self._view = document, view_state
        self._fields: list[Field] = []
        self._form_page = QWidget()
        self._form = dense_form()
        self._form.setContentsMargins(style.MARGIN, style.MARGIN, style.MARGIN, style.MARGIN)
        self._form_page.setLayout(self._form)
        self._hint = QLabel(NOTHING)
        self._hint.setObjectName("weak")
        self._hint.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._pages = QStackedLayout(self)
        self._pages.addWidget(self._hint)
        self._pages.addWidget(self._form_page)
        self._build()
        for signal in (document.changed, document.replaced, view_state.selection_changed):
            signal.connect(self._pull)
        self._pull()

    # ---- the controls, two lines each: model to widget, widget to model

    def _build(self) -> None:
        name = QLineEdit()
        self._add("Name", name, lambda shape: name.setText(shape.name))
        name.editingFinished.connect(lambda: self._push_name(name.text().strip()))

        opacity = _number(0.0, 100.0, " %", decimals=0)
        self._add("Opacity", opacity, lambda shape: opacity.setValue(shape.opacity * 100))
        opacity.valueChanged.connect(lambda value: self.push("Opacity", opacity=value / 100))

        blend = QComboBox()
        for mode in BlendMode:
            blend.addItem(mode.value.capitalize(), mode)
        self._add("Blend", blend, lambda shape: blend.setCurrentIndex(blend.findData(shape.blend)))
        blend.currentIndexChanged.connect(lambda _: self.push("Blend", blend=BlendMode(blend.currentData())))

        feather = _number(0.0, 500.0, " px", decimals=1)
        self._add("Feather", feather, lambda shape: feather.setValue(shape.feather))
        feather.valueChanged.connect(lambda value: self.push("Feather", feather=value))

        invert, closed = QCheckBox("Invert"), QCheckBox("Closed")
        self._fields.append(Field(invert, lambda shape: invert.setChecked(shape.invert)))
        invert.toggled.connect(lambda on: self.push("Invert", invert=on))
        self._fields.append(Field(closed, lambda shape: closed.setChecked(shape.closed)))
        closed.toggled.connect(lambda on: self.push("Close" if on else "Open", closed=on))
        self._form.addRow(form_label("Outline"), _side_by_side(closed, invert))

        colours = ColourRow()
        self._add("Colour", colours, lambda shape: colours.show_colour(shape.colour))
        colours.group.idClicked.connect(lambda index: self.push("Colour", colour=PALETTE[index]))
        self.name, self.opacity, self.blend, self.feather = name, opacity, blend, feather
        self.invert, self.closed, self.colours = invert, closed, colours

    def _add(self, label: str, widget: QWidget, show: Callable[[RotoShape], None]) -> None:
        self._fields.append(Field(widget, show))
        if not isinstance(widget, ColourRow):
            widget.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self._form.addRow(form_label(label), widget)

    def push(self, text: str, **values: Any) -> None:
        """Set fields of every selected shape, as one undo step; what is equal already is no step."""
        project = self._document.project
        for shape in self._selected():
            if any(getattr(shape, name) != value for name, value in values.items()):
                project = edit.set_properties(project, shape.id, **values)
        self._document.apply(text, project)

    def _push_name(self, name: str) -> None:
        if name:
            self.push("Rename", name=name)
        self._pull()

    def _selected(self) -> list[RotoShape]:
        return selected_shapes(self._document.project, self._view.selection)

    def _pull(self, _ids: object = None) -> None:
        selected = self._selected()
        self._pages.setCurrentWidget(self._form_page if selected else self._hint)
        for field in self._fields if selected else ():
            with QSignalBlocker(field.widget):
                field.show(selected[0])
            field.widget.setEnabled(not selected[0].locked)
        if selected:
            self.closed.setEnabled(_can_toggle_closed(selected[0]))
        if len(selected) > 1:  # a name belongs to one shape
            self.name.clear()
            self.name.setEnabled(False)
            self.name.setPlaceholderText(f"{len(selected)} shapes")


class ColourRow(QWidget):
    """The palette as eight small squares; the shape's own is framed."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.group = QButtonGroup(self)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(1)
        for index, colour in enumerate(PALETTE):
            button = QToolButton()
            button.setIcon(style.swatch(colour, 12))
            button.setCheckable(True)
            button.setFixedSize(20, 20)
            button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
            self.group.addButton(button, index)
            row.addWidget(button)
        row.addStretch(1)

    def show_colour(self, colour: tuple[float, float, float]) -> None:
        """Frame the square of this colour, or none."""
        self.group.setExclusive(False)
        for index, known in enumerate(PALETTE):
            self.group.button(index).setChecked(known == colour)
        self.group.setExclusive(True)


def _number(low: float, high: float, suffix: str, *, decimals: int) -> QDoubleSpinBox:
    field = QDoubleSpinBox()
    field.setRange(low, high)
    field.setDecimals(decimals)
    field.setSuffix(suffix)
    field.setKeyboardTracking(False)
    field.setAlignment(Qt.AlignmentFlag.AlignRight)
    return field


def _side_by_side(*widgets: QWidget) -> QHBoxLayout:
    row = QHBoxLayout()
    row.setSpacing(16)
    for widget in widgets:
        widget.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        row.addWidget(widget)
    row.addStretch(1)
    return row


def _can_toggle_closed(shape: RotoShape) -> bool:
    """A shape of two points cannot be closed."""
    return not shape.locked and shape.point_count >= MIN_POINTS_CLOSED
