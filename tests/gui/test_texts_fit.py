"""No text of the window is cut off, in any language: what a label, button or list says has the room that it takes."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QLocale
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QComboBox,
    QLabel,
    QLineEdit,
    QMenuBar,
    QScrollArea,
    QSpinBox,
    QStyle,
    QStyleOptionComboBox,
    QToolButton,
    QWidget,
)
from pytestqt.qtbot import QtBot

from app.panels.bars.status import Sentence
from app.panels.bars.view_bar import PlateLabel
from app.shell.main_window import MainWindow
from app.timeline.scale import LABEL_WIDTH
from app.translation import LANGUAGES, SOURCE, speak, tr
from roam_core.interchange import EXPORTERS
from roam_core.roto import edit
from tests.gui.windows import dialogs_of, opened_window, write_clip

GIVES_WAY = (Sentence, PlateLabel)
"""Labels that say the whole of their text in a tip, and end in three dots where they lack room."""
SIZES = [(1500, 940), (1280, 720), (1160, 620)]
"""Of the window: as it opens; what is left of a 1920 x 1080 screen at 150 %, and of a 4K screen at more than twice the
size. In narrower ones the menu bar and the view bar, which stand in one row, give way."""


@pytest.fixture(params=list(LANGUAGES))
def language(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Iterator[str]:
    """The window speaks each language in turn, and English again."""
    monkeypatch.delenv("ROAM_LANGUAGE", raising=False)
    before = QLocale()
    speak(request.param)
    yield request.param
    speak(SOURCE)
    QLocale.setDefault(before)


@pytest.fixture
def window(language: str, qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    """A window with a shape in a layer, both panels of all kinds open."""
    with opened_window(qtbot, write_clip(tmp_path / "plate"), tmp_path / "state") as window:
        points = [[(10.0, 10.0)] * 3, [(50.0, 10.0)] * 3, [(30.0, 50.0)] * 3]
        project, shape = edit.new_shape(window.document.project, points, 1001, name="arm")
        window.document.apply("Draw shape", project)
        window.view_state.select(frozenset({shape.id}))
        window.tracker.dials.arrow.click()
        yield window


def cut_off(root: QWidget) -> list[str]:
    """What of a window is said with less room than it takes; only what is seen now."""
    QApplication.processEvents()
    found = []
    for widget in [root, *root.findChildren(QWidget)]:
        if widget.isVisible() and (lack := lacking(widget)) > 0:
            text = getattr(widget, "text", lambda: "")() or getattr(widget, "currentText", lambda: "")()
            found.append(f"{type(widget).__name__} {text!r} in {type(widget.parentWidget()).__name__}: {lack} px")
    return found


def lacking(widget: QWidget) -> int:
    """By how many pixels a text is wider, or higher, than its place."""
    if isinstance(widget, QLabel) and not isinstance(widget, GIVES_WAY) and widget.text():
        if widget.wordWrap():
            return widget.heightForWidth(widget.width()) - widget.height()
        return widget.sizeHint().width() - widget.width()
    if isinstance(widget, QToolButton) and widget.toolButtonStyle().name == "ToolButtonIconOnly":
        return 0
    if isinstance(widget, QAbstractButton) and widget.text() and not isinstance(widget.parentWidget(), QLineEdit):
        return widget.sizeHint().width() - widget.width()
    if isinstance(widget, QComboBox):
        return wanted(widget) - room(widget)
    if isinstance(widget, QSpinBox) and widget.value() == widget.minimum() and widget.specialValueText():
        return widget.fontMetrics().horizontalAdvance(widget.specialValueText()) - widget.lineEdit().width()
    if isinstance(widget, QScrollArea):
        return widget.widget().minimumSizeHint().width() - widget.viewport().width()
    return 0


def wanted(box: QComboBox) -> int:
    """The width of the longest word that a list may show."""
    words = [box.itemText(index) for index in range(box.count())]
    return max((box.fontMetrics().horizontalAdvance(word) for word in words), default=0)


def room(box: QComboBox) -> int:
    """The width in which a closed list shows its word."""
    option = QStyleOptionComboBox()
    box.initStyleOption(option)
    sub = QStyle.SubControl.SC_ComboBoxEditField
    return box.style().subControlRect(QStyle.ComplexControl.CC_ComboBox, option, sub, box).width()


@pytest.mark.parametrize("size", SIZES, ids=str)
def test_the_window_cuts_nothing_off(window: MainWindow, size: tuple[int, int]) -> None:
    window.resize(*size)
    for name in ("edit.history", "help.log", "window.second_viewer"):
        window.actions_by_id[name].setChecked(True)
    assert cut_off(window) == []


def test_no_dialog_cuts_anything_off(window: MainWindow) -> None:
    cut = []
    for dialog in dialogs_of(window):
        cut += [f"{type(dialog).__name__}: {each}" for each in cut_off(dialog)]
    assert cut == []


def test_every_format_of_the_export_has_room(window: MainWindow) -> None:
    window.actions_by_id["file.export"].trigger()
    dialog = next(each for each in QApplication.topLevelWidgets() if type(each).__name__ == "ExportDialog")
    cut = []
    for name in EXPORTERS:
        dialog.choose(name)
        cut += [f"{name}: {each}" for each in cut_off(dialog)]
    dialog.close()
    assert cut == []


def test_the_start_page_cuts_nothing_off(language: str, qtbot: QtBot, tmp_path: Path) -> None:
    with opened_window(qtbot, None, tmp_path / "state") as window:
        window.reopening.page.begin()
        assert window.reopening.page.isVisible()
        assert cut_off(window) == []


def test_menus_stand_beside_each_other_in_a_small_window(window: MainWindow) -> None:
    window.resize(*SIZES[-1])
    QApplication.processEvents()
    bar = window.menuWidget().findChild(QMenuBar)
    assert all(bar.actionGeometry(action).right() <= bar.width() for action in bar.actions())


@pytest.mark.parametrize("word", ["marks", "confidence"])
def test_what_is_painted_beside_the_timeline_has_room(word: str, window: MainWindow) -> None:
    font = window.timeline.marks.font()
    font.setPixelSize(11)
    from PySide6.QtGui import QFontMetrics

    assert QFontMetrics(font).horizontalAdvance(tr(word)) < LABEL_WIDTH - 12
