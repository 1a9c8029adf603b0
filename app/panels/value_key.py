"""The small button beside a value that may vary with time: shows whether it has a key here, sets and deletes keys."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from PySide6.QtCore import QPoint, Qt, QTimer, Signal
from PySide6.QtGui import QAction, QMouseEvent
from PySide6.QtWidgets import QHBoxLayout, QMenu, QToolButton, QWidget

from roam_core.roto import Interpolation
from roam_core.roto.animated import Animatable
from roam_core.roto.value_keys import Keying, bent, interpolated, keyed, keying, leading_key, still, unkeyed

from .. import style
from ..model.view_state import ViewState
from ..translation import N_, tr
from ..widgets.fields import NumberField, means_what_was_shown, shared

ValueVerb = Callable[[Animatable], Animatable]

LOOKS = {
    Keying.CONSTANT: ("value-none", style.WEAK, N_("It never varies. Click to set a key on this frame")),
    Keying.KEY: ("value-here", style.ACCENT, N_("It has a key on this frame. Click to delete it")),
    Keying.BETWEEN: ("value-between", style.ACCENT, N_("It varies, without a key on this frame. Click to set one")),
}
"""Drawing, colour and tooltip of each state."""
WAYS = {
    Interpolation.LINEAR: (N_("Linear"), N_("linear")),
    Interpolation.SMOOTH: (N_("Smooth"), N_("smooth")),
    Interpolation.HOLD: (N_("Hold"), N_("hold")),
}
"""How a value goes on from a key: in the menu, and in the name of a step."""
DIFFER = N_("Some have a key on this frame or vary, others do not. Click to set a key on all")


class ValueKeyButton(QToolButton):
    """Empty for a constant, filled for a key on this frame, half filled for a value that varies without one here.

    Of several things it is filled where all have a key here, empty where all are constant. It takes the keyboard by Tab
    alone.

    `acted(text, verb)` asks for a change: what it is called and what becomes of each value.
    """

    acted = Signal(str, object)

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("flat")
        self.setIconSize(style.ICON_SIZE)
        self.setFixedSize(20, 20)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.customContextMenuRequested.connect(self._show_menu)
        self.clicked.connect(self._click)
        self._icons = {state: style.icon(name, colour) for state, (name, colour, _) in LOOKS.items()}
        self.frame = 0
        """The frame on which keys are set and deleted."""
        self.state = Keying.CONSTANT
        self._is_new, self._takes_new = False, False
        """Whether a key came just now, and whether the press did that: it took what was typed in the field."""
        self.menu_of_keys = QMenu(self)
        self._set = self._entry(tr("Set key"), tr("set key"), lambda value: keyed(value, self.frame))
        self._delete = self._entry(tr("Delete key"), tr("delete key"), lambda value: unkeyed(value, self.frame))
        self._delete_all = self._entry(
            tr("Delete all keys"), tr("delete all keys"), lambda value: still(value, self.frame)
        )
        self.menu_of_keys.addSeparator()
        self._ways = {kind: self._way(kind) for kind in Interpolation}
        self._tangents = self._entry(tr("Tangents"), tr("tangents"), lambda value: bent(value, self.frame))
        self._tangents.setCheckable(True)
        self._tangents.setToolTip(tr("It runs smoothly through its key here, or the last one before, by tangents"))
        self.show_values([0.0], 0)

    def show_values(self, values: Sequence[Animatable], frame: int) -> None:
        """Show what the values have on a frame."""
        before, is_same_frame = self.state, frame == self.frame
        self.frame = frame
        states = {keying(value, frame) for value in values}
        is_one = len(states) == 1
        self.state = states.pop() if is_one else Keying.BETWEEN
        if is_same_frame and self.state is Keying.KEY and before is not Keying.KEY:
            self._is_new = True
            QTimer.singleShot(0, self, self._settle)
        self.setIcon(self._icons[self.state])
        self.setToolTip(tr(LOOKS[self.state][2]) if is_one else tr(DIFFER))
        self.setAccessibleDescription(self.toolTip())
        leading = [key for value in values if (key := leading_key(value, frame)) is not None]
        way = shared(key.interpolation for key in leading) if leading else None
        is_bent = bool(leading) and all(key.slopes is not None for key in leading)
        self._tangents.setChecked(is_bent)
        self._set.setEnabled(self.state is not Keying.KEY)
        self._delete.setEnabled(any(keying(value, frame) is Keying.KEY for value in values))
        for action in (self._delete_all, *self._ways.values(), self._tangents):
            action.setEnabled(bool(leading))
        for kind, action in self._ways.items():
            action.setChecked(kind is way and not is_bent)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        super().mousePressEvent(event)  # takes what is typed
        self._takes_new = self._is_new

    # ---- the rest is private

    def _entry(self, text: str, step: str, verb: ValueVerb) -> QAction:
        """An entry of the menu, and what its step is called within a sentence."""
        action = self.menu_of_keys.addAction(text)
        action.triggered.connect(lambda: self.acted.emit(step, verb))
        return action

    def _way(self, kind: Interpolation) -> QAction:
        action = self._entry(tr(WAYS[kind][0]), tr(WAYS[kind][1]), lambda value: interpolated(value, self.frame, kind))
        action.setCheckable(True)
        action.setToolTip(tr("How the value goes on from its key here, or the last one before"))
        return action

    def _settle(self) -> None:
        self._is_new = False

    def _click(self) -> None:
        """Set a key or delete the one that is shown; what was typed before the click has set one already."""
        is_done, self._takes_new = self._takes_new and self.state is Keying.KEY, False
        if not is_done:
            (self._delete if self.state is Keying.KEY else self._set).trigger()
            self._settle()  # a key of its own is known at once

    def _show_menu(self, place: QPoint) -> None:
        self.menu_of_keys.popup(self.mapToGlobal(place))


class KeyedFrame:
    """The frame that numbers of a field mean: of what is typed or dragged the one on which that began."""

    def __init__(self, field: NumberField, view_state: ViewState) -> None:
        self._view, self._begun = view_state, view_state.frame
        field.taken.connect(self._note)

    def of(self, merge_key: str) -> int:
        return self._begun if means_what_was_shown(merge_key) else self._view.frame

    def _note(self) -> None:
        self._begun = self._view.frame


def keyed_row(field: NumberField, button: ValueKeyButton) -> QWidget:
    """A field with its button beside it, as one row of a form."""
    row = QWidget()
    box = QHBoxLayout(row)
    box.setContentsMargins(0, 0, 0, 0)
    box.setSpacing(4)
    box.addWidget(field, 1)
    box.addWidget(button)
    button.pressed.connect(field.clearFocus)  # a press gives it no keyboard, and would leave what is typed
    field.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
    field.customContextMenuRequested.connect(partial(_popup, field, button))
    return row


def _popup(field: NumberField, button: ValueKeyButton, place: QPoint) -> None:
    """What can be done with keys, and below it what can be done with the text."""
    menu = field.lineEdit().createStandardContextMenu()
    menu.setObjectName("field")
    menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    first = menu.actions()[0]
    menu.insertActions(first, button.menu_of_keys.actions())
    menu.insertSeparator(first)
    menu.popup(field.mapToGlobal(place))
