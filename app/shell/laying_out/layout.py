"""How the parts of the main window are laid out beside and above each other."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QBoxLayout, QFrame, QHBoxLayout, QScrollArea, QSplitter, QVBoxLayout, QWidget

LEAST_COLUMN_WIDTH = 240


def row(*parts: QWidget, growing: QWidget | None = None) -> QWidget:
    """The parts beside each other without a gap; `growing` takes what is left."""
    return _filled(QHBoxLayout(), parts, growing)


def column(*parts: QWidget, growing: QWidget | None = None, is_loose: bool = False) -> QWidget:
    """The parts below each other without a gap; `growing` takes what is left; `is_loose`: while it is away, the end."""
    box = QVBoxLayout()
    whole = _filled(box, parts, growing)
    if is_loose:
        box.addStretch()
    return whole


def split(orientation: Qt.Orientation, growing: QWidget, other: QWidget) -> QSplitter:
    """Two parts with a border to drag; `growing` takes what a larger window gives."""
    splitter = QSplitter(orientation)
    for part, stretch in ((growing, 1), (other, 0)):
        splitter.addWidget(part)
        splitter.setStretchFactor(splitter.indexOf(part), stretch)
    splitter.setChildrenCollapsible(False)
    splitter.setHandleWidth(3)
    return splitter


class _WideEnough(QScrollArea):
    """Never narrower than what lies in it: words of other languages are longer."""

    def minimumSizeHint(self) -> QSize:
        whole = self.widget()
        wanted = 0 if whole is None else whole.minimumSizeHint().width()
        if self.verticalScrollBarPolicy() != Qt.ScrollBarPolicy.ScrollBarAlwaysOff:
            wanted += self.verticalScrollBar().sizeHint().width()
        return QSize(max(LEAST_COLUMN_WIDTH, wanted), super().minimumSizeHint().height())


def scrolled(whole: QWidget) -> QScrollArea:
    """A column for small screens: nothing is squeezed, what does not fit is scrolled to."""
    scroll = _WideEnough()
    scroll.setWidgetResizable(True)
    scroll.setFrameShape(QFrame.Shape.NoFrame)
    scroll.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # what lies in it takes the keyboard
    scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    scroll.setWidget(whole)
    return scroll


def _filled(box: QBoxLayout, parts: tuple[QWidget, ...], growing: QWidget | None) -> QWidget:
    whole = QWidget()
    whole.setLayout(box)
    box.setContentsMargins(0, 0, 0, 0)
    box.setSpacing(0)
    for part in parts:
        box.addWidget(part)
    if growing is not None:
        box.setStretchFactor(growing, 1)
    return whole
