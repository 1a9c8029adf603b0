"""The look of the window: the palette, the style sheet, the icons."""

from __future__ import annotations

import re
from functools import lru_cache

from PySide6.QtCore import QByteArray, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QIcon, QPainter, QPalette, QPixmap
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import QApplication

from roam_core.installation import resource

WINDOW = "#262626"
PANEL = "#2e2e2e"
FIELD = "#1f1f1f"
LINE = "#3a3a3a"
EDGE = "#1b1b1b"
"""Between rooms of the window: darker than both sides, so that no bright line frames the picture."""
HOVER = "#383838"
SELECTED = "#444444"
BUTTON = "#343434"
TEXT = "#d8d8d8"
WEAK = "#a8a8a8"
DISABLED = "#6a6a6a"
ACCENT = "#e0a030"
DOUBT = "#ff8c1a"
"""Of all that the engine doubts, and of what boils: on the canvas, in rows, lanes and plots."""

ROW_HEIGHT = 22
MARGIN = 8
ICON_SIZE = QSize(16, 16)

_COLOURS = {
    "window": WINDOW,
    "panel": PANEL,
    "field": FIELD,
    "line": LINE,
    "edge": EDGE,
    "hover": HOVER,
    "selected": SELECTED,
    "button": BUTTON,
    "text": TEXT,
    "weak": WEAK,
    "disabled": DISABLED,
    "accent": ACCENT,
}


def apply(application: QApplication) -> None:
    """Give the application ROAM's look, the same on every desktop."""
    application.setStyle("Fusion")
    application.setPalette(_palette())
    application.setStyleSheet(style_sheet())
    application.setWindowIcon(icon("roam"))


def small(font: QFont) -> QFont:
    """The font in the size of the timeline's names and numbers."""
    result = QFont(font)
    result.setPixelSize(11)
    return result


def style_sheet() -> str:
    """The style sheet with its colours and the folder of icons filled in."""
    text = resource("style", "dark.qss").read_text(encoding="utf-8")
    values = {**_COLOURS, "icons": str(resource("icons")).replace("\\", "/")}
    return re.sub(r"@(\w+)", lambda match: values[match[1]], text)


@lru_cache(maxsize=256)
def icon(name: str, colour: str = TEXT, lit: str = ACCENT) -> QIcon:
    """The line drawing `resources/icons/<name>.svg`: in `colour`, `lit` where it is switched on, dim where disabled."""
    drawing = resource("icons", f"{name}.svg").read_text(encoding="utf-8")
    result = QIcon()
    for size in (16, 32, 48):
        for mode, state, shade in (
            (QIcon.Mode.Normal, QIcon.State.Off, colour),
            (QIcon.Mode.Selected, QIcon.State.Off, colour),
            (QIcon.Mode.Disabled, QIcon.State.Off, DISABLED),
            (QIcon.Mode.Normal, QIcon.State.On, lit),
            (QIcon.Mode.Selected, QIcon.State.On, lit),
        ):
            result.addPixmap(_drawn(drawing.replace(TEXT, shade), size), mode, state)
    return result


@lru_cache(maxsize=64)
def swatch(colour: tuple[float, float, float], size: int = 10) -> QIcon:
    """A filled square in a shape's colour, for lists."""
    pixmap = QPixmap(QSize(size, size) * 2)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setPen(QColor(EDGE))
    painter.setBrush(QColor.fromRgbF(*colour))
    painter.drawRect(1, 1, 2 * size - 3, 2 * size - 3)
    painter.end()
    result = QIcon(pixmap)
    result.addPixmap(pixmap, QIcon.Mode.Selected)
    return result


def _drawn(drawing: str, size: int) -> QPixmap:
    pixmap = QPixmap(size, size)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    QSvgRenderer(QByteArray(drawing.encode())).render(painter, QRectF(0, 0, size, size))
    painter.end()
    return pixmap


def _palette() -> QPalette:
    palette, role = QPalette(), QPalette.ColorRole
    for name, colour in (
        (role.Window, WINDOW),
        (role.WindowText, TEXT),
        (role.Base, FIELD),
        (role.AlternateBase, PANEL),
        (role.Text, TEXT),
        (role.PlaceholderText, WEAK),
        (role.Button, BUTTON),
        (role.ButtonText, TEXT),
        (role.ToolTipBase, FIELD),
        (role.ToolTipText, TEXT),
        (role.Highlight, SELECTED),
        (role.HighlightedText, TEXT),
        (role.Link, ACCENT),
    ):
        palette.setColor(name, QColor(colour))
    for name in (role.WindowText, role.Text, role.ButtonText):
        palette.setColor(QPalette.ColorGroup.Disabled, name, QColor(DISABLED))
    return palette
