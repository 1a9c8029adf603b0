"""The dials of the tracker panel: the few numbers of the engine that an artist may turn, folded away until wanted."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QPushButton, QToolButton, QVBoxLayout, QWidget

from roam_core.dials import DIALS, dials_of
from roam_core.params import params_for

from .. import style
from ..features.tracking import Tracking
from ..translation import tr
from ..widgets.controls import dense_form
from ..widgets.fields import NumberField, ScrubLabel

STEP = 10.0
"""Percent."""


class DialForm(QWidget):
    """A percentage for each dial that turns something in the present configuration; `turned` hears of changes."""

    def __init__(self, tracking: Tracking, turned: Callable[[], None], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._tracking, self._turned = tracking, turned
        self.arrow = QToolButton()
        self.arrow.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.arrow.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.arrow.setIconSize(style.ICON_SIZE)
        self.arrow.setToolTip(tr("The few numbers of the engine that are worth turning"))
        self.arrow.clicked.connect(lambda: self.unfold(not self.is_unfolded))
        self.reset = QPushButton(tr("Reset"))
        self.reset.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.reset.setToolTip(tr("Turn all of them back to 100 %"))
        self.reset.clicked.connect(self._reset)
        self._body = QWidget()
        self._form = dense_form()
        self._body.setLayout(self._form)
        self.fields = {dial.name: self._add(dial.name) for dial in DIALS}
        self._lay_out()
        self.unfold(False)

    @property
    def is_unfolded(self) -> bool:
        return not self._body.isHidden()

    def unfold(self, unfolded: bool) -> None:
        """Show the dials, or fold them away."""
        self._body.setVisible(unfolded)
        self.pull()

    def pull(self) -> None:
        """Show the dials of the present configuration as they are turned."""
        factors = self._tracking.factors.get(self._tracking.config, {})
        offered = {dial.name for dial in dials_of(params_for(self._tracking.config))}
        for name, field in self.fields.items():
            field.show_value(100.0 * factors.get(name, 1.0))
            self._form.setRowVisible(field, name in offered)
        is_turned = self._tracking.configuration != self._tracking.config
        self.reset.setEnabled(is_turned)
        self.reset.setVisible(is_turned or self.is_unfolded)
        self.arrow.setText(tr("Fine tuning, changed") if is_turned else tr("Fine tuning"))
        self.arrow.setIcon(style.icon("chevron-down" if self.is_unfolded else "chevron-right"))

    # ---- the rest is private

    def _add(self, name: str) -> NumberField:
        dial = next(dial for dial in DIALS if dial.name == name)
        field = NumberField(100 * dial.low, 100 * dial.high, suffix=" %", step=STEP, tip=tr(dial.sentence))
        label = ScrubLabel(tr(dial.title), field)
        label.setToolTip(tr("{sentence}. Drag to change", sentence=tr(dial.sentence)))
        self._form.addRow(label, field)
        field.edited.connect(lambda value, _key: self._push(name, value / 100.0))
        return field

    def _lay_out(self) -> None:
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(4)
        header = QHBoxLayout()
        header.addWidget(self.arrow)
        header.addStretch(1)
        header.addWidget(self.reset)
        column.addLayout(header)
        column.addWidget(self._body)

    def _push(self, name: str, factor: float) -> None:
        self._tracking.turn(name, factor)
        self.pull()
        self._turned()

    def _reset(self) -> None:
        self._tracking.reset()
        self.pull()
        self._turned()
