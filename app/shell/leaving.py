"""Leaving in good order when the terminal or the desktop asks for it by a signal."""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QObject, QSocketNotifier, QTimer
from PySide6.QtWidgets import QApplication, QDialog

LOOK_INTERVAL = 200
"""Milliseconds between two looks for signals, where nothing wakes the window."""


def leave_on_signals(leave: Callable[[], object], owner: QObject) -> None:
    """Call `leave` on Ctrl+C in the terminal, a logout, and the terminal's end, as long as `owner` lives.

    Questions that are open end first, unanswered.
    """
    asked: list[int] = []
    for name in ("SIGINT", "SIGTERM", "SIGHUP"):
        if hasattr(signal, name):  # Windows knows no SIGHUP
            signal.signal(getattr(signal, name), lambda number, _: asked.append(number))
    # Python handles signals between its own instructions, and Qt's loop runs none while nothing happens.
    if sys.platform == "win32":
        _look_for(asked, partial(leave_questions_and, leave), owner)
    else:
        _wake_on_signals(partial(leave_questions_and, leave), owner)


def leave_questions_and(leave: Callable[[], object]) -> None:
    """End every dialog that waits for an answer, as if it was cancelled, then call `leave`.

    Qt lets no window close that lies behind one.
    """
    for widget in QApplication.topLevelWidgets():
        if isinstance(widget, QDialog) and widget.isModal() and widget.isVisible():
            widget.done(QDialog.DialogCode.Rejected)
    leave()


def _look_for(asked: list[int], leave: Callable[[], object], owner: QObject) -> None:
    """Look now and then whether a signal has come."""
    timer = QTimer(owner, interval=LOOK_INTERVAL)

    def look() -> None:
        if asked:
            timer.stop()
            leave()

    timer.timeout.connect(look)
    timer.start()


def _wake_on_signals(leave: Callable[[], object], owner: QObject) -> None:
    """Be woken by the byte that Python writes into a pipe when a signal has come."""
    ends = reading, writing = os.pipe()
    for end in ends:
        os.set_blocking(end, False)
    signal.set_wakeup_fd(writing)
    notifier = QSocketNotifier(reading, QSocketNotifier.Type.Read, owner)

    def leave_once() -> None:
        notifier.setEnabled(False)
        signal.set_wakeup_fd(-1)
        for end in ends:
            os.close(end)
        leave()

    notifier.activated.connect(leave_once)
