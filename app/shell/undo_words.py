"""What the undo actions and the empty history are called: each names the step that it would take."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, Slot
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QUndoView

from ..actions.actions import Actions
from ..model.document import Document
from ..tools.in_hand import ToolInHand
from ..translation import N_, tr


def name_steps(document: Document, hand: ToolInHand, history: QUndoView, actions: Actions) -> None:
    """Let the actions follow what can be undone, and the history tell what lies before its first step."""
    undo, redo, stack = actions["edit.undo"], actions["edit.redo"], document.undo_stack
    history.setEmptyLabel(tr("As opened"))
    document.forgot.connect(lambda: history.setEmptyLabel(tr("Earlier steps were dropped")))
    document.replaced.connect(lambda: history.setEmptyLabel(tr("As opened")))
    undoing = _StepName(undo, tr("Undo"), N_("Undo {step}"), lambda: hand.tool.last_step)
    redoing = _StepName(redo, tr("Redo"), N_("Redo {step}"))
    stack.undoTextChanged.connect(undoing.take)
    stack.redoTextChanged.connect(redoing.take)
    for changed in (hand.used, hand.looked, hand.changed, document.replaced):
        changed.connect(undoing.show)


class _StepName(QObject):
    """Names an action by its step. It goes with the action: an undo stack tells of its end after those of a window."""

    def __init__(self, action: QAction, bare: str, named: str, half_done: Callable[[], str] = str) -> None:
        """`half_done()` is what the action would take before any step of the stack; "" where there is nothing."""
        super().__init__(action)
        self._action, self._bare, self._named, self._half_done, self._step = action, bare, named, half_done, ""
        self.show()

    @Slot(str)
    def take(self, step: str) -> None:
        """The stack's step is this one now; "" where there is none."""
        self._step = step
        self.show()

    @Slot()
    def show(self) -> None:
        """Name the action by its step, and offer it; where there is none, plainly and not at all."""
        step = self._half_done() or self._step
        self._action.setText(tr(self._named, step=step) if step else self._bare)
        self._action.setEnabled(bool(step))
