"""The column of tools at the left edge."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QActionGroup, QResizeEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from ... import style
from ...actions.actions import Actions
from ...model.view_state import ViewState
from ...translation import tr
from ...widgets.controls import tool_button
from ...widgets.more import MoreButton

WIDTH, SIDE, END, GAP, BUTTON = 36, 4, 6, 2, 28
"""Of the column; from its sides and ends to the buttons; between these; their size: in widget units."""
LEAST_BUTTONS = 2


class ToolColumn(QWidget):
    """One button a tool; the active one is lit. `names` are the tools in order, top first.

    Tools that a low window has no room for are in the menu of the last button, which is lit for the active one.
    """

    def __init__(
        self, view_state: ViewState, actions: Actions, names: tuple[str, ...], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._view, self._actions, self._names = view_state, actions, names
        self.setObjectName("toolColumn")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setFixedWidth(WIDTH)
        column = QVBoxLayout(self)
        column.setContentsMargins(SIDE, END, SIDE, END)
        column.setSpacing(GAP)
        self._group = QActionGroup(self)
        self.buttons = {name: tool_button(actions, f"tool.{name}", size=BUTTON) for name in names}
        for name, button in self.buttons.items():
            action = actions[f"tool.{name}"]
            self._group.addAction(action)
            action.triggered.connect(lambda _checked=False, tool=name: view_state.set_tool(tool))
            column.addWidget(button)
        self.more = MoreButton(tr("More tools"), BUTTON)
        self.more.setCheckable(True)
        column.addWidget(self.more)
        column.addStretch(1)
        view_state.tool_changed.connect(self._pull)
        self._pull()

    def sizeHint(self) -> QSize:
        return QSize(WIDTH, _height_of(len(self._names)))

    def minimumSizeHint(self) -> QSize:
        return QSize(WIDTH, _height_of(LEAST_BUTTONS))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        room = (self.height() - _height_of(0)) // (BUTTON + GAP)
        shown = len(self._names) if room >= len(self._names) else max(room, LEAST_BUTTONS) - 1
        for index, button in enumerate(self.buttons.values()):
            button.setVisible(index < shown)
        self.more.menu().clear()
        self.more.menu().addActions([self._actions[f"tool.{name}"] for name in self._names[shown:]])
        self.more.setVisible(shown < len(self._names))
        self._pull()

    def _pull(self) -> None:
        tool = self._view.tool
        if tool in self._names:
            self._actions[f"tool.{tool}"].setChecked(True)
        is_more = tool in self._names and self.buttons[tool].isHidden()
        self.more.setChecked(is_more)
        self.more.setIcon(self._actions[f"tool.{tool}"].icon() if is_more else style.icon("more"))


def _height_of(count: int) -> int:
    """The height in which so many buttons fit."""
    return 2 * END + count * (BUTTON + GAP) - GAP
