"""The bar at the lower edge of the viewer that asks about a proposal: what changes, what it gains, the four answers."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QToolButton, QWidget

from app import style
from app.actions import Actions
from app.panels.controls import weak_label
from app.proposals import Proposals, sentence_of

ANSWERS = ("proposal.keep", "proposal.refuse", "proposal.keep_always", "proposal.refuse_always")


class ProposalBar(QWidget):
    """Lies over the viewer while a proposal stands on the present frame; its answers can be given then only."""

    def __init__(self, proposals: Proposals, actions: Actions, viewer: QWidget) -> None:
        super().__init__(viewer)
        self._proposals, self._actions, self._viewer = proposals, actions, viewer
        self.setObjectName("proposalBar")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setCursor(Qt.CursorShape.ArrowCursor)
        self.sentence = QLabel()
        row = QHBoxLayout(self)
        row.setContentsMargins(style.MARGIN, 4, style.MARGIN, 4)
        row.setSpacing(6)
        row.addWidget(self.sentence)
        row.addWidget(weak_label("white dashes: after"))
        row.addSpacing(style.MARGIN)
        for name in ANSWERS:
            row.addWidget(_button(actions, name))
        viewer.installEventFilter(self)
        proposals.changed.connect(self._pull)
        self._pull()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() is QEvent.Type.Resize:
            self._place()
        return False

    def _pull(self) -> None:
        proposal = self._proposals.current
        for name in ANSWERS:
            self._actions[name].setEnabled(proposal is not None)
        self.setVisible(proposal is not None)
        if proposal is not None:
            self.sentence.setText(sentence_of(proposal))
            self._place()
        self._viewer.update()

    def _place(self) -> None:
        self.adjustSize()
        x = max((self._viewer.width() - self.width()) // 2, 0)
        self.move(x, self._viewer.height() - self.height() - 2 * style.MARGIN)


def _button(actions: Actions, action_id: str) -> QToolButton:
    button = QToolButton()
    button.setDefaultAction(actions[action_id])
    button.setObjectName("raised")
    button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
    button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    return button
