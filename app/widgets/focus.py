"""The viewer has the keyboard: edit keys mean what lies under the hand, whatever was typed before."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, Qt, QTimer
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QAbstractItemView, QAbstractSpinBox, QApplication, QLineEdit, QMainWindow, QWidget
from shiboken6 import isValid

from .controls import FrameField
from .fields import NameField, NumberField
from .floating import FloatingWindow

Field = QLineEdit | QAbstractSpinBox
"""What is typed into."""

KEEPS_KEYBOARD = "keepsKeyboard"
"""The property of a field that knows itself when it is done with: the palette's."""

LEAVING = {Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Escape}


class FocusFollowsPointer(QObject):
    """Gives `viewer` the keyboard when the pointer enters it, and when a field of its window is done with.

    So it does where what had the keyboard is hidden: Qt would give it to the next control, a tool's button.
    What is being typed keeps the keyboard until Return takes it, Esc takes it back, or the viewer is pressed. A second
    viewer does not mind fields: done with, they give the keyboard to the first.
    """

    def __init__(self, viewer: QWidget, *, minds_fields: bool = True) -> None:
        super().__init__(viewer)
        self._viewer = viewer
        self._field: Field | None = None
        self._before = ""
        viewer.installEventFilter(self)
        application = QApplication.instance()
        assert isinstance(application, QApplication)
        if minds_fields:
            application.focusChanged.connect(self._follow)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if watched is self._viewer:
            if event.type() == QEvent.Type.Enter and not _is_typed_into(QApplication.focusWidget()):
                self._take()
        elif watched is self._field and isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
            return self._leave(event)
        return False

    # ---- the rest is private

    def _follow(self, old: QWidget | None, now: QWidget | None) -> None:
        """Watch the field that has the keyboard, where it lies in the viewer's window; forget the one before."""
        if old is not None and now is not None and self._is_ours(old.window()):
            QTimer.singleShot(0, self._viewer, lambda: self._pass_on(old, now))
        if self._field is not None and isValid(self._field):
            self._field.removeEventFilter(self)
        self._field = None
        if isinstance(now, Field) and self._is_ours(now.window()) and not now.property(KEEPS_KEYBOARD):
            self._field, self._before = now, _line_of(now).text()
            now.installEventFilter(self)

    def _leave(self, event: QKeyEvent) -> bool:
        """Return is the field's own, and done after it; Esc puts back what stood there, so that nothing is changed."""
        if event.key() not in LEAVING or self._field is None:
            return False
        if _is_of_a_list(self._field):  # which takes its text, or takes it back, and only then the field itself away
            self._field.destroyed.connect(self._take)
            return False
        if event.key() == Qt.Key.Key_Escape:
            if isinstance(self._field, NumberField | NameField | FrameField):
                self._field.take_back()
            else:
                _line_of(self._field).setText(self._before)
        QTimer.singleShot(0, self._viewer, self._take)
        return event.key() == Qt.Key.Key_Escape

    def _pass_on(self, old: QWidget, now: QWidget) -> None:
        """Take the keyboard that `now` got for no other reason than that `old`, which had it, is in sight no more."""
        if now is QApplication.focusWidget() and isValid(old) and not old.isVisible() and self._is_ours(now.window()):
            self._take()

    def _is_ours(self, window: QWidget) -> bool:
        """True for the viewer's own window, and for parts of it that float, unless a viewer floats among them."""
        if window is self._viewer.window():
            return True
        return isinstance(window, FloatingWindow) and window.parentWidget() is self._viewer.window()

    def _take(self) -> None:
        """Give the viewer the keyboard, also where another of our windows has it; not over a dialog."""
        active = QApplication.activeWindow()
        if active is not None and active is not self._viewer.window() and _is_main_or_part(active):
            self._viewer.activateWindow()
        self._viewer.setFocus()


def end_typing(window: QWidget) -> None:
    """Take what is being typed, in the window or in one that floats beside it."""
    for held in (QApplication.focusWidget(), window.focusWidget()):
        if held is not None and _is_typed_into(held):
            held.clearFocus()


def takes_key(event: QEvent) -> bool:
    """Whether a field for words takes a key that the window has a shortcut for; then it accepts the event.

    It takes those without Ctrl, such as Esc for stopping, and Return. Ctrl with Alt writes signs on some keyboards.
    """
    if not isinstance(event, QKeyEvent) or event.type() != QEvent.Type.ShortcutOverride:
        return False
    is_return = event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter)
    held = event.modifiers() & (Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier)
    taken = is_return or held != Qt.KeyboardModifier.ControlModifier
    if taken:
        event.accept()
    return taken


def _is_main_or_part(window: QWidget) -> bool:
    return isinstance(window, FloatingWindow | QMainWindow)


def _is_typed_into(widget: QWidget | None) -> bool:
    return isinstance(widget, Field) or (widget is not None and bool(widget.property(KEEPS_KEYBOARD)))


def _is_of_a_list(field: Field) -> bool:
    """Whether a list lays the field over one of its rows, and closes it."""
    around = field.parentWidget()
    return around is not None and isinstance(around.parentWidget(), QAbstractItemView)


def _line_of(field: Field) -> QLineEdit:
    return field if isinstance(field, QLineEdit) else field.lineEdit()
