"""What the views can be told: the background of the cut-out and the frames of the onion skin, in small popups."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor, QIcon, QPixmap
from PySide6.QtWidgets import (
    QColorDialog,
    QComboBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QMenu,
    QPushButton,
    QToolButton,
    QWidget,
    QWidgetAction,
)

from ... import style
from ...model.viewing import MOST_GHOSTS, BackgroundKind, Viewing
from ...translation import N_, tr
from ...widgets.controls import dense_form, form_label
from ...widgets.fields import NumberField, SwitchBox

BACKGROUNDS = {
    BackgroundKind.CHECKER: N_("Checkerboard"),
    BackgroundKind.COLOUR: N_("Colour"),
    BackgroundKind.IMAGE: N_("Picture"),
}
IMAGES = N_("Pictures (*.exr *.dpx *.png *.jpg *.jpeg *.tif *.tiff);;All files (*)")
COUNT_WIDTH = 52


class Swatch(QToolButton):
    """A button that shows a colour and lets another be chosen."""

    def __init__(self, title: str, chosen: Callable[[str], object]) -> None:
        super().__init__()
        self._title, self._chosen = title, chosen
        self._colour = QColor()
        self.setObjectName("raised")
        self.setIconSize(QSize(24, 12))
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setToolTip(title)
        self.setAccessibleName(title)
        self.clicked.connect(self._choose)

    def show_colour(self, name: str) -> None:
        """Show the colour `#rrggbb`."""
        self._colour = QColor(name)
        picture = QPixmap(24, 12)
        picture.fill(self._colour)
        self.setIcon(QIcon(picture))

    def _choose(self) -> None:
        dialog = QColorDialog(self._colour, self.window().parentWidget() or self)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.setWindowTitle(self._title)
        dialog.currentColorChanged.connect(lambda colour: self._chosen(colour.name()))
        dialog.show()


class BackgroundForm(QWidget):
    """What a cut-out lies on."""

    def __init__(self, viewing: Viewing) -> None:
        super().__init__()
        self._viewing = viewing
        self.kind = QComboBox()
        for kind, word in BACKGROUNDS.items():
            self.kind.addItem(tr(word), kind)
        self.colour = Swatch(tr("Colour under the cut-out"), lambda name: viewing.set_background(colour=name))
        self.image = QPushButton()
        self.image.setMaximumWidth(180)
        form = _form(self)
        form.addRow(form_label(tr("Background")), self.kind)
        form.addRow(form_label(tr("Colour")), self.colour)
        form.addRow(form_label(tr("Picture")), self.image)
        self.kind.activated.connect(lambda _: self._push_kind())
        self.image.clicked.connect(self._choose_image)
        viewing.changed.connect(self._pull)
        self._pull()

    def _push_kind(self) -> None:
        kind = BackgroundKind(self.kind.currentData())
        if kind is BackgroundKind.IMAGE and not self._viewing.background.image:
            self._choose_image()
            self._pull()
        else:
            self._viewing.set_background(kind=kind)

    def _choose_image(self) -> None:
        start = str(Path(self._viewing.background.image).parent) if self._viewing.background.image else ""
        path, _ = QFileDialog.getOpenFileName(self, tr("Picture under the cut-out"), start, tr(IMAGES))
        if path:
            again = self._viewing.background.choice + 1
            self._viewing.set_background(kind=BackgroundKind.IMAGE, image=path, choice=again)

    def _pull(self) -> None:
        background = self._viewing.background
        self.kind.setCurrentIndex(self.kind.findData(background.kind))
        self.colour.show_colour(background.colour)
        self.colour.setEnabled(background.kind is BackgroundKind.COLOUR)
        self.image.setText(Path(background.image).name if background.image else tr("Choose…"))
        self.image.setToolTip(background.image)


class OnionForm(QWidget):
    """Which other frames' outlines are drawn, and in which colours."""

    def __init__(self, viewing: Viewing) -> None:
        super().__init__()
        self._viewing = viewing
        self.before, self.after = (
            NumberField(0, MOST_GHOSTS, tip=tip) for tip in (tr("Frames before this one"), tr("Frames after this one"))
        )
        self.step = NumberField(1, 100, tip=tr("Frames from one outline to the next"))
        self.before_colour = Swatch(tr("Outlines of frames before"), lambda name: viewing.set_onion(before_colour=name))
        self.after_colour = Swatch(tr("Outlines of frames after"), lambda name: viewing.set_onion(after_colour=name))
        self.only_keys = SwitchBox(tr("Artist keys only"), tr("The keys before and after, however far"))
        self.all_shapes = SwitchBox(tr("All shapes"), tr("Also of those that are not selected"))
        form = _form(self)
        for title, field, swatch in (
            (tr("Before"), self.before, self.before_colour),
            (tr("After"), self.after, self.after_colour),
        ):
            form.addRow(form_label(title), _beside(field, swatch))
        form.addRow(form_label(tr("Every")), _beside(self.step, form_label(tr("frames"))))
        form.addRow(form_label(""), self.only_keys)
        form.addRow(form_label(""), self.all_shapes)
        for name, number in (("before", self.before), ("after", self.after), ("step", self.step)):
            number.setFixedWidth(COUNT_WIDTH)
            number.edited.connect(lambda count, _, name=name: viewing.set_onion(**{name: int(count)}))
        for name, switch in (("only_keys", self.only_keys), ("all_shapes", self.all_shapes)):
            switch.clicked.connect(lambda on, name=name: viewing.set_onion(**{name: on}))
        viewing.changed.connect(self._pull)
        self._pull()

    def _pull(self) -> None:
        onion = self._viewing.onion
        for field, count in ((self.before, onion.before), (self.after, onion.after), (self.step, onion.step)):
            field.show_value(count)
        self.step.setEnabled(not onion.only_keys)
        self.before_colour.show_colour(onion.before_colour)
        self.after_colour.show_colour(onion.after_colour)
        self.only_keys.show_value(onion.only_keys)
        self.all_shapes.show_value(onion.all_shapes)


def options_button(form: QWidget, tip: str) -> QToolButton:
    """A narrow button beside a view's own, which opens its form."""
    button = QToolButton()
    button.setObjectName("menuButton")
    button.setIcon(style.icon("chevron-down"))
    button.setIconSize(QSize(10, 10))
    button.setFixedSize(14, 24)
    button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
    button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    button.setToolTip(tip)
    button.setAccessibleName(tip)
    menu = QMenu(button)
    holder = QWidgetAction(menu)
    holder.setDefaultWidget(form)
    menu.addAction(holder)
    button.setMenu(menu)
    return button


def _form(widget: QWidget) -> QFormLayout:
    form = dense_form()
    form.setContentsMargins(style.MARGIN, 4, style.MARGIN, 4)
    widget.setLayout(form)
    return form


def _beside(*parts: QWidget) -> QHBoxLayout:
    row = QHBoxLayout()
    row.setSpacing(6)
    for part in parts:
        row.addWidget(part)
    row.addStretch(1)
    return row
