"""The column of tools at the left edge."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QActionGroup
from PySide6.QtWidgets import QVBoxLayout, QWidget

from ...actions.actions import Actions
from ...model.view_state import ViewState
from ...widgets.controls import tool_button


class ToolColumn(QWidget):
    """One button a tool; the active one is lit. `names` are the tools in order, top first."""

    def __init__(
        self, view_state: ViewState, actions: Actions, names: tuple[str, ...], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._view, self._actions, self._names = view_state, actions, names
        self.setObjectName("toolColumn")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setFixedWidth(36)
        column = QVBoxLayout(self)
        column.setContentsMargins(4, 6, 4, 6)
        column.setSpacing(2)
        self._group = QActionGroup(self)
        for name in names:
            action = actions[f"tool.{name}"]
            self._group.addAction(action)
            action.triggered.connect(lambda _checked=False, tool=name: view_state.set_tool(tool))
            column.addWidget(tool_button(actions, f"tool.{name}", size=28))
        column.addStretch(1)
        view_state.tool_changed.connect(self._pull)
        self._pull()

    def _pull(self) -> None:
        if self._view.tool in self._names:
            self._actions[f"tool.{self._view.tool}"].setChecked(True)
