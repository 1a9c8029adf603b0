"""What the undo actions and the empty history are called: each names the step that it would take."""

from __future__ import annotations

from PySide6.QtCore import QObject, Slot
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QUndoView

from ..actions.actions import Actions
from ..model.document import Document
from ..translation import N_, tr


def name_steps(document: Document, history: QUndoView, actions: Actions) -> None:
    """Let the actions follow what can be undone, and the history tell what lies before its first step."""
    undo, redo, stack = actions["edit.undo"], actions["edit.redo"], document.undo_stack
    history.setEmptyLabel(tr("As opened"))
    document.forgot.connect(lambda: history.setEmptyLabel(tr("Earlier steps were dropped")))
    document.replaced.connect(lambda: history.setEmptyLabel(tr("As opened")))
    stack.canUndoChanged.connect(undo.setEnabled)
    stack.canRedoChanged.connect(redo.setEnabled)
    stack.undoTextChanged.connect(_StepName(undo, tr("Undo"), N_("Undo {step}")).show)
    stack.redoTextChanged.connect(_StepName(redo, tr("Redo"), N_("Redo {step}")).show)


class _StepName(QObject):
    """Names an action by its step. It goes with the action: an undo stack tells of its end after those of a window."""

    def __init__(self, action: QAction, bare: str, named: str) -> None:
        super().__init__(action)
        self._action, self._bare, self._named = action, bare, named

    @Slot(str)
    def show(self, step: str) -> None:
        """Name the action by this step; none: plainly."""
        self._action.setText(tr(self._named, step=step) if step else self._bare)
