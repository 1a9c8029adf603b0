"""Controls that can show several values at once: numbers that are typed or dragged, names, switches, choices."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import count
from typing import TypeVar

from PySide6.QtCore import QEvent, QSignalBlocker, Qt, Signal
from PySide6.QtGui import QEnterEvent, QFocusEvent, QKeyEvent, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QCheckBox, QLabel, QLineEdit

from roam_core.roto import BlendMode

from .. import style
from ..translation import N_, tr
from .controls import LABEL_WIDTH, ChoiceBox, is_being_typed
from .number_boxes import DecimalBox, Verdict, typed_number

MIXED = N_("mixed")
"""What a control shows for things that differ."""

PIXELS_A_STEP = 4.0
"""How far the pointer goes for one step while it drags a label, in widget units."""

BLENDS = {
    BlendMode.ADD: N_("Add"),
    BlendMode.PLUS: N_("Plus"),
    BlendMode.SUBTRACT: N_("Subtract"),
    BlendMode.INTERSECT: N_("Intersect"),
    BlendMode.DIFFERENCE: N_("Difference"),
    BlendMode.MAX: N_("Max"),
}
MEANINGS = {
    BlendMode.ADD: N_("Joins with what lies under it, soft edges as one painted over the other"),
    BlendMode.PLUS: N_("The sum of both, as projects of earlier versions added: soft edges that overlap grow hard"),
    BlendMode.SUBTRACT: N_("Cuts a hole into what lies under it"),
    BlendMode.INTERSECT: N_("Keeps only what both cover"),
    BlendMode.DIFFERENCE: N_("Keeps what one of both covers and the other does not"),
    BlendMode.MAX: N_("The greater of both"),
}
"""What the modes do, for tooltips."""

Value = TypeVar("Value")
_gestures = count(1)
_DRAG = "drag"
"""How merge keys of drags begin."""


def means_what_was_shown(merge_key: str) -> bool:
    """Whether a number of that merge key was typed or dragged, and means what was shown as that began.

    A step means what is shown now.
    """
    return not merge_key or merge_key.startswith(_DRAG)


def shared(values: Iterable[Value]) -> Value | None:
    """The one value that all have, or None where they differ or there is none."""
    first, *others = values
    return first if all(other == first for other in others) else None


class NumberField(DecimalBox):
    """A number that is typed, stepped (wheel, arrow keys) or dragged by its label. It can show that values differ.

    Signals
    -------
    edited(value, merge_key) : the user gave a value. Steps of one gesture (a held key, a turn of the wheel, a drag)
        share a merge key; a typed value has none.
    """

    edited = Signal(float, str)
    taken = Signal()
    """Typing, or a drag of the label, begins: what comes of it means what is shown now."""

    def __init__(
        self, low: float, high: float, *, suffix: str = "", decimals: int = 0, step: float = 1.0, tip: str = ""
    ) -> None:
        super().__init__()
        self._mixed = self._typed = self._is_begun = False
        self._words, self._merge_key = suffix, ""
        self._held: float | None = 0.0
        """The value that holds, whatever is being typed; None where several differ."""
        self._low, self._high = low, high
        self.setRange(low, high)
        self.setDecimals(decimals)
        self.setSingleStep(step)
        self.setSuffix(suffix)
        self.setToolTip(tip)
        self.setKeyboardTracking(False)
        self.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccessibleDescription(tip)
        self.lineEdit().setPlaceholderText(tr(MIXED))
        self.lineEdit().setTextMargins(0, 0, 4, 0)
        self.lineEdit().textEdited.connect(self._note_typing)
        self.editingFinished.connect(self._push_typed)

    def show_value(self, value: float | None, begin: float | None = None) -> None:
        """Show a value, or that several differ (None); then `begin` is where steps and drags begin. What is being typed
        stays.
        """
        self._held = value
        if is_being_typed(self.lineEdit()):
            return
        with QSignalBlocker(self):
            self._mixed, self._typed = value is None, False
            self.setSuffix("" if value is None else self._words)
            known = value if value is not None else begin
            if known is not None:
                self.setRange(min(self._low, known), max(self._high, known))  # files may hold more than is given here
                self.setValue(known)
            self.lineEdit().setText(self.text() if value is not None else "")

    @property
    def is_mixed(self) -> bool:
        return self._mixed

    def begin_drag(self) -> None:
        """The label is dragged from now on: a change of its own, and of what is shown now."""
        self._merge_key = f"{_DRAG} {next(_gestures)}"
        self.taken.emit()

    def begin_gesture(self) -> None:
        """What is stepped or dragged from now on is a change of its own."""
        self._merge_key = f"number {next(_gestures)}"

    def drag_to(self, value: float) -> None:
        """Take a value from a drag that `begin_gesture` began."""
        self.forget_typing()
        with QSignalBlocker(self):
            self.setValue(value)
        self._give(self._merge_key)

    def forget_typing(self) -> None:
        """What was typed is no value to give: it meant what is no longer shown."""
        self._typed = self._is_begun = False
        self.lineEdit().setModified(False)

    def take_back(self) -> None:
        """Show the value that holds in place of what is being typed."""
        self.forget_typing()
        self.show_value(self._held)

    # ---- Qt's own doors

    def textFromValue(self, value: float) -> str:
        return "" if self._mixed else super().textFromValue(value)

    def validate(self, text: str, position: int) -> Verdict:
        """Point and comma both part the decimals, whatever the language's is: no number here has groups."""
        if not self.decimals():
            return super().validate(text, position)
        body = text.removesuffix(self._words) if self._words else text
        point = self.locale().decimalPoint()
        body = body.replace(".", point).replace(",", point)
        return super().validate(body + text[len(body) :], position)

    def stepBy(self, steps: int) -> None:
        self._mixed = False
        self.forget_typing()
        super().stepBy(steps)
        self._give(self._merge_key)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if not event.isAutoRepeat():
            self.begin_gesture()
        super().keyPressEvent(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        # A field that was not chosen lets the panel scroll: a number changed by the way is not noticed.
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()

    def enterEvent(self, event: QEnterEvent) -> None:
        self.begin_gesture()
        super().enterEvent(event)

    def focusInEvent(self, event: QFocusEvent) -> None:
        self.begin_gesture()
        super().focusInEvent(event)

    def _note_typing(self, text: str) -> None:
        if not self._is_begun:
            self._is_begun = True
            self.taken.emit()
        # What is no number yet, as a lone sign, is none to give.
        self._typed = typed_number(self, text) is not None

    def _push_typed(self) -> None:
        was_typed = self._typed
        self.forget_typing()
        if was_typed:
            self._mixed = False
            self._give("")

    def _give(self, merge_key: str) -> None:
        self._held = self.value()
        self.edited.emit(self._held, merge_key)


class NameField(QLineEdit):
    """A name to type, or several things that have one each.

    Signals
    -------
    named(name) : the user is done with the field; `name` may be what it was.
    """

    named = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self._held = ""
        """The name that holds, whatever is being typed."""
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.editingFinished.connect(self._push)

    def show_name(self, name: str, instead: str = "") -> None:
        """Show a name; where there is none, what the field says `instead`. What is being typed stays."""
        self._held = name
        self.setPlaceholderText(instead)
        if not is_being_typed(self):
            self.setText(name)

    def forget_typing(self) -> None:
        """What was typed is no name to give: it meant what is no longer shown."""
        self.setModified(False)

    def take_back(self) -> None:
        """Show the name that holds in place of what is being typed."""
        self.setText(self._held)

    def _push(self) -> None:
        was_typed = self.isModified()
        self.setModified(False)
        self.named.emit(self.text().strip() if was_typed else self._held)


class ScrubLabel(QLabel):
    """A form's label that changes its number field when it is dragged sideways; Shift ten times as fast, Ctrl slow."""

    def __init__(self, text: str, field: NumberField) -> None:
        super().__init__(text)
        self.setObjectName("weak")
        self.setMinimumWidth(LABEL_WIDTH)
        self.setMinimumHeight(style.ROW_HEIGHT)
        self._field = field
        self._last: float | None = None
        self._reached, self._is_begun = 0.0, False
        self.setCursor(Qt.CursorShape.SizeHorCursor)
        self.setToolTip(tr("Drag to change; Shift: faster, Ctrl: finer"))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() is Qt.MouseButton.LeftButton and self._field.isEnabled():
            self._last, self._reached, self._is_begun = event.position().x(), self._field.value(), False

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._last is None:
            return
        if not self._is_begun:  # a mere press changes nothing that is being typed
            self._is_begun = True
            self._field.begin_drag()
        moved, self._last = event.position().x() - self._last, event.position().x()
        pace = {Qt.KeyboardModifier.ShiftModifier: 10.0, Qt.KeyboardModifier.ControlModifier: 0.1}
        self._reached += moved / PIXELS_A_STEP * self._field.singleStep() * pace.get(event.modifiers(), 1.0)
        self._reached = min(max(self._reached, self._field.minimum()), self._field.maximum())
        self._field.drag_to(self._reached)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._last = None

    def changeEvent(self, event: QEvent) -> None:
        if event.type() is QEvent.Type.EnabledChange and not self.isEnabled():
            self._last = None
        super().changeEvent(event)


class BlendBox(ChoiceBox):
    """The modes by which a matte may join what lies under it. It can show that they differ.

    `picked(mode)` tells of a mode that is not the one that was shown.
    """

    picked = Signal(BlendMode)

    def __init__(self, tip: str) -> None:
        super().__init__(tip)
        self.setPlaceholderText(tr(MIXED))
        for mode in BlendMode:
            self.addItem(tr(BLENDS[mode]), mode)
            self.setItemData(self.count() - 1, tr(MEANINGS[mode]), Qt.ItemDataRole.ToolTipRole)
        self.currentIndexChanged.connect(lambda _: self.picked.emit(BlendMode(self.currentData())))

    def show_mode(self, mode: BlendMode | None) -> None:
        """Show a mode, or that they differ (None)."""
        with QSignalBlocker(self):
            self.setCurrentIndex(-1 if mode is None else self.findData(mode))


class SwitchBox(QCheckBox):
    """A switch that can show that some are on and some off; a click then turns all on.

    `clicked(on)` tells of the user's clicks alone.
    """

    def __init__(self, text: str, tip: str) -> None:
        super().__init__(text)
        self.setToolTip(tip)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setAccessibleDescription(tip)

    def show_value(self, value: bool | None) -> None:
        """Show on, off, or that they differ (None)."""
        states = {None: Qt.CheckState.PartiallyChecked, True: Qt.CheckState.Checked, False: Qt.CheckState.Unchecked}
        with QSignalBlocker(self):
            self.setTristate(value is None)
            self.setCheckState(states[value])

    def nextCheckState(self) -> None:
        on = self.checkState() is not Qt.CheckState.Checked
        self.setTristate(False)
        self.setCheckState(Qt.CheckState.Checked if on else Qt.CheckState.Unchecked)
