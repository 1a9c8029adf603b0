"""What the undo actions and the empty history are called: each names the step that it would take."""

from __future__ import annotations

from PySide6.QtWidgets import QUndoView

from ..actions.actions import Actions
from ..model.document import Document
from ..translation import tr


def name_steps(document: Document, history: QUndoView, actions: Actions) -> None:
    """Let the actions follow what can be undone, and the history tell what lies before its first step."""
    undo, redo, stack = actions["edit.undo"], actions["edit.redo"], document.undo_stack
    history.setEmptyLabel(tr("As opened"))
    document.forgot.connect(lambda: history.setEmptyLabel(tr("Earlier steps were dropped")))
    document.replaced.connect(lambda: history.setEmptyLabel(tr("As opened")))
    stack.canUndoChanged.connect(undo.setEnabled)
    stack.canRedoChanged.connect(redo.setEnabled)
    stack.undoTextChanged.connect(lambda text: undo.setText(tr("Undo {step}", step=text) if text else tr("Undo")))
    stack.redoTextChanged.connect(lambda text: redo.setText(tr("Redo {step}", step=text) if text else tr("Redo")))
