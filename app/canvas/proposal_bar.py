"""The bar at the lower edge of the viewer that asks about a proposal: what changes, what it gains, the four answers."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QToolButton, QWidget

from roam_core.propagate.frame.topology_proposals import Proposal

from .. import style
from ..actions.actions import Actions
from ..features.proposals import Proposals, sentence_of
from ..translation import N_, tr
from ..widgets.controls import weak_label
from .items.proposal import Side
from .view import CanvasView

ANSWERS = ("proposal.keep", "proposal.refuse", "proposal.keep_always", "proposal.refuse_always")
SIDES = {"proposal.keep": Side.AFTER, "proposal.refuse": Side.BEFORE}
"""What the viewer shows while the pointer rests on an answer."""

LEGEND = N_("line: before, white dashes: after, hatched: what differs")
GAIN = N_(
    "The energy is the engine's measure of how badly outlines agree with the picture:\n"
    "the farther it falls, the more speaks for the change."
)


class ProposalBar(QWidget):
    """Lies over the viewer while a proposal stands on the present frame; its answers can be given then only."""

    def __init__(self, proposals: Proposals, actions: Actions, viewer: CanvasView) -> None:
        super().__init__(viewer)
        self._proposals, self._actions, self._viewer = proposals, actions, viewer
        self._shown: Proposal | None = None
        self.setObjectName("proposalBar")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setCursor(Qt.CursorShape.ArrowCursor)
        self.sentence, self.legend = QLabel(), weak_label(tr(LEGEND))
        self.sentence.setToolTip(tr(GAIN))
        self.buttons = {name: _button(actions, name) for name in ANSWERS}
        self._keys = {name: weak_label("") for name in SIDES}
        row = QHBoxLayout(self)
        row.setContentsMargins(style.MARGIN, 4, style.MARGIN, 4)
        row.setSpacing(6)
        row.addWidget(self.sentence)
        row.addWidget(self.legend)
        row.addSpacing(style.MARGIN)
        for name, button in self.buttons.items():
            row.addWidget(button)
            if name in SIDES:
                row.addWidget(self._keys[name])
                row.addSpacing(style.MARGIN)
                button.installEventFilter(self)
        viewer.installEventFilter(self)
        proposals.changed.connect(self._pull)
        actions.keymap_changed.connect(self._pull_keys)
        self._pull_keys()
        self._pull()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if watched is self._viewer:
            if event.type() is QEvent.Type.Resize:
                self._place()
        elif event.type() in (QEvent.Type.Enter, QEvent.Type.Leave):
            name = next(name for name, button in self.buttons.items() if button is watched)
            self._viewer.show_proposal(SIDES[name] if event.type() is QEvent.Type.Enter else Side.BOTH)
        return False

    def _pull(self) -> None:
        proposal = self._proposals.current
        for name in ANSWERS:
            self._actions[name].setEnabled(proposal is not None)
        self.setVisible(proposal is not None)
        if proposal is not None:
            self.sentence.setText(sentence_of(proposal))
            self._place()
        if proposal is not self._shown:  # in playback nothing is painted twice for a bar that is not there
            self._shown = proposal
            self._viewer.show_proposal(Side.BOTH)

    def _pull_keys(self) -> None:
        """The keys of the answers that have any, where they are learnt: beside the buttons."""
        for name, label in self._keys.items():
            label.setText(self._actions.keys_of(name).partition(" or ")[0])
        self._place()

    def _place(self) -> None:
        # Where the viewer is narrow the legend gives way, and then the keys: the question and its answers do not.
        keys = list(self._keys.values())
        for away in ([], [self.legend], [self.legend, *keys]):
            for label in (self.legend, *keys):
                label.setVisible(label not in away)
            self.adjustSize()
            if self.width() <= self._viewer.width():
                break
        x = max((self._viewer.width() - self.width()) // 2, 0)
        self.move(x, self._viewer.height() - self.height() - 2 * style.MARGIN)


def _button(actions: Actions, action_id: str) -> QToolButton:
    button = QToolButton()
    button.setDefaultAction(actions[action_id])
    button.setObjectName("raised")
    button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
    button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    return button
