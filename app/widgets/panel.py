"""Panel: a titled part of the right column that folds away under its title."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QHBoxLayout, QLabel, QToolButton, QVBoxLayout, QWidget

from .. import style
from ..translation import tr


class Panel(QWidget):
    """A header with a fold arrow and a title, over `body`. `tools` are small buttons at the header's right end.

    `name` is what settings know it by, in whichever language its title is.
    """

    def __init__(
        self, name: str, title: str, body: QWidget, tools: tuple[QWidget, ...] = (), parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.name, self.title, self._body = name, title, body
        body.setObjectName("panelBody")
        body.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self._header(title, tools))
        column.addWidget(body)

    def _header(self, title: str, tools: tuple[QWidget, ...]) -> QWidget:
        header = QWidget()
        header.setObjectName("panelHeader")
        header.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        header.setFixedHeight(26)
        row = QHBoxLayout(header)
        row.setContentsMargins(4, 0, 4, 0)
        row.setSpacing(2)
        label = QLabel(title.upper())
        label.setObjectName("panelTitle")
        self._arrow = QToolButton()
        self._arrow.setIcon(style.icon("chevron-down"))
        self._arrow.setFixedSize(18, 18)
        self._arrow.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self._arrow.setToolTip(tr("Fold or unfold"))
        self._arrow.setAccessibleName(f"{title}: {tr('Fold or unfold')}")
        self._arrow.clicked.connect(self.toggle)
        row.addWidget(self._arrow)
        row.addWidget(label)
        row.addStretch(1)
        for tool in tools:
            row.addWidget(tool)
        self._row = row
        return header

    def float_with(self, action: QAction) -> None:
        """Put the button of what floats the panel at the header's right end."""
        button = QToolButton()
        button.setDefaultAction(action)
        button.setObjectName("flat")
        button.setIconSize(style.ICON_SIZE)
        button.setFixedSize(22, 22)
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonIconOnly)
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self._row.addWidget(button)

    @property
    def is_folded(self) -> bool:
        return self._body.isHidden()

    def toggle(self) -> None:
        """Fold the body away, or show it again."""
        self.fold(not self.is_folded)

    def fold(self, folded: bool) -> None:
        """Fold the body away, or show it."""
        self._body.setVisible(not folded)
        self._arrow.setIcon(style.icon("chevron-right" if folded else "chevron-down"))
