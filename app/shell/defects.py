"""Defects: an error that nobody caught, in a slot or a thread, costs no work and becomes a report to copy."""

from __future__ import annotations

import logging
import sys
import threading
from collections.abc import Callable
from types import TracebackType

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtWidgets import QDialog, QWidget
from shiboken6 import isValid

from ..dialogs.report_dialog import ReportDialog
from ..features.messages import MessageLog
from ..journal.journal import Journal
from ..model.view_state import ViewState
from ..translation import N_, tr
from . import crash_report

KEPT, AT_RISK = (
    N_("Your project is as it was, and every edit is in the journal."),
    N_("Save your work under a new name now."),
)
PATIENCE = 1.0
"""Seconds for which the window waits until the journal holds every edit, before it says so."""
MOST_SHOWN = 20
"""Different errors that are shown; an error that comes with every repaint is shown once."""

log = logging.getLogger("roam")


class _LastError(logging.Handler):
    """Keeps the trace of the last error that was logged: that of a job, for example, which ends in a sentence."""

    def __init__(self) -> None:
        super().__init__(logging.ERROR)
        self.trace = ""

    def emit(self, record: logging.LogRecord) -> None:
        if record.exc_info and record.exc_info[1] is not None:
            self.trace = crash_report.told(record.exc_info[1])


class Defects(QObject):
    """Hears of every error that nobody caught, on any thread, while it is installed.

    `parent` is the widget that reports lie over.
    """

    _arrived = Signal(str)

    def __init__(self, view_state: ViewState, journal: Journal, messages: MessageLog, parent: QWidget) -> None:
        super().__init__(parent)
        self._view, self._journal, self._messages, self._parent = view_state, journal, messages, parent
        self._seen: set[str] = set()
        self._last_error = _LastError()
        self._hooks: tuple[Callable[..., object], Callable[..., object]] | None = None
        self.dialog: ReportDialog | None = None
        # Queued, so that a dialog is never opened in the midst of what failed, nor by another thread.
        self._arrived.connect(self._show, Qt.ConnectionType.QueuedConnection)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"help.report": self.report_now}

    def install(self) -> None:
        """Hear of errors from now on."""
        self._hooks = sys.excepthook, threading.excepthook
        sys.excepthook = self._in_a_slot
        threading.excepthook = lambda args: self._in_a_thread(args)
        logging.getLogger().addHandler(self._last_error)

    def remove(self) -> None:
        """Leave errors to whoever heard of them before."""
        if self._hooks is not None:
            sys.excepthook, threading.excepthook = self._hooks
            self._hooks = None
            logging.getLogger().removeHandler(self._last_error)

    def report_now(self) -> None:
        """Show a report that the artist asks for: versions, system, messages, and the last error of a job if any."""
        what = self._last_error.trace or tr("Asked for in the Help menu; no error was noted.")
        self._open(tr("Problem report"), self._what_is_kept()).text.setPlainText(self._report(what))

    def tell_of(self, crashes: list[str]) -> None:
        """Tell of native crashes of before."""
        if crashes:
            sentence = tr("What could be found out about it is below; your edits up to then are in the journal.")
            dialog = self._open(tr("ROAM ended in a crash"), sentence)
            dialog.text.setPlainText(self._report("\n".join(crashes)))

    def wait_for(self, question: QDialog) -> None:
        """Put an open report aside until a question is answered, so that neither lies upon the other."""
        report = self.dialog
        if report is not None and isValid(report) and report.isVisible():
            report.hide()
            question.finished.connect(lambda _: report.show() if isValid(report) else None)

    # ---- the rest is private

    def _in_a_slot(self, kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
        self._note(error.with_traceback(trace))

    def _in_a_thread(self, args: threading.ExceptHookArgs) -> None:
        if args.exc_value is not None and not isinstance(args.exc_value, SystemExit):
            self._note(args.exc_value)

    def _note(self, error: BaseException) -> None:
        log.critical("an error nobody caught", exc_info=error)
        if isValid(self):
            self._arrived.emit(crash_report.told(error))

    def _show(self, trace: str) -> None:
        if trace in self._seen or len(self._seen) >= MOST_SHOWN:
            return
        self._seen.add(trace)
        kept = self._what_is_kept()
        self._view.say(tr("Something went wrong inside ROAM. {kept}", kept=kept))
        is_open = self.dialog is not None and isValid(self.dialog) and self.dialog.isVisible()
        before = self.dialog.text.toPlainText() + "\n" if self.dialog is not None and is_open else ""
        dialog = self._open(tr("Something went wrong inside ROAM"), kept)
        dialog.text.setPlainText(before + self._report(trace))

    def _what_is_kept(self) -> str:
        return tr(KEPT) if self._journal.flush(PATIENCE) else tr(AT_RISK)

    def _open(self, title: str, sentence: str) -> ReportDialog:
        if self.dialog is not None and isValid(self.dialog):
            self.dialog.close()
        self.dialog = ReportDialog(title, sentence, self._parent)
        self.dialog.show()
        return self.dialog

    def _report(self, what: str) -> str:
        return crash_report.report(what, [message.line for message in self._messages.all])
