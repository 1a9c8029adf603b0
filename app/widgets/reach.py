"""The keyboard reaches every control: from part to part of the window, and within a part by Tab."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QAbstractButton, QAbstractSlider, QApplication, QComboBox, QScrollArea, QWidget
from shiboken6 import isValid

from .floating import FloatingWindow

Control = QAbstractButton | QComboBox | QAbstractSlider
"""What has keys of its own while it has the keyboard, and takes it by Tab alone, never by a click."""

_KEY = Qt.Key
PRESSING = {_KEY.Key_Return, _KEY.Key_Enter, _KEY.Key_Space}
CHANGING = {_KEY.Key_Up, _KEY.Key_Down, _KEY.Key_Left, _KEY.Key_Right, _KEY.Key_Home, _KEY.Key_End}


class KeyboardReach(QObject):
    """Gives the keyboard from part to part, and lets the control that has it be worked by it.

    While a control has the keyboard, Space and Return press it, and the arrows change what has values, whatever else
    these keys mean in the window. Esc gives the keyboard back to the viewer, and means what it means besides.
    `parts` are those of the window in their order, the viewer among them.
    """

    def __init__(self, viewer: QWidget, parts: Sequence[QWidget]) -> None:
        super().__init__(viewer)
        self._viewer, self._parts = viewer, parts
        self._control: Control | None = None
        application = QApplication.instance()
        assert isinstance(application, QApplication)
        application.focusChanged.connect(self._follow)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"view.next_part": lambda: self._go(1), "view.previous_part": lambda: self._go(-1)}

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if watched is not self._control or not isinstance(event, QKeyEvent):
            return False
        key, has_keys = event.key(), not event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
        if event.type() == QEvent.Type.ShortcutOverride:
            if key == _KEY.Key_Escape:
                self._viewer.activateWindow()
                self._viewer.setFocus()
            elif has_keys and key in _keys_of(self._control):
                event.accept()
                return True
        elif event.type() == QEvent.Type.KeyPress and has_keys and key in PRESSING - {_KEY.Key_Space}:
            _press(self._control)
            return True
        return False

    # ---- the rest is private

    def _follow(self, _old: QWidget | None, now: QWidget | None) -> None:
        """Watch the control that has the keyboard, where it lies in the viewer's window; forget the one before."""
        if self._control is not None and isValid(self._control):
            self._control.removeEventFilter(self)
        self._control = None
        main, window = self._viewer.window(), None if now is None else now.window()
        is_part = isinstance(window, FloatingWindow) and window.parentWidget() is main
        if isinstance(now, Control) and (window is main or is_part):
            self._control = now
            now.installEventFilter(self)

    def _go(self, step: int) -> None:
        """Give the keyboard to the first control of the next part that has one in sight."""
        held = QApplication.focusWidget()
        here = next((place for place, part in enumerate(self._parts) if _holds(part, held)), 0)
        for steps in range(1, len(self._parts) + 1):
            part = self._parts[(here + steps * step) % len(self._parts)]
            if (found := next(reachable(part), None)) is not None:
                found.activateWindow()
                found.setFocus(Qt.FocusReason.TabFocusReason)
                _bring_into_sight(found)
                return


def reachable(part: QWidget) -> Iterator[QWidget]:
    """What of a part the keyboard reaches by Tab now, in the order of Tab; the part itself, where it is a control."""
    widget: QWidget | None = part
    while widget is not None:
        is_there = _holds(part, widget) and widget.isVisible() and widget.isEnabled()
        if is_there and widget.focusPolicy() & Qt.FocusPolicy.TabFocus:
            yield widget
        widget = widget.nextInFocusChain()
        if widget is part:
            return


def _holds(part: QWidget, widget: QWidget | None) -> bool:
    return widget is not None and (part is widget or part.isAncestorOf(widget))


def _keys_of(control: Control) -> set[Qt.Key]:
    return PRESSING if isinstance(control, QAbstractButton) else PRESSING | CHANGING


def _press(control: Control) -> None:
    """What Return does: a button is clicked, a list shows what there is to choose from."""
    if isinstance(control, QAbstractButton):
        control.click()
    elif isinstance(control, QComboBox):
        control.showPopup()


def _bring_into_sight(widget: QWidget) -> None:
    around = widget.parentWidget()
    while around is not None and not isinstance(around, QScrollArea):
        around = around.parentWidget()
    if isinstance(around, QScrollArea):
        around.ensureWidgetVisible(widget)
